"""The box of the samples of a net's windows: a window is only looked into where it can hold more than is known."""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array, Flags, Indices
from qovr_core.geometry import bernstein
from qovr_core.geometry import sampled_box as of_one_window

_LARGEST_BATCH = 33 * 33
"""Samples of a window up to which those of many are computed together."""

_TOGETHER = 128
"""Windows looked into at a time, the most promising first: what they hold may rule the others out."""


@np.errstate(under="ignore")  # what underflows is nothing
def sampled_box(coefficients: Array, intervals_u: Indices, intervals_v: Indices) -> Array:
    """Return the box of the evenly spaced samples of all windows, both ends included.

    Every bound is the coordinate of a sample, within 8 eps of the axis's largest coefficient of the largest (smallest).

    Parameters
    ----------
    coefficients : (m, n, a, b, d), finite
    intervals_u, intervals_v : (n,) and (m,) intervals between samples, each 1 or more

    Returns
    -------
    (d, 2) float64, columns min and max
    """
    m, n, a, b, d = coefficients.shape
    if m * n == 1:
        return of_one_window.sampled_box(coefficients[0, 0], int(intervals_u[0]) + 1, int(intervals_v[0]) + 1)
    windows = coefficients.reshape(m * n, a, b, d)
    counts = np.stack(np.meshgrid(intervals_v, intervals_u, indexing="ij"), axis=-1).reshape(-1, 2)[:, ::-1]
    low, high = windows.min(axis=(1, 2)), windows.max(axis=(1, 2))
    slack = of_one_window.SLACK * np.maximum(np.abs(low), np.abs(high)).max(axis=0)
    corners = windows[:, :: a - 1, :: b - 1]
    box = np.stack([corners.min(axis=(0, 1, 2)), corners.max(axis=(0, 1, 2))], axis=1)
    waiting = np.arange(m * n)
    while True:
        promise = np.maximum(box[:, 0] - slack - low[waiting], high[waiting] - box[:, 1] - slack)
        waiting, promise = waiting[(promise > 0).any(axis=1)], promise[(promise > 0).any(axis=1)]
        if not waiting.size:
            return box
        order = np.argsort(-(promise / np.maximum(slack, np.finfo(np.float64).tiny)).max(axis=1), kind="stable")
        some, waiting = waiting[order[:_TOGETHER]], waiting[order[_TOGETHER:]]
        for kind in np.unique(counts[some], axis=0):
            found = _box_of_alike(windows[some[_are(counts[some], kind)]], *kind.tolist())
            box = np.stack([np.minimum(box[:, 0], found[:, 0]), np.maximum(box[:, 1], found[:, 1])], axis=1)


def _are(counts: Indices, kind: Indices) -> Flags:
    return np.asarray((counts == kind).all(axis=1))


def _box_of_alike(windows: Array, along_u: int, along_v: int) -> Array:
    """Return the box of windows (k, a, b, d) with as many intervals each."""
    if (along_u + 1) * (along_v + 1) > _LARGEST_BATCH:
        boxes = np.stack([of_one_window.sampled_box(window, along_u + 1, along_v + 1) for window in windows])
        return np.stack([boxes[..., 0].min(axis=0), boxes[..., 1].max(axis=0)], axis=1)
    k, a, b, d = windows.shape
    basis_u, basis_v = (
        bernstein.basis(size - 1, np.linspace(0.0, 1.0, count + 1)) for size, count in ((a, along_u), (b, along_v))
    )
    samples = np.einsum("vb,kubd->kuvd", basis_v, (basis_u @ windows.reshape(k, a, b * d)).reshape(k, -1, b, d))
    return np.stack([samples.min(axis=(0, 1, 2)), samples.max(axis=(0, 1, 2))], axis=1)
