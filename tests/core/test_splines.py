"""The classical surfaces against closed forms, Splipy, finite differences, and what must not change."""

import numpy as np
import pytest
import splipy
from hypothesis import given, settings

from qovr_core.geometry import bernstein
from qovr_core.laboratory.splines import TensorSurface, b_spline, bezier, catmull_rom, nurbs
from support.documents import random_net, seeds
from support.surfaces import principal_curvatures

U = np.linspace(0, 1, 9)
V = np.linspace(0, 1, 6)
BESIDE_U = np.array([0.03, 0.2, 0.45, 0.6, 0.97])  # no joint within a step of a finite difference
BESIDE_V = np.array([0.1, 0.3, 0.7])
RANDOM_WEIGHTS = np.random.default_rng(0).uniform(0.2, 5, (5, 5))
SURFACES = {
    "bezier": bezier,
    "b-spline": b_spline,
    "nurbs": lambda net: nurbs(net, RANDOM_WEIGHTS),
    "catmull-rom": catmull_rom,
}
every_surface = pytest.mark.parametrize("make", SURFACES.values(), ids=SURFACES)


def splipy_surface(net, weights=None):
    basis = splipy.BSplineBasis(4, [0, 0, 0, 0, 0.5, 1, 1, 1, 1])
    points = net.transpose(1, 0, 2)  # theirs are indexed [u, v]
    if weights is not None:
        w = weights.T[..., None]
        points = np.concatenate([w * points, w], axis=2)
    return splipy.Surface(basis, basis, points, rational=weights is not None, raw=True)


@given(seeds)
@settings(max_examples=20, deadline=None)
def test_bezier_is_the_bernstein_sum(seed):
    net = random_net(seed)
    expected = np.einsum("uj,vi,ijd->uvd", bernstein.basis(4, U), bernstein.basis(4, V), net)
    assert bezier(net).points(U, V) == pytest.approx(expected, abs=1e-13)


@given(seeds)
@settings(max_examples=20, deadline=None)
def test_catmull_rom_is_the_cubic_of_its_matrix(seed):
    """Between P_1 and P_2 the curve is 1/2 [1 t t^2 t^3] M [P_0 P_1 P_2 P_3], and so on each way."""
    net = random_net(seed)
    matrix = 0.5 * np.array([[0, 2, 0, 0], [-1, 0, 1, 0], [2, -5, 4, -1], [-1, 3, -3, 1]])
    t = np.linspace(0, 1, 7)
    cubic = np.vander(t, 4, increasing=True) @ matrix
    for column in (0, 1):
        for row in (0, 1):
            window = net[row : row + 4, column : column + 4]
            expected = np.einsum("uj,vi,ijd->uvd", cubic, cubic, window)
            points = catmull_rom(net).points((column + t) / 2, (row + t) / 2)
            assert points == pytest.approx(expected, abs=1e-13)


@given(seeds)
@settings(max_examples=20, deadline=None)
def test_catmull_rom_runs_through_the_inner_nine_points(seed):
    net = random_net(seed)
    assert catmull_rom(net).points([0, 0.5, 1], [0, 0.5, 1]) == pytest.approx(
        net[1:4, 1:4].transpose(1, 0, 2), abs=1e-13
    )


@pytest.mark.parametrize("rational", [False, True])
def test_b_spline_and_nurbs_are_those_of_splipy(rational):
    net = random_net(11)
    weights = RANDOM_WEIGHTS if rational else None
    ours = nurbs(net, weights) if rational else b_spline(net)
    theirs = splipy_surface(net, weights)
    assert ours.points(U, V) == pytest.approx(theirs(U, V), abs=1e-13)
    for order in ((1, 0), (0, 1), (2, 0), (1, 1), (0, 2)):
        expected = theirs.derivative(BESIDE_U, BESIDE_V, d=order)
        assert ours.derivative(BESIDE_U, BESIDE_V, *order) == pytest.approx(expected, abs=1e-10)


def test_b_spline_weights_by_hand():
    """Over 0 0 0 0 1/2 1 1 1 1 the five functions are 0, 1/4, 1/2, 1/4, 0 in the middle."""
    net = random_net(3)
    in_the_middle = np.array([0, 0.25, 0.5, 0.25, 0])
    assert b_spline(net).points([0.5], [0.5])[0, 0] == pytest.approx(
        np.einsum("i,j,ijd->d", in_the_middle, in_the_middle, net), abs=1e-14
    )
    assert b_spline(net).points([0, 1], [0, 1]) == pytest.approx(net[::4, ::4].transpose(1, 0, 2), abs=1e-14)


