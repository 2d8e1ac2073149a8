"""Documents whose surfaces are special: of a degree, of a size, with collapsed or closed edges."""

from dataclasses import replace

import numpy as np

from qovr_core import configure
from support.documents import random_document

COLLAPSED = ("v=0", "u=0", "v=0 and v=1")
COINCIDING = {
    "two ends of an edge": ((1, 1), (1, 3)),
    "two ends of two edges": ((1, 1), (3, 1)),  # and (1, 3) with (3, 3)
    "a diagonal": ((1, 1), (3, 3)),
    "the other diagonal": ((1, 3), (3, 1)),
    "three corners": ((1, 1), (1, 3), (3, 3)),
    "four corners": ((1, 1), (1, 3), (3, 1), (3, 3)),
}
"""Corners of the surface, as points of the net, that are one place while the edges between them are none."""
CLOSED = ("tube", "torus", "sphere", "balloon")


def of_degree(seed, degree_u, degree_v, size=1.0, **options):
    """Return a random document whose surface has these degrees; its net is not symmetric."""
    document = random_document(seed, low=0.2, high=0.8, **options)
    rows, columns = (
        tuple(replace(knots, s=knots.u) if degree == 4 else knots for knots in curves.in_window(0))
        for curves, degree in ((document.row_knots, degree_u), (document.column_knots, degree_v))
    )
    return replace(document, control_points=size * document.control_points, row_knots=rows, column_knots=columns)


def special(name, seed=3, size=1.0, samples=(7, 5)):
    """Return an interpolating document whose edges K_1, K_3, C_1, C_3 collapse or coincide."""
    document = of_degree(seed, 6, 6, size, samples=samples)
    points, columns = document.control_points.copy(), list(document.column_knots.in_window(0))
    rows = list(document.row_knots.in_window(0))
    if name in ("v=0", "v=0 and v=1", "sphere", "balloon"):
        points[1] = points[1, 1]
    if name in ("u=0", "balloon"):
        points[:, 1] = points[1, 1]
    if name in ("tube", "torus", "sphere"):
        points[:, 3], columns[3] = points[:, 1], columns[1]
    if name == "torus":
        points[3], rows[3] = points[1], rows[1]
    if name in ("v=0 and v=1", "sphere"):
        points[3] = points[3, 1]
    if name == "balloon":
        points[3] = points[:, 3] = points[1, 1]
    return replace(document, control_points=points, row_knots=tuple(rows), column_knots=tuple(columns))


def coinciding(name, seed=3, size=1.0, samples=(7, 5)):
    """Return an interpolating document whose surface has these corners at one place."""
    document = of_degree(seed, 6, 6, size, samples=samples)
    points = document.control_points.copy()
    pairs = [COINCIDING[name]] if name != "two ends of two edges" else [((1, 1), (3, 1)), ((1, 3), (3, 3))]
    for kept, *moved in pairs:
        for corner in moved:
            points[corner] = points[kept]
    return replace(document, control_points=points)


def at_random(patch, count=1000, seed=0):
    """Return random parameters (count, 2), the patch's points there (count, 3), and the size of the surface."""
    parameters = np.random.default_rng(seed).random((count, 2))
    points = np.array([patch.points([u], [v])[0, 0] for u, v in parameters])
    return parameters, points, float(np.linalg.norm(np.ptp(points, axis=0)))


def configured(*arguments, **options):
    return configure(of_degree(*arguments, **options))
