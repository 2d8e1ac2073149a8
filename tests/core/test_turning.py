"""Nets the other way round: the surface is the same one, by other parameters or in a mirror."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Document, Formulation, build_patch
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.structure.turning import mirror_in_space, reverse, transpose
from support.nets import S, U, closed_net, random_net_document

SEEDS = st.integers(0, 10_000)
DIRECTIONS = st.sampled_from(list(Direction))
CLOSED = st.sampled_from([(), ("u",), ("v",), ("u", "v")])
FEW = settings(max_examples=40)


def net_of(seed, closed):
    return closed_net(seed, (3, 4), closed) if closed else random_net_document(seed, (3, 4), smooth=0.5)


def samples(document):
    patch = build_patch(document)
    return patch.samples(*(np.full(count, 9) for count in patch.windows[::-1]))


@FEW
@given(SEEDS, CLOSED)
def test_transposed_the_surface_has_u_for_v_and_twice_is_the_document(seed, closed):
    document = net_of(seed, closed)
    turned = transpose(document)
    assert turned.windows == document.windows[::-1]
    assert turned.closed == tuple(letter for letter in "uv" if {"u": "v", "v": "u"}[letter] in closed)
    np.testing.assert_allclose(samples(turned), samples(document).swapaxes(0, 1), atol=1e-11)
    assert transpose(turned) == document


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_transposing_keeps_the_formulation_and_what_it_needs(formulation):
    document = random_net_document(2, (2, 3), formulation=formulation, samples=(31, 21), smooth=0.5)
    assert transpose(document).samples == (21, 31)
    assert transpose(transpose(document)) == document


@FEW
@given(SEEDS, CLOSED, DIRECTIONS)
def test_reversed_the_surface_runs_the_other_way_and_twice_is_the_document(seed, closed, direction):
    document = net_of(seed, closed)
    turned = reverse(document, direction)
    axis = 0 if direction is Direction.ROWS else 1
    np.testing.assert_allclose(samples(turned), np.flip(samples(document), axis), atol=1e-11)
    again = reverse(turned, direction)
    assert np.array_equal(again.control_points, document.control_points)
    assert knots_of(again, direction.other) == knots_of(document, direction.other)
    np.testing.assert_allclose(knots_of(again, direction).array, knots_of(document, direction).array, atol=2e-16)
    assert (again.joints, again.samples, again.closed) == (document.joints, document.samples, document.closed)


def test_reversed_knots_are_one_less_the_other():
    document = random_net_document(2, (1, 2))
    r, s, u, t = document.row_knots.array[3, 0]
    assert reverse(document, Direction.ROWS).row_knots.array[3, 1].tolist() == [1 - t, 1 - s, 1 - u, 1 - r]
    quartic = Document(document.control_points, document.row_knots.array[..., [0, U, U, 3]])
    turned = reverse(quartic, Direction.ROWS).row_knots.array
    assert (turned[..., S] == turned[..., U]).all()


@FEW
@given(SEEDS, CLOSED, st.integers(0, 2))
def test_a_mirror_shows_the_same_surface_in_the_same_box(seed, closed, axis):
    document = net_of(seed, closed)
    mirrored = mirror_in_space(document, axis)
    expected = samples(document).copy()
    along = document.control_points[..., axis]
    expected[..., axis] = along.min() + along.max() - expected[..., axis]
    np.testing.assert_allclose(samples(mirrored), expected, atol=1e-11)
    for box in (np.min, np.max):
        sides = (box(each.control_points, axis=(0, 1)) for each in (mirrored, document))
        np.testing.assert_allclose(*sides, atol=1e-14)
    assert mirrored.formulation is Formulation.INTERPOLATING
