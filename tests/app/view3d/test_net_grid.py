"""Nets of windows as vertices: every window's own, as many as its size asks for, rewritten where it is touched."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_app.state.display import Scaling, Style
from qovr_app.view3d.scene import scene as scenes
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.companions import Companions
from qovr_app.view3d.scene.display_grid import display_grid, facet_grid, sample_grid
from qovr_app.view3d.scene.grid import Grid, cell_corners, cell_starts, parameters, shared_grid, spread, window_starts
from qovr_app.view3d.scene.mesh import revised_vertices, surface_vertices, triangle_indices
from qovr_app.view3d.scene.occlusion import Occluder
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.scene import make_scene, scene_frame
from qovr_core import Evaluation, Formulation
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.edits import Direction, KnotPlace, set_point, set_values
from qovr_core.fields import FIELDS, field_values
from qovr_core.layer import Layer
from support.nets import closed_net, random_net_document

GRID = Grid((3, 5, 2), (4, 1))
"""Over 2 x 3 windows."""


def scene_of(document, layer=Layer.RAW, base=None, scaling=Scaling.EACH, **companions):
    result = Evaluation(document, base)
    return make_scene(result, layer, scene_frame(result, layer, scaling), Companions(**companions))


def waves(windows):
    """Return a net of heights over even places, some of whose joints are sharp."""
    document = random_net_document(8, windows, smooth=0.5, margin=0.4, samples=(201, 201))
    y, x = np.mgrid[: 2 * windows[0] + 3, : 2 * windows[1] + 3]
    heights = np.sin(9 * x / x.max()) * np.cos(7 * y / y.max())
    return replace(document, control_points=np.stack([x, y, heights], axis=-1))


def block(values, grid, a, b):
    """Return what stands at the vertices of window (a, b)."""
    u, v = window_starts(grid.u), window_starts(grid.v)
    return values[u[b] : u[b + 1], v[a] : v[a + 1]]


def unit(vector):
    return vector / np.linalg.norm(vector)


def locals_of(grid, a, b):
    return np.linspace(0, 1, grid.u[b] + 1), np.linspace(0, 1, grid.v[a] + 1)


@pytest.mark.parametrize("formulation", [Formulation.INTERPOLATING, Formulation.PUBLISHED])
def test_every_window_has_the_vertices_of_its_own_patch(formulation):
    scene = scene_of(random_net_document(1, (2, 3), formulation=formulation, smooth=0.5))
    vertices = surface_vertices(scene.patch, GRID)
    assert vertices.shape == (*GRID.shape, 6)
    for a, b in np.ndindex(2, 3):
        found, (u, v) = block(vertices, GRID, a, b), locals_of(GRID, a, b)
        patch = scene.patch.window(a, b)
        np.testing.assert_allclose(found[..., :3], patch.points(u, v), atol=2e-6)
        normals = found[..., 3:] / np.linalg.norm(found[..., 3:], axis=-1, keepdims=True)
        np.testing.assert_allclose(normals, patch.normals(u, v), atol=1e-4)


def test_a_crease_has_two_normals_and_one_line_of_points():
    scene = scene_of(random_net_document(2, (1, 2), smooth=0.0))
    grid = Grid((4, 4), (6,))
    vertices = surface_vertices(scene.patch, grid)
    left, right = vertices[4], vertices[5]
    np.testing.assert_allclose(left[:, :3], right[:, :3], atol=1e-6)
    unit = [side[:, 3:] / np.linalg.norm(side[:, 3:], axis=1, keepdims=True) for side in (left, right)]
    assert np.einsum("ij,ij->i", *unit).min() < 0.999


def test_no_triangle_lies_between_two_windows():
    triangles = triangle_indices(GRID).reshape(-1, 3).astype(int)
    assert len(triangles) == 2 * np.prod(GRID.cells)
    for axis, cells in enumerate((GRID.u, GRID.v)):
        at = np.stack(np.divmod(triangles, GRID.shape[1]))[axis]
        window = np.searchsorted(window_starts(cells), at, side="right")
        assert (window == window[:, :1]).all()
    assert len(cell_corners(np.zeros(GRID.shape), GRID)[0].ravel()) == np.prod(GRID.cells)
    assert cell_starts((2, 1)).tolist() == [0, 1, 3]


def test_parameters_stay_in_their_window():
    """Asked at a window's end, the surface answers with the window's own second derivatives."""
    patch = scene_of(random_net_document(3, (2, 3))).patch
    u, v = parameters(patch, GRID)
    second = patch.derivative(u, v, 2, 0)
    for a, b in np.ndindex(2, 3):
        expected = patch.window(a, b).derivative(*locals_of(GRID, a, b), 2, 0) / patch.lengths[0][b] ** 2
        np.testing.assert_allclose(block(second, GRID, a, b), expected, atol=1e-8 * np.abs(expected).max())
    assert u[-1] == patch.domain[0][1]


@pytest.mark.parametrize("index", [(4, 4), (3, 4), (3, 3), (0, 0)])
def test_what_is_revised_is_what_is_made_anew(index):
    document = random_net_document(4, (5, 6))
    before = scene_of(document)
    moved = set_point(document, *index, document.control_points[index] + [0.1, 0.0, 0.3])
    result = Evaluation(moved, before.evaluation)
    after = make_scene(result, Layer.RAW, before.frame)
    grid = Grid((2, 3, 1, 4, 2, 2), (1, 2, 3, 1, 2))
    vertices = surface_vertices(before.patch, grid)
    revised, rows = revised_vertices(vertices, before.patch, after.patch, grid)
    whole = surface_vertices(after.patch, grid)
    np.testing.assert_array_equal(revised, whole)
    assert not revised.flags.writeable
    changed = np.flatnonzero((whole != vertices).any(axis=(1, 2)))
    assert rows.start <= changed.min()
    assert changed.max() < rows.stop
    assert rows.stop - rows.start < len(vertices) / 2 + 3
    assert revised_vertices(vertices, before.patch, before.patch, grid)[0] is vertices


def test_other_windows_are_made_anew_as_a_whole():
    few, many = (scene_of(random_net_document(4, windows)) for windows in ((1, 2), (2, 2)))
    grid = Grid((2, 2), (2, 2))
    found, rows = revised_vertices(np.zeros((6, 3, 6), np.float32), few.patch, many.patch, grid)
    np.testing.assert_array_equal(found, surface_vertices(many.patch, grid))
    assert (rows.start, rows.stop) == (0, 6)


def longest_chord(scene, grid, size):
    """Return the longest side of a cell in pixels, in a view that the whole is fitted into."""
    picture = Picture(settings=None, camera=Camera(*NAMED_VIEWS["paper"]), scene=scene)
    seen = picture.camera.project(surface_vertices(scene.patch, grid)[..., :3].astype(float), size)[..., :2]
    a, b, c, d = cell_corners(seen, grid)
    return max(np.hypot(*(end - start).transpose(2, 0, 1)).max() for start, end in ((a, b), (b, c), (c, d), (d, a)))


@pytest.mark.parametrize("windows", [(1, 2), (2, 3), (7, 4), (40, 40)])
def test_windows_have_as_many_cells_as_they_are_long(windows):
    scene = scene_of(waves(windows))
    resting = display_grid(scene.patch, (4096, 4096), Style.SMOOTH, moving=False)
    moving = display_grid(scene.patch, (4096, 4096), Style.SMOOTH, moving=True)
    assert min(resting.u + resting.v) >= 4
    assert max(resting.u + resting.v) <= 200
    assert np.prod(moving.cells) < np.prod(resting.cells) / 3
    assert longest_chord(scene, resting, (1600.0, 1000.0)) <= 8
    assert longest_chord(scene, moving, (1600.0, 1000.0)) <= 40


def test_a_net_folded_over_and_over_is_drawn_by_a_bounded_number_of_cells():
    patch = scene_of(random_net_document(5, (40, 40), flatness=3.0)).patch
    for moving, most in ((True, 190), (False, 760)):
        assert max(display_grid(patch, (4096, 4096), Style.SMOOTH, moving=moving).cells) <= most


def test_coarse_facets_and_points_stay_coarse_in_every_window():
    patch = scene_of(random_net_document(5, (2, 3))).patch
    assert sample_grid(patch, (8, 4)) == Grid((3, 2, 2), (2, 1))
    for style in (Style.FACETS, Style.POINTS):
        assert display_grid(patch, (8, 4), style, moving=False) == Grid((3, 2, 2), (2, 1))
    assert facet_grid(patch, (8, 4)) == Grid((3, 2, 2), (2, 1))
    assert max(facet_grid(patch, (4096, 4096)).cells) <= 202


def test_shared_grids_and_limits_keep_a_cell_in_every_window():
    patch = scene_of(random_net_document(5, (2, 3))).patch
    assert shared_grid(patch, (4, 4)) == Grid((2, 2, 2), (2, 2))
    assert GRID.within((6, 1)) == Grid((2, 2, 2), (1, 1))
    assert GRID.over(patch) is GRID


@pytest.mark.parametrize("by", ["height", "gaussian", "mean"])
def test_values_are_those_of_each_window(by):
    scene = scene_of(random_net_document(6, (2, 3), smooth=0.5))
    values = scene.values(FIELDS[by], GRID, moving=False)
    for a, b in np.ndindex(2, 3):
        one = scene.surface.window(a, b)
        expected = FIELDS[by].values(one, *locals_of(GRID, a, b), None)
        np.testing.assert_allclose(block(values, GRID, a, b), expected, rtol=1e-6, atol=1e-7 * np.abs(expected).max())


def test_values_spread_in_their_own_window():
    coarse, fine = Grid((1, 2), (1,)), Grid((2, 2), (2,))
    values = np.array([[0, 0], [2, 2], [10, 10], [11, 13], [12, 16]], dtype=float)
    expected = [[0, 0, 0], [1, 1, 1], [2, 2, 2], [10, 10, 10], [11, 12, 13], [12, 14, 16]]
    np.testing.assert_allclose(spread(values, coarse, fine), expected)
    assert spread(values, coarse, coarse) is values


@pytest.mark.parametrize("direction", list(Direction))
def test_a_knot_is_felt_in_its_own_windows_alone(direction):
    document = random_net_document(7, (2, 3), smooth=0.0)
    place = KnotPlace(direction, 3, "r", 1)
    scene = scene_of(document, knot=place)
    slope = scene.knot_slope.coefficients
    own = {(0, 1), (1, 1)} if direction is Direction.ROWS else {(1, 0), (1, 1)}
    assert {tuple(window) for window in np.argwhere(slope.any(axis=(2, 3, 4))).tolist()} == own
    step = 1e-6
    value = document.row_knots.array if direction is Direction.ROWS else document.column_knots.array
    ends = [
        Evaluation(set_values(document, {place: float(value[3, 1, 0]) + sign * step})).patch.coefficients
        for sign in (1, -1)
    ]
    np.testing.assert_allclose(slope, (ends[0] - ends[1]) / (2 * step), atol=1e-7)
    values = scene.values(FIELDS["sensitivity"], GRID, moving=False)
    for a, b in np.ndindex(2, 3):
        assert block(values, GRID, a, b).any() == ((a, b) in own)


@pytest.mark.parametrize("windows", [(1, 2), (2, 3), (7, 40)])
def test_what_lies_below_a_net_is_hidden(windows):
    scene = scene_of(waves(windows))
    (_, u), (_, v) = scene.patch.domain
    on = scene.patch.points(np.linspace(0.03, 0.97, 15) * u, np.linspace(0.03, 0.97, 15) * v).reshape(-1, 3)
    occluder = Occluder(scene, Camera(*NAMED_VIEWS["top"]), (600.0, 500.0))
    above = np.array([0, 0, 0.1])
    assert not occluder.hidden(on + above).any()
    assert occluder.hidden(on - above).mean() > 0.97  # between two cells' straight sides the ground may show
    assert not occluder.hidden(np.array([[5.0, 5.0, -9.0]])).any()


def test_a_pole_has_normals():
    """Where all of a window's points of an edge are one, single precision has no direction."""
    document = closed_net(1, (2, 3), ("u",))
    net = document.control_points.copy()
    net[:3] = net[1, 0]
    scene = scene_of(replace(document, control_points=net))
    vertices = surface_vertices(scene.patch, GRID)
    assert np.isfinite(vertices).all()


