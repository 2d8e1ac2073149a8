"""The window's layout by the room there is: the table, real windows of every size, and what crosses the bounds."""

from itertools import combinations

import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QLabel,
    QLineEdit,
    QScrollArea,
    QScrollBar,
    QTabBar,
    QTableWidget,
    QToolBar,
    QToolButton,
    QWidget,
)

from qovr_app.laboratory.panels import PANELS
from qovr_app.state.display import LaboratoryPlace
from qovr_app.state.looking_intents import Picking
from qovr_app.style.palette import theme_in_force
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_app.window.main_window import MainWindow
from qovr_app.window.preferences import Preferences
from qovr_app.window.room import Dock, Form, room_of
from support.editor import TABS, Editor, scroll_to, wait_until

CONTROLS = (QLineEdit, QComboBox, QAbstractButton, QAbstractSlider, QTableWidget)
AUTO, RIGHT, BELOW, FLOATING = LaboratoryPlace

TABLE = [
    # width, height, wanted, open: form, tabs, dock, what the view keeps at least
    (1280, 720, AUTO, False, Form.TABS, True, Dock.COLUMN, 900),
    (1280, 720, AUTO, True, Form.TABS, True, Dock.COLUMN, 900),
    (1280, 720, RIGHT, True, Form.TABS, True, Dock.COLUMN, 900),
    (1280, 720, BELOW, True, Form.TABS, True, Dock.BELOW, 900),
    (911, 512, AUTO, False, Form.TABS, True, Dock.COLUMN, 547),
    (911, 512, AUTO, True, Form.TABS, True, Dock.COLUMN, 547),
    (1399, 900, AUTO, False, Form.TABS, True, Dock.COLUMN, 900),
    (1400, 900, AUTO, False, Form.ZONES, False, Dock.BELOW, 630),
    (1440, 900, AUTO, True, Form.ZONES, False, Dock.BELOW, 648),
    (1440, 900, RIGHT, True, Form.TABS, True, Dock.RIGHT, 700),
    (1440, 900, RIGHT, False, Form.ZONES, False, Dock.RIGHT, 648),
    (1920, 1080, AUTO, True, Form.ZONES, False, Dock.BELOW, 1056),
    (1920, 1080, RIGHT, True, Form.ZONES, False, Dock.RIGHT, 700),
    (1920, 1080, FLOATING, True, Form.ZONES, False, Dock.FLOATING, 1056),
    (2559, 1440, AUTO, True, Form.ZONES, False, Dock.BELOW, 1536),
    (2560, 1440, AUTO, True, Form.WIDE, False, Dock.RIGHT, 1152),
    (3840, 2160, AUTO, True, Form.WIDE, False, Dock.RIGHT, 1920),
    (900, 1400, AUTO, False, Form.PORTRAIT, False, Dock.COLUMN, 0.5),
    (900, 901, AUTO, False, Form.PORTRAIT, False, Dock.COLUMN, 0.5),
    (700, 1000, AUTO, True, Form.PORTRAIT, True, Dock.COLUMN, 0.5),
    (900, 900, AUTO, False, Form.TABS, True, Dock.COLUMN, 540),
]


@pytest.mark.parametrize("row", TABLE, ids=lambda row: f"{row[0]}x{row[1]} {row[2]} {'open' if row[3] else 'closed'}")
def test_the_table(row):
    width, height, wanted, is_open, form, has_tabs, dock, view = row
    room = room_of(width, height, wanted, is_open=is_open)
    assert (room.form, room.has_tabs, room.dock) == (form, has_tabs, dock)
    if form is Form.PORTRAIT:
        assert (height - room.zones) / height >= view
    else:
        beside = room.laboratory if dock is Dock.RIGHT and is_open else 0
        assert width - room.zones - beside >= view
    assert room.zones <= room.most_zones
    assert room.opens_laboratory == (form is Form.WIDE)


def shown_controls(editor):
    """Return the controls of the zones that are seen, but for those that scroll and those inside other controls."""
    area = editor.find("zones", QScrollArea).widget()
    controls = [control for kind in CONTROLS for control in area.findChildren(kind) if control.isVisible()]
    parts = [each for each in controls if any(other.isAncestorOf(each) for other in controls if other is not each)]
    return [each for each in controls if not isinstance(each, QScrollBar) and each not in parts]


def check_whole(editor):
    """Check that no zone is lower than what stands in it."""
    for zone in [*TABS, "row_knots.plot", "column_knots.plot"]:
        widget = editor.find(f"zone.{zone}" if "." not in zone else zone)
        if widget.isVisible():
            lowest = max(
                part.geometry().bottom() for part in widget.children() if isinstance(part, QWidget) and part.isVisible()
            )
            assert lowest < widget.height(), zone


