"""Ticks, frames, display grids, hidden marks and colours: the parts without Qt."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_app.state.display import ColourMap, Scaling, Style
from qovr_app.style.colour_maps import colour_table, colours_of
from qovr_app.style.ticks import round_limits, tick_positions
from qovr_app.view3d.scene.axes import axes_box
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.curve_lines import curve_points
from qovr_app.view3d.scene.display_grid import display_grid, facet_grid
from qovr_app.view3d.scene.frame import frame_around
from qovr_app.view3d.scene.mesh import surface_vertices, triangle_indices
from qovr_app.view3d.scene.occlusion import Occluder
from qovr_app.view3d.scene.scene import make_scene, scene_frame
from qovr_core import Document, Evaluation, Patch, configure
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.edits import set_formulation, set_points
from qovr_core.layer import Layer
from qovr_core.number_texts import tick_texts
from qovr_core.presets import preset
from support.view import grid


def scene_of(document, layer=Layer.TRANSFORMED, scaling=Scaling.EACH):
    result = configure(document)
    return make_scene(result, layer, scene_frame(result, layer, scaling))


@pytest.mark.parametrize(
    ("interval", "limits"),
    [((0.4, 0.5), (0.4, 0.5)), ((0.88, 1.2), (0.8, 1.2)), ((0, 30), (0, 30)), ((-3, 3.1), (-4, 4))],
)
def test_limits_are_round_and_close(interval, limits):
    assert round_limits(*interval) == pytest.approx(limits)


@pytest.mark.parametrize("value", [0.0, 5.0, -3e9])
def test_an_interval_without_extent_gets_some(value):
    low, high = round_limits(value, value)
    assert low < value < high


@pytest.mark.parametrize(
    ("positions", "texts"),
    [
        ((0.4, 0.5, 3), ["0.40", "0.45", "0.50"]),
        ((-2, 2, 4), ["−2", "−1", "0", "1", "2"]),
        ((0, 3e7, 3), ["0e+00", "1e+07", "2e+07", "3e+07"]),
        ((1e9, 1e9 + 2, 2), ["1.000000000e+09", "1.000000001e+09", "1.000000002e+09"]),
    ],
)
def test_ticks_tell_neighbours_apart(positions, texts):
    assert tick_texts(tick_positions(*positions)) == texts


def test_ticks_closer_together_than_numbers_are_have_texts():
    positions = tick_positions(1e16, 1e16 + 4, 4)
    assert (np.diff(positions) == 0).any()
    assert len(tick_texts(positions)) == positions.size


def test_the_papers_raw_figure_has_one_frame_for_net_and_surface():
    frame = scene_of(preset("fig5").document, Layer.RAW).frame
    np.testing.assert_allclose(frame.limits, [[0, 30], [0, 60], [0.4, 1.2]])
    np.testing.assert_allclose(frame.to_unit(np.array([[3.0, 4.0, 0.5]])) / frame.scale + frame.centre, [[3, 4, 0.5]])


def test_equal_scales_are_equal():
    assert np.ptp(scene_of(preset("fig5").document, scaling=Scaling.EQUAL).frame.scale) == 0


@pytest.mark.parametrize("layer", [Layer.RAW, Layer.TRANSFORMED])
def test_vertices_are_the_patch_and_its_normals(layer):
    scene = scene_of(preset("fig6c").document, layer)
    u, v = np.linspace(0, 1, 7), np.linspace(0, 1, 5)
    vertices = surface_vertices(scene.patch, grid(7, 5))
    np.testing.assert_allclose(vertices[..., :3], scene.patch.points(u, v), atol=1e-6)
    normals = vertices[..., 3:] / np.linalg.norm(vertices[..., 3:], axis=-1, keepdims=True)
    np.testing.assert_allclose(normals, scene.patch.normals(u, v), atol=1e-5)
    assert not vertices.flags.writeable


def test_normals_belong_to_the_scaled_surface():
    """A plane that rises by 0.1 over 4 units stands steep once every axis fills its box."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    scene = scene_of(Document(np.stack([x, y, 0.025 * x], axis=-1), formulation="interpolating"), Layer.RAW)
    normal = surface_vertices(scene.patch, grid(3, 3))[1, 1, 3:]
    scaled = np.array([-0.025, 0, 1]) / scene.frame.scale
    np.testing.assert_allclose(normal / np.linalg.norm(normal), scaled / np.linalg.norm(scaled), atol=1e-6)


def test_an_edge_drawn_into_a_point_has_finite_normals():
    coefficients = scene_of(preset("fig5").document).patch.coefficients[0, 0].copy()
    coefficients[0] = coefficients[0, 0]
    patch = Patch(coefficients)
    assert np.ptp(patch.points([0.0], [0.0, 0.5, 1.0]), axis=1).max() < 1e-12  # it is a point
    assert np.abs(patch.derivative([0.0], [0.0, 0.5, 1.0], 0, 1)).max() < 1e-12  # where S_u x S_v vanishes
    vertices = surface_vertices(patch, grid(11, 11))
    lengths = np.linalg.norm(vertices[..., 3:], axis=-1)
    assert np.isfinite(vertices).all()
    assert lengths.min() > 0


