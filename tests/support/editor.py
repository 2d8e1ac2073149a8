"""The editor's window as a user meets it: things are found by their names and moved by real events."""

from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QEvent, QPoint, Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QApplication,
    QComboBox,
    QDialog,
    QLabel,
    QLineEdit,
    QSplitter,
    QTabBar,
    QWidget,
)

from qovr_app.main import open_windows
from qovr_app.state.intents import Saved, ZoneRead
from qovr_app.window.sources import opened_source
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, Zone, value_at

ROW_FIELDS = [KnotPlace(Direction.ROWS, k, name) for k in range(5) for name in "rsut"]
COLUMN_FIELDS = [KnotPlace(Direction.COLUMNS, k, name) for k in range(5) for name in "rsut"]
POINT_FIELDS = [CoordinatePlace(i, j, axis) for i in range(5) for j in range(5) for axis in range(3)]

TABS = {"row_knots": "Rows u", "column_knots": "Columns v", "control_points": "Points", "surface": "Surface"}
"""What is written on the tab of each zone, where they are seen one at a time."""


def name_of(place):
    """Return the promised object name, written here apart from the program's own."""
    if isinstance(place, CoordinatePlace):
        return f"control_points.P_{place.i}_{place.j}.{'xyz'[place.axis]}"
    if place.direction is Direction.ROWS:
        return f"row_knots.C_{place.curve}.{place.name}"
    return f"column_knots.K_{place.curve}.{place.name.replace('u', 'v')}"


def wait_until(happened, seconds=30.0):
    """Let the event loop run until something is true."""
    for _ in range(int(seconds * 100)):
        if happened():
            return
        QTest.qWait(10)
    raise AssertionError("it did not happen in time")


def opened_windows():
    """Return the main windows that are shown, in the order in which they were opened."""
    QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    return [window for window in open_windows().all if window.isVisible()]


