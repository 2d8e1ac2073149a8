"""Random documents of several windows: smooth and sharp joints, open and closed."""

import numpy as np

from qovr_core import Document, Formulation
from qovr_core.joints import Joint, Joints

_R, _S, _U, _T = range(4)

EXACT = 1e-12

NETS = {
    "smooth": {"m": 5, "n": 6},
    "one sharp joint": {"m": 3, "n": 4, "sharp_u": {1}},
    "sharp both ways": {"m": 5, "n": 6, "sharp_u": {0, 3}, "sharp_v": {2}},
    "all sharp": {"m": 3, "n": 2, "sharp_u": {0}, "sharp_v": {0, 1}},
    "quartic along u": {"m": 2, "n": 3, "quartic_u": range(3)},
    "quartic in its first part": {"m": 2, "n": 4, "sharp_u": {1}, "quartic_u": (0, 1), "quartic_v": (0, 1)},
    "tube": {"m": 3, "n": 4, "closed": ("u",)},
    "tube with a sharp seam": {"m": 2, "n": 4, "sharp_u": {3}, "closed": ("u",)},
    "tube of parts": {"m": 3, "n": 5, "sharp_u": {1, 2}, "sharp_v": {0}, "closed": ("u",)},
    "torus": {"m": 4, "n": 4, "closed": ("u", "v")},
    "torus of parts": {"m": 4, "n": 5, "sharp_u": {2}, "sharp_v": {0, 1}, "closed": ("u", "v")},
    "small": {"m": 2, "n": 3, "sharp_v": {0}, "size": 1e-3},
    "large": {"m": 2, "n": 3, "sharp_v": {0}, "size": 1e5},
}
"""Arguments of ``random_net`` by what is special about the net."""


def random_knots(rng, curves, joints, closed, *, quartic=(), low=0.3, high=0.7):
    """Return knots (curves, windows, 4) that make smooth joints smooth; ``quartic`` are the windows of degree 4."""
    windows = len(joints) + (not closed)
    knots = rng.uniform(low, high, (curves, windows, 4))
    for b, joint in enumerate(joints):
        if joint is Joint.SMOOTH:
            after = (b + 1) % windows
            knots[:, b, _T] = knots[:, after, _R] = rng.uniform(low, high)
            for window in (b, after):
                knots[:, window, _U] = knots[0, window, _U]
    for window in quartic:
        knots[:, window, _S] = knots[:, window, _U]
    return knots


def random_net(
    seed,
    m,
    n,
    *,
    sharp_u=(),
    sharp_v=(),
    closed=(),
    quartic_u=(),
    quartic_v=(),
    formulation=Formulation.INTERPOLATING,
    size=1.0,
    samples=(41, 41),
):
    """Return a document of m x n windows, all joints smooth but those named; closed along u it runs round an axis."""
    rng = np.random.default_rng(seed)
    rows, columns = 2 * m + 3, 2 * n + 3
    y, x = np.mgrid[:rows, :columns].astype(float)
    if "u" in closed:
        turn = np.pi * x / n
        radius = 3 + (np.cos(np.pi * y / m) if "v" in closed else 0.2 * np.sin(y))
        height = np.sin(np.pi * y / m) if "v" in closed else y
        points = np.stack([radius * np.cos(turn), radius * np.sin(turn), height], axis=-1)
        spread = 0.5 / n
    else:
        points, spread = np.stack([x, y, 0 * x], axis=-1), 0.3
    points += rng.uniform(-spread, spread, points.shape)
    joints = Joints(
        *(
            tuple(Joint.SHARP if k in sharp else Joint.SMOOTH for k in range(count - (letter not in closed)))
            for sharp, count, letter in ((sharp_u, n, "u"), (sharp_v, m, "v"))
        )
    )
    row_knots = random_knots(rng, rows, joints.u, "u" in closed, quartic=quartic_u)
    column_knots = random_knots(rng, columns, joints.v, "v" in closed, quartic=quartic_v)
    if "u" in closed:
        points[:, -3:], column_knots[-3:] = points[:, :3], column_knots[:3]
    if "v" in closed:
        points[-3:], row_knots[-3:] = points[:3], row_knots[:3]
    return Document(size * points, row_knots, column_knots, formulation, samples, joints=joints, closed=closed)


def net_of(name, **changes):
    return random_net(7, **{**NETS[name], **changes})


def part_counts(document):
    """Return how many parts lie along u and along v."""
    m, n = document.windows
    cuts = (
        joints[: count - 1].count(Joint.SHARP)
        for joints, count in zip((document.joints.u, document.joints.v), (n, m), strict=True)
    )
    return tuple(count + 1 for count in cuts)


def check_exact(surfaces, patch, count=1000):
    """Check surfaces at random parameters of the net, and that together they cover it."""
    (u0, u1), (v0, v1) = patch.domain
    parameters = np.random.default_rng(0).random((count, 2)) * [u1 - u0, v1 - v0] + [u0, v0]
    points = patch.derivative_at(*parameters.T, 0, 0)
    size = float(np.linalg.norm(np.ptp(patch.coefficients.reshape(-1, 3), axis=0)))
    covered = np.zeros(count, dtype=int)
    for surface in surfaces:
        (first_u, last_u), (first_v, last_v) = surface.domain
        inside = ((parameters >= [first_u, first_v]) & (parameters <= [last_u, last_v])).all(axis=1)
        covered += inside
        assert np.abs(surface(parameters[inside]) - points[inside]).max() <= EXACT * size
    assert (covered == 1).all()
