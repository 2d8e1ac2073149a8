"""The comparison in the laboratory: another surface in the view, and the measures of all of them."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QLabel, QTableWidget

from qovr_app.laboratory.comparison_panel import ComparisonPanel
from qovr_app.state.intents import FormulationChosen
from qovr_app.state.looking_intents import Picking
from qovr_app.work import quiet
from qovr_core import Formulation
from qovr_core.laboratory.comparison import compare, compared_names
from qovr_core.laboratory.comparison_report import ROWS, surface_titles
from support.editor import wait_until

SURFACES = list(compared_names())


@pytest.fixture
def editor(make_editor):
    return compared(make_editor)


def compared(make_editor):
    made = make_editor()
    made.dispatch(FormulationChosen(str(Formulation.INTERPOLATING)))
    made.trigger("laboratory_comparison")
    return made


def panel(editor):
    return editor.find("laboratory.comparison", ComparisonPanel)


def table(editor):
    return editor.find("laboratory.comparison.table", QTableWidget)


def scenes(editor):
    view = editor.window.view
    return [view.picture(k).scene for k in range(len(view.viewports))]


def texts(editor):
    cells = table(editor)
    columns = range(1, cells.columnCount())
    return [[cells.item(row, column).text() for column in columns] for row in range(cells.rowCount())]


def expected(document, **options):
    comparison = compare(document, **options)
    size = comparison.of.document.net_size
    return [[row.text(comparison.measures[surface], size) for surface in SURFACES] for row in ROWS]


def measured(editor):
    wait_until(lambda: panel(editor).is_current)
    return texts(editor)


def test_the_table_holds_what_the_library_measures_and_follows_every_edit(editor):
    titles = [table(editor).horizontalHeaderItem(column).text() for column in range(1, table(editor).columnCount())]
    assert titles == list(surface_titles().values())
    assert measured(editor) == expected(editor.document)
    editor.type_into("control_points.P_2_2.z", "1.25", Qt.Key.Key_Return)
    assert not panel(editor).is_current
    assert measured(editor) == expected(editor.document)
    editor.trigger("undo")
    assert measured(editor) == expected(editor.document)


def test_old_numbers_are_pale_until_there_are_new_ones(editor):
    measured(editor)
    strong = table(editor).item(0, 1).foreground().color()
    editor.type_into("row_knots.C_4.r", "0.4")
    assert table(editor).item(0, 1).foreground().color() != strong
    assert texts(editor)[0][0]
    measured(editor)
    assert table(editor).item(0, 1).foreground().color() == strong


def test_the_selected_point_is_the_one_that_moves(editor):
    assert "<sub>2,2</sub>" in editor.find("laboratory.comparison.state", QLabel).text() or measured(editor)
    editor.window.view.points_picked.emit(((1, 3),), Picking.REPLACE)
    editor.settle()
    assert measured(editor) == expected(editor.document, point=(1, 3))
    assert "<sub>1,3</sub> moves by" in editor.find("laboratory.comparison.state", QLabel).text()
    assert "P 1 3" in editor.field("laboratory.comparison.weight").accessibleName()
    editor.field("column_knots.K_2.v").setFocus()
    editor.settle()
    assert panel(editor).is_current  # a knot in focus moves nothing


def test_the_weight_is_live_in_table_and_view(editor):
    editor.choose("laboratory.comparison.surface", "NURBS")
    before = scenes(editor)[0].lines
    editor.type_into("laboratory.comparison.weight", "25")
    assert not (scenes(editor)[0].lines == before).all()
    assert measured(editor) == expected(editor.document, weight=25.0)


@pytest.mark.parametrize("bad", ["0", "-3", "heavy"])
def test_a_weight_that_is_none_is_refused_in_words(editor, bad):
    measured(editor)
    editor.type_into("laboratory.comparison.weight", bad)
    assert "the weight is" in editor.message()
    assert "expected" in editor.message()
    assert panel(editor).is_current


def test_a_surface_lies_over_or_beside_qovr_or_nowhere(editor):
    (only,) = scenes(editor)
    assert only.lines_name == "B-spline"
    editor.choose("laboratory.comparison.placement", "beside QOVR")
    assert [scene.name for scene in scenes(editor)] == ["QOVR", "B-spline"]
    editor.choose("laboratory.comparison.surface", "Catmull-Rom")
    assert [scene.name for scene in scenes(editor)] == ["QOVR", "Catmull-Rom"]
    editor.choose("laboratory.comparison.placement", "not in the view")
    (only,) = scenes(editor)
    assert only.lines_name == ""


def test_it_leaves_the_view_with_the_panel_and_comes_back_with_it(editor):
    editor.choose("laboratory.comparison.placement", "beside QOVR")
    editor.click("laboratory.close")
    assert len(scenes(editor)) == 1
    editor.trigger("laboratory_comparison")
    assert len(scenes(editor)) == 2
    editor.trigger("laboratory_curve")
    assert len(scenes(editor)) == 1


def test_the_distance_map_colours_both_and_gives_the_colours_back(editor):
    view = editor.window.view
    editor.trigger("colour_by_mean")
    editor.choose("laboratory.comparison.placement", "beside QOVR")
    switch = editor.find("laboratory.comparison.distance_map", QAbstractButton)
    editor.click(switch.objectName())
    assert view.shown.settings.colour_by == "distance"
    pictures = [view.picture(k) for k in (0, 1)]
    assert [each.colouring.title for each in pictures] == ["Distance from B-spline", "Distance from QOVR"]
    assert pictures[0].colouring.limits == pictures[1].colouring.limits
    editor.click(switch.objectName())
    assert view.shown.settings.colour_by == "mean"
    editor.trigger("colour_by_distance")
    assert switch.isChecked()
    editor.trigger("colour_by_gaussian")
    assert not switch.isChecked()


@pytest.mark.parametrize("leave", ["nowhere", "close"])
def test_the_distance_map_ends_with_the_comparison(editor, leave):
    editor.click("laboratory.comparison.distance_map")
    assert editor.window.view.shown.settings.colour_by == "distance"
    if leave == "close":
        editor.click("laboratory.close")
    else:
        editor.choose("laboratory.comparison.placement", "not in the view")
        assert not editor.find("laboratory.comparison.distance_map").isEnabled()
    assert editor.window.view.shown.settings.colour_by == "height"


def test_the_numbers_can_be_copied_whole_and_in_part(editor):
    measured(editor)
    editor.click("laboratory.comparison.copy")
    lines = QGuiApplication.clipboard().text().splitlines()
    assert lines[1].split("\t") == ["measure", *surface_titles().values()]
    cells = {line.split("\t")[0]: line.split("\t")[1:] for line in lines[2:]}
    energies = [float(text) for text in cells["bending energy"]]
    assert energies == [measures.bending_energy for measures in compare(editor.document).measures.values()]
    assert cells["curvature jump"][0] == ""
    table(editor).setCurrentCell(0, 1)
    editor.key(Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier, widget=table(editor))
    assert QGuiApplication.clipboard().text() == f"{texts(editor)[0][0]}\n"


def test_a_drag_is_not_held_up_by_measuring(make_editor, monkeypatch):
    """Every move of a drag sends the measuring back to its start; it begins when nothing has moved for a while."""
    monkeypatch.setattr(quiet, "QUIET_MILLISECONDS", 3000)  # longer than the slowest machine takes for a drag
    editor = compared(make_editor)
    measured(editor)
    editor.field("row_knots.C_4.r").setFocus()
    editor.settle()
    editor.drag_slider("row_knots.slider", [4, 4, 4])
    assert not panel(editor).is_current
    assert not panel(editor).work.is_running
    assert measured(editor) == expected(editor.document)


def test_a_closed_panel_measures_nothing(editor):
    measured(editor)
    editor.click("laboratory.close")
    editor.type_into("control_points.P_2_2.z", "2", Qt.Key.Key_Return)
    QTest.qWait(500)
    assert not panel(editor).work.is_running
    editor.trigger("laboratory_comparison")
    assert measured(editor) == expected(editor.document)


def test_a_net_in_one_place_has_nothing_to_measure(editor):
    measured(editor)
    QGuiApplication.clipboard().setText("\n".join(["1\t2\t3"] * 25))
    editor.find("control_points.P_0_0.x").setFocus()
    editor.key(Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier)
    state = editor.find("laboratory.comparison.state", QLabel)
    wait_until(lambda: "Nothing to measure" in state.text())
    assert "all lie in one place" in state.text()
    assert not any(any(row) for row in texts(editor))
    assert not editor.find("laboratory.comparison.copy").isEnabled()
    editor.trigger("undo")
    assert measured(editor) == expected(editor.document, point=(0, 0))  # whose field has the keyboard


def test_everything_has_a_name_for_the_ear(editor):
    for name in ("surface", "placement", "weight", "table"):
        assert editor.find(f"laboratory.comparison.{name}").accessibleName()
    measured(editor)
    spoken = table(editor).item(0, 2).data(Qt.ItemDataRole.AccessibleTextRole)
    assert spoken.startswith("largest displacement, Bezier: ")


def test_a_point_dragged_in_the_other_picture_moves_both_surfaces(editor):
    editor.choose("laboratory.comparison.placement", "beside QOVR")
    before = editor.document.control_points.copy()
    viewport = editor.window.view.viewports[1]
    navigated = QPoint(viewport.width() // 2, viewport.height() // 2)
    QTest.mouseMove(viewport, navigated)
    editor.window.view.points_dragged.emit(((2, 2),), np.array([[0.0, 0.0, 1.0]]), 77)
    editor.settle()
    own, other = scenes(editor)
    assert editor.document.control_points[2, 2, 2] == before[2, 2, 2] + 1
    assert other.surface.net[2, 2, 2] == before[2, 2, 2] + 1
    assert own.document == editor.document
