"""The laboratory's place: opened, closed, told the latest and no more, and out of the way of everything else."""

import pytest
from PySide6.QtWidgets import QAbstractButton, QLabel, QTabBar, QTableWidget

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.laboratory.panels import PANELS, PanelRecord
from qovr_app.state.display import ThemeName
from qovr_app.state.intents import ValuesEdited
from qovr_app.state.looking_intents import MessageShown, Picking
from qovr_app.state.requests import DocumentAsked
from qovr_app.style.palette import set_theme
from qovr_app.window.preferences import Preferences
from qovr_core.edits import Direction, KnotPlace
from qovr_core.presets import preset


class Diary(LaboratoryPanel):
    """Writes down what it is shown."""

    def __init__(self, store, worker):
        super().__init__(store, worker)
        self.evaluations, self.foci, self.themes = [], [], []

    def show_state(self, before, after):
        assert self.isVisible()
        if after.differs(before, "evaluation"):
            self.evaluations.append(after.evaluation)
        if before is None or before.focus != after.focus:
            self.foci.append(after.focus)
        if before is None or before.display.theme != after.display.theme:
            self.themes.append(after.display.theme)


@pytest.fixture
def lab(make_editor):
    """An editor whose laboratory holds two diaries besides the program's own panels."""
    first = PanelRecord("first", "&First", "What comes first", Diary)
    second = PanelRecord("second", "&Second", "What comes second", Diary)
    with PANELS.register(first), PANELS.register(second):
        yield make_editor()
    set_theme(ThemeName.LIGHT)


def diary(lab, name):
    return lab.find(f"laboratory.{name}", Diary)


def test_panels_are_made_when_they_are_asked_for_and_the_commands_say_which_is_shown(lab):
    place = lab.window.parts.laboratory
    assert not place.isVisible()
    assert lab.window.findChildren(Diary) == []
    lab.trigger("laboratory_second")
    assert [made.objectName() for made in lab.window.findChildren(Diary)] == ["laboratory.second"]
    assert diary(lab, "second").isVisible()
    assert lab.action("laboratory_second").isChecked()
    lab.trigger("laboratory_first")
    assert (lab.action("laboratory_first").isChecked(), lab.action("laboratory_second").isChecked()) == (True, False)
    assert not diary(lab, "second").isVisible()
    lab.find("laboratory.tabs", QTabBar).setCurrentIndex(list(PANELS).index("second"))
    lab.settle()
    assert lab.window.store.state.panel == "second"
    assert lab.action("laboratory_second").isChecked()
    lab.click("laboratory.close")
    assert (lab.window.store.state.panel, place.isVisible()) == ("", False)
    assert not lab.action("laboratory_second").isChecked()
    lab.trigger("laboratory_second")
    lab.trigger("laboratory_second")
    assert not place.isVisible()


def test_only_the_panel_that_is_seen_is_told_and_only_the_latest(lab, spin):
    lab.trigger("laboratory_first")
    lab.trigger("laboratory_second")
    first, second = diary(lab, "first"), diary(lab, "second")
    spin(50)
    before = len(first.evaluations)
    assert len(second.evaluations) == 1
    lab.type_into("row_knots.C_4.r", "0.31")
    lab.type_into("row_knots.C_4.r", "0.32")
    assert second.evaluations[-1].document == lab.document
    assert len(first.evaluations) == before
    lab.trigger("laboratory_first")
    assert first.evaluations[-1].document == lab.document
    assert len(first.evaluations) == before + 1
    lab.click("laboratory.close")
    lab.type_into("row_knots.C_4.r", "0.33")
    assert len(first.evaluations) == before + 1


