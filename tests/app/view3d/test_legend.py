"""Which line is what, and what a colour means in two layers side by side."""

import re

import numpy as np
import pytest

from qovr_app.state.display import LayerChoice
from qovr_app.state.figure_options import FigureOptions
from support.view import choose

LINES = {
    "row_curves": "Ci(u)",
    "column_curves": "Kj(v)",
    "control_box": "Box of the points",
    "surface_box": "Box of the",
}


def said(view, folder):
    """Return what a figure of the view says, without the breaks between pieces of text."""
    view.save_figure(folder / "a.svg", FigureOptions(160, 120, 100))
    text = (folder / "a.svg").read_text(encoding="utf-8")
    return "".join(re.findall(r"<text[^>]*>([^<]*)</text>", text)).replace("\n", "").replace(" ", "")


@pytest.mark.parametrize("setting", LINES)
def test_lines_beside_the_net_have_names(make_view, document, setting, tmp_path):
    view = make_view(document, labels=False).view
    name = LINES[setting].replace(" ", "")
    assert "Controlnet" not in said(view, tmp_path)
    choose(view, **{setting: True})
    assert name in said(view, tmp_path)
    assert "Controlnet" in said(view, tmp_path)
    choose(view, control_net=False)
    assert "Controlnet" not in said(view, tmp_path)
    choose(view, legend=False)
    assert name not in said(view, tmp_path)


def test_both_layers_can_have_one_range_of_colours_and_then_one_bar(make_view, document, tmp_path):
    view = make_view(document, layer=LayerChoice.BOTH, at_rest=False, axes=False).view
    title = "Z-AxisValue"
    assert said(view, tmp_path).count(title) == 2
    own = [view.picture(k).colouring.limits for k in range(2)]
    assert own[0] != own[1]
    choose(view, shares_range=True)
    shared = [view.picture(k).colouring.limits for k in range(2)]
    assert said(view, tmp_path).count(title) == 1
    assert shared[0] == shared[1] == (min(low for low, _ in own), max(high for _, high in own))
    choose(view, shares_range=False)
    assert [view.picture(k).colouring.limits for k in range(2)] == own
    choose(view, shares_range=True, layer=LayerChoice.RAW)
    np.testing.assert_allclose(view.picture().colouring.limits, own[0])
