"""What the user wants of the net's structure, as values; each one is a step that can be undone.

Joints and windows are counted along the curves of a direction: joint k lies between the windows k and k + 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_app.state.intents import Intent, Request
from qovr_core.document import Window
from qovr_core.geometry.knots import Direction
from qovr_core.geometry.nodes import Spacing


@dataclass(frozen=True)
class WindowInserted(Intent):
    """A window is split in two along the curves of a direction."""

    direction: Direction
    window: int


@dataclass(frozen=True)
class WindowRemoved(Intent):
    """The two windows at a joint become one."""

    direction: Direction
    joint: int


@dataclass(frozen=True)
class WindowAppended(Intent):
    """The net goes on by a window along the curves of a direction, after its last one or before its first."""

    direction: Direction
    at_start: bool = False


@dataclass(frozen=True)
class WindowExtracted(Intent):
    """One window (a, b) becomes the whole net."""

    window: Window


@dataclass(frozen=True)
class JointSmoothed(Intent):
    """A joint becomes smooth; with a ``gesture``, 0 for none, in the net with which it began."""

    direction: Direction
    joint: int
    gesture: int = 0


@dataclass(frozen=True)
class JointSharpened(Intent):
    """Every curve has its own knots at a joint from now on."""

    direction: Direction
    joint: int


@dataclass(frozen=True)
class JointCreased(Intent):
    """A joint becomes a crease, from 0 to 0.45; with a ``gesture``, 0 for none, in the net with which it began."""

    direction: Direction
    joint: int
    strength: float
    gesture: int = 0


@dataclass(frozen=True)
class KnotsSpaced(Intent):
    """All curves of a direction share the knots that the distances of their points say."""

    direction: Direction
    spacing: Spacing


@dataclass(frozen=True)
class NetReversed(Intent):
    """The curves of a direction run the other way."""

    direction: Direction


@dataclass(frozen=True)
class NetTransposed(Intent):
    """Rows become columns."""


@dataclass(frozen=True)
class NetMirrored(Intent):
    """The net becomes its mirror image across axis 0, 1 or 2."""

    axis: int


@dataclass(frozen=True)
class NetResampled(Intent):
    """Another net, of m x n windows, runs through the surface.

    Parameters
    ----------
    windows : (m, n)
    is_even : whether it meets the surface at even steps of the parameters, or at the net's nodes, spread over these
    gesture : 0 for none; else of the net with which it began
    """

    windows: Window
    is_even: bool = True
    gesture: int = 0


class Asked(StrEnum):
    """What of the net's structure is asked for in a dialog, which shows it in the view meanwhile."""

    SMOOTH = "smooth"
    CREASE = "crease"


@dataclass(frozen=True)
class JointAsked(Request):
    """Show what becomes of a joint, how far the surface moves, and ask whether it is to be."""

    direction: Direction
    joint: int
    what: Asked


@dataclass(frozen=True)
class ResamplingAsked(Request):
    """Ask of how many windows the net is to be that runs through the surface."""