def test_windows_too_small_to_be_told_apart_share_their_cells_while_something_moves():
    scene = scene_of(waves((100, 100)))
    grid = display_grid(scene.patch, (4096, 4096), Style.FACETS, moving=True)
    assert grid.together == (2, 2)
    assert max(grid.cells) <= 60
    assert grid.is_over(scene.patch)
    vertices, values = surface_vertices(scene.patch, grid), scene.values(FIELDS["height"], grid, moving=True)
    (u, v), number = grid.together, 3
    a, b = number * v, number * u
    first, last = scene.patch.window(a, b), scene.patch.window(a + v - 1, b + u - 1)
    mine = block(vertices, grid, number, number)
    np.testing.assert_allclose(mine[0, 0, :3], first.points([0.0], [0.0])[0, 0], atol=1e-6)
    np.testing.assert_allclose(mine[1, 1, :3], last.points([1.0], [1.0])[0, 0], atol=1e-6)
    np.testing.assert_allclose(unit(mine[1, 1, 3:]), last.normals([1.0], [1.0])[0, 0], atol=1e-4)
    assert block(values, grid, number, number)[1, 1] == pytest.approx(
        scene.surface.window(a + v - 1, b + u - 1).points([1.0], [1.0])[0, 0, 2], abs=1e-9
    )
    moved = set_point(scene.document, 7, 7, scene.document.control_points[7, 7] + [0, 0, 1.0])
    after = make_scene(Evaluation(moved, scene.evaluation), Layer.RAW, scene.frame)
    revised, rows = revised_vertices(vertices, scene.patch, after.patch, grid)
    np.testing.assert_array_equal(revised, surface_vertices(after.patch, grid))
    assert rows.stop - rows.start < len(vertices) / 4


