"""The box of a net's samples: that of all of them, and of whatever edit it comes the same to the last bit."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Document, Evaluation, Formulation, Patch, edits
from qovr_core.geometry.knots import Direction
from support.documents import seeds
from support.nets import closed_net, random_net_document

EPS = np.finfo(float).eps
FORMULATIONS = st.sampled_from(list(Formulation.table.values()))
SAMPLES = 410, 433
"""So many that not all are computed, and not a multiple of the windows."""


def agrees(document):
    """Return whether the box is that of all samples, within 8 eps of each axis's largest coefficient."""
    evaluation = Evaluation(document)
    samples, coefficients = evaluation.raw.reshape(-1, 3), evaluation.patch.coefficients
    error = np.abs(evaluation.raw_box - np.stack([samples.min(axis=0), samples.max(axis=0)], axis=1)).max(axis=1)
    return bool((error <= 8 * EPS * np.abs(coefficients).max(axis=(0, 1, 2, 3))).all())


def moved(document, rng):
    """Return the document after one random edit: a point, a knot, or the samples."""
    kind = rng.integers(5)
    i, j = (int(rng.integers(count)) for count in document.control_points.shape[:2])
    if kind < 3:
        return edits.set_point(document, i, j, document.control_points[i, j] + rng.normal(0, 1, 3) * (kind > 0))
    if kind == 3:
        direction = list(Direction)[rng.integers(2)]
        knots = edits.knots_of(document, direction).array.copy()
        knots[rng.integers(len(knots)), rng.integers(knots.shape[1])] = rng.uniform(0.3, 0.7, 4)
        rows, columns = document.row_knots, document.column_knots
        rows, columns = (knots, columns) if direction is Direction.ROWS else (rows, knots)
        return Document(document.control_points, rows, columns, document.formulation, document.samples)
    return edits.set_samples(document, tuple(rng.permutation(SAMPLES).tolist()))


@given(seeds, FORMULATIONS, st.tuples(st.integers(1, 6), st.integers(1, 6)), st.sampled_from([0.0, 0.05, 1.0]))
@settings(max_examples=15, deadline=None)
def test_a_box_does_not_tell_by_which_edits_it_came(seed, formulation, windows, flatness):
    rng = np.random.default_rng(seed)
    document = random_net_document(
        seed, windows, formulation=formulation, smooth=0.5, flatness=flatness, samples=SAMPLES
    )
    evaluation = Evaluation(document)
    for _ in range(6):
        document = moved(document, rng)
        evaluation = Evaluation(document, evaluation)
        if rng.random() < 0.7:  # else the next one stands on what an older one knew
            fresh = Evaluation(document)
            assert np.array_equal(evaluation.raw_box, fresh.raw_box)
            assert np.array_equal(evaluation.matrix, fresh.matrix)
            assert np.array_equal(evaluation.rounding, fresh.rounding)


@given(
    seeds,
    FORMULATIONS,
    st.tuples(st.integers(1, 40), st.integers(1, 12)),
    st.tuples(st.integers(400, 900), st.integers(400, 900)),
    st.sampled_from([0.0, 0.05, 1.0]),
    st.sampled_from([0.2, 0.02]),
)
@settings(max_examples=25, deadline=None)
def test_random_nets(seed, formulation, windows, samples, flatness, margin):
    """Counts that differ from window to window, folds, flat nets and knots at the ends among them."""
    assert agrees(
        random_net_document(
            seed, windows, formulation=formulation, smooth=0.5, flatness=flatness, samples=samples, margin=margin
        )
    )


def ridge(height, windows=(9, 7)):
    """Return a net of a height over the unit square, whose crest runs across many windows."""
    m, n = windows
    y, x = np.meshgrid(np.linspace(0, 1, 2 * m + 3), np.linspace(0, 1, 2 * n + 3), indexing="ij")
    return Document(np.stack([x, y, height(x, y)], axis=-1), formulation=Formulation.INTERPOLATING, samples=SAMPLES)


RIDGES = {
    "constant height": lambda x, y: 0.3 + 0 * x,
    "extruded": lambda x, y: -((x - 0.3337) ** 2) + 0 * y,
    "turned": lambda x, y: -((0.8 * x + 0.6 * y - 0.7) ** 2),
    "diagonal": lambda x, y: -((x + y - 1) ** 2),
    "cylinder": lambda x, y: np.sqrt(np.maximum(0, 1 - (2 * y - 1) ** 2)),
    "waves of one height": lambda x, y: np.cos(12 * np.pi * x) * np.cos(12 * np.pi * y),
    "far away": lambda x, y: 1e9 + 1e-6 * x * (1 - x) * y,
}


@pytest.mark.parametrize("name", RIDGES)
def test_ridges_across_windows(name):
    assert agrees(ridge(RIDGES[name]))


@pytest.mark.parametrize("along", [("u",), ("v",), ("u", "v")])
def test_closed_nets(along):
    assert agrees(edits.set_samples(closed_net(3, (4, 5), along), SAMPLES))


def test_one_window_of_many_holds_every_extreme():
    """The bounds of a window that is renewed are its own, wherever it is."""
    document = random_net_document(5, (6, 5), flatness=0.1, samples=SAMPLES)
    evaluation = Evaluation(document)
    evaluation.raw_box  # noqa: B018 - so that the next one has what to stand on
    for i, j in ((2, 2), (14, 12), (0, 6), (7, 7)):
        raised = edits.set_point(document, i, j, (-50.0, 70.0, 90.0))
        after = Evaluation(raised, evaluation)
        assert np.array_equal(after.raw_box, Patch.sampled_box(after.patch, *raised.intervals))
        assert np.array_equal(Evaluation(document, after).raw_box, evaluation.raw_box)
