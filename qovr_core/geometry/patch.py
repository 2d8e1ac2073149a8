"""The exact surface: a tensor-product polynomial in every window, and everything else asks it."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, partial
from typing import Any

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Floats, Indices, checked_out, handed_out, read_only
from qovr_core.geometry import bernstein, differential, extent, grid, locate, sampled_box, scattered
from qovr_core.geometry.differential import Curvature, Domain
from qovr_core.geometry.edges import Edge
from qovr_core.geometry.locate import Parameters

PATCH_DEGREE = 6
"""Degree each way in which every patch is held, whatever its true degree."""

_SHAPE = (PATCH_DEGREE + 1, PATCH_DEGREE + 1, 3)

_AXES = 2, 3
"""The axes of the coefficients along u and along v."""


@dataclass(frozen=True, eq=False)
class Patch:
    """A surface S(u, v) that is one polynomial of degree 6 each way in every window of a net, in Bernstein form.

    Its domain is a rectangle: along u the windows' lengths follow each other from 0, along v likewise. One window of
    length 1 is a polynomial over [0, 1] x [0, 1].

    Parameters
    ----------
    coefficients : (m, n, 7, 7, 3) float64, m windows along v and n along u, and inside each u along the first axis; or
        (7, 7, 3) for one window; kept read-only
    degree : true degree in u and in v, each 4 or 6
    lengths : of the windows along u, (n,), and along v, (m,); None where all are 1

    Raises
    ------
    ValueError : the coefficients or the lengths have another shape

    Examples
    --------
    >>> u, v = np.mgrid[0:1:7j, 0:1:7j]
    >>> plane = Patch(np.stack([u, v, 2 * u], axis=-1))
    >>> plane.points([0.5], [0.25])
    array([[[0.5 , 0.25, 1.  ]]])
    >>> plane.bounding_box()
    array([[0., 1.],
           [0., 1.],
           [0., 2.]])
    """

    coefficients: Array
    degree: tuple[int, int] = (PATCH_DEGREE, PATCH_DEGREE)
    lengths: tuple[Array, Array] | None = None

    def __post_init__(self) -> None:
        coefficients = np.asarray(self.coefficients, dtype=np.float64)
        if coefficients.flags.writeable:
            coefficients = coefficients.copy()
        if coefficients.shape == _SHAPE:
            coefficients = coefficients[None, None]
        if coefficients.ndim != 5 or coefficients.shape[2:] != _SHAPE:
            raise ValueError(f"patch coefficients have shape {coefficients.shape}; expected (m, n, 7, 7, 3)")
        object.__setattr__(self, "coefficients", read_only(coefficients))
        m, n = self.windows
        for lengths, count in zip(self.lengths or (), (n, m), strict=False):
            if lengths.shape != (count,):
                raise ValueError(f"lengths have shape {lengths.shape}; expected ({count},)")

    @property
    def windows(self) -> tuple[int, int]:
        """How many windows there are along v and along u, (m, n)."""
        m, n = self.coefficients.shape[:2]
        return m, n

    @cached_property
    def breakpoints(self) -> tuple[Array, Array]:
        """Where the windows begin and the last one ends, along u, (n + 1,), and along v, (m + 1,)."""
        m, n = self.windows
        lengths = self.lengths or (np.ones(n), np.ones(m))
        u, v = (read_only(np.concatenate([[0.0], np.cumsum(each)])) for each in lengths)
        return u, v

    @property
    def breaks(self) -> tuple[Array, Array]:
        """The joints inside the domain in u and in v; one polynomial has none."""
        u, v = self.breakpoints
        return u[1:-1], v[1:-1]

    @property
    def domain(self) -> Domain:
        """The first and the last parameter along u, and along v."""
        (u0, *_, u1), (v0, *_, v1) = (ends.tolist() for ends in self.breakpoints)
        return (u0, u1), (v0, v1)

    def window(self, a: int, b: int) -> Patch:
        """Return the patch of one window, the a-th along v and the b-th along u, over [0, 1] x [0, 1]."""
        return Patch(self.coefficients[a, b], self.degree)

    def points(self, u: Parameters, v: Parameters, out: Floats | None = None) -> npt.NDArray[Any]:
        """Return the points S(u, v) on a grid.

        Parameters
        ----------
        u : (n,) parameters along u in the domain; beyond it the outer polynomials go on
        v : (m,) parameters along v
        out : (n, m, 3) float64 or float32 in C order to write to; what is computed is float64 all the same

        Returns
        -------
        (n, m, 3) float64, read-only, indexed [iu, iv]; or ``out``

        Raises
        ------
        TypeError : ``out`` is no array of float64 or float32
        ValueError : u or v is not one-dimensional, or ``out`` has another shape or order, or is read-only
        """
        return self.derivative(u, v, 0, 0, out)

    def samples(self, intervals_u: Indices, intervals_v: Indices, out: Floats | None = None) -> npt.NDArray[Any]:
        """Return the points at evenly spaced parameters of every window, the joints once.

        Parameters
        ----------
        intervals_u, intervals_v : between samples, of every window along u, (n,), and along v, (m,)
        out : as for ``points``

        Returns
        -------
        (sum of intervals_u + 1, sum of intervals_v + 1, 3) float64, read-only, indexed [iu, iv]; on a joint those of
        the window that begins there; or ``out``
        """
        return self._on_grid(locate.even(intervals_u), locate.even(intervals_v), 0, 0, out)

    def sampled_box(
        self, intervals_u: Indices, intervals_v: Indices, bounds: Callable[[], Array] | None = None
    ) -> Array:
        """Return the box of ``samples``, few of which are computed; parameters as of ``sampled_box.sampled_box``.

        Returns
        -------
        (3, 2) float64, read-only, columns min and max
        """
        return read_only(sampled_box.sampled_box(self.coefficients, intervals_u, intervals_v, bounds))

    def derivative(
        self, u: Parameters, v: Parameters, order_u: int, order_v: int, out: Floats | None = None
    ) -> npt.NDArray[Any]:
        """Return a partial derivative of S on a grid; on a joint that of the window which begins there.

        Parameters
        ----------
        u, v : (n,) and (m,) parameters
        order_u, order_v : order of the derivative in u and in v, each 0 to 6
        out : as for ``points``

        Returns
        -------
        (n, m, 3) float64, read-only, indexed [iu, iv]; or ``out``

        Raises
        ------
        TypeError, ValueError : as ``points``, or an order is outside 0 to 6
        """
        return self._on_grid(*locate.of_grid(u, v, self.breakpoints), order_u, order_v, out)

    def derivative_at(
        self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int, out: Floats | None = None
    ) -> npt.NDArray[Any]:
        """Return a partial derivative of S at scattered parameters, as ``derivative`` does on a grid.

        Parameters
        ----------
        u, v : (k,) and (k,) parameters
        order_u, order_v : order of the derivative in u and in v, each 0 to 6
        out : (k, 3), else as for ``points``

        Returns
        -------
        (k, 3) float64, read-only; or ``out``

        Raises
        ------
        TypeError, ValueError : as ``derivative``
        """
        at_u, at_v = locate.of_grid(u, v, self.breakpoints)
        asked, pieces = scattered.asked_pieces(self.coefficients, (at_v.window, at_u.window))
        coefficients = bernstein.partial_derivative(asked, (order_u, order_v), _AXES)
        in_u, in_v = (at.basis(PATCH_DEGREE - order, order) for at, order in ((at_u, order_u), (at_v, order_v)))
        return handed_out(scattered.evaluate_pieces(coefficients, pieces, in_u, in_v, out), out)

    def normals(self, u: Parameters, v: Parameters, out: Floats | None = None) -> npt.NDArray[Any]:
        """Return the unit normals along S_u x S_v, (n, m, 3), limits taken in windows; see ``differential.normals``.

        ``out`` is as for ``points``.
        """
        at_u, at_v = (at.by_own_parameter for at in locate.of_grid(u, v, self.breakpoints))
        normals, singular = checked_out(out, (len(at_u.local), len(at_v.local), 3)), self._rounding_of_a_normal()
        for rows in grid.blocks(at_u.by_window(PATCH_DEGREE, 0), normals[:1].size):
            some = at_u[rows]
            tangents, inward = partial(self._on_grid, some, at_v), (some.to_middle, at_v.to_middle)
            normals[rows] = differential.unit_normals(tangents, inward, singular=singular)
        return handed_out(normals, out)

    def curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Curvature:
        """Return the curvatures on a grid, from the two fundamental forms; parameters as for ``points``."""
        return differential.surface_curvature(self, u, v, singular=self._rounding_of_a_normal())

    def edge(self, edge: Edge) -> Array:
        """Return an edge curve as Bernstein coefficients (windows, 7, 3) in the parameter that runs along it."""
        across_u = edge in (Edge.U0, Edge.U1)
        end = 0 if edge in (Edge.U0, Edge.V0) else -1
        windows = self.coefficients[:, end] if across_u else self.coefficients[end]
        iu, iv = edge.position
        curves: Array = windows[:, iu, iv]
        return curves

    def bounding_box(self) -> Array:
        """Return the exact box, (3, 2) float64 with columns min and max."""
        return read_only(extent.bounding_box(self.coefficients))

    def transformed(self, matrix: npt.ArrayLike) -> Patch:
        """Return the patch mapped by a (4, 4) affine matrix that acts on columns [x y z 1], eq. (62)."""
        m = np.asarray(matrix, dtype=np.float64)
        return self.mapped(lambda points: points @ m[:3, :3].T + m[:3, 3])

    def mapped(self, mapping: Callable[[Array], Array]) -> Patch:
        """Return the patch with its coefficients mapped by what is affine on arrays (..., 3)."""
        return Patch(mapping(self.coefficients), self.degree, self.lengths)

    def _on_grid(
        self, at_u: locate.Located, at_v: locate.Located, order_u: int, order_v: int, out: Floats | None = None
    ) -> npt.NDArray[Any]:
        """Return a partial derivative on a grid of located parameters."""
        coefficients = bernstein.partial_derivative(self.coefficients, (order_u, order_v), _AXES)
        in_u, in_v = (at.by_window(PATCH_DEGREE - order, order) for at, order in ((at_u, order_u), (at_v, order_v)))
        return handed_out(grid.evaluate_pieces(coefficients, in_u, in_v, out), out)

    def _rounding_of_a_normal(self) -> float:
        return differential.rounding_of_a_normal(bernstein.derivative(self.coefficients, axis) for axis in _AXES)