@pytest.mark.parametrize("index", [(4, 4), (0, 0), (12, 14)])
@pytest.mark.parametrize("layer", list(Layer))
def test_a_surface_laid_by_an_earlier_one_is_what_it_is_laid_anew(index, layer):
    document = random_net_document(4, (5, 6))
    before = scene_of(document, layer)
    for moved in (document, set_point(document, *index, document.control_points[index] + [0.0, 0.1, 3.0])):
        result = Evaluation(moved, before.evaluation)
        anew = make_scene(result, layer, before.frame)
        after = make_scene(result, layer, before.frame, earlier=before)
        np.testing.assert_array_equal(after.patch.coefficients, anew.patch.coefficients)
        assert not after.patch.coefficients.flags.writeable
        assert after.patch.lengths[0].tolist() == anew.patch.lengths[0].tolist()


def test_corners_of_windows_are_points_of_the_surface():
    scene = scene_of(random_net_document(4, (5, 6)))
    np.testing.assert_allclose(scene.window_corners, scene.patch.points(*scene.patch.breakpoints), atol=1e-12)


@pytest.mark.parametrize("by", ["height", "mean", "distance"])
def test_a_scene_takes_over_what_an_earlier_one_made_of_the_same_windows(by, monkeypatch):
    document = waves((5, 6))
    reference = Evaluation(random_net_document(1, (1, 1))).patch
    before = scene_of(document, reference=reference)
    grid = before.grid(Style.SMOOTH, moving=True)
    before.values(FIELDS[by], grid, moving=True)
    before.mesh(36)
    moved = Evaluation(set_point(document, 5, 6, [6.0, 5.0, 0.6]), before.evaluation)
    after, anew = (make_scene(moved, Layer.RAW, before.frame, before.companions) for _ in range(2))
    after.follow(before)
    asked = []
    monkeypatch.setattr(
        scenes,
        "field_values",
        lambda field, surface, *rest: asked.append(surface) or field_values(field, surface, *rest),
    )
    values = after.values(FIELDS[by], grid, moving=True)
    assert [surface.windows for surface in asked] == [(2, 3)]
    np.testing.assert_allclose(values, anew.values(FIELDS[by], grid, moving=True), rtol=1e-9, atol=1e-9)
    np.testing.assert_array_equal(after.mesh(36)[0], anew.mesh(36)[0])
    assert after.grid(Style.SMOOTH, moving=True) is grid
    later = make_scene(Evaluation(document, moved), Layer.RAW, before.frame, before.companions)
    later.follow(after)
    assert scenes.Scene not in after.cache  # what is older is let go
    other = scene_of(document)
    other.follow(before)
    assert scenes.Scene not in other.cache
