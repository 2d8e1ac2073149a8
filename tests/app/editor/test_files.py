"""Open, save, recent, drop, export and figures, as a user meets them."""

import json
import os

import numpy as np
import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDialog,
    QFileDialog,
    QLabel,
    QLineEdit,
    QMenu,
    QMessageBox,
    QTreeWidget,
)

from qovr_core import configure
from qovr_core.files import FORMATS, ExportOptions, export, read_document, write_document
from qovr_core.presets import preset
from support.documents import random_document
from support.editor import wait_until

FIG5 = preset("fig5").document


@pytest.fixture
def names(monkeypatch):
    """What the system's file dialogs answer, one after the other."""
    answers = []

    def answer(*_arguments):
        return str(answers.pop(0)), ""

    monkeypatch.setattr(QFileDialog, "getOpenFileName", answer)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", answer)
    return answers


def answer_question(button):
    """Press a button of the next message box."""

    def press():
        box = QApplication.activeModalWidget()
        assert isinstance(box, QMessageBox)
        QTest.mouseClick(box.button(button), Qt.MouseButton.LeftButton)

    QTimer.singleShot(50, press)


def drop(editor, path):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    what = (Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier)
    for kind in (QDragEnterEvent, QDropEvent):
        QApplication.sendEvent(editor.window, kind(QPoint(9, 9), *what))
    editor.settle()


def test_save_as_open_and_recent(editor, home, names):
    editor.type_into("row_knots.C_0.r", "0.3")
    assert editor.window.isWindowModified()
    names.append(home / "mine")
    editor.trigger("save_as")
    assert read_document(home / "mine.qovr") == editor.document
    assert not editor.window.isWindowModified()
    assert editor.window.windowTitle() == "mine.qovr[*] - QOVR Studio"
    editor.trigger("preset_fig8")
    assert editor.document == preset("fig8").document
    menu = editor.find("menu.recent", QMenu)
    menu.aboutToShow.emit()
    menu.actions()[0].trigger()
    editor.settle()
    assert editor.document.row_knots[0, 0].r == 0.3
    editor.type_into("row_knots.C_0.r", "0.4")
    editor.trigger("save")
    assert read_document(home / "mine.qovr").row_knots[2, 0].r == 0.4


def test_unsaved_changes_are_asked_about(editor):
    editor.type_into("row_knots.C_0.r", "0.3")
    answer_question(QMessageBox.StandardButton.Cancel)
    editor.trigger("preset_fig8")
    assert editor.document.row_knots[0, 0].r == 0.3
    answer_question(QMessageBox.StandardButton.Discard)
    editor.trigger("preset_fig8")
    assert editor.document == preset("fig8").document


def test_what_cannot_be_opened_changes_nothing(editor, home, names):
    (home / "bad.qovr").write_text('{"format": "qovr-document", "version": 9}')
    names.append(home / "bad.qovr")
    editor.trigger("open")
    assert editor.document == FIG5
    assert "a newer program wrote this file" in editor.message()


def test_a_dropped_file_is_opened(editor, home):
    write_document(random_document(5), home / "dropped.qovr")
    drop(editor, home / "dropped.qovr")
    assert editor.document == random_document(5)
    assert editor.disagreements() == []


def test_opening_drops_what_was_typed_and_refused(editor):
    editor.type_into("row_knots.C_0.r", "7")
    editor.trigger("preset_fig8")
    assert editor.text("row_knots.C_0.r") == "0.5"
    assert editor.disagreements() == []


@pytest.mark.parametrize("suffix", [*FORMATS])
def test_every_format_is_offered_with_what_it_keeps(editor, home, suffix):
    editor.type_into("surface.samples_u", "11")
    editor.click("surface.export")
    dialog = editor.dialog("export")
    tree = dialog.findChild(QTreeWidget, "export.format")
    rows = {tree.topLevelItem(k).text(1): tree.topLevelItem(k) for k in range(tree.topLevelItemCount())}
    assert set(rows) == set(FORMATS)
    tree.setCurrentItem(rows[suffix])
    assert dialog.findChild(QLabel, "export.keeps").text() == FORMATS[suffix].keeps
    assert dialog.findChild(QLabel, "export.loses").text() == (FORMATS[suffix].loses or "nothing")
    assert dialog.findChild(QComboBox, "export.layer").isVisible() == FORMATS[suffix].holds_one_layer
    assert dialog.findChild(QLineEdit, "export.tolerance").isVisible() == FORMATS[suffix].is_mesh
    assert dialog.findChild(QLineEdit, "export.path").text().endswith(suffix)
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    editor.settle()
    editor.export_to(home / f"out{suffix}")
    assert (home / f"out{suffix}").is_file()
    assert f"out{suffix}" in editor.message()


