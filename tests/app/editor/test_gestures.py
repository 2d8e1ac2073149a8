"""Every gesture of the table, by real events in one window. ``QOVR_PICTURES=FOLDER`` keeps a picture of each."""

import os
import re
from dataclasses import fields
from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication, QDialog

from gestures import GESTURES
from gestures.gesture import GestureHand
from qovr_app.state.display import DisplaySettings
from qovr_app.state.intents import LiveSwitched, Opened
from qovr_app.state.knot_intents import LinkSwitched
from qovr_app.state.looking_intents import DisplayChosen, PanelShown, Selected, ToolChosen
from qovr_app.state.tools import ToolSettings
from qovr_core.edits import set_samples
from qovr_core.presets import preset
from support.editor import wait_until

PICTURES = os.environ.get("QOVR_PICTURES")

COARSE = (31, 31)
"""Samples of a surface that nobody looks at."""


@pytest.fixture
def editor(one_window):
    """The one window as it opens: the paper's example, every setting as at first."""
    document = preset("fig5").document if PICTURES else set_samples(preset("fig5").document, COARSE)
    one_window.window.store.dispatch(Opened(document, "fig5", preset="fig5"))
    for choose, settings, now in (
        (DisplayChosen, DisplaySettings(), one_window.window.store.state.display),
        (ToolChosen, ToolSettings(), one_window.window.store.state.tools),
    ):
        for field in fields(settings):
            if getattr(now, field.name) != getattr(settings, field.name):
                one_window.window.store.dispatch(choose(field.name, getattr(settings, field.name)))
    one_window.window.store.dispatch(LiveSwitched(is_live=True))
    for link in ("curves", "directions"):
        one_window.window.store.dispatch(LinkSwitched(link, is_on=link == "curves"))
    one_window.window.store.dispatch(PanelShown(""))
    one_window.window.store.dispatch(Selected(None))
    one_window.window.view.set_camera("paper", animated=False)
    one_window.window.view.fit(animated=False)
    one_window.window.activateWindow()  # without a window manager it does not come back after a dialog
    wait_until(one_window.window.isActiveWindow)
    one_window.window.view.viewports[0].widget.setFocus()
    one_window.settle()
    yield one_window
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()
    for dialog in one_window.window.findChildren(QDialog):
        dialog.close()
    one_window.settle()


def slug(text):
    return re.sub("[^A-Za-z0-9+]+", "-", text).strip("-").lower()


@pytest.mark.parametrize(
    ("number", "gesture"), [pytest.param(*each, id=slug(each[1].name)) for each in enumerate(GESTURES, start=1)]
)
def test_a_gesture(editor, number, gesture):
    picture = Path(PICTURES, f"{number:03} {slug(gesture.name)}.png") if PICTURES else None
    if picture is not None:
        picture.parent.mkdir(parents=True, exist_ok=True)
    hand = GestureHand(editor, picture)
    gesture.run(hand)
    assert hand.shown


def test_no_gesture_stands_there_twice():
    names = [gesture.name for gesture in GESTURES]
    assert len(names) >= 40
    assert len(set(names)) == len(names)
