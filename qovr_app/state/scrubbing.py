"""What a number becomes that is dragged sideways: rounded to what a pixel means, and never one that may not be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from decimal import Decimal

from qovr_app.state.gestures import FINE

_HALVINGS = 24
"""Enough to find the last pixel, and a part of it, on which a number may still be."""


@dataclass(frozen=True)
class Scrub:
    """A number in the hand.

    Parameters
    ----------
    start : the number where the way began
    pixel : by how much a pixel changes it
    step : of what it is a multiple while it snaps
    may_be : says which numbers may be
    begun_at : the pixel where the way began
    is_fine : whether a pixel means a tenth

    Examples
    --------
    >>> scrub = Scrub(0.7123, 0.005, 0.05, lambda value: value < 1)
    >>> scrub.value(10), scrub.value(12, snaps=True), scrub.value(1000)
    (0.76, 0.75, 0.995)
    """

    start: float
    pixel: float
    step: float
    may_be: Callable[[float], bool]
    begun_at: float = 0.0
    is_fine: bool = False

    def value(self, at: float, *, snaps: bool = False) -> float:
        """Return the number for a pixel; beyond the last one that may be, that one."""
        wanted = self._rounded(at - self.begun_at, snaps)
        if self.may_be(wanted):
            return wanted
        good, bad = 0.0, at - self.begun_at
        for _ in range(_HALVINGS):
            middle = (good + bad) / 2
            good, bad = (middle, bad) if self.may_be(self._rounded(middle, snaps)) else (good, middle)
        last = self._rounded(good, snaps)
        return last if good and self.may_be(last) else self.start

    def gone_on(self, at: float, value: float, *, is_fine: bool) -> Scrub:
        """Return the same number in the hand from here on, with the other fineness."""
        return replace(self, start=value, begun_at=at, is_fine=is_fine)

    def _rounded(self, pixels: float, snaps: bool) -> float:
        if not pixels and not snaps:
            return self.start
        pixel = self.pixel * FINE if self.is_fine else self.pixel
        unit = self.step if snaps else pixel
        count = round((self.start + pixels * pixel) / unit)
        return float(count * Decimal(f"{unit:.12g}")) + 0.0  # never minus zero
