"""The exact patch: one tensor-product polynomial that everything else asks."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, read_only
from qovr_core.geometry import bernstein, differential, extent, grid, sampled_box
from qovr_core.geometry.differential import Curvature
from qovr_core.geometry.edges import Edge

PATCH_DEGREE = 6
"""Degree each way in which every patch is held, whatever its true degree."""

_SINGULAR = 1e-12
"""|S_u x S_v| below this part of the largest possible one is rounding, and no direction."""

_NO_JOINTS = read_only(np.empty(0))


@dataclass(frozen=True, eq=False)
class Patch:
    """A polynomial patch S(u, v) over [0, 1] x [0, 1] in Bernstein form.

    Parameters
    ----------
    coefficients : (7, 7, 3) float64, u along the first axis; kept read-only
    degree : true degree in u and in v, each 4 or 6

    Raises
    ------
    ValueError : the coefficients have another shape

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

    def __post_init__(self) -> None:
        coefficients = np.array(self.coefficients, dtype=np.float64)
        if coefficients.shape != (PATCH_DEGREE + 1, PATCH_DEGREE + 1, 3):
            raise ValueError(f"patch coefficients have shape {coefficients.shape}; expected (7, 7, 3)")
        object.__setattr__(self, "coefficients", read_only(coefficients))

    @property
    def breaks(self) -> tuple[Array, Array]:
        """The joints inside (0, 1) in u and in v; one polynomial has none."""
        return _NO_JOINTS, _NO_JOINTS

    def points(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the points S(u, v) on a grid.

        Parameters
        ----------
        u : (n,) parameters along u; the patch's domain is [0, 1], beyond it the polynomial goes on
        v : (m,) parameters along v

        Returns
        -------
        (n, m, 3) float64, read-only, indexed [iu, iv]

        Raises
        ------
        ValueError : u or v is not one-dimensional
        """
        return self.derivative(u, v, 0, 0)

    def sampled_box(self, n: int, m: int) -> Array:
        """Return the box of n x m evenly spaced samples, few of which are computed; see ``sampled_box.sampled_box``.

        Parameters
        ----------
        n, m : samples along u and along v, each 2 or more

        Returns
        -------
        (3, 2) float64, read-only, columns min and max
        """
        return read_only(sampled_box.sampled_box(self.coefficients, n, m))

    def derivative(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative of S on a grid.

        Parameters
        ----------
        u, v : (n,) and (m,) parameters
        order_u, order_v : order of the derivative in u and in v, each 0 to 6

        Returns
        -------
        (n, m, 3) float64, read-only, indexed [iu, iv]

        Raises
        ------
        ValueError : u or v is not one-dimensional, or an order is outside 0 to 6
        """
        coefficients = self._differentiated(order_u, order_v)
        basis_u = bernstein.basis(PATCH_DEGREE - order_u, u)
        basis_v = bernstein.basis(PATCH_DEGREE - order_v, v)
        return read_only(grid.evaluate(coefficients, basis_u, basis_v))

    def derivative_at(self, u: npt.ArrayLike, v: npt.ArrayLike, order_u: int, order_v: int) -> Array:
        """Return a partial derivative of S at scattered parameters, as ``derivative`` does on a grid.

        Parameters
        ----------
        u, v : (k,) and (k,) parameters
        order_u, order_v : order of the derivative in u and in v, each 0 to 6

        Returns
        -------
        (k, 3) float64, read-only

        Raises
        ------
        ValueError : u or v is not one-dimensional, or an order is outside 0 to 6
        """
        coefficients = self._differentiated(order_u, order_v)
        basis_u = bernstein.basis(PATCH_DEGREE - order_u, u)
        basis_v = bernstein.basis(PATCH_DEGREE - order_v, v)
        return read_only(grid.evaluate_scattered(coefficients, basis_u, basis_v))

    def normals(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Array:
        """Return the unit normals along S_u x S_v on a grid, (n, m, 3); see ``differential.normals``."""
        return differential.normals(self, u, v, singular=self._rounding_of_a_normal())

    def curvature(self, u: npt.ArrayLike, v: npt.ArrayLike) -> Curvature:
        """Return the curvatures on a grid, from the two fundamental forms.

        Parameters
        ----------
        u, v : (n,) and (m,) parameters

        Raises
        ------
        ValueError : u or v is not one-dimensional
        """
        return differential.surface_curvature(self, u, v, singular=self._rounding_of_a_normal())

    def edge(self, edge: Edge) -> Array:
        """Return an edge curve as Bernstein coefficients (7, 3) in the parameter that runs along it."""
        curve: Array = self.coefficients[edge.position]
        return curve

    def bounding_box(self) -> Array:
        """Return the exact box over [0, 1] x [0, 1], (3, 2) float64 with columns min and max."""
        return read_only(extent.bounding_box(self.coefficients))

    def transformed(self, matrix: npt.ArrayLike) -> Patch:
        """Return the patch mapped by a (4, 4) affine matrix that acts on columns [x y z 1], eq. (62)."""
        m = np.asarray(matrix, dtype=np.float64)
        return Patch(self.coefficients @ m[:3, :3].T + m[:3, 3], self.degree)

    def _differentiated(self, order_u: int, order_v: int) -> Array:
        """Return the Bernstein coefficients of a partial derivative."""
        if not (0 <= order_u <= PATCH_DEGREE and 0 <= order_v <= PATCH_DEGREE):
            raise ValueError(f"derivative orders are {order_u} and {order_v}; expected 0 to {PATCH_DEGREE}")
        coefficients = self.coefficients
        for _ in range(order_u):
            coefficients = bernstein.derivative(coefficients, 0)
        for _ in range(order_v):
            coefficients = bernstein.derivative(coefficients, 1)
        return coefficients

    def _rounding_of_a_normal(self) -> float:
        """Return the length below which S_u x S_v is no more than rounding."""
        tangents = (np.abs(bernstein.derivative(self.coefficients, axis)).max() for axis in (0, 1))
        return float(_SINGULAR * np.prod(list(tangents)))