def test_exported_arrays_are_those_of_the_document(editor, home):
    editor.type_into("surface.samples_u", "11")
    editor.choose("surface.formulation", "interpolating")
    editor.export_to(home / "out.npz")
    assert np.array_equal(np.load(home / "out.npz")["raw"], configure(editor.document).raw)


def test_a_cancelled_export_leaves_nothing(editor, home):
    editor.type_into("surface.samples_u", "800")
    editor.type_into("surface.samples_v", "800")
    (home / "big.csv").write_text("as it was")
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path = dialog.findChild(QLineEdit, "export.path")
    path.selectAll()
    QTest.keyClicks(path, str(home / "big.csv"))
    assert "replaced" in dialog.findChild(QLabel, "export.note").text()
    QTest.mouseClick(dialog.findChild(QAbstractButton, "export.start"), Qt.MouseButton.LeftButton)
    bar = dialog.findChild(object, "export.progress")
    wait_until(lambda: bar.value() > 0)
    QTest.mouseClick(dialog.findChild(QAbstractButton, "export.cancel"), Qt.MouseButton.LeftButton)
    wait_until(lambda: "nothing was written" in dialog.findChild(QLabel, "export.note").text())
    assert [entry.name for entry in home.iterdir()] == ["big.csv"]
    assert (home / "big.csv").read_text() == "as it was"
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert not dialog.isVisible()


def test_an_export_that_fails_says_why(editor, home):
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path = dialog.findChild(QLineEdit, "export.path")
    path.selectAll()
    QTest.keyClicks(path, str(home / "nowhere" / "a.csv"))
    QTest.mouseClick(dialog.findChild(QAbstractButton, "export.start"), Qt.MouseButton.LeftButton)
    note = dialog.findChild(QLabel, "export.note")
    wait_until(lambda: "does not exist" in note.text())
    QTest.keyClick(dialog, Qt.Key.Key_Escape)


def test_save_figure_writes_what_is_seen(editor, home, names):
    names.append(home / "seen.png")
    editor.click("surface.figure")
    dialog = next(box for box in editor.window.findChildren(QDialog) if box.windowTitle() == "Save Figure")
    buttons = {button.text().replace("&", ""): button for button in dialog.findChildren(QAbstractButton)}
    QTest.mouseClick(buttons["Save"], Qt.MouseButton.LeftButton)
    wait_until((home / "seen.png").is_file)
    assert (home / "seen.png").read_bytes().startswith(b"\x89PNG")


def test_settings_are_remembered(make_editor, home):
    first = make_editor(size=(1300, 760))
    first.trigger("style_wireframe")
    first.trigger("show_labels")
    usual = first.window.parts.sizes()
    first.drag_handle("workspace", 60)
    sizes = first.window.parts.sizes()
    assert sizes != usual
    first.window.close()
    second = make_editor(size=(1300, 760))
    assert second.action("style_wireframe").isChecked()
    assert not second.action("show_labels").isChecked()
    assert second.window.parts.sizes() == sizes
    assert second.action("live").isChecked()


def test_damaged_settings_count_as_never_set(make_editor, home):
    from qovr_app.window.preferences import Preferences

    preferences = Preferences()
    preferences._store.setValue("view/style", "baroque")
    preferences._store.setValue("folder", "relative/nonsense")
    preferences._store.setValue("window/geometry", "text")
    preferences._store.setValue("recent", [str(home / "gone.qovr")])
    editor = make_editor()
    assert editor.action("style_facets").isChecked()
    menu = editor.find("menu.recent", QMenu)
    menu.aboutToShow.emit()
    menu.actions()[0].trigger()
    editor.settle()
    assert "gone.qovr: cannot be read" in editor.message()
    assert editor.document == FIG5


def test_the_inputs_beside_a_csv_are_the_document(editor, home):
    editor.type_into("surface.samples_u", "5")
    editor.export_to(home / "t.csv")
    assert json.loads((home / "t.inputs.json").read_text())["document"]["samples"] == [5, 101]


