"""Files that are dropped on a window: copied, never moved, and opened once the drop has ended, each of them."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDragMoveEvent, QDropEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.requests import SourceAsked
from qovr_app.store import Dispatch
from qovr_core.files import source_suffixes
from qovr_core.files.sources import local_path

_MOST_WINDOWS = 12
"""So many windows opened by one drop are meant; more are a slip of the hand."""


class Drops(QObject):
    """Opens what is dropped on a window."""

    def __init__(self, window: QWidget, dispatch: Dispatch) -> None:
        super().__init__(window)
        self._dispatch = dispatch
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if not isinstance(event, QDragEnterEvent | QDragMoveEvent | QDropEvent):
            return False
        if take(event) and event.type() == QEvent.Type.Drop:
            sources = dropped_sources(event)
            # Whatever is asked waits until the drop has ended: its source waits for that too.
            QTimer.singleShot(0, self, lambda: open_each(sources, self._dispatch))
        return event.isAccepted()


def take(event: QDropEvent) -> bool:
    """Accept a drag of files that can be opened, as a copy whatever key is held: its source keeps the files.

    Returns
    -------
    whether there is anything to open
    """
    if not dropped_sources(event):
        return False
    event.setDropAction(Qt.DropAction.CopyAction)
    event.accept()
    return True


def dropped_sources(event: QDropEvent) -> list[str]:
    """Return the paths of the dropped files that can be opened."""
    urls = (url for url in event.mimeData().urls() if url.isLocalFile())
    paths = (local_path(url.toString(QUrl.ComponentFormattingOption.FullyEncoded)) for url in urls)
    return [path for path in paths if path.lower().endswith(source_suffixes())]


def open_each(sources: Sequence[str], dispatch: Dispatch) -> None:
    """Open the first of some files in the window they were dropped on, and each other one in a window of its own."""
    for k, source in enumerate(sources[:_MOST_WINDOWS]):
        dispatch(SourceAsked(source, elsewhere=k > 0))
    if len(sources) > _MOST_WINDOWS:
        text = f"Opened the first {_MOST_WINDOWS} of {len(sources)} files; drop the others again."
        dispatch(MessageShown(text))
