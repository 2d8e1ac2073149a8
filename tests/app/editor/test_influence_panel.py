"""The influence panel as it is used: it follows focus and edits, says what edges do, and changes nothing."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QComboBox, QLabel, QTableWidget

from qovr_app.state.display import ColourMap, ThemeName
from qovr_app.state.intents import FormulationChosen, PointsMoved
from qovr_app.state.looking_intents import Picking
from qovr_app.style.colour_maps import colour_table
from qovr_app.style.palette import set_theme
from qovr_core import Edge, Formulation, Layer
from qovr_core.edits import Direction, KnotPlace
from qovr_core.laboratory.influence import KnotMove, PointMove, influence
from support.editor import wait_until

NAME = "laboratory.influence"


@pytest.fixture
def lab(make_editor):
    """An editor whose influence panel is open."""
    editor = make_editor()
    editor.trigger("laboratory_influence")
    yield editor
    set_theme(ThemeName.LIGHT)


def focus(lab, name):
    lab.field(name).setFocus()
    lab.settle()


def numbers(lab):
    """Return the table's lines by name."""
    table = lab.find(f"{NAME}.numbers", QTableWidget)
    return {table.item(row, 0).text(): table.item(row, 1).text() for row in range(table.rowCount())}


def words(lab):
    """Return what the panel says instead of showing something; empty where it shows something."""
    label = lab.find(f"{NAME}.words", QLabel)
    return label.text() if label.isVisible() else ""


def caption(lab, which):
    return lab.find(f"{NAME}.{which}_caption", QLabel).text()


def choose(lab, name, text):
    lab.find(f"{NAME}.{name}", QComboBox).setCurrentText(text)
    lab.settle()


def test_it_says_what_to_do_and_then_follows_point_and_knot(lab):
    lab.window.view.points_picked.emit(((1, 3),), Picking.REPLACE)
    lab.window.view.points_picked.emit((), Picking.REPLACE)
    lab.settle()
    assert "Select a control point" in words(lab)
    focus(lab, "control_points.P_2_2.z")
    assert words(lab) == ""
    expected = influence(lab.document, PointMove(2, 2, (0, 0, 0.57)), Layer.TRANSFORMED)
    assert numbers(lab)["Largest"] == f"{expected.largest:.4g}"
    assert numbers(lab)["Edge u = 0"] == f"{expected.edges[Edge.U0]:.4g}"
    focus(lab, "column_knots.K_1.v")
    expected = influence(lab.document, KnotMove(KnotPlace(Direction.COLUMNS, 1, "u"), 0.1), Layer.TRANSFORMED)
    assert numbers(lab)["Largest"] == f"{expected.largest:.4g}"
    assert lab.find(f"{NAME}.title", QLabel).text().startswith("<i>v</i><sub>ip</sub> of <i>K</i><sub>1</sub>")
    lab.window.view.points_picked.emit(((1, 3),), Picking.REPLACE)
    lab.settle()
    assert "1,3" in lab.find(f"{NAME}.title", QLabel).text()
    lab.window.view.points_picked.emit((), Picking.REPLACE)
    lab.settle()
    assert "Select a control point" in words(lab)


def test_it_is_live(lab):
    focus(lab, "control_points.P_2_2.z")
    assert numbers(lab)["Edge v = 0"] != "stays"
    lab.dispatch(FormulationChosen(str(Formulation.INTERPOLATING)))
    lab.settle()
    assert [numbers(lab)[f"Edge {p} = {end}"] for p in "uv" for end in "01"] == ["stays"] * 4
    assert (numbers(lab)["Corners"], numbers(lab)["Still at u"]) == ("stay", "0, 1")
    assert numbers(lab)["Exponential"] == "does not fit"
    before = numbers(lab)["at"]
    lab.type_into("row_knots.C_2.u", "0.35")
    focus(lab, "control_points.P_2_2.z")
    assert numbers(lab)["at"] != before


def test_a_surface_that_is_older_than_the_net_is_not_mixed_with_it(lab):
    lab.trigger("live")
    focus(lab, "control_points.P_2_2.z")
    lab.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, 0.4),)))
    lab.settle()
    expected = influence(lab.document, PointMove(2, 2, (0, 0, 0.57)), Layer.TRANSFORMED)
    assert lab.document.control_points[2, 2, 2] == 0.9
    assert numbers(lab)["Largest"] == f"{expected.largest:.4g}"
    assert numbers(lab)["Edge u = 0"] == f"{expected.edges[Edge.U0]:.4g}"


