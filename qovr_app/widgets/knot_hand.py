"""Dragging one knot, wherever it is seen as a place."""

from __future__ import annotations

from abc import abstractmethod

from PySide6.QtCore import QPointF, Signal
from PySide6.QtWidgets import QWidget

from qovr_app.state.intents import GestureBegun
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.state.looking_intents import FieldFocused
from qovr_app.widgets.dragger import Dragger


class KnotHand(Dragger):
    """Moves the knot that is held; s goes with u while the two are one number and Ctrl is up.

    Parameters
    ----------
    in_view : whether the document is set even where edits wait

    Signals
    -------
    wanted : an intent
    """

    wanted = Signal(object)

    def __init__(self, widget: QWidget, *, in_view: bool) -> None:
        super().__init__(widget)
        self._in_view = in_view
        self._knot: KnotInHand | None = None
        self._snaps_by_itself = False
        self._value = self._kept = 0.0

    @property
    def is_pressed(self) -> bool:
        """Whether the mouse holds a knot."""
        return self._knot is not None

    @property
    def knot(self) -> KnotInHand | None:
        """The knot that is held, as it was when it was taken."""
        return self._knot

    @property
    def typed(self) -> str:
        """The number that is being typed."""
        return self._typed.text

    @property
    def is_possible(self) -> bool:
        """Whether what is typed, if anything is, can be a knot."""
        return not self._typed.text or self._typed_knot is not None

    def hold(self, knot: KnotInHand, at: QPointF, *, snaps: bool) -> None:
        """Take hold of a knot, and turn to it."""
        self._knot, self._snaps_by_itself, self._value = knot, snaps, knot.value
        self._press_at(at)
        self._take_again()
        self.wanted.emit(FieldFocused(knot.place))

    @abstractmethod
    def _gone(self) -> float:
        """Return how far the mouse has gone along the knot since it was taken, or taken again."""

    @abstractmethod
    def _pixel(self) -> float:
        """Return how far the knot goes while the mouse goes a pixel."""

    def _begin(self) -> None:
        self.wanted.emit(GestureBegun(self._gesture))

    def _take_again(self) -> None:
        self._kept = self._value

    def _let_go(self) -> None:
        self._knot = None

    def _report(self) -> None:
        knot = self._knot
        if knot is None:
            return
        if self._typed.text:
            self._value = self._typed_knot or self._value
        else:  # where s goes with u, Ctrl means another thing than the step
            snaps = self._snaps_by_itself is not (self._has_control and not knot.takes_s)
            goal = self._kept + self._gone()
            self._value = knot.meant(goal, self._pixel(), snaps=snaps, is_fine=self._is_fine)
        takes_s = knot.takes_s and not self._has_control
        self.wanted.emit(knot.set_to(self._value, self._gesture, takes_s=takes_s, in_view=self._in_view))
        self.changed.emit()

    @property
    def _typed_knot(self) -> float | None:
        """The number that is typed, where it can be a knot."""
        value = self._typed.value
        return value if value is not None and 0 < value < 1 else None
