"""What an earlier run left unsaved, offered in a bar over the work until it is answered."""

from __future__ import annotations

from datetime import datetime
from functools import partial

from PySide6.QtWidgets import QWidget

from qovr_app.state.intents import Opened
from qovr_app.state.requests import RecoveryAnswered
from qovr_app.store import Dispatch
from qovr_app.widgets.notice import Notice
from qovr_app.window.document_shell import DocumentShell
from qovr_app.window.recovery import RecoveryStore, Unsaved
from qovr_app.window.shell import Answers


class RecoveryOffer:
    """Offers one document after the other; ``notice`` is the bar."""

    def __init__(self, documents: DocumentShell, dispatch: Dispatch, parent: QWidget) -> None:
        self._documents = documents
        self._unsaved: list[Unsaved] = []
        self.answers: Answers = {RecoveryAnswered: self._answer}
        self.notice = Notice("recovery", parent)
        for name, text, tip in (
            ("restore", "Restore", "Go on with the unsaved document"),
            ("discard", "Discard", "Delete the unsaved document"),
        ):
            answer = RecoveryAnswered(is_wanted=name == "restore")
            self.notice.add_answer(name, text, tip, partial(dispatch, answer))

    def offer(self, store: RecoveryStore) -> None:
        """Offer what earlier runs left unsaved."""
        self._unsaved = store.found()
        self._ask()

    def _answer(self, request: RecoveryAnswered) -> None:
        """Go on with the document that is offered, or delete it."""
        entry = self._unsaved[0]
        if request.is_wanted:
            message = f"Restored {entry.title}; it is not saved yet."
            restored = Opened(entry.document, entry.title, entry.path, is_saved=False, message=message)
            if not self._documents.go_on_with(restored):
                return
        self._unsaved.pop(0).remove()
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