def place_in(widget, ancestor):
    return QRect(widget.mapTo(ancestor, widget.rect().topLeft()), widget.size())


def check_zones(editor):
    """Check that controls and words of what is seen of the zones lie apart, and that each can be scrolled to."""
    area = editor.find("zones", QScrollArea)
    controls = shown_controls(editor)
    words = [each for each in area.widget().findChildren(QLabel) if each.isVisible() and each.text()]
    words = [each for each in words if not any(control.isAncestorOf(each) for control in controls)]
    placed = [(each.objectName() or each.text(), place_in(each, area.widget())) for each in (*controls, *words)]
    for (one, first), (other, second) in combinations(placed, 2):
        assert not first.intersects(second), (one, other)
    for control in controls:
        scroll_to(area, control)
        assert control.visibleRegion().boundingRect() == control.rect(), control.objectName()
    return {control.objectName() for control in controls}


SIZES = [(1280, 720), (911, 512), (1440, 900), (1920, 1080), (2560, 1440), (900, 1400)]
"""In logical pixels: 3840 x 2160 at scale 2 is the fourth; 2560 x 1440 is the widest."""


@pytest.mark.parametrize("size", SIZES, ids=lambda size: "x".join(map(str, size)))
def test_every_control_is_there_and_apart_and_the_view_has_its_share(make_editor, size):
    editor = make_editor("paper:fig6c", size)
    window, tabs = editor.window, editor.find("zones.tabs", QTabBar)
    assert (window.width(), window.height()) == size
    has_tabs = size[0] < 1400 and size[0] > size[1]
    assert tabs.isVisible() == has_tabs
    names = set()
    for tab in TABS.values() if has_tabs else [None]:
        if tab:
            editor.choose_tab(tab)
        names |= check_zones(editor)
        check_whole(editor)
    assert len([name for name in names if name.count(".") == 2]) == 115
    assert names >= {f"surface.{part}" for part in ("configure", "export", "figure", "formulation", "boxes", "matrix")}
    for button in ("edit_bar", "view_bar"):
        assert editor.find(button).isVisible()
    view, column = window.view, editor.find("zones", QScrollArea)
    if size[1] > size[0]:
        assert view.width() == size[0]
        assert view.height() >= 0.48 * size[1]
        assert column.mapTo(window, column.rect().topLeft()).y() > view.mapTo(window, view.rect().bottomLeft()).y()
    else:
        assert view.width() >= {1280: 899, 911: 547}.get(size[0], 0.45 * size[0])
        assert not column.horizontalScrollBar().isVisible()
    assert window.parts.laboratory.isVisible() == (size[0] >= 2560)


@pytest.mark.parametrize("size", [(1440, 900), (1920, 1080)])
def test_six_digits_and_the_sign_are_seen_where_all_zones_are(make_editor, size):
    editor = make_editor("paper:fig6c", size)
    for name, text in (("control_points.P_4_4.z", "-0.123456"), ("column_knots.K_4.v", "0.123456")):
        field = editor.field(name)
        assert field.fontMetrics().horizontalAdvance(text) + 4 <= field.width(), name


def test_rows_grow_with_the_height(make_editor):
    editor = make_editor("paper:fig6c", (1440, 760))
    names = ("control_points.P_0_0.z", "row_knots.plot", "column_knots.plot")
    before = [editor.find(name).height() for name in names]
    editor.window.resize(1440, 1200)
    editor.settle()
    assert all(editor.find(name).height() > height for name, height in zip(names, before, strict=True))
    for name in ("row_knots.C_0.r", "column_knots.K_0.v"):  # one digit needs no more, and the picture says it better
        assert editor.find(name).height() < 2 * editor.find(name).fontMetrics().height(), name


def test_six_digits_and_the_sign_are_seen_in_the_column(make_editor):
    editor = make_editor("paper:fig6c", (1280, 720))
    editor.type_into("control_points.P_4_4.z", "-0.123456")
    field = editor.field("control_points.P_4_4.z")
    assert field.fontMetrics().horizontalAdvance("-0.123456") + 2 <= field.width()


@pytest.mark.parametrize("size", [(911, 512), (1280, 720)])
def test_the_laboratory_cuts_no_word_and_scrolls_sideways_nowhere(make_editor, size):
    editor = make_editor("paper:fig5", size)
    for name in PANELS:
        editor.trigger(f"laboratory_{name}")
        panel = editor.find(f"laboratory.{name}")
        area = panel.parentWidget().parentWidget()
        assert area.horizontalScrollBar().maximum() == 0, name
    tabs = editor.find("laboratory.tabs", QTabBar)
    for number in range(tabs.count()):
        assert tabs.fontMetrics().horizontalAdvance(tabs.tabText(number)) < tabs.tabRect(number).width()


