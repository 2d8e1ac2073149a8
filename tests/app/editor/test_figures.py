"""Figures and drawings are written beside the work: progress, a way out, and a failure said where it was asked for."""

import time

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QAbstractButton, QDialog, QDialogButtonBox, QFileDialog, QLabel, QLineEdit

from support.editor import wait_until

Button = QDialogButtonBox.StandardButton


@pytest.fixture
def figure(editor, monkeypatch):
    """A function that has a figure written to a path, from the view or from the laboratory; returns the dialog."""

    def run(path, source="surface.figure", pixels=None):
        monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(path), ""))
        editor.click(source)
        dialog = editor.dialog("figure")
        if pixels:
            dialog.findChild(object, "figure.unit").setCurrentText("pixels")
            for name in ("figure.width", "figure.height"):
                dialog.findChild(object, name).setValue(pixels)
        dialog.findChild(QDialogButtonBox).button(Button.Save).click()
        return dialog

    return run


def note_of(dialog):
    return dialog.findChild(QLabel, f"{dialog.objectName()}.note").text()


def test_the_window_lives_while_a_figure_is_written(editor, figure, home):
    longest, last = [0.0], [time.perf_counter()]

    def tick():
        now = time.perf_counter()
        longest[0], last[0] = max(longest[0], now - last[0]), now

    timer = QTimer(editor.window, interval=5)
    timer.timeout.connect(tick)
    timer.start()
    figure(home / "large.png", pixels=3000)
    wait_until(lambda: "Wrote" in editor.message(), 60)
    timer.stop()
    assert (home / "large.png").read_bytes().startswith(b"\x89PNG")
    assert longest[0] < 0.5  # a tenth on a machine of its own


def test_a_figure_can_be_cancelled(editor, figure, home):
    dialog = figure(home / "large.png", pixels=8000)
    dialog.findChild(QDialogButtonBox).button(Button.Cancel).click()
    wait_until(lambda: "nothing was written" in note_of(dialog), 60)
    assert list(home.iterdir()) == []
    dialog.reject()
    assert editor.find("surface.figure").isEnabled()


@pytest.mark.parametrize("source", ["surface.figure", "laboratory.curve.figure"])
def test_a_figure_that_fails_says_so_in_its_dialog(editor, figure, home, source):
    editor.trigger("laboratory_curve")
    editor.settle()
    dialog = figure(home / "nowhere" / "a.png", source)
    wait_until(lambda: "does not exist" in note_of(dialog), 60)
    assert dialog.isVisible()
    dialog.reject()


AWKWARD = ["x" * 300, "a/" * 3000, "no\x00thing", "/proc/self/mem/x", ".", "..", "/", "~", "  ", "a\nb", "/dev/null"]


@pytest.mark.parametrize("text", AWKWARD)
def test_no_path_that_is_typed_breaks_the_export_dialog(editor, home, text):
    (home / "loop").symlink_to(home / "loop")
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path = dialog.findChild(QLineEdit, "export.path")
    path.setText(text)
    path.textEdited.emit(path.text())
    start = dialog.findChild(QAbstractButton, "export.start")
    if start.isEnabled():
        start.click()
        wait_until(lambda: editor.window.findChild(QDialog, "export") is None or start.isEnabled(), 60)
    if editor.window.findChild(QDialog, "export") is not None:
        dialog.reject()
    editor.settle()


def test_what_has_come_since_it_was_said_is_said_before_it_is_replaced(editor, home):
    editor.click("surface.export")
    dialog = editor.dialog("export")
    path = dialog.findChild(QLineEdit, "export.path")
    path.setText(str(home / "a.npz"))
    path.textEdited.emit(path.text())
    (home / "a.npz").write_text("somebody else's")
    dialog.findChild(QAbstractButton, "export.start").click()
    assert "will be replaced" in note_of(dialog)
    assert (home / "a.npz").read_text() == "somebody else's"
    dialog.reject()
