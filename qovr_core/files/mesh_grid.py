"""The grid of a mesh: evenly spaced samples of every window of a net, the joints from both sides."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import product

import numpy as np
import numpy.typing as npt

from qovr_core.arrays import Array, Indices, read_only
from qovr_core.geometry import locate
from qovr_core.geometry.locate import Located
from qovr_core.geometry.patch import Patch

Numbers = npt.NDArray[np.int32]
"""Vertices and triangles by number: half as wide as indices elsewhere, since there are millions."""


@dataclass(frozen=True, eq=False)
class Axis:
    """The samples of a grid along one direction.

    Parameters
    ----------
    intervals : (windows,) between samples of each window, each 1 or more
    """

    intervals: Indices

    @cached_property
    def located(self) -> Located:
        """Where the samples are, those of joints from both sides."""
        return locate.even(self.intervals, from_both_sides=True)

    @cached_property
    def starts(self) -> Indices:
        """The first sample of each window, (windows,)."""
        starts: Indices = self.ends - self.intervals
        return starts

    @cached_property
    def ends(self) -> Indices:
        """The last sample of each window, (windows,)."""
        ends: Indices = np.cumsum(self.intervals + 1) - 1
        return ends

    @property
    def shared(self) -> Indices:
        """For each sample its number where joints count once."""
        return np.arange(len(self)) - self.located.window

    @property
    def halved(self) -> Axis:
        """The axis with every interval halved."""
        return Axis(2 * self.intervals)

    def window(self, number: int) -> Axis:
        """Return the axis of one window alone."""
        return Axis(self.intervals[number : number + 1])

    def samples(self, number: int) -> slice:
        """Return the samples of one window."""
        return slice(int(self.starts[number]), int(self.ends[number]) + 1)

    def __len__(self) -> int:
        return int(self.ends[-1]) + 1


@dataclass(frozen=True, eq=False)
class MeshGrid:
    """The vertices of a mesh before any of them are one.

    Parameters
    ----------
    u, v : its samples along u and v
    is_joined : whether neighbouring windows share the points of their joint
    """

    u: Axis
    v: Axis
    is_joined: bool

    @classmethod
    def of(cls, intervals: tuple[Indices, Indices], is_joined: bool) -> MeshGrid:
        """Return the grid with so many intervals of every window along u, (n,), and along v, (m,)."""
        u, v = intervals
        return cls(Axis(u), Axis(v), is_joined)

    @property
    def shape(self) -> tuple[int, int]:
        """How many samples there are along u and along v."""
        return len(self.u), len(self.v)

    @cached_property
    def numbers(self) -> Numbers:
        """The vertices in their grid, counted with v running fastest."""
        return np.arange(len(self.u) * len(self.v), dtype=np.int32).reshape(self.shape)

    def spread(self, samples: Array) -> Array:
        """Return the points (n, m, 3) of samples in which joints stand once."""
        if len(self.u.intervals) == len(self.v.intervals) == 1:
            return samples
        return read_only(samples[self.u.shared[:, None], self.v.shared])

    def points(self, patch: Patch) -> Array:
        """Return the points of a surface, (n, m, 3): where windows meet, one on both sides of a joint."""
        if self.is_joined:
            return self.spread(patch.samples(self.u.intervals, self.v.intervals))
        return patch.points(self.u.located, self.v.located)

    def column(self, patch: Patch, window: int) -> Patch:
        """Return the windows of a surface that are the same along u, by their own parameters."""
        ones = np.ones(len(self.v.intervals))
        return Patch(patch.coefficients[:, window : window + 1], patch.degree, (ones[:1], ones))

    def triangles(self, index: Numbers) -> Numbers:
        """Return two triangles a cell as entries of ``index``, (f, 3), window by window; between them is none."""
        faces = np.empty((int(self.u.intervals.sum() * self.v.intervals.sum()), 2, 3), dtype=np.int32)
        done = 0
        for b, a in product(range(len(self.u.intervals)), range(len(self.v.intervals))):
            own = index[self.u.samples(b), self.v.samples(a)]
            one, two, three, four = own[:-1, :-1], own[1:, :-1], own[1:, 1:], own[:-1, 1:]
            of_window = faces[done : done + one.size].reshape(*one.shape, 2, 3)
            done += one.size
            for triangle, corners in enumerate(((one, two, three), (one, three, four))):
                for k, corner in enumerate(corners):
                    of_window[:, :, triangle, k] = corner
        return faces.reshape(-1, 3)
