"""Where the edges of a patch stand in its arrays."""

import numpy as np
import pytest

from qovr_core import Edge, build_patch
from support.documents import random_document


@pytest.mark.parametrize("edge", Edge)
def test_an_edge_is_where_its_name_says(edge):
    patch, along = build_patch(random_document(3)), np.linspace(0, 1, 5)
    parameter, at = edge.value[0], [float(edge.value[-1])]
    u, v = (at, along) if parameter == "u" else (along, at)
    samples = patch.points(along, along)
    assert samples[edge.position] == pytest.approx(patch.points(u, v).reshape(-1, 3), abs=1e-12)
    assert np.array_equal(patch.edge(edge)[0], patch.coefficients[0, 0][edge.position])
    start, end = edge.corners
    assert np.array_equal(samples[start], samples[edge.position][0])
    assert np.array_equal(samples[end], samples[edge.position][-1])
