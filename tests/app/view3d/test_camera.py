"""The camera's matrices, moves and fits, against formulas written down apart from them."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_app.view3d.scene.camera import SPAN_LIMITS, Camera, Margins, fitted
from qovr_core.cameras import NAMED_VIEWS

SIZE = (800.0, 600.0)
CAMERAS = [
    Camera(),
    Camera(azimuth=20, elevation=-30, centre=(0.2, -0.1, 0.3), span=2.0),
    Camera(azimuth=170, elevation=10, span=3.0, perspective=True),
]
POINTS = np.random.default_rng(7).uniform(-1, 1, (40, 3))


def test_matlabs_view_of_the_paper():
    # MATLAB's viewmtx(36, 64): rows right and up.
    az, el = np.radians([36, 64])
    right = [np.cos(az), np.sin(az), 0]
    up = [-np.sin(el) * np.sin(az), np.sin(el) * np.cos(az), np.cos(el)]
    camera = Camera(*NAMED_VIEWS["paper"])
    np.testing.assert_allclose(camera.axes[:2], [right, up], atol=1e-12)


def test_from_above_x_goes_right_and_y_up():
    np.testing.assert_allclose(Camera(*NAMED_VIEWS["top"]).axes, np.eye(3), atol=1e-12)


@pytest.mark.parametrize("camera", CAMERAS)
def test_unproject_undoes_project(camera):
    seen = camera.project(POINTS, SIZE)
    np.testing.assert_allclose(camera.unproject(seen, SIZE), POINTS, atol=1e-9)
    assert (np.abs(seen[:, 2]) <= 1).all()


@pytest.mark.parametrize("camera", CAMERAS)
def test_nearer_points_have_less_depth(camera):
    toward = camera.axes[2]
    seen = camera.project(np.array([0.3 * toward, -0.3 * toward]), SIZE)
    assert seen[0, 2] < seen[1, 2]


@pytest.mark.parametrize("camera", CAMERAS)
def test_a_ray_goes_through_what_its_pixel_shows(camera):
    for point in POINTS[:5]:
        x, y, _ = camera.project(point[None], SIZE)[0]
        origin, direction = camera.ray(x, y, SIZE)
        offset = point - origin
        np.testing.assert_allclose(offset - (offset @ direction) * direction, 0, atol=1e-6)


def test_points_behind_the_eye_have_no_place():
    camera = Camera(perspective=True)
    behind = camera.axes[2] * (camera.distance + 1)
    assert np.isnan(camera.project(behind[None], SIZE)).all()


@pytest.mark.parametrize("camera", CAMERAS)
def test_zooming_keeps_the_cursor_on_the_same_point(camera):
    at = (130.0, 440.0)
    point = camera.unproject(np.array([[*at, camera.project(np.array([camera.centre]), SIZE)[0, 2]]]), SIZE)
    zoomed = camera.zoomed(1.7, at, SIZE)
    np.testing.assert_allclose(zoomed.project(point, SIZE)[0, :2], at, atol=1e-6)
    assert zoomed.span == pytest.approx(camera.span / 1.7)


def test_zooming_stops_at_its_limits():
    assert Camera().zoomed(1e9, (0, 0), SIZE).span == SPAN_LIMITS[0]
    assert Camera().zoomed(1e-9, (0, 0), SIZE).span == SPAN_LIMITS[1]


@pytest.mark.parametrize("camera", CAMERAS)
def test_panning_moves_the_picture_by_pixels(camera):
    at_centre = np.array([camera.centre])
    before = camera.project(at_centre, SIZE)[0, :2]
    after = camera.panned(31, -17, SIZE).project(at_centre, SIZE)[0, :2]
    np.testing.assert_allclose(after - before, [31, -17], atol=1e-6)


def test_orbiting_stops_at_the_poles_and_goes_round_the_axis():
    assert Camera(elevation=80).orbited(0, 40).elevation == 90
    assert Camera(azimuth=170).orbited(20, 0).azimuth == pytest.approx(-170)


@pytest.mark.parametrize("camera", CAMERAS)
@pytest.mark.parametrize("size", [(800.0, 600.0), (400.0, 900.0)])
def test_a_fitted_box_fills_the_room_inside_the_margins(camera, size):
    half, margins = np.array([1.0, 1.0, 0.6]), Margins(60, 20, 100, 50)
    signs = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    seen = fitted(camera, half, size, margins).project(signs * half, size)[:, :2]
    low, high = seen.min(axis=0), seen.max(axis=0)
    assert (low >= np.array([60, 20]) - 1).all()
    assert (high <= np.array(size) - [100, 50] + 1).all()
    slack = (np.array(size) - [160, 70]) - (high - low)
    assert slack.min() == pytest.approx(0, abs=1.5)


def test_a_turn_goes_the_shorter_way():
    start, goal = Camera(azimuth=170), Camera(azimuth=-170, span=1.0)
    assert start.toward(goal, 0.5).azimuth % 360 == pytest.approx(180)
    assert start.toward(goal, 0.5).span == pytest.approx(2.0)
    assert start.toward(goal, 1.0) == replace(goal, azimuth=190.0)
