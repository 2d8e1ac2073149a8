"""The undo history, as a value: what every step changed, and the document as it stands; never what can be computed."""

from __future__ import annotations

from dataclasses import dataclass, replace

from qovr_app.state.change import Change, backward, forward
from qovr_app.state.intents import Intent
from qovr_app.state.point_intents import PointsEdited
from qovr_app.state.renumbering import Renumbering
from qovr_core import Document
from qovr_core.net_edits import NetEdit

MOST_STEPS = 2000
"""More steps than anybody takes back."""

MOST_BYTES = 256 * 1024 * 1024
"""What all steps of a history may take together; of moves of single points, 2,000 stay far below."""

_BYTES_A_STEP = 500
"""One step as Python holds it, without its change."""


@dataclass(frozen=True, eq=False)
class Step:
    """One step: what it is called, and what it changed.

    Parameters
    ----------
    serial : a number that no other step of the history has
    gesture : the gesture that the step belongs to, 0 for none; steps of one gesture become one
    edit : the edit of points that it was, which can be done once more; None for any other step
    renumbering : which numbers rows and columns had afterwards; None where the same
    """

    text: str
    change: Change
    serial: int
    gesture: int = 0
    edit: NetEdit | None = None
    renumbering: Renumbering | None = None

    @property
    def bytes_held(self) -> int:
        """What it takes in memory."""
        return _BYTES_A_STEP + self.change.bytes_held


@dataclass(frozen=True, eq=False)
class History:
    """All steps that can be undone or redone.

    Parameters
    ----------
    document : the document as it stands
    first : the document before the first step
    steps : the steps, the oldest first
    index : how many of the steps are done
    first_serial, last_serial : the serial of ``first``, and the last one that was given to a step
    saved : the serial of the document that lies in the file; None where none does
    bytes_held : what the steps take
    latest : what asked for the step that was made last; None where something else has been since
    """

    document: Document
    first: Document
    steps: tuple[Step, ...] = ()
    index: int = 0
    first_serial: int = 0
    last_serial: int = 0
    saved: int | None = 0
    bytes_held: int = 0
    latest: Intent | None = None

    @classmethod
    def of(cls, document: Document, *, is_saved: bool = True) -> History:
        """Return the history of a document of which nothing has changed yet."""
        return cls(document, document, saved=0 if is_saved else None)

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

    def pushed(
        self,
        text: str,
        document: Document,
        intent: Intent | None,
        gesture: int = 0,
        *,
        renumbering: Renumbering | None = None,
    ) -> History:
        """Return the history with another document on top.

        A gesture's steps become one, and none where the document comes back to where the gesture began. A saved step
        does not grow: what is in the file stays what the mark says.
        """
        if document == self.document:
            return self
        grows = self._can_grow(gesture)
        earlier = self.undone() if grows else self
        if grows and document == earlier.document:
            return replace(earlier, steps=self.steps[:-1], bytes_held=self.bytes_held - self.steps[-1].bytes_held)
        edit = intent.edit if isinstance(intent, PointsEdited) else None
        text, serial = (self.steps[-1].text, self.serial) if grows else (text, self.last_serial + 1)
        step = Step(text, Change.between(earlier.document, document), serial, gesture, edit, renumbering)
        return earlier._with_step(document, step, intent)

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
        there = min(max(index, 0), len(self.steps))
        if there == self.index:
            return self
        if there < self.index:
            document = backward(self.document, [step.change for step in reversed(self.steps[there : self.index])])
        else:
            document = forward(self.document, [step.change for step in self.steps[self.index : there]])
        return replace(self, document=document, index=there, latest=None)

    def renumberings_to(self, index: int) -> list[Renumbering]:
        """Return what rows and columns go through on the way to where so many steps are done."""
        there = min(max(index, 0), len(self.steps))
        if there < self.index:
            undone = (step.renumbering for step in reversed(self.steps[there : self.index]))
            return [each.back for each in undone if each is not None]
        return [step.renumbering for step in self.steps[self.index : there] if step.renumbering is not None]

    def marked_saved(self, serial: int | None) -> History:
        """Return the history with the document of a serial as the one in the file; None where none is."""
        return replace(self, saved=serial)

    def _can_grow(self, gesture: int) -> bool:
        is_last = 0 < self.index == len(self.steps)
        return bool(gesture) and is_last and not self.is_saved and self.steps[-1].gesture == gesture

    def _with_step(self, document: Document, step: Step, intent: Intent | None) -> History:
        """Return the history with one more step in place of all that are undone, without the oldest if too many."""
        undone = self.steps[self.index :]
        steps = (*self.steps[: self.index], step)
        held = self.bytes_held - sum(each.bytes_held for each in undone) + step.bytes_held
        dropped = max(len(steps) - MOST_STEPS, 0)
        held -= sum(each.bytes_held for each in steps[:dropped])
        while held > MOST_BYTES and dropped < len(steps) - 1:
            held -= steps[dropped].bytes_held
            dropped += 1
        kept = replace(
            self,
            document=document,
            steps=steps[dropped:],
            index=len(steps) - dropped,
            last_serial=max(self.last_serial, step.serial),
            bytes_held=held,
            latest=intent,
        )
        if not dropped:
            return kept
        first = forward(self.first, [each.change for each in steps[:dropped]])
        return replace(kept, first=first, first_serial=steps[dropped - 1].serial)
