"""Selecting and moving points by commands, through the window."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDialog, QLineEdit

from qovr_app.state.looking_intents import Selected


def points(editor):
    return editor.document.control_points.copy()


def type_at_focus(editor, text):
    QTest.keyClicks(QApplication.focusWidget(), text)
    editor.settle()


def test_the_bump_is_raised_by_exactly_a_tenth_in_few_keys(editor):
    before = points(editor)
    editor.dispatch(Selected((2, 2)))
    editor.trigger("transform_points")
    editor.dialog("transform")
    type_at_focus(editor, "0.1")
    editor.key(Qt.Key.Key_Return)
    assert editor.window.findChild(QDialog, "transform") is None
    difference = points(editor) - before
    assert difference[2, 2].tolist() == [0, 0, before[2, 2, 2] + 0.1 - before[2, 2, 2]]
    assert np.count_nonzero(difference) == 1
    assert editor.window.store.state.history.index == 1
    editor.trigger("undo")
    np.testing.assert_array_equal(points(editor), before)


def test_numbers_that_are_none_are_not_accepted_and_escape_changes_nothing(editor):
    before = points(editor)
    editor.dispatch(Selected((2, 2), ((1, 1),)))
    editor.trigger("transform_points")
    dialog = editor.dialog("transform")
    assert dialog.windowTitle() == "Transform 2 points"
    type_at_focus(editor, "abc")
    editor.key(Qt.Key.Key_Return)
    assert dialog.isVisible()
    assert "abc" in editor.find("transform.note").text()
    editor.key(Qt.Key.Key_Escape)
    np.testing.assert_array_equal(points(editor), before)


def test_a_transform_is_seen_at_once_and_put_back_exactly(editor):
    editor.dispatch(Selected((2, 2), ((1, 1),)))
    editor.trigger("nudge_up")
    editor.trigger("undo")
    before, redo = editor.document, editor.action("redo").text()
    editor.trigger("transform_points")
    dialog = editor.dialog("transform")
    note = editor.find("transform.note")
    assert "Mean of 2 points: x 1.5, y 1.5" in note.text()
    type_at_focus(editor, "1/4")
    assert editor.document.control_points[2, 2, 2] == before.control_points[2, 2, 2] + 0.25
    assert editor.window.view.shown.evaluation.document == editor.document
    assert "(+0.25)" in note.text()
    scale = dialog.findChild(QLineEdit, "transform.scale.x")
    scale.setFocus()
    scale.selectAll()
    type_at_focus(editor, "3")
    assert editor.document.control_points[1, 1, 0] == 0
    dialog.findChild(QComboBox, "transform.about").setCurrentIndex(1)
    assert editor.document.control_points[1, 1, 0] == -1
    assert editor.document.control_points[2, 2, 0] == 2
    dialog.reject()
    editor.settle()
    assert editor.document is before
    assert editor.action("redo").text() == redo
    assert editor.window.store.state.gesture is None


def test_a_transform_that_no_document_can_hold_is_said_in_the_dialog(editor):
    editor.dispatch(Selected((2, 2)))
    editor.trigger("transform_points")
    editor.dialog("transform")
    type_at_focus(editor, "1e12*1")
    type_at_focus(editor, "0")
    assert "expected a finite number" in editor.find("transform.note").text()
    editor.key(Qt.Key.Key_Return)
    assert editor.dialog("transform").isVisible()
    editor.dialog("transform").reject()


@pytest.mark.parametrize(
    ("command", "count"),
    [("select_all", 25), ("select_rows", 10), ("select_columns", 10), ("select_invert", 23), ("select_none", 0)],
)
def test_what_is_selected(editor, command, count):
    editor.dispatch(Selected((2, 2), ((1, 3),)))
    editor.trigger(command)
    selection = editor.window.store.state.selection
    assert len(selection.points) == count
    if command in ("select_rows", "select_columns", "select_all"):
        assert selection.last == (2, 2)


def test_commands_of_points_wait_for_a_selection_and_repeat(editor):
    names = ["transform_points", "flatten_height", "align_z", "smooth_points", "nudge_up", "select_rows", "repeat"]
    assert not any(editor.action(name).isEnabled() for name in names)
    editor.dispatch(Selected((2, 2), ((1, 3), (3, 1))))
    assert [editor.action(name).isEnabled() for name in names] == [True] * 6 + [False]
    editor.trigger("smooth_points")
    assert editor.action("undo").text() == "&Undo Smooth 3 points"
    editor.dispatch(Selected((1, 1), ((1, 2),)))
    assert editor.action("repeat").text() == "Rep&eat Smooth"
    editor.trigger("repeat")
    assert editor.action("undo").text() == "&Undo Smooth 2 points"


def test_nudges_are_one_undo_and_follow_the_step(editor):
    before = points(editor)
    editor.dispatch(Selected((2, 2)))
    for _ in range(3):
        editor.key(Qt.Key.Key_PageUp, Qt.KeyboardModifier.AltModifier, editor.window)
    assert points(editor)[2, 2, 2] - before[2, 2, 2] == pytest.approx(0.03)
    editor.trigger("undo")
    np.testing.assert_array_equal(points(editor), before)
    editor.trigger("snap")
    editor.key(Qt.Key.Key_Left, Qt.KeyboardModifier.AltModifier, editor.window)
    assert points(editor)[2, 2, 0] - before[2, 2, 0] == pytest.approx(-0.05)


def test_the_document_is_made_symmetric(editor):
    editor.trigger("symmetric_rows_mean")
    editor.dispatch(Selected((0, 1)))
    editor.trigger("nudge_up")
    editor.trigger("symmetric_columns_first")
    z = points(editor)[..., 2]
    np.testing.assert_array_equal(z, z[:, ::-1])
