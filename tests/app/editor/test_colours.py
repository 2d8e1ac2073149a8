"""Colours, reference and probe by the window's commands: what they ask, remember and say."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QDialogButtonBox, QLabel, QLineEdit, QMenu, QToolBar, QToolButton

from qovr_app.state.display import ColourRange
from qovr_app.view3d.scene.grid import Grid
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_core.edits import Direction, KnotPlace
from qovr_core.fields import FIELDS, Field
from support.view import change


@pytest.fixture
def editor(shared_editor):
    return shared_editor


def colouring(editor):
    return editor.window.view.picture().colouring


@pytest.mark.parametrize("by", list(colour_sources()))
def test_every_command_of_colour_by_chooses_it_alone(editor, by):
    editor.trigger(f"colour_by_{by}")
    assert editor.window.view.shown.settings.colour_by == by
    assert [other for other in colour_sources() if editor.action(f"colour_by_{other}").isChecked()] == [by]
    assert editor.action(f"colour_by_{by}").statusTip()


def slope_field():
    """A field that the program does not know: how steep the surface is."""

    def values(surface, u, v, _beside):
        return np.abs(surface.normals(u, v)[..., 2])

    return Field(
        "steepness", "Part upward n_z", "n_z", "S&teepness", "Colours say the upward part of the normal", values
    )


def test_a_field_from_outside_is_in_menu_bar_colours_and_dialog_by_its_record(make_editor):
    with FIELDS.register(slope_field()) as field:
        editor = make_editor()
        action = editor.action("colour_by_steepness")
        assert (action.text(), action.statusTip()) == (field.text, field.tip)
        assert [action.objectName() for action in editor.action("colour_by_height").actionGroup().actions()] == [
            f"colour_by_{name}" for name in colour_sources()
        ]
        assert any(action in menu.actions() for menu in editor.window.findChildren(QMenu, "menu.view/colour by"))
        assert any(action in button.menu().actions() for button in menus_of(editor.find("view_bar", QToolBar)))
        editor.trigger("colour_by_steepness")
        scene, shown = editor.window.view.picture().scene, colouring(editor)
        assert shown.title == "Part upward n_z"
        values = shown.values(Grid((8,), (6,)))
        grid = np.linspace(0, 1, 9), np.linspace(0, 1, 7)
        assert values == pytest.approx(np.abs(scene.surface.normals(*grid)[..., 2]), abs=1e-12)
        titles = []
        QTimer.singleShot(0, lambda: titles.extend(closed_dialog(editor)))
        editor.trigger("colour_range_fixed")
        assert field.title in titles
        editor.window.close()


def menus_of(bar):
    return [button for button in bar.findChildren(QToolButton) if button.menu() is not None]


def closed_dialog(editor):
    """Close the range dialog; return the texts it showed."""
    dialog = editor.dialog("colour_range")
    texts = [label.text() for label in dialog.findChildren(QLabel)]
    dialog.reject()
    return texts


def test_pinning_shows_the_distance_from_what_was_pinned(editor):
    editor.trigger("colour_by_distance")
    assert colouring(editor).note == Field.DISTANCE.missing
    editor.trigger("pin_reference")
    assert "Pinned the transformed surface of fig5 (published)" in editor.message()
    assert colouring(editor).limits[1] < 1e-9
    editor.type_into("control_points.P_4_2.z", "0.6")
    assert colouring(editor).limits[1] > 0.01
    assert colouring(editor).title == "Distance from fig5, published"
    editor.trigger("undo")
    assert colouring(editor).limits[1] > 0.01  # a colour means the same after an edit as before it
    editor.trigger("fit")
    assert colouring(editor).limits[1] < 1e-9
    editor.choose("surface.formulation", "interpolating")
    assert colouring(editor).limits[1] > 0.01
    editor.mark_saved()  # or it would ask about what is unsaved
    editor.trigger("preset_fig8")
    assert colouring(editor).title == "Distance from fig5, published"
    editor.trigger("unpin_reference")
    assert colouring(editor).note == Field.DISTANCE.missing
    assert "no reference" in editor.message()


def test_with_both_layers_the_one_on_the_net_is_pinned(editor):
    editor.trigger("layer_both")
    editor.trigger("pin_reference")
    assert "the transformed surface" in editor.message()
    editor.choose("surface.formulation", "interpolating")
    editor.trigger("pin_reference")
    assert "the raw surface" in editor.message()


def test_the_sensitivity_is_that_of_the_knot_whose_field_had_the_keyboard_last(editor):
    editor.field("control_points.P_0_0.x").setFocus()
    editor.trigger("colour_by_sensitivity")
    change(editor.window.view, knot=None)  # however the window chose its first focus
    assert colouring(editor).note == Field.SENSITIVITY.missing
    editor.field("row_knots.C_4.s").setFocus()
    editor.settle()
    assert colouring(editor).title == "Sensitivity |∂S/∂s_ip of C_4|"
    assert editor.window.view.picture().scene.companions.knot == KnotPlace(Direction.ROWS, 4, "s")
    editor.field("control_points.P_0_0.x").setFocus()
    editor.settle()
    assert colouring(editor).title == "Sensitivity |∂S/∂s_ip of C_4|"
    editor.field("row_knots.C_1.r").setFocus()
    editor.settle()
    assert colouring(editor).note == "r_ip of C_1 has no effect on the published surface"


def answer(editor, texts, button):
    """Fill the range dialog in as soon as it is there; return what it said of each pair of texts."""
    said = []

    def fill():
        dialog = editor.dialog("colour_range")
        for low, high in texts:
            for name, text in (("low", low), ("high", high)):
                field = dialog.findChild(QLineEdit, f"colour_range.{name}")
                field.selectAll()
                QTest.keyClicks(field, text)
            note = dialog.findChild(QLabel, "colour_range.note").text()
            enabled = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Ok).isEnabled()
            said.append((note, enabled))
        QTest.mouseClick(dialog.findChild(QDialogButtonBox).button(button), Qt.MouseButton.LeftButton)

    QTimer.singleShot(0, fill)
    editor.trigger("colour_range_fixed")
    return said


def test_a_fixed_range_is_asked_for_and_checked(editor):
    editor.trigger("colour_by_mean")
    said = answer(editor, [("x", "1"), ("2", "1"), ("1", "1"), ("-0,25", "1/2")], QDialogButtonBox.StandardButton.Ok)
    assert [enabled for _, enabled in said] == [False, False, False, True]
    assert said[0][0] == "The lower end is 'x'; expected a number as 0.35 or -2e-4."
    assert "has to lie above" in said[1][0]
    assert said[3][0] == ""
    assert editor.window.view.shown.settings.colour_range is ColourRange.FIXED
    assert colouring(editor).limits == (-0.25, 0.5)
    editor.trigger("colour_range_robust")
    answer(editor, [("0", "9")], QDialogButtonBox.StandardButton.Cancel)
    assert editor.window.view.shown.settings.colour_range is ColourRange.ROBUST
    assert editor.action("colour_range_robust").isChecked()
    assert not editor.action("colour_range_fixed").isChecked()


def test_the_next_window_remembers_what_can_be_shown_again(make_editor):
    first = make_editor()
    first.trigger("colour_by_gaussian")
    first.trigger("colour_range_robust")
    first.window.close()
    second = make_editor()
    assert second.window.view.shown.settings.colour_by == "gaussian"
    assert second.window.view.shown.settings.colour_range is ColourRange.ROBUST
    assert second.action("colour_by_gaussian").isChecked()
    second.trigger("colour_by_distance")
    answer(second, [("0", "1")], QDialogButtonBox.StandardButton.Ok)
    second.window.close()
    third = make_editor()
    assert third.window.view.shown.settings.colour_by == "gaussian"
    assert third.window.view.shown.settings.colour_range is ColourRange.ROBUST


def test_the_probe_reads_and_is_copied(editor):
    QGuiApplication.clipboard().clear()
    editor.trigger("copy_probe")
    assert "nothing under the probe" in editor.message()
    editor.key(Qt.Key.Key_F8, widget=editor.window)
    assert editor.action("probe").isChecked()
    viewport = editor.window.view.viewports[0]
    for away in (9, 0):  # the mouse may have been in the middle already
        QTest.mouseMove(viewport, QPoint(viewport.width() // 2, viewport.height() // 2 - away))
    editor.settle()
    editor.trigger("copy_probe")
    lines = QGuiApplication.clipboard().text().splitlines()
    assert lines[0].startswith("u, v\t")
    assert [line.split("\t")[0] for line in lines] == ["u, v", "x, y, z", "normal", "K, H", "k1, k2"]
    editor.trigger("pin_reference")
    editor.trigger("copy_probe")
    assert QGuiApplication.clipboard().text().splitlines()[-1].startswith("distance\t")


def test_the_bar_has_room_for_all_it_offers(make_editor):
    editor = make_editor(size=(1280, 720))
    bar = editor.find("view_bar", QToolBar)
    assert bar.width() >= bar.sizeHint().width()
