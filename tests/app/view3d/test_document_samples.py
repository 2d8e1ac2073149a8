"""The document's samples drawn as they are: every facet flat, whoever draws it, and all of them."""

import numpy as np
import pytest

from qovr_app.state.display import ColourMap, LayerChoice, Style
from qovr_app.style.colour_maps import colours_of
from qovr_app.view3d.gl import api, mark_rows
from qovr_app.view3d.interaction.picking import points_under
from qovr_app.view3d.scene.grid import Grid
from qovr_app.view3d.scene.probing import parameters_under
from qovr_core import Document, Evaluation
from qovr_core.edits import set_point, set_samples
from qovr_core.fields import FIELDS, field_values
from qovr_core.layer import Layer
from support.view import change, choose

PLAIN = {"control_points": False, "labels": False, "control_net": False, "parameter_lines": False, "joints": False}
INSIDE = np.array([[0.2, 0.2], [0.75, 0.15], [0.8, 0.8], [0.2, 0.75], [0.55, 0.4]])
"""Places in a cell, none of them near a side or the diagonal."""


@pytest.fixture
def cell_colours(expected_pixel, colour_at):
    """A function that returns the colours seen at places inside a cell between samples (2, 2, 3), (k, 3)."""

    def colours(view, image, corners, viewport=0):
        seen = []
        for s, t in INSIDE:
            # On the triangle of the two that holds the place; both have the first corner and the one across.
            a, b, c, d = corners[0, 0], corners[1, 0], corners[1, 1], corners[0, 1]
            point = a + (s - t) * (b - a) + t * (c - a) if s > t else a + (t - s) * (d - a) + s * (c - a)
            seen.append(colour_at(image, *expected_pixel(view, point, viewport)))
        return np.array(seen, dtype=int)

    return colours


def from_above(make_view, document, **settings):
    owner = make_view(document, document_samples=True, colour_map=ColourMap.JET, **{**PLAIN, **settings})
    owner.view.set_camera("top", animated=False)
    make_view.settle(owner.view)
    return owner.view


def cells(samples):
    """Return each cell of samples by its first corner's number: the samples at its corners, (2, 2, 3)."""
    for i, j in np.ndindex(samples.shape[0] - 1, samples.shape[1] - 1):
        yield (i, j), samples[i : i + 2, j : j + 2]


@pytest.mark.parametrize("by", ["height", "mean"])
def test_every_facet_has_one_colour_that_of_its_first_sample(make_view, document, renderer, by, cell_colours):
    document = set_samples(document, (4, 6))
    view = from_above(make_view, document, layer=LayerChoice.RAW, colour_by=by)
    evaluation, colouring = Evaluation(document), view.picture().colouring
    values = field_values(FIELDS[by], evaluation.patch, np.linspace(0, 1, 4), np.linspace(0, 1, 6))
    for at, corners in cells(evaluation.raw):
        expected = colouring.table[int(np.interp(values[at], colouring.limits, [0, 255]).round())]
        assert np.abs(cell_colours(view, view.image(), corners) - expected).max() <= 8, at


def test_both_layers_are_drawn_by_their_own_samples(make_view, document, renderer, cell_colours):
    document = set_samples(document, (3, 3))
    view = from_above(make_view, document, layer=LayerChoice.BOTH, axes=False)
    evaluation = Evaluation(document)
    for number, layer in enumerate(Layer):
        image, box = view.viewports[number].image(), view.picture(number).scene.surface_box[2]
        for _, corners in cells(evaluation.samples(layer)):
            expected = colours_of(corners[0, 0, 2:], *box, ColourMap.JET)[0].astype(int)
            assert np.abs(cell_colours(view, image, corners, number) - expected).max() <= 8


def test_the_windows_of_a_net_have_their_own_samples(make_view, renderer, cell_colours):
    y, x = np.mgrid[:7, :9].astype(float)
    document = Document(np.stack([x, y, np.sin(x) + np.cos(y)], axis=-1), formulation="interpolating", samples=(9, 5))
    view = from_above(make_view, document, layer=LayerChoice.RAW)
    assert view.picture().grid == Grid((3, 3, 2), (2, 2))
    box = view.picture().scene.surface_box[2]
    for at, corners in cells(Evaluation(document).raw):
        expected = colours_of(corners[0, 0, 2:], *box, ColourMap.JET)[0].astype(int)
        assert np.abs(cell_colours(view, view.image(), corners) - expected).max() <= 8, at


