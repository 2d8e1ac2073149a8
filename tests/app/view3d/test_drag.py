"""Picking and dragging with real events: every point, in the plane, along axes, at both scale factors."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice
from qovr_app.view3d.interaction.keys import arrow_step, next_point
from qovr_app.view3d.scene.camera import Camera
from qovr_core.cameras import NAMED_VIEWS

ALL_POINTS = [(i, j) for i in range(5) for j in range(5)]
LEFT = Qt.MouseButton.LeftButton


def by(dx, dy):
    return np.array([dx, dy], dtype=float)


@pytest.fixture
def pixel(expected_pixel):
    """A function that tells where a control point belongs, by an independent projection."""
    return lambda owner, index: np.array(expected_pixel(owner.view, owner.document.control_points[index]))


def send(viewport, kind, at, button=LEFT, buttons=LEFT):
    position = QPointF(*at)
    event = QMouseEvent(kind, position, viewport.mapToGlobal(position), button, buttons, Qt.KeyboardModifier.NoModifier)
    QApplication.sendEvent(viewport, event)


def press(viewport, at):
    send(viewport, QMouseEvent.Type.MouseButtonPress, at)


def move(viewport, at):
    send(viewport, QMouseEvent.Type.MouseMove, at, Qt.MouseButton.NoButton)


def release(viewport, at):
    send(viewport, QMouseEvent.Type.MouseButtonRelease, at, LEFT, Qt.MouseButton.NoButton)


@pytest.fixture
def owner(make_view, document):
    return make_view(document, layer=LayerChoice.RAW, at_rest=False)


@pytest.mark.parametrize("index", ALL_POINTS)
def test_a_point_is_picked_and_follows_the_mouse(owner, index, spin, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, index)
    goal = start + by(37, -22)
    press(viewport, start + by(2, -3))
    assert owner.selections == [index]
    move(viewport, start + by(20, -10))
    move(viewport, goal + by(2, -3))
    np.testing.assert_allclose(pixel(owner, index), goal, atol=0.1)
    release(viewport, goal + by(2, -3))
    i, j, point, gesture = owner.drags[-1]
    assert (i, j) == index
    assert not point.flags.writeable
    np.testing.assert_array_equal(owner.document.control_points[index], point)
    assert {drag[3] for drag in owner.drags} == {gesture}
    assert owner.ends == [("finished", gesture)]
    others = np.ones((5, 5), dtype=bool)
    others[index] = False
    np.testing.assert_array_equal(owner.document.control_points[others], owner.before.control_points[others])


@pytest.mark.parametrize(("key", "axis"), [(Qt.Key.Key_X, 0), (Qt.Key.Key_Y, 1), (Qt.Key.Key_Z, 2)])
def test_an_axis_key_keeps_the_point_on_its_axis(owner, key, axis, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (1, 3))
    press(viewport, start)
    QTest.keyPress(viewport, key)
    move(viewport, start + by(30, -24))
    QTest.keyRelease(viewport, key)
    moved = owner.drags[0][2] - owner.before.control_points[1, 3]
    assert moved[axis] != 0
    assert np.count_nonzero(moved) == 1
    np.testing.assert_allclose(pixel(owner, (1, 3)), start + by(30, -24), atol=0.1)
    release(viewport, start + by(30, -24))


def test_an_axis_that_points_at_the_viewer_is_refused(owner, pixel):
    owner.view.set_camera("top", animated=False)
    viewport, start = owner.view.viewports[0], pixel(owner, (2, 2))
    press(viewport, start)
    QTest.keyPress(viewport, Qt.Key.Key_Z)
    move(viewport, start + by(25, 25))
    assert owner.drags == []
    QTest.keyRelease(viewport, Qt.Key.Key_Z)
    release(viewport, start + by(25, 25))
    assert owner.drags[-1][2][2] == owner.before.control_points[2, 2, 2]


def test_escape_puts_the_point_back(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (3, 1))
    press(viewport, start)
    move(viewport, start + by(40, 10))
    assert owner.document != owner.before
    QTest.keyClick(viewport, Qt.Key.Key_Escape)
    assert owner.document == owner.before
    assert owner.ends == [("cancelled", owner.drags[0][3])]
    move(viewport, start + by(60, 10))
    release(viewport, start + by(60, 10))
    assert len(owner.drags) == 1
    assert len(owner.ends) == 1


def test_two_drags_have_two_gestures(owner, pixel):
    viewport = owner.view.viewports[0]
    for _ in range(2):
        start = pixel(owner, (1, 1))
        press(viewport, start)
        move(viewport, start + by(12, 0))
        release(viewport, start + by(12, 0))
    assert len({drag[3] for drag in owner.drags}) == 2


def test_a_click_selects_and_edits_nothing(owner, pixel):
    viewport, start = owner.view.viewports[0], pixel(owner, (4, 2))
    press(viewport, start)
    move(viewport, start + by(1, 1))
    release(viewport, start + by(1, 1))
    assert owner.selections == [(4, 2)]
    assert owner.drags == []
    assert owner.ends == []
    press(viewport, (3, 3))
    release(viewport, (3, 3))
    assert owner.selections == [(4, 2), None]


def test_a_hidden_point_is_still_picked(make_view, document, pixel):
    owner = make_view(document, layer=LayerChoice.TRANSFORMED)
    picture = owner.view.picture()
    from qovr_app.view3d.scene.occlusion import Occluder

    size = owner.view.viewports[0].logical_size
    hidden = Occluder(picture.scene.patch, picture.camera, size).hidden(picture.scene.points.reshape(-1, 3))
    index = divmod(int(np.flatnonzero(hidden)[0]), 5)
    press(owner.view.viewports[0], pixel(owner, index))
    release(owner.view.viewports[0], pixel(owner, index))
    assert owner.selections == [index]


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
        move(viewport, start + by(15, -15))
        seen = expected_pixel(owner.view, owner.document.control_points[2, 3], number)
        np.testing.assert_allclose(seen, start + by(15, -15), atol=0.1)
        release(viewport, start + by(15, -15))


def test_the_same_at_scale_factor_two():
    if os.environ.get("QT_SCALE_FACTOR"):
        pytest.skip("this is the run at another scale factor")
    here = Path(__file__)
    command = [sys.executable, "-m", "pytest", "-q", "-x", str(here), "-k", "follows_the_mouse or axis_key"]
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
    shape, walked = (3, 7), [None]
    while (index := next_point(walked[-1], shape, forward=True)) is not None:
        walked.append(index)
    assert walked[1:] == [(i, j) for i in range(3) for j in range(7)]
    assert next_point(None, shape, forward=False) == (2, 6)
    above = Camera(*NAMED_VIEWS["top"])
    assert arrow_step((1, 5), shape, Qt.Key.Key_Right, above) == (1, 6)
    assert arrow_step((1, 6), shape, Qt.Key.Key_Right, above) == (1, 6)
    assert arrow_step((1, 6), shape, Qt.Key.Key_Up, above) == (2, 6)
    assert arrow_step((2, 6), shape, Qt.Key.Key_Up, above) == (2, 6)


def test_keys_walk_over_the_net(owner, spin):
    viewport = owner.view.viewports[0]
    viewport.setFocus()
    QTest.keyClick(viewport, Qt.Key.Key_Tab)
    QTest.keyClick(viewport, Qt.Key.Key_Tab)
    QTest.keyClick(viewport, Qt.Key.Key_Up)
    QTest.keyClick(viewport, Qt.Key.Key_Right)
    QTest.keyClick(viewport, Qt.Key.Key_Backtab)
    assert owner.selections == [(0, 0), (0, 1), (1, 1), (1, 2), (1, 1)]
    QTest.keyClick(viewport, Qt.Key.Key_Escape)
    assert owner.selections[-1] is None
