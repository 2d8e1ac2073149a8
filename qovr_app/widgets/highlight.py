"""A frame drawn around a part of the window, through which one works as if it were not there."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QRect, Qt, QTimer
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QWidget

from qovr_app.style.palette import theme_in_force

_WIDTH, _ROUND = 3, 6
_FOLLOW_MILLISECONDS = 100
"""As soon as the eye notices that a part has moved under its frame."""


class Highlight(QWidget):
    """Follows a part of its window."""

    def __init__(self, window: QWidget) -> None:
        super().__init__(window)
        self._window = window
        self.setObjectName("highlight")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self._target: QWidget | None = None
        self._timer = QTimer(self, interval=_FOLLOW_MILLISECONDS)
        self._timer.timeout.connect(self._follow)
        self.setVisible(False)

    def show_around(self, target: QWidget | None) -> None:
        """Frame a part of the window; none at all hides the frame."""
        self._target = target
        if target is None:
            self._timer.stop()
            self.setVisible(False)
            return
        self._timer.start()
        self._follow()

    def _follow(self) -> None:
        target = self._target
        if target is None or not target.isVisible():
            self.setVisible(False)
            return
        place = target.visibleRegion().boundingRect()
        around = QRect(target.mapTo(self._window, QPoint(0, 0)) + place.topLeft(), place.size())
        self.setGeometry(around.adjusted(-_WIDTH, -_WIDTH, _WIDTH, _WIDTH) & self._window.rect())
        self.setVisible(True)
        self.raise_()

    def paintEvent(self, _event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QPen(QColor(*theme_in_force().accent), _WIDTH))
        inside = self.rect().adjusted(_WIDTH // 2 + 1, _WIDTH // 2 + 1, -_WIDTH // 2 - 1, -_WIDTH // 2 - 1)
        painter.drawRoundedRect(inside, _ROUND, _ROUND)
        painter.end()
