"""Surfaces of every size and however far from the origin: a picture with numbers that can be read, and no warning."""

import itertools
import warnings
from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import DisplaySettings, LayerChoice, Scaling, Style
from qovr_app.state.tools import ToolSettings, Way
from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.tick_labels import tick_labels
from qovr_app.style.ticks import round_limits, tick_positions
from qovr_app.view3d.painter import surface as painter_surface
from qovr_app.view3d.painter.backdrop import backdrop
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.paint import paint
from qovr_app.view3d.painter.text import text_size
from qovr_app.view3d.scene.axes import axes_box
from qovr_app.view3d.scene.camera import Camera, fitted
from qovr_app.view3d.scene.colouring import FAR_NOTE
from qovr_app.view3d.scene.frame import FARTHEST
from qovr_app.view3d.scene.marks import Text
from qovr_app.view3d.scene.mesh import surface_vertices
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_app.view3d.scene.picture import Picture, margins
from qovr_app.view3d.scene.scene import make_scene, scene_frame
from qovr_core import Document, Evaluation
from qovr_core.geometry.knots import Knots
from qovr_core.layer import Layer
from support.view import change, choose, grid

SIZE = (700.0, 560.0)
ROWS, COLUMNS = np.mgrid[0:5, 0:5].astype(float)
WAVE = np.stack([COLUMNS, ROWS, 0.9 * np.sin(COLUMNS) * np.cos(ROWS)], axis=-1)

NETS = {
    "a site in national coordinates": WAVE / 100 + [512345.6, 300000, 100],
    "a plate that is flat but for its waves": WAVE * [100, 100, 1e-4] + [0, 0, 1000],
    "far in every direction": WAVE * 1e-3 - [9e8, -9e8, 9e8],
    "minute": WAVE * 2.5e-301,
    "below what has digits": WAVE * 5e-324,
    "large": WAVE * 2.5e11,
    "long": WAVE * [1e9, 1, 1e-3],
    "level, far off": WAVE * [0.01, 0.01, 0] + 5e5,
    "one point": WAVE * 0 + 7e5,
}
WILD_KNOTS = Knots(1e-300, 0.5, 1 - 1e-12, 1e-6)


def pictures_of(document, layers=tuple(Layer), scalings=tuple(Scaling)):
    evaluation = Evaluation(document)
    for layer, scaling in itertools.product(layers, scalings):
        scene = make_scene(evaluation, layer, scene_frame(evaluation, layer, scaling))
        settings = DisplaySettings(layer=LayerChoice(layer), scaling=scaling, row_curves=True, surface_box=True)
        camera = fitted(Camera(), scene.frame.half_extents, SIZE, margins(settings, SIZE))
        yield Picture(settings, camera, scene)


def painted(picture):
    image = blank_image(SIZE, 1.0)
    with painting(image) as painter:
        paint(painter, backdrop(picture, SIZE))
        painter_surface.paint_surface(painter, picture, SIZE)
        paint(painter, overlay(picture, SIZE))
    return image


@pytest.mark.parametrize("formulation", ["interpolating", "published"])
@pytest.mark.parametrize("name", NETS)
def test_every_size_is_painted_without_a_warning(app, name, formulation):
    document = Document(NETS[name], formulation=formulation, samples=(9, 9))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for picture in pictures_of(document):
            assert np.isfinite(surface_vertices(picture.scene.patch, grid(21, 21))).all()
            painted(picture)
            axes_box(picture.scene.frame, picture.camera, SIZE)


def test_every_colour_of_the_smallest_and_the_largest_is_painted_without_a_warning(app):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for name, colour_by in itertools.product(("minute", "large", "one point"), colour_sources()):
            document = Document(NETS[name], formulation="interpolating", samples=(9, 9))
            picture = next(pictures_of(document))
            painted(replace(picture, settings=replace(picture.settings, colour_by=colour_by, style=Style.SMOOTH)))


