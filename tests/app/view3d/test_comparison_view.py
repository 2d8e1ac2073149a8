"""Another surface of the same control net beside the document's own, or over it."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QImage, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice, Placement, Style
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.tools import ToolSettings
from qovr_app.view3d.scene.comparison import ComparisonView
from qovr_core.edits import set_formulation, set_point
from qovr_core.fields import Field
from qovr_core.geometry.closest import closest_points
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.laboratory.comparison_surfaces import COMPARISON_SURFACES, ComparisonSurface
from qovr_core.laboratory.splines import b_spline, bezier
from support.view import change, choose, grid


def compared(placement):
    return ComparisonView(COMPARISON_SURFACES["b-spline"], placement)


@pytest.fixture(params=["opengl", "painter"])
def owner(request, make_view, document):
    if request.param == "painter":
        request.getfixturevalue("no_opengl")
    return make_view(document, layer=LayerChoice.RAW, size=(900, 480))


def test_beside_it_has_a_viewport_with_its_name_and_the_same_camera_and_limits(owner):
    view = owner.view
    assert [view.picture(k).caption for k in range(len(view.viewports))] == [""]
    change(view, comparison=compared(Placement.BESIDE))
    assert [view.picture(k).caption for k in range(len(view.viewports))] == ["QOVR, raw", "B-spline"]
    own, other = (view.picture(k).scene for k in (0, 1))
    np.testing.assert_array_equal(own.frame.limits, other.frame.limits)
    view.set_camera("top", animated=False)
    assert view.picture(0).camera == view.picture(1).camera
    change(view, comparison=None)
    assert len(view.viewports) == 1
    assert view.picture().scene.companions.reference is None


def test_with_both_layers_it_stands_at_the_right_of_both(make_view, document):
    view = make_view(document, layer=LayerChoice.BOTH, size=(1200, 400)).view
    change(view, comparison=compared(Placement.BESIDE))
    assert [view.picture(k).caption for k in range(3)] == ["QOVR, raw", "Transformed", "B-spline"]


def test_the_limits_hold_what_reaches_beyond_the_net(owner, document):
    view = owner.view

    def stretched(net, _point, _weight):
        return bezier(net).transformed(np.diag([3.0, 1.0, 1.0, 1.0]))

    kind = ComparisonSurface("stretched", "Stretched", "A surface that reaches beyond its net.", stretched)
    change(view, comparison=ComparisonView(kind, Placement.BESIDE))
    assert view.picture().scene.frame.limits[0, 1] >= 12
    change(view, comparison=None)
    assert view.picture().scene.frame.limits[0, 1] < 12


@pytest.mark.parametrize("by", ["height", "mean", "distance"])
def test_a_colour_means_the_same_in_both(make_view, document, by):
    view = make_view(document, layer=LayerChoice.RAW, size=(900, 480), style=Style.SMOOTH, colour_by=by).view
    change(view, comparison=compared(Placement.BESIDE))
    pictures = [view.picture(k) for k in (0, 1)]
    assert pictures[0].colouring.limits == pictures[1].colouring.limits
    values = np.concatenate([each.colouring.values(each.grid).ravel() for each in pictures])
    reach = np.abs(values).max()
    expected = (-reach, reach) if by == "mean" else (values.min(), values.max())
    assert pictures[0].colouring.limits == pytest.approx(expected, abs=1e-3)


def test_distances_are_those_of_each_from_the_other(make_view, document):
    view = make_view(document, layer=LayerChoice.RAW, style=Style.SMOOTH, colour_by="distance").view
    change(view, comparison=compared(Placement.BESIDE))
    own, other = (view.picture(k) for k in (0, 1))
    assert own.colouring.title == "Distance from B-spline"
    assert other.colouring.title == "Distance from QOVR"
    t = np.linspace(0, 1, 5)
    for one, two in ((own.scene, other.scene), (other.scene, own.scene)):
        expected = closest_points(two.surface, one.surface.points(t, t).reshape(-1, 3)).distance
        np.testing.assert_allclose(one.values(Field.DISTANCE, grid(5, 5), moving=False).ravel(), expected, atol=1e-12)


def test_it_has_no_knots_to_be_sensitive_to(make_view, document):
    view = make_view(document, layer=LayerChoice.RAW, colour_by="sensitivity").view
    change(view, comparison=compared(Placement.BESIDE))
    assert view.picture(1).colouring.note == "A B-spline surface has no internal knots"


@pytest.mark.parametrize("order", ["comparison first", "knot first"])
def test_beside_a_surface_coloured_by_a_sensitivity_it_is_drawn_without_a_fault(owner, document, order):
    view = owner.view
    owner.show(set_formulation(document, "published"))
    knot = KnotPlace(Direction.ROWS, 4, "s")
    steps = [{"comparison": compared(Placement.BESIDE)}, {"knot": knot}]
    choose(view, colour_by="sensitivity", probe=True)
    for step in steps if order == "comparison first" else steps[::-1]:
        change(view, **step)
        view.image()
    for viewport in view.viewports:
        QTest.mouseMove(viewport.widget, QPoint(*(round(side / 2) for side in viewport.logical_size)))
        view.image()
    change(view, knot=None)
    view.image()
    assert owner.faults == []


def test_the_colours_of_a_sensitivity_are_those_of_the_surface_that_has_the_knot(owner):
    change(owner.view, knot=KnotPlace(Direction.ROWS, 2, "s"))
    choose(owner.view, colour_by="sensitivity")
    alone = owner.view.picture().colouring.limits
    change(owner.view, comparison=compared(Placement.BESIDE))
    assert owner.view.picture(0).colouring.limits == alone
    assert owner.view.picture(1).colouring.note


def test_an_edit_moves_both(owner, document):
    view = owner.view
    change(view, comparison=compared(Placement.BESIDE))
    before = [view.picture(k).scene.surface.points([0.5], [0.5]) for k in (0, 1)]
    owner.show(set_point(document, 2, 2, (2.0, 2.0, 3.0)))
    after = [view.picture(k).scene.surface.points([0.5], [0.5]) for k in (0, 1)]
    assert all(b[0, 0, 2] > a[0, 0, 2] + 0.1 for a, b in zip(before, after, strict=True))


def test_a_point_can_be_dragged_in_either(owner, expected_pixel, spin):
    view = owner.view
    change(view, comparison=compared(Placement.BESIDE), tools=ToolSettings(xray=True))
    make_room = [viewport.width() for viewport in view.viewports]
    assert min(make_room) > 300
    viewport = view.viewports[1]
    x, y = (round(value) for value in expected_pixel(view, owner.document.control_points[2, 2], 1))
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=QPoint(x, y))
    QTest.mouseMove(viewport, QPoint(x + 20, y - 20))
    spin(1)
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=QPoint(x + 20, y - 20))
    assert {indices for indices, *_ in owner.drags} == {((2, 2),)}


def near(image, colour, reach=30):
    """Return how many pixels have nearly a colour."""
    image = image.convertToFormat(QImage.Format.Format_RGBA8888)
    pixels = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1, 4)[..., :3].astype(int)
    return int((np.abs(pixels - colour).max(axis=-1) < reach).sum())


def test_over_it_is_lines_with_a_legend(owner, make_view):
    view = owner.view
    make_view.settle(view)
    ink = view.picture().theme.comparison
    assert near(view.image(), ink) == 0
    change(view, comparison=compared(Placement.OVER))
    assert len(view.viewports) == 1
    assert near(view.image(), ink) > 2000
    scene = view.picture().scene
    assert scene.lines_name == "B-spline"
    line = scene.lines[0] / scene.frame.scale + scene.frame.centre
    np.testing.assert_allclose(line, b_spline(owner.document.control_points).points(np.linspace(0, 1, 49), [0.0])[:, 0])
    legend = view.image().copy(0, 0, round(120 * view.devicePixelRatioF()), round(60 * view.devicePixelRatioF()))
    assert near(legend, ink) > 20


def test_a_figure_shows_both(owner, tmp_path):
    view = owner.view
    change(view, comparison=compared(Placement.BESIDE))
    view.save_figure(tmp_path / "both.png", FigureOptions(900, 480, None))
    image = QImage(str(tmp_path / "both.png"))
    halves = [image.copy(x, 0, 450, 480) for x in (0, 450)]
    ink = view.picture().theme.point
    assert all(near(half, ink) > 200 for half in halves)
    assert halves[0] != halves[1]


@pytest.mark.parametrize("style", Style)
def test_every_style_draws_it(make_view, document, style):
    view = make_view(document, layer=LayerChoice.RAW, size=(900, 480), style=style).view
    change(view, comparison=compared(Placement.BESIDE))
    make_view.settle(view)
    image = view.viewports[1].image()
    background = np.array(view.picture().theme.background)
    assert near(image, background, 8) < 0.9 * image.width() * image.height()


def test_the_probe_reads_the_surface_under_it(owner, spin):
    view = owner.view
    choose(view, probe=True)
    change(view, comparison=compared(Placement.BESIDE))
    spin(20)
    viewport, scene = view.viewports[1], view.picture(1).scene
    x, y, _ = view.camera.project(scene.patch.points([0.1], [0.1])[0, 0], viewport.logical_size)
    at = QPointF(x, y)
    kind, button = QEvent.Type.MouseMove, Qt.MouseButton.NoButton
    move = QMouseEvent(kind, at, viewport.mapToGlobal(at), button, button, Qt.KeyboardModifier.NoModifier)
    QApplication.sendEvent(viewport, move)
    said = dict(line.split("\t", 1) for line in view.probe_text().splitlines())
    u, v = map(float, said["u, v"].split("\t"))
    point = [float(number) for number in said["x, y, z"].split("\t")]
    np.testing.assert_allclose(point, b_spline(owner.document.control_points).points([u], [v])[0, 0], atol=1e-12)
    assert float(said["distance"]) == pytest.approx(closest_points(view.picture(0).scene.surface, [point]).distance[0])