def test_nurbs_by_hand():
    """With the weight w of P_22 the middle is (sum of the others + w P_22 / 4) / (1 + (w - 1) / 4)."""
    net = random_net(5)
    weights = np.ones((5, 5))
    weights[2, 2] = 9.0
    plain = b_spline(net).points([0.5], [0.5])[0, 0]
    assert nurbs(net, weights).points([0.5], [0.5])[0, 0] == pytest.approx((plain + 2 * net[2, 2]) / 3, abs=1e-14)


def test_nurbs_of_equal_weights_is_the_b_spline():
    net = random_net(6)
    for order in ((0, 0), (1, 0), (1, 1), (2, 2), (3, 0)):
        expected = b_spline(net).derivative(U, V, *order)
        assert nurbs(net, np.full((5, 5), 3.0)).derivative(U, V, *order) == pytest.approx(expected, abs=1e-11)


@every_surface
def test_u_runs_along_the_rows(make):
    y, x = np.mgrid[:5, :5].astype(float)
    surface = make(np.stack([x, 10 * y, 0 * x], axis=-1))
    along_u, along_v = surface.derivative([0.3], [0.6], 1, 0)[0, 0], surface.derivative([0.3], [0.6], 0, 1)[0, 0]
    assert along_u[0] > 0.1
    assert along_v[1] > 1
    if make is not SURFACES["nurbs"]:
        assert along_u[1] == pytest.approx(0, abs=1e-12)


@every_surface
def test_the_basis_is_a_partition_of_unity(make):
    surface = make(np.ones((5, 5, 3)))
    assert surface.points(U, V) == pytest.approx(np.ones((9, 6, 3)), abs=1e-14)
    assert surface.derivative(U, V, 1, 0) == pytest.approx(np.zeros((9, 6, 3)), abs=1e-13)


@every_surface
def test_an_affine_map_of_the_net_maps_the_surface(make):
    matrix = np.array([[1, 2, 0, 3], [0, -1, 1, 0.5], [0.3, 0, 2, -1], [0, 0, 0, 1]])
    net = random_net(7)
    mapped = make(net).points(U, V) @ matrix[:3, :3].T + matrix[:3, 3]
    assert make(net).transformed(matrix).points(U, V) == pytest.approx(mapped, abs=1e-12)
    assert make(net @ matrix[:3, :3].T + matrix[:3, 3]).points(U, V) == pytest.approx(mapped, abs=1e-12)


@every_surface
def test_derivatives_are_those_of_finite_differences(make):
    surface = make(random_net(8))
    h = 1e-5
    for order in ((1, 0), (2, 0), (1, 1), (2, 1)):
        lower = (order[0] - 1, order[1])
        slope = surface.derivative(BESIDE_U + h, BESIDE_V, *lower) - surface.derivative(BESIDE_U - h, BESIDE_V, *lower)
        assert surface.derivative(BESIDE_U, BESIDE_V, *order) == pytest.approx(slope / (2 * h), rel=1e-6, abs=1e-6)
    for order in ((0, 1), (0, 2), (1, 2)):
        lower = (order[0], order[1] - 1)
        slope = surface.derivative(BESIDE_U, BESIDE_V + h, *lower) - surface.derivative(BESIDE_U, BESIDE_V - h, *lower)
        assert surface.derivative(BESIDE_U, BESIDE_V, *order) == pytest.approx(slope / (2 * h), rel=1e-6, abs=1e-6)


@every_surface
def test_scattered_parameters_are_those_of_the_grid(make):
    surface = make(random_net(9))
    u, v = np.meshgrid(U, V, indexing="ij")
    for order in ((0, 0), (1, 0), (1, 1), (0, 2)):
        scattered = surface.derivative_at(u.ravel(), v.ravel(), *order).reshape(9, 6, 3)
        assert scattered == pytest.approx(surface.derivative(U, V, *order), abs=1e-12)
    assert surface.derivative_at([], [], 1, 0).shape == (0, 3)


