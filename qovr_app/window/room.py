"""How the window is laid out, by the room there is: one pure function."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_app.state.display import LaboratoryPlace

ZONES_FROM, WIDE_FROM = 1400, 2560
"""Widths in logical pixels: from the first one all four zones stand beside the view; from the second, the laboratory
too."""

_COLUMN, _SLIM = 380, 320
"""Widths of the column with tabs: with room for six digits and a sign, where the view has 900 of 1280 pixels beside it;
and where the laboratory stands at the view's other side."""

_MOST_OF_NARROW = 0.4
"""What the view leaves to the column of a narrow window, at most."""

_ZONES, _ZONES_GROW = 740, 10
"""First width of the four zones where they begin, and in how many pixels more of the window they gain one."""

_BESIDE_BELOW = 880
"""Below the view, zones stand side by side from this width on: what their fields and buttons need."""

_BELOW = 660
"""First height of the zones below the view: what both zones of knots need, one above the other."""

_MOST_OF_TALL = 0.46
_RIGHT, _PART_RIGHT = 400, 0.21
_UNDER, _PART_UNDER = 330, 0.4
"""First size of the laboratory, at the right at least and under the view at most, and its part of the window."""


class Form(StrEnum):
    """The four ways in which the zones and the view share a window."""

    TABS = "tabs"
    ZONES = "zones"
    WIDE = "wide"
    PORTRAIT = "portrait"


class Dock(StrEnum):
    """Where the laboratory is in a window; ``COLUMN`` is in place of the zones."""

    COLUMN = "column"
    RIGHT = "right"
    BELOW = "below"
    FLOATING = "floating"


@dataclass(frozen=True)
class Room:
    """What a window has room for.

    Parameters
    ----------
    form : how zones and view share it
    has_tabs : whether the zones are seen one at a time
    zones : first width of the zones' side, first height where it lies below the view; logical pixels
    most_zones : more than this it never takes from the view
    dock : where the laboratory is
    has_drawer : whether it is open there in place of the zones
    laboratory : its first width, or its first height where it lies under the view
    """

    form: Form
    has_tabs: bool
    zones: int
    most_zones: int
    dock: Dock
    has_drawer: bool
    laboratory: int

    @property
    def is_below(self) -> bool:
        """Whether the zones are below the view, not beside it."""
        return self.form is Form.PORTRAIT

    @property
    def has_all_digits(self) -> bool:
        """Whether every field has room for a sign and six digits."""
        return self.form in (Form.ZONES, Form.WIDE)

    @property
    def opens_laboratory(self) -> bool:
        """Whether the laboratory has a place of its own, in which it is open from the start."""
        return self.form is Form.WIDE and self.dock is Dock.RIGHT


def room_of(width: int, height: int, place: LaboratoryPlace, *, is_open: bool) -> Room:
    """Return the layout of a window of this size in logical pixels, with the laboratory open or not."""
    form, dock = _form(width, height), _dock(width, height, place)
    has_drawer = is_open and dock is Dock.COLUMN
    laboratory = round(max(_RIGHT, _PART_RIGHT * width))
    if dock is Dock.RIGHT and is_open and form is Form.ZONES and width - laboratory < ZONES_FROM:
        form = Form.TABS
    if dock is Dock.BELOW:
        laboratory = round(min(_UNDER, _PART_UNDER * height))
    if form is Form.PORTRAIT:
        zones = round(min(_BELOW, _MOST_OF_TALL * height))
        return Room(form, width < _BESIDE_BELOW, zones, height, dock, has_drawer, laboratory)
    if form is Form.TABS:
        wanted = _SLIM if is_open and dock is Dock.RIGHT else _COLUMN
        most = int(_MOST_OF_NARROW * width) - 1
        return Room(form, True, min(wanted, most), most, dock, has_drawer, laboratory)
    zones = _ZONES + (width - ZONES_FROM) // _ZONES_GROW
    return Room(form, False, zones, width, dock, has_drawer, laboratory)


def _form(width: int, height: int) -> Form:
    if height > width:
        return Form.PORTRAIT
    if width < ZONES_FROM:
        return Form.TABS
    return Form.ZONES if width < WIDE_FROM else Form.WIDE


def _dock(width: int, height: int, place: LaboratoryPlace) -> Dock:
    """Return where the laboratory has room; where the user wants it, if it has it there."""
    if place is LaboratoryPlace.AUTO:
        by_form = {Form.ZONES: Dock.BELOW, Form.WIDE: Dock.RIGHT}
        return by_form.get(_form(width, height), Dock.COLUMN)
    if place is LaboratoryPlace.RIGHT and width < ZONES_FROM:
        return Dock.COLUMN
    return Dock(place.value)