def test_the_surface_is_the_one_in_place_until_another_is_chosen(lab):
    focus(lab, "control_points.P_2_2.z")
    layer = lab.find(f"{NAME}.layer", QComboBox)
    assert layer.currentText() == "transformed"
    choose(lab, "layer", "raw")
    expected = influence(lab.document, PointMove(2, 2, (0, 0, 0.57)), Layer.RAW)
    assert numbers(lab)["Largest"] == f"{expected.largest:.4g}"
    lab.type_into("control_points.P_2_2.z", "0.6")
    assert layer.currentText() == "raw"
    lab.dispatch(FormulationChosen(str(Formulation.DOUBLE_SUM)))
    lab.settle()
    assert layer.currentText() == "transformed"


def test_a_knot_that_moves_nothing_is_explained(lab):
    focus(lab, "row_knots.C_2.s")
    assert "the published surface uses the row-wise knots of C_4 alone" in words(lab)
    assert not lab.find(f"{NAME}.copy").isEnabled()
    focus(lab, "row_knots.C_4.s")
    assert words(lab) == ""
    assert lab.find(f"{NAME}.copy").isEnabled()


def test_axis_and_amount_are_chosen_and_the_document_stays(lab):
    before = lab.document
    focus(lab, "control_points.P_1_2.x")
    choose(lab, "axis", "x")
    lab.type_into(f"{NAME}.amount", "-0,25")
    expected = influence(before, PointMove(1, 2, (-0.25, 0, 0)), Layer.TRANSFORMED)
    assert numbers(lab)["Largest"] == f"{expected.largest:.4g}"
    focus(lab, "control_points.P_3_3.z")
    assert lab.text(f"{NAME}.amount") == "-0.25"
    lab.click(f"{NAME}.default")
    assert lab.text(f"{NAME}.amount") == "0.57"
    assert not lab.find(f"{NAME}.default").isEnabled()
    lab.type_into(f"{NAME}.amount", "0")
    assert "the amount is 0; expected a number that moves something" in lab.message()
    assert lab.document == before
    assert lab.window.store.state.history.undo_text is None


def test_an_amount_that_takes_a_knot_out_of_its_interval_is_refused(lab):
    focus(lab, "row_knots.C_4.s")
    lab.type_into(f"{NAME}.amount", "0.5")
    assert "expected more than -0.5 and less than 0.5" in lab.message()
    lab.type_into(f"{NAME}.amount", "0.4")
    assert lab.message() == ""
    lab.type_into("row_knots.C_4.s", "0.7")
    focus(lab, "row_knots.C_4.s")
    assert "row_knots[4].s is 1.1" in words(lab)
    lab.click(f"{NAME}.default")
    assert words(lab) == ""


def test_a_knot_near_one_is_changed_downward(lab):
    lab.type_into("column_knots.K_0.t", "0.93")
    focus(lab, "column_knots.K_0.t")
    assert lab.text(f"{NAME}.amount") == "-0.1"


def test_numbers_are_copied_in_full(lab):
    focus(lab, "control_points.P_2_3.z")
    lab.click(f"{NAME}.copy")
    assert lab.message() == "Copied the influence of P 2,3 along z by 0.57"
    expected = influence(lab.document, PointMove(2, 3, (0, 0, 0.57)), Layer.TRANSFORMED)
    head, table = QGuiApplication.clipboard().text().split("\n\n")
    values = [line.split("\t") for line in head.splitlines()]
    assert values[:2] == [["change", "P 2,3 along z by 0.57"], ["surface", "published, transformed"]]
    assert float(dict(values)["largest displacement"]) == expected.largest
    assert float(dict(values)["largest motion of edge u=1"]) == expected.edges[Edge.U1]
    assert float(dict(values)["exponential L"]) == expected.falloff.exponential.length
    envelope = [[float(cell) for cell in line.split("\t")] for line in table.splitlines()[1:]]
    assert np.array_equal(envelope, expected.falloff.envelope)


def test_the_table_s_lines_are_copied_as_shown(lab):
    focus(lab, "control_points.P_2_3.z")
    table = lab.find(f"{NAME}.numbers", QTableWidget)
    table.selectRow(2)
    lab.key(Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier, table)
    assert QGuiApplication.clipboard().text() == f"Over 10 %\t{numbers(lab)['Over 10 %']}\n"


def test_the_map_lies_as_the_parameters_do(lab):
    lab.dispatch(FormulationChosen(str(Formulation.INTERPOLATING)))
    lab.settle()
    focus(lab, "control_points.P_1_3.z")
    found = influence(lab.document, PointMove(1, 3, (0, 0, 0.57)), Layer.RAW)
    picture = lab.find(f"{NAME}.map")
    square, image = picture.square(), picture.grab().toImage()
    table = colour_table(ColourMap.VIRIDIS).astype(int)
    for u, v in ((0.93, 0.12), (0.85, 0.3), (0.75, 0.15)):  # where no line is drawn
        at = QPointF(square.left() + u * square.width(), square.bottom() - v * square.height()).toPoint()
        colour = np.array(image.pixelColor(at).getRgb()[:3])
        part = np.linalg.norm(found.displacement.points([u], [v])) / found.largest
        assert np.abs(colour - table[int(part * 256)]).max() <= 14, (u, v)


