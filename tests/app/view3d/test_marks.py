"""What lies behind and over the surface is one list of values, which OpenGL and the painter draw alike."""

import numpy as np
import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QColor, QImage
from PySide6.QtTest import QTest

from qovr_app.state.display import DisplaySettings, LayerChoice, Projection, ThemeName, Underlay
from qovr_app.style.canvas import blank_image, painting
from qovr_app.view3d.painter.backdrop import backdrop
from qovr_app.view3d.painter.overlay import overlay
from qovr_app.view3d.painter.paint import paint
from qovr_app.view3d.scene.marks import MANY, Discs, Lines, Photo, Polygon, Polyline, Rectangle, Strip, Text
from qovr_core import Document
from support.view import change, select

LINES = {"control_box": True, "surface_box": True, "row_curves": True, "column_curves": True, "combs_u": True}


def pixels_of(image):
    """Return red, green and blue of an image, (n, m, 3) int."""
    image = image.convertToFormat(image.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


def farther_than_a_pixel(one, other):
    """Return of how many pixels neither image has the other's colour within a pixel."""
    away = np.zeros(one.shape[:2], dtype=int)
    for a, b in ((one, other), (other, one)):
        around = np.pad(a, ((1, 1), (1, 1), (0, 0)), mode="edge")
        windows = np.lib.stride_tricks.sliding_window_view(around, (3, 3), axis=(0, 1))
        away = np.maximum(away, np.abs(windows - b[..., None, None]).max(axis=2).min(axis=(2, 3)))
    return int((away > 64).sum())


def assert_alike(view):
    """Hold what a view without a surface shows against the same marks by the painter."""
    picture, size, ratio = view.picture(), view.viewports[0].logical_size, view.devicePixelRatioF()
    image = blank_image(size, ratio)
    image.fill(QColor(*picture.theme.background))
    with painting(image) as painter:
        paint(painter, [*backdrop(picture, size), *overlay(picture, size)])
    painted, seen = pixels_of(image), pixels_of(view.viewports[0].image())
    assert (np.abs(painted - seen).max(axis=-1) > 32).mean() < 0.02
    assert farther_than_a_pixel(painted, seen) <= 0.0003 * painted.shape[0] * painted.shape[1]


@pytest.fixture
def photo(tmp_path):
    """A picture of stripes."""
    image = QImage(120, 80, QImage.Format.Format_RGB888)
    image.fill(QColor(200, 120, 60))
    for x in range(0, 120, 20):
        for y in range(80):
            image.setPixelColor(x, y, QColor(0, 0, 80))
    image.save(str(tmp_path / "stripes.bmp"))
    return str(tmp_path / "stripes.bmp")


def busy_view(make_view, document, photo, **settings):
    """Return a view without a surface of its own colours, with marks of every kind."""
    underlay = Underlay(photo, 0.0, 0.0, 4.0, 2.0, 0.6)
    view = make_view(document, layer=LayerChoice.RAW, underlay=underlay, probe=True, **LINES, **settings).view
    select(view, (1, 1), (2, 2))
    change(view, pending=frozenset({(3, 3)}), refused=frozenset({(0, 1)}))
    QTest.mouseMove(view.viewports[0], QPoint(340, 280))
    make_view.settle(view)
    return view


@pytest.mark.parametrize("projection", list(Projection))
@pytest.mark.parametrize("theme", list(ThemeName))
def test_opengl_draws_marks_where_the_painter_does(make_view, document, photo, theme, projection):
    view = busy_view(make_view, document, photo, theme=theme, projection=projection, colour_by="none")
    picture, size = view.picture(), view.viewports[0].logical_size
    marks = [*backdrop(picture, size), *overlay(picture, size)]
    kinds = {type(mark) for mark in marks}
    assert kinds >= {Discs, Lines, Photo, Polygon, Polyline, Rectangle, Text}
    change(view, settings=DisplaySettings(**{**vars(view.shown.settings), "surface": False}))
    make_view.settle(view)
    assert_alike(view)


def test_opengl_draws_very_many_points_where_the_painter_does(make_view):
    x, y = np.meshgrid(np.arange(21.0), np.arange(21.0))
    view = make_view(Document(np.stack([x, y, 0.01 * x * y], axis=-1)), surface=False, control_net=False).view
    view.set_camera("top", animated=False)
    make_view.settle(view)
    points = [mark for mark in overlay(view.picture(), view.viewports[0].logical_size) if isinstance(mark, Discs)]
    assert max(len(discs.places) for discs in points) > MANY
    assert_alike(view)


def test_letters_and_the_colour_bar_are_the_painters_to_the_pixel(make_view, document):
    view = make_view(document, layer=LayerChoice.RAW, control_net=False, control_points=False, triad=False).view
    picture, size = view.picture(), view.viewports[0].logical_size
    marks = [mark for mark in overlay(picture, size) if isinstance(mark, Text | Strip)]
    assert {type(mark) for mark in marks} == {Text, Strip}
    view.camera_motion.move(view.camera)
    image = view.viewports[0].image()
    ratio = view.devicePixelRatioF()
    right = round((size[0] - 90) * ratio)
    expected = blank_image(size, ratio)
    expected.fill(QColor(*picture.theme.background))
    with painting(expected) as painter:
        paint(painter, marks)
    np.testing.assert_array_equal(pixels_of(image)[:, right:], pixels_of(expected)[:, right:])


def test_a_texture_that_is_full_begins_anew_or_grows(make_view, document, monkeypatch):
    from qovr_app.view3d.gl import atlas

    images = []
    for side in (1024, 8):
        monkeypatch.setattr(atlas, "_LEAST_SIDE", side)
        view = make_view(document, layer=LayerChoice.RAW).view
        if not view.uses_opengl:
            pytest.skip("there is no OpenGL here")
        for name in ("top", "front", "paper"):
            view.set_camera(name, animated=False)
            make_view.settle(view)
        images.append(view.viewports[0].image())
    assert images[0] == images[1]
