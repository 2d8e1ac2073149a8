"""A net of windows in the view: joints, the window in focus, picking, probing, figures, with both ways of drawing."""

import re

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice, Style
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.looking_intents import WindowFocused
from qovr_app.style.theme import theme_of
from qovr_app.view3d.interaction.curve_picking import curve_under
from qovr_app.view3d.interaction.picking import points_under, window_under
from qovr_app.view3d.painter.lines import lines_of
from qovr_app.view3d.painter.readout import readout_rows
from qovr_app.view3d.scene.joints import joint_lines, outline
from qovr_app.view3d.scene.net_marks import shown_part
from qovr_app.view3d.scene.probing import parameters_under, reading_at
from qovr_core import Document, Formulation
from qovr_core.edits import Direction, KnotPlace, set_point
from qovr_core.joints import Joint
from support.nets import closed_net
from support.view import change, choose, select

SIZE = (800.0, 600.0)


def hood(windows=(2, 3), formulation=Formulation.INTERPOLATING):
    """Return a net of heights: smooth, but for a crease at its first joint along v."""
    m, n = windows
    y, x = np.mgrid[: 2 * m + 3, : 2 * n + 3].astype(float)
    z = 1.6 * np.exp(-((x / n - 1.3) ** 2) - (y / m - 1.7) ** 2)
    columns = np.full((2 * n + 3, m, 4), 0.5)
    columns[:, 0, 3], columns[:, 1, 0] = 0.2, 0.8
    return Document(np.stack([x, y, z], axis=-1), np.full((2 * m + 3, n, 4), 0.5), columns, formulation, (61, 61))


def shown(make_view, document, **settings):
    settings = {"layer": LayerChoice.RAW, "style": Style.SMOOTH, **settings}
    view = make_view(document, size=(800, 600), **settings).view
    change(view, window=(0, 1))
    return view


def names(view):
    return [lines.name for lines in lines_of(view.picture(), SIZE)]


def test_joints_lie_where_windows_meet(make_view):
    view = shown(make_view, hood())
    scene = view.picture().scene
    joints, patch = joint_lines(scene), scene.patch
    (v,) = patch.breaks[1]
    (smooth,), (sharp,) = joints.smooth, joints.sharp
    assert smooth.shape[0] == 2
    assert sharp.shape[0] == 1
    u = np.concatenate([np.linspace(b, b + 1, 17)[: 16 if b < 2 else 17] for b in range(3)]) * patch.domain[0][1] / 3
    np.testing.assert_allclose(sharp[0], patch.points(u, [v])[:, 0], atol=1e-12)
    np.testing.assert_allclose(smooth[0][[0, -1]], patch.points([patch.breaks[0][0]], patch.domain[1])[0], atol=1e-12)
    around = outline(scene, (0, 1))
    assert around.shape[0] == 4
    np.testing.assert_allclose(around[0, 0], patch.window(0, 1).points([0.0], [0.0])[0, 0], atol=1e-12)
    assert len(outline(scene, (2, 0))) == 0


def test_windows_that_jump_have_both_their_edges(make_view):
    view = shown(make_view, hood(formulation=Formulation.PUBLISHED))
    joints = joint_lines(view.picture().scene)
    assert sum(map(len, joints.smooth)) == 2 * 2 * 2
    assert sum(map(len, joints.sharp)) == 2 * 3
    patch = view.picture().scene.patch
    (sharp,) = joints.sharp
    ends = [patch.window(0, b).points([0, 1], [1])[:, 0] for b in range(3)]
    ends += [patch.window(1, b).points([0, 1], [0])[:, 0] for b in range(3)]
    np.testing.assert_allclose(sharp[:, [0, -1]], ends, atol=1e-12)


def test_the_seam_of_a_closed_net_is_a_joint(make_view):
    document = closed_net(3, (2, 3), ("u",))
    scene = shown(make_view, document).picture().scene
    joints = joint_lines(scene)
    assert sum(map(len, (*joints.smooth, *joints.sharp))) == len(document.joints.u) + len(document.joints.v) == 3 + 1
    seam = scene.patch.points([scene.patch.domain[0][0]], scene.patch.domain[1])[0]
    ends = np.concatenate([lines[:, [0, -1]] for lines in (*joints.smooth, *joints.sharp)])
    assert np.abs(ends - seam).max(axis=(1, 2)).min() < 1e-9


