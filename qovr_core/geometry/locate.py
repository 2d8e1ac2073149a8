"""Where parameters lie in a piecewise polynomial: in which window, and where in it."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.geometry import bernstein
from qovr_core.geometry.grid import PieceBasis


@dataclass(frozen=True, eq=False)
class Located:
    """Parameters of one direction by window.

    Parameters
    ----------
    window : (k,) the window that each lies in; a joint belongs to the one that begins there
    local : (k,) where in the window, 0 to 1
    lengths : (windows,) of all windows
    """

    window: Indices
    local: Array
    lengths: Array

    @property
    def to_middle(self) -> Array:
        """How far the middle of its window is from each, (k,), by the window's own parameter."""
        return 0.5 - self.local

    @property
    def by_own_parameter(self) -> Located:
        """The same with windows of length 1, so that derivatives are those by each window's own parameter."""
        return Located(self.window, self.local, np.ones(len(self.lengths)))

    @property
    def place(self) -> Array:
        """The window plus where in it, (k,)."""
        return read_only(self.window + self.local)

    def __getitem__(self, part: slice | Indices) -> Located:
        return Located(self.window[part], self.local[part], self.lengths)

    def basis(self, degree: int, order: int) -> Array:
        """Return the functions (k, degree + 1) with which a derivative's coefficients are summed, by the parameter."""
        values = bernstein.basis(degree, self.local)
        if order:
            values = values / self.lengths[self.window, None] ** order
        return values

    def by_window(self, degree: int, order: int) -> PieceBasis:
        """Return the same by window; it is computed once."""
        if (degree, order) not in self._by_window:
            self._by_window[degree, order] = self._sorted_by_window(degree, order)
        return self._by_window[degree, order]

    @cached_property
    def _by_window(self) -> dict[tuple[int, int], PieceBasis]:
        return {}

    def _sorted_by_window(self, degree: int, order: int) -> PieceBasis:
        values, ordered = self.basis(degree, order), None
        window = self.window
        if (np.diff(window) < 0).any():
            ordered = np.argsort(window, kind="stable")
            values, window = values[ordered], window[ordered]
        starts = np.searchsorted(window, np.arange(len(self.lengths) + 1))
        return PieceBasis(values, starts.tolist(), ordered)


Parameters = npt.ArrayLike | Located
"""Parameters of one direction, (k,); those of joints are told from which side where they are located."""


def located(parameters: npt.ArrayLike, breakpoints: Array) -> Located:
    """Return in which window parameters lie, and where; outside all windows the outer ones go on.

    Parameters
    ----------
    parameters : (k,)
    breakpoints : (windows + 1,), ascending

    Raises
    ------
    ValueError : the parameters are not one-dimensional
    """
    x = bernstein.checked_parameters(parameters)
    lengths = np.diff(breakpoints)
    window = np.clip(np.searchsorted(breakpoints, x, side="right") - 1, 0, len(lengths) - 1)
    return Located(window, (x - breakpoints[window]) / lengths[window], lengths)


def of_grid(u: Parameters, v: Parameters, breakpoints: tuple[Array, Array]) -> tuple[Located, Located]:
    """Return where the parameters of a grid lie, along u and along v; see ``located``."""
    at_u, at_v = (
        at if isinstance(at, Located) else located(at, ends) for at, ends in zip((u, v), breakpoints, strict=True)
    )
    return at_u, at_v


def spread(samples: int, windows: int) -> Indices:
    """Return how many of the intervals between samples fall to each window, (windows,): nearly equal, larger first.

    Examples
    --------
    >>> spread(12, 3).tolist()
    [4, 4, 3]
    """
    each, more = divmod(samples - 1, windows)
    intervals = np.full(windows, each, dtype=np.intp)
    intervals[:more] += 1
    return read_only(intervals)


def even(intervals: Indices, *, from_both_sides: bool = False) -> Located:
    """Return the evenly spaced parameters of each window, with so many intervals; the joints once, or from both sides.

    The windows count as of length 1, so that derivatives are those by each window's own parameter. What is asked again,
    as it is in every frame of a drag, is known.
    """
    return _even(tuple(intervals.tolist()), from_both_sides)


@lru_cache(maxsize=8)
def _even(intervals: tuple[int, ...], from_both_sides: bool) -> Located:
    made = {count: np.linspace(0.0, 1.0, count + 1) for count in set(intervals)}
    local = [made[count] for count in intervals]
    if not from_both_sides:
        local[:-1] = [places[:-1] for places in local[:-1]]
    window = np.repeat(np.arange(len(intervals)), [len(places) for places in local])
    return Located(*map(read_only, (window, np.concatenate(local), np.ones(len(intervals)))))
