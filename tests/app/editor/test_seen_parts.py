"""What is not seen does no work on an edit, and is right at once when it is seen again."""

import sys

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QSplitter, QTabBar, QWidget

from qovr_app.state.intents import PointsMoved, Undone
from qovr_app.state.knot_intents import KnotsSet
from qovr_app.state.looking_intents import PanelShown, Selected, ZonesShown
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, value_at

PANELS = ("curve", "influence", "comparison", "section", "claims")
EDITS = (
    PointsMoved(((2, 2),), ((0.0, 0.0, 0.125),)),
    KnotsSet(Direction.ROWS, 2, 0, "s", 0.375),
    PointsMoved(((2, 2), (1, 3)), ((0.25, 0.0, 0.0),) * 2),
    Undone(),
)


def work_of(act, is_meant):
    """Return which methods of the program's widgets run while something is done, of those that are meant."""
    found = set()

    def watch(frame, event, _argument):
        owner = frame.f_locals.get("self")
        is_ours = "qovr_app" in frame.f_code.co_filename
        if event == "call" and is_ours and isinstance(owner, QWidget) and is_meant(owner):
            found.add((type(owner).__name__, owner.objectName(), frame.f_code.co_name))

    sys.setprofile(watch)
    try:
        act()
    finally:
        sys.setprofile(None)
    return found


def edit(editor):
    for intent in EDITS:
        editor.dispatch(intent)


@pytest.fixture
def tabs(make_editor):
    """An editor in which one zone is seen at a time, after every panel has been shown once."""
    editor = make_editor(size=(1280, 800))
    editor.dispatch(Selected((2, 2)))
    for name in (*PANELS, "section"):
        editor.dispatch(PanelShown(name))
    return editor


def test_what_is_not_seen_does_nothing_on_an_edit(tabs):
    dock = tabs.find("laboratory")  # it opens itself
    for panel, has_zones in (("section", True), ("", True), ("", False)):
        tabs.dispatch(PanelShown(panel))
        tabs.dispatch(ZonesShown(has_zones))
        assert work_of(lambda: edit(tabs), lambda widget: not (widget.isVisible() or widget is dock)) == set()


def test_nothing_beside_the_view_follows_in_a_minimised_window(tabs):
    tabs.dispatch(PanelShown(""))
    tabs.window.showMinimized()
    tabs.settle()
    zone = tabs.window.parts.zones.points
    assert work_of(lambda: edit(tabs), lambda widget: widget is zone or zone.isAncestorOf(widget)) == set()
    assert float(tabs.text("control_points.P_2_2.z")) != value_at(tabs.document, CoordinatePlace(2, 2, 2))
    tabs.window.showNormal()
    QTest.qWaitForWindowExposed(tabs.window)
    tabs.settle()
    assert float(tabs.text("control_points.P_2_2.z")) == value_at(tabs.document, CoordinatePlace(2, 2, 2))


def moved_by(editor, row_knot):
    """Move a point and a knot; return what the fields of both have to show."""
    editor.window.store.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, row_knot),)))
    editor.window.store.dispatch(KnotsSet(Direction.ROWS, 4, 0, "t", row_knot))
    editor.settle()
    return (
        value_at(editor.document, CoordinatePlace(2, 2, 2)),
        value_at(editor.document, KnotPlace(Direction.ROWS, 4, "t")),
    )


def test_a_zone_is_right_as_soon_as_its_tab_is_chosen(tabs):
    bar = tabs.find("zones.tabs", QTabBar)
    tabs.dispatch(PanelShown(""))
    names = [bar.tabText(k) for k in range(bar.count())]
    for number, zone in enumerate(("Rows u", "Points", "Rows u")):
        height, knot = moved_by(tabs, 0.25 + number / 8)
        bar.setCurrentIndex(names.index(zone))
        shown = tabs.text("row_knots.C_4.t" if zone == "Rows u" else "control_points.P_2_2.z")
        assert float(shown) == (knot if zone == "Rows u" else height)


def test_zones_that_were_pushed_together_are_right_when_there_is_room_again(tabs):
    tabs.dispatch(PanelShown(""))
    splitter = tabs.find("workspace", QSplitter)
    before = splitter.sizes()
    splitter.setSizes([0, sum(before)])
    tabs.settle()
    height, _ = moved_by(tabs, 0.625)
    assert float(tabs.text("control_points.P_2_2.z")) != height
    splitter.setSizes(before)
    tabs.settle()
    assert float(tabs.text("control_points.P_2_2.z")) == height


def test_a_panel_is_right_as_soon_as_it_is_shown_again(tabs):
    tabs.dispatch(PanelShown("curve"))
    panel = tabs.find("laboratory.curve")
    for name in ("section", ""):
        tabs.dispatch(PanelShown(name))
        moved_by(tabs, 0.125)
        net = tabs.document.control_points
        assert not np.array_equal(panel.curve.points[2], net[2, 2])
        tabs.window.store.dispatch(PanelShown("curve"))
        tabs.window.store.flush()
        assert any(np.array_equal(panel.curve.points, line) for line in (*net, *net.swapaxes(0, 1)))


def test_copies_of_a_zone_that_is_not_seen_are_of_the_document(tabs):
    tabs.dispatch(ZonesShown(are_shown=False))
    height, _ = moved_by(tabs, 0.75)
    zone = tabs.window.parts.current_zone()
    assert zone.copied_block()[12][2] == height


def test_while_something_is_dragged_the_fields_follow_and_then_show_it(make_editor, spin):
    editor = make_editor(size=(1280, 800))
    view = editor.window.view
    viewport = view.viewports[0].widget
    at = viewport.mapFromGlobal(editor.window.screen_position(2, 2))
    field = editor.field("control_points.P_2_2.z")

    def is_right():
        return float(field.text()) == value_at(editor.document, CoordinatePlace(2, 2, 2))

    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=at)
    for k in range(12):
        QTest.mouseMove(viewport, at - QPoint(0, 6 + 2 * k))
        editor.settle()
    spin(is_right)  # though the mouse rests
    QTest.mouseMove(viewport, at - QPoint(0, 40))
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=at - QPoint(0, 40))
    editor.settle()
    assert editor.window.store.state.gesture is None
    assert is_right()
