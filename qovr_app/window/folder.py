"""Where files go first, and which came last: remembered from one start to the next where there are preferences."""

from __future__ import annotations

from pathlib import Path

from qovr_app.window.preferences import Preferences


class Folder:
    """The folder in which a file was last opened or written, and the files opened or saved last.

    Parameters
    ----------
    preferences : None where nothing is to be remembered
    """

    def __init__(self, preferences: Preferences | None) -> None:
        self._preferences = preferences
        self._path = preferences.folder if preferences else Path.cwd()

    @property
    def path(self) -> Path:
        """The folder."""
        return self._path

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last that still exist."""
        return [path for path in self._preferences.recent if path.is_file()] if self._preferences else []

    def stem(self, title: str) -> Path:
        """Return where a file that belongs to a document goes first, without its suffix."""
        return self._path / Path(title).stem

    def note_written(self, path: Path) -> None:
        """Take note of a file that was written but is no document."""
        self._path = path.absolute().parent
        if self._preferences:
            self._preferences.folder = self._path

    def note_document(self, path: Path) -> None:
        """Take note of a document's file."""
        self.note_written(path)
        if self._preferences:
            self._preferences.add_recent(path)

    def clear_recent(self) -> None:
        """Forget all recent files."""
        if self._preferences:
            self._preferences.clear_recent()
