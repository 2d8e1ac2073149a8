"""A mouse with its left button down over a widget that is found by its name."""

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
NONE = Qt.KeyboardModifier.NoModifier
SHIFT, CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


class Mouse:
    """A mouse over a widget, its left button down from the middle of the widget on."""

    def __init__(self, editor, name):
        self.editor, self.widget = editor, editor.find(name)
        self.at = self.widget.mapToGlobal(self.widget.rect().center())
        QTest.mousePress(self.widget, LEFT, NONE, self._here())
        editor.settle()

    def _here(self):
        return self.widget.mapFromGlobal(self.at)

    def move(self, *steps, modifiers=NONE):
        for step in steps:
            self.at += QPoint(step, 0)
            move(self.widget, self._here(), modifiers)
            self.editor.settle()
        return self

    def press_right(self):
        QTest.mousePress(self.widget, RIGHT, NONE, self._here())
        QTest.mouseRelease(self.widget, RIGHT, NONE, self._here())
        self.editor.settle()

    def release(self):
        QTest.mouseRelease(self.widget, LEFT, NONE, self._here())
        self.editor.settle()


def move(widget, at, modifiers):
    """Move the mouse with a button down and keys held, which QTest's own move cannot say."""
    place = QPointF(at)
    event = QMouseEvent(
        QEvent.Type.MouseMove, place, widget.mapToGlobal(place), Qt.MouseButton.NoButton, LEFT, modifiers
    )
    QApplication.sendEvent(widget, event)