def scroll_to(area, widget):
    """Scroll until all of a widget is in sight, if it can be."""
    at = widget.mapTo(area.widget(), widget.rect().center())
    area.ensureVisible(at.x(), at.y(), widget.width() // 2 + 2, widget.height() // 2 + 2)


class Editor:
    def __init__(self, window, size):
        self.window = window
        self.is_discarded = False
        self._first = window.store.state
        window.resize(*size)
        window.show()
        window.activateWindow()
        QTest.qWaitForWindowExposed(window)
        self.settle()

    @property
    def document(self):
        return self.window.store.state.document

    def dispatch(self, intent):
        """Ask for something as any part of the window would."""
        self.window.store.dispatch(intent)
        self.settle()

    def mark_saved(self):
        """Have the document count as saved, and nothing be typed over it, so that nothing is asked."""
        for zone in Zone:
            self.window.store.dispatch(ZoneRead(zone))
        state = self.window.store.state
        self.window.store.dispatch(Saved(Path(state.file.title), state.file.title, state.history.serial))

    def begin_again(self, source=None, size=(1440, 900)):
        """Have the window as if it had just been opened: its state, and what is kept outside of it."""
        self.close_dialogs()
        self.window.resize(*size)
        self.find("message").setFocus()
        (QApplication.focusWidget() or self.window).clearFocus()
        self.mark_saved()
        store = self.window.store
        store._state = replace(self._first, file=store.state.file)  # every choice as at first, however it was made
        self.dispatch(opened_source(source or "paper:fig5"))
        self.window.view.set_camera("paper", animated=False)
        self.window.activateWindow()  # without a window manager it does not come back after a dialog
        self.settle()

    def close_dialogs(self):
        """Close every dialog and popup."""
        while (popup := QApplication.activePopupWidget()) is not None:
            popup.close()
        for dialog in self.window.findChildren(QDialog):
            dialog.close()

    def on_evaluation(self, call):
        """Call with every surface that is shown from now on."""
        self.window.store.subscribe(
            lambda before, after: call(after.evaluation) if before and after.differs(before, "evaluation") else None
        )

    def settle(self):
        for _ in range(3):
            QApplication.processEvents()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    def find(self, name, kind=QWidget):
        (found,) = self.window.findChildren(kind, name)
        return found

    def choose_tab(self, text):
        """Click a tab of the column of zones."""
        tabs = self.find("zones.tabs", QTabBar)
        number = [tabs.tabText(k) for k in range(tabs.count())].index(text)
        QTest.mouseClick(tabs, Qt.MouseButton.LeftButton, pos=tabs.tabRect(number).center())
        self.settle()

    def reach(self, name, kind=QWidget):
        """Return what has a name, its zone's tab clicked where that is what hides it."""
        widget = self.find(name, kind)
        tabs = self.find("zones.tabs", QTabBar)
        if not widget.isVisible() and tabs.isVisible() and name.partition(".")[0] in TABS:
            self.choose_tab(TABS[name.partition(".")[0]])
        return widget

    def field(self, name):
        return self.find(name, QLineEdit)

    def text(self, name):
        return self.field(name).text()

    def message(self):
        return self.find("message", QLabel).text()

    def action(self, name):
        return self.find(name, QAction)

    def trigger(self, name):
        self.action(name).trigger()
        self.settle()

    def click(self, name):
        QTest.mouseClick(self.reach(name, QAbstractButton), Qt.MouseButton.LeftButton)
        self.settle()

    def type_into(self, name, text, end=Qt.Key.Key_Tab):
        field = self.reach(name, QLineEdit)
        QTest.mouseClick(field, Qt.MouseButton.LeftButton)
        field.selectAll()
        QTest.keyClicks(field, text)
        if end is not None:
            QTest.keyClick(field, end)
        self.settle()

    def key(self, key, modifiers=Qt.KeyboardModifier.NoModifier, widget=None):
        QTest.keyClick(widget or QApplication.focusWidget() or self.window, key, modifiers)
        self.settle()

    def choose(self, name, text):
        box = self.reach(name, QComboBox)
        box.setFocus()
        QTest.qWait(QApplication.keyboardInputInterval() + 50)  # or the letter joins the one typed before
        QTest.keyClicks(box, text[0])
        self.settle()
        assert box.currentText() == text

    def dialog(self, name):
        wait_until(lambda: self.window.findChild(QDialog, name) is not None)
        return self.find(name, QDialog)

    def move_slider(self, name, steps):
        slider = self.reach(name)
        slider.setFocus()
        for _ in range(abs(steps)):
            QTest.keyClick(slider, Qt.Key.Key_Right if steps > 0 else Qt.Key.Key_Left)
        self.settle()

    def drag_slider(self, name, moves):
        """Drag the slider's handle by these distances in pixels, one after the other."""
        slider = self.reach(name)
        start = QPoint(round(slider.width() * slider.value() / (slider.maximum() + 1)), slider.height() // 2)
        QTest.mousePress(slider, Qt.MouseButton.LeftButton, pos=start)
        at = start
        for move in moves:
            at += QPoint(move, 0)
            QTest.mouseMove(slider, at)
            self.settle()
        QTest.mouseRelease(slider, Qt.MouseButton.LeftButton, pos=at)
        self.settle()

    def drag_handle(self, name, by):
        """Drag the handle between a splitter's parts so many pixels to the right or down."""
        splitter = self.find(name, QSplitter)
        handle = splitter.handle(1)
        is_row = splitter.orientation() == Qt.Orientation.Horizontal
        start = handle.rect().center()
        QTest.mousePress(handle, Qt.MouseButton.LeftButton, pos=start)
        QTest.mouseMove(handle, start + (QPoint(by, 0) if is_row else QPoint(0, by)))
        QTest.mouseRelease(handle, Qt.MouseButton.LeftButton, pos=handle.rect().center())
        self.settle()

    def export_to(self, path):
        """Export through the dialog, the file's name typed."""
        self.click("surface.export")
        dialog = self.dialog("export")
        field = dialog.findChild(QLineEdit, "export.path")
        field.setFocus()
        field.selectAll()
        QTest.keyClicks(field, str(path))
        QTest.mouseClick(dialog.findChild(QAbstractButton, "export.start"), Qt.MouseButton.LeftButton)
        wait_until(lambda: self.window.findChild(QDialog, "export") is None, 60)
        self.settle()

    def disagreements(self):
        """Return the fields that show something else than the document and do not look so.

        Those behind a tab show an older state until they are seen, or asked.
        """
        zones, wrong = self.window.parts.zones, []
        for zone in zones.of_fields:
            zones.told(zone)
        for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS):
            field = self.field(name_of(place))
            is_same = not field.has_own_text and float(field.text()) == value_at(self.document, place)
            if is_same == field.is_pending:
                wrong.append((name_of(place), field.text(), value_at(self.document, place)))
        return wrong

    def discard(self):
        if self.is_discarded:
            return
        self.is_discarded = True
        self.mark_saved()
        self.window.close()
        self.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QApplication.processEvents()
