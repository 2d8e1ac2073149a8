"""What the view shows of a surface: its sides, its points, the axes in the corner, and what a click there does."""

import numpy as np
import pytest
from matplotlib import colormaps
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from qovr_app.state.display import ColourMap, DisplaySettings, LayerChoice, Style
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.tools import ToolSettings
from qovr_app.style.colour_maps import colour_table
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.patterns import CLAY
from qovr_app.view3d.scene.triad import VIEWS, triad_centre, triad_ends
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.edits import set_points
from support.view import change, choose, select

LEFT = Qt.MouseButton.LeftButton
BARE = {"control_points": False, "labels": False, "control_net": False, "parameter_lines": False, "axes": False}


def end_at(view, axis, is_high):
    """Return the pixel of an end of an axis in the corner: along where the camera sees the axis point."""
    right, up, _ = view.camera.axes
    way = 1 if is_high else -1
    x, y = triad_centre(view.viewports[0].logical_size)
    return QPoint(round(x + 29 * way * right[axis]), round(y - 29 * way * up[axis]))


@pytest.mark.parametrize("axis", range(3))
@pytest.mark.parametrize("is_high", [True, False])
def test_a_click_on_an_end_of_an_axis_looks_from_there_and_another_from_the_other_side(
    make_view, document, axis, is_high, spin
):
    view = make_view(document, at_rest=False).view
    viewport = view.viewports[0]
    view.camera_motion.move(Camera(-37.0, 31.0))
    QTest.mouseClick(viewport, LEFT, pos=end_at(view, axis, is_high))
    spin(lambda: (view.camera.azimuth, view.camera.elevation) == NAMED_VIEWS[VIEWS[axis][is_high]])
    x, y = triad_centre(viewport.logical_size)
    QTest.mouseClick(viewport, LEFT, pos=QPoint(round(x), round(y)))
    spin(lambda: (view.camera.azimuth, view.camera.elevation) == NAMED_VIEWS[VIEWS[axis][not is_high]])


def test_the_axes_in_the_corner_say_what_a_click_does_and_let_go_of_nothing(make_view, document):
    owner = make_view(document, at_rest=False)
    view, viewport = owner.view, owner.view.viewports[0]
    select(view, (1, 1))
    at = end_at(view, 0, is_high=True)
    QTest.mouseMove(viewport, at)
    assert view.picture().hand.view == "right"
    assert viewport.toolTip() == "Look from: right"
    assert viewport.cursor().shape() is Qt.CursorShape.PointingHandCursor
    QTest.mouseClick(viewport, LEFT, pos=at)
    assert view.shown.selected == {(1, 1)}
    before = view.camera
    QTest.mouseMove(viewport, QPoint(300, 20))
    assert view.picture().hand.view == ""
    assert viewport.toolTip() == ""
    choose(view, triad=False)
    QTest.mouseClick(viewport, LEFT, pos=at)
    assert view.shown.selected == frozenset()
    assert view.camera.elevation != before.elevation or view.camera == before


def test_the_ends_nearer_to_the_viewer_are_drawn_last_and_taken_first():
    ends = triad_ends(Camera(-54, 64), (700.0, 560.0))
    assert [end.depth for end in ends] == sorted(end.depth for end in ends)
    assert ends[-1].view == "top"


def test_figures_have_no_axes_in_the_corner(make_view, document, tmp_path):
    view = make_view(document).view
    images = []
    for triad in (False, True):
        choose(view, triad=triad)
        view.save_figure(tmp_path / "a.png", FigureOptions(400, 320, None))
        images.append(QImage(str(tmp_path / "a.png")))
    assert images[0] == images[1]


def test_what_is_seen_from_below_is_tinted_whichever_way_the_net_runs(
    make_view, document, renderer, expected_pixel, colour_at
):
    mirrored = set_points(document, document.control_points[:, ::-1])
    for net in (document, mirrored):
        view = make_view(net, layer=LayerChoice.RAW, colour_by="none", **BARE).view
        colours = {}
        for camera in ("top", "bottom"):
            view.set_camera(camera, animated=False)
            make_view.settle(view)
            middle = view.picture().scene.surface.points([0.4], [0.4])[0, 0]
            colours[camera] = np.array(colour_at(view.image(), *expected_pixel(view, middle)))
        np.testing.assert_allclose(colours["top"], CLAY, atol=2)
        np.testing.assert_allclose(colours["bottom"], 0.58 * np.array(CLAY) + 0.42 * np.array([92, 70, 112]), atol=2)


