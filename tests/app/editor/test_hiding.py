"""Control points that a user hides: they are neither seen nor picked, and come back."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

CONTROL, SHIFT, ALT = (getattr(Qt.KeyboardModifier, f"{name}Modifier") for name in ("Control", "Shift", "Alt"))
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def seen(make_editor):
    """The editor with a net that is seen from above."""
    editor = make_editor("paper:fig8")
    editor.window.view.set_camera("top", animated=False)
    editor.trigger("xray")
    return editor


def pixel(editor, index):
    view = editor.window.view
    points = view.picture().scene.points
    x, y, _ = view.camera.project(points[index], view.viewports[0].logical_size).tolist()
    return QPoint(round(x), round(y))


def click(editor, index, modifiers=Qt.KeyboardModifier.NoModifier):
    QTest.mouseClick(editor.window.view.viewports[0].widget, LEFT, modifiers, pixel(editor, index))
    editor.settle()


def press(editor, key, modifiers):
    editor.key(key, modifiers, editor.window.view.viewports[0].widget)


def selected(editor):
    return editor.window.store.state.selection.points


def test_hidden_points_are_not_picked_and_come_back(seen):
    click(seen, (1, 1))
    click(seen, (2, 3), SHIFT)
    press(seen, Qt.Key.Key_H, CONTROL)
    assert "2 points are hidden" in seen.message()
    assert selected(seen) == frozenset()
    click(seen, (1, 1))
    assert selected(seen) == frozenset()
    seen.trigger("select_all")
    assert len(selected(seen)) == 23
    press(seen, Qt.Key.Key_H, CONTROL | ALT)
    seen.trigger("select_none")
    click(seen, (1, 1))
    assert selected(seen) == {(1, 1)}
    assert not seen.action("show_points").isEnabled()


def test_what_is_isolated_is_seen_alone_with_its_curves(seen):
    for name in ("show_surface", "show_labels", "show_axes", "show_row_curves", "show_legend", "show_triad"):
        seen.trigger(name)
    click(seen, (2, 0))
    seen.trigger("select_rows")
    press(seen, Qt.Key.Key_H, CONTROL | SHIFT)
    seen.trigger("select_none")
    view = seen.window.view
    image, theme = view.image(), view.picture().theme
    places = {index: pixel(seen, index) for index in np.ndindex(5, 5)}

    def colour(x, y):
        return image.pixelColor(round(x), round(y)).getRgb()[:3]

    shown = {index for index, at in places.items() if colour(at.x(), at.y()) == theme.point}
    assert shown == {(2, j) for j in range(5)}
    between = {i: (places[i, 1] + places[i, 2]) / 2 for i in range(5)}
    assert {i for i, at in between.items() if colour(at.x(), at.y()) != theme.background} == {2}


def test_another_document_shows_all_its_points(seen):
    click(seen, (1, 1))
    press(seen, Qt.Key.Key_H, CONTROL)
    seen.mark_saved()
    seen.trigger("new_dome")
    assert seen.window.store.state.put_away == frozenset()


def test_a_hidden_point_whose_field_is_opened_is_seen_while_it_is(seen):
    click(seen, (1, 1))
    press(seen, Qt.Key.Key_H, CONTROL)
    seen.field("control_points.P_1_1.z").setFocus()
    seen.settle()
    assert seen.window.view.picture().put_away == frozenset()
    seen.trigger("select_none")
    assert seen.window.view.picture().put_away == {(1, 1)}


def test_a_line_of_the_net_is_hidden_by_its_menu(seen):
    at = (pixel(seen, (2, 1)) + pixel(seen, (2, 2))) / 2
    QTest.mouseClick(seen.window.view.viewports[0].widget, Qt.MouseButton.RightButton, pos=at)
    menu = seen.find("context.net_line", QMenu)
    assert seen.action("laboratory_curve") in menu.actions()
    {action.text(): action for action in menu.actions()}["Hide this line of the net"].trigger()
    menu.close()
    seen.settle()
    click(seen, (2, 2))
    assert selected(seen) == frozenset()
    assert seen.window.store.state.put_away == {(2, j) for j in range(5)}
