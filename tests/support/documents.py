"""Random documents, for hypothesis and by seed."""

import numpy as np
from hypothesis import strategies as st

from qovr_core import FORMULATIONS, Document, Formulation, Knots
from qovr_core.edits import KnotPlace, set_values

knot_values = st.floats(0.05, 0.95)
knots = st.builds(Knots, knot_values, knot_values, knot_values, knot_values)
curves = st.tuples(*[knots] * 5)
formulations = st.sampled_from(list(FORMULATIONS.values()))
seeds = st.integers(0, 2**32 - 1)


def random_net(seed, size=1.0):
    """Return a net like the paper's, x = j, y = i, every point moved at random."""
    rng = np.random.default_rng(seed)
    y, x = np.mgrid[:5, :5].astype(float)
    return size * (np.stack([x, y, 0 * x], axis=-1) + rng.uniform(-0.4, 0.4, (5, 5, 3)))


nets = st.builds(random_net, seeds)


def random_document(seed, formulation=Formulation.INTERPOLATING, samples=(7, 5), low=0.05, high=0.95):
    rng = np.random.default_rng(seed)
    rows, columns = (tuple(Knots(*k) for k in rng.uniform(low, high, (5, 4))) for _ in range(2))
    return Document(random_net(seed), rows, columns, formulation, samples)


def documents(samples=(7, 5)):
    return st.builds(Document, nets, curves, curves, formulations, st.just(samples))


def size(points):
    """Return the diagonal of the points' box."""
    flat = np.asarray(points).reshape(-1, 3)
    return float(np.linalg.norm(flat.max(axis=0) - flat.min(axis=0)))


def with_knot(document, direction, name, value, curve=None):
    """Return a document of one window with one knot changed, of one curve or of all of them."""
    curves = range(5) if curve is None else (curve,)
    return set_values(document, {KnotPlace(direction, k, name): value for k in curves})
