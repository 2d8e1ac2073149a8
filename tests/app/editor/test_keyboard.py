"""Everything by keyboard: the order of Tab, shortcuts, menus."""

import itertools

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QAction, QKeySequence
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QPushButton, QToolBar

from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, name_of, wait_until


def tab_stops(editor, count):
    editor.field("row_knots.C_4.r").setFocus()
    stops = []
    for _ in range(count):
        stops.append(QApplication.focusWidget())
        QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_Tab)
    return stops


def test_tab_reaches_every_control_of_the_zones(editor):
    names = [widget.objectName() for widget in tab_stops(editor, 150)]
    wanted = {name_of(place) for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS)}
    wanted |= {f"{zone}.{verb}" for zone in ("row_knots", "column_knots", "control_points") for verb in ("get", "set")}
    wanted |= {f"surface.{part}" for part in ("formulation", "samples_u", "samples_v", "configure", "export", "figure")}
    wanted |= {"row_knots.slider", "column_knots.slider", "surface.boxes", "surface.matrix", "row_knots.note"}
    assert wanted - set(names) == set()


def test_tab_goes_as_the_eye_goes(editor):
    """Within a zone every stop is right of the one before or below it."""
    for zone in (editor.window.parts.zones.rows, editor.window.parts.zones.columns):
        stops = [widget for widget in tab_stops(editor, 150) if zone.isAncestorOf(widget)]
        places = [widget.mapTo(zone, QPoint(0, widget.height() // 2)) for widget in stops]
        for before, after in itertools.pairwise(places):
            is_same = before == after  # the links of a note, one after the other
            is_back = after == places[0]
            assert is_same or is_back or after.y() > before.y() + 5 or after.x() > before.x()


def test_every_action_is_in_a_menu_with_a_letter_to_reach_it(editor):
    menu_bar = editor.window.menuBar()
    reached = set()

    def walk(menu):
        for action in menu.actions():
            if action.menu():
                walk(action.menu())
            elif not action.isSeparator():
                reached.add(action)

    for action in menu_bar.actions():
        assert "&" in action.text()
        walk(action.menu())
    named = {action for action in editor.window.findChildren(QAction) if action.objectName()}
    assert {a.objectName() for a in named - reached if not a.objectName().startswith("menu.")} == set()
    for button in editor.window.parts.zones.surface.findChildren(QPushButton):
        assert button.focusPolicy() & Qt.FocusPolicy.TabFocus


def test_no_letter_of_a_menu_is_given_twice(editor):
    for menu in editor.window.findChildren(QMenu):
        texts = [action.text() for action in menu.actions() if "&" in action.text()]
        letters = [text[text.index("&") + 1].lower() for text in texts]
        assert len(set(letters)) == len(letters), (menu.objectName(), texts)


def test_no_shortcut_is_given_twice(editor):
    keys = [
        key.toString(QKeySequence.SequenceFormat.PortableText)
        for action in editor.window.findChildren(QAction)
        for key in action.shortcuts()
    ]
    assert len(set(keys)) == len(keys), sorted(keys)


def test_what_the_bars_hold_is_named(editor):
    for bar in editor.window.findChildren(QToolBar):
        for action in bar.actions():
            assert action.isSeparator() or action.text() or bar.widgetForAction(action).text()


def test_the_paper_way_by_shortcuts_alone(editor):
    control = Qt.KeyboardModifier.ControlModifier
    editor.key(Qt.Key.Key_L, control)
    editor.key(Qt.Key.Key_1, Qt.KeyboardModifier.AltModifier)
    assert QApplication.focusWidget().objectName() == "row_knots.C_4.r"
    QTest.keyClicks(QApplication.focusWidget(), "0.3")
    editor.key(Qt.Key.Key_Return, control)
    assert editor.document.row_knots[4, 0].r == 0.3
    assert not editor.find("surface.export").isEnabled()
    editor.key(Qt.Key.Key_F5)
    assert editor.find("surface.export").isEnabled()
    editor.key(Qt.Key.Key_5, Qt.KeyboardModifier.AltModifier)
    assert QApplication.focusWidget() in editor.window.view.viewports


@pytest.mark.parametrize("size", [(1280, 720), (1440, 900)])
def test_a_window_begins_with_the_keyboard_in_the_view_and_nothing_chosen(make_editor, size):
    editor = make_editor(None, size)
    wait_until(lambda: QApplication.focusWidget() in editor.window.view.viewports)
    state = editor.window.store.state
    assert state.selection.points == frozenset()
    assert editor.window.view.picture().curve is None
    QTest.keyClick(QApplication.focusWidget(), Qt.Key.Key_1)
    editor.settle()
    assert editor.action("layer_raw").isChecked()


def test_digits_typed_into_a_field_are_no_shortcuts(editor):
    editor.type_into("control_points.P_0_0.x", "123")
    assert editor.document.control_points[0, 0, 0] == 123
    assert editor.action("layer_transformed").isChecked()


def test_help_opens_and_closes(editor):
    editor.trigger("help")
    dialog = editor.dialog("help")
    assert dialog.isVisible()
    QTest.keyClick(dialog, Qt.Key.Key_Escape)
    assert not dialog.isVisible()
