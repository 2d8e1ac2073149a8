"""The two bars in one row, with less in them where the window is narrow."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from PySide6.QtGui import QAction, QResizeEvent
from PySide6.QtWidgets import QHBoxLayout, QToolBar, QWidget


class Bars(QWidget):
    """The bar of edits and the bar of the view.

    Where both have no room, the cameras go first, because the axes in the view's corner turn it too.

    Parameters
    ----------
    shorter : what actions say in a narrow window
    cameras : the actions at the end of the view's bar that a narrow one does without
    """

    def __init__(
        self,
        edit: QToolBar,
        view: QToolBar,
        shorter: Mapping[QAction, str],
        cameras: Sequence[QAction],
        parent: QWidget,
    ) -> None:
        super().__init__(parent)
        self._parts, self._view, self._cameras = (edit, view), view, cameras
        self._texts = {action: (action.iconText(), text) for action, text in shorter.items()}
        self._is_narrow = False
        self._needed = 0
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(0)
        row.addWidget(edit)
        row.addWidget(view, 1)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if not self._is_narrow:
            self._needed = sum(part.sizeHint().width() for part in self._parts)
        is_narrow = self.width() < self._needed
        if is_narrow is self._is_narrow:
            return
        self._is_narrow = is_narrow
        for action, texts in self._texts.items():
            action.setIconText(texts[is_narrow])
        for action in self._cameras:
            (self._view.removeAction if is_narrow else self._view.addAction)(action)
