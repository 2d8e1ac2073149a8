"""Picking and dragging with real events: every point, in the plane, along axes, at both scale factors."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QFocusEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice
from qovr_app.state.tools import ToolSettings, Way
from qovr_app.view3d.interaction.interactor import KEPT_POINTS
from qovr_app.view3d.interaction.keys import arrow_step
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.gizmo import gizmo_at
from qovr_app.view3d.scene.occlusion import Occluder
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.edits import set_point
from support.view import change, select, wheel

ALL_POINTS = [(i, j) for i in range(5) for j in range(5)]
LEFT = Qt.MouseButton.LeftButton


def by(dx, dy):
    return np.array([dx, dy], dtype=float)


@pytest.fixture
def pixel(expected_pixel):
    """A function that tells where a control point belongs, by an independent projection."""
    return lambda owner, index: np.array(expected_pixel(owner.view, owner.document.control_points[index]))


NONE, SHIFT, CONTROL = (getattr(Qt.KeyboardModifier, f"{name}Modifier") for name in ("No", "Shift", "Control"))
RIGHT, NO_BUTTON = Qt.MouseButton.RightButton, Qt.MouseButton.NoButton


def send(viewport, kind, at, button=LEFT, buttons=LEFT, modifiers=NONE):
    position = QPointF(*at)
    event = QMouseEvent(kind, position, viewport.mapToGlobal(position), button, buttons, modifiers)
    QApplication.sendEvent(viewport, event)


def press(viewport, at, modifiers=NONE):
    send(viewport, QMouseEvent.Type.MouseButtonPress, at, modifiers=modifiers)


def move(viewport, at, modifiers=NONE):
    send(viewport, QMouseEvent.Type.MouseMove, at, NO_BUTTON, modifiers=modifiers)


def release(viewport, at, modifiers=NONE):
    send(viewport, QMouseEvent.Type.MouseButtonRelease, at, LEFT, NO_BUTTON, modifiers)


def click(viewport, at, modifiers=NONE):
    press(viewport, at, modifiers)
    release(viewport, at, modifiers)


@pytest.fixture
def owner(make_view, document):
    return make_view(document, layer=LayerChoice.RAW, at_rest=False)


def moved_by(owner, index):
    return owner.document.control_points[index] - owner.before.control_points[index]


@pytest.mark.parametrize("index", ALL_POINTS)
def test_a_point_is_picked_and_follows_the_mouse_along_z(owner, index, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, index)
    press(viewport, start + by(2, -3))
    assert owner.selections == [(index,)]
    move(viewport, start + by(20, -10))
    move(viewport, start + by(37, -25))
    seen = pixel(owner, index)
    np.testing.assert_allclose(seen, start + by(0, -22), atol=0.6)  # no finer than a pixel means
    release(viewport, start + by(37, -25))
    indices, moved, gesture = owner.drags[-1]
    assert indices == (index,)
    assert not moved.flags.writeable
    assert {drag[2] for drag in owner.drags} == {gesture}
    assert owner.ends == [("finished", gesture)]
    assert np.argwhere(owner.document.control_points != owner.before.control_points).tolist() == [[*index, 2]]


@pytest.mark.parametrize("index", [(0, 0), (1, 3), (4, 2)])
def test_in_the_plane_of_the_view_a_point_stays_under_the_mouse(make_view, document, index, pixel):
    owner = make_view(document, layer=LayerChoice.RAW, at_rest=False)
    change(owner.view, tools=ToolSettings(way=Way.VIEW))
    viewport, start = owner.view.viewports[0], pixel(owner, index)
    press(viewport, start + by(2, -3))
    move(viewport, start + by(39, -25))
    np.testing.assert_allclose(pixel(owner, index), start + by(37, -22), atol=1.5)
    release(viewport, start + by(39, -25))


def test_along_the_normal_a_point_leaves_the_surface_at_a_right_angle(make_view, document, pixel):
    owner = make_view(document, layer=LayerChoice.RAW, at_rest=False)
    change(owner.view, tools=ToolSettings(way=Way.NORMAL))
    viewport, start = owner.view.viewports[0], pixel(owner, (1, 3))
    surface = owner.view.picture().scene.surface
    press(viewport, start)
    move(viewport, start + by(4, -40))
    way = moved_by(owner, (1, 3))
    release(viewport, start + by(4, -40))
    samples = np.linspace(0, 1, 401)
    points = surface.points(samples, samples)
    u, v = np.unravel_index(np.linalg.norm(points - owner.before.control_points[1, 3], axis=-1).argmin(), (401, 401))
    normal = surface.normals(samples[u : u + 1], samples[v : v + 1])[0, 0]
    assert np.linalg.norm(way) > 0.01
    assert abs(way @ normal) / np.linalg.norm(way) == pytest.approx(1, abs=1e-4)


@pytest.mark.parametrize(("key", "axis"), [(Qt.Key.Key_X, 0), (Qt.Key.Key_Y, 1), (Qt.Key.Key_Z, 2)])
def test_a_tap_locks_an_axis_and_again_frees_it(make_view, document, key, axis, pixel):
    owner = make_view(document, layer=LayerChoice.RAW, at_rest=False)
    change(owner.view, tools=ToolSettings(way=Way.VIEW))
    viewport, start = owner.view.viewports[0], pixel(owner, (1, 3))
    press(viewport, start)
    QTest.keyClick(viewport, key)
    move(viewport, start + by(30, -24))
    moved = moved_by(owner, (1, 3))
    assert moved[axis] != 0
    assert np.count_nonzero(moved) == 1
    QTest.keyClick(viewport, key)
    move(viewport, start + by(31, -60))
    assert np.count_nonzero(moved_by(owner, (1, 3))) > 1
    release(viewport, start + by(31, -60))


@pytest.mark.parametrize("axis", [0, 1, 2])
def test_shift_and_a_letter_lock_the_plane_and_are_not_fine(owner, axis, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (1, 3))
    press(viewport, start)
    key = (Qt.Key.Key_X, Qt.Key.Key_Y, Qt.Key.Key_Z)[axis]
    QTest.keyPress(viewport, key, SHIFT)
    move(viewport, start + by(50, -44), SHIFT)
    moved = moved_by(owner, (1, 3))
    assert moved[axis] == 0
    assert np.count_nonzero(moved) == 2
    np.testing.assert_allclose(pixel(owner, (1, 3)), start + by(50, -44), atol=1.5)
    QTest.keyRelease(viewport, key, SHIFT)
    move(viewport, start + by(50, -54), SHIFT)  # fine from here: a tenth of the way
    assert np.linalg.norm(pixel(owner, (1, 3)) - start - by(50, -44)) < 4
    release(viewport, start + by(50, -54))


def test_what_cannot_be_seen_to_move_follows_the_mouse_upward(owner, pixel):
    owner.view.set_camera("top", animated=False)
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    press(viewport, start)
    move(viewport, start + by(25, -25))
    assert moved_by(owner, (2, 2))[2] > 0
    assert not moved_by(owner, (2, 2))[:2].any()
    move(viewport, start + by(-25, 25))
    assert moved_by(owner, (2, 2))[2] < 0
    release(viewport, start + by(-25, 25))


def test_shift_is_fine_from_where_the_point_is(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    press(viewport, start)
    move(viewport, start + by(0, -40))
    move(viewport, start + by(0, -40), SHIFT)
    coarse = pixel(owner, (2, 2))
    np.testing.assert_allclose(coarse, start + by(0, -40), atol=0.6)
    move(viewport, start + by(0, -60), SHIFT)
    np.testing.assert_allclose(pixel(owner, (2, 2)), coarse + by(0, -2), atol=0.2)
    move(viewport, start + by(0, -60))
    move(viewport, start + by(0, -70))
    np.testing.assert_allclose(pixel(owner, (2, 2)), coarse + by(0, -12), atol=0.7)
    release(viewport, start + by(0, -70))


def test_control_keeps_to_the_step_and_numbers_are_short(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    press(viewport, start)
    move(viewport, start + by(0, -33))
    z = owner.document.control_points[2, 2, 2]
    assert len(repr(float(z))) <= 6
    move(viewport, start + by(0, -33), CONTROL)
    z = owner.document.control_points[2, 2, 2]
    assert z == round(z * 20) / 20
    release(viewport, start + by(0, -33), CONTROL)


def test_digits_say_the_value_until_backspace_has_emptied_them(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    press(viewport, start)
    move(viewport, start + by(0, -30))
    QTest.keyClicks(viewport, "0.75")
    assert owner.document.control_points[2, 2, 2] == 0.75
    move(viewport, start + by(0, -90))
    assert owner.document.control_points[2, 2, 2] == 0.75
    for _ in range(4):
        QTest.keyClick(viewport, Qt.Key.Key_Backspace)
    move(viewport, start + by(0, -120))
    assert owner.document.control_points[2, 2, 2] > 0.76
    QTest.keyClicks(viewport, "-.5")
    QTest.keyClick(viewport, Qt.Key.Key_Return)
    assert owner.document.control_points[2, 2, 2] == -0.5
    assert owner.ends == [("finished", owner.drags[0][2])]
    move(viewport, start + by(0, -150))
    release(viewport, start + by(0, -150))
    assert owner.document.control_points[2, 2, 2] == -0.5
    assert len(owner.ends) == 1


def test_several_points_move_alike_and_digits_are_the_difference(owner, pixel):
    chosen = [(1, 1), (3, 2), (2, 2)]
    select(owner.view, *chosen)
    viewport, start = owner.view.viewports[0], pixel(owner, (3, 2))
    press(viewport, start)
    move(viewport, start + by(0, -30))
    ways = np.array([moved_by(owner, index) for index in chosen])
    assert ways[0, 2] > 0
    np.testing.assert_allclose(ways, ways[[0, 0, 0]], atol=1e-12)
    QTest.keyClicks(viewport, "0.1")
    release(viewport, start + by(0, -30))
    for index in chosen:
        assert moved_by(owner, index) == pytest.approx([0, 0, 0.1])
    assert owner.selections == []
    assert np.count_nonzero(owner.document.control_points != owner.before.control_points) == 3


@pytest.mark.parametrize("end", ["escape", "right button", "focus"])
def test_a_drag_that_is_given_up_puts_all_back_and_waits_for_the_release(owner, pixel, end):
    viewport, start, camera = owner.view.viewports[0], pixel(owner, (3, 1)), owner.view.camera
    viewport.setFocus()
    press(viewport, start)
    move(viewport, start + by(40, 10))
    assert owner.document != owner.before
    if end == "escape":
        QTest.keyClick(viewport, Qt.Key.Key_Escape)
    elif end == "right button":
        send(viewport, QMouseEvent.Type.MouseButtonPress, start + by(40, 10), RIGHT, LEFT | RIGHT)
        send(viewport, QMouseEvent.Type.MouseButtonRelease, start + by(40, 10), RIGHT, LEFT)
    else:
        QApplication.sendEvent(viewport, QFocusEvent(QEvent.Type.FocusOut, Qt.FocusReason.ActiveWindowFocusReason))
    assert owner.document == owner.before
    assert owner.ends == [("cancelled", owner.drags[0][2])]
    move(viewport, start + by(90, 60))
    assert owner.view.camera == camera
    release(viewport, start + by(90, 60))
    assert len(owner.drags) == 1
    assert len(owner.ends) == 1


def test_a_release_that_is_lost_puts_all_back(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (3, 1))
    press(viewport, start)
    move(viewport, start + by(0, -30))
    send(viewport, QMouseEvent.Type.MouseMove, start + by(0, -60), NO_BUTTON, NO_BUTTON)
    assert owner.document == owner.before
    assert owner.ends == [("cancelled", owner.drags[0][2])]


def test_wheel_and_pinch_wait_while_a_point_is_dragged(owner, pixel):
    viewport, start, camera = owner.view.viewports[0], pixel(owner, (3, 1)), owner.view.camera
    press(viewport, start)
    move(viewport, start + by(0, -30))
    wheel(viewport, start, 3)
    assert owner.view.camera == camera
    release(viewport, start + by(0, -30))
    wheel(viewport, start, 3)
    assert owner.view.camera != camera


def test_two_drags_have_two_gestures(owner, pixel):
    viewport = owner.view.viewports[0]
    for _ in range(2):
        start = pixel(owner, (1, 1))
        press(viewport, start)
        move(viewport, start + by(0, 12))
        release(viewport, start + by(0, 12))
    assert len({drag[2] for drag in owner.drags}) == 2


def test_a_click_selects_and_edits_nothing(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (4, 2))
    press(viewport, start)
    move(viewport, start + by(1, 1))
    release(viewport, start + by(1, 1))
    assert owner.selections == [((4, 2),)]
    assert owner.drags == []
    assert owner.ends == []
    click(viewport, (3, 3))
    assert owner.selections == [((4, 2),), ()]


def test_an_orbit_keeps_the_selection(owner):
    select(owner.view, (1, 1))
    viewport, camera = owner.view.viewports[0], owner.view.camera
    press(viewport, (5, 5))
    move(viewport, (45, 5))
    release(viewport, (45, 5))
    assert owner.view.camera != camera
    assert owner.selections == []


def test_shift_adds_and_control_toggles_and_neither_drags(owner, pixel):
    viewport = owner.view.viewports[0]
    click(viewport, pixel(owner, (1, 1)))
    for index, modifier in (((1, 3), SHIFT), ((3, 1), CONTROL), ((1, 1), CONTROL)):
        at = pixel(owner, index)
        press(viewport, at, modifier)
        move(viewport, at + by(0, -40), modifier)
        release(viewport, at + by(0, -40), modifier)
    assert owner.view.shown.selected == {(1, 3), (3, 1)}
    assert owner.drags == []


def test_a_rectangle_selects_what_is_in_it(owner, pixel):
    viewport = owner.view.viewports[0]
    every = {index: pixel(owner, index) for index in ALL_POINTS}
    left, right = pixel(owner, (2, 2)) - by(90, 60), pixel(owner, (2, 2)) + by(90, 60)
    inside = {index for index, at in every.items() if (at > left).all() and (at < right).all()}
    press(viewport, left, CONTROL)
    move(viewport, right, CONTROL)
    release(viewport, right, CONTROL)
    size, picture = viewport.logical_size, owner.view.picture()
    hidden = Occluder(picture.scene.patch, picture.camera, size).hidden(picture.scene.points.reshape(-1, 3))
    assert owner.view.shown.selected == {index for index in inside if not hidden[5 * index[0] + index[1]]}
    assert owner.view.shown.selected
    change(owner.view, tools=ToolSettings(selects=True, xray=True))
    camera = owner.view.camera
    press(viewport, right)
    move(viewport, left)
    release(viewport, left)
    assert owner.view.shown.selected == inside
    assert owner.view.camera == camera


def test_the_gizmo_moves_along_its_arrow_and_in_its_square(owner, pixel):
    select(owner.view, (2, 2))
    viewport, picture = owner.view.viewports[0], owner.view.picture()
    gizmo = gizmo_at(picture.scene.points[2, 2], picture.camera, viewport.logical_size)
    assert len(gizmo.arrows) == 3
    for axis, ends in gizmo.arrows.items():
        at = ends[0] + 0.75 * (ends[1] - ends[0])
        press(viewport, at)
        move(viewport, at + by(30, -14))
        assert np.flatnonzero(moved_by(owner, (2, 2))).tolist() == [axis]
        QTest.keyClicks(viewport, "0.25")
        assert moved_by(owner, (2, 2))[axis] == pytest.approx(0.25)
        QTest.keyClick(viewport, Qt.Key.Key_Escape)
        release(viewport, at)
    for axis, corners in gizmo.squares.items():
        at = corners.mean(axis=0)
        press(viewport, at)
        move(viewport, at + by(20, -30))
        assert moved_by(owner, (2, 2))[axis] == 0
        assert np.count_nonzero(moved_by(owner, (2, 2))) == 2
        QTest.keyClick(viewport, Qt.Key.Key_Escape)
        release(viewport, at)
    assert owner.selections == []


def test_a_point_behind_the_surface_is_picked_with_x_ray_only(make_view, document, pixel):
    owner = make_view(document, layer=LayerChoice.TRANSFORMED)
    picture, viewport = owner.view.picture(), owner.view.viewports[0]
    size = viewport.logical_size
    hidden = Occluder(picture.scene.patch, picture.camera, size).hidden(picture.scene.points.reshape(-1, 3))
    index = divmod(int(np.flatnonzero(hidden)[0]), 5)
    click(viewport, pixel(owner, index))
    assert owner.selections == []
    change(owner.view, tools=ToolSettings(xray=True))
    click(viewport, pixel(owner, index))
    assert owner.selections == [(index,)]


def test_stacked_points_are_picked_one_after_the_other(make_view, document, pixel):
    stacked = set_point(set_point(document, 1, 1, (2.0, 2.0, 1.2)), 3, 3, (2.0, 2.0, 1.2))
    owner = make_view(set_point(stacked, 2, 2, (2.0, 2.0, 1.2)), layer=LayerChoice.RAW)
    viewport, at = owner.view.viewports[0], pixel(owner, (2, 2))
    for _ in range(4):
        click(viewport, at)
    picked = [selection[0] for selection in owner.selections]
    assert set(picked[:3]) == {(1, 1), (2, 2), (3, 3)}
    assert picked[3] == picked[0]
    press(viewport, at)
    move(viewport, at + by(0, -30))
    assert owner.drags[-1][0] == (picked[3],)
    release(viewport, at + by(0, -30))


def test_axes_and_colours_stay_and_f_takes_them_anew(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    limits, colours = owner.view.picture().scene.frame.limits, owner.view.picture().colouring.limits
    press(viewport, start)
    move(viewport, start + by(0, -150))
    release(viewport, start + by(0, -150))
    for _ in range(2):
        np.testing.assert_array_equal(owner.view.picture().scene.frame.limits, limits)
        assert owner.view.picture().colouring.limits == colours
        owner.make_rest()
    assert owner.view.picture().leaves_frame
    np.testing.assert_allclose(pixel(owner, (2, 2)), start + by(0, -150), atol=0.6)
    owner.view.fit(animated=False)
    assert not owner.view.picture().leaves_frame
    assert (owner.view.picture().scene.frame.limits != limits).any()
    assert owner.view.picture().colouring.limits[1] > colours[1]


def test_hovering_tells_which_point(owner, pixel):
    viewport = owner.view.viewports[0]
    for at, index in ((pixel(owner, (0, 1)), (0, 1)), (np.array([3.0, 3.0]), None)):
        send(viewport, QMouseEvent.Type.MouseMove, at, Qt.MouseButton.NoButton, Qt.MouseButton.NoButton)
        assert owner.view.picture().hovered == index


def test_both_layers_are_dragged_in_their_own_space(make_view, document, expected_pixel):
    owner = make_view(document, layer=LayerChoice.BOTH, size=(1000, 480))
    for number, viewport in enumerate(owner.view.viewports):
        point = owner.document.control_points[2, 3]
        start = np.array(expected_pixel(owner.view, point, number))
        press(viewport, start)
        move(viewport, start + by(15, -25))
        seen = expected_pixel(owner.view, owner.document.control_points[2, 3], number)
        np.testing.assert_allclose(seen, start + by(0, -25), atol=0.6)
        release(viewport, start + by(15, -25))


def test_the_same_at_scale_factor_two():
    if os.environ.get("QT_SCALE_FACTOR"):
        pytest.skip("this is the run at another scale factor")
    here = Path(__file__)
    command = [sys.executable, "-m", "pytest", "-q", "-x", str(here), "-k", "follows_the_mouse or tap_locks"]
    run = subprocess.run(
        command,
        env={**os.environ, "QT_SCALE_FACTOR": "2"},
        cwd=here.parents[3],
        capture_output=True,
        text=True,
        check=False,
    )
    assert run.returncode == 0, run.stdout[-3000:]


def test_keys_walk_over_nets_of_any_shape():
    shape, above = (3, 7), Camera(*NAMED_VIEWS["top"])
    assert arrow_step(None, shape, Qt.Key.Key_Right, above) == (0, 0)
    assert arrow_step((1, 5), shape, Qt.Key.Key_Right, above) == (1, 6)
    assert arrow_step((1, 6), shape, Qt.Key.Key_Right, above) == (1, 6)
    assert arrow_step((1, 6), shape, Qt.Key.Key_Up, above) == (2, 6)
    assert arrow_step((2, 6), shape, Qt.Key.Key_Up, above) == (2, 6)
    assert arrow_step((2, 6), shape, Qt.Key.Key_A, above) is None


def test_keys_walk_over_the_net_and_tab_leaves_it(owner):
    viewport, said = owner.view.viewports[0], []
    owner.view.wanted.connect(lambda intent: said.append(intent.text))
    viewport.setFocus()
    for key in (Qt.Key.Key_Right, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Tab):
        QTest.keyClick(viewport, key)
    assert owner.selections == [((0, 0),), ((0, 1),), ((1, 1),)]
    QTest.keyClick(viewport, Qt.Key.Key_Delete)
    assert said == [KEPT_POINTS]
    assert owner.document == owner.before
    QTest.keyClick(viewport, Qt.Key.Key_Escape)
    assert owner.selections[-1] == ()