@every_surface
def test_curvature_is_that_of_the_shape_operator(make):
    surface = make(random_net(10))
    smallest, largest = principal_curvatures(surface, BESIDE_U, BESIDE_V)
    curvature = surface.curvature(BESIDE_U, BESIDE_V)
    assert curvature.gaussian == pytest.approx(smallest * largest, rel=1e-5, abs=1e-6)
    assert curvature.mean == pytest.approx((smallest + largest) / 2, rel=1e-5, abs=1e-6)


@every_surface
def test_normals_are_unit_and_across_both_tangents(make):
    surface = make(random_net(12))
    normals = surface.normals(U, V)
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(np.ones((9, 6)), abs=1e-12)
    for order in ((1, 0), (0, 1)):
        assert np.einsum("ijk,ijk->ij", normals, surface.derivative(U, V, *order)) == pytest.approx(
            np.zeros((9, 6)), abs=1e-11
        )


@every_surface
def test_a_net_in_one_point_has_no_curvature_and_a_normal_all_the_same(make):
    surface = make(np.ones((5, 5, 3)))
    assert np.isnan(surface.curvature(U, V).mean).all()
    assert np.array_equal(surface.normals(U, V), np.broadcast_to([0.0, 0.0, 1.0], (9, 6, 3)))


@pytest.mark.parametrize(("name", "smooth"), [("b-spline", 2), ("nurbs", 2), ("catmull-rom", 1)])
def test_joints_are_as_smooth_as_they_should_be_and_no_smoother(name, smooth):
    surface = SURFACES[name](random_net(13))
    assert [list(breaks) for breaks in surface.breaks] == [[0.5], [0.5]]
    for order in range(smooth + 2):
        before, after = surface.derivative(np.array([np.nextafter(0.5, 0), 0.5]), V, order, 0)
        jump = np.abs(after - before).max()
        assert jump < 1e-10 if order <= smooth else jump > 1e-2


def test_bezier_has_no_joints():
    assert [breaks.size for breaks in bezier(random_net(0)).breaks] == [0, 0]


@every_surface
def test_what_it_hands_out_is_read_only(make):
    net = random_net(14)
    surface = make(net)
    arrays = [surface.net, surface.points(U, V), surface.normals(U, V), surface.derivative_at(V, V, 1, 0)]
    assert not any(array.flags.writeable for array in arrays)
    net[0, 0] = 100  # is the caller's, not the surface's
    assert surface.net[0, 0, 0] != 100


@pytest.mark.parametrize(("rows", "columns"), [(5, 7), (7, 5), (7, 9)])
def test_a_net_need_not_be_square(rows, columns):
    """Points on a plane give that plane, run through without turning back; Catmull-Rom has the second corners."""
    y, x = np.mgrid[:rows, :columns].astype(float)
    net = np.stack([x, y, 0.5 * x - y], axis=-1)
    for make in (bezier, b_spline, catmull_rom, lambda net: nurbs(net, np.ones((rows, columns)))):
        points = make(net).points(U, V)
        assert points[..., 2] == pytest.approx(0.5 * points[..., 0] - points[..., 1], abs=1e-13)
        assert (np.diff(points[..., 0], axis=0) > 0).all()
        assert (np.diff(points[..., 1], axis=1) > 0).all()
    corners = catmull_rom(net).points([0.0, 1.0], [0.0, 1.0])
    expected = [[[1, 1], [1, rows - 2]], [[columns - 2, 1], [columns - 2, rows - 2]]]
    assert corners[..., :2] == pytest.approx(np.array(expected), abs=1e-13)


def test_refusals():
    net = random_net(15)
    for bad in (np.zeros((5, 5)), np.zeros((4, 5))):
        with pytest.raises(ValueError, match="expected"):
            nurbs(net, bad)
    for value in (0.0, -1.0, np.nan, np.inf):
        weights = np.ones((5, 5))
        weights[1, 3] = value
        with pytest.raises(ValueError, match="expected positive weights"):
            nurbs(net, weights)
    with pytest.raises(ValueError, match=r"expected \(5, 5, 3\)"):
        TensorSurface(np.zeros((4, 4, 3)), bezier(net).basis_u, bezier(net).basis_v)
    with pytest.raises(ValueError, match="expected one dimension"):
        bezier(net).points(0.5, V)
    with pytest.raises(ValueError, match="expected 0 or more"):
        bezier(net).derivative(U, V, -1, 0)
