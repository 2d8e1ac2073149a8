"""The box of the samples is that of all of them, though hardly any is computed."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from qovr_core import Formulation, Patch, build_patch
from qovr_core.geometry import sampled_box as module
from qovr_core.presets import presets
from support.documents import random_document, seeds

EPS = np.finfo(float).eps
T = np.linspace(0, 1, 7)


def bernstein_basis(parameters):
    """Return the basis of degree 6 as the definition says, by Python's own binomials."""
    from math import comb

    x = np.asarray(parameters)[:, None]
    return np.hstack([comb(6, k) * x**k * (1 - x) ** (6 - k) for k in range(7)])


def interpolated(values):
    """Return the coefficients of the polynomials of degree 6 each way with these values at 7 x 7 places."""
    to_coefficients = np.linalg.inv(bernstein_basis(T))
    return np.einsum("ai,bj,ijd->abd", to_coefficients, to_coefficients, values)


def box_of_all(coefficients, n, m):
    """Return the box of every sample, a slice of them at a time."""
    along_v = np.einsum("jb,abd->ajd", bernstein_basis(np.linspace(0, 1, m)), coefficients)
    low, high = np.full(3, np.inf), np.full(3, -np.inf)
    for rows in np.array_split(bernstein_basis(np.linspace(0, 1, n)), max(1, n // 256)):
        points = np.tensordot(rows, along_v, axes=1)
        low, high = np.minimum(low, points.min(axis=(0, 1))), np.maximum(high, points.max(axis=(0, 1)))
    return np.stack([low, high], axis=1)


def sampled_box(coefficients, n, m):
    return module.sampled_box(coefficients[None, None], np.array([n - 1]), np.array([m - 1]))


def agrees(coefficients, n, m):
    error = np.abs(sampled_box(coefficients, n, m) - box_of_all(coefficients, n, m)).max(axis=1)
    return bool((error <= 8 * EPS * np.abs(coefficients).max(axis=(0, 1))).all())


def turned(coefficients, angle=0.6, tilt=0.9):
    """Return the surface turned about z and tilted about x, so that every axis sees what was along one."""
    c, s, p, q = np.cos(angle), np.sin(angle), np.cos(tilt), np.sin(tilt)
    return (
        coefficients @ (np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) @ np.array([[1, 0, 0], [0, p, -q], [0, q, p]])).T
    )


def over_the_square(height):
    u, v = np.meshgrid(T, T, indexing="ij")
    return interpolated(np.stack([u, v, height(u, v)], axis=-1))


SHAPES = {
    "constant height": over_the_square(lambda u, v: 0.3 + 0 * u),
    "extruded ridge": over_the_square(lambda u, v: -((u - 0.3337) ** 2) + 0 * v),
    "diagonal ridge": over_the_square(lambda u, v: -((u + v - 1) ** 2)),
    "oblique ridge": over_the_square(lambda u, v: -((u + 0.7312 * v - 0.8123) ** 2)),
    "steep oblique ridge": over_the_square(lambda u, v: 1e3 - 1e6 * (0.31 * u + 0.9 * v - 0.6) ** 2),
    "cylinder": over_the_square(lambda u, v: 4 * u * (1 - u) * (1 + u * (1 - u) / 2) + 0 * v),
    "two hills of one height": over_the_square(lambda u, v: -(((u - 0.2) * (u - 0.8)) ** 2) - (v - 0.5) ** 2),
    "slow wave far away": over_the_square(lambda u, v: 1e9 + 1e-6 * u * (1 - u) * v),
}
COUNTS = [(2, 2), (2, 4096), (4096, 70), (399, 401), (1001, 513)]


@pytest.mark.parametrize("counts", COUNTS, ids=str)
@pytest.mark.parametrize("name", SHAPES)
def test_ridges_hills_and_plains(name, counts):
    for coefficients in (SHAPES[name], turned(SHAPES[name])):
        assert agrees(coefficients, *counts)
        assert agrees(coefficients.transpose(1, 0, 2), *counts)


def test_the_largest_grid():
    assert agrees(turned(SHAPES["oblique ridge"]), 4096, 4096)


@pytest.mark.parametrize("name", presets())
def test_the_papers_cases(name):
    assert agrees(build_patch(presets()[name].document).coefficients[0, 0], 777, 512)


@given(
    seeds,
    st.sampled_from(list(Formulation.table.values())),
    st.tuples(st.integers(2, 1500), st.integers(2, 1500)),
    st.sampled_from([0.05, 1e-4]),
)
@settings(max_examples=25)
def test_random_nets_with_knots_near_the_ends(seed, formulation, counts, low):
    assert agrees(build_patch(random_document(seed, formulation, low=low, high=1 - low)).coefficients[0, 0], *counts)


def test_few_samples_are_computed(monkeypatch):
    """Of the 3 x 4096 x 4096 coordinates, fewer than one in a hundred are, be it on a ridge across the grid."""
    computed = []
    product = module._tensor_product

    def counting(left, pieces, right):
        computed.append(len(left) * len(pieces) * len(right))
        return product(left, pieces, right)

    monkeypatch.setattr(module, "_tensor_product", counting)
    for coefficients in (*SHAPES.values(), *(turned(shape) for shape in SHAPES.values())):
        computed.clear()
        sampled_box(coefficients, 4096, 4096)
        assert sum(computed) < 0.01 * 3 * 4096**2


@pytest.mark.parametrize("size", [1e-300, 1e12])
def test_any_size(size):
    coefficients = size * build_patch(presets()["fig8"].document).coefficients[0, 0]
    assert agrees(coefficients, 1001, 500)


def test_a_patch_gives_it_read_only():
    patch = Patch(SHAPES["cylinder"])
    box = patch.sampled_box(np.array([599]), np.array([499]))
    assert not box.flags.writeable
    assert box[:2] == pytest.approx(np.array([[0, 1], [0, 1]]))