def test_the_map_says_what_is_under_the_pointer(lab):
    focus(lab, "control_points.P_2_2.z")
    resting = caption(lab, "map")
    assert "10 %" in resting
    picture = lab.find(f"{NAME}.map")
    square = picture.square()
    at = QPoint(round(square.left() + 0.25 * square.width()), round(square.bottom() - 0.75 * square.height()))
    QTest.mouseMove(picture, at)
    wait_until(lambda: "<i>u</i> 0.2" in caption(lab, "map"))
    assert "<i>v</i> 0.7" in caption(lab, "map")
    QTest.mouseMove(picture, QPoint(1, 1))
    wait_until(lambda: caption(lab, "map") == resting)


def test_the_plot_shows_envelope_and_exponential_on_both_scales(lab):
    focus(lab, "control_points.P_2_2.z")
    found = influence(lab.document, PointMove(2, 2, (0, 0, 0.57)), Layer.TRANSFORMED)
    plot = lab.find(f"{NAME}.plot")
    distance, displacement = plot.envelope.getData()
    assert np.array_equal(np.column_stack([distance, displacement]), found.falloff.envelope)
    (low, high) = plot.getViewBox().viewRange()[1]
    assert (low, high > found.largest) == (0, True)
    lab.click(f"{NAME}.log")
    distance, logarithm = plot.envelope.getData()
    assert logarithm[0] == pytest.approx(np.log10(found.largest))
    exponential = np.polyfit(*plot.exponential.getData(), 1)
    assert exponential[0] == pytest.approx(-np.log10(np.e) / found.falloff.exponential.length, rel=1e-6)


def test_the_plot_says_what_is_under_the_pointer(lab):
    focus(lab, "control_points.P_2_2.z")
    resting = caption(lab, "plot")
    assert "envelope" in resting
    plot = lab.find(f"{NAME}.plot")
    plot.grab()  # its axes take their width when they are drawn
    lab.settle()
    at = plot.mapFromScene(plot.getViewBox().mapViewToScene(QPointF(0.3, 0.2)))
    QTest.mouseMove(plot.viewport(), at)
    wait_until(lambda: "<i>d</i>" in caption(lab, "plot") and "up to" in caption(lab, "plot"))
    read = float(caption(lab, "plot").split()[1].rstrip(":"))
    assert read == pytest.approx(0.3, abs=0.03)
    QTest.qWait(50)  # the plot looks at the pointer a hundred times a second
    QTest.mouseMove(plot.viewport(), QPoint(1, 1))
    wait_until(lambda: caption(lab, "plot") == resting)


def test_it_is_drawn_dark_where_the_window_is(lab):
    focus(lab, "control_points.P_2_2.z")
    light = lab.find(f"{NAME}.plot").grab().toImage().pixelColor(3, 3).lightness()
    set_theme(ThemeName.DARK)
    lab.settle()
    dark = lab.find(f"{NAME}.plot").grab().toImage().pixelColor(3, 3).lightness()
    assert light > 200
    assert dark < 60


def test_a_drag_computes_it_once_a_turn(lab, monkeypatch):
    from qovr_app.laboratory import influence_panel

    calls = []
    monkeypatch.setattr(
        influence_panel, "influence", lambda *arguments: calls.append(arguments) or influence(*arguments)
    )
    focus(lab, "row_knots.C_4.r")
    calls.clear()
    lab.drag_slider("row_knots.slider", [5, 5, 5, 5])
    assert 0 < len(calls) <= 4
    lab.click("laboratory.close")
    calls.clear()
    lab.type_into("row_knots.C_4.r", "0.33")
    assert calls == []


def test_it_fits_a_small_window(make_editor):
    editor = make_editor(size=(1280, 720))
    editor.trigger("laboratory_influence")
    focus(editor, "control_points.P_2_2.z")
    assert (editor.window.width(), editor.window.height()) == (1280, 720)
    panel = editor.find(NAME)
    for name in ("axis", "amount", "default", "layer", "copy", "log", "map", "plot", "numbers"):
        control = editor.find(f"{NAME}.{name}")
        assert control.accessibleName() or control.text()
        area = control.rect().translated(control.mapTo(panel, QPoint(0, 0)))
        assert panel.rect().contains(area), name
    table = editor.find(f"{NAME}.numbers", QTableWidget)
    for row in range(table.rowCount()):
        for column in (0, 1):
            needed = table.fontMetrics().horizontalAdvance(table.item(row, column).text())
            assert needed + 6 <= table.columnWidth(column), table.item(row, column).text()
