"""The other buttons, the wheel and the trackpad."""

import numpy as np
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QMenu

from support.hand import ALT, MIDDLE, RIGHT

from .gesture import Table

TABLE = Table()
_KEYS = {"Shift": Qt.Key.Key_Shift, "Ctrl": Qt.Key.Key_Control}


def _add_menus():
    kinds = {
        "a point": ("context.point", lambda hand: hand.place(4, 2), "transform_points"),
        "a line of the net": (
            "context.net_line",
            lambda hand: (hand.place(0, 1) + hand.place(0, 2)) / 2,
            "fit_selection",
        ),
        "the colour bar": (
            "context.colour_bar",
            lambda hand: QPoint(hand.viewport.width() - 30, hand.viewport.height() // 2),
            "colour_map_cividis",
        ),
        "the view": ("context.view", lambda hand: hand.beside, "camera_back"),
    }
    for what, (name, place, command) in kinds.items():

        @TABLE(f"right click on {what}: its menu")
        def _(hand, name=name, place=place, command=command):
            hand.click(place(hand), RIGHT)
            menu = hand.editor.find(name, QMenu)
            hand.show()
            assert menu.isVisible()
            assert command in {action.objectName() for action in menu.actions()}
            assert hand.steps == []
            menu.close()


_add_menus()


@TABLE("right click on an unselected point selects it, on a selected one keeps the selection")
def _(hand):
    hand.select((0, 1), (0, 2))
    hand.click(hand.place(0, 1), RIGHT)
    hand.show()
    QApplication.activePopupWidget().close()
    assert hand.selected == {(0, 1), (0, 2)}
    hand.click(hand.place(0, 3), RIGHT)
    QApplication.activePopupWidget().close()
    assert hand.selected == {(0, 3)}


def _add_schemes():
    schemes = [
        ("blender", RIGHT, "", "pan"),
        ("blender", MIDDLE, "", "orbit"),
        ("blender", MIDDLE, "Shift", "pan"),
        ("rhino", RIGHT, "", "orbit"),
        ("rhino", RIGHT, "Shift", "pan"),
        ("cad", RIGHT, "", "pan"),
        ("cad", MIDDLE, "", "orbit"),
        ("cad", MIDDLE, "Ctrl", "pan"),
    ]
    for scheme, button, key, motion in schemes:
        held, which = f"{key}+" if key else "", "right" if button == RIGHT else "middle"

        @TABLE(f"{scheme}: {held}{which} drag {motion}s")
        def _(hand, scheme=scheme, button=button, key=key, motion=motion):
            hand.editor.trigger(f"mouse_{scheme}")
            before = hand.camera
            if key:
                hand.hold(_KEYS[key])
            hand.press(hand.beside, button)
            hand.move_by(45, 15)
            hand.show()
            hand.release(button)
            if key:
                hand.let_go(_KEYS[key])
            assert QApplication.activePopupWidget() is None
            assert (hand.camera.azimuth == before.azimuth) is (motion == "pan")
            assert (hand.camera.centre != before.centre) is (motion == "pan")


_add_schemes()


@TABLE("Alt + left drag stays free for the window manager")
def _(hand):
    before = hand.camera
    hand.modifiers = ALT
    hand.drag(hand.beside, 60, 25)
    hand.modifiers &= ~ALT
    hand.show()
    assert hand.camera == before
    assert hand.editor.document == hand.state.history.first


@TABLE("the wheel zooms to what is under the mouse")
def _(hand):
    at, span = hand.place(0, 2), hand.camera.span
    hand.wheel(4, at)
    hand.show()
    assert hand.camera.span < span
    away = hand.place(0, 2) - at
    assert max(abs(away.x()), abs(away.y())) <= 1


@TABLE("the wheel stops where sense ends, inward and outward")
def _(hand):
    hand.move(hand.place(0, 2))
    for notches in (60, -60):
        for _ in range(3):
            hand.wheel(notches)
        reached = hand.camera.span
        hand.wheel(notches)
        assert hand.camera.span == reached
    hand.show()
    assert hand.viewport.rect().contains(hand.place(0, 2).toPoint())


@TABLE("the wheel during a soft drag changes the radius, and nothing else moves")
def _(hand):
    hand.editor.trigger("soft")
    camera = hand.camera
    hand.press(hand.place(4, 2))
    hand.move_by(0, -40)
    before = hand.net
    hand.wheel(1)
    hand.show()
    wider = hand.net
    assert hand.editor.message() == "Soft moves reach 3 steps along the net."
    assert hand.camera == camera
    assert np.array_equal(wider[4, 2], before[4, 2])
    assert wider[4, 1, 2] > before[4, 1, 2]
    hand.wheel(-1)
    assert np.array_equal(hand.net, before)
    hand.release()
    assert hand.steps == ["Move P 4,2"]


@TABLE("the wheel during a drag that is not soft does nothing")
def _(hand):
    camera = hand.camera
    hand.press(hand.place(4, 2))
    hand.move_by(0, -40)
    before = hand.net
    hand.wheel(3)
    hand.show()
    assert hand.camera == camera
    assert np.array_equal(hand.net, before)
    hand.release()


@TABLE("two fingers orbit, with Shift they pan, with Ctrl they zoom")
def _(hand):
    hand.move(hand.beside)
    before = hand.camera
    hand.two_fingers(40, 10)
    hand.show()
    turned = hand.camera
    assert turned.azimuth != before.azimuth
    assert turned.elevation != before.elevation
    assert turned.span == before.span
    hand.hold(Qt.Key.Key_Shift)
    hand.two_fingers(40, 10)
    hand.let_go(Qt.Key.Key_Shift)
    assert hand.camera.azimuth == turned.azimuth
    assert hand.camera.centre != turned.centre
    hand.hold(Qt.Key.Key_Control)
    hand.two_fingers(0, 40)
    hand.let_go(Qt.Key.Key_Control)
    assert hand.camera.span < before.span
