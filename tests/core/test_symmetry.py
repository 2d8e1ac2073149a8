"""Documents made symmetric, and edits that keep them so: judged by the surface."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_core import Document, Formulation, QovrError, configure
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, set_values
from qovr_core.shapes import SHAPES
from qovr_core.symmetry import Source, make_symmetric, mirrored_values
from support.documents import random_document


def asymmetry(document: Document, across: Direction) -> float:
    """Return how far the sampled surface is from its mirror image."""
    raw = configure(replace(document, samples=(21, 17), formulation=Formulation.INTERPOLATING)).raw
    axis, coordinate = (0, 0) if across is Direction.COLUMNS else (1, 1)
    image = np.flip(raw, axis).copy()
    middle = document.control_points[:, 2, 0].mean() if axis == 0 else document.control_points[2, :, 1].mean()
    image[..., coordinate] = 2 * middle - image[..., coordinate]
    return float(np.abs(raw - image).max())


@pytest.mark.parametrize("across", Direction)
@pytest.mark.parametrize("source", Source)
def test_the_surface_is_its_own_mirror_image(across, source):
    document = random_document(3, low=0.3, high=0.7)
    assert asymmetry(document, across) > 1e-3
    symmetric = make_symmetric(document, across, source)
    assert asymmetry(symmetric, across) < 1e-13
    assert asymmetry(make_symmetric(symmetric, across, Source.FIRST), across) < 1e-13


@pytest.mark.parametrize(("source", "kept"), [(Source.FIRST, slice(0, 2)), (Source.LAST, slice(3, 5))])
def test_one_side_stays_as_it_is(source, kept):
    document = random_document(4, low=0.3, high=0.7)
    symmetric = make_symmetric(document, Direction.COLUMNS, source)
    np.testing.assert_allclose(symmetric.control_points[:, kept], document.control_points[:, kept], atol=1e-15)
    assert np.array_equal(symmetric.column_knots.array[kept], document.column_knots.array[kept])
    assert symmetric.column_knots[2, 0] == document.column_knots[2, 0]
    ends = [(knots.r, knots.t) for knots in document.row_knots.in_window(0)]
    for knots, (r, t) in zip(symmetric.row_knots.in_window(0), ends, strict=True):
        assert (knots.s, knots.u) == (0.5, 0.5)
        assert (knots.r if source is Source.FIRST else knots.t) == (r if source is Source.FIRST else t)
        assert knots.r == pytest.approx(1 - knots.t)


@pytest.mark.parametrize("across", Direction)
def test_numbers_set_with_their_images_leave_a_symmetric_document_symmetric(across):
    document = make_symmetric(random_document(5, low=0.3, high=0.7), across, Source.MEAN)
    values = {
        CoordinatePlace(1, 1, 0): 1.7,
        CoordinatePlace(0, 4, 1): 0.3,
        CoordinatePlace(2, 2, 2): 0.9,
        KnotPlace(across, 1, "u"): 0.3,
        KnotPlace(across, 0, "s"): 0.6,
        KnotPlace(across.other, 3, "r"): 0.35,
        KnotPlace(across.other, 1, "t"): 0.45,
    }
    wanted = mirrored_values(document, values, across)
    assert wanted.items() >= values.items()
    edited = set_values(document, wanted)
    assert asymmetry(edited, across) < 1e-13
    assert edited != document


@pytest.mark.parametrize("place", [KnotPlace(Direction.ROWS, 2, "u"), CoordinatePlace(1, 2, 0)])
def test_what_would_leave_the_plane_is_refused(place):
    document = SHAPES["dome"].document()
    with pytest.raises(QovrError, match="as symmetry has it"):
        mirrored_values(document, {place: 0.625}, Direction.COLUMNS)


@pytest.mark.parametrize("name", SHAPES)
def test_shapes_to_begin_with_interpolate_and_configure(name):
    document = SHAPES[name].document()
    assert document.formulation == Formulation.INTERPOLATING
    raw = configure(document).raw
    np.testing.assert_allclose(raw[0, 0], document.control_points[1, 1], atol=1e-14)
    assert np.isfinite(raw).all()
