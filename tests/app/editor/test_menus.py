"""File, Edit and Help: new documents, copies, the history's list, the palette, and what the program says of itself."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QListWidget, QMenu, QTextBrowser

from qovr_app.state.intent_text import intent_of
from qovr_app.state.intents import Opened
from qovr_app.state.looking_intents import Selected
from qovr_core import Formulation
from qovr_core.files import read_source
from qovr_core.presets import preset
from qovr_core.shapes import shape


@pytest.mark.parametrize("name", ["paper", "flat", "dome", "saddle", "wave"])
def test_new_documents_interpolate(editor, name):
    editor.trigger(f"new_{name}")
    assert editor.document.formulation == Formulation.INTERPOLATING
    assert not editor.window.store.state.is_changed
    assert not editor.window.store.state.is_stale
    if name == "paper":
        np.testing.assert_array_equal(editor.document.control_points, preset("fig5").document.control_points)


def test_a_copy_is_saved_and_the_document_stays_where_it_is(editor, tmp_path, monkeypatch):
    editor.dispatch(Selected((2, 2)))
    editor.trigger("nudge_up")
    before = editor.window.store.state
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_args, **_more: (str(tmp_path / "copy.qovr"), ""))
    monkeypatch.setattr("qovr_app.window.document_shell.ask_for_target", lambda *_args: tmp_path / "copy.qovr")
    editor.trigger("save_copy")
    assert read_source(str(tmp_path / "copy.qovr")) == editor.document
    assert editor.window.store.state.file is before.file
    assert editor.window.store.state.is_changed


def test_points_are_copied_and_pasted_as_a_table(editor):
    editor.dispatch(Selected((2, 2), ((1, 3), (0, 1))))
    editor.trigger("copy")
    assert QGuiApplication.clipboard().text() == "1\t0\t0.4\n3\t1\t0.45\n2\t2\t0.5\n"
    QGuiApplication.clipboard().setText("1\t0\t9\n3\t1\t8\n2\t2\t7\n")
    editor.trigger("paste")
    assert [editor.document.control_points[i, j, 2] for i, j in ((0, 1), (1, 3), (2, 2))] == [9, 8, 7]
    document = editor.document
    QGuiApplication.clipboard().setText("1\t2\n3\t4\n")
    editor.trigger("paste")
    assert editor.document is document
    assert "3 x 3, a row for each selected point, row 0 of the net first" in editor.message()


def test_the_history_is_a_list_to_go_to_a_step(editor):
    start = editor.document
    editor.dispatch(Selected((2, 2), ((1, 1),)))
    for name in ("smooth_points", "flatten_height", "align_x"):
        editor.trigger(name)
    menu = editor.find("menu.history", QMenu)
    menu.aboutToShow.emit()
    texts = [action.text() for action in menu.actions()]
    assert texts == ["As opened", "Smooth 2 points", "Flatten 2 points", "Align 2 points"]
    assert [action.isChecked() for action in menu.actions()] == [False, False, False, True]
    menu.actions()[0].trigger()
    editor.settle()
    assert editor.document == start
    menu.aboutToShow.emit()
    menu.actions()[2].trigger()
    editor.settle()
    assert editor.action("undo").text() == "&Undo Flatten 2 points"
    assert editor.action("redo").text() == "&Redo Align 2 points"


def palette(editor, text):
    editor.trigger("palette")
    QTest.keyClicks(QApplication.focusWidget(), text)
    editor.settle()
    found = editor.find("palette.matches", QListWidget)
    return [found.item(row).text() for row in range(found.count())]


def test_the_palette_finds_and_does_a_command_by_the_keyboard_alone(editor):
    assert palette(editor, "colu symm")[0].startswith("Symmetry across columns")
    editor.key(Qt.Key.Key_Return)
    assert editor.window.store.state.tools.symmetry_columns
    lines = palette(editor, "top")
    assert lines[0].startswith("Top")
    editor.key(Qt.Key.Key_Escape)
    assert editor.window.findChildren(QListWidget, "palette.matches") == []


def test_the_palette_says_what_a_command_needs_and_does_it_not(editor):
    document = editor.document
    lines = palette(editor, "smooth neighbours")
    assert len(lines) == 1
    assert lines[0].endswith("Select a control point first")
    editor.key(Qt.Key.Key_Return)
    assert editor.find("palette.matches", QListWidget).isVisible()
    assert editor.document is document
    editor.key(Qt.Key.Key_Escape)


def test_the_palette_lists_every_other_command(editor):
    actions = editor.window._actions
    commands = [command for command in actions.commands if command.name != "palette"]
    shown = [command for command in commands if actions[command.name].isVisible()]
    assert {command.name for command in commands} - {command.name for command in shown} == {
        "link_windows",
        "window_next_u",
        "window_previous_u",
        "window_next_v",
        "window_previous_v",
    }  # one window is no net
    assert len(palette(editor, "")) == len(shown)
    editor.key(Qt.Key.Key_Escape)


def test_the_palette_lists_first_what_can_be_done_and_was_done_last(editor):
    editor.trigger("camera_top")
    editor.trigger("camera_front")
    lines = palette(editor, "")
    assert [line.split("   ")[0] for line in lines[:2]] == ["Front", "Top"]
    matches = editor.find("palette.matches", QListWidget)
    actions = [editor.action(matches.item(row).data(Qt.ItemDataRole.UserRole)) for row in range(matches.count())]
    enabled = [action.isEnabled() for action in actions]
    assert enabled == sorted(enabled, reverse=True)
    assert not all(enabled)
    assert matches.currentRow() == 0
    editor.key(Qt.Key.Key_Down)
    assert matches.currentRow() == 1
    editor.key(Qt.Key.Key_Escape)


def test_the_palette_does_nothing_before_anything_is_asked_for(make_editor):
    editor = make_editor(None)
    editor.window._actions.used.clear()
    document = editor.document
    palette(editor, "")
    assert editor.find("palette.matches", QListWidget).currentRow() == -1
    editor.key(Qt.Key.Key_Return)
    assert editor.document is document
    assert editor.find("palette.matches", QListWidget).isVisible()
    editor.key(Qt.Key.Key_Escape)


def test_keys_and_versions_are_shown(editor):
    editor.trigger("keys")
    text = editor.find("keys.text", QTextBrowser).toPlainText()
    for key, command in (("Ctrl+Z", "Undo"), ("Ctrl+M", "Move, scale, rotate"), ("Alt+PgUp", "z + one step")):
        assert key in text
        assert command in text
    editor.trigger("about")
    assert "PySide6" in editor.find("about.text", QTextBrowser).toPlainText()


def test_the_citation_and_a_report_are_copied(editor):
    editor.trigger("citation")
    assert QGuiApplication.clipboard().text().startswith("@misc{qovr,")
    editor.dispatch(Selected((2, 2)))
    editor.trigger("nudge_up")
    editor.trigger("report")
    versions, _, session = QGuiApplication.clipboard().text().partition("\n\n")
    assert versions.startswith("QOVR Studio")
    kinds = [type(intent_of(line)).__name__ for line in session.splitlines()]
    assert kinds[0] == "Configured"
    assert "PointsNudged" in kinds


@pytest.mark.parametrize(
    ("focus", "heading"),
    [
        ("row_knots.C_2.u", "Row-wise knots"),
        ("control_points.P_1_3.z", "Control points"),
        ("surface.samples_u", "Surface"),
        ("view", "The view"),
        ("net.map", "Nets"),
    ],
)
def test_f1_helps_with_what_has_the_keyboard(editor, focus, heading):
    if focus == "net.map":
        editor.dispatch(Opened(shape("hood").document(), "hood"))
    if focus == "view":
        editor.trigger("go_view")
    else:
        editor.find(focus).setFocus()
    editor.settle()
    editor.key(Qt.Key.Key_F1)
    text = editor.find("help.text", QTextBrowser)
    line = text.cursorForPosition(text.viewport().rect().topLeft() + QPoint(40, 12)).block().text()
    assert line.startswith(heading)


def test_the_page_of_keys_has_those_of_the_hand_too(editor):
    editor.trigger("keys")
    text = editor.find("keys.text", QTextBrowser).toPlainText()
    assert "While a point is dragged" in text
    assert "Preferences" in text
