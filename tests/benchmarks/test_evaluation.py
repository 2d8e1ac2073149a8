"""The surface against copying memory, Splipy, SciPy and the literal Algorithm 1."""

import tracemalloc

import numpy as np
import pytest
from scipy.interpolate import BSpline, NdBSpline
from splipy import BSplineBasis
from splipy import Surface as SplipySurface

from qovr_core import Document, Formulation, build_patch, configure
from qovr_core.evaluation import parameters
from qovr_core.geometry import bernstein, grid
from support import algorithm1
from support.documents import random_document

from .timing import in_turn

SIZES = (101, 501, 1001, 2001)
LARGEST = 4096
SCREEN = 201
"""Points along each direction that the view draws at rest, however many samples there are."""

LITERAL = 31
KNOTS = [0.0] * 5 + [1.0] * 5


def document(size):
    return random_document(1, Formulation.PUBLISHED, samples=(size, size))


def raw(size):
    """Return a call that makes a document's raw samples."""
    source, u = document(size), parameters(size)
    return lambda: build_patch(source).points(u, u)


def copy(size):
    source = np.random.default_rng(0).random((size, size, 3))
    target = np.zeros_like(source)
    return lambda: np.copyto(target, source)


def splipy(size):
    net = document(size).control_points.transpose(1, 0, 2).reshape(25, 3)
    surface = SplipySurface(BSplineBasis(5, KNOTS), BSplineBasis(5, KNOTS), net)
    u = parameters(size).copy()  # Splipy snaps parameters to knots in place
    return lambda: surface(u, u)


def scipy_points(size):
    """Return a call that evaluates at any points, as SciPy does for tensor products."""
    spline = NdBSpline((np.array(KNOTS), np.array(KNOTS)), document(size).control_points, k=4)
    points = np.stack(np.meshgrid(parameters(size), parameters(size), indexing="ij"), axis=-1).reshape(-1, 2)
    return lambda: spline(points)


def scipy_grid(size):
    """Return a call that evaluates on the grid, one direction after the other."""
    net, u = document(size).control_points, parameters(size)

    def samples():
        curves = BSpline(np.array(KNOTS), net, 4)(u)
        return BSpline(np.array(KNOTS), curves, 4, axis=1)(u)

    return samples


@pytest.mark.parametrize("size", SIZES)
def test_copy(measure, size):
    measure(f"raw/copy {size}", raw(size), copy(size))


def given(size):
    """Return calls that make raw samples in a given array, make them by one bare product in blocks, and copy them."""
    source, patch, out = document(size), build_patch(document(size)), np.empty((size, size, 3))
    basis, flat = np.ascontiguousarray(bernstein.basis(6, parameters(size))), out.reshape(size, -1)
    table = np.einsum("jb,abd->ajd", basis, patch.coefficients[0, 0]).reshape(7, -1)
    rows, samples = grid.BLOCK_BYTES // out[0].nbytes, np.zeros_like(out)

    def bare():
        for k in range(0, size, rows):
            np.matmul(basis[k : k + rows], table, out=flat[k : k + rows])

    return lambda: patch.samples(*source.intervals, out=out), bare, lambda: np.copyto(out, samples)


@pytest.mark.parametrize("size", [1001, 2001])
def test_given_array(measure, size):
    ours, bare, copied = given(size)
    measure(f"out/matmul {size}", ours, bare, rounds=30)
    measure(f"out/copy {size}", ours, copied, rounds=30)


@pytest.mark.parametrize("size", SIZES)
def test_splipy(measure, size):
    measure(f"splipy {size}", raw(size), splipy(size), rounds=15 if size < 2001 else 5)


@pytest.mark.parametrize("size", [101, 501, 1001])
def test_scipy(measure, size):
    measure(f"scipy {size}", raw(size), scipy_points(size), every=5)


def test_scipy_grid(measure):
    measure("scipy grid 1001", raw(1001), scipy_grid(1001))


def test_algorithm_1(measure):
    source: Document = document(LITERAL)
    rows, columns = (knots.array[:, 0].tolist() for knots in (source.row_knots, source.column_knots))
    net, u = source.control_points.tolist(), parameters(LITERAL).tolist()
    literal = lambda: [[algorithm1.point(net, rows, columns, "published", a, b) for b in u] for a in u]  # noqa: E731
    measure("algorithm 1", raw(LITERAL), literal, every=15)


def test_time_per_point(record):
    sizes = (501, 1001, 2001, LARGEST)
    runs = np.transpose(in_turn(*map(raw, sizes), rounds=5)) * 1e9 / np.square(sizes)
    record("time per point", runs.max(axis=1), runs.min(axis=1))


def test_configure(measure):
    large, small = document(1001), document(101)
    measure("configure/copy", lambda: configure(large), copy(1001))
    measure("configure/splipy", lambda: configure(small), splipy(101), rounds=30)


def box(size):
    """Return a call that finds the box that T needs, in the program's way."""
    patch = build_patch(document(size))
    return lambda: patch.sampled_box(np.array([size - 1]), np.array([size - 1]))


def box_of_all(size):
    patch = build_patch(document(size))

    def found():
        basis = grid.PieceBasis(bernstein.basis(6, parameters(size)), (0, size))
        return grid.box(patch.coefficients, basis, basis)

    return found


@pytest.mark.parametrize("size", [*SIZES, LARGEST])
def test_box(measure, size):
    measure(f"box/all {size}", box(size), box_of_all(size), rounds=15 if size < 2001 else 3)


@pytest.mark.parametrize("size", [*SIZES, LARGEST])
def test_box_of_a_ridge(measure, size):
    """Along the whole crest, the samples are nearly as high as the highest."""
    y, x = np.mgrid[:5, :5] / 4
    ridge = -((x + 0.7312 * y - 0.8123) ** 2)
    patch = build_patch(Document(np.stack([x, ridge, y + ridge], axis=-1), formulation=Formulation.INTERPOLATING))
    measure(f"box ridge {size}", lambda: patch.sampled_box(np.array([size - 1]), np.array([size - 1])))


@pytest.mark.parametrize("size", [1001, LARGEST])
def test_box_beside_the_screen(measure, size):
    measure(f"box/screen {size}", box(size), raw(SCREEN))


@pytest.mark.parametrize("size", [1001, LARGEST])
def test_peak_memory(record, size):
    source = document(size)
    configure(source)
    tracemalloc.start()
    surface = configure(source)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    results = surface.raw.nbytes + surface.transformed.nbytes
    record(f"configure memory {size}", [peak / 1e6], [results / 1e6])
