"""The tour: the paper's example, five things to do with it, and nothing that stays but by wish."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Qt
from PySide6.QtGui import QShortcut
from PySide6.QtWidgets import QBoxLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.intents import Configured, LiveSwitched, WentTo, ZoneRead
from qovr_app.state.looking_intents import DisplayChosen, ZonesShown
from qovr_app.state.requests import FocusAsked, TourAsked
from qovr_app.widgets.highlight import Highlight
from qovr_app.widgets.notice import Notice
from qovr_app.window.preferences import Preferences
from qovr_app.window.sources import opened_source
from qovr_app.window.tour_steps import TOUR
from qovr_app.window.windows import Windows, is_untouched
from qovr_core.edits import Zone
from qovr_core.files.sources import PRESET_PREFIX

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow

_EXAMPLE = f"{PRESET_PREFIX}fig5"
_OFFERED = "tour/offered"


def begin_tour(windows: Windows, window: MainWindow) -> None:
    """Begin the tour with a document of its own: in this window if nothing was done in it, else in another one."""
    opened = replace(opened_source(_EXAMPLE), title="Tour", message="")
    if is_untouched(window.store.state):
        window.store.dispatch(opened)
        window.store.flush()
    else:
        window = windows.take(opened)
    Tour(window)


def offer_tour(window: MainWindow, preferences: Preferences) -> None:
    """Offer the tour in a line over the work, the first time that the program is started."""
    if preferences.chosen(_OFFERED, ""):
        return
    preferences.choose(_OFFERED, "yes")
    line = Notice("tour.offer", window)

    def answer(*, is_wanted: bool) -> None:
        line.deleteLater()
        if is_wanted:
            window.store.dispatch(TourAsked())

    line.add_answer("take", "Take the tour", "Five steps with the paper's example", lambda: answer(is_wanted=True))
    line.add_answer("decline", "No, thanks", "It is in the menu Help", lambda: answer(is_wanted=False))
    _put_over_work(window, line)
    line.ask("New here? Five steps show what can be done with a surface.")


class Tour(QObject):
    """Leads through the steps in a bar over the work; every step can be done by hand, shown, or skipped."""

    def __init__(self, window: MainWindow) -> None:
        super().__init__(window)
        self._window, self._store = window, window.store
        self._first = self._begun = self._store.state
        self._step, self._is_over = -1, False
        self._highlight = Highlight(window)
        self._bar = Notice("tour", window)
        self._bar.add_answer("show", "&Show me", "Let the program do this step", self._do)
        self._bar.add_answer("next", "&Next", "Go on without doing this", self._go_on)
        self._bar.add_answer("leave", "&Leave", "End the tour (Esc)", self.leave)
        self._end = Notice("tour.end", window)
        self._end.add_answer("keep", "&Keep it", "Go on with what was made", lambda: self._finish(keeps=True))
        self._end.add_answer("back", "&Put back", "Have the example as it was (Esc)", lambda: self._finish(keeps=False))
        for bar in (self._bar, self._end):
            _put_over_work(window, bar)
        self._escape = QShortcut(Qt.Key.Key_Escape, window)
        self._escape.activated.connect(self.leave)
        self._go_on()
        self._store.subscribe(self._show_state)

    def leave(self) -> None:
        """End the tour; where something was changed, ask whether it stays, and put it back when left once more."""
        if self._end.isVisible():
            self._finish(keeps=False)
            return
        self._bar.setVisible(False)
        self._highlight.show_around(None)
        if self._store.state.is_changed:
            self._end.ask("The tour is over. What was made in it can be kept, or the example is put back as it was.")
        else:
            self._finish(keeps=False)

    def _show_state(self, _before: EditorState | None, after: EditorState) -> None:
        if self._is_over:
            return
        if after.file.opening != self._first.file.opening:
            self._finish(keeps=True)  # another document has come: it is not the tour's to put back
            return
        self._escape.setEnabled(after.gesture is None and not after.texts)  # else it is theirs
        is_at_rest = self._bar.isVisible() and after.gesture is None
        if is_at_rest and TOUR[self._step].is_done(self._begun, after):
            self._go_on()

    def _do(self) -> None:
        for intent in TOUR[self._step].doing(self._store.state):
            self._store.dispatch(intent)

    def _go_on(self) -> None:
        if not self._store.state.is_live and self._first.is_live:
            self._go_live()
        self._step, self._begun = self._step + 1, self._store.state
        if self._step == len(TOUR):
            self.leave()
            return
        step = TOUR[self._step]
        self._store.dispatch(ZonesShown(are_shown=True))
        self._store.dispatch(FocusAsked(step.part))
        self._highlight.show_around(self._window.findChild(QWidget, step.target))
        self._bar.ask(f"Tour, {self._step + 1} of {len(TOUR)}.  {step.text}")

    def _go_live(self) -> None:
        """Drop what is typed and not set, which nobody would see any more, and set edits at once again."""
        for zone in Zone:
            self._store.dispatch(ZoneRead(zone))
        self._store.dispatch(LiveSwitched(is_live=True))

    def _finish(self, *, keeps: bool) -> None:
        self._is_over = True
        if not keeps:
            self._put_back()
        for part in (self._bar, self._end, self._highlight, self._escape):
            part.deleteLater()
        self.deleteLater()

    def _put_back(self) -> None:
        self._go_live()
        self._store.dispatch(WentTo(self._first.history.index))
        self._store.dispatch(LiveSwitched(is_live=self._first.is_live))
        self._store.dispatch(Configured())
        self._store.dispatch(DisplayChosen("colour_by", self._first.display.colour_by))


def _put_over_work(window: MainWindow, bar: QWidget) -> None:
    middle = window.centralWidget()
    layout = middle.layout() if middle is not None else None
    if isinstance(layout, QBoxLayout):
        layout.insertWidget(0, bar)
