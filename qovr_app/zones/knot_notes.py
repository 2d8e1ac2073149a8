"""What is said under the knots of a window, and at their fields: without effect, folding back, shared at a joint."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from qovr_app.state.focus import in_window
from qovr_app.style.symbols import symbol_html
from qovr_core import FORMULATIONS, Document, Knots
from qovr_core.construction import active_curves
from qovr_core.document import Window
from qovr_core.edits import knots_of, shared_knots
from qovr_core.geometry.folding import Parts, folding_parts
from qovr_core.geometry.knots import KNOT_NAMES, Direction, KnotPlace
from qovr_core.geometry.windows import NET_SIZE


@dataclass(frozen=True)
class KnotNotes:
    """The notes on the knots of the five curves of a direction in one window.

    Parameters
    ----------
    document : the document, as its formulation and its joints are in force
    curves : the knots of the five curves, which may be edited and not set
    """

    direction: Direction
    document: Document
    window: Window
    curves: Sequence[Knots]

    @property
    def active(self) -> list[int]:
        """Which of the five have an effect on the surface, in this window or in another."""
        whole = set(active_curves(self.document, self.direction))
        return [number for number in range(NET_SIZE) if self._place(number).curve in whole]

    def html(self) -> str:
        """Return the notes as rich text, a line each."""
        active, notes = self.active, []
        if len(active) < NET_SIZE:
            idle = [number for number in range(NET_SIZE) if number not in active]
            is_run = len(idle) > 1 and idle == list(range(idle[0], idle[-1] + 1))
            names, used = self._symbols(idle), ", ".join(self._symbols(active))
            notes.append(
                f"{f'{names[0]}..{names[-1]}' if is_run else ', '.join(names)} have no effect: "
                f"the <i>{self.document.formulation}</i> surface uses {used} alone. {self._way_out()}"
            )
        folding = {number: parts for number in active if (parts := folding_parts(self.curves[number]))}
        if folding:
            notes.append(self._folding_note(folding))
        if shared := self._shared_note():
            notes.append(shared)
        return "<br>".join(notes)

    def warning(self, number: int) -> str:
        """Return what a curve's folding means for its knots; nothing where it does not fold."""
        parts = folding_parts(self.curves[number])
        if not parts:
            return ""
        where, name = _where(self.direction.parameter, parts), self.direction.curve_name(self._place(number).curve)
        return f"{name} folds back: over evenly spaced points it runs backwards {where}."

    def _place(self, number: int, name: str = "u") -> KnotPlace:
        return in_window(KnotPlace(self.direction, number, name), self.window)

    def _way_out(self) -> str:
        """Return which formulations use every curve of the direction, the latest first, as links."""
        whole = [each for each in FORMULATIONS.values() if each.active_curves(self.direction) is None]
        links = " or ".join(f'<a href="{each}">{each}</a>' for each in reversed(whole))
        return f"Choose {links} to use all {_family(self.direction)}."

    def _symbols(self, numbers: list[int]) -> list[str]:
        return [symbol_html(self.direction.letter, str(number)) for number in numbers]

    def _folding_note(self, folding: Mapping[int, Parts]) -> str:
        shown = self._symbols(list(folding))
        names = f"{shown[0]}..{shown[-1]}" if len(shown) == NET_SIZE else ", ".join(shown)
        verb = "folds" if len(shown) == 1 else "fold"
        alike = set(folding.values())
        where = _where(f"<i>{self.direction.parameter}</i>", alike.pop()) if len(alike) == 1 else "in part"
        return f"{names} {verb} back: evenly spaced points are passed backwards {where}."

    def _shared_note(self) -> str:
        places = [place for name in KNOT_NAMES if is_shared(self.document, place := self._place(0, name))]
        if not places:
            return ""
        names = ", ".join(symbol_html(place.letter, "ip") for place in places)
        partners = [
            f"{symbol_html(place.letter, 'ip')} is {symbol_html(letter, 'ip')} of window {window} along {_along(place)}"
            for place in places
            for letter, window in partners_of(self.document, place)
        ]
        verb = "is" if len(places) == 1 else "are each"
        return f"Smooth joints: {names} {verb} one number on all {_family(self.direction)}; {', '.join(partners)}."


def is_shared(document: Document, place: KnotPlace) -> bool:
    """Return whether a smooth joint makes one number of a knot on all curves."""
    return any(isinstance(curves, slice) for curves, _, _ in shared_knots(document, place))


def partners_of(document: Document, place: KnotPlace) -> list[tuple[str, int]]:
    """Return the letters, and the windows along the curves, of the knots that a smooth joint makes one with another."""
    if not is_shared(document, place):
        return []
    own = place.window, place.number
    shared = shared_knots(document, place)
    return [(place.direction.knot_letters[knot], window) for _, window, knot in shared if (window, knot) != own]


def shared_words(document: Document, place: KnotPlace) -> str:
    """Return what a field says of a knot that a smooth joint shares; nothing of one that is the curve's own.

    Examples
    --------
    >>> from qovr_core import Document
    >>> net = Document([[[j, i, 0] for j in range(7)] for i in range(5)], formulation="interpolating")
    >>> shared_words(net, KnotPlace(Direction.ROWS, 3, "t"))
    'Smooth joint: one number on all rows, and r_ip of window 1 along u.'
    >>> shared_words(net, KnotPlace(Direction.COLUMNS, 3, "t"))
    ''
    """
    if not is_shared(document, place):
        return ""
    partners = "".join(
        f", and {letter}_ip of window {window} along {_along(place)}" for letter, window in partners_of(document, place)
    )
    return f"Smooth joint: one number on all {_family(place.direction)}{partners}."


def five_curves(document: Document, direction: Direction, window: Window) -> list[Knots]:
    """Return the knots of the five curves of a direction in a window."""
    table = knots_of(document, direction)
    places = (in_window(KnotPlace(direction, number, "u"), window) for number in range(NET_SIZE))
    return [table[place.curve, place.window] for place in places]


def _along(place: KnotPlace) -> str:
    return place.direction.parameter


def _family(direction: Direction) -> str:
    return "rows" if direction is Direction.ROWS else "columns"


def _where(parameter: str, parts: Parts) -> str:
    return f"for {parameter} from " + " and ".join(f"{low:.3g} to {high:.3g}" for low, high in parts)