def test_what_is_just_being_typed_is_saved(editor, home, names):
    names.append(home / "typed.qovr")
    editor.type_into("row_knots.C_0.r", "0.3", end=None)
    editor.key(Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
    assert {knots.r for knots in read_document(home / "typed.qovr").row_knots.in_window(0)} == {0.3}


def test_what_a_format_cannot_hold_is_said_before_any_work(editor):
    for parameter in "uv":
        editor.type_into(f"surface.samples_{parameter}", "2000")
    editor.click("surface.export")
    dialog = editor.dialog("export")
    assert "the rows of one sheet" in dialog.findChild(QLabel, "export.note").text()
    assert not dialog.findChild(QAbstractButton, "export.start").isEnabled()
    QTest.keyClick(dialog, Qt.Key.Key_Escape)


def test_a_surface_that_overflows_is_no_surface(editor):
    before = editor.document
    editor.trigger("link_directions")
    editor.type_into("column_knots.K_0.r", "1e-200")
    assert "no finite coordinates" in editor.message()
    assert editor.document == before
    assert not editor.action("undo").isEnabled()
    field = editor.field("column_knots.K_0.r")
    assert (field.text(), field.has_own_text) == ("1e-200", True)
    assert "no finite coordinates" in field.error
    assert editor.find("surface.export").isEnabled()
    editor.type_into("column_knots.K_0.r", "0.4")
    assert editor.message() == ""
    assert not editor.find("message").toolTip()
    assert editor.document.row_knots[4, 0].r == 0.4


def test_staged_a_surface_that_overflows_is_refused_when_it_is_set(editor):
    editor.trigger("live")
    editor.trigger("link_directions")
    editor.type_into("column_knots.K_0.r", "1e-200")
    editor.click("row_knots.set")
    editor.click("column_knots.set")
    assert "no finite coordinates" in editor.message()
    assert editor.document.column_knots == FIG5.column_knots
    assert editor.field("column_knots.K_0.r").is_pending
    editor.click("surface.configure")
    assert editor.find("surface.export").isEnabled()


def test_choices_of_a_mesh_are_taken_and_checked(editor, home):
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path, tolerance = (dialog.findChild(QLineEdit, f"export.{name}") for name in ("path", "tolerance"))
    path.selectAll()
    QTest.keyClicks(path, str(home / "mesh.ply"))
    start = dialog.findChild(QAbstractButton, "export.start")
    for typed in ("0", "-1", "x"):
        tolerance.selectAll()
        QTest.keyClicks(tolerance, typed)
        assert not start.isEnabled()
        assert "positive number" in dialog.findChild(QLabel, "export.note").text()
    tolerance.selectAll()
    QTest.keyClicks(tolerance, "0,01")
    assert start.isEnabled()
    dialog.findChild(QComboBox, "export.layer").setCurrentText("raw")
    QTest.mouseClick(start, Qt.MouseButton.LeftButton)
    wait_until((home / "mesh.ply").is_file)
    wait_until(lambda: "mesh.ply" in editor.message())
    assert (home / "mesh.ply").stat().st_size < 101 * 101 * 12


@pytest.mark.parametrize(
    ("name", "choice", "value", "suffix"),
    [("units", "unit", "in", ".step"), ("up", "up", "z", ".obj"), ("csv_dialect", "csv_dialect", "semicolon", ".csv")],
)
def test_the_conventions_of_an_export_are_offered_taken_and_remembered(make_editor, home, name, choice, value, suffix):
    from qovr_app.window.preferences import Preferences

    def opened(editor):
        editor.click("surface.export")
        dialog = editor.dialog("export")
        path = dialog.findChild(QLineEdit, "export.path")
        path.selectAll()
        QTest.keyClicks(path, str(home / f"a{suffix}"))
        return dialog, dialog.findChild(QComboBox, f"export.{name}")

    first = make_editor()
    dialog, box = opened(first)
    assert box.isVisible()
    assert box.currentData() != value
    box.setCurrentIndex(box.findData(value))
    QTest.mouseClick(dialog.findChild(QAbstractButton, "export.start"), Qt.MouseButton.LeftButton)
    wait_until(lambda: f"a{suffix}" in first.message())
    export(first.document, home / f"b{suffix}", ExportOptions(**{choice: value}))
    written, expected = ((home / f"{stem}{suffix}").read_text().splitlines()[12:] for stem in "ab")
    assert len(written) == len(expected)
    assert [line for line in written if "'a'" not in line] == [line for line in expected if "'b'" not in line]
    first.window.close()
    second = make_editor()
    dialog, box = opened(second)
    assert box.currentData() == value
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    Preferences()._store.setValue(f"export/{choice}", "nonsense")
    assert Preferences().conventions == ExportOptions()


@pytest.mark.parametrize(("typed", "suffix"), [("a.stp", ".step"), ("a.IGS", ".iges")])
def test_other_names_of_a_format_choose_it(editor, home, typed, suffix):
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path = dialog.findChild(QLineEdit, "export.path")
    path.selectAll()
    QTest.keyClicks(path, str(home / typed))
    assert dialog.findChild(QTreeWidget, "export.format").currentItem().text(1) == suffix
    QTest.mouseClick(dialog.findChild(QAbstractButton, "export.start"), Qt.MouseButton.LeftButton)
    wait_until((home / typed).is_file)


def test_who_becomes_the_owner_of_a_file_is_told(editor, home, names, monkeypatch):
    path = home / "somebody_s.qovr"
    write_document(editor.document, path)
    try:
        os.chown(path, 12345, 12345)
    except OSError:
        pytest.skip("only root can give a file away")

    def refuse(*_):
        raise PermissionError

    monkeypatch.setattr(os, "chown", refuse)
    names.append(path)
    editor.trigger("save_as")
    assert "belongs to you now" in editor.message()
    assert path.stat().st_uid == os.geteuid()
