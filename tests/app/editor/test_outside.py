"""What happens to the document's file outside, and what is typed and not set: nothing goes without a question."""

import os

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QMessageBox

from qovr_app.window.recovery import recovery_folder
from qovr_core.edits import CoordinatePlace, set_values, value_at
from qovr_core.files import read_document, write_document
from qovr_core.presets import preset
from support.editor import wait_until

FIG5, FIG8 = preset("fig5").document, preset("fig8").document
Z = CoordinatePlace(2, 2, 2)
Button = QMessageBox.StandardButton


@pytest.fixture
def mine(home):
    """A document's file of the test's own."""
    write_document(FIG5, home / "mine.qovr")
    return home / "mine.qovr"


@pytest.fixture
def asked():
    """The texts of the questions that were asked."""
    return []


def answering(asked, button):
    """Answer the next question."""

    def press():
        box = QApplication.activeModalWidget()
        if not isinstance(box, QMessageBox):
            QTimer.singleShot(20, press)
            return
        asked.append(box.text())
        box.button(button).click()

    QTimer.singleShot(0, press)


def change_outside(path, how):
    """Do what another program may do to a file."""
    if how == "written":
        write_document(FIG8, path)
    elif how == "in place":
        path.write_text(path.read_text().replace("0.5", "0.6"))
    elif how == "same size and time":
        before = path.stat()
        other = path.with_suffix(".other")
        other.write_text(path.read_text().replace("0.5", "0.6"))
        os.utime(other, ns=(before.st_atime_ns, before.st_mtime_ns))
        other.replace(path)
    elif how == "deleted":
        path.unlink()


@pytest.mark.parametrize("how", ["written", "in place", "same size and time", "deleted"])
def test_a_file_changed_outside_is_not_replaced_without_a_question(make_editor, mine, asked, how):
    editor = make_editor(str(mine))
    editor.type_into("row_knots.C_0.r", "0.3")
    change_outside(mine, how)
    before = mine.read_bytes() if mine.exists() else None
    answering(asked, Button.Cancel)
    editor.trigger("save")
    assert "mine.qovr was " + ("deleted" if how == "deleted" else "changed") in asked[0]
    assert (mine.read_bytes() if mine.exists() else None) == before
    assert editor.window.isWindowModified()
    answering(asked, Button.Save)
    editor.trigger("save")
    assert read_document(mine) == editor.document
    assert not editor.window.isWindowModified()
    editor.type_into("row_knots.C_0.r", "0.4")
    editor.trigger("save")
    assert len(asked) == 2
    assert read_document(mine) == editor.document


def test_a_folder_in_the_file_s_place_is_refused_in_words(make_editor, mine, asked):
    editor = make_editor(str(mine))
    editor.type_into("row_knots.C_0.r", "0.3")
    mine.unlink()
    mine.mkdir()
    answering(asked, Button.Save)
    editor.trigger("save")
    assert "it is a folder" in editor.message()
    assert editor.window.isWindowModified()


def test_reload_is_offered_and_can_be_undone(make_editor, mine):
    editor = make_editor(str(mine))
    editor.type_into("row_knots.C_0.r", "0.3")
    edited = editor.document
    write_document(FIG8, mine)
    wait_until(lambda: editor.find("outside").isVisible())
    editor.click("outside.reload")
    assert editor.document == FIG8
    assert not editor.window.isWindowModified()
    assert not editor.find("outside").isVisible()
    editor.trigger("undo")
    assert editor.document == edited
    assert editor.window.isWindowModified()


def test_who_keeps_his_own_is_not_asked_again(make_editor, mine):
    editor = make_editor(str(mine))
    write_document(FIG8, mine)
    wait_until(lambda: editor.find("outside").isVisible())
    editor.click("outside.keep")
    assert not editor.find("outside").isVisible()
    assert editor.window.isWindowModified()
    editor.trigger("save")
    assert read_document(mine) == FIG5


def test_two_windows_of_one_file_tell_each_other(make_editor, mine):
    first, second = make_editor(str(mine)), make_editor(str(mine))
    first.type_into("row_knots.C_0.r", "0.3")
    first.trigger("save")
    wait_until(lambda: second.find("outside").isVisible())
    assert not first.find("outside").isVisible()


def test_the_suffix_is_added_before_the_question(editor, home, mine, asked, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(home / "mine"), ""))
    editor.type_into("row_knots.C_0.r", "0.3")
    answering(asked, Button.No)
    editor.trigger("save_as")
    assert "mine.qovr already exists" in asked[0]
    assert read_document(mine) == FIG5
    answering(asked, Button.Yes)
    editor.trigger("save_as")
    assert read_document(mine) == editor.document


@pytest.mark.parametrize("way", ["preset_fig8", "close"])
def test_numbers_that_are_typed_and_not_set_are_asked_about(editor, asked, way):
    editor.trigger("live")
    editor.type_into("control_points.P_2_2.z", "0.7")
    assert editor.window.isWindowModified()
    answering(asked, Button.Cancel)
    editor.trigger(way)
    assert "Numbers are typed that are not set" in asked[0]
    assert editor.window.isVisible()
    assert editor.text("control_points.P_2_2.z") == "0.7"


def test_saving_before_leaving_sets_what_is_typed(make_editor, mine, asked):
    editor = make_editor(str(mine))
    editor.trigger("live")
    editor.type_into("control_points.P_2_2.z", "0.7")
    answering(asked, Button.Save)
    editor.trigger("preset_fig8")
    assert value_at(read_document(mine), Z) == 0.7
    assert editor.document == FIG8


def test_with_live_off_an_opened_document_is_shown(editor):
    editor.trigger("live")
    editor.trigger("preset_fig8")
    assert not editor.find("view.stale").isVisible()
    assert editor.find("surface.export").isEnabled()
    assert editor.window.store.state.evaluation.document == FIG8


def test_typed_numbers_outlive_a_crash(make_editor, mine):
    first = make_editor(str(mine))
    first.trigger("live")
    first.type_into("control_points.P_2_2.z", "0.7")
    QTest.qWait(400)
    for lock in recovery_folder().glob("*.lock"):
        lock.unlink()
    second = make_editor()
    second.click("recovery.restore")
    assert second.document == FIG5
    assert not second.action("live").isChecked()
    assert second.text("control_points.P_2_2.z") == "0.7"
    second.click("control_points.set")
    assert second.document == set_values(FIG5, {Z: 0.7})


def test_a_save_that_fails_closes_nothing(make_editor, mine, asked, monkeypatch):
    editor = make_editor(str(mine))
    editor.type_into("row_knots.C_0.r", "0.3")

    def full(*_):
        raise OSError(28, "No space left on device", str(mine))

    monkeypatch.setattr("qovr_app.window.sources.write_document", full)
    answering(asked, Button.Save)
    editor.window.close()
    editor.settle()
    assert editor.window.isVisible()
    assert "No space left on device" in editor.message()
    assert editor.window.isWindowModified()
    assert read_document(mine) == FIG5