def test_light_falls_on_flat_facets(make_view, document, renderer, cell_colours):
    """In clay, which is light alone, a triangle has one brightness, and the next one another."""
    document = set_samples(document, (4, 4))
    view = from_above(make_view, document, layer=LayerChoice.RAW, style=Style.CLAY)
    samples, first = Evaluation(document).raw, []
    for _, corners in cells(samples):
        below = cell_colours(view, view.image(), corners)[[1, 4]]
        assert np.ptp(below, axis=0).max() <= 2
        first.append(below[0].sum())
    assert np.ptp(first) > 20
    choose(view, document_samples=False)
    corners = samples[:2, :2]
    assert np.ptp(cell_colours(view, view.image(), corners), axis=0).max() > 5


@pytest.mark.parametrize("style", list(Style))
@pytest.mark.parametrize("by", ["zebra", "isophotes", "none", "gaussian"])
def test_every_style_and_pattern_draws_them(make_view, document, renderer, style, by):
    view = make_view(document, document_samples=True, style=style, colour_by=by, axes=False, colour_bar=False).view
    shown = view.image()
    choose(view, surface=False)
    assert shown != view.image()


def test_all_samples_are_drawn_while_a_point_is_moved(make_view, document):
    view = from_above(make_view, set_samples(document, (301, 257)), layer=LayerChoice.RAW)
    assert view.picture().grid.shape == (301, 257)
    view._show(moving=True)
    assert view.picture().moving
    assert view.picture().grid.shape == (301, 257)


def test_an_edit_brings_only_places_to_the_driver(make_view, document, monkeypatch):
    """Neither triangles, nor normals, nor values of heights; beside them there are only marks."""
    document = set_samples(document, (41, 31))
    view = make_view(document, layer=LayerChoice.RAW, document_samples=True).view
    brought = []
    load = api.load_attributes

    def note_and_load(buffer, values, widths, **more):
        if widths != mark_rows.WIDTHS:
            brought.append(values.nbytes)
        load(buffer, values, widths, **more)

    monkeypatch.setattr(api, "load_indices", lambda *_: brought.append("indices"))
    monkeypatch.setattr(api, "load_values", lambda *_: brought.append("values"))
    monkeypatch.setattr(api, "load_attributes", note_and_load)
    change(view, document=set_point(document, 2, 2, (2.0, 2.0, 0.7)))
    view.viewports[0].image()
    assert brought == [41 * 31 * 3 * 4]


def test_probe_and_points_are_found_as_before(make_view, document):
    view = from_above(make_view, set_samples(document, (4, 4)), layer=LayerChoice.RAW, control_points=True)
    picture, size = view.picture(), view.viewports[0].logical_size
    x, y, _ = picture.camera.project(picture.scene.patch.points([0.3], [0.6])[0, 0], size)
    assert parameters_under(picture.scene, picture.camera, size, x, y) == pytest.approx((0.3, 0.6))
    x, y, _ = picture.camera.project(picture.scene.points[1, 3], size)
    assert points_under(picture, size, x, y)[0] == (1, 3)


def test_figures_show_the_facets(make_view, document, tmp_path, expected_pixel):
    """Along a line across it the exact surface has many more colours than four facets have."""
    from PySide6.QtGui import QImage

    from qovr_app.state.figure_options import FigureOptions

    view = from_above(make_view, set_samples(document, (3, 3)), layer=LayerChoice.RAW, axes=False, triad=False)
    counts = []
    for is_flat in (True, False):
        choose(view, document_samples=is_flat, style=Style.SMOOTH)
        view.save_figure(tmp_path / "figure.png", FigureOptions(100, 80, 100))
        image = QImage(str(tmp_path / "figure.png")).convertToFormat(QImage.Format.Format_RGB888)
        rows = np.frombuffer(image.constBits(), np.uint8).reshape(image.height(), -1)[:, : 3 * image.width()]
        middle = rows.reshape(image.height(), image.width(), 3)[image.height() // 3, : image.width() * 3 // 4]
        counts.append(len(np.unique(middle, axis=0)))
    assert counts[0] < counts[1] / 2
