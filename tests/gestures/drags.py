"""What keys, buttons and the other world do while a point is dragged, and what stays."""

import numpy as np
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QFocusEvent
from PySide6.QtWidgets import QApplication

from qovr_app.view3d.painter.hand import drag_text
from qovr_app.view3d.painter.overlay import LEAVES_FRAME
from qovr_core.presets import preset
from support.hand import NO_BUTTON, RIGHT

from .gesture import Table

TABLE = Table()
_SHIFT, _CONTROL, _KEYS = Qt.Key.Key_Shift, Qt.Key.Key_Control, (Qt.Key.Key_X, Qt.Key.Key_Y, Qt.Key.Key_Z)
POINT = (4, 2)


def _way(hand):
    """Return how far the point is from where its document had it."""
    return hand.net[POINT] - hand.state.history.first.control_points[POINT]


@TABLE("Shift during a drag is fine: a tenth of the way")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -40)
    hand.hold(_SHIFT)
    coarse = hand.place(*POINT)
    hand.move_by(0, -50)
    hand.show()
    assert abs(hand.place(*POINT).y() - coarse.y() + 5) <= 1
    hand.let_go(_SHIFT)
    hand.move_by(0, -20)
    assert abs(hand.place(*POINT).y() - coarse.y() + 25) <= 1
    hand.release()


@TABLE("Ctrl during a drag keeps to the step")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -33)
    assert hand.net[POINT][2] != round(hand.net[POINT][2] * 20) / 20
    hand.hold(_CONTROL)
    hand.show()
    assert hand.net[POINT][2] == round(hand.net[POINT][2] * 20) / 20
    hand.let_go(_CONTROL)
    hand.release()


def _add_locks():
    for axis, (letter, key) in enumerate(zip("XYZ", _KEYS, strict=True)):

        @TABLE(f"{letter} tapped during a drag locks the axis, and again frees it")
        def _(hand, axis=axis, key=key):
            hand.editor.trigger("move_view")
            hand.press(hand.place(*POINT))
            hand.tap(key)
            hand.move_by(30, -24)
            hand.show()
            assert np.flatnonzero(_way(hand)).tolist() == [axis]
            hand.tap(key)
            hand.move_by(5, -30)
            assert np.count_nonzero(_way(hand)) > 1
            hand.release()

        @TABLE(f"Shift+{letter} during a drag locks the plane, and is fine only when the letter is up")
        def _(hand, axis=axis, key=key):
            hand.press(hand.place(*POINT))
            hand.hold(_SHIFT)
            hand.hold(key)
            start = hand.place(*POINT)
            hand.move_by(30, -44)
            hand.show()
            assert _way(hand)[axis] == 0
            assert np.count_nonzero(_way(hand)) == 2
            reached = hand.place(*POINT)
            assert abs(reached.x() - start.x() - 30) <= 2
            assert abs(reached.y() - start.y() + 44) <= 2
            hand.let_go(key)
            hand.move_by(0, -20)
            assert np.hypot((hand.place(*POINT) - reached).x(), (hand.place(*POINT) - reached).y()) <= 6
            hand.let_go(_SHIFT)
            hand.release()


_add_locks()


@TABLE("digits during a drag set the value, whatever the mouse does, and release commits")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -30)
    hand.type("0.6")
    hand.move_by(0, -60)
    hand.show()
    assert hand.net[POINT][2] == 0.6
    hand.release()
    assert hand.net[POINT][2] == 0.6
    assert hand.steps == ["Move P 4,2"]


@TABLE("Backspace that has emptied the digits gives the point back to the mouse")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -30)
    hand.type("0.7")
    for _ in range(3):
        hand.tap(Qt.Key.Key_Backspace)
    hand.show()
    hand.move_by(0, -10)
    assert hand.net[POINT][2] not in (0.5, 0.7)
    assert abs(hand.place(*POINT).y() - hand.at.y()) <= 1
    hand.release()


