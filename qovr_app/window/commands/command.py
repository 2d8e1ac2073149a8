"""What a command is: a record whose marks are functions of the state and which is carried out by an intent."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtGui import QKeySequence

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Intent


def _always(_state: EditorState) -> bool:
    return True


@dataclass(frozen=True)
class Command:
    """One command.

    Parameters
    ----------
    name : the action's object name, by which tests and other programs find it
    text : what the menu says
    intent : what it asks for, in a state
    menu : the menu it stands in, as "View/Show"
    shortcut : a standard key or a sequence as text
    tip : one sentence for the status bar; empty takes the text
    group : commands of one group exclude each other
    is_checked : whether it has its check mark; None where it has none ever
    is_enabled : whether it can be asked for
    is_shown : whether menus and bars have it at all
    noun : what the text ends with in a state, as the step that Undo takes back
    begins_part : whether the menu has a line before it
    needs : what has to be done before it can be asked for
    """

    name: str
    text: str
    intent: Callable[[EditorState], Intent]
    menu: str
    shortcut: QKeySequence.StandardKey | str | None = None
    tip: str = ""
    group: str = ""
    is_checked: Callable[[EditorState], bool] | None = None
    is_enabled: Callable[[EditorState], bool] = _always
    is_shown: Callable[[EditorState], bool] = _always
    noun: Callable[[EditorState], str] | None = None
    begins_part: bool = False
    needs: str = ""

    @property
    def varies(self) -> bool:
        """Whether its marks, or the noun in its text, follow the state."""
        always = self.is_shown is self.is_enabled is _always
        return not always or self.is_checked is not None or self.noun is not None


def asking(intent: Intent) -> Callable[[EditorState], Intent]:
    """Return what asks for the same in every state."""
    return lambda _state: intent
