"""What is seen, compared with an independent projection of known points: OpenGL and the painter alike."""

import numpy as np
import pytest

from qovr_app.state.display import ColourMap, DisplaySettings, LayerChoice, Projection, Style, ThemeName
from qovr_app.style.colour_maps import colours_of
from qovr_app.view3d.painter.colour_bar import bar_rect
from qovr_core import Formulation, configure
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.document import Document
from qovr_core.edits import set_formulation
from support.view import change, choose

PLAIN = {
    "control_points": False,
    "labels": False,
    "control_net": False,
    "parameter_lines": False,
}


@pytest.fixture
def seen_colour(expected_pixel, colour_at):
    """A function that returns the colour an image has where a point of the document belongs."""
    return lambda view, image, point: np.array(colour_at(image, *expected_pixel(view, point)), dtype=int)


@pytest.mark.parametrize("colour_map", list(ColourMap))
def test_every_point_has_the_colour_of_its_height(make_view, document, renderer, colour_map, seen_colour):
    owner = make_view(document, layer=LayerChoice.RAW, colour_map=colour_map, **PLAIN)
    owner.view.set_camera("top", animated=False)
    make_view.settle(owner.view)
    image, (low, high) = owner.view.image(), owner.view.picture().scene.surface_box[2]
    patch, cell = configure(document).patch, np.linspace(-1 / 30, 1 / 30, 3)
    for u in np.linspace(0.13, 0.87, 6):
        for v in np.linspace(0.11, 0.89, 6):
            around = patch.points(u + cell, v + cell)
            seen = seen_colour(owner.view, image, around[1, 1])
            heights = np.linspace(around[..., 2].min(), around[..., 2].max(), 40)
            near = colours_of(heights, low, high, colour_map).astype(int)
            assert np.abs(near - seen).max(axis=1).min() <= 16, (u, v, seen)


@pytest.mark.parametrize("camera", list(NAMED_VIEWS))
def test_control_points_appear_where_they_are(make_view, document, renderer, camera, seen_colour):
    owner = make_view(document, layer=LayerChoice.RAW, surface=False, labels=False, control_net=False, axes=False)
    owner.view.set_camera(camera, animated=False)
    make_view.settle(owner.view)
    image, accent = owner.view.image(), owner.view.picture().theme.point
    for point in document.control_points.reshape(-1, 3):
        assert tuple(seen_colour(owner.view, image, point)) == accent


def test_a_mirrored_picture_would_be_noticed(make_view, renderer, expected_pixel, colour_at):
    """One lifted corner: high colours lie there, and at no other corner."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    z = 0.1 * x + 0.3 * x * y
    document = Document(np.stack([x, y, z], axis=-1), formulation="interpolating")
    owner = make_view(document, layer=LayerChoice.RAW, colour_map=ColourMap.JET, **PLAIN)
    owner.view.set_camera("top", animated=False)
    make_view.settle(owner.view)
    image, patch = owner.view.image(), configure(document).patch
    corners = patch.points(np.array([0.02, 0.98]), np.array([0.02, 0.98])).reshape(-1, 3)
    red_less_blue = []
    for corner in corners:
        red, _, blue = colour_at(image, *expected_pixel(owner.view, corner))
        red_less_blue.append(red - blue)
    highest = int(corners[:, 2].argmax())
    assert int(np.argmax(red_less_blue)) == highest
    assert red_less_blue[highest] > 100
    assert sum(value > 100 for value in red_less_blue) == 1


def test_smooth_surfaces_are_lit_and_facets_are_not(make_view, renderer, expected_pixel, colour_at):
    """Two slopes of one roof have the same heights: light tells them apart, flat colours do not."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    net = np.stack([x, y, -((y - 2) ** 2)], axis=-1)
    document = Document(net, formulation="interpolating", samples=(31, 31))
    owner = make_view(document, layer=LayerChoice.RAW, **PLAIN)
    owner.view.set_camera("top", animated=False)
    # In cells whose first corners, which colour facets, lie equally far from the ridge.
    slopes = configure(document).patch.points(np.array([0.517]), np.array([8.5, 22.5]) / 30)[0]
    sums = {}
    for style in (Style.FACETS, Style.SMOOTH):
        change(owner.view, settings=DisplaySettings(layer=LayerChoice.RAW, style=style, **PLAIN))
        make_view.settle(owner.view)
        image = owner.view.image()
        sums[style] = [sum(colour_at(image, *expected_pixel(owner.view, point))) for point in slopes]
    assert abs(np.subtract(*sums[Style.FACETS])) < 20
    assert abs(np.subtract(*sums[Style.SMOOTH])) > 40


def pixels_of(image):
    image = image.convertToFormat(image.Format.Format_RGB888)
    rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), image.bytesPerLine())
    return rows[:, : 3 * image.width()].reshape(image.height(), image.width(), 3).astype(int)


