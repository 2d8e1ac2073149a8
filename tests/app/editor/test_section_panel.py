"""The panel of sections: what it draws, says and copies is the section of the surface that is shown."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QComboBox, QLabel, QSlider

from qovr_app.state.intents import FormulationChosen
from qovr_app.state.looking_intents import Picking, Selected
from qovr_app.style.palette import theme_in_force
from qovr_core.geometry.section import plane_across, section, upright_plane


@pytest.fixture
def lab(make_editor):
    editor = make_editor("paper:fig6a", size=(1280, 720))
    editor.trigger("laboratory_section")
    return editor


def drawn(lab):
    plot = lab.find("laboratory.section.plot")
    return [np.stack(line.getData(), axis=1) for line in plot.lines if line.getData()[0] is not None]


def expected(lab, plane):
    state = lab.window.store.shown
    return section(state.evaluation.layer_patch(state.display.layer.layers[0]), plane)[1]


def assert_shows(lab, plane):
    pieces = expected(lab, plane)
    assert pieces
    shown = [line for line in drawn(lab) if len(line)]
    assert len(shown) == len(pieces)
    for line, piece in zip(shown, pieces, strict=True):
        assert line == pytest.approx(plane.drawn(piece.points))
    total = sum(piece.length for piece in pieces)
    assert f"{total:.4g}" in lab.find("laboratory.section.words", QLabel).text()


def section_pixels(lab):
    image = lab.window.view.image()
    colour = np.array(theme_in_force().section)
    pixels = [image.pixelColor(x, y) for x in range(150, image.width(), 3) for y in range(80, image.height())]
    return sum(np.abs(np.array(pixel.getRgb()[:3]) - colour).max() < 30 for pixel in pixels)


def test_it_cuts_where_it_is_told_and_follows_the_document(lab):
    assert_shows(lab, plane_across(1, None))
    lab.type_into("laboratory.section.place", "1.5")
    assert_shows(lab, plane_across(1, 1.5))
    lab.find("laboratory.section.plane", QComboBox).setFocus()
    lab.key(Qt.Key.Key_Up, widget=lab.find("laboratory.section.plane", QComboBox))
    lab.settle()
    assert lab.find("laboratory.section.plane", QComboBox).currentText() == "x ="
    assert_shows(lab, plane_across(0, None))
    slider = lab.find("laboratory.section.slider", QSlider)
    lab.key(Qt.Key.Key_PageUp, widget=slider)
    place = lab.window.store.state.display.section.place
    assert place == pytest.approx(2 + 4 * 0.01, abs=1e-9)
    assert_shows(lab, plane_across(0, place))
    lab.dispatch(FormulationChosen("interpolating"))
    assert_shows(lab, plane_across(0, place))
    lab.type_into("laboratory.section.place", "77")
    assert "does not meet" in lab.find("laboratory.section.words", QLabel).text()
    assert not any(len(line) for line in drawn(lab))


def test_two_selected_points_carry_the_plane_and_its_points_are_copied(lab):
    box = lab.find("laboratory.section.plane", QComboBox)
    lab.dispatch(Selected((0, 0), (), Picking.REPLACE))
    box.activated.emit(3)
    lab.settle()
    assert "Select two control points first" in lab.message()
    assert box.currentIndex() == 1
    lab.dispatch(Selected((4, 3), ((0, 0),), Picking.REPLACE))
    box.activated.emit(3)
    lab.settle()
    net = lab.document.control_points
    plane = upright_plane(net[0, 0], net[4, 3])
    assert_shows(lab, plane)
    assert not lab.find("laboratory.section.place").isVisible()
    lab.click("laboratory.section.copy")
    head, *lines = (line.split("\t") for line in QApplication.clipboard().text().splitlines())
    assert head[:6] == ["piece", "u", "v", "x", "y", "z"]
    (piece,) = expected(lab, plane)
    numbers = np.array(lines, dtype=float)
    assert np.array_equal(numbers[:, 1:3], piece.parameters)
    assert np.array_equal(numbers[:, 3:6], piece.points)


def test_it_is_in_the_view_while_the_panel_is_shown(lab):
    assert section_pixels(lab) > 20
    lab.trigger("laboratory_section")
    assert section_pixels(lab) == 0
