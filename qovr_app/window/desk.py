"""The desk: everything between the window and files - open, save, recent, recovered, exported, drawn."""

from __future__ import annotations

from collections.abc import Callable
from datetime import datetime
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from qovr_app.dialogs.export_dialog import ExportDialog
from qovr_app.dialogs.figure_dialog import FigureDialog
from qovr_app.state.figure_options import FigureOptions
from qovr_app.widgets.notice import Notice
from qovr_app.window.application import NAME
from qovr_app.window.controller import Controller
from qovr_app.window.preferences import Preferences
from qovr_app.window.recovery import RecoveryStore, Unsaved
from qovr_app.window.session import DOCUMENT_SUFFIX, Session
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.files.sources import PRESET_PREFIX, readable_suffixes

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D

FigureWriter = Callable[[Path, FigureOptions], None]
"""Writes a figure of these options into a file, or raises QovrError."""


class Desk(QObject):
    """Asks for files and reads and writes them; says how it went.

    Parameters
    ----------
    view : gives the 3D view, for Save Figure
    preferences : None where nothing is to be remembered

    Signals
    -------
    told : a sentence for the message line, and whether it is a refusal
    opened : another document has come; its preset's name, or empty
    """

    told = Signal(str, bool)
    opened = Signal(str)

    def __init__(
        self,
        session: Session,
        controller: Controller,
        view: Callable[[], View3D],
        preferences: Preferences | None,
        parent: QWidget,
        *,
        worker: Worker,
    ) -> None:
        super().__init__(parent)
        self._session, self._controller, self._view = session, controller, view
        self._worker = worker
        self._preferences = preferences
        self._window = parent
        self._folder = preferences.folder if preferences else Path.cwd()
        self._unsaved: list[Unsaved] = []
        self.notice = Notice("recovery", parent)
        self.notice.add_answer("restore", "Restore", "Go on with the unsaved document", self._restore)
        self.notice.add_answer("discard", "Discard", "Delete the unsaved document", self._discard)

    # Opening

    def open_dialog(self) -> None:
        """Ask for a file and open it."""
        kinds = " ".join(f"*{suffix}" for suffix in readable_suffixes())
        filters = f"Documents and workbooks ({kinds})"
        name, _ = QFileDialog.getOpenFileName(self._window, "Open", str(self._folder), filters)
        if name:
            self.open_source(name)

    def open_source(self, source: str) -> None:
        """Open a file or a preset, after asking about unsaved changes; what cannot be read changes nothing."""
        if not self.may_leave():
            return
        try:
            self._session.open(source)
        except QovrError as error:
            self.told.emit(f"{error}.", True)
            return
        is_preset = source.startswith(PRESET_PREFIX)
        if not is_preset:
            self._remember(Path(source))
        self.told.emit(f"Opened {self._session.title}", False)
        self.opened.emit(self._session.title if is_preset else "")

    def open_document(self, document: Document, title: str) -> None:
        """Open a document that the program made, after asking about unsaved changes."""
        if self.may_leave():
            self._session.start(document, title)
            self.told.emit(f"Opened {title}", False)
            self.opened.emit("")

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last that still exist."""
        return [path for path in self._preferences.recent if path.is_file()] if self._preferences else []

    def clear_recent(self) -> None:
        """Forget all recent files."""
        if self._preferences:
            self._preferences.clear_recent()

    # Saving

    def save(self) -> bool:
        """Save to the document's file, asking for one where there is none; return whether it was saved."""
        if self._session.path is None:
            return self.save_as()
        return self._save_to(self._session.path)

    def save_as(self) -> bool:
        """Ask for a file and save to it; return whether it was saved."""
        first = self._stem.with_suffix(DOCUMENT_SUFFIX)
        kind = f"QOVR documents (*{DOCUMENT_SUFFIX})"
        name, _ = QFileDialog.getSaveFileName(self._window, "Save As", str(first), kind)
        if not name:
            return False
        path = Path(name)
        return self._save_to(
            path if path.suffix.lower() == DOCUMENT_SUFFIX else path.with_name(path.name + DOCUMENT_SUFFIX)
        )

    def may_leave(self) -> bool:
        """Ask about unsaved changes; return whether the document may go."""
        if not self._session.is_changed:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self._window,
            NAME,
            f"Save the changes to {self._session.title}?",
            button.Save | button.Discard | button.Cancel,
            button.Save,
        )
        if answer == button.Save:
            return self.save()
        return answer == button.Discard

    def _save_to(self, path: Path) -> bool:
        try:
            self._session.save(path)
        except QovrError as error:
            self.told.emit(f"{error}.", True)
            return False
        self._remember(path)
        self.told.emit(f"Saved {path.name}", False)
        return True

    # Export Data and Save Figure

    def export(self) -> None:
        """Ask for a format and a file, and write the configured surface."""
        state = self._controller.state
        if state.is_stale:
            self.told.emit("Nothing to export: configure the surface first.", True)
            return
        dialog = ExportDialog(state.document, self._stem, self._worker, self._window)
        dialog.exported.connect(self._on_written)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()

    def save_figure(self) -> None:
        """Ask how large and where, and write what is seen in the 3D view."""
        self._ask_for_figure("", "only the surface is pixels", lambda *asked: self._view().save_figure(*asked))

    def save_drawing(self, name: str, write: FigureWriter) -> None:
        """Ask how large and where, and let a drawing be written; ``name`` is added to the document's."""
        self._ask_for_figure(f"_{name}", "everything is lines", write)

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
            self.told.emit(f"{error}.", True)
            return
        self._on_written(dialog.path)

    def _on_written(self, path: Path) -> None:
        self._set_folder(path.parent)
        self.told.emit(f"Wrote {path}", False)

    # What an earlier run left

    def offer(self, store: RecoveryStore) -> None:
        """Offer what earlier runs left unsaved."""
        self._unsaved = store.found()
        self._ask()

    def release(self) -> None:
        """Leave what was not answered to the next start."""
        for entry in self._unsaved:
            entry.release()
        self._unsaved = []

    def _ask(self) -> None:
        if not self._unsaved:
            self.notice.setVisible(False)
            return
        entry = self._unsaved[0]
        when = datetime.fromtimestamp(entry.changed).strftime("%d %B, %H:%M")
        more = f"  ({len(self._unsaved) - 1} more)" if len(self._unsaved) > 1 else ""
        self.notice.ask(f"Unsaved changes to {entry.title} from {when} were kept when the program ended.{more}")

    def _restore(self) -> None:
        if not self.may_leave():
            return
        entry = self._unsaved.pop(0)
        self._session.restore(entry.document, entry.title, entry.path)
        entry.remove()
        self.told.emit(f"Restored {entry.title}; it is not saved yet.", False)
        self.opened.emit("")
        self._ask()

    def _discard(self) -> None:
        self._unsaved.pop(0).remove()
        self._ask()

    # Places

    @property
    def _stem(self) -> Path:
        """Where a file that belongs to the document goes first, without its suffix."""
        return self._folder / Path(self._session.title).stem

    def _remember(self, path: Path) -> None:
        self._set_folder(path.absolute().parent)
        if self._preferences:
            self._preferences.add_recent(path)

    def _set_folder(self, folder: Path) -> None:
        self._folder = folder
        if self._preferences:
            self._preferences.folder = folder
