"""The keyboard, with the focus in the view."""

import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication

from support.hand import ALT, CONTROL, SHIFT

from .gesture import Table

TABLE = Table()
_LEFT, _RIGHT, _UP, _DOWN = Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down


@TABLE("arrows walk over the points and stay at the net's end")
def _(hand):
    hand.editor.trigger("camera_top")
    hand.rest()
    walked = []
    for key in (_RIGHT, _RIGHT, _RIGHT, _UP, _LEFT, _DOWN, _DOWN):
        hand.tap(key)
        walked.append(hand.picked_last)
    hand.show()
    assert walked == [(0, 0), (0, 1), (0, 2), (1, 2), (1, 1), (0, 1), (0, 1)]
    assert len(hand.selected) == 1


def _add_nudges():
    keys = {
        "Alt+Left": (_LEFT, 0, -1),
        "Alt+Right": (_RIGHT, 0, 1),
        "Alt+Down": (_DOWN, 1, -1),
        "Alt+Up": (_UP, 1, 1),
        "Alt+PageDown": (Qt.Key.Key_PageDown, 2, -1),
        "Alt+PageUp": (Qt.Key.Key_PageUp, 2, 1),
    }
    for text, (key, axis, way) in keys.items():

        @TABLE(f"{text} nudges {'xyz'[axis]} {'up' if way > 0 else 'down'}")
        def _(hand, key=key, axis=axis, way=way):
            hand.click(hand.place(4, 2))
            before = hand.net
            hand.tap(key, ALT)
            hand.show()
            moved = hand.net - before
            assert moved[4, 2].round(12).tolist() == [0.01 * way * (k == axis) for k in range(3)]
            assert abs(moved).sum() == pytest.approx(0.01)


_add_nudges()


@TABLE("nudges within a second are one undo")
def _(hand):
    hand.click(hand.place(4, 2))
    for _ in range(3):
        hand.tap(Qt.Key.Key_PageUp, ALT)
    hand.show()
    assert hand.net[4, 2, 2] == 0.53
    assert len(hand.steps) == 1
    hand.tap(Qt.Key.Key_Z, CONTROL)
    assert hand.editor.document == hand.state.history.first


@TABLE("nudges go by the step that drags snap to, where they do")
def _(hand):
    hand.editor.trigger("snap")
    hand.click(hand.place(4, 2))
    hand.tap(_LEFT, ALT)
    hand.show()
    assert hand.net[4, 2, 0] == pytest.approx(1.95)


@TABLE("Ctrl+arrows orbit, Shift+arrows pan, plus and minus zoom")
def _(hand):
    hand.viewport.setFocus()
    before = hand.camera
    hand.tap(_LEFT, CONTROL)
    hand.show()
    turned = hand.camera
    assert turned.azimuth == pytest.approx(before.azimuth - 5)
    hand.tap(_RIGHT, SHIFT)
    assert hand.camera.centre != turned.centre
    hand.tap(Qt.Key.Key_Plus)
    assert hand.camera.span < turned.span
    hand.tap(Qt.Key.Key_Minus)
    assert hand.camera.span == pytest.approx(turned.span)
    assert hand.selected == set()


@TABLE("Tab leaves the view, and Shift+Tab leaves it the other way")
def _(hand):
    for modifier in (SHIFT, None):
        hand.viewport.setFocus()
        hand.tap(Qt.Key.Key_Tab, *([modifier] if modifier else []))
        if modifier is None:
            hand.show()
        focus = QApplication.focusWidget()
        assert focus is not None
        assert focus is not hand.viewport
        assert not hand.view.isAncestorOf(focus)


@TABLE("single letters act only with the keyboard in the view")
def _(hand):
    hand.drag(hand.place(4, 2), 0, -60)
    hand.editor.field("row_knots.C_4.r").setFocus()
    for key in (Qt.Key.Key_F, Qt.Key.Key_1):
        hand.tap(key)
    assert hand.view.picture().leaves_frame
    assert not hand.editor.action("layer_raw").isChecked()
    hand.tap(Qt.Key.Key_Escape)
    hand.viewport.setFocus()
    hand.tap(Qt.Key.Key_1)
    hand.show()
    assert hand.editor.action("layer_raw").isChecked()
    hand.tap(Qt.Key.Key_2)
    assert hand.editor.action("layer_transformed").isChecked()


@TABLE("Delete says what to do instead")
def _(hand):
    hand.click(hand.place(4, 2))
    hand.tap(Qt.Key.Key_Delete)
    hand.show()
    assert "keeps all its points" in hand.editor.message()
    assert hand.editor.document == hand.state.history.first


@TABLE("Escape without a drag clears the selection")
def _(hand):
    hand.click(hand.place(4, 2))
    hand.tap(Qt.Key.Key_Escape)
    hand.show()
    assert hand.selected == set()