def test_opengl_draws_every_size(make_view, logged_errors):
    owner = make_view(Document(NETS["large"], formulation="interpolating"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for net in NETS.values():
            owner.show(Document(net, formulation="interpolating"))
            owner.view.fit(animated=False)
            for scaling in Scaling:
                choose(owner.view, scaling=scaling)
                owner.view.image()
    assert logged_errors == []


@pytest.mark.parametrize("formulation", ["interpolating", "published"])
def test_a_surface_that_leaves_the_picture_between_its_samples_is_drawn_and_said(app, formulation):
    net = WAVE * [1, 1, 0]
    document = Document(net, row_knots=[WILD_KNOTS] * 5, formulation=formulation, samples=(2, 5))
    notes = []
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        for picture in pictures_of(document):
            vertices = surface_vertices(picture.scene.patch, grid(49, 49))
            assert np.abs(vertices[..., :3]).max() <= FARTHEST
            assert picture.colouring.note == (FAR_NOTE if picture.scene.leaves_sight else "")
            notes.append(picture.colouring.note)
            painted(picture)
    assert FAR_NOTE in notes


def test_a_site_far_from_the_origin_has_the_shape_it_has_at_the_origin():
    here, there = (
        next(pictures_of(Document(net, formulation="interpolating"), scalings=(Scaling.EQUAL,))).scene
        for net in (WAVE / 64, WAVE / 64 + [524288, 262144, 128])  # numbers that are moved without rounding
    )
    np.testing.assert_allclose(there.points, here.points + (there.points - here.points)[0, 0], atol=1e-14)
    np.testing.assert_allclose(
        there.patch.coefficients[0, 0], here.patch.coefficients[0, 0] + (there.points - here.points)[0, 0], atol=1e-8
    )


def test_the_axes_of_a_site_have_different_numbers_and_an_offset():
    picture = next(pictures_of(Document(NETS["a site in national coordinates"], formulation="interpolating")))
    x, y, z = axes_box(picture.scene.frame, picture.camera, SIZE).edges
    assert [edge.labels.note.replace("\xa0", " ") for edge in (x, y, z)] == ["+ 512 345.6", "+ 300 000", "+ 100"]
    for edge in (x, y, z):
        assert len(set(edge.labels.texts)) == len(edge.labels.texts) > 2
    assert x.labels.texts == ["0.00", "0.01", "0.02", "0.03", "0.04"]


@pytest.mark.parametrize("name", ["a site in national coordinates", "large", "minute", "far in every direction"])
@pytest.mark.parametrize("size", [SIZE, (350.0, 400.0)])
def test_texts_of_axes_cover_no_other_and_are_not_cut_off(app, name, size):
    for picture in pictures_of(Document(NETS[name], formulation="interpolating")):
        room = margins(picture.settings, size)
        fits = replace(picture, camera=fitted(picture.camera, picture.scene.frame.half_extents, size, room))
        texts = [mark for mark in backdrop(fits, size) if isinstance(mark, Text)]
        written = [
            QRectF(*text.anchor, *text_size(text.lettering.runs, text.lettering.pixels)).adjusted(0, 4, 0, -4)
            for text in texts
        ]
        assert len(written) > 6
        assert all(QRectF(0, 0, *size).contains(text) for text in written)
        assert not any(a.intersects(b) for a, b in itertools.combinations(written, 2))


@pytest.mark.parametrize(
    ("low", "high", "texts", "note"),
    [
        (5e5, 5e5 + 4e-2, ["0.00", "0.01", "0.02", "0.03", "0.04"], "+ 500 000"),
        (-1e6 - 4, -1e6, ["−4", "−3", "−2", "−1", "0"], "− 1 000 000"),
        (0, 4e-300, ["0", "1", "2", "3", "4"], "×10⁻³⁰⁰"),
        (1e12, 1e12 + 2, ["0.0", "0.5", "1.0", "1.5", "2.0"], "+ 1 000 000 000 000"),
        (1 - 2e-9, 1 + 2e-9, ["−2", "−1", "0", "1", "2"], "×10⁻⁹ + 1"),
        (2e-200, 2e-200 + 4e-206, ["0", "1", "2", "3", "4"], "×10⁻²⁰⁶ + 2e−200"),
        (0.4, 0.5, ["0.40", "0.42", "0.44", "0.46", "0.48", "0.50"], ""),
    ],
)
def test_ticks_far_off_and_minute_have_short_labels(low, high, texts, note):
    labels = tick_labels(tick_positions(low, high, 5))
    assert (labels.texts, labels.note.replace("\xa0", " ")) == (texts, note)


@pytest.mark.parametrize("interval", [(5e5, 5e5 + 4e-2), (1e12, 1e12 + 3), (-3e-300, 4e-300), (999.9999, 1000.0001)])
def test_limits_are_close_however_far_off(interval):
    low, high = round_limits(*interval)
    extent = interval[1] - interval[0]
    assert interval[0] - extent / 2 <= low <= interval[0] < interval[1] <= high <= interval[1] + extent / 2


def test_a_point_stays_under_the_mouse_far_from_the_origin(make_view, expected_pixel):
    net = NETS["a site in national coordinates"]
    owner = make_view(Document(net, formulation="interpolating"))
    change(owner.view, tools=ToolSettings(way=Way.VIEW))
    widget = owner.view.viewports[0].widget
    start = np.array(expected_pixel(owner.view, net[0, 0]))
    button, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    for kind, way in ((QMouseEvent.Type.MouseButtonPress, (0, 0)), (QMouseEvent.Type.MouseMove, (60, -30))):
        at = QPointF(*(start + way))
        QApplication.sendEvent(widget, QMouseEvent(kind, at, widget.mapToGlobal(at), button, button, none))
    seen = expected_pixel(owner.view, owner.document.control_points[0, 0])
    assert seen == pytest.approx(start + [60, -30], abs=1.5)  # noqa: RUF005 - the sum of two vectors
