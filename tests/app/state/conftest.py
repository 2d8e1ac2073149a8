"""What the tests of the editor's logic begin with."""

import pytest

from qovr_app.state.editor_state import EditorState
from support.states import opened


@pytest.fixture
def start() -> EditorState:
    """The editor with Figure 5."""
    return opened()
