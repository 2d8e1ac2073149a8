"""What edits leave behind: nothing that waits for Python to look for circles, which it does by number, not by size."""

import gc

import pytest
from PySide6.QtTest import QTest

from qovr_app.state.display import LayerChoice
from qovr_app.state.intents import PointsMoved
from qovr_app.state.looking_intents import DisplayChosen, PanelShown
from qovr_app.view3d.scene.scene import Scene
from qovr_app.widgets.seen_part import BEHIND
from qovr_core import Evaluation

PANELS = ("", "curve", "influence", "comparison", "section")


@pytest.mark.parametrize("panel", PANELS)
@pytest.mark.parametrize("shape", ["paper", "folded-saddle"])
def test_scenes_and_surfaces_go_with_the_edit_that_replaces_them(make_editor, shape, panel):
    editor = make_editor(size=(900, 600))  # little of the view, of which nothing is looked at
    editor.trigger(f"new_{shape}")
    editor.dispatch(PanelShown(panel))
    editor.dispatch(DisplayChosen("layer", LayerChoice.BOTH))
    editor.dispatch(DisplayChosen("shares_range", True))

    def move(count):
        for k in range(count):
            editor.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, 0.01 * (-1) ** k),), gesture=100 + k))
            editor.settle()
        QTest.qWait(2 * BEHIND)  # a panel that was told last in the midst of a gesture still has its state

    move(3)
    gc.collect()
    gc.disable()
    try:
        kept = count_of(Scene), count_of(Evaluation)
        move(6)
        assert (count_of(Scene), count_of(Evaluation)) == kept
    finally:
        gc.enable()


def count_of(kind):
    return sum(type(each) is kind for each in gc.get_objects())
