"""The panel of one curve: what it shows is the curve of the document, and its handles are the knots."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QLabel,
    QScrollArea,
    QSlider,
    QSpinBox,
)

from qovr_app.laboratory.curve_drawings import Drawing
from qovr_app.state.display import ThemeName
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.intents import FormulationChosen
from qovr_app.style.palette import set_theme
from qovr_core import FileError, Formulation, curve_network
from qovr_core.edits import Direction, KnotPlace, set_values
from qovr_core.geometry.bernstein import basis
from qovr_core.geometry.combs import comb_changes
from qovr_core.geometry.weights import CURVE_DEGREE
from qovr_core.laboratory.one_curve import SAMPLES, curve_of
from qovr_core.laboratory.planes import View, plane_of
from support.editor import wait_until

_BETWEEN_MOVES = 20
"""Milliseconds; the plots take no more than a hundred moves of the mouse in a second."""


@pytest.fixture
def panel(share_editor):
    editor = share_editor("paper:fig6c")
    editor.trigger("laboratory_curve")
    panel = editor.find("laboratory.curve")
    panel.editor = editor
    yield panel
    set_theme(ThemeName.LIGHT)


def plot_of(panel, name):
    return panel.editor.find(f"laboratory.curve.{name}")


def caption(panel, name):
    """Return a caption as the eye reads it."""
    return re.sub("<[^>]*>|&nbsp;", " ", panel.editor.find(f"laboratory.curve.{name}.caption", QLabel).text())


def pixel_of(plot, x, y):
    return plot.mapFromScene(plot.view_box.mapViewToScene(QPointF(x, y)))


def drag(panel, handle, moves):
    """Drag a handle of the transformations by pixels, one move after the other."""
    plot = plot_of(panel, "transformations")
    at = plot.handle_at(handle).toPoint()
    QTest.mousePress(plot, Qt.MouseButton.LeftButton, pos=at)
    for move in moves:
        at += move
        QTest.mouseMove(plot, at)
        panel.editor.settle()
    QTest.mouseRelease(plot, Qt.MouseButton.LeftButton, pos=at)
    panel.editor.settle()


def assert_shows(panel, document, direction, number):
    curve = curve_of(document, direction, number)
    assert (panel.curve.direction, panel.curve.number, panel.curve.knots) == (direction, number, curve.knots)
    geometry = plot_of(panel, "geometry")
    lines = [np.stack(line.getData(), axis=1) for line in geometry.listDataItems() if line.getData()[0] is not None]
    wanted = plane_of(curve.points, View.BEST).drawn(curve.at(SAMPLES))
    assert any(line.shape == wanted.shape and line == pytest.approx(wanted) for line in lines)
    for name, values in (("blends", curve.blends), ("weights", curve.weights)):
        shown = plot_of(panel, name).values
        assert pytest.approx(values(SAMPLES)) == shown
    assert plot_of(panel, "transformations").knots == curve.knots


def test_it_shows_the_curve_of_the_knot_in_focus(panel):
    editor = panel.editor
    assert_shows(panel, editor.document, Direction.ROWS, 4)
    editor.field("column_knots.K_2.v").setFocus()
    editor.settle()
    assert editor.find("laboratory.curve.choice", QComboBox).currentText() == "K₂(v)"
    assert_shows(panel, editor.document, Direction.COLUMNS, 2)
    editor.field("control_points.P_1_3.z").setFocus()
    editor.settle()
    assert_shows(panel, editor.document, Direction.COLUMNS, 3)
    editor.choose("laboratory.curve.choice", "C₀(u)")
    assert_shows(panel, editor.document, Direction.ROWS, 0)
    assert "no effect on the published surface" in caption(panel, "geometry")
    editor.dispatch(FormulationChosen(str(Formulation.INTERPOLATING)))
    editor.settle()
    assert "no effect" not in caption(panel, "geometry")
    assert panel.curve.decimals is None


def test_it_follows_a_drag_at_most_once_a_turn_and_then_shows_it(panel):
    editor = panel.editor
    editor.field("row_knots.C_4.s").setFocus()
    editor.settle()
    shown = []
    geometry = plot_of(panel, "geometry")
    draw = geometry.show_curve
    geometry.show_curve = lambda *what: shown.append(None) or draw(*what)
    editor.drag_slider("row_knots.slider", [4, 4, 4, 4, 4, 4])
    assert 1 <= len(shown) <= 6
    assert_shows(panel, editor.document, Direction.ROWS, 4)
    assert editor.document.row_knots[4, 0].s > 0.6


def test_the_curve_is_the_one_the_formulation_computes(panel):
    editor = panel.editor
    editor.type_into("row_knots.C_4.r", "0.3")
    assert panel.curve.decimals == 4
    network = curve_network(editor.document)
    drawn = basis(CURVE_DEGREE, SAMPLES) @ network.rows[:, 0][4]
    assert panel.curve.at(SAMPLES) == pytest.approx(drawn, abs=1e-14)
    exact = curve_of(set_values(editor.document, {KnotPlace(Direction.ROWS, 4, "r"): 0.3}), Direction.ROWS, 4).at(
        SAMPLES
    )
    assert panel.curve.at(SAMPLES) == pytest.approx(exact)


def test_a_handle_drags_its_knot_live_and_as_one_step(panel):
    editor = panel.editor
    before = editor.document
    drag(panel, "r", [QPoint(0, -8)] * 4)
    knots = editor.document.row_knots.in_window(0)
    assert {curve.r for curve in knots} == {knots[0].r}  # the curves are linked
    assert 0.4 < knots[0].r < 1
    assert round(knots[0].r, 3) == knots[0].r
    assert knots[0].s == 0.6
    assert editor.window.store.state.history.undo_text == "Set r_ip of C_0..C_4"
    editor.trigger("undo")
    assert editor.document == before

    drag(panel, "u", [QPoint(-6, 0)] * 3)
    knots = editor.document.row_knots[4, 0]
    assert knots.u < 0.7
    assert knots.s == 0.6
    assert plot_of(panel, "transformations").knots == knots
    assert editor.find("row_knots.transformations").knots == knots
    editor.trigger("undo")
    assert editor.document == before
    drag(panel, "t", [QPoint(0, 300)] * 3)
    assert editor.document.row_knots[4, 0].t == 0.001  # no farther than a slider goes


def test_a_handle_respects_the_links_and_staged_edits(panel):
    editor = panel.editor
    editor.trigger("link_curves")
    drag(panel, "r", [QPoint(0, -10)] * 2)
    assert editor.document.row_knots[4, 0].r != 0.4
    assert {curve.r for curve in editor.document.row_knots.in_window(0)[:4]} == {0.4}
    editor.trigger("live")
    document = editor.document
    drag(panel, "t", [QPoint(0, -10)] * 2)
    assert editor.document == document
    assert editor.field("row_knots.C_4.t").is_pending
    assert plot_of(panel, "transformations").knots == document.row_knots[4, 0]


def test_the_fold_back_is_said(panel):
    editor = panel.editor
    editor.window.resize(1900, 1000)  # where the caption has room for it
    for knot, value in (("r", 0.5), ("s", 0.2), ("t", 0.5)):
        editor.type_into(f"row_knots.C_4.{knot}", str(value))
    editor.type_into("row_knots.C_4.u", "0.5")
    assert "folds" not in caption(panel, "transformations")
    editor.type_into("row_knots.C_4.u", "0.2")
    assert "folds back 0.65 to 0.907" in " ".join(caption(panel, "transformations").split())
    editor.type_into("row_knots.C_4.s", "0.98")
    plot = plot_of(panel, "transformations")
    assert plot.rect().contains(plot.handle_at("s").toPoint())


def test_the_comb_stands_on_the_curve_and_its_number_over_it(panel):
    geometry = plot_of(panel, "geometry")

    def lines():
        found = [np.stack(line.getData(), axis=1) for line in geometry.listDataItems() if line.getData()[0] is not None]
        return [line for line in found if len(line)]

    without = len(lines())
    panel.editor.find("laboratory.curve.comb", QCheckBox).click()
    panel.editor.settle()
    feet = plane_of(panel.curve.points, View.BEST).drawn(panel.curve.at(SAMPLES))
    assert len(lines()) == without + 2
    (teeth,) = (line.reshape(-1, 3, 2) for line in lines() if np.isnan(line).any())
    assert teeth[:, 0] == pytest.approx(feet[::2])
    (changes,) = comb_changes([panel.curve.coefficients])
    assert f"comb changes {changes:.4g}" in caption(panel, "geometry")
    before = np.nanmax(np.abs(teeth[:, 1] - teeth[:, 0]))
    slider = panel.editor.find("laboratory.curve.comb_scale", QSlider)
    for _ in range(6):
        panel.editor.key(Qt.Key.Key_Right, widget=slider)
    (longer,) = (line.reshape(-1, 3, 2) for line in lines() if np.isnan(line).any())
    scale = panel.editor.window.store.state.display.comb_scale
    assert scale == pytest.approx(10**0.3)
    assert np.nanmax(np.abs(longer[:, 1] - longer[:, 0])) == pytest.approx(scale * before)
    panel.editor.find("laboratory.curve.comb", QCheckBox).click()
    panel.editor.settle()
    assert len(lines()) == without
    assert "comb" not in caption(panel, "geometry")


def test_hovering_says_the_values(panel):
    plot = plot_of(panel, "weights")

    def read():
        found = re.search(r"u = (\d\.\d+)", " ".join(caption(panel, "geometry").split()))
        return found and float(found[1])

    def is_read():
        for x in (0.2, 0.25):
            QTest.qWait(_BETWEEN_MOVES)
            QTest.mouseMove(plot.viewport(), pixel_of(plot, x, 0.5))
        return read() == pytest.approx(0.25, abs=0.01)

    wait_until(is_read)
    u = read()
    values = {name: re.findall(r"[−\d]\d*\.\d+", caption(panel, name)) for name in ("blends", "weights")}
    numbers = {name: [float(text.replace("−", "-")) for text in texts] for name, texts in values.items()}
    assert numbers["blends"] == pytest.approx(panel.curve.blends([u])[0], abs=6e-3)
    assert numbers["weights"] == pytest.approx(panel.curve.weights([u])[0], abs=2e-2)
    geometry = plot_of(panel, "geometry")
    place = plane_of(panel.curve.points, View.BEST).drawn(panel.curve.at([0.6]))[0]
    geometry.hovered.emit(tuple(place))
    assert "u  = 0.600" in caption(panel, "geometry")
    geometry.hovered.emit(None)
    assert "degree 6" in caption(panel, "geometry")


def test_planes_and_scales(panel):
    editor = panel.editor
    geometry = plot_of(panel, "geometry")
    labels = [geometry.getAxis(side).labelText for side in ("bottom", "left")]
    assert labels == ["x", "z"]
    editor.find("laboratory.curve.plane", QComboBox).setCurrentText("y, z")
    editor.settle()
    assert [geometry.getAxis(side).labelText for side in ("bottom", "left")] == ["y", "z"]
    editor.find("laboratory.curve.plane", QComboBox).setCurrentText("Best plane")
    editor.find("laboratory.curve.equal_scales", QCheckBox).click()
    editor.settle()
    width, height = geometry.view_box.viewPixelSize()
    assert width == pytest.approx(height)


def test_it_follows_light_and_dark(panel):
    for name, is_dark in ((ThemeName.DARK, True), (ThemeName.LIGHT, False)):
        set_theme(name)
        panel.editor.settle()
        for plot in ("geometry", "blends", "weights", "transformations"):
            image = plot_of(panel, plot).grab().toImage()
            assert (image.pixelColor(image.width() - 3, 3).lightnessF() < 0.5) == is_dark


@pytest.mark.parametrize("kind", ["png", "svg", "pdf"])
def test_the_curve_is_saved_as_a_figure(panel, home, monkeypatch, kind):
    editor = panel.editor
    path = home / f"curve.{kind}"
    offered = []
    monkeypatch.setattr(
        QFileDialog, "getSaveFileName", lambda parent, title, first, kinds: offered.append(first) or (str(path), "")
    )
    editor.click("laboratory.curve.figure")
    dialog = next(child for child in editor.window.findChildren(QDialog) if child.windowTitle() == "Save Figure")
    dialog.findChild(QSpinBox, "figure.dpi").setValue(100)
    dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save).click()
    wait_until(lambda: f"Wrote {path}" in editor.message())
    assert offered[0].endswith("fig6c_C_4.png")
    if kind == "png":
        assert QImage(str(path)).size().toTuple() == (630, 472)
    elif kind == "svg":
        assert ET.parse(path).getroot().tag.endswith("svg")
    else:
        assert path.read_bytes().startswith(b"%PDF")


@pytest.mark.parametrize("drawing", Drawing)
def test_what_is_saved_can_be_chosen(panel, home, drawing):
    asked = []
    panel.store.answer_with(asked.append)
    panel.editor.find("laboratory.curve.drawing").setCurrentText(drawing)
    panel.editor.click("laboratory.curve.figure")
    (request,) = asked
    name, write = request.name, request.write
    assert name == ("network" if drawing is Drawing.NETWORK else "C_4")
    write(home / "a.svg", FigureOptions(width=120, height=90))
    size = ET.parse(home / "a.svg").getroot().get("viewBox").split()[2:]
    assert [float(side) / 72 * 25.4 for side in size] == pytest.approx([120, 90], abs=0.2)
    with pytest.raises(FileError, match="50 x 40 mm is too small for this figure"):
        write(home / "b.png", FigureOptions(width=50, height=40))
    with pytest.raises(FileError, match="by the file name's end"):
        write(home / "b.gif", FigureOptions())
    assert [path.name for path in home.iterdir()] == ["a.svg"]


def test_every_part_has_a_spoken_name_and_is_seen(make_editor):
    editor = make_editor(size=(1280, 720))
    editor.trigger("laboratory_curve")
    for name in ("choice", "plane", "geometry", "blends", "weights", "transformations"):
        widget = editor.find(f"laboratory.curve.{name}")
        assert widget.accessibleName()
        seen = widget.viewport() if hasattr(widget, "viewport") else widget
        parent = widget
        while (parent := parent.parentWidget()) is not None:
            if isinstance(parent, QScrollArea):
                parent.ensureWidgetVisible(widget.parentWidget())
        editor.settle()
        assert seen.visibleRegion().boundingRect() == seen.rect(), name


def test_a_window_with_the_panel_open_is_let_go(make_editor, spin):
    editor = make_editor("paper:fig5")
    editor.trigger("laboratory_curve")
    gone = []
    editor.find("laboratory.curve").destroyed.connect(lambda: gone.append(None))
    editor.discard()
    spin(lambda: bool(gone))


def test_the_plots_are_loaded_when_they_are_asked_for(app):
    code = (
        "import sys\nimport qovr_app.window.main_window\n"
        "assert not {'pyqtgraph', 'matplotlib', 'scipy'} & {name.split('.')[0] for name in sys.modules}"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
