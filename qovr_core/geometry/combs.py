r"""Curvature combs, and the number that says how fair a curve is: how much its comb changes.

The tooth of a comb at u stands on C(u) and is the curvature there, against the side to which the curve bends:

$$\kappa N = \frac{C'' (C' \cdot C') - C' (C' \cdot C'')}{(C' \cdot C')^2}$$

The **sum of comb changes** of a curve is the sum of |k(u_n+1) - k(u_n)| over ever more teeth, which is the total
variation of its curvature k over [0, 1]; of a curve in pieces, the jumps of k between them included. It is counted in
1 / length; 0 belongs to lines and circles, and of two curves through the same points the one with less of it is the
fairer.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Flags, Indices, read_only
from qovr_core.geometry import bernstein
from qovr_core.geometry.locate import located
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.rounding import ROUNDING, own_unit
from qovr_core.geometry.weights import CURVE_DEGREE

ISOLINES = 9
"""Isolines each way in the sum of a surface, evenly spaced, its edges among them."""

_LOOKED_AT = read_only(np.linspace(0.0, 1.0, 513))
"""Between two of these the curvature is taken to have one extremum at most."""

_HALVINGS = 40
"""An extremum is found to 2^-40 of a step: beyond that nothing is seen in the curvature, which is level there."""


@dataclass(frozen=True, eq=False)
class Comb:
    """Teeth on a curve.

    Parameters
    ----------
    feet : (n, 3) points of the curve
    curvature : (n, 3) curvature vectors, in 1 / length, towards the centre of the osculating circle; not finite
        where the curve has no tangent
    """

    feet: Array
    curvature: Array


def curvature_vectors(first: Array, second: Array) -> Array:
    """Return the curvature vectors (..., 3) of curves with these first and second derivatives (..., 3)."""
    with np.errstate(all="ignore"):
        squared = (first * first).sum(axis=-1, keepdims=True)
        along = (first * second).sum(axis=-1, keepdims=True)
        return np.asarray(second / squared - first * (along / squared / squared))


def comb(curve: npt.ArrayLike, u: npt.ArrayLike) -> Comb:
    """Return the comb of a curve, Bernstein coefficients (d + 1, 3), with teeth at parameters (n,)."""
    c, d, e = _derivatives(np.asarray(curve, dtype=np.float64))[:3]
    feet, first, second = (bernstein.basis(len(each) - 1, u) @ each for each in (c, d, e))
    return Comb(read_only(feet), read_only(curvature_vectors(first, second)))


def comb_changes(curves: npt.ArrayLike) -> Array:
    """Return the sum of comb changes of curves.

    Parameters
    ----------
    curves : (k, d + 1, 3) Bernstein coefficients, d at least 3; or those of the pieces of each, (k, n, d + 1, 3)

    Returns
    -------
    (k,) float64, in 1 / length; inf where a curve stops, as in a cusp, or is a single point
    """
    given = np.asarray(curves, dtype=np.float64)
    return families_changes(given[:, None] if given.ndim == 3 else given)[0]


@np.errstate(under="ignore")  # what underflows is nothing
def families_changes(*families: Array) -> list[Array]:
    """Return the ``comb_changes`` of families of curves in pieces, (k, n, d + 1, 3); all in one pass."""
    pieces = [family.reshape(-1, *family.shape[2:]) for family in families]
    changes, ends = _changes_and_ends(np.concatenate(pieces))
    parts = np.cumsum([len(each) for each in pieces])[:-1]
    result = []
    for family, own, own_ends in zip(families, np.split(changes, parts), np.split(ends, parts), strict=True):
        with np.errstate(invalid="ignore"):
            jumps = np.abs(np.diff(own_ends.reshape(len(family), -1)[:, 1:-1])[:, ::2])
            total = own.reshape(family.shape[:2]).sum(axis=1) + jumps.sum(axis=1)
        result.append(read_only(np.where(np.isfinite(total), total, np.inf)))
    return result


def _changes_and_ends(given: Array) -> tuple[Array, Array]:
    """Return the sums of comb changes of curves (k, d + 1, 3), and their curvature at both ends, (k, 2)."""
    unit = own_unit(np.abs(given - given[:, :1]).max(axis=(1, 2)))
    derivatives = _derivatives(given / unit[:, None, None])
    bases = [bernstein.basis(each.shape[-2] - 1, _LOOKED_AT) for each in derivatives]
    rows = [basis @ each for basis, each in zip(bases, derivatives, strict=True)]
    turning = _turning(*rows[1:])
    curve, step = np.nonzero((turning[:, 1:] > 0) != (turning[:, :-1] > 0))
    places = _extrema(derivatives, curve, step, rising=turning[curve, step] > 0)
    size, speed = (np.abs(each).max(axis=(1, 2)) for each in derivatives[:2])
    straight, still = ROUNDING * speed * size, ROUNDING * size
    at_steps = _curvature(rows[1], rows[2], straight[:, None], still[:, None])
    first, second = _at([each[curve] for each in derivatives[1:3]], places)
    at_extrema = _curvature(first, second, straight[curve], still[curve])
    with np.errstate(invalid="ignore", over="ignore"):
        changes = [
            np.abs(np.diff(np.insert(along, step[curve == k] + 1, at_extrema[curve == k]))).sum()
            for k, along in enumerate(at_steps)
        ]
        return np.asarray(changes) / unit, at_steps[:, [0, -1]] / unit[:, None]


def isolines(patch: Patch, count: int = ISOLINES) -> tuple[Array, Array]:
    """Return isolines of a patch, evenly spaced over its whole domain, as Bernstein coefficients of their pieces.

    Returns
    -------
    (count, n, 7, 3) along u and (count, m, 7, 3) along v, for m x n windows
    """
    at_u, at_v = (
        located(np.linspace(*ends, count), breakpoints)
        for ends, breakpoints in zip(patch.domain, patch.breakpoints, strict=True)
    )
    basis_u, basis_v = (bernstein.basis(CURVE_DEGREE, at.local) for at in (at_u, at_v))
    return (
        read_only(np.einsum("kb,knabd->knad", basis_v, patch.coefficients[at_v.window])),
        read_only(np.einsum("ka,mkabd->kmbd", basis_u, patch.coefficients[:, at_u.window])),
    )


def _derivatives(curves: Array) -> list[Array]:
    """Return curves and their first three derivatives as coefficients (..., n, 3)."""
    found = [curves]
    for _ in range(3):
        found.append(bernstein.derivative(found[-1], -2))
    return found


def _turning(first: Array, second: Array, third: Array) -> Array:
    """Return what has the sign of the derivative of the squared curvature."""
    x, dx = _cross(first, second), _cross(first, third)
    return np.asarray(_dot(x, dx) * _dot(first, first) - 3 * _dot(x, x) * _dot(first, second))


def _extrema(derivatives: list[Array], curve: Indices, step: Indices, *, rising: Flags) -> Array:
    """Return where the curvature of curves (m,) is extreme within steps (m,), by halving; it rises first or falls."""
    low, width, own = _LOOKED_AT[step], _LOOKED_AT[1], [each[curve] for each in derivatives[1:]]
    for _ in range(_HALVINGS):
        width = width / 2
        goes_on = (_turning(*_at(own, low + width)) > 0) == rising
        low = np.where(goes_on, low + width, low)
    return np.asarray(low + width / 2)


def _at(derivatives: list[Array], places: Array) -> list[Array]:
    """Return derivatives of m curves at one place each, (m, 3)."""
    return [np.einsum("mk,mkc->mc", bernstein.basis(each.shape[1] - 1, places), each) for each in derivatives]


def _curvature(first: Array, second: Array, straight: Array, still: Array) -> Array:
    """Return curvatures: 0 where they are rounding, and inf where a curve stops."""
    bending, speed = (np.linalg.norm(each, axis=-1) for each in (_cross(first, second), first))
    with np.errstate(all="ignore"):
        return np.where(speed <= still, np.inf, np.where(bending <= straight, 0.0, bending / speed**3))


def _cross(a: Array, b: Array) -> Array:
    """Return a x b as ``np.cross`` does, without its looking for axes, which takes longer than a hundred products."""
    product = np.empty(a.shape)
    for k, (i, j) in enumerate(((1, 2), (2, 0), (0, 1))):
        np.subtract(a[..., i] * b[..., j], a[..., j] * b[..., i], out=product[..., k])
    return product


def _dot(a: Array, b: Array) -> Array:
    return np.asarray((a * b).sum(axis=-1))
