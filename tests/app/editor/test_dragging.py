"""Control points dragged in the view: fields, surface and history follow."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from qovr_core.presets import preset

FIG5 = preset("fig5").document
LEFT = Qt.MouseButton.LeftButton


def place_of(editor, i, j):
    """Return where a control point is seen, in the viewport's pixels."""
    viewport = editor.window.view.viewports[0]
    return viewport, viewport.mapFromGlobal(editor.window.screen_position(i, j))


@pytest.fixture
def drag(editor):
    """A function that takes hold of P_4_2, moves it up step by step, and says what the fields showed meanwhile."""

    def run(end):
        viewport, at = place_of(editor, 4, 2)
        QTest.mousePress(viewport, LEFT, pos=at)
        seen = []
        for _ in range(6):
            at -= QPoint(0, 8)
            QTest.mouseMove(viewport, at)
            QTest.qWait(10)
            seen.append(editor.text("control_points.P_4_2.z"))
        if end == "escape":
            QTest.keyClick(viewport, Qt.Key.Key_Escape)
        QTest.mouseRelease(viewport, LEFT, pos=at)
        editor.settle()
        return seen

    return run


def test_a_drag_is_one_step_and_the_fields_follow(editor, drag):
    results = []
    editor.on_evaluation(results.append)
    seen = drag("release")
    assert len(set(seen)) == 6
    assert len(results) >= 6
    assert len(editor.window.store.state.history.steps) == 1
    assert editor.action("undo").text() == "&Undo Move P 4,2"
    assert editor.disagreements() == []
    assert editor.field("control_points.P_4_2.z").is_marked
    editor.trigger("undo")
    assert editor.document == FIG5


def test_escape_puts_the_point_back_and_leaves_no_step(editor, drag):
    assert len(set(drag("escape"))) == 6
    assert editor.document == FIG5
    assert not editor.action("undo").isEnabled()
    assert not editor.action("redo").isEnabled()
    assert editor.disagreements() == []


def test_staged_the_net_follows_and_the_surface_waits(editor, drag):
    editor.trigger("live")
    before = editor.window.store.state.evaluation
    drag("release")
    state = editor.window.store.state
    assert state.evaluation is before
    assert state.is_stale
    assert np.array_equal(editor.window.view.picture().scene.document.control_points, editor.document.control_points)
    assert editor.find("view.stale").isVisible()
    editor.trigger("undo")
    assert not editor.find("view.stale").isVisible()


def test_a_document_opened_during_a_drag_ends_the_drag(editor):
    viewport, at = place_of(editor, 4, 2)
    QTest.mousePress(viewport, LEFT, pos=at)
    QTest.mouseMove(viewport, at - QPoint(0, 16))
    editor.settle()
    assert editor.document != FIG5
    editor.mark_saved()
    editor.trigger("preset_fig8")
    for step in (24, 32):
        QTest.mouseMove(viewport, at - QPoint(0, step))
        editor.settle()
    QTest.mouseRelease(viewport, LEFT, pos=at)
    editor.settle()
    assert editor.document == preset("fig8").document
    assert not editor.action("undo").isEnabled()


def test_the_right_button_opens_the_menu_of_what_is_there(editor):
    viewport, point = place_of(editor, 4, 2)
    _, other = place_of(editor, 4, 3)
    places = {
        "context.point": point,
        "context.net_line": (point + other) / 2,
        "context.colour_bar": QPoint(viewport.width() - 30, viewport.height() // 2),
        "context.view": QPoint(6, 6),
    }
    names = {
        "context.point": "smooth_points",
        "context.colour_bar": "colour_map_cividis",
        "context.view": "camera_back",
    }
    for name, at in places.items():
        QTest.mouseClick(viewport, Qt.MouseButton.RightButton, pos=at)
        menu = editor.find(name, QMenu)
        assert menu.isVisible()
        found = {action.objectName() for action in menu.actions()}
        assert names.get(name, "fit_selection") in found
        if name == "context.net_line":
            menu.actions()[0].trigger()
            assert len(editor.window.store.state.selection.points) == 5
        menu.close()
        editor.settle()


def test_a_double_click_goes_to_the_height_of_a_point(editor):
    viewport, at = place_of(editor, 4, 2)
    QTest.mouseDClick(viewport, LEFT, pos=at)
    editor.settle()
    assert QApplication.focusWidget().objectName() == "control_points.P_4_2.z"


def test_single_letters_act_with_the_keyboard_in_the_view_only(editor):
    viewport, at = place_of(editor, 2, 2)
    QTest.mousePress(viewport, LEFT, pos=at)
    QTest.mouseMove(viewport, at - QPoint(0, 60))
    QTest.mouseRelease(viewport, LEFT, pos=at - QPoint(0, 60))
    editor.settle()
    assert editor.window.view.picture().leaves_frame
    editor.find("surface.export").setFocus()
    QTest.keyClick(editor.find("surface.export"), Qt.Key.Key_F)
    editor.settle()
    assert editor.window.view.picture().leaves_frame
    viewport.setFocus()
    QTest.keyClick(viewport, Qt.Key.Key_F)
    editor.settle()
    assert not editor.window.view.picture().leaves_frame
