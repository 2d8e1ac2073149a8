"""The four edges of a patch, and where they stand in an array of its samples or coefficients."""

from __future__ import annotations

from enum import StrEnum

Position = tuple[int | slice, int | slice]


class Edge(StrEnum):
    """The four edges of a patch.

    Examples
    --------
    >>> import numpy as np
    >>> samples = np.arange(6).reshape(3, 2)  # indexed [iu, iv]
    >>> samples[Edge("u=1").position].tolist(), samples[Edge.V0.position].tolist()
    ([4, 5], [0, 2, 4])
    """

    U0 = "u=0"
    U1 = "u=1"
    V0 = "v=0"
    V1 = "v=1"

    @property
    def position(self) -> Position:
        """The edge in an array of samples or Bernstein coefficients indexed [iu, iv], in the order along the edge."""
        end = -1 if self in (Edge.U1, Edge.V1) else 0
        return (end, slice(None)) if self in (Edge.U0, Edge.U1) else (slice(None), end)

    @property
    def corners(self) -> tuple[tuple[int, int], tuple[int, int]]:
        """The indices [iu, iv] of the corners at which the edge begins and ends."""
        iu, iv = self.position
        if isinstance(iu, int):
            return (iu, 0), (iu, -1)
        assert isinstance(iv, int)
        return (0, iv), (-1, iv)
