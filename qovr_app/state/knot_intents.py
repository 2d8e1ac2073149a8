"""What the user wants of single knots, as values."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.intents import Intent
from qovr_core.geometry.knots import Direction


@dataclass(frozen=True)
class KnotsSet(Intent):
    """A knot is another number, and with it those that are linked.

    Parameters
    ----------
    curve : its number in its direction; None for all curves of the direction, whatever is linked
    window : the window along the curve
    name : r, s, u or t
    gesture : 0 for none
    takes_s : whether s goes with u on every curve on which the two were one number when the gesture began
    in_view : whether the document is set even where edits wait, as by every gesture in the view
    """

    direction: Direction
    curve: int | None
    window: int
    name: str
    value: float
    gesture: int = 0
    takes_s: bool = False
    in_view: bool = False


@dataclass(frozen=True)
class LinkSwitched(Intent):
    """What shares its knots, by its field of ``Links``, shares them from now on, or does no longer."""

    link: str
    is_on: bool
