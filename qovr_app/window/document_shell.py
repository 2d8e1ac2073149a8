"""Opening and saving: asks for files, has them read and written, and says how it went. What came of it is an intent."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QFileDialog, QWidget

from qovr_app.dialogs.question import Answer, ask
from qovr_app.dialogs.target import ask_for_target
from qovr_app.dialogs.waiting import GivenUpError, at_work, patiently
from qovr_app.state import requests
from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import FileFound, Opened, PendingSet, Reloaded, Saved
from qovr_app.state.looking_intents import MessageShown
from qovr_app.store import Store
from qovr_app.window.application import NAME
from qovr_app.window.folder import Folder
from qovr_app.window.shell import Answers
from qovr_app.window.sources import (
    DOCUMENT_SUFFIX,
    file_stamp,
    opened_by_worker,
    opened_if_small,
    place_of,
    written_document,
)
from qovr_app.window.windows import Windows, bring_forward, is_untouched
from qovr_app.work.worker import Worker
from qovr_core import QovrError
from qovr_core.files import source_suffixes
from qovr_core.files.sources import local_path

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow


class DocumentShell:
    """Asks for documents and has them read and written; says how it went.

    Parameters
    ----------
    worker : reads what is large
    commit_typed : takes what is just being typed, as leaving the field would
    windows : the others, which may have a file open
    """

    def __init__(
        self,
        store: Store,
        window: QWidget,
        folder: Folder,
        worker: Worker,
        *,
        commit_typed: Callable[[], None],
        windows: Windows,
    ) -> None:
        self._store, self._window, self._folder, self._worker = store, window, folder, worker
        self._commit_typed, self._windows = commit_typed, windows
        self.answers: Answers = {
            requests.OpenAsked: self._ask_for_source,
            requests.SourceAsked: self._open_source,
            requests.DocumentAsked: self._open_document,
            requests.ReloadAsked: self._reload,
            requests.SaveAsked: self._save,
            requests.SaveCopyAsked: self._save_copy,
            requests.RecentCleared: lambda _asked: folder.clear_recent(),
        }

    @property
    def _state(self) -> EditorState:
        return self._store.state

    # Opening

    def _ask_for_source(self, request: requests.OpenAsked) -> None:
        """Ask for a file and open it."""
        kinds = " ".join(f"*{suffix}" for suffix in source_suffixes())
        filters = f"Documents and workbooks ({kinds})"
        name, _ = QFileDialog.getOpenFileName(self._window, "Open", str(self._folder.path), filters)
        if name:
            self._open_source(requests.SourceAsked(name, request.elsewhere))

    def _open_source(self, request: requests.SourceAsked) -> None:
        """Open a file or a preset; what another window has open is shown there, what cannot be read changes nothing."""
        if self._is_shown_elsewhere(request.source):
            return
        is_elsewhere = request.elsewhere and not is_untouched(self._state)
        if not is_elsewhere and not self.may_leave():
            return
        opened = self._read(request.source)
        if opened is None:
            return
        if not opened.preset:
            self._folder.note_document(Path(local_path(request.source)))
        if is_elsewhere:
            self._windows.take(opened)
        else:
            self._take(opened)

    def _is_shown_elsewhere(self, source: str) -> bool:
        """Bring the window forward that has a file open, if another one has."""
        window = self._other_with(source)
        if window is not None:
            bring_forward(window)
        return window is not None

    def _other_with(self, source: str) -> MainWindow | None:
        try:
            place = patiently(self._window, f"Opening {Path(source).name}…", place_of, source)
        except QovrError:
            return None  # reading will say why
        return self._windows.having(place, besides=self._window)

    def _read(self, source: str) -> Opened | None:
        """Return what came of reading a source; None, and a sentence, where nothing did."""
        name = Path(source).name
        try:
            opened: Opened | None = patiently(self._window, f"Opening {name}…", opened_if_small, source)
            if opened is None:
                opened = at_work(self._window, self._worker, f"Opening {name}…", opened_by_worker, source)
        except QovrError as error:
            self._refuse(error)
            return None
        return opened

    def _open_document(self, request: requests.DocumentAsked) -> None:
        """Open a document that the program made, after asking about unsaved changes."""
        self.go_on_with(Opened(request.document, request.title, message=f"Opened {request.title}"))

    def go_on_with(self, opened: Opened) -> bool:
        """Take a document over, after asking about unsaved changes; return whether it was taken."""
        may_leave = self.may_leave()
        if may_leave:
            self._take(opened)
        return may_leave

    def _take(self, opened: Opened) -> None:
        self._store.dispatch(opened)
        self._store.flush()  # nothing that was meant for the document before may reach this one

    def _reload(self, _request: requests.ReloadAsked) -> None:
        """Read the document's file again; Undo brings back what stood here before."""
        path = self._state.file.path
        if path is not None and (opened := self._read(str(path))) is not None:
            self._store.dispatch(Reloaded(opened.document, opened.stamp))
            self._store.flush()

    # Saving

    def _save(self, request: requests.SaveAsked) -> bool:
        """Save, with what is just being typed, to the document's file or to one that is asked for."""
        self._commit_typed()
        path = self._state.file.path
        if path is None or request.elsewhere:
            path = self._asked_path()
        elif not self._may_write_over(path):
            return False
        return path is not None and self._save_to(path)

    def _save_copy(self, _request: requests.SaveCopyAsked) -> None:
        """Write the document, with what is just being typed, to a file that is asked for, and stay with its own."""
        self._commit_typed()
        path = self._asked_path()
        if path is None:
            return
        try:
            patiently(self._window, f"Saving {path.name}…", written_document, self._state.document, path)
        except QovrError as error:
            self._refuse(error)
        else:
            self._say(f"Saved a copy as {path.name}.")

    def may_leave(self) -> bool:
        """Ask about what is not saved, typed numbers included; return whether the document may go."""
        if not self._state.is_changed:
            return True
        text = f"Save the changes to {self._state.file.title}?"
        if self._state.has_pending:
            text += "\nNumbers are typed that are not set; Save sets them first."
        answers = dict.fromkeys((Answer.Save, Answer.Discard, Answer.Cancel), "")
        answer = ask(self._window, NAME, text, answers, Answer.Save)
        if answer == Answer.Save:
            return self._store.dispatch(PendingSet()) is None and self._save(requests.SaveAsked())
        return answer == Answer.Discard

    def _may_write_over(self, path: Path) -> bool:
        """Return whether the document's file may be replaced: as it was left here, or after a question."""
        try:
            self._store.dispatch(FileFound(path, patiently(self._window, f"Saving {path.name}…", file_stamp, path)))
        except GivenUpError as error:
            self._refuse(error)
            return False
        except QovrError:
            return True  # writing will say why
        file = self._state.file
        if not file.is_changed_outside:
            return True
        if file.found is None:
            text, answers = f"{path} was deleted or moved. Save it there again?", {Answer.Save: ""}
        else:
            text = f"{path} was changed by another program since it was read. Overwrite it?"
            answers = {Answer.Save: "&Overwrite", Answer.Open: "&Reload"}
        answer = ask(self._window, NAME, text, {**answers, Answer.Cancel: ""}, Answer.Cancel)
        if answer == Answer.Open:
            self._reload(requests.ReloadAsked())
        return answer == Answer.Save

    def _asked_path(self) -> Path | None:
        """Ask for a file to save to; one that another window has open is none."""
        first = self._folder.stem(self._state.file.title).with_suffix(DOCUMENT_SUFFIX)
        path = ask_for_target(self._window, "Save As", first, {DOCUMENT_SUFFIX: "QOVR documents"})
        if path is None or self._other_with(str(path)) is None:
            return path
        text = f"{path.name} is open in another window; save to another name, or close it there."
        self._say(text, is_refusal=True)
        return None

    def _save_to(self, path: Path) -> bool:
        state = self._state
        try:
            place, stamp = patiently(self._window, f"Saving {path.name}…", written_document, state.document, path)
        except QovrError as error:
            self._refuse(error)
            return False
        self._folder.note_document(path)
        self._store.dispatch(Saved(place, path.name, state.history.serial, stamp))
        if self._state.has_pending:
            self._say(f"Saved {path.name}, without what is typed and not set.")
        return True

    def _refuse(self, error: QovrError) -> None:
        self._say(f"{error}.", is_refusal=True)

    def _say(self, text: str, *, is_refusal: bool = False) -> None:
        self._store.dispatch(MessageShown(text, is_refusal))
