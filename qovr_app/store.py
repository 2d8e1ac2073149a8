"""The store: holds the state, is its only writer, and says once a turn of the event loop what has changed."""

from __future__ import annotations

from collections.abc import Callable

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent, Request
from qovr_app.state.looking_steps import refused
from qovr_app.state.next_state import next_state
from qovr_app.state.session import Session
from qovr_core import QovrError

Listener = Callable[[EditorState | None, EditorState], None]
"""Called with the state that was shown last, None the first time, and the one to show now."""

Dispatch = Callable[[Intent], QovrError | None]
"""Takes an intent; returns why it was not followed, or nothing."""


class Store:
    """One window's state.

    Parameters
    ----------
    state : with what it begins
    schedule : asks for ``flush`` at the end of this turn of the event loop; asking twice is asking once
    """

    def __init__(self, state: EditorState, schedule: Callable[[], None]) -> None:
        self._state = self._shown = state
        self._schedule = schedule
        self._perform: Callable[[Request], None] = _nobody_answers
        self._listeners: list[Listener] = []
        self.session = Session()

    @property
    def state(self) -> EditorState:
        """The state as it is now, shown or not."""
        return self._state

    @property
    def shown(self) -> EditorState:
        """The state that listeners were told last."""
        return self._shown

    def subscribe(self, listener: Listener) -> None:
        """Tell a part what is shown now, and every change from then on, after the parts that came before it."""
        self._listeners.append(listener)
        listener(None, self._shown)

    def answer_with(self, perform: Callable[[Request], None]) -> None:
        """Let a shell answer requests; it dispatches what comes of them."""
        self._perform = perform

    def dispatch(self, intent: Intent) -> QovrError | None:
        """Follow an intent, or say in the message line, and to the caller, why not."""
        if isinstance(intent, Request):
            self._perform(intent)
            return None
        self.session.note(intent)
        try:
            self._state = next_state(self._state, intent)
        except QovrError as error:
            self._state = refused(self._state, error)
            self._schedule()
            return error
        if self._state is not self._shown:
            self._schedule()
        return None

    def flush(self) -> None:
        """Say now what has changed; what listeners dispatch is said in the next turn."""
        before, self._shown = self._shown, self._state
        if before is not self._shown:
            for listener in tuple(self._listeners):
                listener(before, self._shown)


def _nobody_answers(request: Request) -> None:
    raise TypeError(f"nobody answers {type(request).__name__}; expected a shell, given to answer_with")
