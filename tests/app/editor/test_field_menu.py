"""What a field says that is refused, at the field itself, and what its menu offers."""

import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtGui import QContextMenuEvent, QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QMenu

from qovr_core.presets import preset

BUMP, KNOT = "control_points.P_2_2.z", "row_knots.C_3.t"


@pytest.fixture
def editor(shared_editor):
    return shared_editor


def bubbles(editor, zone):
    return [label for label in editor.find(zone).findChildren(QLabel, "field.error") if label.isVisible()]


def place_in(widget, zone):
    return QRect(widget.mapTo(zone, QPoint()), widget.size())


def test_a_refusal_stands_at_its_field_until_it_is_mended(editor):
    editor.type_into(KNOT, "1.5")
    (bubble,) = bubbles(editor, "zone.row_knots")
    zone, field = editor.find("zone.row_knots"), editor.field(KNOT)
    assert bubble.text() == (
        "<i>t</i><sub>ip</sub> of <i>C</i><sub>3</sub> is 1.5; expected a number strictly between 0 and 1."
    )
    said, typed = place_in(bubble, zone), place_in(field, zone)
    assert zone.rect().contains(said)
    assert not said.intersects(typed)
    assert min(abs(said.top() - typed.bottom()), abs(typed.top() - said.bottom())) <= 2
    assert not said.intersects(place_in(QApplication.focusWidget(), zone))
    assert editor.message() == "tᵢₚ of C₃ is 1.5; expected a number strictly between 0 and 1."
    assert "strictly between 0 and 1" in field.accessibleDescription()
    editor.type_into(KNOT, "0.4")
    assert bubbles(editor, "zone.row_knots") == []
    assert editor.message() == ""
    assert "strictly" not in field.accessibleDescription()


def test_of_two_refusals_the_other_one_is_said_when_one_is_mended(editor):
    editor.type_into(BUMP, "abc")
    editor.type_into("control_points.P_0_0.x", "1,234.5")
    (bubble,) = bubbles(editor, "zone.control_points")
    assert "group separators" in bubble.text()
    editor.type_into("control_points.P_0_0.x", "7")
    (bubble,) = bubbles(editor, "zone.control_points")
    assert "<i>P</i><sub>2,2</sub> is 'abc'" in bubble.text()
    editor.key(Qt.Key.Key_Escape, widget=editor.field(BUMP))
    assert bubbles(editor, "zone.control_points") == []


def test_a_refusal_of_the_document_calls_places_as_the_window_does(editor):
    editor.trigger("symmetry_columns")
    editor.type_into("control_points.P_1_2.x", "2.5")
    expected = "X of P 1,2 is 2.5; expected 2.0, as symmetry has it; or switch it off"
    assert editor.message() == f"{expected}."
    (bubble,) = bubbles(editor, "zone.control_points")
    assert bubble.text().startswith("X of <i>P</i><sub>1,2</sub> is 2.5")
    assert editor.field("control_points.P_1_2.x").error == expected


def test_the_slider_has_the_menu_of_its_knot(editor):
    editor.field(KNOT).setFocus()
    slider = editor.find("row_knots.slider")
    editor.field(BUMP).setFocus()
    at = slider.rect().center()
    QApplication.sendEvent(slider, QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, slider.mapToGlobal(at)))
    editor.settle()
    menu = QApplication.activePopupWidget()
    assert menu.objectName() == "context.field"
    choose(editor, next(action for action in menu.actions() if action.objectName() == "field_copy"))
    assert editor.message() == "Copied tᵢₚ of C₃: 0.5"


def open_menu(editor, name, reason=QContextMenuEvent.Reason.Mouse):
    field = editor.field(name)
    if reason is QContextMenuEvent.Reason.Mouse:
        QTest.mouseClick(field, Qt.MouseButton.RightButton)
    else:
        field.setFocus()
    at = field.rect().center()
    QApplication.sendEvent(field, QContextMenuEvent(reason, at, field.mapToGlobal(at)))
    editor.settle()
    menu = QApplication.activePopupWidget()
    assert isinstance(menu, QMenu)
    assert menu.objectName() == "context.field"
    return {action.objectName(): action for action in menu.actions() if action.objectName()}


def choose(editor, action):
    menu = QApplication.activePopupWidget()
    QTest.mouseClick(menu, Qt.MouseButton.LeftButton, pos=menu.actionGeometry(action).center())
    editor.settle()
    assert QApplication.activePopupWidget() is None


@pytest.mark.parametrize("reason", [QContextMenuEvent.Reason.Mouse, QContextMenuEvent.Reason.Keyboard])
def test_the_menu_resets_a_number(editor, reason):
    editor.type_into(BUMP, "0.75")
    offered = open_menu(editor, BUMP, reason)
    first = preset("fig5").document.control_points[2, 2, 2]
    assert offered["field_reset"].text() == f"&Reset to {first:g}"
    assert not offered["field_set_curves"].isEnabled()
    choose(editor, offered["field_reset"])
    assert editor.document == preset("fig5").document
    QTest.keyClick(editor.field(BUMP), Qt.Key.Key_Escape)
    assert not open_menu(editor, BUMP)["field_reset"].isEnabled()
    QApplication.activePopupWidget().close()


def test_the_menu_copies_and_pastes_numbers_and_tables(editor):
    editor.type_into(BUMP, "0.123456789012345")
    choose(editor, open_menu(editor, BUMP)["field_copy"])
    assert QGuiApplication.clipboard().text() == "0.123456789012345"
    choose(editor, open_menu(editor, "control_points.P_1_2.z")["field_paste"])
    assert editor.document.control_points[1, 2, 2] == 0.123456789012345
    QGuiApplication.clipboard().setText("1\t2\t3")
    choose(editor, open_menu(editor, "control_points.P_4_4.y")["field_paste"])
    assert editor.document.control_points[4, 4].tolist() == [1, 2, 3]
    choose(editor, open_menu(editor, BUMP)["copy_zone"])
    assert len(QGuiApplication.clipboard().text().splitlines()) == 25
    choose(editor, open_menu(editor, KNOT)["copy_zone"])
    assert len(QGuiApplication.clipboard().text().splitlines()) == 5


def test_a_knot_is_set_on_all_curves_whatever_is_linked(editor):
    editor.trigger("link_curves")
    editor.type_into(KNOT, "0.35", end=None)
    choose(editor, open_menu(editor, KNOT)["field_set_curves"])
    assert [knots.t for knots in editor.document.row_knots.in_window(0)] == [0.35] * 5
    assert [knots.t for knots in editor.document.column_knots.in_window(0)] == [0.5] * 5
    choose(editor, open_menu(editor, KNOT)["field_set_directions"])
    assert [knots.t for knots in editor.document.column_knots.in_window(0)] == [0.35] * 5
    assert editor.window.store.state.history.index == 2
    editor.trigger("link_curves")


def test_what_is_typed_can_be_taken_back(editor):
    editor.type_into(BUMP, "0.9", end=None)
    choose(editor, open_menu(editor, BUMP)["field_revert"])
    assert editor.text(BUMP) == "0.5"
    assert editor.document == preset("fig5").document
