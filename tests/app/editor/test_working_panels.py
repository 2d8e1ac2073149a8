"""Panels whose contents a job finds: it goes on in a minimised window, and ends with a panel that is closed."""

import os
import signal
import sys

import pytest
from PySide6.QtGui import QHideEvent

from qovr_app.laboratory.panel import WorkingPanel
from support.editor import wait_until
from support.working import children


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


@pytest.mark.skipif(sys.platform != "linux", reason="the worker is found in /proc")
@pytest.mark.parametrize("name", ["claims", "comparison"])
def test_work_whose_process_was_killed_can_be_begun_again(editor, name):
    editor.trigger(f"laboratory_{name}")
    again = editor.find(f"laboratory.{name}.again")
    wait_until(children)
    for pid in children():
        os.kill(pid, signal.SIGKILL)
    wait_until(again.isVisible)
    assert "ended unexpectedly" in editor.find(f"laboratory.{name}.state").text()
    again.click()
    panel = editor.find(f"laboratory.{name}")
    wait_until(lambda: not again.isVisible() and panel.is_current, 60)
