"""What the open influence panel adds to every edit."""

import pytest

from qovr_core import Formulation, Layer
from qovr_core.edits import Direction, KnotPlace, set_formulation
from qovr_core.laboratory.influence import KnotMove, PointMove, influence
from qovr_core.presets import preset

CHANGES = {
    "point": PointMove(2, 2, (0.0, 0.0, 0.57)),
    "knot": KnotMove(KnotPlace(Direction.COLUMNS, 1, "s"), 0.1),
}


@pytest.mark.parametrize("layer", Layer)
@pytest.mark.parametrize("what", CHANGES)
def test_an_influence_is_found_within_a_picture(measure, what, layer):
    document = set_formulation(preset("fig6c").document, Formulation.INTERPOLATING)
    measure(f"influence {what} {layer}", lambda: influence(document, CHANGES[what], layer), rounds=30)
