"""Dragging numbers sideways: fields, headings of rows and columns, and the sliders; with the mouse as it comes."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QFocusEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit

from qovr_app.state.intents import LiveSwitched
from qovr_core.presets import preset
from support.mouse import CONTROL, LEFT, NONE, RIGHT, SHIFT, Mouse, move

BUMP = "control_points.P_2_2.z"


@pytest.fixture
def editor(shared_editor):
    return shared_editor


def steps_done(editor):
    return editor.window.store.state.history.index


def points(editor):
    return editor.document.control_points.copy()


def test_a_field_that_has_not_the_keyboard_is_dragged_as_one_step(editor):
    before = points(editor)
    mouse = Mouse(editor, BUMP).move(2, 2)
    np.testing.assert_array_equal(points(editor), before)
    mouse.move(16, 10, 10)
    assert editor.document.control_points[2, 2, 2] == pytest.approx(before[2, 2, 2] + 0.2, abs=0.0026)
    assert (editor.document.control_points[2, 2, 2] * 200) % 1 == pytest.approx(0, abs=1e-9)
    assert float(editor.text(BUMP)) == editor.document.control_points[2, 2, 2]
    mouse.release()
    assert steps_done(editor) == 1
    assert editor.window.store.state.gesture is None
    editor.trigger("undo")
    np.testing.assert_array_equal(points(editor), before)


def test_shift_is_fine_and_control_snaps_to_the_step(editor):
    mouse = Mouse(editor, BUMP).move(40)
    value = editor.document.control_points[2, 2, 2]
    mouse.move(0, modifiers=SHIFT)
    assert editor.document.control_points[2, 2, 2] == value
    mouse.move(10, modifiers=SHIFT)
    assert editor.document.control_points[2, 2, 2] == pytest.approx(value + 0.005)
    mouse.move(3, modifiers=CONTROL)
    assert editor.document.control_points[2, 2, 2] in {k / 20 for k in range(100)}
    mouse.release()


DRAGGED = (BUMP, "row_knots.C_2.t", "row_knots.C_2", "control_points.column_2", "surface.samples_u")


def test_what_is_put_back_waits_for_the_release(editor):
    for name in DRAGGED:
        for way in ("escape", "right", "focus"):
            drag_and_put_back(editor, name, way)


def drag_and_put_back(editor, name, way):
    mouse = Mouse(editor, name).move(30)
    assert editor.document != preset("fig5").document
    if way == "escape":
        QTest.keyClick(QApplication.focusWidget() or editor.window, Qt.Key.Key_Escape)
    elif way == "right":
        mouse.press_right()
    else:
        QApplication.sendEvent(mouse.widget, QFocusEvent(QEvent.Type.FocusOut, Qt.FocusReason.ActiveWindowFocusReason))
    editor.settle()
    assert editor.document == preset("fig5").document
    mouse.move(30, 30)
    mouse.release()
    assert editor.document == preset("fig5").document
    assert steps_done(editor) == 0
    assert QApplication.activePopupWidget() is None
    again = Mouse(editor, name).move(30, 2)
    again.release()
    assert steps_done(editor) == 1
    editor.trigger("undo")


def test_a_field_that_is_edited_has_its_text_selected_and_not_dragged(editor):
    field = editor.field(BUMP)
    QTest.mouseClick(field, LEFT)
    assert field.selectedText() == field.text()
    QTest.keyClick(field, Qt.Key.Key_End)
    Mouse(editor, BUMP).move(10, 30).release()
    assert editor.document == preset("fig5").document
    assert field.selectedText() != ""


def test_what_was_dragged_can_be_dragged_again_typed_over_and_stepped(editor):
    for _ in range(2):
        before = editor.document.control_points[2, 2, 2]
        Mouse(editor, BUMP).move(20).release()
        assert editor.document.control_points[2, 2, 2] > before
    QTest.keyClicks(editor.field(BUMP), "0.25")
    editor.key(Qt.Key.Key_Return, widget=editor.field(BUMP))
    assert editor.document.control_points[2, 2, 2] == 0.25


def test_a_double_click_selects_the_whole_number(editor):
    editor.type_into(BUMP, "-0.125")
    field = editor.field(BUMP)
    QTest.mouseDClick(field, LEFT, NONE, QPoint(field.width() - 8, field.height() // 2))
    assert field.selectedText() == "-0.125"


def test_a_heading_selects_its_points_and_changes_its_numbers_together(editor):
    for name, chosen in (
        ("control_points.row_3", {(3, j) for j in range(5)}),
        ("control_points.column_1", {(i, 1) for i in range(5)}),
        ("row_knots.C_1", {(1, j) for j in range(5)}),
        ("column_knots.K_4", {(i, 4) for i in range(5)}),
        ("row_knots.r", {(i, j) for i in range(5) for j in range(5)}),
    ):
        QTest.mouseClick(editor.find(name), LEFT)
        editor.settle()
        assert editor.window.store.state.selection.points == chosen
    editor.field(BUMP).setFocus()
    QTest.mouseClick(editor.find("control_points.row_3"), LEFT)
    QTest.mouseClick(editor.find("control_points.row_1"), LEFT, SHIFT)
    QTest.mouseClick(editor.find("control_points.column_0"), LEFT, CONTROL)
    editor.settle()
    rows = {(i, j) for i in (1, 3) for j in range(5)}
    assert editor.window.store.state.selection.points == rows ^ {(i, 0) for i in range(5)}
    assert steps_done(editor) == 0
    before = points(editor)
    Mouse(editor, "control_points.row_3.y").move(-20).release()
    assert editor.window.store.state.selection.points == rows ^ {(i, 0) for i in range(5)}
    difference = points(editor) - before
    assert np.unique(difference[3, :, 1].round(9)).tolist() == [-0.1]
    assert np.count_nonzero(difference) == 5
    Mouse(editor, "row_knots.t").move(2000).release()
    assert {knots.t for knots in editor.document.row_knots.in_window(0)} == {0.995}
    assert steps_done(editor) == 2


def test_with_live_off_a_dragged_field_is_pending_and_amber(editor):
    editor.dispatch(LiveSwitched(is_live=False))
    Mouse(editor, BUMP).move(20).release()
    assert editor.document == preset("fig5").document
    assert editor.field(BUMP).is_pending
    assert editor.window.store.state.has_pending


def test_a_slider_is_put_back_and_reset(editor):
    editor.type_into("row_knots.C_4.r", "0.3", end=Qt.Key.Key_Return)
    for way in ("escape", "right"):
        drag_slider_and_put_back(editor, way)
    slider = editor.find("row_knots.slider")
    QTest.mouseDClick(slider, LEFT, NONE, slider.rect().center())
    editor.settle()
    assert {knots.r for knots in editor.document.row_knots.in_window(0)} == {0.5}


def drag_slider_and_put_back(editor, way):
    before, slider = editor.document, editor.find("row_knots.slider")
    start = QPoint(round(slider.width() * slider.value() / 1000), slider.height() // 2)
    QTest.mousePress(slider, LEFT, NONE, start)
    move(slider, start + QPoint(30, 0), NONE)
    editor.settle()
    assert editor.document != before
    if way == "escape":
        QTest.keyClick(slider, Qt.Key.Key_Escape)
    else:
        QTest.mouseClick(slider, RIGHT, NONE, start)
    editor.settle()
    assert editor.document == before
    move(slider, start + QPoint(60, 0), NONE)
    QTest.mouseRelease(slider, LEFT, NONE, start)
    editor.settle()
    assert editor.document == before
    assert steps_done(editor) == 1


def test_every_field_that_is_seen_can_be_dragged(editor):
    seen = [field for field in editor.window.findChildren(QLineEdit) if hasattr(field, "gesture_begun")]
    assert len(seen) > 100
    assert all(field.cursor().shape() == Qt.CursorShape.SizeHorCursor for field in seen if not field.hasFocus())
