"""What the user wants, as values: every intent makes the next state in ``next_state``, or is refused there.

Here are those of the document; ``knot_intents`` are those of single knots, ``field_intents`` those of several
fields at once, ``point_intents`` those of the selected control points, ``net_intents`` those of the net's windows and
joints, ``looking_intents`` those of what is looked at.

A ``Request`` is an intent that needs the world outside - a file, a dialog, the clipboard. The shell answers it, and the
answer comes back as an intent.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

from qovr_core import Document
from qovr_core.document import NetIndex
from qovr_core.edits import Place, Zone

Stamp = tuple[int, ...]
"""When a file was last written, in nanoseconds, its size, and its number in the file system: together they tell whether
it is another one."""


class Intent:
    """Base of everything that can be dispatched."""


class Request(Intent):
    """Base of the intents that the shell answers."""


# Numbers of the document


@dataclass(frozen=True)
class ValuesEdited(Intent):
    """Numbers are other ones, and with them those that are linked; ``gesture`` is 0 for none.

    One knot alone is a ``KnotsSet``.
    """

    values: Mapping[Place, float]
    gesture: int = 0


@dataclass(frozen=True)
class ValuesPasted(Intent):
    """Exactly these numbers are other ones."""

    values: Mapping[Place, float]


@dataclass(frozen=True)
class TextTyped(Intent):
    """A field holds a text that is not its number; None when it does no longer."""

    place: Place
    text: str | None


@dataclass(frozen=True)
class ZoneSet(Intent):
    """A zone of the draft, in the window in focus, and what is typed over it, becomes that of the document."""

    zone: Zone
    typed: Mapping[Place, float]


@dataclass(frozen=True)
class PendingSet(Intent):
    """All that is typed and not set becomes that of the document."""


@dataclass(frozen=True)
class ZoneRead(Intent):
    """A zone of the document, in the window in focus, comes back into the draft."""

    zone: Zone


@dataclass(frozen=True)
class PointsMoved(Intent):
    """Control points are moved, and with them what the tools let follow.

    Parameters
    ----------
    indices : which; where two of them mirror each other, the first one's side leads
    displacements : of each, x, y, z in the document's units from where it stood when the gesture began
    gesture : 0 for none
    """

    indices: tuple[NetIndex, ...]
    displacements: tuple[tuple[float, float, float], ...]
    gesture: int = 0


@dataclass(frozen=True)
class GestureBegun(Intent):
    """A drag has begun; points that are moved begin theirs themselves."""

    gesture: int


@dataclass(frozen=True)
class GestureEnded(Intent):
    """A drag has ended where it is."""

    gesture: int


@dataclass(frozen=True)
class GestureCancelled(Intent):
    """A drag is to be as if it had never been."""

    gesture: int


@dataclass(frozen=True)
class FormulationChosen(Intent):
    """Another formulation, by its name."""

    name: str


@dataclass(frozen=True)
class SamplesChosen(Intent):
    """Other sample counts along u and v; ``gesture`` is 0 for none."""

    samples: tuple[int, int]
    gesture: int = 0


@dataclass(frozen=True)
class Undone(Intent):
    """One step back."""


@dataclass(frozen=True)
class Redone(Intent):
    """One step forward."""


@dataclass(frozen=True)
class WentTo(Intent):
    """So many steps of the history are done."""

    index: int


@dataclass(frozen=True)
class Configured(Intent):
    """The surface is that of the document from now on."""


@dataclass(frozen=True)
class LiveSwitched(Intent):
    """Edits are set at once, or wait in the draft."""

    is_live: bool


# Answers of the shell


@dataclass(frozen=True)
class Opened(Intent):
    """Another document has come, with a history of its own.

    Parameters
    ----------
    path : the ``.qovr`` file that Save writes; None where there is none yet
    preset : the name of the preset that it is, else empty
    is_saved : whether it lies in a file as it is, or need not
    draft : the document with what was typed over it and not set; None where nothing was
    """

    document: Document
    title: str
    path: Path | None = None
    stamp: Stamp | None = None
    preset: str = ""
    is_saved: bool = True
    message: str = ""
    draft: Document | None = None


@dataclass(frozen=True)
class Saved(Intent):
    """The document of a serial of the history lies in a file now, and is called by its name."""

    path: Path
    title: str
    serial: int
    stamp: Stamp | None = None


@dataclass(frozen=True)
class FileFound(Intent):
    """The document's file was looked at again; ``stamp`` is None where there is none any more."""

    path: Path
    stamp: Stamp | None


@dataclass(frozen=True)
class Reloaded(Intent):
    """The document's file was read again; what stood here before can be had back by Undo."""

    document: Document
    stamp: Stamp | None


@dataclass(frozen=True)
class OutsideKept(Intent):
    """The document stays as it is, whatever lies in its file now: Save will replace that."""
