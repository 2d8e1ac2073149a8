"""Selecting and moving points by commands, through the window."""

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QLineEdit

from qovr_app.state.looking_intents import Selected


def points(editor):
    return editor.document.control_points.copy()


def type_at_focus(editor, text):
    QTest.keyClicks(QApplication.focusWidget(), text)
    editor.settle()


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
    view = editor.window.parts.view_frame
    assert dialog.frameGeometry().left() >= view.mapToGlobal(view.rect().topLeft()).x()  # the numbers stay in sight
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


def test_the_document_is_made_symmetric(editor):
    editor.trigger("symmetric_rows_mean")
    editor.dispatch(Selected((0, 1)))
    editor.trigger("nudge_up")
    editor.trigger("symmetric_columns_first")
    z = points(editor)[..., 2]
    np.testing.assert_array_equal(z, z[:, ::-1])
