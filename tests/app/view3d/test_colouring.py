"""What colours mean: parts, limits, sections of maps, titles, notes, and that nothing is computed twice."""

import math
from dataclasses import replace

import numpy as np
import pytest

from qovr_app.state.display import ColourRange, DisplaySettings, Scaling
from qovr_app.style.canvas import blank_image, painting
from qovr_app.style.colour_maps import DIVERGING, colour_table
from qovr_app.style.theme import theme_of
from qovr_app.view3d.scene import scene as scenes
from qovr_app.view3d.scene.colouring import SINGULAR_NOTE, UNDEFINED, Colouring, colouring_of
from qovr_app.view3d.scene.companions import Companions
from qovr_app.view3d.scene.grid import spread
from qovr_app.view3d.scene.patterns import isophote_parts, zebra_is_light
from qovr_app.view3d.scene.scene import make_scene, scene_frame
from qovr_core import Document, Evaluation
from qovr_core.edits import Direction, KnotPlace, set_formulation
from qovr_core.fields import FIELDS, Field, field_values
from qovr_core.layer import Layer
from qovr_core.presets import preset
from support.view import choose, grid

GRID = grid(21, 17)
FIG8 = set_formulation(preset("fig8").document, "interpolating")
MIDDLE = (247, 246, 246)
"""Of the diverging map: nearly white."""


def scene_of(document, layer=Layer.RAW, scaling=Scaling.EACH, **companions):
    result = Evaluation(document)
    return make_scene(result, layer, scene_frame(result, layer, scaling), Companions(**companions))


def colouring(scene, by, *, moving=False, **settings):
    return colouring_of(scene, DisplaySettings(colour_by=by, **settings), GRID, moving=moving)


def net_of(height):
    y, x = np.mgrid[:5, :5].astype(float)
    return Document(np.stack([x, y, height(x, y) + 0 * x], axis=-1), formulation="interpolating")


@pytest.mark.parametrize("layer", [Layer.RAW, Layer.TRANSFORMED])
@pytest.mark.parametrize("scaling", list(Scaling))
def test_values_are_those_of_the_surface_in_the_documents_units(layer, scaling):
    """Not of the stretched surface in the unit space: the axes' scaling changes nothing."""
    scene, result = scene_of(FIG8, layer, scaling), Evaluation(FIG8)
    surface = result.patch if layer is Layer.RAW else result.transformed_patch
    u, v = (np.linspace(0, 1, count) for count in GRID.shape)
    for field in (Field.HEIGHT, Field.GAUSSIAN, Field.MEAN, Field.LARGEST, Field.SMALLEST):
        expected = field_values(field, surface, u, v)
        assert scene.values(field, GRID, moving=False) == pytest.approx(expected, rel=1e-12)
        shown, (low, high) = colouring(scene, field.name), colouring(scene, field.name).limits
        assert shown.parts(GRID) == pytest.approx((expected - low) / (high - low), abs=1e-6)


def test_heights_end_at_the_samples_of_the_document():
    assert colouring(scene_of(preset("fig5").document), "height").limits == pytest.approx((0.88, 1.2))


def test_diverging_limits_are_symmetric_and_zero_has_the_middle_colour():
    shown = colouring(scene_of(FIG8), "mean")
    assert shown.limits[0] == -shown.limits[1]
    assert tuple(shown.colours(np.array([0.5]), (0, 0, 0))[0]) == MIDDLE
    fixed = colouring(scene_of(FIG8), "mean", colour_range=ColourRange.FIXED, fixed_range=(-1.0, 3.0))
    assert fixed.limits == (-1, 3)
    assert np.abs(fixed.table[64].astype(int) - MIDDLE).max() <= 4  # zero lies a quarter of the way up
    assert fixed.table[255] == pytest.approx(colour_table(DIVERGING)[255], abs=1)
    assert fixed.table[0] == pytest.approx(colour_table(DIVERGING)[85], abs=2)  # -1 of a map from -3 to 3