def test_joints_can_be_switched_off_and_one_window_has_none(make_view, document):
    view = shown(make_view, hood())
    assert names(view) == ["Control net", "Control net", "Smooth joint", "Window in focus", "Sharp joint"]
    choose(view, joints=False)
    assert names(view) == ["Control net", "Control net"]
    choose(view, joints=True)
    change(view, document=document)
    assert names(view) == ["Control net"]


@pytest.mark.parametrize("painter", [False, True])
def test_crease_and_focus_are_seen(make_view, request, painter, colour_at):
    if painter:
        request.getfixturevalue("no_opengl")
    settings = {"labels": False, "control_net": False, "control_points": False, "legend": False}
    view = shown(make_view, hood(), **settings)
    make_view.settle(view)
    assert view.uses_opengl != painter
    image, picture, size = view.image(), view.picture(), view.viewports[0].logical_size
    theme = theme_of(picture.settings.theme)
    (sharp,) = joint_lines(picture.scene).sharp
    for lines, colour in ((sharp, theme.sharp_joint), (outline(picture.scene, (0, 1)), theme.selected)):
        x, y, _ = picture.camera.project(lines[0, 5], size)
        near = [colour_at(image, x + dx, y + dy) for dx in (-1, 0, 1) for dy in (-1, 0, 1)]
        assert min(np.abs(np.subtract(each, colour)).max() for each in near) < 40


def double_click(view, at):
    viewport, at = view.viewports[0].widget, QPointF(*at)
    left, no_keys = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    for kind in (QEvent.Type.MouseButtonDblClick, QEvent.Type.MouseButtonRelease):
        event = QMouseEvent(kind, at, viewport.mapToGlobal(at), left, left, no_keys)
        QApplication.sendEvent(viewport, event)


def seen(view, window, place=(0.3, 0.35)):
    """Return the pixel at which a place in a window is seen."""
    picture = view.picture()
    point = picture.scene.patch.window(*window).points(*([x] for x in place))[0, 0]
    return picture.camera.project(point, view.viewports[0].logical_size)[:2].tolist()


@pytest.mark.parametrize("window", [(0, 0), (1, 2), (0, 1)])
def test_two_clicks_turn_to_the_window_that_is_seen_there(make_view, window):
    view, wanted = shown(make_view, hood(), control_net=False), []
    view.wanted.connect(wanted.append)
    at = seen(view, window)
    assert window_under(view.picture(), view.viewports[0].logical_size, *at) == window
    double_click(view, at)
    assert wanted == [WindowFocused(window)]
    double_click(view, (4.0, 300.0))
    assert len(wanted) == 1


def test_two_clicks_on_one_window_are_what_they_were(make_view, document):
    view, wanted = shown(make_view, document, control_net=False), []
    view.wanted.connect(wanted.append)
    double_click(view, seen(view, (0, 0), (0.3, 0.3)))
    assert wanted == []


@pytest.mark.parametrize("place", [(0.0, 0.0), (0.31, 0.62), (1.0, 0.5), (0.999999, 0.0)])
@pytest.mark.parametrize("formulation", [Formulation.INTERPOLATING, Formulation.PUBLISHED])
def test_the_probe_is_exact_in_every_window(make_view, place, formulation):
    view = shown(make_view, hood(formulation=formulation))
    picture, size = view.picture(), view.viewports[0].logical_size
    for window in np.ndindex(2, 3):
        at = seen(view, window, place)
        found = parameters_under(picture.scene, picture.camera, size, *at)
        if found is None:  # at the outline a pixel's rounding decides
            assert set(place) & {0.0, 1.0}
            continue
        point = picture.scene.patch.points([found[0]], [found[1]])[0, 0]
        assert picture.camera.project(point, size)[:2] == pytest.approx(at, abs=1e-6)


