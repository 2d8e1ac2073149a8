"""What the user wants to look at, as values: selection, display, reference, comparison, panels, messages."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_app.state.intents import Intent
from qovr_core.document import NetIndex, Window
from qovr_core.edits import Place


class Picking(StrEnum):
    """What picked points do to the selection."""

    REPLACE = "replace"
    ADD = "add"
    TOGGLE = "toggle"


@dataclass(frozen=True)
class Selected(Intent):
    """These control points are picked, ``last`` the latest of them; none at all where ``last`` is None."""

    last: NetIndex | None
    others: tuple[NetIndex, ...] = ()
    picking: Picking = Picking.REPLACE


@dataclass(frozen=True)
class PointsPutAway(Intent):
    """These control points, and no others, are not shown until they are selected."""

    indices: tuple[NetIndex, ...]


@dataclass(frozen=True)
class FieldFocused(Intent):
    """The field at a place has the keyboard now."""

    place: Place


@dataclass(frozen=True)
class WindowFocused(Intent):
    """A window (a, b) of the net is the one that the zones and the laboratory show."""

    window: Window


@dataclass(frozen=True)
class DisplayChosen(Intent):
    """One of the display settings, by its field of ``DisplaySettings``."""

    setting: str
    value: object


@dataclass(frozen=True)
class PaperLookChosen(Intent):
    """The surface looks as in the paper's figures."""


@dataclass(frozen=True)
class ToolChosen(Intent):
    """One of the tools' settings, by its field of ``ToolSettings``."""

    setting: str
    value: object


@dataclass(frozen=True)
class RangeFixed(Intent):
    """The colours end at two values."""

    low: float
    high: float


@dataclass(frozen=True)
class ReferencePinned(Intent):
    """The configured surface is the reference from now on."""


@dataclass(frozen=True)
class ReferenceUnpinned(Intent):
    """There is no reference any more."""


@dataclass(frozen=True)
class ComparisonChosen(Intent):
    """The surface compared with, its placement in the view (empty for none), and the weight of the measured point."""

    surface: str
    placement: str
    weight: float


@dataclass(frozen=True)
class DistanceMapSwitched(Intent):
    """The surfaces are coloured by their distance from each other, or as they were before."""

    is_on: bool


@dataclass(frozen=True)
class PanelShown(Intent):
    """A panel of the laboratory, by its name; empty closes the laboratory."""

    name: str


@dataclass(frozen=True)
class ZonesShown(Intent):
    """The zones beside the view are shown, or not."""

    are_shown: bool


@dataclass(frozen=True)
class MessageShown(Intent):
    """One sentence for the message line."""

    text: str
    is_refusal: bool = False


@dataclass(frozen=True)
class MessageOutdated(Intent):
    """The message has been read, or, where only refusals are meant, no longer holds."""

    only_refusals: bool = False
