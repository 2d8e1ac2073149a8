"""Opening and saving: asks for files, reads and writes them, and says how it went. What came of it is an intent."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget

from qovr_app.state import requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Opened, Saved, Stamp
from qovr_app.state.looking_intents import MessageShown
from qovr_app.store import Store
from qovr_app.window.application import NAME
from qovr_app.window.folder import Folder
from qovr_app.window.shell import Answers
from qovr_core import QovrError
from qovr_core.files import read_source, source_suffixes, write_document
from qovr_core.files.sources import PRESET_PREFIX

DOCUMENT_SUFFIX = ".qovr"


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


class DocumentShell:
    """Asks for documents and reads and writes them; says how it went.

    Parameters
    ----------
    commit_typed : takes what is just being typed, as leaving the field would
    """

    def __init__(self, store: Store, window: QWidget, folder: Folder, commit_typed: Callable[[], None]) -> None:
        self._store, self._window, self._folder, self._commit_typed = store, window, folder, commit_typed
        self.answers: Answers = {
            requests.OpenAsked: self._ask_for_source,
            requests.SourceAsked: self._open_source,
            requests.DocumentAsked: self._open_document,
            requests.SaveAsked: self._save,
            requests.RecentCleared: lambda _asked: folder.clear_recent(),
        }

    @property
    def _state(self) -> EditorState:
        return self._store.state

    # Opening

    def _ask_for_source(self, _request: requests.OpenAsked) -> None:
        """Ask for a file and open it."""
        kinds = " ".join(f"*{suffix}" for suffix in source_suffixes())
        filters = f"Documents and workbooks ({kinds})"
        name, _ = QFileDialog.getOpenFileName(self._window, "Open", str(self._folder.path), filters)
        if name:
            self._open_source(requests.SourceAsked(name))

    def _open_source(self, request: requests.SourceAsked) -> None:
        """Open a file or a preset, after asking about unsaved changes; what cannot be read changes nothing."""
        if not self.may_leave():
            return
        try:
            opened = opened_source(request.source)
        except QovrError as error:
            self._say(f"{error}.", is_refusal=True)
            return
        if not opened.preset:
            self._folder.note_document(Path(request.source))
        self._store.dispatch(opened)

    def _open_document(self, request: requests.DocumentAsked) -> None:
        """Open a document that the program made, after asking about unsaved changes."""
        self.go_on_with(Opened(request.document, request.title, message=f"Opened {request.title}"))

    def go_on_with(self, opened: Opened) -> bool:
        """Take a document over, after asking about unsaved changes; return whether it was taken."""
        may_leave = self.may_leave()
        if may_leave:
            self._store.dispatch(opened)
        return may_leave

    # Saving

    def _save(self, request: requests.SaveAsked) -> bool:
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
            return self._save(requests.SaveAsked())
        return answer == button.Discard

    def _asked_path(self) -> Path | None:
        first = self._folder.stem(self._state.file.title).with_suffix(DOCUMENT_SUFFIX)
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
        self._folder.note_document(path)
        self._store.dispatch(Saved(path.resolve(), path.name, state.history.serial, file_stamp(path)))
        return True

    def _say(self, text: str, *, is_refusal: bool = False) -> None:
        self._store.dispatch(MessageShown(text, is_refusal))
