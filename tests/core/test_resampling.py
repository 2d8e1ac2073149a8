"""Nets through other surfaces: where they meet them, with which tangents, and how fast the rest comes near."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Document, QovrError, build_patch
from qovr_core.joints import Joint
from qovr_core.laboratory.splines import b_spline, bezier
from qovr_core.structure.resampling import resample
from support.nets import closed_net, node_net, random_net_document


def random_surface(seed, size=(6, 7)):
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[: size[0], : size[1]].astype(float)
    return bezier(np.stack([x, y, 0 * x], axis=-1) + rng.uniform(-0.5, 0.5, (*size, 3)))


@settings(max_examples=30)
@given(st.integers(0, 10_000), st.integers(1, 4), st.integers(1, 4), st.booleans())
def test_it_runs_through_the_surface_with_its_tangents_at_the_edges(seed, m, n, is_even):
    surface, rng = random_surface(seed), np.random.default_rng(seed)
    u, v = (np.linspace(0, 1, 2 * count + 1) for count in (n, m))
    if not is_even:
        u, v = (np.concatenate([[0], np.cumsum(d) / d.sum()]) for d in (rng.uniform(0.3, 1, 2 * k) for k in (n, m)))
        u[-1] = v[-1] = 1
    change = resample(surface, (m, n), None if is_even else (u, v))
    document, patch = change.document, build_patch(change.document)
    np.testing.assert_allclose(document.control_points[1:-1, 1:-1].swapaxes(0, 1), surface.points(u, v), atol=1e-12)
    assert set(document.joints.u + document.joints.v) <= {Joint.SMOOTH}
    assert len(np.unique(document.row_knots.array)) == 1 or not is_even
    lengths = u[2] - u[0], v[2] - v[0]
    at_u, at_v = (np.interp(each, each[::2], breaks) for each, breaks in zip((u, v), patch.breakpoints, strict=True))
    for order, ends in (
        ((1, 0), (at_u[[0, -1]], at_v)),
        ((0, 1), (at_u, at_v[[0, -1]])),
        ((1, 1), (at_u[[0, -1]], at_v[[0, -1]])),
    ):
        own = patch.derivative(*ends, *order)
        places = [each[[0, -1]] if len(end) == 2 else each for each, end in zip((u, v), ends, strict=True)]
        scale = lengths[0] ** order[0] * lengths[1] ** order[1]
        np.testing.assert_allclose(own, scale * surface.derivative(*places, *order), atol=1e-10)
    fine = np.linspace(0, 1, 41)
    own = patch.points(
        *(np.interp(fine, each[::2], breaks) for each, breaks in zip((u, v), patch.breakpoints, strict=True))
    )
    assert np.linalg.norm(own - surface.points(fine, fine), axis=-1).max() <= 1.05 * change.motion + 1e-12


def test_the_error_is_of_order_three():
    surface = random_surface(3, (4, 5))
    errors = [resample(surface, (count, count)).motion for count in (8, 16, 32, 64)]
    orders = np.log2(np.divide(errors[:-1], errors[1:]))
    assert (orders > 2.7).all()
    assert orders[-1] == pytest.approx(3, abs=0.1)


@settings(max_examples=30)
@given(st.integers(0, 10_000))
def test_what_is_quadratic_comes_out_exactly(seed):
    surface = random_surface(seed, (3, 3))
    assert resample(surface, (2, 3)).motion < 1e-12
    assert resample(surface, (1, 2), ([0, 0.1, 0.5, 0.7, 1], [0, 0.7, 1])).motion < 1e-12


@settings(max_examples=30)
@given(st.integers(0, 10_000))
def test_a_net_by_its_own_nodes_is_itself(seed):
    document = node_net(seed, (2, 3))
    patch = build_patch(document)
    nodes = []
    for knots, breaks in zip((document.row_knots, document.column_knots), patch.breakpoints, strict=True):
        middles = breaks[:-1] + knots.array[0, :, 2] * np.diff(breaks)
        nodes.append(np.sort(np.concatenate([breaks, middles])))
    change = resample(patch, document.windows, tuple(nodes))
    assert change.motion < 1e-12 * document.net_size
    np.testing.assert_allclose(
        change.document.control_points[1:-1, 1:-1], document.control_points[1:-1, 1:-1], atol=1e-12
    )


@pytest.mark.parametrize("closed", [("u",), ("v",), ("u", "v")])
def test_a_closed_surface_gives_a_closed_net(closed):
    document = closed_net(5, (3, 4), closed)
    spaced = Document(document.control_points, formulation="interpolating", closed=closed)
    change = resample(build_patch(spaced), (6, 8), closed=closed, samples=(5, 5))
    assert change.document.closed == closed
    assert set(change.document.joints.u + change.document.joints.v) == {Joint.SMOOTH}
    assert change.document.samples == (9, 7)
    again = resample(build_patch(spaced), (3, 4), closed=closed).document
    size = spaced.net_size
    np.testing.assert_allclose(again.control_points, spaced.control_points, atol=1e-12 * size)


def test_any_surface_will_do():
    net = random_net_document(1, (1, 1)).control_points
    for surface in (b_spline(net), build_patch(random_net_document(2, (2, 3), smooth=0.0))):
        coarse, fine = (resample(surface, (count, count)).motion for count in (2, 24))
        assert fine < coarse


@pytest.mark.parametrize(
    ("windows", "closed", "text"),
    [
        ((0, 1), (), "0 windows along v are no net; expected 1 to 100 of them"),
        ((1, 101), (), "101 windows along u are no net; expected 1 to 100 of them"),
        ((3, 1), ("u",), "1 windows along u are no net that closes; expected 2 to 100 of them"),
    ],
)
def test_what_is_no_net_is_refused(windows, closed, text):
    with pytest.raises(QovrError) as refused:
        resample(random_surface(1), windows, closed=closed)
    assert str(refused.value) == text