def test_only_values_beyond_the_ends_are_told():
    scene = scene_of(FIG8)
    assert colouring(scene, "gaussian").beyond == (False, False)
    assert colouring(scene, "height", colour_range=ColourRange.ROBUST).beyond == (True, True)
    low, high = scene.surface_box[2]
    ranges = {(low, high - 0.1): (False, True), (low + 0.1, high): (True, False), (low - 1, high + 1): (False, False)}
    for limits, beyond in ranges.items():
        shown = colouring(scene, "height", colour_range=ColourRange.FIXED, fixed_range=limits)
        assert (shown.limits, shown.beyond) == (limits, beyond)


def test_a_level_surface_has_one_colour_and_a_plane_no_curvature():
    scene = scene_of(net_of(lambda x, y: 0.1 + 0.2))
    shown = colouring(scene, "height")
    assert shown.limits[0] == shown.limits[1] == pytest.approx(0.3)
    assert (shown.parts(GRID) == 0.5).all()
    plane = scene_of(net_of(lambda x, y: 0.3 * x - 0.1 * y))
    bent = colouring(plane, "gaussian")
    assert bent.limits == (0, 0)
    assert (bent.parts(GRID) == 0.5).all()


def test_without_a_companion_the_picture_says_what_to_do():
    scene = scene_of(FIG8)
    for by, note in (("distance", Field.DISTANCE.missing), ("sensitivity", Field.SENSITIVITY.missing)):
        shown = colouring(scene, by)
        assert shown.note == note
        assert math.isnan(shown.limits[0])
        assert (shown.parts(GRID) == np.float32(UNDEFINED)).all()
        assert (shown.colours(shown.parts(GRID), (1, 2, 3)) == [1, 2, 3]).all()


def test_a_surface_without_curvature_says_so():
    shown = colouring(scene_of(Document(np.full((5, 5, 3), 2.0))), "mean")
    assert shown.note == SINGULAR_NOTE
    assert colouring(scene_of(Document(np.full((5, 5, 3), 2.0))), "height").note == ""


def test_distance_and_sensitivity_name_what_they_belong_to():
    reference = Evaluation(preset("fig5").document).patch
    knot = KnotPlace(Direction.COLUMNS, 2, "u")
    scene = scene_of(FIG8, reference=reference, reference_name="a file with a very long name.qovr", knot=knot)
    shown = colouring(scene, "distance")
    assert shown.title == "Distance from a file with a very long…"
    assert shown.limits[1] > 1
    assert colouring(scene, "sensitivity").title == "Sensitivity |∂S/∂v_ip of K_2|"
    idle = scene_of(preset("fig5").document, knot=KnotPlace(Direction.ROWS, 1, "s"))
    assert colouring(idle, "sensitivity").note == "s_ip of C_1 has no effect on the published surface"


def test_patterns_tell_whether_the_shape_is_stretched():
    titles = {
        scaling: [colouring(scene_of(FIG8), by, scaling=scaling).title for by in ("zebra", "isophotes")]
        for scaling in Scaling
    }
    assert all("stretched" in title for title in titles[Scaling.EACH])
    assert not any("stretched" in title for title in titles[Scaling.EQUAL])


def test_nothing_is_computed_twice(monkeypatch):
    calls = []

    def counted(field, *arguments):
        calls.append(field)
        return field_values(field, *arguments)

    monkeypatch.setattr(scenes, "field_values", counted)
    scene = scene_of(FIG8)
    first = colouring(scene, "gaussian")
    assert colouring(scene, "gaussian") is first
    colouring(scene, "gaussian", colour_range=ColourRange.ROBUST).parts(GRID)
    assert calls == [Field.GAUSSIAN]