def test_far_from_the_origin_nothing_is_lost():
    document = set_formulation(preset("fig5").document, "interpolating")
    away = set_points(document, document.control_points + np.array([1e9, -1e9, 0]))
    near, far = (surface_vertices(scene_of(each, Layer.RAW).patch, grid(9, 9)) for each in (document, away))
    np.testing.assert_allclose(far[..., :3], near[..., :3], atol=1e-5)


def test_triangles_cover_the_grid_in_one_direction():
    n, m = 4, 6
    triangles = triangle_indices(grid(n, m)).reshape(-1, 3).astype(int)
    at = np.stack([triangles // m, triangles % m], axis=-1)
    a, b, c = at[:, 0], at[:, 1], at[:, 2]
    areas = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    assert (areas == 1).all()
    assert len(triangles) == 2 * (n - 1) * (m - 1)


def test_the_display_grid_does_not_follow_large_documents():
    patch, large = scene_of(preset("fig5").document).patch, (1001, 1001)
    for style in Style:
        assert max(display_grid(patch, large, style, moving=True).shape) <= 101
        assert display_grid(patch, large, style, moving=False) == grid(201, 201)
    assert display_grid(patch, (7, 30), Style.FACETS, moving=True) == grid(7, 30)
    assert facet_grid(patch, (1001, 30)) == grid(201, 30)


def test_curves_end_on_the_inner_points():
    document = preset("fig8").document
    points = curve_points(scene_of(document).network.rows, 2)
    np.testing.assert_allclose(points[:, 0], document.control_points[:, 1], atol=1e-9)
    np.testing.assert_allclose(points[:, -1], document.control_points[:, 3], atol=1e-9)


def test_what_lies_below_a_roof_is_hidden():
    size = (600.0, 500.0)
    scene = scene_of(preset("fig5").document)
    u = np.linspace(0.1, 0.9, 9)
    above = np.array([0, 0, 0.1])
    on_surface = scene.patch.points(u, u).reshape(-1, 3)
    for camera in (Camera(*NAMED_VIEWS["top"]), Camera(-90, 89, perspective=True)):
        occluder = Occluder(scene, camera, size)
        assert not occluder.hidden(on_surface).any()
        assert not occluder.hidden(on_surface + above).any()
        assert occluder.hidden(on_surface - above).all()
        assert not occluder.hidden(np.array([[5.0, 5.0, -9.0]])).any()


def test_jet_is_matlabs():
    table = colour_table(ColourMap.JET) / 255
    # Rows 1, 33, 97, 129, 161 and 256 of MATLAB's jet(256), in 64ths.
    rows = np.array([[0, 0, 33], [0, 1, 64], [1, 64, 63], [33, 64, 31], [64, 63, 0], [32, 0, 0]]) / 64
    np.testing.assert_allclose(table[[0, 32, 96, 128, 160, 255]], rows, atol=0.01)


@pytest.mark.parametrize("colour_map", list(ColourMap))
def test_every_colour_map_has_a_table(colour_map):
    table = colour_table(colour_map)
    assert table.shape == (256, 3)
    assert not table.flags.writeable
    np.testing.assert_array_equal(colours_of(np.array([-1.0, 5.0]), 0, 1, colour_map), table[[0, 255]])
    np.testing.assert_array_equal(colours_of(np.array([2.0]), 2, 2, colour_map)[0], table[128])


def test_the_axes_box_opens_toward_the_viewer():
    frame = frame_around([np.array([[0, 4], [0, 4], [0.4, 0.5]])], Scaling.EACH)
    box = axes_box(frame, Camera(*NAMED_VIEWS["paper"]), (800.0, 600.0))
    assert [edge.title for edge in box.edges] == ["X-Axis", "Y-Axis", "Z-Axis"]
    x, y, z = box.edges
    assert x.outward[1] > 0  # below the box, as in the paper's figures
    assert y.outward[0] > 0
    assert y.outward[1] > 0
    assert z.outward[0] < 0
    assert x.labels.texts == ["0", "1", "2", "3", "4"]


def test_from_above_the_z_axis_has_no_ticks():
    frame = frame_around([np.array([[0, 4], [0, 4], [0.4, 0.5]])], Scaling.EACH)
    box = axes_box(frame, Camera(*NAMED_VIEWS["top"]), (800.0, 600.0))
    assert [edge.title for edge in box.edges] == ["X-Axis", "Y-Axis"]
    assert box.edges[0].outward[1] > 0.9
    assert box.edges[1].outward[0] < -0.9


def test_a_scene_needs_no_samples():
    """The view reads nothing of an evaluation that grows with the document's sample counts."""

    class WithoutSamples(Evaluation):
        @property
        def raw(self):
            raise AssertionError("the raw samples were asked for")

        @property
        def transformed(self):
            raise AssertionError("the transformed samples were asked for")

    evaluation = WithoutSamples(replace(preset("fig5").document, samples=(11, 7)))
    scene = make_scene(evaluation, Layer.RAW, scene_frame(evaluation, Layer.RAW, Scaling.EACH))
    assert scene.surface_box[2] == pytest.approx((0.88, 1.2))
