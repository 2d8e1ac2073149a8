"""Sections by planes, against curves that are known: circles, parabolas, hyperbolas, edges, and the turned surface."""

from math import asinh, pi, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Document, Evaluation, Formulation
from qovr_core.geometry.section import plane_across, section, upright_plane
from support.documents import random_document, seeds

ROWS, COLUMNS = np.mgrid[:5, :5].astype(float)


def height_field(z):
    """Return the surface z(x, y) over 1..3 x 1..3: with knots of 0.5 it is exact for quadratic z."""
    net = np.stack([COLUMNS, ROWS, z(COLUMNS - 2, ROWS - 2)], axis=-1)
    return Evaluation(Document(net, formulation="interpolating")).patch


def parabola_length(half_width):
    """Return the length of z = x^2 from -half_width to half_width."""
    return half_width * sqrt(1 + 4 * half_width**2) + asinh(2 * half_width) / 2


def test_a_paraboloid_is_cut_in_circles_and_parabolas():
    bowl = height_field(lambda x, y: x * x + y * y)
    offset, (circle,) = section(bowl, plane_across(2, 0.25))
    assert offset == 0.25
    assert circle.is_closed
    assert circle.length == pytest.approx(pi, abs=1e-8)
    assert np.hypot(*(circle.points[:, :2] - 2).T) == pytest.approx(np.full(len(circle.points), 0.5), abs=1e-13)
    offset, (middle,) = section(bowl, plane_across(1, None))
    assert offset == pytest.approx(2)
    assert not middle.is_closed
    assert middle.length == pytest.approx(parabola_length(1), abs=1e-8)
    _, (diagonal,) = section(bowl, upright_plane([1, 1, 7], [3, 3, -7]))
    assert diagonal.length == pytest.approx(parabola_length(sqrt(2)), abs=1e-8)


def test_a_section_runs_on_through_all_windows_of_a_net():
    y, x = np.mgrid[:7, :9].astype(float)
    net = np.stack([x, y, (x - 4) ** 2 + (y - 3) ** 2], axis=-1)
    bowl = Evaluation(Document(net, formulation="interpolating")).patch
    _, (circle,) = section(bowl, plane_across(2, 2.25))
    assert circle.is_closed
    assert np.hypot(*(circle.points[:, :2] - [4, 3]).T) == pytest.approx(np.full(len(circle.points), 1.5), abs=1e-9)
    assert circle.length == pytest.approx(3 * pi, rel=1e-5)
    _, (across,) = section(bowl, plane_across(1, 2.0))
    assert sorted(across.points[[0, -1], 0]) == pytest.approx([1, 7])


@pytest.mark.parametrize(("axis", "place"), [(0, 1.0), (0, 3.0), (1, 1.0), (1, 3.0)])
def test_an_edge_that_lies_in_the_plane_is_found(axis, place):
    bowl = height_field(lambda x, y: x * x + y * y)
    _, (edge,) = section(bowl, plane_across(axis, place))
    assert edge.length == pytest.approx(parabola_length(1), abs=1e-8)


def test_pieces_come_longest_first_and_a_plane_that_misses_gives_none():
    saddle = height_field(lambda x, y: x * x - y * y)
    _, pieces = section(saddle, plane_across(2, 0.2))
    assert len(pieces) == 2
    assert pieces[0].length == pytest.approx(pieces[1].length)
    for piece in pieces:
        x, y = piece.points[:, 0] - 2, piece.points[:, 1] - 2
        assert x * x - y * y == pytest.approx(np.full(len(x), 0.2), abs=1e-13)
    assert section(saddle, plane_across(2, 5.0)) == (5.0, ())
    flat = height_field(lambda x, y: 0 * x + 3)
    assert section(flat, plane_across(2, 3.0)) == (3.0, ())
    assert upright_plane([1, 2, 3], [1, 2, 9]) is None


@settings(max_examples=15)
@given(seeds, st.integers(0, 2))
def test_points_lie_on_surface_and_plane_and_length_is_that_of_many_chords(seed, axis):
    patch = Evaluation(random_document(seed, Formulation.INTERPOLATING, low=0.35, high=0.65)).patch
    offset, pieces = section(patch, plane_across(axis, None))
    assert pieces
    for piece in pieces:
        on = patch.derivative_at(piece.parameters[:, 0], piece.parameters[:, 1], 0, 0)
        assert piece.points == pytest.approx(on, abs=1e-12)
        assert piece.points[:, axis] == pytest.approx(np.full(len(on), offset), abs=1e-8)
        chords = np.linalg.norm(np.diff(piece.points, axis=0), axis=1).sum()
        assert chords <= piece.length + 1e-12
        assert piece.length == pytest.approx(chords, rel=1e-2)
        assert piece.is_closed or np.isin(piece.parameters[[0, -1]], (0.0, 1.0)).any(axis=1).all()
    turned = patch.transformed(np.array([[0, 0, 1.0, 5], [1, 0, 0, 0], [0, 1, 0, 0], [0, 0, 0, 1]]))
    _, again = section(turned, plane_across((axis + 1) % 3, offset + (5 if axis == 2 else 0)))
    assert sum(p.length for p in again) == pytest.approx(sum(p.length for p in pieces), rel=1e-6)


def test_a_plane_draws_what_lies_in_it():
    plane = plane_across(1, 2.0)
    assert plane.labels == ("x", "z")
    assert plane.drawn([[3, 2, 5]]).tolist() == [[3, 5]]
    plane = upright_plane([1, 1, 4], [4, 5, 0])
    assert plane.drawn([[1, 1, 7], [4, 5, 0]]) == pytest.approx(np.array([[0, 7], [5, 0]]))
    assert np.dot(plane.normal, [4, 5, 0]) == pytest.approx(plane.offset)