@pytest.mark.parametrize(
    "part",
    [
        "surface",
        "parameter_lines",
        "control_points",
        "labels",
        "control_net",
        "row_curves",
        "column_curves",
        "combs_u",
        "combs_v",
        "control_box",
        "surface_box",
        "axes",
        "colour_bar",
        "triad",
    ],
)
def test_every_part_can_be_switched(make_view, document, renderer, part):
    owner = make_view(document, layer=LayerChoice.RAW)
    camera = owner.view.camera
    images = []
    for shown in (False, True):
        change(owner.view, settings=DisplaySettings(layer=LayerChoice.RAW, **{part: shown}))
        owner.view.camera_motion.move(camera)
        make_view.settle(owner.view)
        images.append(pixels_of(owner.view.image()))
    changed = (np.abs(images[0] - images[1]).max(axis=-1) > 20).sum()
    assert changed > 60


@pytest.mark.parametrize("style", list(Style))
@pytest.mark.parametrize("projection", list(Projection))
def test_every_style_shows_the_surface(make_view, document, renderer, style, projection):
    owner = make_view(
        document,
        layer=LayerChoice.RAW,
        style=style,
        projection=projection,
        colour_map=ColourMap.JET,
        colour_bar=False,
        triad=False,
        axes=False,
    )
    image = pixels_of(owner.view.image())
    least = 8 if style is Style.CLAY else 120  # clay is a warm grey
    colourful = (np.ptp(image, axis=-1) > least).mean()
    assert colourful > 0.004


@pytest.mark.parametrize("theme", list(ThemeName))
def test_the_background_is_the_themes(make_view, document, renderer, theme, colour_at):
    owner = make_view(document, theme=theme)
    assert colour_at(owner.view.image(), 2, 2) == owner.view.picture().theme.background


def test_labels_stand_beside_their_points(make_view, document, renderer, expected_pixel):
    owner = make_view(document, layer=LayerChoice.RAW, surface=False, control_net=False, axes=False)
    image = pixels_of(owner.view.image())
    for index in ((0, 0), (0, 4), (4, 0), (2, 2)):
        x, y = expected_pixel(owner.view, document.control_points[index])
        ratio = owner.view.devicePixelRatioF()
        top, bottom, left, right = (round(at * ratio) for at in (y - 14, y, x + 7, x + 26))
        beside = image[top:bottom, left:right]
        assert (beside.sum(axis=-1) < 250).sum() > 15, index


def test_the_names_of_a_crowded_net_leave_its_discs_alone(make_view, document, no_opengl, expected_pixel):
    """The raw surface is ten times as large as its net: with names and without, the discs are the same."""
    document = set_formulation(document, Formulation.PUBLISHED)
    view = make_view(document, layer=LayerChoice.RAW, axes=False).view
    named = pixels_of(view.image())
    choose(view, labels=False)
    bare = pixels_of(view.image())
    assert (named != bare).any()
    ratio = view.devicePixelRatioF()
    for index in np.ndindex(document.control_points.shape[:2]):
        x, y = (round(ratio * at) for at in expected_pixel(view, document.control_points[index]))
        np.testing.assert_array_equal(named[y - 3 : y + 4, x - 3 : x + 4], bare[y - 3 : y + 4, x - 3 : x + 4])


def test_the_colour_bar_has_the_colours_of_the_surface(make_view, document, renderer, colour_at):
    owner = make_view(document, colour_map=ColourMap.VIRIDIS)
    rect = bar_rect(owner.view.viewports[0].logical_size)
    image = owner.view.image()
    for part in (0.05, 0.5, 0.95):
        seen = np.array(colour_at(image, rect.center().x(), rect.bottom() - part * rect.height()))
        expected = colours_of(np.array([part]), 0.0, 1.0, ColourMap.VIRIDIS)[0]
        np.testing.assert_allclose(seen, expected, atol=8)


def test_painter_and_opengl_show_the_same(make_view, document, no_opengl, monkeypatch):
    painter = pixels_of(make_view(document, layer=LayerChoice.RAW, parameter_lines=False).view.image())
    monkeypatch.undo()
    opengl = pixels_of(make_view(document, layer=LayerChoice.RAW, parameter_lines=False).view.image())
    assert (np.abs(painter - opengl).max(axis=-1) > 48).mean() < 0.01


def test_parameter_lines_follow_the_samples(make_view, expected_pixel):
    """On a level plane with 31 samples a coarse line comes at every second one, and none between samples."""
    x, y = np.meshgrid(np.arange(5.0), np.arange(5.0))
    document = Document(np.stack([x, y, 0 * x], axis=-1), formulation="interpolating", samples=(31, 31))
    owner = make_view(document, layer=LayerChoice.RAW, style=Style.SMOOTH, **{**PLAIN, "parameter_lines": True})
    owner.view.set_camera("top", animated=False)
    make_view.settle(owner.view)
    image, patch = pixels_of(owner.view.image()).sum(axis=-1), configure(document).patch
    ratio = owner.view.devicePixelRatioF()

    def darkness(k):
        points = patch.points(np.linspace(k - 0.25, k + 0.25, 15) / 30, np.array([11.5 / 30]))[:, 0]
        places = [np.array(expected_pixel(owner.view, point)) * ratio for point in points]
        values = [image[round(y), round(x)] for x, y in places]
        return max(values) - min(values)

    assert min(darkness(k) for k in range(2, 30, 2)) > 40
    assert max(darkness(k + 0.5) for k in range(2, 28)) < 10
