"""The knots' handles as they are drawn and found: by OpenGL and by the painter, on nets of several windows too."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_app.state.display import LayerChoice, Projection, Scaling
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.style.theme import KNOT_SERIES
from qovr_app.view3d.interaction.picking import handle_under, points_under
from qovr_app.view3d.scene.frame import frame_around
from qovr_app.view3d.scene.knot_handles import handles_of
from qovr_core.geometry.knots import Direction, KnotPlace, Knots
from support.view import change, choose

KNOTS = Knots(r=0.3, s=0.65, u=0.38, t=0.8)
CHORDS = {"r": (0, 2), "s": (1, 3), "u": (1, 3), "t": (2, 4)}


@pytest.fixture(params=["opengl", "painter"])
def owner(request, make_view, document):
    if request.param == "painter":
        request.getfixturevalue("no_opengl")
    owner = make_view(document, layer=LayerChoice.RAW, labels=False)
    assert owner.view.uses_opengl == (request.param == "opengl")
    return owner


def in_hand(direction=Direction.ROWS, curve=0, knots=KNOTS, window=0):
    return KnotInHand(KnotPlace(direction, curve, "u", window), knots)


def place_of(net, name, knots=KNOTS):
    """Return where a handle belongs on a line of points, by the words of its definition."""
    start, end = (net[k] for k in CHORDS[name])
    return start + getattr(knots, name) * (end - start)


@pytest.mark.parametrize("direction", Direction)
def test_every_handle_is_seen_and_found_where_it_belongs(owner, direction, expected_pixel, colour_at):
    view, net = owner.view, owner.document.control_points
    line = net[0] if direction is Direction.ROWS else net[:, 0]
    change(view, curve=in_hand(direction))
    owner.make_rest()
    theme, image = view.picture().theme, view.image()
    for name in "rsut":
        pixel = expected_pixel(view, place_of(line, name))
        assert colour_at(image, *pixel) == theme.background  # the ground of its diamond
        radius = 4.5 if name == "s" else 6.0
        rim = colour_at(image, pixel[0] + radius / 2, pixel[1] - radius / 2)
        assert np.abs(np.subtract(rim, theme.series[KNOT_SERIES[name]])).max() < 60
        found = handle_under(view.picture(), view.viewports[0].logical_size, *pixel)
        assert found.knot.place == KnotPlace(direction, 0, name)
    choose(view, knot_handles=False)
    owner.make_rest()
    assert handle_under(view.picture(), view.viewports[0].logical_size, *pixel) is None
    hidden = view.image()
    choose(view, knot_handles=True)
    owner.make_rest()
    assert hidden != view.image()


def test_in_perspective_and_with_equal_scales_they_are_found_too(make_view, document):
    owner = make_view(document, at_rest=False, projection=Projection.PERSPECTIVE, scaling=Scaling.EQUAL)
    view = owner.view
    change(view, curve=in_hand(Direction.COLUMNS, 3))
    picture, size = view.picture(), view.viewports[0].logical_size
    for name in "rut":
        place = picture.scene.frame.to_unit(place_of(document.control_points[:, 3], name))
        x, y, _ = picture.camera.project(place[None], size)[0].tolist()
        assert handle_under(picture, size, x, y).knot.place.name == name


def test_a_handle_on_its_control_point_stands_aside_so_that_either_can_be_taken(make_view, document, expected_pixel):
    net = document.control_points.copy()
    net[0] = np.linspace([0, 0, 0], [0, 4, 0.4], 5)  # evenly spaced, where knots of one half are points
    owner = make_view(replace(document, control_points=net), layer=LayerChoice.RAW, labels=False)
    view, size = owner.view, owner.view.viewports[0].logical_size
    change(view, curve=in_hand(knots=Knots()))
    picture = view.picture()
    for column, name in ((1, "r"), (2, "u"), (3, "t")):
        at = np.array(expected_pixel(view, net[0, column]))
        assert handle_under(picture, size, *at) is None
        assert points_under(picture, size, *at)[0] == (0, column)
        way = np.array(expected_pixel(view, net[0, 4])) - expected_pixel(view, net[0, 0])
        across = np.array([way[1], -way[0]]) / np.hypot(*way)
        aside = at + 12 * across * np.sign(across[1])
        assert handle_under(picture, size, *aside).knot.place.name == name


def test_a_window_of_a_larger_net_has_the_handles_of_its_own_points():
    net = np.random.default_rng(7).random((7, 9, 3))
    frame = frame_around([np.array([[0.0, 1.0]] * 3)], Scaling.EACH)
    for window in range(3):
        handles = handles_of(in_hand(curve=2, window=window), net, frame)
        points = net[2, 2 * window : 2 * window + 5]
        assert [handle.knot.place.name for handle in handles] == list("rsut")
        for handle in handles:
            assert handle.point == pytest.approx(place_of(points, handle.knot.place.name))
    joined = handles_of(in_hand(Direction.COLUMNS, curve=8, knots=Knots(), window=1), net, frame)
    assert [handle.knot.place.name for handle in joined] == ["r", "u", "t"]
    assert [handle.knot.takes_s for handle in joined] == [False, True, False]
    np.testing.assert_allclose(joined[1].point, (net[3, 8] + net[5, 8]) / 2)


def test_a_chord_without_length_has_no_handle():
    net = np.zeros((5, 5, 3))
    net[0, :, 0] = [0, 1, 0, 3, 4]  # P_0 and P_2 are one point
    frame = frame_around([np.array([[0.0, 4.0]] * 3)], Scaling.EACH)
    assert [handle.knot.place.name for handle in handles_of(in_hand(knots=Knots()), net, frame)] == ["u", "t"]
