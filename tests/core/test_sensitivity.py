"""dS/dknot against central differences, for every formulation, both layers and every knot."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Evaluation, Formulation, Layer, configure, edits, formulations
from qovr_core.edits import Direction, KnotPlace
from qovr_core.geometry.kernels import inverse_kernel_slopes, inverse_kernels
from qovr_core.geometry.weights import weight_coefficients, weight_slopes
from qovr_core.laboratory.sensitivity import knot_sensitivity
from qovr_core.presets import preset
from support.documents import documents, knot_values, knots, random_document

PLACES = [KnotPlace(direction, k, name) for direction in Direction for k in range(5) for name in "rsut"]
STEP = 1e-6


@pytest.fixture
def uncut(monkeypatch):
    """The published surface with uncut kernels: what its derivative is the derivative of."""
    monkeypatch.setattr(formulations, "PUBLISHED_KERNEL_DECIMALS", None)


def difference(document, place, layer):
    """Return the central difference quotient of the surface's coefficients."""
    value = edits.value_at(document, place)
    lower, upper = (
        Evaluation(edits.set_values(document, {place: value + step})).layer_patch(layer).coefficients[0, 0]
        for step in (-STEP, STEP)
    )
    return (upper - lower) / (2 * STEP)


@given(knot_values)
def test_kernels_change_as_their_closed_form_does(knot):
    slope = (inverse_kernels(knot + STEP) - inverse_kernels(knot - STEP)) / (2 * STEP)
    assert inverse_kernel_slopes(knot) == pytest.approx(slope, abs=1e-7 * np.abs(slope).max())


@given(knots)
def test_weights_change_as_they_are_computed(knots):
    values = np.array(tuple(knots))
    slopes = weight_slopes(values)
    for k, step in enumerate(STEP * np.eye(4)):
        quotient = (weight_coefficients(values + step) - weight_coefficients(values - step)) / (2 * STEP)
        assert slopes[k] == pytest.approx(quotient, abs=1e-6 * np.abs(slopes[k]).max())
    assert slopes.sum(axis=-1) == pytest.approx(np.zeros((4, 7)), abs=1e-12 * np.abs(slopes).max())


def test_slopes_of_many_curves_at_once():
    several = np.random.default_rng(3).uniform(0.1, 0.9, (2, 5, 4))
    assert weight_slopes(several).shape == (2, 5, 4, 7, 5)
    assert weight_slopes(several)[1, 2] == pytest.approx(weight_slopes(several[1, 2]), rel=1e-14)


@pytest.mark.parametrize("layer", list(Layer))
@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_every_knot_against_central_differences(uncut, formulation, layer):
    document = random_document(11, formulation, samples=(9, 14), low=0.25, high=0.75)
    result = configure(document)
    size = max(np.abs(difference(document, place, layer)).max() for place in PLACES)
    for place in PLACES:
        slope = knot_sensitivity(result, place, layer).coefficients[0, 0]
        assert slope == pytest.approx(difference(document, place, layer), abs=1e-7 * size), place


@given(documents(samples=(6, 9)), st.sampled_from(PLACES))
@settings(max_examples=60, deadline=None)
def test_the_raw_surface_of_any_document(document, place):
    document = replace(document, formulation=Formulation.INTERPOLATING)
    slope = knot_sensitivity(Evaluation(document), place, Layer.RAW).coefficients[0, 0]
    quotient = difference(document, place, Layer.RAW)
    assert slope == pytest.approx(quotient, abs=1e-5 * max(1.0, np.abs(quotient).max()))


@pytest.mark.parametrize("layer", list(Layer))
def test_the_published_surface_follows_up_to_its_cuts(layer):
    """Over a step that is long beside the cuts of 1e-4 the real surface moves as its derivative says."""
    document = edits.set_formulation(random_document(12, low=0.4, high=0.6), Formulation.PUBLISHED)
    for place in (KnotPlace(Direction.ROWS, 4, "s"), KnotPlace(Direction.COLUMNS, 1, "u")):
        slope = knot_sensitivity(Evaluation(document), place, layer).coefficients[0, 0]
        step = 0.01
        value = edits.value_at(document, place)
        lower, upper = (
            Evaluation(edits.set_values(document, {place: value + sign * step})).layer_patch(layer).coefficients[0, 0]
            for sign in (-1, 1)
        )
        assert (upper - lower) / (2 * step) == pytest.approx(slope, abs=0.02 * np.abs(slope).max())


def test_knots_of_the_rows_that_the_published_surface_leaves_out_do_nothing():
    result = configure(preset("fig6c").document)
    for layer in Layer:
        for k in range(4):
            assert not knot_sensitivity(result, KnotPlace(Direction.ROWS, k, "s"), layer).coefficients[0, 0].any()
        assert knot_sensitivity(result, KnotPlace(Direction.ROWS, 4, "s"), layer).coefficients[0, 0].any()


def test_where_two_samples_attain_the_box_the_slope_is_the_mean_of_both_sides(uncut):
    """The paper's net is symmetric, so its box is attained at mirrored samples that a knot drives apart."""
    document = preset("fig8").document
    place = KnotPlace(Direction.ROWS, 4, "r")
    slope = knot_sensitivity(configure(document), place, Layer.TRANSFORMED).coefficients[0, 0]
    assert slope == pytest.approx(difference(document, place, Layer.TRANSFORMED), abs=1e-5)


@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_a_flat_axis_only_moves(uncut, formulation):
    net = random_document(13).control_points.copy()
    net[..., 2] = 0.3
    document = edits.set_points(random_document(13, formulation, low=0.3, high=0.7), net)
    place = KnotPlace(Direction.COLUMNS, 2, "t")
    result = configure(document)
    assert result.flat_axes == ("z",)
    slope = knot_sensitivity(result, place, Layer.TRANSFORMED).coefficients[0, 0]
    assert slope == pytest.approx(difference(document, place, Layer.TRANSFORMED), abs=1e-6 * np.abs(slope).max())
    assert slope[..., 2] == pytest.approx(np.zeros((7, 7)), abs=1e-12)
