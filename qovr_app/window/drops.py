"""Files that are dropped on a window: copied, never moved, and opened once the drop has ended, each of them."""

from __future__ import annotations

import sys
from collections.abc import Sequence
from pathlib import Path

from PySide6.QtCore import QProcess, Qt, QUrl
from PySide6.QtGui import QDropEvent

from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.requests import SourceAsked
from qovr_app.store import Dispatch
from qovr_core.files import source_suffixes
from qovr_core.files.sources import local_path

_MOST_WINDOWS = 12
"""So many windows opened by one drop are meant; more are a slip of the hand."""


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
    """Open the first of some files in the window they were dropped on, and each other one in a window of its own.

    A window of its own is a process of its own, so that no end of one can touch the work in another.
    """
    dispatch(SourceAsked(sources[0]))
    others = sources[1:_MOST_WINDOWS]
    failed = [path for path in others if not _started(path)]
    if failed:
        refusal = f"{Path(failed[0]).name}: no further window can be started; open the file from the menu."
        dispatch(MessageShown(refusal, is_refusal=True))
    elif len(sources) > _MOST_WINDOWS:
        text = f"Opened the first {_MOST_WINDOWS} of {len(sources)} files; drop the others again."
        dispatch(MessageShown(text))


def _started(path: str) -> bool:
    is_started, _process = QProcess.startDetached(sys.executable, ["-m", "qovr_app", path], str(Path(path).parent))
    return is_started
