"""Measures of one surface, or of two: jumps at joints, bending energy, the largest distance."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from qovr_core.arrays import Array
from qovr_core.geometry.closest import ClosestSearch
from qovr_core.geometry.differential import ParametricSurface

_DISTANCE_SAMPLES, _FINER_SAMPLES = 33, 9
"""Samples each way whose distance from another surface is taken, and between the neighbours of the farthest."""

_JOINT_SAMPLES = 101

_FIRST_NODES, _MOST_NODES = 24, 384
"""Gauss-Legendre nodes each way and piece: doubled until the energy settles, or given up."""

_ENERGY_SETTLED = 1e-6
"""Part of itself by which the energy may still change under doubled nodes."""

_NO_ENERGY = 1e-12
"""Less than this is the rounding of a plane; a whole sphere of any size has 8 pi."""


@dataclass(frozen=True)
class Joints:
    """What jumps where two polynomials meet, the largest value along all interior joints.

    Parameters
    ----------
    tangent : angle in degrees between the tangents of the parameter lines that cross the joint
    curvature : length of the jump of their curvature vector, in 1 / length
    """

    tangent: float
    curvature: float


def largest_distance(surface: ParametricSurface, other: ClosestSearch) -> float:
    """Return the largest distance of a surface from another, which is searched.

    It is that of 33 x 33 of its points, border and corners included, and of a finer grid around the farthest.
    """
    u = np.linspace(0.0, 1.0, _DISTANCE_SAMPLES)
    distance = _distances(surface, other, u, u)
    farthest = np.unravel_index(distance.argmax(), distance.shape)
    finer = (
        np.linspace(u[max(k - 1, 0)], u[min(k + 1, _DISTANCE_SAMPLES - 1)], _FINER_SAMPLES) for k in map(int, farthest)
    )
    return float(_distances(surface, other, *finer).max())


def _distances(surface: ParametricSurface, other: ClosestSearch, u: Array, v: Array) -> Array:
    """Return the distance of a surface's points on a grid from another surface, (n, m)."""
    distance = other(surface.points(u, v).reshape(-1, 3)).distance
    return distance.reshape(len(u), len(v))


def bending_energy(surface: ParametricSurface) -> float:
    """Return the integral of k_1^2 + k_2^2 over the area, by Gauss-Legendre quadrature on every polynomial piece.

    Returns
    -------
    a number without a unit, settled to 1e-6 under doubled nodes; NaN where it does not settle, as at a fold, where
    the integral is infinite, or where the surface has no area
    """
    nodes, before = _FIRST_NODES, np.nan
    while nodes <= _MOST_NODES:
        energy = _energy(surface, nodes)
        if abs(energy - before) <= _ENERGY_SETTLED * energy + _NO_ENERGY:
            return energy
        nodes, before = 2 * nodes, energy
    return np.nan


def _energy(surface: ParametricSurface, nodes: int) -> float:
    (u, weights_u), (v, weights_v) = (_piecewise_nodes(joints, nodes) for joints in surface.breaks)
    curvature = surface.curvature(u, v)
    area = np.linalg.norm(np.cross(surface.derivative(u, v, 1, 0), surface.derivative(u, v, 0, 1)), axis=2)
    return float(weights_u @ ((4 * curvature.mean**2 - 2 * curvature.gaussian) * area) @ weights_v)


def _piecewise_nodes(breaks: Array, nodes: int) -> tuple[Array, Array]:
    """Return Gauss-Legendre nodes and weights over [0, 1], as many on every piece between the breaks."""
    x, weights = np.polynomial.legendre.leggauss(nodes)
    ends = [0.0, *breaks, 1.0]
    pieces = [((b - a) * (x + 1) / 2 + a, (b - a) * weights / 2) for a, b in pairwise(ends)]
    parameters, scaled = (np.concatenate(parts) for parts in zip(*pieces, strict=True))
    return parameters, scaled


def joints(surface: ParametricSurface) -> Joints | None:
    """Return what jumps across the joints of a surface's polynomials in u and in v; None where there are none."""
    along = np.linspace(0.0, 1.0, _JOINT_SAMPLES)
    lines = [_line_across(surface, at, along, axis) for axis in (0, 1) for at in surface.breaks[axis]]
    if not lines:
        return None
    angle, jump = np.max(lines, axis=0)
    return Joints(float(angle), float(jump))


def _line_across(surface: ParametricSurface, at: float, along: Array, axis: int) -> tuple[float, float]:
    """Return the largest angle and jump of curvature of the parameter lines that cross one joint."""
    sides = np.array([np.nextafter(at, 0.0), at])  # a joint belongs to the polynomial on its right

    def across(order: int) -> Array:
        if axis == 0:
            return surface.derivative(sides, along, order, 0)
        return surface.derivative(along, sides, 0, order).swapaxes(0, 1)

    first, second = across(1), across(2)
    speed = np.linalg.norm(first, axis=-1, keepdims=True)
    tangent = first / np.where(speed > 0, speed, 1.0)
    bend = second - np.einsum("sni,sni->sn", second, tangent)[..., None] * tangent
    curvature = bend / np.where(speed > 0, speed, 1.0) ** 2
    sine = np.linalg.norm(np.cross(*tangent), axis=-1)
    cosine = np.einsum("ni,ni->n", *tangent)
    angle = np.degrees(np.arctan2(sine, cosine)).max()
    return float(angle), float(np.linalg.norm(curvature[1] - curvature[0], axis=-1).max())
