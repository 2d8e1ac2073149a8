"""What the open influence panel adds to every edit."""

import pytest

from qovr_core import Formulation, Layer
from qovr_core.edits import Direction, KnotPlace, set_formulation
from qovr_core.laboratory.influence import KnotMove, PointMove, influence
from qovr_core.presets import preset

from .conftest import MEDIANS

MOST_SECONDS = 0.010
"""An edit, its influence and their drawing have to fit into one picture of 60 a second."""

CHANGES = {
    "a point": PointMove(2, 2, (0.0, 0.0, 0.57)),
    "a knot": KnotMove(KnotPlace(Direction.COLUMNS, 1, "s"), 0.1),
}


@pytest.mark.parametrize("layer", Layer)
@pytest.mark.parametrize("what", CHANGES)
def test_an_influence_is_found_within_a_picture(measure, row, what, layer):
    document = set_formulation(preset("fig6c").document, Formulation.INTERPOLATING)
    name = f"influence of {what}, {layer}"
    measure(name, 101, lambda: influence(document, CHANGES[what], layer), rounds=50)
    row(f"{name}: part of 10 ms", 101, MEDIANS[name, 101] / MOST_SECONDS, at_most=1)
