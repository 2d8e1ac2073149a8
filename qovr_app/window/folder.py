"""Where files go first, and which came last: remembered from one start to the next where there are preferences."""

from __future__ import annotations

from concurrent.futures import Future, wait
from pathlib import Path
from threading import Thread

from qovr_app.window.preferences import Preferences, home_folder, present_folder

_PATIENCE_SECONDS = 0.1
"""A share that has not answered by then is not the place to begin a dialog in."""


class Folder:
    """The folder in which a file was last opened or written, and the files opened or saved last.

    Parameters
    ----------
    preferences : None where nothing is to be remembered
    """

    def __init__(self, preferences: Preferences | None) -> None:
        self._preferences = preferences
        self._path = preferences.folder if preferences else present_folder()

    @property
    def path(self) -> Path:
        """The folder for a dialog: another one where it is no more or does not answer."""
        return self._path if _answers(self._path) else home_folder()

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last; whether they still are there is found out when one is wanted."""
        return self._preferences.recent if self._preferences else []

    def stem(self, title: str) -> Path:
        """Return where a file that belongs to a document goes first, without its suffix."""
        return self.path / Path(title).stem

    def note_written(self, path: Path) -> None:
        """Take note of a file that was written but is no document."""
        self._path = _absolute(path).parent
        if self._preferences:
            self._preferences.folder = self._path

    def note_document(self, path: Path) -> None:
        """Take note of a document's file."""
        self.note_written(path)
        if self._preferences:
            self._preferences.add_recent(_absolute(path))

    def clear_recent(self) -> None:
        """Forget all recent files."""
        if self._preferences:
            self._preferences.clear_recent()


def _absolute(path: Path) -> Path:
    return path if path.is_absolute() else present_folder() / path


def _answers(folder: Path) -> bool:
    """Return whether a folder is there, and says so soon."""
    told: Future[bool] = Future()

    def ask() -> None:
        try:
            told.set_result(folder.is_dir())
        except OSError:
            told.set_result(False)

    Thread(target=ask, daemon=True).start()
    wait([told], _PATIENCE_SECONDS)
    return told.done() and told.result()