def test_a_narrow_bar_does_without_the_cameras_first(make_editor):
    editor = make_editor("paper:fig5", (1280, 720))
    bar = editor.find("view_bar", QToolBar)
    cameras = [editor.action(name) for name in ("camera_paper", "camera_top", "fit")]
    assert all(bar.widgetForAction(camera).isVisible() for camera in cameras)
    editor.window.resize(911, 512)
    editor.settle()
    shown = {button.text() for button in bar.findChildren(QToolButton) if button.isVisible()}
    assert {"Style", "Colour by", "Show"} <= shown
    assert not any(camera in bar.actions() for camera in cameras)
    editor.window.resize(1280, 720)
    editor.settle()
    assert all(bar.widgetForAction(camera).isVisible() for camera in cameras)


@pytest.mark.parametrize("size", [(911, 512), (1280, 720)])
def test_equal_scales_are_one_click_away(make_editor, size):
    editor = make_editor("paper:fig5", size)
    bar, action = editor.find("view_bar", QToolBar), editor.action("scaling_equal")
    button = bar.widgetForAction(action)
    assert button.visibleRegion().boundingRect() == button.rect()
    for is_equal in (True, False):
        QTest.mouseClick(button, Qt.MouseButton.LeftButton)
        editor.settle()
        extents = editor.window.view.picture().scene.frame.half_extents
        assert (extents[2] < 0.1 * extents[0]) == is_equal  # the net is 4 wide and 0.1 high
        assert action.isChecked() == is_equal


def test_crossing_a_bound_keeps_keyboard_selection_and_what_is_typed(make_editor):
    editor = make_editor("paper:fig6c", (1440, 900))
    editor.window.view.points_picked.emit(((1, 1), (2, 2)), Picking.REPLACE)
    editor.type_into("column_knots.K_3.s", "0.31", end=None)
    field, selected = editor.field("column_knots.K_3.s"), editor.window.store.state.selection
    field.setSelection(1, 2)
    for size in ((1280, 720), (900, 1400), (911, 512), (2560, 1440), (1399, 900), (1400, 900)):
        editor.window.resize(*size)
        editor.settle()
        assert field.hasFocus(), size
        assert (field.text(), field.selectedText()) == ("0.31", ".3"), size
        assert not field.visibleRegion().isEmpty(), size
        assert editor.window.store.state.selection == selected
    editor.key(Qt.Key.Key_Return, widget=field)
    assert editor.document.column_knots[3, 0].s == 0.31


def test_a_tab_says_what_its_hidden_zone_holds(make_editor):
    editor = make_editor("paper:fig5", (1280, 720))
    tabs = editor.find("zones.tabs", QTabBar)
    assert [tabs.tabText(k) for k in range(tabs.count())] == list(TABS.values())
    assert tabs.tabText(tabs.currentIndex()) == "Points"
    editor.trigger("live")
    editor.type_into("row_knots.C_1.r", "0.3")
    editor.type_into("column_knots.K_1.r", "7")
    editor.choose_tab("Points")
    assert [tabs.tabToolTip(k) for k in range(4)][2:] == ["", ""]
    assert "not set" in tabs.tabToolTip(0)
    assert "refused" in tabs.tabToolTip(1)
    assert [tabs.tabIcon(k).isNull() for k in range(4)] == [False, False, True, True]
    assert "not set" in tabs.accessibleTabName(0)
    editor.click("row_knots.get")
    editor.click("column_knots.get")
    assert all(tabs.tabIcon(k).isNull() for k in range(4))


def test_what_goes_to_a_zone_brings_its_tab(make_editor):
    editor = make_editor("paper:fig5", (1280, 720))
    for zone, name in (("row_knots", "row_knots.C_4.r"), ("surface", "surface.formulation")):
        editor.trigger(f"go_{zone}")
        assert QApplication.focusWidget() is editor.find(name)
        assert editor.find(name).isVisible()
    editor.trigger("show_panels")
    assert not editor.find("zones").isVisible()
    assert editor.find("edit_bar").isVisible()
    editor.window.view.point_opened.emit((3, 1))
    editor.settle()
    assert QApplication.focusWidget() is editor.field("control_points.P_3_1.z")
    editor.trigger("go_column_knots")
    assert not editor.find("zone.control_points").isVisible()


def test_the_keyboard_goes_from_a_zone_to_the_tab_that_hides_it(make_editor):
    editor = make_editor("paper:fig5", (1280, 720))
    editor.type_into("row_knots.C_4.r", "0.35", end=None)
    editor.choose_tab("Surface")
    assert editor.document.row_knots[4, 0].r == 0.35  # as leaving the field does
    tabs = editor.find("zones.tabs", QTabBar)
    assert tabs.hasFocus()
    QTest.keyClick(tabs, Qt.Key.Key_Left)
    editor.settle()
    assert editor.find("zone.control_points").isVisible()


