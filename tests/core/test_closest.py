"""The closest point against closed forms, dense samples, and surfaces that are special."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from qovr_core import FORMULATIONS, Document, Evaluation, Layer, Patch, build_patch
from qovr_core.geometry.closest import closest_points
from support.documents import random_document, random_net, size
from support.shapes import CLOSED, COLLAPSED, special
from support.surfaces import SphericalPatch


def box_patch(width, depth):
    """Return the rectangle [0, width] x [0, depth] in the plane z = 0."""
    x, y = np.meshgrid(np.linspace(0, width, 7), np.linspace(0, depth, 7), indexing="ij")
    return Patch(np.stack([x, y, 0 * x], axis=-1))


def test_a_rectangle_inside_beyond_its_border_and_beyond_its_corners():
    rng = np.random.default_rng(1)
    points = rng.uniform([-3, -3, -2], [7, 5, 2], (2000, 3))
    closest = closest_points(box_patch(4, 2), points)
    feet = np.clip(points, [0, 0, 0], [4, 2, 0])
    assert closest.points == pytest.approx(feet, abs=1e-13)
    assert closest.distance == pytest.approx(np.linalg.norm(points - feet, axis=1), abs=1e-13)
    assert closest.u == pytest.approx(feet[:, 0] / 4, abs=1e-13)
    assert closest.v == pytest.approx(feet[:, 1] / 2, abs=1e-13)


def test_a_sphere_from_outside_and_from_inside():
    sphere = SphericalPatch(radius=3.0)
    u, v = np.random.default_rng(2).uniform(0.02, 0.98, (2, 1000))
    points = sphere.derivative_at(u, v, 0, 0) * np.random.default_rng(3).uniform(0.2, 3, 1000)[:, None]
    closest = closest_points(sphere, points)
    assert closest.distance == pytest.approx(np.abs(np.linalg.norm(points, axis=1) - 3), abs=1e-12)
    assert closest.u == pytest.approx(u, abs=1e-11)
    assert closest.v == pytest.approx(v, abs=1e-11)


def test_the_centre_of_a_sphere_is_as_far_from_every_point_of_it():
    assert closest_points(SphericalPatch(), np.zeros((1, 3))).distance == pytest.approx([1.0], abs=1e-13)


def test_points_beyond_the_border_of_a_sphere_come_to_its_border():
    sphere = SphericalPatch(longitude=np.pi / 2, latitude=np.pi / 3)
    below = np.array([[2.0, 2.0, -1.0]])  # nearest to the equator, at 45 degrees
    closest = closest_points(sphere, below)
    assert (closest.u[0], closest.v[0]) == pytest.approx((0.5, 0.0), abs=1e-12)
    assert closest.distance[0] == pytest.approx(np.hypot(np.sqrt(8) - 1, 1), abs=1e-13)


def patches(low):
    """Yield surfaces of all formulations; the further from 0.5 the knots, the more they fold."""
    for seed in range(12):
        document = random_document(seed, list(FORMULATIONS.values())[seed % 3], low=low, high=1 - low)
        yield seed, Evaluation(document).layer_patch(Layer.TRANSFORMED)


def test_points_of_the_surface_are_their_own_feet():
    for seed, patch in patches(0.35):
        u, v = np.random.default_rng(seed).random((2, 300))
        points = patch.derivative_at(u, v, 0, 0)
        assert closest_points(patch, points).distance.max() <= 1e-12 * size(points)


def test_no_sample_is_nearer_than_the_foot():
    grid = np.linspace(0, 1, 201)
    for seed, patch in patches(0.35):
        samples = patch.points(grid, grid).reshape(-1, 3)
        points = np.random.default_rng(seed).uniform(samples.min(axis=0) - 1, samples.max(axis=0) + 1, (100, 3))
        closest = closest_points(patch, points)
        nearest = np.array([np.linalg.norm(samples - point, axis=1).min() for point in points])
        assert (closest.distance <= nearest + 1e-12 * size(samples)).all()
        assert np.linalg.norm(closest.points - points, axis=1) == pytest.approx(closest.distance, abs=1e-13)
        assert closest.points == pytest.approx(patch.derivative_at(closest.u, closest.v, 0, 0), abs=1e-13)


def test_a_surface_folded_ten_times_over_still_gives_almost_every_foot():
    for seed, patch in patches(0.05):
        u, v = np.random.default_rng(seed).random((2, 300))
        points = patch.derivative_at(u, v, 0, 0)
        missed = closest_points(patch, points).distance > 1e-12 * size(points)
        assert missed.mean() <= 0.1


@pytest.mark.parametrize("name", [*COLLAPSED, *CLOSED])
def test_surfaces_with_collapsed_and_closed_edges(name):
    patch = Evaluation(special(name)).patch
    grid = np.linspace(0, 1, 201)
    samples = patch.points(grid, grid).reshape(-1, 3)
    points = np.random.default_rng(4).uniform(-1, 5, (50, 3))
    nearest = np.array([np.linalg.norm(samples - point, axis=1).min() for point in points])
    assert (closest_points(patch, points).distance <= nearest + 1e-12).all()


def test_a_point_and_a_line_are_surfaces_too():
    points = np.array([[0.0, 0, 0], [3, 4, 0], [-2, 0, 1]])
    at_origin = closest_points(Patch(np.zeros((7, 7, 3))), points)
    assert at_origin.distance == pytest.approx([0, 5, np.sqrt(5)], abs=1e-13)
    line = Patch(np.linspace(0, 1, 7)[:, None, None] * np.array([1.0, 0, 0]) * np.ones((1, 7, 1)))
    assert closest_points(line, points).distance == pytest.approx([0, np.sqrt(20), np.sqrt(5)], abs=1e-13)


@pytest.mark.parametrize("scale", [1e-250, 1e-6, 1e6, 1e250])
def test_size_changes_nothing(scale):
    document = random_document(7)
    patch = Evaluation(document).patch
    points = np.random.default_rng(8).uniform(0, 4, (100, 3))
    larger = patch.transformed(np.diag([scale, scale, scale, 1]))
    assert closest_points(larger, scale * points).distance == pytest.approx(
        scale * closest_points(patch, points).distance, rel=1e-9, abs=1e-12 * scale
    )


def test_what_it_hands_out_is_read_only():
    closest = closest_points(box_patch(1, 1), np.zeros((2, 3)))
    assert not any(array.flags.writeable for array in vars(closest).values())


@pytest.mark.parametrize("shape", [(3,), (2, 2), (1, 1, 3)])
def test_points_of_another_shape_are_refused(shape):
    with pytest.raises(ValueError, match=r"expected \(k, 3\)"):
        closest_points(box_patch(1, 1), np.zeros(shape))


def test_no_points_have_no_feet():
    assert closest_points(box_patch(1, 1), np.zeros((0, 3))).distance.shape == (0,)


def folded_back(kind):
    """Return a net on which a tangent vanishes: along one edge, or along two and in the middle."""
    if kind == "edge":
        net = random_net(0)
        net[:, 0] = net[:, 2]
        return net
    if kind == "zigzag":
        return random_net(1)[:, [0, 1, 0, 1, 0]]
    i, j = np.mgrid[:5, :5].astype(float)
    side = np.where(j % 2, 1.0, -1.0)
    return np.stack([side * (1 + 0.3 * i), side / 2, i], axis=-1)


@pytest.mark.parametrize("kind", ["edge", "zigzag", "ruled"])
@pytest.mark.parametrize("reach", [1e-3, 1e-2, 0.1])
def test_no_point_of_a_dense_grid_is_nearer_where_a_tangent_vanishes(kind, reach):
    patch = build_patch(Document(folded_back(kind), formulation="interpolating"))
    rng = np.random.default_rng(7)
    on_surface = patch.points(np.concatenate([[0.0, 0.5, 1.0], rng.random(27)]), rng.random(30)).reshape(-1, 3)
    targets = on_surface + reach * rng.normal(size=on_surface.shape)
    dense = np.linspace(0, 1, 801)
    nearest, _ = cKDTree(patch.points(dense, dense).reshape(-1, 3)).query(targets)
    assert (closest_points(patch, targets).distance <= nearest + 1e-9).all()
