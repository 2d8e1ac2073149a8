"""Preferences: chosen once, they hold at once in all windows and at the next start, and never in a written file."""

import subprocess

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QDialog, QLabel

from qovr_app.main import open_windows
from qovr_app.state.display import ColourMap, MouseScheme, ThemeName
from qovr_app.style.digits import digits_in_force
from qovr_app.style.palette import set_theme, theme_in_force
from qovr_app.window.preferences import Preferences
from qovr_app.window.preferences_shell import PREFERENCES, apply_preferences
from support.command import QOVR, environment


@pytest.fixture
def dialog(editor):
    """The dialog, by its key; what was chosen for all windows is as usual again at the end."""
    editor.key(Qt.Key.Key_Comma, Qt.KeyboardModifier.ControlModifier)
    shown = editor.dialog("preferences")
    assert shown.isVisible()
    assert not shown.isModal()
    yield shown
    QTest.mouseClick(shown.findChild(QAbstractButton, "preferences.usual"), Qt.MouseButton.LeftButton)
    set_theme(ThemeName.LIGHT)


def choose(dialog, name, text):
    box = dialog.findChild(QComboBox, f"preferences.{name}")
    index = next(k for k in range(box.count()) if box.itemText(k).startswith(text))
    box.setFocus()
    while box.currentIndex() != index:
        QTest.keyClick(box, Qt.Key.Key_Down if box.currentIndex() < index else Qt.Key.Key_Up)


def test_mouse_and_colours_hold_in_every_window_and_in_the_next(editor, dialog, make_editor):
    second = make_editor("paper:fig8")
    assert second.window.store.state.display.colour_map is ColourMap.CIVIDIS
    choose(dialog, "mouse", "Rhino")
    choose(dialog, "colour_map", "Jet")
    for window in (editor.window, second.window, make_editor().window):
        assert window.store.state.display.mouse is MouseScheme.RHINO
        assert window.store.state.display.colour_map is ColourMap.JET


def test_fewer_digits_are_shown_at_once_and_none_is_lost(dialog, make_editor):
    wide = make_editor(size=(2500, 1400))  # else the columns have no room for more
    wide.type_into("control_points.P_2_2.z", repr(1 / 3), end=Qt.Key.Key_Return)
    field = wide.field("control_points.P_2_2.z")
    wide.field("row_knots.C_0.r").setFocus()
    wide.settle()
    before = field.grab().toImage()
    choose(dialog, "digits", "3")
    wide.settle()
    assert digits_in_force() == 3
    assert field.grab().toImage() != before
    assert float(field.text()) == wide.document.control_points[2, 2, 2] == 1 / 3


def test_the_export_begins_with_unit_and_axis(editor, dialog):
    choose(dialog, "unit", "Inches")
    choose(dialog, "up", "y")
    editor.click("surface.export")
    export = editor.dialog("export")
    assert export.findChild(QComboBox, "export.units").currentData() == "in"
    assert export.findChild(QComboBox, "export.up").currentData() == "y"
    export.close()


def test_the_theme_is_the_systems_or_the_chosen_one(editor, dialog):
    hints = QGuiApplication.styleHints()
    choose(dialog, "theme", "Dark")
    editor.settle()
    assert theme_in_force().name is editor.window.store.state.display.theme is ThemeName.DARK
    hints.colorSchemeChanged.emit(Qt.ColorScheme.Light)  # as when the system becomes light
    assert theme_in_force().name is ThemeName.DARK
    choose(dialog, "theme", "System")
    for scheme, name in ((Qt.ColorScheme.Dark, ThemeName.DARK), (Qt.ColorScheme.Light, ThemeName.LIGHT)):
        hints.colorSchemeChanged.emit(scheme)
        editor.settle()
        assert theme_in_force().name is editor.window.store.state.display.theme is name


def test_what_was_chosen_holds_at_the_next_start_and_nonsense_does_not(editor, dialog):
    choose(dialog, "digits", "4")
    choose(dialog, "theme", "Dark")
    set_theme(ThemeName.LIGHT)
    apply_preferences(Preferences(), open_windows())
    assert theme_in_force().name is ThemeName.DARK
    assert digits_in_force() == 4
    for entry in PREFERENCES:
        Preferences().choose(entry.key, "nonsense")
    apply_preferences(Preferences(), open_windows())
    assert digits_in_force() == 6
    assert editor.window.store.state.display.mouse is MouseScheme.BLENDER


def test_the_command_line_writes_the_same_whatever_is_preferred(dialog, home):
    def export():
        call = [QOVR, "export", "paper:fig5", "a.obj", "--samples", "5"]
        subprocess.run(call, cwd=home, env=environment(), check=True)
        return (home / "a.obj").read_bytes()

    before = export()
    for name, text in (("unit", "Inches"), ("up", "z"), ("digits", "3"), ("colour_map", "Viridis")):
        choose(dialog, name, text)
    assert export() == before
    assert "never change what the command line writes" in dialog.findChild(QLabel, "preferences.note").text()


def test_a_second_call_shows_the_same_dialog(editor, dialog):
    editor.trigger("preferences")
    assert editor.window.findChildren(QDialog, "preferences") == [dialog]
