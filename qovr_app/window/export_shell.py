"""Export Data and Save Figure: asks for format, size and file, and has the configured surface written."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from qovr_app.state import requests
from qovr_app.state.looking_intents import MessageShown
from qovr_app.store import Store
from qovr_app.window.folder import Folder
from qovr_app.window.preferences import Preferences
from qovr_app.window.shell import Answers
from qovr_app.work.worker import Worker
from qovr_core.files import ExportOptions

if TYPE_CHECKING:
    from qovr_app.dialogs.figure_dialog import FigureWriter


class ExportShell:
    """Asks what is to be written and where, and says how it went.

    Parameters
    ----------
    worker : in which an export is done
    preferences : where the conventions of the last export are remembered; None where nothing is
    view_writer : gives what writes the 3D view as it is then
    commit_typed : takes what is just being typed, as leaving the field would
    """

    def __init__(
        self,
        store: Store,
        window: QWidget,
        folder: Folder,
        worker: Worker,
        preferences: Preferences | None,
        *,
        view_writer: Callable[[], FigureWriter],
        commit_typed: Callable[[], None],
    ) -> None:
        self._store, self._window, self._folder, self._worker = store, window, folder, worker
        self._preferences = preferences
        self._conventions = ExportOptions()
        self._view_writer, self._commit_typed = view_writer, commit_typed
        self.answers: Answers = {
            requests.ExportAsked: self._export,
            requests.FigureAsked: self._save_figure,
            requests.DrawingAsked: self._save_drawing,
        }

    def _export(self, _request: requests.ExportAsked) -> None:
        """Ask for a format and a file, and write the configured surface."""
        self._commit_typed()
        self._store.flush()
        if self._store.state.is_stale:
            self._say("Nothing to export: configure the surface first.", is_refusal=True)
            return
        from qovr_app.dialogs.export_dialog import ExportDialog

        document, window = self._store.state.document, self._store.state.window
        first = self._preferences.conventions if self._preferences else self._conventions
        dialog = ExportDialog(document, self._stem, self._worker, first, self._window, window=window)
        dialog.written.connect(lambda path: self._on_exported(path, dialog.conventions))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _on_exported(self, path: Path, conventions: ExportOptions) -> None:
        self._conventions = conventions
        if self._preferences:
            self._preferences.conventions = conventions
        self._on_written(path)

    def _save_figure(self, _request: requests.FigureAsked) -> None:
        """Ask how large and where, and write what is seen in the 3D view."""
        self._ask_for_figure("", "only the surface is pixels", self._view_writer())

    def _save_drawing(self, request: requests.DrawingAsked) -> None:
        """Ask how large and where, and let a drawing be written."""
        self._ask_for_figure(f"_{request.name}", "everything is lines", request.write)

    def _ask_for_figure(self, addition: str, vectors: str, write: FigureWriter) -> None:
        from qovr_app.dialogs.figure_dialog import FigureDialog

        first = self._stem.with_name(f"{self._stem.name}{addition}.png")
        dialog = FigureDialog(first, vectors, write, self._worker, self._window)
        dialog.written.connect(self._on_written)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _on_written(self, path: Path) -> None:
        self._folder.note_written(path)
        self._say(f"Wrote {path}")

    @property
    def _stem(self) -> Path:
        """Where a file that belongs to the document goes first, without its suffix."""
        return self._folder.stem(self._store.state.file.title)

    def _say(self, text: str, *, is_refusal: bool = False) -> None:
        self._store.dispatch(MessageShown(text, is_refusal))
