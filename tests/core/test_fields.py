"""Fields against surfaces whose curvature is known, against another formula for it, and ranges by hand."""

import math

import numpy as np
import pytest
from hypothesis import given, settings

from qovr_core import Document, Evaluation, Layer, Patch, build_patch, edits
from qovr_core.edits import Direction, KnotPlace
from qovr_core.fields import FIELDS, Field, field_range, field_rounding, field_values
from qovr_core.laboratory.sensitivity import knot_sensitivity
from qovr_core.presets import preset
from support.documents import random_document, seeds

U, V = np.linspace(0, 1, 9), np.linspace(0, 1, 6)
CURVATURES = (Field.GAUSSIAN, Field.MEAN, Field.LARGEST, Field.SMALLEST)


def graph(height):
    """Return z = height(x, y), at most quadratic in each, over x = 1 + 2 u, y = 1 + 2 v: the interpolating surface."""
    y, x = np.mgrid[:5, :5].astype(float)
    return build_patch(Document(np.stack([x, y, height(x, y) + 0 * x], axis=-1), formulation="interpolating"))


X, Y = (1 + 2 * U)[:, None] + 0 * V, (1 + 2 * V)[None, :] + 0 * U[:, None]


def check(surface, **expected):
    for name, values in expected.items():
        found = field_values(FIELDS[name], surface, U, V)
        assert not found.flags.writeable
        assert found == pytest.approx(np.broadcast_to(values, found.shape), abs=1e-11), name


def test_a_plane():
    check(graph(lambda x, y: 0.5 * x - y + 3), height=0.5 * X - Y + 3, gaussian=0, mean=0, largest=0, smallest=0)


def test_a_parabolic_cylinder():
    bent = 2 / (1 + 4 * (X - 2) ** 2) ** 1.5
    check(graph(lambda x, y: (x - 2) ** 2), gaussian=0, mean=bent / 2, largest=bent, smallest=0)
    check(graph(lambda x, y: -((x - 2) ** 2)), gaussian=0, mean=-bent / 2, largest=0, smallest=-bent)


def test_a_saddle():
    w = 1 + X**2 + Y**2
    gaussian, mean = -1 / w**2, -X * Y / w**1.5
    root = np.sqrt(mean**2 - gaussian)
    check(graph(lambda x, y: x * y), gaussian=gaussian, mean=mean, largest=mean + root, smallest=mean - root)


@given(seeds)
@settings(max_examples=25, deadline=None)
def test_curvatures_are_those_of_the_turning_normal(seed):
    """Weingarten's equations: dn = -W dS; the normals are differenced, and W is solved for and diagonalised."""
    surface, h = build_patch(random_document(seed, low=0.35, high=0.65)), 1e-5
    u, v = np.linspace(0.2, 0.8, 4), np.linspace(0.15, 0.9, 3)
    values = {field: field_values(field, surface, u, v) for field in CURVATURES}
    normal_u = (surface.normals(u + h, v) - surface.normals(u - h, v)) / (2 * h)
    normal_v = (surface.normals(u, v + h) - surface.normals(u, v - h)) / (2 * h)
    su, sv = surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)
    for i, j in np.ndindex(4, 3):
        tangents = np.stack([su[i, j], sv[i, j]], axis=1)
        if np.linalg.cond(tangents) > 50:
            continue  # there the differences say nothing
        turning = np.stack([normal_u[i, j], normal_v[i, j]], axis=1)
        shape = -np.linalg.lstsq(tangents, turning, rcond=None)[0]
        smallest, largest = np.sort(np.linalg.eigvals(shape).real)
        expected = {
            Field.GAUSSIAN: np.linalg.det(shape),
            Field.MEAN: np.trace(shape) / 2,
            Field.LARGEST: largest,
            Field.SMALLEST: smallest,
        }
        size = 1 + np.abs(shape).max()
        for field, value in expected.items():
            power = -field.length_power
            tolerance = 1e-3 if field in (Field.LARGEST, Field.SMALLEST) else 1e-5  # a root, at an umbilic
            assert values[field][i, j] == pytest.approx(value, abs=tolerance * size**power), field


def test_curvature_has_no_value_where_the_surface_is_drawn_together():
    coefficients = graph(lambda x, y: x * y).coefficients[0, 0].copy()
    coefficients[0] = coefficients[0, 0]
    for field in CURVATURES:
        values = field_values(field, Patch(coefficients), U, V)
        assert np.isnan(values[0]).all()
        assert np.isfinite(values[1:]).all()