def test_the_readout_says_the_window_and_the_place_in_it(make_view, document):
    view = shown(make_view, hood())
    picture, size = view.picture(), view.viewports[0].logical_size
    found = parameters_under(picture.scene, picture.camera, size, *seen(view, (1, 2)))
    rows = dict(readout_rows(reading_at(picture.scene, found, "height")))
    assert rows["window"] == (1, 2)
    assert rows["u, v"] == pytest.approx((0.3, 0.35), abs=1e-9)
    change(view, document=document)
    assert "window" not in dict(readout_rows(reading_at(view.picture().scene, (0.3, 0.35), "height")))


def test_a_line_of_the_net_and_a_curve_tell_their_window(make_view):
    view = shown(make_view, hood(), control_net=True)
    picture, size = view.picture(), view.viewports[0].logical_size
    points = picture.scene.points
    for j, window in ((0, 0), (2, 0), (3, 1), (4, 1), (7, 2)):
        at = picture.camera.project(0.6 * points[0, j] + 0.4 * points[0, j + 1], size)[:2]
        assert curve_under(picture, size, *at) == KnotPlace(Direction.ROWS, 0, "u", window)
    choose(view, control_net=False, column_curves=True)
    picture = view.picture()
    curves = picture.scene.column_curves
    assert curves.shape == (9, 49, 3)
    np.testing.assert_allclose(curves[2, [0, 24, 48]], points[[1, 3, 5], 2], atol=1e-9)
    for piece, window in ((5, 0), (30, 1)):
        at = picture.camera.project(curves[0, piece : piece + 2].mean(axis=0), size)[:2]
        assert curve_under(picture, size, *at) == KnotPlace(Direction.COLUMNS, 0, "u", window)


def test_only_touched_windows_are_made_anew(make_view, monkeypatch):
    from qovr_app.view3d.gl import api

    document = hood((6, 7))
    owner = make_view(document, size=(800, 600), layer=LayerChoice.RAW, style=Style.SMOOTH)
    owner.show(set_point(document, 5, 5, (5.0, 5.0, 0.4)))
    owner.make_rest()
    rewritten = []
    rewrite = api.rewrite
    monkeypatch.setattr(
        api,
        "rewrite",
        lambda buffer, values, rows: rewritten.append((rows, len(values))) or rewrite(buffer, values, rows),
    )
    change(owner.view, document=set_point(owner.document, 5, 5, (5.0, 5.0, 0.41)))
    owner.view.viewports[0].image()
    change(owner.view, document=set_point(owner.document, 5, 5, (5.0, 5.0, 0.42)))
    owner.view.viewports[0].image()
    rows, count = rewritten[-1]
    assert 0 < rows.stop - rows.start < count / 2


def test_many_points_are_fewer_while_something_moves_and_the_marked_ones_stay(make_view):
    document = hood((50, 50))
    view = shown(make_view, document, control_net=True)
    select(view, (33, 57))
    view._show(moving=True)
    part = shown_part(view.picture())
    assert len(part.rows) < 30
    assert 33 in part.rows
    assert 57 in part.columns
    assert (part.rows[0], part.rows[-1]) == (0, 102)
    assert part.place((33, 57)) == (part.rows.tolist().index(33), part.columns.tolist().index(57))
    make_view.settle(view)
    assert len(shown_part(view.picture()).rows) == 103


def test_every_point_of_a_large_net_is_picked(make_view):
    view = shown(make_view, hood((50, 50)))
    view.set_camera("top", animated=False)
    picture, size = view.picture(), view.viewports[0].logical_size
    for index in ((0, 0), (51, 34), (102, 102)):
        at = picture.camera.project(picture.scene.points[index], size)[:2]
        assert points_under(picture, size, *at)[0] == index


@pytest.mark.parametrize("suffix", ["svg", "png", "pdf"])
def test_figures_show_joints(make_view, tmp_path, suffix):
    view = shown(make_view, hood(), labels=False)
    path = tmp_path / f"net.{suffix}"
    view.save_figure(path, FigureOptions(160, 120, 100))
    assert path.stat().st_size > 1000
    if suffix == "svg":
        text = "".join(re.findall(r"<text[^>]*>([^<]*)</text>", path.read_text(encoding="utf-8")))
        assert "Sharp joint" in text
        assert Joint.SHARP in hood().joints.v
