"""Distances and an angle, between places that are clicked."""

import math

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest

from qovr_app.state.display import LayerChoice
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.looking_intents import ToolChosen
from qovr_app.state.tools import ToolSettings
from qovr_app.view3d.words import measure_words
from qovr_core.edits import set_point
from support.view import change

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def owner(make_view, document):
    owner = make_view(document, layer=LayerChoice.RAW, at_rest=False)
    owner.view.set_camera("top", animated=False)
    change(owner.view, tools=ToolSettings(measures=True))
    return owner


def click(owner, expected_pixel, point):
    x, y = expected_pixel(owner.view, point)
    QTest.mouseClick(owner.view.viewports[0].widget, LEFT, pos=QPoint(round(x), round(y)))


def numbers(owner):
    return [[float(each) for each in line.split("\t")[1:]] for line in measure_words(owner.view.picture()).splitlines()]


def test_two_points_have_a_distance_and_three_an_angle(owner, document, expected_pixel):
    net = document.control_points
    for index in ((0, 0), (0, 3), (2, 3)):
        click(owner, expected_pixel, net[index])
    a, b, c = net[0, 0], net[0, 3], net[2, 3]
    first, second, (angle,) = numbers(owner)
    assert first == pytest.approx([math.dist(a, b), *(b - a)], rel=1e-15)
    assert second == pytest.approx([math.dist(b, c), *(c - b)], rel=1e-15)
    cosine = np.dot(a - b, c - b) / math.dist(a, b) / math.dist(b, c)
    assert angle == pytest.approx(math.degrees(math.acos(cosine)))
    assert "P 0,3 to P 2,3" in measure_words(owner.view.picture())
    assert owner.selections == []
    assert owner.drags == []
    click(owner, expected_pixel, net[4, 4])
    assert numbers(owner) == []


def test_what_is_measured_is_said_in_the_picture(owner, document, expected_pixel, tmp_path):
    for index in ((0, 0), (0, 3), (2, 3)):
        click(owner, expected_pixel, document.control_points[index])
    owner.view.image()
    owner.view.save_figure(tmp_path / "a.svg", FigureOptions(160, 120, 100))
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    first, _, (angle,) = numbers(owner)
    assert f"P 0,0 to P 0,3:  {first[0]:.6g}".replace("  ", " ") in " ".join(text.split())
    assert f"{angle:.6g}°" in text


def test_what_is_measured_follows_an_edit(owner, document, expected_pixel):
    for index in ((0, 0), (1, 1)):
        click(owner, expected_pixel, document.control_points[index])
    owner.show(set_point(document, 1, 1, (1.0, 1.0, 7.0)))
    assert numbers(owner)[0][3] == pytest.approx(7.0 - document.control_points[0, 0, 2])


def test_places_on_the_surface_are_measured_exactly(owner, expected_pixel):
    surface = owner.view.picture().scene.surface
    at = [surface.points([u], [v])[0, 0] for u, v in ((0.31, 0.4), (0.62, 0.57))]
    for point in at:
        click(owner, expected_pixel, point)
    ((length, *way),) = numbers(owner)
    assert way == pytest.approx(at[1] - at[0], abs=0.02)
    assert length == pytest.approx(math.hypot(*way), rel=1e-14)


def test_a_drag_turns_the_view_and_a_click_beside_everything_begins_anew(owner, document, expected_pixel):
    viewport, point = owner.view.viewports[0].widget, document.control_points[2, 2]
    click(owner, expected_pixel, document.control_points[0, 0])
    before, (x, y) = owner.view.camera, expected_pixel(owner.view, point)
    QTest.mousePress(viewport, LEFT, pos=QPoint(round(x), round(y)))
    QTest.mouseMove(viewport, QPoint(round(x) + 40, round(y) + 25))
    QTest.mouseRelease(viewport, LEFT, pos=QPoint(round(x) + 40, round(y) + 25))
    assert owner.view.camera != before
    assert owner.drags == []
    assert len(owner.view.picture().spots) == 1
    QTest.mouseClick(viewport, LEFT, pos=QPoint(3, 3))
    assert owner.view.picture().spots == ()


def test_escape_puts_the_tool_down(owner):
    wanted = []
    owner.view.wanted.connect(wanted.append)
    QTest.keyClick(owner.view.viewports[0].widget, Qt.Key.Key_Escape)
    assert wanted == [ToolChosen("measures", value=False)]