@TABLE("Enter commits the digits, and the button's release does nothing more")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -30)
    hand.type("-.5")
    hand.tap(Qt.Key.Key_Return)
    hand.show()
    hand.move_by(40, -60)
    hand.release()
    assert hand.net[POINT][2] == -0.5
    assert hand.steps == ["Move P 4,2"]


@TABLE("digits are the difference of several points")
def _(hand):
    hand.select((0, 1), (0, 2), (0, 3))
    before = hand.net
    hand.press(hand.place(0, 2))
    hand.move_by(0, -30)
    hand.type("0.1")
    hand.show()
    hand.release()
    np.testing.assert_array_equal((hand.net - before)[0, :, 2].round(12), [0, 0.1, 0.1, 0.1, 0])


def _add_gizmo():
    for axis, letter in enumerate("xyz"):

        @TABLE(f"the gizmo's {letter} arrow moves along {letter}, and digits are the difference")
        def _(hand, axis=axis):
            hand.click(hand.place(*POINT))
            hand.press(hand.arrow(axis))
            hand.move_by(25, -14)
            hand.show()
            assert np.flatnonzero(_way(hand)).tolist() == [axis]
            hand.type("0.25")
            hand.release()
            assert _way(hand).tolist() == [0.25 * (k == axis) for k in range(3)]

        @TABLE(f"the gizmo's square across {letter} moves in its plane")
        def _(hand, axis=axis):
            hand.click(hand.place(*POINT))
            start = hand.place(*POINT)
            hand.press(hand.square(axis))
            hand.move_by(20, -30)
            hand.show()
            assert _way(hand)[axis] == 0
            assert np.count_nonzero(_way(hand)) == 2
            moved = hand.place(*POINT) - start
            assert abs(moved.x() - 20) <= 2
            assert abs(moved.y() + 30) <= 2
            hand.release()
            assert hand.steps == ["Move P 4,2"]


_add_gizmo()


@TABLE("the tool's view plane keeps the point under the mouse, and is remembered")
def _(hand):
    hand.editor.trigger("move_view")
    hand.press(hand.place(*POINT))
    hand.move_by(37, -22)
    hand.show()
    away = hand.place(*POINT) - hand.at
    assert max(abs(away.x()), abs(away.y())) <= 1
    hand.release()
    hand.editor.mark_saved()
    hand.editor.trigger("preset_fig8")
    assert hand.editor.action("move_view").isChecked()


@TABLE("the tool's normal takes the point off the surface at a right angle")
def _(hand):
    hand.editor.trigger("move_normal")
    surface = hand.view.picture().scene.surface
    hand.press(hand.place(*POINT))
    hand.move_by(4, -40)
    hand.show()
    way, before = _way(hand), hand.state.history.first.control_points[POINT]
    hand.release()
    samples = np.linspace(0, 1, 401)
    away = np.linalg.norm(surface.points(samples, samples) - before, axis=-1)
    u, v = samples[list(np.unravel_index(away.argmin(), away.shape))]
    normal = surface.normals([u], [v])[0, 0]
    assert np.linalg.norm(way) > 0.01
    assert abs(way @ normal) / np.linalg.norm(way) > 0.999


@TABLE("z from above follows the mouse's vertical way")
def _(hand):
    hand.editor.trigger("camera_top")
    hand.rest()
    hand.press(hand.place(*POINT))
    hand.move_by(25, 25)
    assert _way(hand)[2] < 0
    hand.move_by(0, -60)
    hand.show()
    assert _way(hand)[2] > 0
    assert not _way(hand)[:2].any()
    hand.release()


@TABLE("guide line, ghost and numbers show a drag; a mouse's numbers are no finer than a pixel")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -45)
    hand.show()
    picture = hand.view.picture()
    marks, (_, numbers) = picture.hand.drag, drag_text(picture, picture.hand.drag)
    z = float(hand.net[POINT][2])
    assert numbers == f"z {z:g} (+{z - 0.5:.4g})"
    assert len(repr(z)) <= 6
    assert marks.begun[0].tolist() == [2, 4, 0.5]
    assert marks.ways.tolist() == [[0, 0, 1]]
    hand.release()
    assert hand.view.picture().hand.drag is None


