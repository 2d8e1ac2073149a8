"""The surface against copying memory, Splipy, SciPy and the literal Algorithm 1."""

import tracemalloc

import numpy as np
import pytest
from scipy.interpolate import NdBSpline
from splipy import BSplineBasis
from splipy import Surface as SplipySurface

from qovr_core import Document, Formulation, build_patch, configure
from qovr_core.evaluation import parameters
from qovr_core.geometry import bernstein, grid
from support import algorithm1
from support.documents import random_document

from .conftest import MEDIANS

SIZES = (101, 501, 1001, 2001)
LARGEST = 4096
SCREEN = 201
"""Points along each direction that the view draws at rest, however many samples there are."""

LITERAL = 31
KNOTS = [0.0] * 5 + [1.0] * 5


def document(size):
    return random_document(1, Formulation.PUBLISHED, samples=(size, size))


def raw_points(source):
    u, v = (parameters(count) for count in source.samples)
    return build_patch(source).points(u, v)


@pytest.mark.parametrize("size", SIZES)
def test_copy(measure, size):
    source = np.random.default_rng(0).random((size, size, 3))
    target = np.zeros_like(source)
    measure("copy", size, lambda: np.copyto(target, source), rounds=30)


@pytest.mark.parametrize("size", [LITERAL, *SIZES, LARGEST])
def test_raw(measure, size):
    source = document(size)
    measure("raw", size, lambda: raw_points(source), rounds=30 if size <= 2001 else 8)


@pytest.mark.parametrize("size", [*SIZES, LARGEST])
def test_box(measure, size):
    """The box that T needs, in the program's way."""
    patch = build_patch(document(size))
    measure("box", size, lambda: patch.sampled_box(np.array([size - 1]), np.array([size - 1])))


@pytest.mark.parametrize("size", [*SIZES, LARGEST])
def test_box_of_all(measure, size):
    patch = build_patch(document(size))

    def box():
        basis = grid.PieceBasis(bernstein.basis(6, parameters(size)), (0, size))
        return grid.box(patch.coefficients, basis, basis)

    measure("box of all", size, box, rounds=5)


def test_points_on_the_screen(measure):
    measure("points", SCREEN, lambda: raw_points(document(SCREEN)))


@pytest.mark.parametrize("size", SIZES)
def test_configure(measure, size):
    source = document(size)
    measure("configure", size, lambda: configure(source), rounds=30)


@pytest.mark.parametrize("size", SIZES)
def test_splipy(measure, size):
    net = document(size).control_points.transpose(1, 0, 2).reshape(25, 3)
    surface = SplipySurface(BSplineBasis(5, KNOTS), BSplineBasis(5, KNOTS), net)
    u = parameters(size).copy()  # Splipy snaps parameters to knots in place
    measure("splipy", size, lambda: surface(u, u))


@pytest.mark.parametrize("size", SIZES)
def test_scipy(measure, size):
    spline = NdBSpline((np.array(KNOTS), np.array(KNOTS)), document(size).control_points, k=4)
    grid = np.stack(np.meshgrid(parameters(size), parameters(size), indexing="ij"), axis=-1).reshape(-1, 2)
    measure("scipy", size, lambda: spline(grid), rounds=3)


def test_algorithm_1(measure):
    source: Document = document(LITERAL)
    rows, columns = (knots.array[:, 0].tolist() for knots in (source.row_knots, source.column_knots))
    net, u = source.control_points.tolist(), parameters(LITERAL).tolist()
    literal = lambda: [[algorithm1.point(net, rows, columns, "published", a, b) for b in u] for a in u]  # noqa: E731
    measure("algorithm 1", LITERAL, literal, rounds=1)


def test_ratios(row):
    """Not a measurement: it turns the medians above into the table."""
    m = MEDIANS
    for size in SIZES:
        at = f"{size} x {size}"
        row("raw / copy", at, m["raw", size] / m["copy", size], at_most=2 if size == 1001 else None)
    for size in SIZES:
        at = f"{size} x {size}"
        row("Splipy / raw", at, m["splipy", size] / m["raw", size], at_least=2 if size == 1001 else None)
    for size in SIZES:
        at = f"{size} x {size}"
        row("SciPy NdBSpline / raw", at, m["scipy", size] / m["raw", size], at_least=50 if size == 1001 else None)
    at = f"{LITERAL} x {LITERAL}"
    row("Algorithm 1 / raw", at, m["algorithm 1", LITERAL] / m["raw", LITERAL], at_least=2000)
    for size in (*SIZES, LARGEST):
        row("box of the samples / of all", f"{size} x {size}", m["box", size] / m["box of all", size], at_most=1)
    for size in (1001, LARGEST):
        row("box of the samples / points on the screen", f"{size} x {size}", m["box", size] / m["points", SCREEN])
    row("configure / copy", "1001 x 1001", m["configure", 1001] / m["copy", 1001], at_most=6)
    row("configure / Splipy", "101 x 101", m["configure", 101] / m["splipy", 101], at_most=3)
    per_point = [m["raw", size] / size**2 for size in (501, 1001, 2001, LARGEST)]
    row("slowest / fastest time per point", "501 to 4096", max(per_point) / min(per_point), at_most=1.5)


@pytest.mark.parametrize("size", [1001, LARGEST])
def test_peak_memory(row, size):
    source = document(size)
    configure(source)
    tracemalloc.start()
    surface = configure(source)
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    results = surface.raw.nbytes + surface.transformed.nbytes
    row("peak memory / results of configure", f"{size} x {size}", peak / results, at_most=1.25)