def test_a_drag_with_a_panel_open_tells_it_once_a_turn(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    lab.field("row_knots.C_4.r").setFocus()
    lab.settle()
    before = len(panel.evaluations)
    lab.drag_slider("row_knots.slider", [5, 5, 5, 5])
    assert before < len(panel.evaluations) <= before + 4
    assert panel.evaluations[-1].document == lab.document


def test_the_focus_is_the_knot_or_point_that_came_last(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    lab.field("column_knots.K_2.v").setFocus()
    lab.settle()
    assert panel.foci[-1] == KnotPlace(Direction.COLUMNS, 2, "u")
    lab.field("control_points.P_3_1.z").setFocus()
    lab.settle()
    assert panel.foci[-1] == (3, 1)
    lab.window.view.points_picked.emit(((2, 2),), Picking.REPLACE)
    lab.settle()
    assert panel.foci[-1] == (2, 2)
    lab.window.view.points_picked.emit((), Picking.REPLACE)
    lab.settle()
    assert panel.foci[-1] is None
    lab.field("row_knots.C_0.t").setFocus()
    lab.settle()
    assert panel.foci[-1] == KnotPlace(Direction.ROWS, 0, "t")
    lab.window.view.points_picked.emit((), Picking.REPLACE)
    lab.settle()
    assert panel.foci[-1] is None


def test_panels_follow_the_theme(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    set_theme(ThemeName.DARK)
    lab.settle()
    assert panel.themes == [ThemeName.LIGHT, ThemeName.DARK]


def test_a_panel_can_open_a_document_edit_and_speak(lab):
    lab.trigger("laboratory_first")
    dispatch = diary(lab, "first").store.dispatch
    dispatch(MessageShown("It is so."))
    lab.settle()
    assert lab.message() == "It is so."
    dispatch(ValuesEdited({KnotPlace(Direction.ROWS, 4, "r"): 0.25}, 7))
    lab.settle()
    assert {knots.r for knots in lab.document.row_knots.in_window(0)} == {0.25}  # the curves are linked
    lab.trigger("undo")
    assert lab.document == preset("fig5").document
    dispatch(DocumentAsked(preset("fig6c").document, "a counterexample"))
    lab.settle()
    assert lab.document == preset("fig6c").document
    assert "a counterexample" in lab.window.windowTitle()
    assert not lab.window.store.state.is_changed
    assert lab.window.store.state.file.path is None


def test_the_laboratory_stays_when_the_zones_go_and_keeps_its_height(lab, home, spin):
    from qovr_app.window.main_window import MainWindow
    from support.editor import Editor

    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    lab.trigger("show_panels")
    assert panel.isVisible()
    lab.trigger("show_panels")

    window = MainWindow(None, Preferences())
    first = Editor(window, (1440, 900))
    first.trigger("laboratory_first")
    first.drag_handle("splitter.laboratory", -60)
    height = window.parts.laboratory.height()
    first.trigger("laboratory_first")
    first.discard()
    again = Editor(MainWindow(None, Preferences()), (1440, 900))
    assert not again.window.parts.laboratory.isVisible()
    again.trigger("laboratory_first")
    assert again.window.parts.laboratory.height() == pytest.approx(height, abs=2)
    again.discard()


@pytest.mark.parametrize(("place", "view"), [("auto", (899, 600)), ("below", (899, 300))])
def test_view_and_panel_have_room_in_a_small_window(make_editor, place, view):
    editor = make_editor(size=(1280, 720))
    editor.trigger(f"laboratory_place_{place}")
    editor.trigger("laboratory_curve")
    assert (editor.window.width(), editor.window.height()) == (1280, 720)
    assert editor.window.view.width() >= view[0]
    assert editor.window.view.height() >= view[1]
    assert editor.window.parts.laboratory.height() >= 250
    for name in ("surface.configure", "surface.matrix", "row_knots.C_0.t"):
        assert not editor.reach(name).visibleRegion().isEmpty()


def test_tabs_and_closing_have_spoken_names(lab):
    assert lab.find("laboratory.tabs").accessibleName()
    assert lab.find("laboratory.close", QAbstractButton).accessibleName() == "Close the laboratory"


def test_panels_of_a_surface_older_than_what_is_set_say_so(lab):
    lab.trigger("laboratory_first")
    note = lab.find("laboratory.stale", QLabel)
    lab.trigger("live")
    assert not note.isVisible()
    lab.type_into("row_knots.C_4.r", "0.3")
    lab.click("row_knots.set")
    assert note.isVisible()
    lab.click("surface.configure")
    assert not note.isVisible()


@pytest.mark.parametrize("name", ["comparison", "claims"])
def test_headers_of_tables_follow_the_theme(make_editor, name):
    editor = make_editor()
    editor.trigger(f"laboratory_{name}")
    header = editor.find(f"laboratory.{name}.table", QTableWidget).horizontalHeader()
    try:
        set_theme(ThemeName.DARK)
        editor.settle()
        assert header.grab().toImage().pixelColor(2, 2).lightness() < 100
        set_theme(ThemeName.LIGHT)
        editor.settle()
        assert header.grab().toImage().pixelColor(2, 2).lightness() > 150
    finally:
        set_theme(ThemeName.LIGHT)
