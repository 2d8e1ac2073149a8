"""The undo history: documents and the intents that made them, as a value; never anything that can be computed again."""

from __future__ import annotations

from dataclasses import dataclass, replace

from qovr_app.state.intents import Intent
from qovr_core import Document

MOST_STEPS = 2000
"""More steps than anybody takes back."""

MOST_BYTES = 256 * 1024 * 1024
"""What all documents of a history may take together; of 5 x 5 points, 2,000 steps stay far below."""

_BYTES_A_CURVE = 200
"""A curve's four knots as Python holds them."""


@dataclass(frozen=True, eq=False)
class Step:
    """One step: the document after it, what it is called, and what asked for it.

    Parameters
    ----------
    serial : a number that no other step of the history has
    gesture : the gesture that the step belongs to, 0 for none; steps of one gesture become one
    """

    text: str
    document: Document
    intent: Intent | None
    serial: int
    gesture: int = 0


@dataclass(frozen=True, eq=False)
class History:
    """All steps that can be undone or redone.

    Parameters
    ----------
    first : the document before the first step
    steps : the steps, the oldest first
    index : how many of the steps are done
    first_serial, last_serial : the serial of ``first``, and the last one that was given to a step
    saved : the serial of the document that lies in the file; None where none does
    bytes_held : what the documents of the steps take
    """

    first: Document
    steps: tuple[Step, ...] = ()
    index: int = 0
    first_serial: int = 0
    last_serial: int = 0
    saved: int | None = 0
    bytes_held: int = 0

    @property
    def document(self) -> Document:
        """The document as it stands."""
        return self._document_at(self.index)

    @property
    def serial(self) -> int:
        """The serial of the document as it stands."""
        return self.steps[self.index - 1].serial if self.index else self.first_serial

    @property
    def is_saved(self) -> bool:
        """Whether the document as it stands lies in its file."""
        return self.serial == self.saved

    @property
    def undo_text(self) -> str | None:
        """What would be undone; None where nothing can be."""
        return self.steps[self.index - 1].text if self.index else None

    @property
    def redo_text(self) -> str | None:
        """What would be done again; None where nothing can be."""
        return self.steps[self.index].text if self.index < len(self.steps) else None

    def pushed(self, text: str, document: Document, intent: Intent | None, gesture: int = 0) -> History:
        """Return the history with another document on top.

        A gesture's steps become one, and none where the document comes back to where the gesture began. A saved step
        does not grow: what is in the file stays what the mark says.
        """
        if document == self.document:
            return self
        if not self._can_grow(gesture):
            done, undone = self.steps[: self.index], self.steps[self.index :]
            step = Step(text, document, intent, self.last_serial + 1, gesture)
            held = self.bytes_held - sum(document_bytes(each.document) for each in undone) + document_bytes(document)
            return replace(self._with_steps((*done, step), held), last_serial=step.serial)
        if document == self._document_at(self.index - 1):
            return self._with_steps(self.steps[:-1], self.bytes_held - document_bytes(self.document))
        grown = replace(self.steps[-1], document=document, intent=intent)
        held = self.bytes_held - document_bytes(self.document) + document_bytes(document)
        return self._with_steps((*self.steps[:-1], grown), held)

    def without(self, gesture: int, earlier: History) -> History:
        """Return what this history was before a gesture, undone steps included; itself where more has been since."""
        newer = [step for step in self.steps if step.serial > earlier.last_serial]
        if self.index < len(self.steps) or any(step.gesture != gesture for step in newer):
            return self
        return replace(earlier, saved=self.saved, last_serial=self.last_serial)

    def undone(self) -> History:
        """Return the history one step back."""
        return self.gone_to(self.index - 1)

    def redone(self) -> History:
        """Return the history one step forward."""
        return self.gone_to(self.index + 1)

    def gone_to(self, index: int) -> History:
        """Return the history with so many steps done; the nearest there can be."""
        return replace(self, index=min(max(index, 0), len(self.steps)))

    def marked_saved(self, serial: int | None) -> History:
        """Return the history with the document of a serial as the one in the file; None where none is."""
        return replace(self, saved=serial)

    def _can_grow(self, gesture: int) -> bool:
        is_last = 0 < self.index == len(self.steps)
        return bool(gesture) and is_last and not self.is_saved and self.steps[-1].gesture == gesture

    def _document_at(self, index: int) -> Document:
        return self.steps[index - 1].document if index else self.first

    def _with_steps(self, steps: tuple[Step, ...], held: int) -> History:
        """Return the history with these steps, all done, the oldest gone where there are too many."""
        dropped = max(len(steps) - MOST_STEPS, 0)
        held -= sum(document_bytes(step.document) for step in steps[:dropped])
        while held > MOST_BYTES and dropped < len(steps) - 1:
            held -= document_bytes(steps[dropped].document)
            dropped += 1
        kept = replace(self, steps=steps[dropped:], index=len(steps) - dropped, bytes_held=held)
        if not dropped:
            return kept
        return replace(kept, first=steps[dropped - 1].document, first_serial=steps[dropped - 1].serial)


def document_bytes(document: Document) -> int:
    """Return what a document takes in memory."""
    curves = len(document.row_knots) + len(document.column_knots)
    return document.control_points.nbytes + _BYTES_A_CURVE * curves