@TABLE("camera, axes and colours stay in a drag, after it and on undo; F fits")
def _(hand):
    def looks():
        picture = hand.view.picture()
        return hand.camera, picture.scene.frame.limits.tolist(), picture.colouring.limits

    before = looks()
    hand.press(hand.place(*POINT))
    hand.move_by(0, -90)
    assert looks() == before
    hand.release()
    assert abs(hand.place(*POINT).y() - hand.at.y()) <= 1
    hand.show()
    assert LEAVES_FRAME.endswith("F fits")
    assert hand.view.picture().leaves_frame
    hand.editor.type_into("control_points.P_0_0.z", "0.9")
    hand.editor.trigger("undo")
    assert looks() == before
    hand.viewport.setFocus()
    hand.tap(Qt.Key.Key_F)
    hand.rest()
    assert not hand.view.picture().leaves_frame
    assert looks()[1:] != before[1:]


def _is_put_back(hand):
    """Assert that the drag is over, and that the button, still held, does nothing until its release."""
    camera = hand.camera
    assert hand.editor.document == hand.state.history.first
    hand.move_by(60, 50)
    assert hand.camera == camera
    hand.release()
    hand.move_by(-20, -20)
    assert hand.editor.document == hand.state.history.first
    assert hand.steps == []
    assert hand.editor.disagreements() == []


@TABLE("Escape during a drag puts everything back and waits for the release")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -50)
    assert _way(hand)[2] > 0
    hand.tap(Qt.Key.Key_Escape)
    hand.show()
    _is_put_back(hand)


@TABLE("the right button during a drag puts everything back and opens no menu")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -50)
    hand.click(button=RIGHT)
    hand.show()
    assert QApplication.activePopupWidget() is None
    _is_put_back(hand)


@TABLE("lost focus ends a drag as Escape does")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -50)
    lost = QFocusEvent(QEvent.Type.FocusOut, Qt.FocusReason.ActiveWindowFocusReason)
    QApplication.sendEvent(hand.viewport, lost)
    hand.editor.settle()
    hand.show()
    _is_put_back(hand)


@TABLE("a release that nobody told of ends a drag as Escape does")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -50)
    hand.held = NO_BUTTON
    hand.move_by(5, 5)
    hand.show()
    assert hand.editor.document == hand.state.history.first
    assert hand.steps == []


@TABLE("a document that is opened during a drag ends it")
def _(hand):
    hand.press(hand.place(*POINT))
    hand.move_by(0, -30)
    hand.editor.mark_saved()
    hand.editor.trigger("preset_fig8")
    hand.move_by(0, -20)
    hand.show()
    hand.release()
    assert hand.editor.document == preset("fig8").document
    assert hand.steps == []


@TABLE("with Live off a drag moves the document, and the surface stays stale")
def _(hand):
    hand.editor.trigger("live")
    before = hand.state.evaluation
    hand.press(hand.place(*POINT))
    hand.move_by(0, -40)
    hand.show()
    assert hand.state.evaluation is before
    assert hand.state.is_stale
    assert hand.editor.find("view.stale").isVisible()
    hand.release()
    assert hand.steps == ["Move P 4,2"]
    hand.editor.trigger("undo")
    assert not hand.editor.find("view.stale").isVisible()


@TABLE("with Live off, what is typed over a moved point stays pending beside it")
def _(hand):
    hand.editor.trigger("live")
    hand.editor.type_into("control_points.P_4_2.z", "0.7")
    hand.press(hand.place(*POINT))
    hand.move_by(0, -40)
    hand.show()
    hand.release()
    field = hand.editor.field("control_points.P_4_2.z")
    assert field.text() == "0.7"
    assert field.is_pending
    assert hand.net[POINT][2] not in (0.5, 0.7)
