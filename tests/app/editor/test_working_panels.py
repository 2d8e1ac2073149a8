"""Panels whose contents a job finds: it goes on in a minimised window, and ends with a panel that is closed."""

import pytest
from PySide6.QtGui import QHideEvent

from qovr_app.laboratory.panel import WorkingPanel
from support.editor import wait_until


class Minimised(QHideEvent):
    """What the window system sends when it minimises a window."""

    def spontaneous(self):
        return True


@pytest.mark.parametrize("name", ["claims", "comparison"])
def test_the_work_of_a_panel_ends_when_it_is_closed_but_not_when_its_window_is_minimised(editor, name):
    editor.trigger(f"laboratory_{name}")
    panel = editor.find(f"laboratory.{name}", WorkingPanel)
    wait_until(lambda: panel.work.is_running)
    panel.hideEvent(Minimised())
    assert panel.work.is_running
    editor.click("laboratory.close")
    assert not panel.work.is_running
    editor.trigger(f"laboratory_{name}")
    wait_until(lambda: panel.work.is_running)