@pytest.mark.parametrize("name", PANELS)
def test_the_laboratory_is_a_drawer_in_place_of_the_column(make_editor, name):
    editor = make_editor("paper:fig5", (1280, 720))
    editor.trigger(f"laboratory_{name}")
    laboratory = editor.window.parts.laboratory
    assert laboratory.isVisible()
    assert not editor.find("zones").isVisible()
    assert editor.window.view.width() >= 899
    assert laboratory.width() >= 0.95 * (1280 - editor.window.view.width())
    for part in ("laboratory.place", "laboratory.close", "laboratory.tabs"):
        assert editor.find(part).visibleRegion().boundingRect() == editor.find(part).rect()
    editor.choose_tab("Points")
    assert not laboratory.isVisible()
    assert editor.field("control_points.P_0_0.x").isVisible()
    editor.choose_tab("Lab")
    assert laboratory.isVisible()
    editor.trigger("show_panels")
    assert laboratory.isVisible()
    editor.trigger("show_panels")
    editor.click("laboratory.close")
    assert editor.find("zones").isVisible()
    assert not laboratory.isVisible()


def test_the_place_of_the_laboratory_is_chosen_and_remembered(home, app):
    first = Editor(MainWindow("paper:fig5", Preferences()), (1920, 1080))
    first.trigger("laboratory_influence")
    laboratory, view = first.window.parts.laboratory, first.window.view

    def corner(widget):
        return widget.mapToGlobal(widget.rect().topLeft())

    assert corner(laboratory).y() > corner(view).y()
    first.trigger("laboratory_place_right")
    assert corner(laboratory).x() >= corner(view).x() + view.width()
    first.trigger("laboratory_place_floating")
    assert laboratory.window() is not first.window
    assert laboratory.window().isVisible()
    laboratory.window().close()
    first.settle()
    assert not first.window.store.state.panel
    assert not laboratory.isVisible()
    first.discard()
    again = Editor(MainWindow("paper:fig5", Preferences()), (1920, 1080))
    assert again.action("laboratory_place_floating").isChecked()
    again.trigger("laboratory_influence")
    assert again.window.parts.laboratory.window() is not again.window
    again.trigger("laboratory_place_below")
    assert again.window.parts.laboratory.window() is again.window
    again.discard()


def test_sizes_are_kept_apart_for_every_arrangement(home, app):
    first = Editor(MainWindow("paper:fig5", Preferences()), (1440, 900))
    first.drag_handle("workspace", 50)
    wide = first.find("workspace").sizes()[0]
    first.window.resize(1280, 720)
    first.settle()
    first.drag_handle("workspace", -30)
    assert first.find("workspace").sizes()[0] == pytest.approx(350, abs=3)
    first.discard()
    again = Editor(MainWindow("paper:fig5", Preferences()), (1280, 720))
    assert again.find("workspace").sizes()[0] == pytest.approx(350, abs=3)
    again.window.resize(1440, 900)
    again.settle()
    assert again.find("workspace").sizes()[0] == pytest.approx(wide, abs=3)
    again.discard()


def test_both_is_stacked_where_that_shows_more(make_editor):
    editor = make_editor("paper:fig5", (900, 1400))
    editor.trigger("layer_both")
    raw, transformed = (viewport.widget for viewport in editor.window.view.viewports)
    assert raw.x() == transformed.x()
    assert raw.y() + raw.height() <= transformed.y()
    editor.trigger("show_panels")
    editor.window.resize(1440, 600)
    editor.settle()
    assert raw.y() == transformed.y()
    assert raw.x() + raw.width() <= transformed.x()


def disc_width(editor):
    """Return how many pixels of a control point's colour lie beside one another through its middle."""
    view = editor.window.view
    at = view.mapFromGlobal(editor.window.screen_position(0, 3))
    image, colour = view.image(), QColor(*theme_in_force().point).rgb()
    return sum(image.pixel(x, at.y()) == colour for x in range(at.x() - 12, at.x() + 13))


def test_discs_and_colour_bar_are_larger_in_a_large_window(make_editor):
    editor = make_editor("paper:fig5", (1280, 720))
    usual = disc_width(editor), bar_rect(editor.window.view.viewports[0].logical_size)
    editor.window.resize(2560, 1440)
    editor.settle()
    editor.trigger("fit")
    wait_until(lambda: disc_width(editor) > usual[0])
    wide = bar_rect(editor.window.view.viewports[0].logical_size)
    assert wide.width() > usual[1].width()
    assert wide.right() < editor.window.view.width()