def test_clay_is_light_alone(make_view, document, renderer, expected_pixel, colour_at):
    view = make_view(document, layer=LayerChoice.RAW, style=Style.CLAY, **BARE).view
    view.set_camera("top", animated=False)
    make_view.settle(view)
    image, seen = view.image(), []
    for u in np.linspace(0.1, 0.9, 7):
        point = view.picture().scene.surface.points([u], [0.3])[0, 0]
        seen.append(colour_at(image, *expected_pixel(view, point)))
    shares = np.array(seen) / np.sum(seen, axis=1, keepdims=True)
    np.testing.assert_allclose(shares, np.tile(np.array(CLAY) / sum(CLAY), (7, 1)), atol=0.02)
    assert np.ptp(np.sum(seen, axis=1)) > 10
    size = view.viewports[0].logical_size
    bar = view.image().copy(round(size[0] - 78), round(size[1] / 3), 14, 40)
    assert {bar.pixel(x, y) for x in range(14) for y in range(40)} == {image.pixel(2, 2)}


def test_a_surface_without_colours_has_one(make_view, document, renderer, expected_pixel, colour_at):
    view = make_view(document, layer=LayerChoice.RAW, colour_by="none", **BARE).view
    view.set_camera("top", animated=False)
    make_view.settle(view)
    for v in (0.2, 0.5, 0.8):
        point = view.picture().scene.surface.points([0.4], [v])[0, 0]
        np.testing.assert_allclose(colour_at(view.image(), *expected_pixel(view, point)), CLAY, atol=2)


def test_points_say_by_colour_what_is_with_them(make_view, document, renderer, expected_pixel, colour_at):
    view = make_view(document, layer=LayerChoice.RAW, surface=False, control_net=False, labels=False, axes=False).view
    select(view, (1, 1), (2, 2))
    change(view, pending=frozenset({(3, 3)}), refused=frozenset({(0, 1)}))
    make_view.settle(view)
    image, theme = view.image(), view.picture().theme

    def beside(index, away):
        x, y = expected_pixel(view, document.control_points[index])
        return colour_at(image, x + away, y)

    assert beside((1, 1), 0) == beside((2, 2), 0) == beside((2, 2), 10) == theme.selected
    for index, halo in (((3, 3), theme.pending), ((0, 1), theme.bad)):
        assert beside(index, 0) == theme.point
        np.testing.assert_allclose(beside(index, 7), halo, atol=8)  # beside the edge of the disc
    assert beside((4, 0), 0) == theme.point


def test_x_ray_shows_hidden_points_more_clearly(make_view, document, expected_pixel, colour_at):
    """Their discs are translucent either way, over what hides them."""
    view = make_view(document, layer=LayerChoice.TRANSFORMED, labels=False, control_net=False).view
    point = np.array(view.picture().theme.point)
    hidden, away = (0, 3), {}
    for xray in (False, True):
        change(view, tools=ToolSettings(xray=xray), settings=DisplaySettings(labels=False, control_net=False))
        view.set_camera("bottom", animated=False)
        make_view.settle(view)
        image = view.image()
        net = view.picture().scene.document.control_points
        seen = [np.array(colour_at(image, *expected_pixel(view, net[i, j]))) for i in range(5) for j in range(5)]
        away[xray] = np.sort([np.abs(colour - point).sum() for colour in seen])
    assert hidden
    assert (away[True] <= away[False] + 1).all()
    assert away[True].sum() < 0.7 * away[False].sum()


def test_the_colours_of_work_are_matplotlibs_cividis():
    assert DisplaySettings().colour_map is ColourMap.CIVIDIS
    expected = colormaps["cividis"](np.arange(256), bytes=True)[:, :3].astype(int)
    assert np.abs(colour_table(ColourMap.CIVIDIS).astype(int) - expected).max() <= 5
