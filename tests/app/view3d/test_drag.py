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
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice
from qovr_app.state.tools import ToolSettings, Way
from qovr_app.view3d.interaction.keys import arrow_step
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.occlusion import Occluder
from qovr_core.cameras import NAMED_VIEWS
from support.view import change

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


def test_two_drags_have_two_gestures(owner, pixel):
    viewport = owner.view.viewports[0]
    for _ in range(2):
        start = pixel(owner, (1, 1))
        press(viewport, start)
        move(viewport, start + by(0, 12))
        release(viewport, start + by(0, 12))
    assert len({drag[2] for drag in owner.drags}) == 2


def test_a_rectangle_selects_what_is_in_it(owner, pixel):
    viewport = owner.view.viewports[0]
    every = {index: pixel(owner, index) for index in ALL_POINTS}
    left, right = pixel(owner, (2, 2)) - by(90, 60), pixel(owner, (2, 2)) + by(90, 60)
    inside = {index for index, at in every.items() if (at > left).all() and (at < right).all()}
    press(viewport, left, CONTROL)
    move(viewport, right, CONTROL)
    release(viewport, right, CONTROL)
    size, picture = viewport.logical_size, owner.view.picture()
    hidden = Occluder(picture.scene, picture.camera, size).hidden(picture.scene.points.reshape(-1, 3))
    assert owner.view.shown.selected == {index for index in inside if not hidden[5 * index[0] + index[1]]}
    assert owner.view.shown.selected
    change(owner.view, tools=ToolSettings(selects=True, xray=True))
    camera = owner.view.camera
    press(viewport, right)
    move(viewport, left)
    release(viewport, left)
    assert owner.view.shown.selected == inside
    assert owner.view.camera == camera


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
    command = [sys.executable, "-m", "pytest", "-q", "-x", str(here), "-k", "follows_the_mouse or in_the_plane"]
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
