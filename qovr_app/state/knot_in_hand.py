"""One knot in a hand, wherever the hand is: in the view, in a plot, over a menu."""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

from qovr_app.state.knot_intents import KnotsSet
from qovr_core.geometry.folding import STEPS
from qovr_core.geometry.knots import KNOT_NAMES, KnotPlace, Knots

_LEAST = 1 / STEPS
"""How near to 0 and 1 a hand brings a knot: a knot lies strictly between, and nearer ones swing out of sight."""

STEP = 0.05
"""Drags that snap keep a knot to multiples of this."""

_MAGNET = 4.0
"""Pixels between u and s within which the one in the hand goes to where the other is."""

_PARTNERS = {"s": "u", "u": "s"}
"""The two knots that may be one number."""


@dataclass(frozen=True)
class KnotInHand:
    """A knot with its curve.

    Parameters
    ----------
    place : which knot
    knots : of the curve in its window
    """

    place: KnotPlace
    knots: Knots

    @property
    def value(self) -> float:
        """The knot."""
        value: float = getattr(self.knots, self.place.name)
        return value

    @property
    def takes_s(self) -> bool:
        """Whether it is u, and s is the same number: then s goes with it."""
        return self.place.name == "u" and self.knots.is_quartic

    @property
    def on_curve(self) -> list[KnotInHand]:
        """The knots of the curve that a hand can take: u and s are one while they are one number."""
        names = [name for name in KNOT_NAMES if name != "s" or not self.knots.is_quartic]
        return [replace(self, place=replace(self.place, name=name)) for name in names]

    def set_to(self, value: float, gesture: int = 0, *, takes_s: bool, in_view: bool = False) -> KnotsSet:
        """Return what sets it."""
        place = self.place
        return KnotsSet(
            place.direction, place.curve, place.window, place.name, value, gesture, takes_s=takes_s, in_view=in_view
        )

    @property
    def default(self) -> float:
        """What it is reset to."""
        return default_knot(self.place.name)

    def reset(self, *, in_view: bool = False) -> KnotsSet:
        """Return what resets it, and s with u where they are one."""
        return self.set_to(self.default, takes_s=self.takes_s, in_view=in_view)

    def meant(self, value: float, pixel: float, *, snaps: bool, is_fine: bool) -> float:
        """Return the knot that a mouse means.

        Parameters
        ----------
        value : where the mouse is, as exact as floats are
        pixel : how far the knot goes while the mouse goes a pixel
        snaps : whether it keeps to the step
        is_fine : whether it goes slower than the mouse; then u and s do not catch each other
        """
        partner = _PARTNERS.get(self.place.name)
        home = None if partner is None or self.takes_s else float(getattr(self.knots, partner))
        if home is not None and not is_fine and abs(value - home) < _MAGNET * pixel:
            return home
        if snaps:
            value = float(f"{round(value / STEP) * STEP:.12g}")
        elif pixel > 0 and math.isfinite(pixel):
            value = round(value, -math.floor(math.log10(pixel)))
        return min(max(value, _LEAST), 1 - _LEAST)


def default_knot(name: str) -> float:
    """Return what a knot is on a new curve."""
    value: float = getattr(Knots(), name)
    return value