def test_distance_from_a_shifted_plane_and_from_itself():
    plane, shift = graph(lambda x, y: 0.75 * x), np.eye(4)
    shift[:3, 3] = 0.4 * np.array([-0.6, 0, 0.8])  # along the normal
    inner = np.linspace(0.2, 0.8, 7)
    distances = field_values(Field.DISTANCE, plane.transformed(shift), inner, inner, plane)
    assert distances == pytest.approx(np.full((7, 7), 0.4), abs=1e-12)
    bent = build_patch(random_document(3))
    assert field_values(Field.DISTANCE, bent, U, V, bent) == pytest.approx(np.zeros((9, 6)), abs=1e-12)


def test_sensitivity_is_the_length_of_the_derivative():
    document = random_document(4, low=0.3, high=0.7)
    place = KnotPlace(Direction.ROWS, 2, "s")
    result = Evaluation(document)
    values = field_values(Field.SENSITIVITY, result.patch, U, V, knot_sensitivity(result, place, Layer.RAW))
    value, h = edits.value_at(document, place), 1e-6
    lower, upper = (build_patch(edits.set_values(document, {place: value + step})).points(U, V) for step in (-h, h))
    assert values == pytest.approx(np.linalg.norm((upper - lower) / (2 * h), axis=-1), abs=1e-6)


@pytest.mark.parametrize("field", [Field.DISTANCE, Field.SENSITIVITY])
def test_a_field_that_needs_a_companion_says_so(field):
    with pytest.raises(ValueError, match=f"{field} has no surface beside it"):
        field_values(field, graph(lambda x, y: 0 * x), U, V)


def test_ranges():
    values = np.array([[-1.0, 3.0], [np.nan, np.inf]])
    assert field_range(Field.HEIGHT, values, robust=False) == (-1, 3)
    assert field_range(Field.MEAN, values, robust=False) == (-3, 3)
    many = np.arange(101.0)
    assert field_range(Field.DISTANCE, many, robust=True) == pytest.approx((2, 98))
    assert field_range(Field.GAUSSIAN, many, robust=True) == pytest.approx((-98, 98))
    spike = np.append(np.ones(1000), 1e9)
    assert field_range(Field.MEAN, spike, robust=True) == (-1, 1)


@pytest.mark.parametrize("robust", [False, True])
def test_ranges_of_what_has_none(robust):
    for field in FIELDS.values():
        assert all(math.isnan(end) for end in field_range(field, np.full(4, np.nan), robust=robust))
        assert all(math.isnan(end) for end in field_range(field, np.empty(0), robust=robust))
    assert field_range(Field.HEIGHT, np.full(9, 0.3), robust=robust) == (0.3, 0.3)
    assert field_range(Field.MEAN, np.full(9, -0.3), robust=robust) == (-0.3, 0.3)
    assert field_range(Field.GAUSSIAN, np.zeros(9), robust=robust) == (0, 0)


@pytest.mark.parametrize("away", [0.0, 1e5])
@pytest.mark.parametrize("size", [1e-6, 1.0, 1e6])
def test_rounding_is_not_taken_for_a_range(size, away):
    """The plane has no curvature and a level one no heights, whatever its size and wherever it is."""
    y, x = np.mgrid[:5, :5].astype(float)
    net = size * (np.stack([x + 0.2 * y, y - 0.3 * x, 0 * x], axis=-1) + away)
    surface = build_patch(Document(net, formulation="interpolating"))
    points = surface.points(U, V)
    for field in (Field.HEIGHT, *CURVATURES):
        low, high = field_range(
            field, field_values(field, surface, U, V), robust=False, least=field_rounding(field, points)
        )
        assert low == high


def test_what_there_is_is_not_taken_for_rounding():
    surface = build_patch(edits.set_formulation(preset("fig5").document, "interpolating"))
    points = surface.points(U, V)
    for field in (Field.HEIGHT, *CURVATURES):
        values = field_values(field, surface, U, V)
        low, high = field_range(field, values, robust=False, least=field_rounding(field, points))
        assert high - low > 1e6 * field_rounding(field, points)
        assert (high == -low) == field.is_diverging
