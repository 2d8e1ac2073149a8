"""The sizes of the tools in the toolbar, and the planes of symmetry."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QCheckBox, QComboBox, QLabel, QLineEdit

from qovr_app.state.looking_intents import Selected

STEP, RADIUS = "tools.snap_step", "tools.soft_radius"


@pytest.fixture
def editor(shared_editor):
    return shared_editor


def tools(editor):
    return editor.window.store.state.tools


def test_sizes_are_typed_worked_out_and_stepped(editor):
    assert (editor.text(STEP), editor.text(RADIUS)) == ("0.05", "2")
    for text, value in (("0,2", 0.2), ("1/8", 0.125), ("*2", 0.25), ("+0.05", 0.3)):
        editor.type_into(STEP, text, end=Qt.Key.Key_Return)
        assert tools(editor).snap_step == value
        assert float(editor.text(STEP)) == value
    editor.key(Qt.Key.Key_Up, widget=editor.field(STEP))
    assert tools(editor).snap_step == 0.4
    editor.type_into(RADIUS, "3.5")
    assert tools(editor).soft_radius == 3.5
    assert editor.window.store.state.history.index == 0


@pytest.mark.parametrize("text", ["0", "-1", "abc", "1,234.5", "1e13"])
def test_what_is_no_size_is_refused_where_it_stands(editor, text):
    editor.type_into(STEP, text)
    assert tools(editor).snap_step == 0.05
    assert editor.message().startswith("the snap step is ")
    said = [label.text() for label in editor.window.findChildren(QLabel, "field.error") if label.isVisible()]
    assert [text.lower() for text in said] == [editor.message()]
    editor.type_into(STEP, "0.05")
    assert not [label for label in editor.window.findChildren(QLabel, "field.error") if label.isVisible()]
    assert editor.message() == ""


def test_a_nudge_and_a_soft_move_go_by_them(editor):
    editor.type_into(STEP, "0.125")
    editor.type_into(RADIUS, "3")
    for name in ("snap", "soft"):
        editor.trigger(name)
    before = editor.document.control_points
    editor.dispatch(Selected((2, 2)))
    editor.trigger("nudge_up")
    moved = (editor.document.control_points - before)[..., 2]
    assert moved[2, 2] == pytest.approx(0.125)
    assert moved[2, 0] == pytest.approx(0.125 * (3 * (1 / 3) ** 2 - 2 * (1 / 3) ** 3))
    assert moved[1, 0] == 0


def test_both_are_remembered(make_editor):
    first = make_editor()
    first.type_into(STEP, "0.3", end=Qt.Key.Key_Return)
    first.type_into(RADIUS, "4", end=Qt.Key.Key_Return)
    second = make_editor()
    assert (second.text(STEP), second.text(RADIUS)) == ("0.3", "4")
    assert (tools(second).snap_step, tools(second).soft_radius) == (0.3, 4.0)


def ask(editor):
    editor.trigger("symmetry_planes")
    return editor.dialog("symmetry")


def test_a_plane_of_symmetry_has_an_axis_and_a_place(editor):
    dialog = ask(editor)
    place, middle = (
        dialog.findChild(QLineEdit, "symmetry.columns.place"),
        dialog.findChild(QCheckBox, "symmetry.columns.middle"),
    )
    assert (place.text(), middle.isChecked()) == ("2", True)
    place.setFocus()
    place.selectAll()
    QTest.keyClicks(place, "5/2")
    assert not middle.isChecked()
    QTest.keyClick(place, Qt.Key.Key_Return)
    editor.settle()
    editor.trigger("symmetric_columns_first")
    x = editor.document.control_points[..., 0]
    np.testing.assert_array_equal(x[0], [0, 1, 2.5, 4, 5])
    np.testing.assert_array_equal(x, np.tile(x[0], (5, 1)))


def test_across_another_axis_moves_are_mirrored_there(editor):
    dialog = ask(editor)
    dialog.findChild(QComboBox, "symmetry.columns.axis").setCurrentIndex(1)
    dialog.accept()
    editor.settle()
    editor.trigger("symmetry_columns")
    before = editor.document.control_points
    editor.type_into("control_points.P_1_0.y", "1.5", end=Qt.Key.Key_Return)
    editor.type_into("control_points.P_1_0.x", "0.25", end=Qt.Key.Key_Return)
    moved = editor.document.control_points - before
    assert moved[1, 4].tolist() == [0.25, -0.5, 0]
    assert np.count_nonzero(moved) == 4


def test_a_place_that_is_no_number_is_not_accepted(editor):
    dialog = ask(editor)
    dialog.findChild(QCheckBox, "symmetry.rows.middle").setChecked(False)
    place = dialog.findChild(QLineEdit, "symmetry.rows.place")
    place.setFocus()
    place.selectAll()
    QTest.keyClicks(QApplication.focusWidget(), "abc")
    assert "abc" in dialog.findChild(QLabel, "symmetry.note").text()
    QTest.keyClick(place, Qt.Key.Key_Return)
    assert dialog.isVisible()
    dialog.reject()
    assert tools(editor).mirror_rows.at is None