def test_in_motion_costly_fields_are_taken_from_fewer_points(monkeypatch):
    sizes = []

    def counted(field, surface, u, v, companion):
        sizes.append((len(u), len(v)))
        return field_values(field, surface, u, v, companion)

    monkeypatch.setattr(scenes, "field_values", counted)
    scene = scene_of(FIG8, reference=Evaluation(preset("fig8").document).patch)
    for moving in (True, False):
        for by in ("height", "mean", "distance"):
            values = scene.values(FIELDS[by], grid(201, 201), moving=moving)
            assert values.shape == (201, 201)
    assert sizes == [(201, 201), (49, 49), (25, 25), (201, 201), (101, 101)]  # the heights of rest are those of motion


def test_spreading_is_linear_and_keeps_what_is_undefined_to_itself():
    values = np.add.outer(3 * np.linspace(0, 1, 5), np.linspace(0, 2, 4))
    fine = np.add.outer(3 * np.linspace(0, 1, 33), np.linspace(0, 2, 10))
    assert spread(values, grid(*values.shape), grid(33, 10)) == pytest.approx(fine)
    assert spread(values, grid(5, 4), grid(5, 4)) is values
    values[0] = np.nan
    undefined = np.isnan(spread(values, grid(*values.shape), grid(33, 10)))
    assert undefined[:8].all()
    assert not undefined[9:].any()


def test_isophotes_and_zebra_of_known_normals():
    tilts = np.radians([0.0, 9.0, 11.0, 44.0, 89.0])
    normals = np.stack([0 * tilts, np.sin(tilts), np.cos(tilts)], axis=1)
    toward = np.broadcast_to([0.0, 0.0, 1.0], normals.shape)
    assert isophote_parts(normals, toward) == pytest.approx(np.array([0, 0, 1, 4, 8]) / 8)
    assert isophote_parts(-normals, toward) == pytest.approx(np.array([0, 0, 1, 4, 8]) / 8)
    # A normal tilted up by t mirrors what lies 90 - 2 t degrees from the vertical; stripes are 15 degrees long.
    for tilt, normal in zip(np.degrees(tilts), normals, strict=True):
        part = abs(90 - 2 * tilt) / 15 % 1
        assert zebra_is_light(normal[None], toward[:1])[0] == (abs(part - 0.5) > 0.25)


@pytest.mark.parametrize("value", [1 / 3, 4.3e-17, -2.5e13, 0.0])
def test_one_value_alone_is_written_short(app, value):
    from PySide6.QtCore import QRectF

    from qovr_app.view3d.painter.colour_bar import draw_ticks

    image = blank_image((120.0, 300.0), 1.0)
    colouring = Colouring(colour_table("jet"), "z", (value, value))
    with painting(image) as painter:
        assert draw_ticks(painter, QRectF(10, 10, 14, 280), colouring, theme_of("light")) < 40


@pytest.mark.parametrize(
    "limits", [(-3e-9, 3e-9), (-2e-3, 1e-3), (0.0, 0.73), (12.0, 97.0), (-4e11, 5e11), (-9e3, 9e3)]
)
def test_numbers_on_the_bar_leave_room_for_the_title(app, limits):
    from PySide6.QtCore import QRectF

    from qovr_app.view3d.painter.colour_bar import draw_ticks

    image = blank_image((120.0, 300.0), 1.0)
    colouring = Colouring(colour_table("jet"), "z", limits)
    with painting(image) as painter:
        assert 0 < draw_ticks(painter, QRectF(10, 10, 14, 280), colouring, theme_of("light")) < 40


def test_the_bar_is_drawn_again_only_where_it_looks_different(make_view, document):
    """An edit makes a new colouring, whose limits are held."""
    from qovr_app.view3d.painter.colour_bar import colour_bar

    view = make_view(document).view

    def bar():
        return next(colour_bar(view.picture(), (400.0, 300.0)))

    before, colouring = bar(), view.picture().colouring
    net = document.control_points.copy()
    net[2, 2, 2] += 1e-3
    view.display(replace(view.shown, evaluation=Evaluation(replace(document, control_points=net))))
    assert view.picture().colouring is not colouring
    assert bar() == before
    choose(view, colour_range=ColourRange.FIXED, fixed_range=(0.5, 2.0))
    assert bar() != before
