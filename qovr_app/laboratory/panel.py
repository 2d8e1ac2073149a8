"""What every panel of the laboratory is: a widget that shows states and dispatches intents."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import MessageOutdated, MessageShown
from qovr_app.store import Store
from qovr_app.widgets.parts import CompactButton
from qovr_app.work.job import Job
from qovr_app.work.quiet import QuietJob
from qovr_app.work.worker import Worker

WIDE = 560
"""Logical pixels from which on the parts of a panel stand beside each other, and below each other in less."""


class LaboratoryPanel(QWidget):
    """A panel that shows something of the configured surface and changes nothing by itself.

    While it is seen, its dock shows it the state: when it comes before the user's eyes, and then whenever the state
    changes, before the turn's frame; during a gesture less often, see ``SeenPart``.
    """

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.store, self.worker = store, worker

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show a state.

        Parameters
        ----------
        before : the state that this panel has shown last; None the first time
        after : the state to show
        """

    def tell(self, text: str, *, is_refusal: bool = False) -> None:
        """Say one sentence in the message line."""
        self.store.dispatch(MessageShown(text, is_refusal))

    def refuse(self, reason: str) -> None:
        """Say why what is typed is not taken; empty says that this is outdated."""
        self.store.dispatch(MessageShown(reason, is_refusal=True) if reason else MessageOutdated(only_refusals=True))


class WorkingPanel(LaboratoryPanel):
    """A panel that shows what a job finds, which the worker does while the panel is shown and nothing changes.

    Parameters
    ----------
    begin : asks the worker for the job, of what is shown; returns None where there is nothing to do
    is_outdated : whether there is something to do, and not all of it has been found
    """

    def __init__(
        self,
        store: Store,
        worker: Worker,
        begin: Callable[[], Job | None],
        is_outdated: Callable[[], bool],
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(store, worker, parent)
        self.work = QuietJob(begin, self)
        self._is_outdated = is_outdated
        self._again: CompactButton | None = None

    def with_again(self, state: QWidget, name: str) -> QHBoxLayout:
        """Return a row of what says how the job goes, and a button to begin it again that is there after a failure."""
        self._again = CompactButton("Try again", f"{name}.again", "Begin the work again", self)
        self._again.clicked.connect(lambda _checked: self.work.restart())
        self._again.setVisible(False)
        row = QHBoxLayout()
        row.addWidget(state, 1)
        row.addWidget(self._again)
        return row

    def offer_again(self, *, is_offered: bool) -> None:
        """Offer to begin the job again, or no longer."""
        if self._again is not None:
            self._again.setVisible(is_offered)

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        if self._is_outdated() and not self.work.is_running:
            self.work.restart()

    def hideEvent(self, event: QHideEvent) -> None:
        super().hideEvent(event)
        if not event.spontaneous():  # a minimised window comes back as it was
            self.work.stop()
