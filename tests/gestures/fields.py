"""Fields, headings, sliders and the knots' handles."""

import numpy as np
import pytest
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLineEdit, QMenu

from qovr_app.state.intents import FormulationChosen

from .gesture import Table

TABLE = Table()
BUMP = "control_points.P_2_2.z"


@TABLE("a field that has not the keyboard is dragged sideways: its number, one undo")
def _(hand):
    hand.over(BUMP)
    hand.press(hand.middle)
    hand.move_by(40, 0)
    hand.show()
    assert float(hand.editor.text(BUMP)) == hand.net[2, 2, 2] > 0.5
    hand.release()
    assert len(hand.steps) == 1


@TABLE("a heading dragged sideways changes all numbers of its column")
def _(hand):
    before = hand.net
    hand.over("control_points.column_2")
    hand.press(hand.middle)
    hand.move_by(40, 0)
    hand.show()
    hand.release()
    assert set(np.argwhere(hand.net != before)[:, 1].tolist()) == {2}
    assert len(hand.steps) == 1


@TABLE("a click on a heading selects its points")
def _(hand):
    hand.over("control_points.column_2")
    hand.click(hand.middle)
    hand.show()
    assert hand.selected == {(i, 2) for i in range(5)}


@TABLE("Escape during a drag of a slider puts the knot back and waits for the release")
def _(hand):
    hand.over("row_knots.slider")
    hand.press(hand.middle)
    hand.move_by(30, 0)
    assert hand.editor.document != hand.state.history.first
    hand.tap(Qt.Key.Key_Escape)
    hand.show()
    hand.move_by(30, 0)
    hand.release()
    assert hand.editor.document == hand.state.history.first
    assert hand.steps == []


@TABLE("double click on a slider resets its knots")
def _(hand):
    hand.editor.type_into("row_knots.C_4.r", "0.3", Qt.Key.Key_Return)
    hand.over("row_knots.slider")
    hand.double_click(QPointF(0.3 * hand.widget.width(), hand.middle.y()))
    hand.show()
    assert {knots.r for knots in hand.editor.document.row_knots.in_window(0)} == {0.5}


@TABLE("double click in a field selects its text")
def _(hand):
    hand.over(BUMP)
    QTest.mouseDClick(hand.widget, Qt.MouseButton.LeftButton)
    hand.show()
    assert hand.editor.find(BUMP, QLineEdit).selectedText() == "0.5"


def _add_numbers():
    texts = {"0.7": 0.7, "-0.1": -0.1, "1/3": 1 / 3, "+0.1": 0.6, "*2": 1.0, "/2": 0.25, "+-0.1": 0.4}
    for text, value in texts.items():

        @TABLE(f"{text} typed into a field of 0.5 is {value:.4g}")
        def _(hand, text=text, value=value):
            hand.editor.type_into(BUMP, text, None)
            hand.show()
            hand.tap(Qt.Key.Key_Return)
            assert hand.net[2, 2, 2] == pytest.approx(value, abs=1e-15)


_add_numbers()


@TABLE("what is no number is said at its field, and nothing changes")
def _(hand):
    hand.editor.type_into(BUMP, "abc", None)
    hand.tap(Qt.Key.Key_Return)
    hand.show()
    assert "abc" in hand.editor.message()
    assert hand.editor.document == hand.state.history.first
    hand.tap(Qt.Key.Key_Escape)
    assert hand.editor.text(BUMP) == "0.5"


@TABLE("right click on a field: reset, copy, paste, set on all curves")
def _(hand):
    hand.over("row_knots.C_4.r")
    hand.move(hand.middle)
    at = hand.middle.toPoint()
    asked = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, at, hand.widget.mapToGlobal(at))
    QApplication.sendEvent(hand.widget, asked)
    hand.editor.settle()
    menu = QApplication.activePopupWidget()
    hand.show()
    assert isinstance(menu, QMenu)
    names = {action.objectName() for action in menu.actions()}
    assert {"field_reset", "field_copy", "field_paste"} <= names
    menu.close()


@TABLE("a knot's handle is dragged along its chord")
def _(hand):
    hand.editor.dispatch(FormulationChosen("interpolating"))
    hand.editor.field("row_knots.C_0.u").setFocus()
    hand.editor.settle()
    start, end = hand.place(0, 1), hand.place(0, 3)
    hand.press((start + end) / 2)
    hand.move(start + 0.6 * (end - start))
    hand.show()
    hand.release()
    row = hand.editor.document.row_knots[0, 0]
    assert row.u == row.s == pytest.approx(0.6, abs=0.006)
    assert hand.steps[-1].startswith("Set u_ip")
    assert np.array_equal(hand.net, hand.state.history.first.control_points)


@TABLE("Escape during a drag of a knot's handle puts it back and waits for the release")
def _(hand):
    hand.editor.dispatch(FormulationChosen("interpolating"))
    before = hand.editor.document
    hand.editor.field("row_knots.C_0.u").setFocus()
    hand.editor.settle()
    start, end = hand.place(0, 1), hand.place(0, 3)
    hand.press((start + end) / 2)
    hand.move(start + 0.6 * (end - start))
    assert hand.editor.document != before
    hand.tap(Qt.Key.Key_Escape)
    hand.show()
    hand.move_by(20, 20)
    hand.release()
    assert hand.editor.document == before
