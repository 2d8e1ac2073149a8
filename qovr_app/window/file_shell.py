"""Everything between the window and files: open, save, export, draw. Answers come back to the store as intents."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from qovr_app.dialogs.export_dialog import ExportDialog
from qovr_app.dialogs.figure_dialog import FigureDialog
from qovr_app.state import requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.intents import MessageShown, Opened, Saved, Stamp
from qovr_app.store import Store
from qovr_app.window.application import NAME
from qovr_app.window.preferences import Preferences
from qovr_app.work.worker import Worker
from qovr_core import QovrError
from qovr_core.files import read_source, readable_suffixes, write_document
from qovr_core.files.sources import PRESET_PREFIX

DOCUMENT_SUFFIX = ".qovr"

FigureWriter = Callable[[Path, FigureOptions], None]
"""Writes a figure of these options into a file, or raises QovrError."""


def opened_source(source: str) -> Opened:
    """Return what came of opening a ``.qovr`` file, a workbook in the published layout, or ``paper:NAME``.

    Raises
    ------
    QovrError : the source cannot be read
    """
    document = read_source(source)
    if source.startswith(PRESET_PREFIX):
        name = source.removeprefix(PRESET_PREFIX)
        return Opened(document, name, preset=name, message=f"Opened {name}")
    path = Path(source).resolve()
    own = path if path.suffix.lower() == DOCUMENT_SUFFIX else None
    return Opened(document, path.name, own, file_stamp(path), message=f"Opened {path.name}")


def file_stamp(path: Path) -> Stamp | None:
    """Return when a file was last written and its size; None where it cannot be told."""
    try:
        found = path.stat()
    except OSError:
        return None
    return found.st_mtime_ns, found.st_size


class FileShell:
    """Asks for files and reads and writes them; says how it went.

    Parameters
    ----------
    save_view : writes what the 3D view shows
    commit_typed : takes what is just being typed, as leaving the field would
    worker : in which what takes time is done
    preferences : None where nothing is to be remembered
    """

    def __init__(
        self,
        store: Store,
        window: QWidget,
        preferences: Preferences | None,
        worker: Worker,
        *,
        save_view: FigureWriter,
        commit_typed: Callable[[], None],
    ) -> None:
        self._store, self._window, self._preferences = store, window, preferences
        self._worker, self._save_view, self._commit_typed = worker, save_view, commit_typed
        self._folder = preferences.folder if preferences else Path.cwd()

    @property
    def _state(self) -> EditorState:
        return self._store.state

    # Opening

    def ask_for_source(self, _request: requests.OpenAsked) -> None:
        """Ask for a file and open it."""
        kinds = " ".join(f"*{suffix}" for suffix in readable_suffixes())
        filters = f"Documents and workbooks ({kinds})"
        name, _ = QFileDialog.getOpenFileName(self._window, "Open", str(self._folder), filters)
        if name:
            self.open_source(requests.SourceAsked(name))

    def open_source(self, request: requests.SourceAsked) -> None:
        """Open a file or a preset, after asking about unsaved changes; what cannot be read changes nothing."""
        if not self.may_leave():
            return
        try:
            opened = opened_source(request.source)
        except QovrError as error:
            self._say(f"{error}.", is_refusal=True)
            return
        if not opened.preset:
            self._remember(Path(request.source))
        self._store.dispatch(opened)

    def open_document(self, request: requests.DocumentAsked) -> None:
        """Open a document that the program made, after asking about unsaved changes."""
        self.go_on_with(Opened(request.document, request.title, message=f"Opened {request.title}"))

    def go_on_with(self, opened: Opened) -> bool:
        """Take a document over, after asking about unsaved changes; return whether it was taken."""
        may_leave = self.may_leave()
        if may_leave:
            self._store.dispatch(opened)
        return may_leave

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last that still exist."""
        return [path for path in self._preferences.recent if path.is_file()] if self._preferences else []

    def clear_recent(self, _request: requests.RecentCleared) -> None:
        """Forget all recent files."""
        if self._preferences:
            self._preferences.clear_recent()

    # Saving

    def save(self, request: requests.SaveAsked) -> bool:
        """Save, with what is just being typed, to the document's file or to one that is asked for."""
        self._commit_typed()
        path = self._state.file.path
        if path is None or request.elsewhere:
            path = self._asked_path()
        return path is not None and self._save_to(path)

    def may_leave(self) -> bool:
        """Ask about unsaved changes; return whether the document may go."""
        if not self._state.is_changed:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self._window,
            NAME,
            f"Save the changes to {self._state.file.title}?",
            button.Save | button.Discard | button.Cancel,
            button.Save,
        )
        if answer == button.Save:
            return self.save(requests.SaveAsked())
        return answer == button.Discard

    def _asked_path(self) -> Path | None:
        first = self._stem.with_suffix(DOCUMENT_SUFFIX)
        kind = f"QOVR documents (*{DOCUMENT_SUFFIX})"
        name, _ = QFileDialog.getSaveFileName(self._window, "Save As", str(first), kind)
        if not name:
            return None
        path = Path(name)
        return path if path.suffix.lower() == DOCUMENT_SUFFIX else path.with_name(path.name + DOCUMENT_SUFFIX)

    def _save_to(self, path: Path) -> bool:
        state = self._state
        try:
            write_document(state.document, path)
        except QovrError as error:
            self._say(f"{error}.", is_refusal=True)
            return False
        self._remember(path)
        self._store.dispatch(Saved(path.resolve(), path.name, state.history.serial, file_stamp(path)))
        return True

    # Export Data and Save Figure

    def export(self, _request: requests.ExportAsked) -> None:
        """Ask for a format and a file, and write the configured surface."""
        self._commit_typed()
        self._store.flush()
        if self._state.is_stale:
            self._say("Nothing to export: configure the surface first.", is_refusal=True)
            return
        dialog = ExportDialog(self._state.document, self._stem, self._worker, self._window)
        dialog.exported.connect(self._on_written)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def save_figure(self, _request: requests.FigureAsked) -> None:
        """Ask how large and where, and write what is seen in the 3D view."""
        self._ask_for_figure("", "only the surface is pixels", self._save_view)

    def save_drawing(self, request: requests.DrawingAsked) -> None:
        """Ask how large and where, and let a drawing be written."""
        self._ask_for_figure(f"_{request.name}", "everything is lines", request.write)

    def _ask_for_figure(self, addition: str, vectors: str, write: FigureWriter) -> None:
        first = self._stem.with_name(f"{self._stem.name}{addition}.png")
        dialog = FigureDialog(first, vectors, self._window)
        dialog.accepted.connect(lambda: self._write_figure(dialog, write))
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def _write_figure(self, dialog: FigureDialog, write: FigureWriter) -> None:
        try:
            write(dialog.path, dialog.options)
        except QovrError as error:
            self._say(f"{error}.", is_refusal=True)
            return
        self._on_written(dialog.path)

    def _on_written(self, path: Path) -> None:
        self._set_folder(path.parent)
        self._say(f"Wrote {path}")

    # Where things are

    @property
    def _stem(self) -> Path:
        """Where a file that belongs to the document goes first, without its suffix."""
        return self._folder / Path(self._state.file.title).stem

    def _remember(self, path: Path) -> None:
        self._set_folder(path.absolute().parent)
        if self._preferences:
            self._preferences.add_recent(path)

    def _set_folder(self, folder: Path) -> None:
        self._folder = folder
        if self._preferences:
            self._preferences.folder = folder

    def _say(self, text: str, *, is_refusal: bool = False) -> None:
        self._store.dispatch(MessageShown(text, is_refusal))
