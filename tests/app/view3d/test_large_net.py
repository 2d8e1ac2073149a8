"""A net of 203 x 203 points in the view alone: picked, framed, dragged and orbited as one of 5 x 5 is."""

import time

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import DisplaySettings, LayerChoice
from qovr_app.style.canvas import blank_image, painting
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.paint import paint
from qovr_app.view3d.scene.net_marks import with_room
from qovr_app.view3d.scene.occlusion import Occluder, hidden_among
from support.made_up import MadeUp, net_on_surface
from support.view import change, select

SHAPE = (203, 203)
LEFT, NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
CONTROL = Qt.KeyboardModifier.ControlModifier
DOWN, MOVE, UP = (getattr(QEvent.Type, name) for name in ("MouseButtonPress", "MouseMove", "MouseButtonRelease"))


def send(viewport, kind, at, modifiers=Qt.KeyboardModifier.NoModifier):
    at = QPointF(*at)
    button, buttons = (NO_BUTTON if kind is MOVE else LEFT), (NO_BUTTON if kind is UP else LEFT)
    event = QMouseEvent(kind, at, viewport.mapToGlobal(at), button, buttons, modifiers)
    QApplication.sendEvent(viewport, event)


def gesture(viewport, start, end, modifiers=Qt.KeyboardModifier.NoModifier):
    send(viewport, DOWN, start, modifiers)
    for part in (0.5, 1.0):
        send(viewport, MOVE, np.array(start) + part * np.subtract(end, start), modifiers)
    send(viewport, UP, end, modifiers)


def places(view):
    """Return where the points are seen, (k, l, 2): one matrix and one product."""
    picture, size = view.picture(), view.viewports[0].logical_size
    points, matrix = picture.scene.points, picture.camera.matrix(size)
    clip = np.concatenate([points, np.ones((*points.shape[:2], 1))], axis=-1) @ matrix.T
    return (clip[..., :2] / clip[..., 3:] * [0.5, -0.5] + 0.5) * size


@pytest.fixture(scope="module")
def view(app):
    """The view with a net of many points, whose owner selects and moves them as the view asks."""
    from qovr_app.view3d.view import View3D

    view = View3D()
    view.resize(700, 560)
    made_up = MadeUp(net_on_surface(*SHAPE))
    change(view, settings=DisplaySettings(layer=LayerChoice.RAW), evaluation=made_up)
    view.moves = []
    view.points_picked.connect(lambda picked, _picking: select(view, *picked))

    def drag(indices, moved, _gesture):
        points = made_up.points.copy()
        points[tuple(np.array(indices).T)] += moved
        view.moves.append(moved)
        change(view, evaluation=MadeUp(points), dragging=True)

    view.points_dragged.connect(drag)
    view.show()
    view.set_camera("top", animated=False)
    yield view
    view.close()
    view.deleteLater()


@pytest.fixture
def at_once(view):
    """The view from above, nothing selected."""
    select(view)
    change(view, dragging=False)
    view.set_camera("top", animated=False)
    view.moves.clear()
    return view


@pytest.mark.parametrize("index", [(0, 0), (101, 57), (202, 202)])
def test_a_click_picks_the_point_under_it(at_once, index):
    viewport = at_once.viewports[0]
    gesture(viewport, places(at_once)[index], places(at_once)[index])
    assert at_once.shown.selected == {index}


def test_a_rectangle_selects_what_lies_in_it(at_once):
    viewport, seen = at_once.viewports[0], places(at_once)
    corners = seen[60, 40] - 0.5, seen[30, 90] + 0.5
    low, high = np.minimum(*corners), np.maximum(*corners)
    expected = {(i, j) for i, j in np.argwhere(((seen >= low) & (seen <= high)).all(axis=-1)).tolist()}
    change(at_once, tools=type(at_once.shown.tools)(selects=True))
    gesture(viewport, *corners)
    change(at_once, tools=type(at_once.shown.tools)())
    assert len(expected) > 1000
    assert at_once.shown.selected == expected


def test_a_point_is_dragged_along_z(at_once):
    at_once.set_camera("front", animated=False)
    viewport, start = at_once.viewports[0], places(at_once)[0, 101]
    gesture(viewport, start, start - [0, 40])
    moved = at_once.moves[-1]
    assert moved.shape == (1, 3)
    assert moved[0, 2] > 0
    assert np.abs(moved[0, :2]).max() == 0


def test_the_view_turns_about_what_is_pressed(at_once):
    viewport, before = at_once.viewports[0], at_once.camera
    gesture(viewport, (4, 4), (64, 30))
    assert at_once.camera != before
    assert at_once.shown.selected == frozenset()


def test_most_points_are_known_to_be_hidden_without_being_looked_up(view):
    """What lies between points that look alike is taken for the same: wrong at most along the edge of what is seen."""
    view.set_camera("paper", animated=False)
    picture, size = view.picture(), view.viewports[0].logical_size
    waves = np.sin(np.linspace(0, 9, SHAPE[0]))[:, None] * np.cos(np.linspace(0, 7, SHAPE[1]))
    points = picture.scene.points + 0.2 * waves[..., None] * [0, 0, 1]
    (quick,) = hidden_among(picture, [points], size)
    every = Occluder(picture.scene, picture.camera, size).hidden(points.reshape(-1, 3)).reshape(SHAPE)
    assert 0.2 < every.mean() < 0.8
    assert (quick != every).mean() < 0.002


def test_names_keep_their_distance_from_one_another_and_from_what_is_never_covered():
    corners = np.random.default_rng(3).uniform(0, 400, (5000, 2))
    taken = np.array([[300.0, 100.0, 400.0, 300.0]])
    kept, opacity = with_room(corners, (30.0, 14.0), taken, 1)
    boxes = corners[kept]
    apart = np.abs(boxes[:, None] - boxes[None])
    np.fill_diagonal(apart[..., 0], 99)
    assert ((apart[..., 0] >= 30) | (apart[..., 1] >= 14)).all()
    in_bar = (boxes + np.array([30, 14]) > taken[0, :2]) & (boxes < taken[0, 2:])
    assert not in_bar.all(axis=1).any()
    assert len(kept) > 60
    assert kept[0] == 0
    assert opacity[0] == 1
    assert (opacity > 0).all()


def test_what_a_frame_of_many_points_takes(make_view, document, view, capsys):
    """Sixteen hundred times as many points take some ten times as long; the numbers are for whoever reads them."""
    few = make_view(document).view
    seconds = {}
    for name, each in (("5 x 5", few), ("203 x 203", view)):
        each.set_camera("paper", animated=False)
        picture, size, image = each.picture(), each.viewports[0].logical_size, None
        spent = []
        for _ in range(9):
            start = time.thread_time()
            image = blank_image(size, 1.0, image)
            with painting(image) as painter:
                paint(painter, overlay(picture, size))
            spent.append(time.thread_time() - start)
        seconds[name] = sorted(spent)[len(spent) // 2]
    with capsys.disabled():
        ratio = seconds["203 x 203"] / seconds["5 x 5"]
        print(
            f"\n203 x 203 points are drawn in {1e3 * seconds['203 x 203']:.1f} ms, {ratio:.1f} times as long as 5 x 5"
        )
    assert np.count_nonzero(np.frombuffer(image.constBits(), np.uint8)) > 10_000
