"""A plot of the transformations r(u), s(u), t(u) of one curve with its four knots as handles."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import QEvent, QPointF, Qt, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.intents import GestureCancelled, GestureEnded
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.store import Store
from qovr_app.widgets.knot_canvas import KnotCanvas
from qovr_app.widgets.knot_picture import limits_of
from qovr_app.widgets.plot_hand import nearest_knot

_REACH = 10.0
"""Pixels around a handle that belong to it."""

_MODIFIERS: dict[int, Qt.KeyboardModifier] = {
    Qt.Key.Key_Shift: Qt.KeyboardModifier.ShiftModifier,
    Qt.Key.Key_Control: Qt.KeyboardModifier.ControlModifier,
}

_CURSORS = {
    "u": Qt.CursorShape.SizeHorCursor,
    **dict.fromkeys("rst", Qt.CursorShape.SizeVerCursor),
}
"""By the knot under the mouse."""

_TIP = """The parameters r, s and t of the three parabolas, over the curve's own.
Drag a handle: r on the left edge, t on the right, s on its line, u along 0.
s goes with u while the two are one number; Ctrl parts them.
Shift: fine. Digits: the value. Esc: back. Double click: 0.5.
Amber: there the curve folds back."""


class KnotPlot(KnotCanvas):
    """Shows a curve's transformations; what is dragged there sets its knots.

    Signals
    -------
    hovered : the parameter under the mouse; None when the mouse has gone
    """

    hovered = Signal(object)

    def __init__(self, name: str, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(name, parent)
        self._store = store
        self._waits = False
        self._at = QPointF()
        self._hand.wanted.connect(store.dispatch)
        self._hand.finished.connect(lambda gesture: store.dispatch(GestureEnded(gesture)))
        self._hand.cancelled.connect(lambda gesture: store.dispatch(GestureCancelled(gesture)))
        self.setMouseTracking(True)
        self.setFocusPolicy(Qt.FocusPolicy.ClickFocus)
        self.setToolTip(_TIP)

    def _knot(self, name: str) -> KnotInHand | None:
        curve = self._curve
        if curve is None or not name:
            return None
        return replace(curve, place=replace(curve.place, name=name))

    # The mouse

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if self._hand.is_pressed or self._waits:
            if event.button() == Qt.MouseButton.RightButton:
                self._put_back()
            return
        knot = self._knot(self._name_under(event.position()))
        if event.button() == Qt.MouseButton.LeftButton and knot is not None:
            self._at = event.position()
            self._hand.take(knot, self._frame, event.position(), snaps=self._store.state.tools.snaps)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        at = event.position()
        if self._hand.is_pressed:
            self._follow(at, event.modifiers())
        elif not event.buttons():
            self._waits = False
            self._point_at(self._name_under(at))
            self.hovered.emit(self._frame.u_at(at.x()) if self._has_room else None)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._hand.finish()
            self._settle()
            self._point_at(self._name_under(event.position()))

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        knot = self._knot(self._name_under(event.position()))
        if event.button() == Qt.MouseButton.LeftButton and knot is not None:
            self._store.dispatch(knot.reset())
            self._settle(waits=True)

    def leaveEvent(self, event: QEvent) -> None:
        super().leaveEvent(event)
        if not self._hand.is_pressed:
            self._point_at("")
            self.hovered.emit(None)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        if self._hand.is_pressed:
            self._put_back()

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ShortcutOverride and self._hand.is_pressed:
            event.accept()  # whatever shortcuts the window has, a drag is not disturbed
            return True
        return super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        self._on_key(event, is_press=True)

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        self._on_key(event, is_press=False)

    def _on_key(self, event: QKeyEvent, *, is_press: bool) -> None:
        """Take the keys of a drag; all others are the window's."""
        if not self._hand.is_pressed:
            event.ignore()
        elif event.key() in _MODIFIERS:
            changed = _MODIFIERS[event.key()]
            self._follow(self._at, event.modifiers() | changed if is_press else event.modifiers() & ~changed)
        elif is_press and event.key() == Qt.Key.Key_Escape:
            self._put_back()
        elif is_press and event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter):
            self._hand.finish()
            self._settle(waits=True)
        elif is_press:
            self._hand.type(event)

    def _follow(self, at: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Move what is held to where the mouse is."""
        self._at = at
        is_fine = bool(modifiers & Qt.KeyboardModifier.ShiftModifier)
        has_control = bool(modifiers & Qt.KeyboardModifier.ControlModifier)
        self._hand.move_to(at, is_fine=is_fine, has_control=has_control)

    def _put_back(self) -> None:
        """Let the drag be as if it had never been, and wait for the release."""
        self._hand.cancel()
        self._settle(waits=True)

    def _settle(self, *, waits: bool = False) -> None:
        """Show the knots as they are after a drag, in limits of their own."""
        self._waits = waits
        if self._curve is not None:
            self._limits = limits_of(self._curve.knots)
        self.update()

    def _name_under(self, at: QPointF) -> str:
        """Return the knot whose handle a pixel belongs to; empty for none."""
        if self._curve is None or not self._has_room:
            return ""
        return nearest_knot(self._frame, self._curve.knots, at, _REACH)

    def _point_at(self, name: str) -> None:
        """Show which handle the mouse would take."""
        self.setCursor(_CURSORS.get(name, Qt.CursorShape.ArrowCursor))
        if name != self._used:
            self._used = name
            self.update()
