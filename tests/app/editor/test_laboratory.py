"""The laboratory's place: opened, closed, told the latest and no more, and out of the way of everything else."""

import pytest
from PySide6.QtWidgets import QAbstractButton, QLabel, QTabBar, QTableWidget

from qovr_app.laboratory import dock as place_module
from qovr_app.laboratory.dock import PanelEntry
from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.state.display import ThemeName
from qovr_app.style.palette import set_theme
from qovr_app.style.theme import theme_of
from qovr_app.window.preferences import Preferences
from qovr_core.edits import Direction, KnotPlace
from qovr_core.presets import preset


class Diary(LaboratoryPanel):
    """Writes down what it is told."""

    def __init__(self):
        super().__init__()
        self.documents, self.foci, self.themes = [], [], []

    def show_document(self, document):
        assert self.isVisible()
        self.documents.append(document)

    def show_focus(self, focus):
        self.foci.append(focus)

    def show_theme(self, theme):
        self.themes.append(theme)


class OtherDiary(Diary):
    pass


@pytest.fixture
def lab(monkeypatch, make_editor):
    """An editor whose laboratory holds two diaries."""
    entries = (
        PanelEntry("first", "&First", "What comes first", "first", "Diary"),
        PanelEntry("second", "&Second", "What comes second", "second", "OtherDiary"),
    )
    monkeypatch.setattr(place_module, "PANELS", entries)
    monkeypatch.setattr(PanelEntry, "make", lambda entry: globals()[entry.kind]())
    yield make_editor()
    set_theme(ThemeName.LIGHT)


def diary(lab, name):
    return lab.find(f"laboratory.{name}", Diary)


def test_panels_are_made_when_they_are_asked_for_and_the_commands_say_which_is_shown(lab):
    place = lab.window.workspace.laboratory
    assert not place.isVisible()
    assert place.panels == {}
    lab.trigger("laboratory_second")
    assert list(place.panels) == ["second"]
    assert diary(lab, "second").isVisible()
    assert lab.action("laboratory_second").isChecked()
    lab.trigger("laboratory_first")
    assert (lab.action("laboratory_first").isChecked(), lab.action("laboratory_second").isChecked()) == (True, False)
    assert not diary(lab, "second").isVisible()
    lab.find("laboratory.tabs", QTabBar).setCurrentIndex(1)
    lab.settle()
    assert place.shown == "second"
    assert lab.action("laboratory_second").isChecked()
    lab.click("laboratory.close")
    assert (place.shown, place.isVisible()) == ("", False)
    assert not lab.action("laboratory_second").isChecked()
    lab.trigger("laboratory_second")
    lab.trigger("laboratory_second")
    assert not place.isVisible()


def test_only_the_panel_that_is_seen_is_told_and_only_the_latest(lab, spin):
    lab.trigger("laboratory_first")
    lab.trigger("laboratory_second")
    first, second = diary(lab, "first"), diary(lab, "second")
    spin(50)
    before = len(first.documents)
    assert len(second.documents) == 1
    lab.type_into("row_knots.C_4.r", "0.31")
    lab.type_into("row_knots.C_4.r", "0.32")
    assert second.documents[-1] == lab.document
    assert len(first.documents) == before
    lab.trigger("laboratory_first")
    assert first.documents[-1] == lab.document
    assert len(first.documents) == before + 1
    lab.click("laboratory.close")
    lab.type_into("row_knots.C_4.r", "0.33")
    assert len(first.documents) == before + 1


def test_a_drag_with_a_panel_open_tells_it_once_a_turn(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    lab.field("row_knots.C_4.r").setFocus()
    lab.settle()
    before = len(panel.documents)
    lab.drag_slider("row_knots.slider", [5, 5, 5, 5])
    assert before < len(panel.documents) <= before + 4
    assert panel.documents[-1] == lab.document


def test_the_focus_is_the_knot_or_point_that_came_last(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    lab.field("column_knots.K_2.v").setFocus()
    lab.settle()
    assert panel.foci[-1] == KnotPlace(Direction.COLUMNS, 2, "u")
    lab.field("control_points.P_3_1.z").setFocus()
    lab.settle()
    assert panel.foci[-1] == (3, 1)
    lab.window.view.point_selected.emit((2, 2))
    lab.settle()
    assert panel.foci[-1] == (2, 2)
    lab.window.view.point_selected.emit(None)
    lab.settle()
    assert panel.foci[-1] is None
    lab.field("row_knots.C_0.t").setFocus()
    lab.window.view.point_selected.emit(None)
    lab.settle()
    assert panel.foci[-1] == KnotPlace(Direction.ROWS, 0, "t")


def test_panels_follow_the_theme(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    set_theme(ThemeName.DARK)
    lab.settle()
    assert panel.themes == [theme_of(ThemeName.LIGHT), theme_of(ThemeName.DARK)]


def test_a_panel_can_open_a_document_edit_and_speak(lab):
    lab.trigger("laboratory_first")
    panel = diary(lab, "first")
    panel.told.emit("It is so.", False)
    assert lab.message() == "It is so."
    panel.values_edited.emit({KnotPlace(Direction.ROWS, 4, "r"): 0.25}, 7)
    lab.settle()
    assert {knots.r for knots in lab.document.row_knots} == {0.25}  # the curves are linked
    lab.trigger("undo")
    assert lab.document == preset("fig5").document
    panel.document_requested.emit(preset("fig6c").document, "a counterexample")
    lab.settle()
    assert lab.document == preset("fig6c").document
    assert "a counterexample" in lab.window.windowTitle()
    assert not lab.window.session.is_changed
    assert lab.window.session.path is None


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
    window.workspace._splitters["laboratory"].setSizes([400, 260])
    first.settle()
    height = window.workspace.laboratory.height()
    first.trigger("laboratory_first")
    first.discard()
    again = Editor(MainWindow(None, Preferences()), (1440, 900))
    assert not again.window.workspace.laboratory.isVisible()
    again.trigger("laboratory_first")
    assert again.window.workspace.laboratory.height() == pytest.approx(height, abs=2)
    again.discard()


def test_view_and_panel_have_room_in_a_small_window(make_editor):
    editor = make_editor(size=(1280, 720))
    editor.trigger("laboratory_curve")
    assert (editor.window.width(), editor.window.height()) == (1280, 720)
    assert editor.window.view.height() >= 240
    assert editor.window.workspace.laboratory.height() >= 250
    for name in ("surface.configure", "surface.matrix", "row_knots.C_0.t"):
        assert not editor.find(name).visibleRegion().isEmpty()


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
