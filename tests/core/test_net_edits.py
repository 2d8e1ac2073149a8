"""Edits of selected points against what each is by definition, on nets of any size."""

import numpy as np
import pytest

from qovr_core import QovrError
from qovr_core.net_edits import About, Align, Flatten, Plane, Smooth, Transform

RNG = np.random.default_rng(7)


def net(rows=7, columns=9):
    y, x = np.mgrid[:rows, :columns].astype(float)
    return np.stack([x, y, RNG.uniform(-1, 1, x.shape)], axis=-1)


SOME = np.array([(2, 3), (1, 1), (5, 8), (0, 0), (3, 3)])


def at(points, indices):
    return points[indices[:, 0], indices[:, 1]]


def test_a_move_is_exact():
    points = net()
    moved = Transform((0.0, 0.0, 0.1)).of(points, SOME)
    np.testing.assert_array_equal(moved, at(points, SOME) + np.array([0, 0, 0.1]))


@pytest.mark.parametrize("about", About)
def test_scaling_leaves_what_it_is_about(about):
    points = net()
    before = at(points, SOME)
    after = Transform(factors=(2.0, 1.0, 0.5), about=about).of(points, SOME)
    centre = before[0] if about is About.LAST else before.mean(axis=0)
    np.testing.assert_allclose(after - centre, (before - centre) * [2, 1, 0.5], atol=1e-14)


@pytest.mark.parametrize("axis", range(3))
def test_turning_goes_counterclockwise(axis):
    points = np.zeros((5, 5, 3))
    points[0, 1, (axis + 1) % 3] = 1
    turned = Transform(axis=axis, degrees=90, about=About.LAST).of(points, np.array([(0, 0), (0, 1)]))
    np.testing.assert_allclose(turned[1], np.eye(3)[(axis + 2) % 3], atol=1e-15)


def test_flat_is_one_height_or_the_nearest_plane():
    points = net()
    flat = Flatten(Plane.HEIGHT).of(points, SOME)
    np.testing.assert_allclose(flat[:, 2], at(points, SOME)[:, 2].mean())
    np.testing.assert_array_equal(flat[:, :2], at(points, SOME)[:, :2])
    best = Flatten(Plane.BEST).of(points, SOME)
    assert np.linalg.svd(best - best.mean(axis=0))[1][2] < 1e-14
    tilted = points.copy()
    tilted[..., 2] = 0.3 * tilted[..., 0] - 0.2 * tilted[..., 1] + 1
    np.testing.assert_allclose(Flatten(Plane.BEST).of(tilted, SOME), at(tilted, SOME), atol=1e-14)


@pytest.mark.parametrize("axis", range(3))
def test_aligned_points_have_the_last_ones_coordinate(axis):
    points = net()
    aligned = Align(axis).of(points, SOME)
    assert set(aligned[:, axis]) == {points[2, 3, axis]}
    rest = [k for k in range(3) if k != axis]
    np.testing.assert_array_equal(aligned[:, rest], at(points, SOME)[:, rest])


def everything(shape):
    return np.argwhere(np.ones(shape, dtype=bool))


@pytest.mark.parametrize("shape", [(5, 5), (7, 9)])
def test_smoothing_leaves_what_is_even_and_the_corners(shape):
    points = net(*shape)
    even = points.copy()
    even[..., 2] = 2 * even[..., 0] + even[..., 1] - 1
    np.testing.assert_allclose(Smooth().of(even, everything(shape)).reshape(even.shape), even, atol=1e-14)
    smooth = Smooth().of(points, everything(shape)).reshape(points.shape)
    np.testing.assert_array_equal(smooth[:: shape[0] - 1, :: shape[1] - 1], points[:: shape[0] - 1, :: shape[1] - 1])
    np.testing.assert_allclose(smooth[0, 1], (points[0, 1] + (points[0, 0] + points[0, 2]) / 2) / 2)
    around = (points[1, 2] + points[3, 2] + points[2, 1] + points[2, 3]) / 4
    np.testing.assert_allclose(smooth[2, 2], (points[2, 2] + around) / 2)


@pytest.mark.parametrize(("edit", "fewest"), [(Flatten(Plane.HEIGHT), 2), (Flatten(Plane.BEST), 4), (Align(0), 2)])
def test_too_few_points_are_refused(edit, fewest):
    with pytest.raises(QovrError, match=f"takes {fewest} points or more"):
        edit.of(net(), SOME[: fewest - 1])
