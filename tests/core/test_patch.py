"""The patch against finite differences, surfaces of known shape, and dense samples."""

import numpy as np
import pytest
from hypothesis import given, settings

from qovr_core import Edge, Patch
from qovr_core.geometry import bernstein
from support.documents import seeds

U = np.linspace(0, 1, 9)
V = np.linspace(0, 1, 6)


def random_patch(seed):
    rng = np.random.default_rng(seed)
    y, x = np.meshgrid(np.arange(7.0), np.arange(7.0))
    return Patch(np.stack([x, y, 0 * x], axis=-1) + rng.uniform(-0.7, 0.7, (7, 7, 3)))


def graph(height):
    """Return z = height[a, b] u^a v^b over x = 2 u - 1, y = 2 v - 1 as a patch."""
    height = np.asarray(height, dtype=float)
    monomials = np.zeros((7, 7, 3))
    monomials[0, 0, :2] = -1
    monomials[1, 0, 0] = monomials[0, 1, 1] = 2
    monomials[: height.shape[0], : height.shape[1], 2] = height
    to_bernstein = np.array(
        [[bernstein.binomials(k)[j] / bernstein.binomials(6)[j] if j <= k else 0 for j in range(7)] for k in range(7)]
    )
    return Patch(np.einsum("ka,lb,abd->kld", to_bernstein, to_bernstein, monomials))


PLANE = graph([[1, 2], [3, 0]])
CYLINDER = graph([[1.0], [-4.0], [4.0]])  # z = x^2
SADDLE = graph([[1, -2], [-2, 4]])  # z = x y


@given(seeds)
def test_points_are_the_bernstein_sum(seed):
    patch = random_patch(seed)
    expected = np.einsum("ia,jb,abd->ijd", bernstein.basis(6, U), bernstein.basis(6, V), patch.coefficients[0, 0])
    assert patch.points(U, V) == pytest.approx(expected, abs=1e-13)


@given(seeds)
@settings(max_examples=25)
def test_derivatives_are_those_of_finite_differences(seed):
    patch = random_patch(seed)
    h = 1e-5
    for order in ((1, 0), (2, 0), (1, 1)):
        lower = (order[0] - 1, order[1])
        slope = (patch.derivative(U + h, V, *lower) - patch.derivative(U - h, V, *lower)) / (2 * h)
        assert patch.derivative(U, V, *order) == pytest.approx(slope, abs=1e-4)
    slope = (patch.derivative(U, V + h, 0, 1) - patch.derivative(U, V - h, 0, 1)) / (2 * h)
    assert patch.derivative(U, V, 0, 2) == pytest.approx(slope, abs=1e-4)


@pytest.mark.parametrize("shape", [(2, 2), (3, 1500), (1200, 150), (1, 1)])
def test_large_grids_are_the_small_ones(shape):
    """Blocks and threads change nothing: every row stands where it belongs."""
    patch = random_patch(1)
    u, v = np.linspace(0, 1, shape[0]), np.linspace(0, 1, shape[1])
    points = patch.points(u, v)
    one_by_one = np.array([patch.points([value], v)[0] for value in u])
    assert points == pytest.approx(one_by_one, abs=1e-13)


def test_what_it_hands_out_is_read_only():
    patch = random_patch(2)
    arrays = [
        patch.coefficients[0, 0],
        patch.points(U, V),
        patch.normals(U, V),
        patch.curvature(U, V).mean,
        patch.edge(Edge.U0)[0],
        patch.bounding_box(),
        patch.sampled_box(np.array([8]), np.array([5])),
    ]
    assert not any(array.flags.writeable for array in arrays)


@given(seeds)
def test_normals_are_unit_and_across_both_tangents(seed):
    patch = random_patch(seed)
    normals = patch.normals(U, V)
    assert np.linalg.norm(normals, axis=-1) == pytest.approx(np.ones((9, 6)), abs=1e-12)
    for order in ((1, 0), (0, 1)):
        tangent = patch.derivative(U, V, *order)
        assert np.einsum("ijk,ijk->ij", normals, tangent) == pytest.approx(np.zeros((9, 6)), abs=1e-10)
    assert (
        np.einsum("ijk,ijk->ij", normals, np.cross(patch.derivative(U, V, 1, 0), patch.derivative(U, V, 0, 1))) > 0
    ).all()


def test_normals_point_up_over_a_plane():
    assert PLANE.normals(U, V) == pytest.approx(np.broadcast_to(np.array([-1.5, -1, 1]) / np.sqrt(4.25), (9, 6, 3)))


def test_the_normal_on_a_collapsed_edge_is_its_limit_from_inside():
    coefficients = graph([[0, 1], [1, 0], [0.5, 0]]).coefficients[0, 0].copy()
    coefficients[:, 0] = coefficients[3, 0]
    cone = Patch(coefficients)
    at_edge, beside = cone.normals(U, [0.0, 1e-7]).transpose(1, 0, 2)
    assert np.linalg.norm(at_edge, axis=-1) == pytest.approx(np.ones(9))
    assert at_edge == pytest.approx(beside, abs=1e-5)


@pytest.mark.parametrize(
    "coefficients", [np.ones((7, 7, 3)), np.zeros((7, 7, 3)), np.arange(7.0)[:, None, None] * np.ones((7, 7, 3))]
)
def test_the_normal_of_a_point_or_a_line_is_still_a_unit_vector(coefficients):
    patch = Patch(coefficients)
    assert np.array_equal(patch.normals(U, V), np.broadcast_to([0.0, 0.0, 1.0], (9, 6, 3)))
    assert np.isnan(patch.curvature(U, V).gaussian).all()


