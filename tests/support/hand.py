"""A hand on the mouse and the keys over the window's view: real events, by the places that the window promises."""

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

NONE, SHIFT, CONTROL, ALT = (
    getattr(Qt.KeyboardModifier, f"{name}Modifier") for name in ("No", "Shift", "Control", "Alt")
)
LEFT, MIDDLE, RIGHT, NO_BUTTON = (
    getattr(Qt.MouseButton, f"{name}Button") for name in ("Left", "Middle", "Right", "No")
)

_MODIFIER_KEYS = {Qt.Key.Key_Shift: SHIFT, Qt.Key.Key_Control: CONTROL, Qt.Key.Key_Alt: ALT}


class Hand:
    """Presses, moves and types over a widget of an editor, at first its view; ``at`` is a pixel of that widget."""

    def __init__(self, editor):
        self.editor, self.at = editor, QPointF()
        self.widget = self.viewport
        self.held, self.modifiers = NO_BUTTON, NONE
        self.presses = 0  # of buttons and keys, as a user would count them

    @property
    def view(self):
        return self.editor.window.view

    @property
    def viewport(self):
        return self.view.viewports[0].widget

    def over(self, name):
        """Go over another widget of the window; pixels are its own from now on."""
        self.widget = self.editor.find(name)

    @property
    def middle(self):
        return QPointF(self.widget.rect().center())

    def place(self, i, j):
        """Return where a control point is seen, in the viewport's pixels."""
        return QPointF(self.viewport.mapFromGlobal(self.editor.window.screen_position(i, j)))

    def press(self, at=None, button=LEFT):
        """Press a button; it goes down on its way there, as on a real table."""
        if at is not None:
            self.move(at)
        self.held |= button
        self.presses += 1
        if self.widget.focusPolicy() & Qt.FocusPolicy.ClickFocus:  # which Qt gives for events of the system alone
            self.widget.setFocus(Qt.FocusReason.MouseFocusReason)
        self._send(QMouseEvent.Type.MouseButtonPress, button)
        self.editor.settle()

    def move(self, at):
        """Move the mouse to a pixel, and over one half way there."""
        start = self.at
        for part in (0.5, 1.0):
            self.at = start + part * (QPointF(at) - start)
            self._send(QMouseEvent.Type.MouseMove, NO_BUTTON)
        self.editor.settle()

    def move_by(self, dx, dy):
        self.move(self.at + QPointF(dx, dy))

    def release(self, button=LEFT):
        self.held &= ~button
        self._send(QMouseEvent.Type.MouseButtonRelease, button)
        self.editor.settle()

    def click(self, at=None, button=LEFT):
        self.press(at, button)
        self.release(button)

    def double_click(self, at):
        self.click(at)
        self.held |= LEFT
        self.presses += 1
        self._send(QMouseEvent.Type.MouseButtonDblClick, LEFT)
        self.release()

    def drag(self, at, dx, dy, button=LEFT):
        """Press somewhere, go some way, and release."""
        self.press(at, button)
        self.move_by(dx, dy)
        self.release(button)

    def hold(self, key):
        """Hold a modifier, or a letter, down."""
        self.modifiers |= _MODIFIER_KEYS.get(key, NONE)
        self.presses += 1
        QTest.keyPress(self._focus(), key, self.modifiers & ~_MODIFIER_KEYS.get(key, NONE))
        self.editor.settle()

    def let_go(self, key):
        QTest.keyRelease(self._focus(), key, self.modifiers)
        self.modifiers &= ~_MODIFIER_KEYS.get(key, NONE)
        self.editor.settle()

    def tap(self, key, modifiers=NONE):
        """Press a key with modifiers and release it; a key with a modifier counts as one."""
        self.presses += 1
        QTest.keyClick(self._focus(), key, self.modifiers | modifiers)
        self.editor.settle()

    def type(self, text):
        self.presses += len(text)
        QTest.keyClicks(self._focus(), text)
        self.editor.settle()

    def wheel(self, notches, at=None):
        """Turn the wheel towards what is seen, or back."""
        if at is not None:
            self.move(at)
        self._turn(QPoint(), QPoint(0, 120 * notches), Qt.ScrollPhase.NoScrollPhase)

    def two_fingers(self, dx, dy):
        """Move two fingers over a trackpad."""
        self._turn(QPoint(dx, dy), QPoint(dx, dy), Qt.ScrollPhase.ScrollUpdate)

    def _focus(self):
        return QApplication.focusWidget() or self.viewport

    def _send(self, kind, button):
        event = QMouseEvent(kind, self.at, self.widget.mapToGlobal(self.at), button, self.held, self.modifiers)
        QApplication.sendEvent(self.widget, event)

    def _turn(self, pixels, angle, phase):
        at = self.widget.mapToGlobal(self.at)
        event = QWheelEvent(self.at, at, pixels, angle, self.held, self.modifiers, phase, False)
        QApplication.sendEvent(self.widget, event)
        self.editor.settle()