def test_a_plane_has_no_curvature():
    curvature = PLANE.curvature(U, V)
    assert curvature.gaussian == pytest.approx(np.zeros((9, 6)), abs=1e-12)
    assert curvature.mean == pytest.approx(np.zeros((9, 6)), abs=1e-12)


def test_curvature_of_a_parabolic_cylinder():
    x = (2 * U - 1)[:, None]
    curvature = CYLINDER.curvature(U, V)
    assert curvature.gaussian == pytest.approx(np.zeros((9, 6)), abs=1e-12)
    assert curvature.mean == pytest.approx(np.broadcast_to(1 / (1 + 4 * x**2) ** 1.5, (9, 6)))


def test_curvature_of_a_saddle():
    x, y = (2 * U - 1)[:, None], (2 * V - 1)[None, :]
    w = 1 + x**2 + y**2
    curvature = SADDLE.curvature(U, V)
    assert curvature.gaussian == pytest.approx(-1 / w**2)
    assert curvature.mean == pytest.approx(-x * y / w**1.5, abs=1e-12)


@given(seeds)
def test_edges_are_the_surface_on_its_border(seed):
    patch = random_patch(seed)
    for edge, (u, v) in {Edge.U0: ([0.0], V), Edge.U1: ([1.0], V), Edge.V0: (U, [0.0]), Edge.V1: (U, [1.0])}.items():
        along = V if edge in (Edge.U0, Edge.U1) else U
        curve = bernstein.basis(6, along) @ patch.edge(edge)[0]
        assert curve == pytest.approx(patch.points(u, v).reshape(-1, 3), abs=1e-13)


@given(seeds)
@settings(max_examples=40)
def test_the_exact_box_holds_every_sample_and_is_met_by_the_densest(seed):
    patch = random_patch(seed)
    box = patch.bounding_box()
    dense = patch.points(np.linspace(0, 1, 501), np.linspace(0, 1, 501)).reshape(-1, 3)
    assert (box[:, 0] <= dense.min(axis=0) + 1e-13).all()
    assert (box[:, 1] >= dense.max(axis=0) - 1e-13).all()
    # Between samples 1/500 apart a polynomial of this size hides no more than its curvature allows.
    assert box[:, 0] == pytest.approx(dense.min(axis=0), abs=1e-3)
    assert box[:, 1] == pytest.approx(dense.max(axis=0), abs=1e-3)


def test_the_exact_box_knows_an_extremum_between_samples():
    z_low = graph([[0.0, 0, 0], [-0.6, 0, 0], [1.0, 0, 0]]).bounding_box()[2]  # u^2 - 0.6 u: least at u = 0.3
    assert z_low == pytest.approx([-0.09, 0.4], abs=1e-14)
    ridge = graph(-np.outer([0.3, -1, 1], [1, 0, 0])[:, :1]).bounding_box()[2]  # greatest along a whole line
    assert ridge == pytest.approx([-0.3, -0.05], abs=1e-14)
    bump = graph(np.outer([0, 1, -1], [0, 0.9, -1.0])).bounding_box()[
        2
    ]  # u(1-u) v(0.9-v): at (0.5, 0.45), least at v = 1
    assert bump == pytest.approx([-0.025, 0.25 * 0.45**2], abs=1e-14)


def test_the_exact_box_of_a_maximum_along_a_curve():
    circle = np.zeros((5, 5))  # -((u - .5)^2 + (v - .5)^2 - .09)^2: greatest, 0, on a circle
    quadratic = {(0, 0): 0.41, (1, 0): -1, (0, 1): -1, (2, 0): 1, (0, 2): 1}
    for (a, b), p in quadratic.items():
        for (c, d), q in quadratic.items():
            circle[a + c, b + d] -= p * q
    assert graph(circle).bounding_box()[2] == pytest.approx([-(0.41**2), 0.0], abs=1e-12)


def test_an_affine_map_of_the_patch_maps_its_points():
    matrix = np.array([[1, 2, 0, 3], [0, -1, 1, 0.5], [0.3, 0, 2, -1], [0, 0, 0, 1]])
    patch = random_patch(5)
    mapped = patch.points(U, V) @ matrix[:3, :3].T + matrix[:3, 3]
    assert patch.transformed(matrix).points(U, V) == pytest.approx(mapped, abs=1e-12)


def test_refusals():
    with pytest.raises(ValueError, match=r"expected \(m, n, 7, 7, 3\)"):
        Patch(np.zeros((5, 5, 3)))
    with pytest.raises(ValueError, match="expected one dimension"):
        PLANE.points(0.5, V)
    with pytest.raises(ValueError, match="orders are -1 and 0"):
        PLANE.derivative(U, V, -1, 0)


def test_a_fine_grid_passes_over_windows_in_which_no_parameter_lies():
    lengths = np.where(np.arange(40) == 39, 1.0, 1e-6)
    coefficients = np.random.default_rng(1).random((1, 40, 7, 7, 3))
    patch = Patch(coefficients, (6, 6), (lengths, np.ones(1)))
    u, v = np.linspace(*patch.domain[0], 60), np.linspace(0, 1, 3000)
    np.testing.assert_allclose(patch.points(u, v)[-1], patch.window(0, 39).points([1.0], v)[0], atol=1e-13)
