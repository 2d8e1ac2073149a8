"""The knots' handles in the view: each moves its knot along its chord, and nothing else, by real events."""

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QFocusEvent, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu

from qovr_app.state.display import LayerChoice
from qovr_app.state.figure_options import FigureOptions
from qovr_app.state.intents import FormulationChosen
from qovr_app.state.looking_intents import DisplayChosen
from qovr_core.edits import Direction, knots_of

LEFT, RIGHT, NO_BUTTON = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.NoButton
NONE, SHIFT, CONTROL = (getattr(Qt.KeyboardModifier, f"{name}Modifier") for name in ("No", "Shift", "Control"))
PRESS, MOVE, RELEASE, DOUBLE = (
    getattr(QMouseEvent.Type, name)
    for name in ("MouseButtonPress", "MouseMove", "MouseButtonRelease", "MouseButtonDblClick")
)
CHORDS = {"r": (0, 2), "s": (1, 3), "u": (1, 3), "t": (2, 4)}


def by(dx, dy):
    return np.array([dx, dy], dtype=float)


class Hands:
    """A window with the curve C_2 in focus, and a mouse over its view."""

    def __init__(self, editor):
        self.editor, self.view = editor, editor.window.view
        self.focus("row_knots.C_2.u")

    def focus(self, field):
        self.editor.field(field).setFocus()
        self.editor.settle()

    @property
    def viewport(self):
        return self.view.viewports[0].widget

    @property
    def state(self):
        return self.editor.window.store.state

    def knots(self, direction=Direction.ROWS):
        return [tuple(knots) for knots in knots_of(self.state.document, direction).in_window(0)]

    def point(self, i, j):
        """Return where a control point is in the viewport, by the promised way to aim at it."""
        return np.array(self.viewport.mapFromGlobal(QPointF(self.editor.window.screen_position(i, j))).toTuple())

    def handle(self, name, value=0.5, row=2):
        """Return where a row's handle belongs: in a parallel projection, so far along the chord on the screen."""
        start, end = (self.point(row, j) for j in CHORDS[name])
        return start + value * (end - start)

    def aside(self, start, end):
        """Return the way of one pixel on which a handle leaves a chord on which its control point lies."""
        way = (end - start) / np.hypot(*(end - start))
        across = np.array([way[1], -way[0]])
        return across if across[1] >= 0 else -across

    def send(self, kind, at, button=LEFT, buttons=LEFT, modifiers=NONE):
        place = QPointF(*at)
        event = QMouseEvent(kind, place, self.viewport.mapToGlobal(place), button, buttons, modifiers)
        QApplication.sendEvent(self.viewport, event)
        self.editor.settle()

    def press(self, at, modifiers=NONE):
        self.send(PRESS, at, modifiers=modifiers)

    def move(self, at, modifiers=NONE):
        self.send(MOVE, at, NO_BUTTON, modifiers=modifiers)

    def release(self, at, modifiers=NONE):
        self.send(RELEASE, at, LEFT, NO_BUTTON, modifiers)

    def click(self, at):
        self.press(at)
        self.release(at)

    def drag(self, name, begun, end, modifiers=NONE):
        """Drag a handle from where one value of its knot has it to where another does; leave the button down."""
        at = self.handle(name, begun)
        self.press(at)
        self.move(at + by(8, 8), modifiers)
        self.move(self.handle(name, end), modifiers)


@pytest.fixture
def hands(make_editor):
    editor = make_editor("paper:fig8")
    editor.dispatch(FormulationChosen("interpolating"))
    return Hands(editor)


@pytest.mark.parametrize("layer", [LayerChoice.RAW, LayerChoice.TRANSFORMED])
def test_a_handle_is_dragged_along_its_chord(hands, layer):
    hands.editor.dispatch(DisplayChosen("layer", layer))
    for name, column, value in (("r", 0, 0.4), ("t", 3, 0.62), ("u", 2, 0.55)):
        before = hands.state.document
        hands.drag(name, 0.5, value)
        hands.release(hands.handle(name, value))
        expected = [value if k == column or (name == "u" and k == 1) else 0.5 for k in range(4)]
        for knots in hands.knots():  # the curves are linked, and s is the same as u
            assert knots == pytest.approx(expected, abs=0.006)
        assert all(round(number, 3) == number for number in hands.knots()[2])  # no finer than a pixel means
        assert hands.state.knot.name == name
        assert hands.state.history.undo_text == f"Set {name}_ip of C_0..C_4"
        hands.editor.trigger("undo")
        assert hands.state.document == before


def test_control_lets_s_stay_and_takes_it_again(hands):
    hands.drag("u", 0.5, 0.6)
    hands.move(hands.handle("u", 0.6), CONTROL)
    r, s, u, t = hands.knots()[2]
    assert (r, s, t) == (0.5, 0.5, 0.5)
    assert u == pytest.approx(0.6, abs=0.006)
    hands.move(hands.handle("u", 0.61))
    assert hands.knots()[2][1] == hands.knots()[2][2]
    hands.move(hands.handle("u", 0.6), CONTROL)
    hands.release(hands.handle("u", 0.6), CONTROL)
    u = hands.knots()[2][2]
    hands.drag("s", 0.5, 0.3)  # now s has a handle of its own
    assert hands.knots()[2] == (0.5, pytest.approx(0.3, abs=0.006), u, 0.5)
    hands.move(hands.handle("s", u) + by(2, 0))  # near to u it comes home
    hands.release(hands.handle("s", u) + by(2, 0))
    assert hands.knots()[2] == (0.5, u, u, 0.5)


def test_fine_snapped_and_within_the_ends(hands):
    hands.drag("r", 0.5, 0.4)
    begun = hands.knots()[2][0]
    at = hands.handle("r", 0.4)
    hands.move(at, SHIFT)
    hands.move(at + 0.1 * (hands.point(2, 2) - hands.point(2, 0)), SHIFT)
    assert hands.knots()[2][0] - begun == pytest.approx(0.01, abs=0.001)
    hands.move(hands.handle("r", 0.32), CONTROL)
    assert hands.knots()[2][0] in {0.2, 0.25, 0.3}  # the mouse is ahead of the knot since it was fine
    hands.move(hands.handle("r", 1.7))
    assert hands.knots()[2][0] == 0.999
    hands.move(hands.handle("r", -1.7))
    assert hands.knots()[2][0] == 0.001
    hands.release(hands.handle("r", -1.7))


def test_digits_say_the_value_and_what_is_no_knot_is_not_taken(hands):
    hands.drag("t", 0.5, 0.6)
    QTest.keyClicks(hands.viewport, "0.7")
    hands.editor.settle()
    assert hands.knots()[2][3] == 0.7
    hands.move(hands.handle("t", 0.2))
    assert hands.knots()[2][3] == 0.7
    QTest.keyClick(hands.viewport, Qt.Key.Key_Backspace)
    QTest.keyClick(hands.viewport, Qt.Key.Key_Backspace)  # 0 is no knot
    hands.editor.settle()
    assert hands.knots()[2][3] == 0.7
    assert hands.editor.message() == ""
    QTest.keyClicks(hands.viewport, ".25")
    QTest.keyClick(hands.viewport, Qt.Key.Key_Return)
    hands.move(hands.handle("t", 0.9))
    hands.release(hands.handle("t", 0.9))
    assert hands.knots()[2][3] == 0.25
    assert len(hands.state.history.steps) == 2  # the formulation, and this


@pytest.mark.parametrize("end", ["escape", "right button", "focus"])
def test_a_drag_that_is_given_up_puts_all_back_and_waits_for_the_release(hands, end):
    before, camera, steps = hands.state.document, hands.view.camera, hands.state.history.steps
    hands.viewport.setFocus()
    hands.drag("u", 0.5, 0.6)
    assert hands.state.document != before
    if end == "escape":
        QTest.keyClick(hands.viewport, Qt.Key.Key_Escape)
    elif end == "right button":
        hands.send(PRESS, hands.handle("u", 0.6), RIGHT, LEFT | RIGHT)
        hands.send(RELEASE, hands.handle("u", 0.6), RIGHT, LEFT)
    else:
        lost = QFocusEvent(QEvent.Type.FocusOut, Qt.FocusReason.ActiveWindowFocusReason)
        QApplication.sendEvent(hands.viewport, lost)
    hands.editor.settle()
    hands.move(hands.handle("u", 0.7))
    hands.release(hands.handle("u", 0.7))
    assert hands.state.document == before
    assert hands.state.history.steps == steps
    assert hands.view.camera == camera
    assert hands.state.gesture is None


def test_two_clicks_reset_and_a_click_alone_edits_nothing(hands):
    hands.editor.type_into("row_knots.C_2.r", "0.3")
    before = hands.state.document
    at = hands.handle("r", 0.3)
    hands.click(at)
    assert hands.state.document == before
    hands.send(DOUBLE, at)
    hands.release(at)
    assert hands.knots()[2][0] == 0.5


def test_without_links_and_with_a_column(hands):
    hands.editor.trigger("link_curves")
    hands.drag("r", 0.5, 0.4)
    hands.release(hands.handle("r", 0.4))
    assert [knots[0] == 0.5 for knots in hands.knots()] == [True, True, False, True, True]
    hands.click(hands.point(0, 3) * 0.5 + hands.point(1, 3) * 0.5)  # a line of the net: K_3
    assert hands.state.focus == hands.state.knot
    assert (hands.state.knot.direction, hands.state.knot.curve) == (Direction.COLUMNS, 3)
    start, end = hands.point(2, 3), hands.point(4, 3)
    at = start + 0.5 * (end - start) + 12 * hands.aside(start, end)  # the chord's middle is the control point itself
    hands.press(at)
    hands.move(at + 0.1 * (end - start))
    hands.release(at + 0.1 * (end - start))
    assert hands.knots(Direction.COLUMNS)[3][3] == pytest.approx(0.6, abs=0.006)
    assert hands.knots(Direction.COLUMNS)[2][3] == 0.5


def test_edits_that_wait_do_not_keep_a_hand_from_the_document(hands):
    hands.editor.trigger("live")
    hands.drag("r", 0.5, 0.4)
    hands.release(hands.handle("r", 0.4))
    assert hands.knots()[2][0] == pytest.approx(0.4, abs=0.006)
    assert hands.state.is_stale
    hands.drag("r", hands.knots()[2][0], 0.3)  # the handle is where the document's knot is
    hands.release(hands.handle("r", 0.3))
    assert hands.knots()[2][0] == pytest.approx(0.3, abs=0.006)


def menu_at(hands, at):
    hands.send(PRESS, at, RIGHT, RIGHT)
    hands.send(RELEASE, at, RIGHT, NO_BUTTON)
    (menu,) = (each for each in hands.editor.window.findChildren(QMenu) if each.objectName().startswith("context."))
    texts = {action.text(): action for action in menu.actions()}
    return menu, texts


def test_the_menus_of_a_handle_and_of_a_line_of_the_net(hands):
    hands.editor.trigger("link_curves")
    hands.editor.type_into("row_knots.C_2.r", "0.3")
    menu, texts = menu_at(hands, hands.handle("r", 0.3))
    assert menu.objectName() == "context.knot"
    texts["Set rᵢₚ to 0.3 on all curves C₀ to C₄"].trigger()
    hands.editor.settle()
    assert [knots[0] for knots in hands.knots()] == [0.3] * 5
    menu.close()
    hands.editor.settle()
    menu, texts = menu_at(hands, hands.handle("r", 0.3))
    texts["Reset rᵢₚ of C₂ to 0.5"].trigger()
    menu.close()
    hands.editor.settle()
    assert [knots[0] for knots in hands.knots()] == [0.3, 0.3, 0.5, 0.3, 0.3]
    menu, texts = menu_at(hands, 0.5 * (hands.point(0, 3) + hands.point(0, 4)))
    texts["Show the knots of C₀"].trigger()
    texts["Set the knots of C₀ on all curves C₀ to C₄"].trigger()
    menu.close()
    hands.editor.settle()
    assert (hands.state.focus.curve, hands.state.focus.direction) == (0, Direction.ROWS)
    assert [knots[0] for knots in hands.knots()] == [0.3] * 5


def test_handles_are_hidden_by_a_command_by_letting_go_and_in_figures(hands, home):
    def seen():
        return hands.view.picture().knot_handles

    def picture():
        path = home / "figure.png"
        hands.view.save_figure(path, FigureOptions(dpi=60))
        return path.read_bytes()

    assert [handle.knot.place.name for handle in seen()] == ["r", "u", "t"]
    with_handles = picture()
    hands.editor.trigger("show_knot_handles")
    assert seen() == []
    assert picture() == with_handles
    hands.editor.trigger("show_knot_handles")
    hands.click((5, 5))
    assert seen() == []
    hands.focus("row_knots.C_2.u")
    hands.viewport.setFocus()
    QTest.keyClick(hands.viewport, Qt.Key.Key_Escape)
    hands.editor.settle()
    assert seen() == []


def test_a_handle_stands_aside_from_its_point_and_gives_way_to_it_when_it_is_clicked_again(hands):
    hands.view.set_camera("top", animated=False)
    hands.editor.settle()
    on = hands.handle("r")  # from above, the middle of the chord lies on P 2,1
    assert on == pytest.approx(hands.point(2, 1), abs=2)
    hands.click(on)
    assert hands.state.selection.points == {(2, 1)}
    hands.click(by(5, 5))
    hands.focus("row_knots.C_2.u")
    at = on + 5 * hands.aside(hands.point(2, 0), hands.point(2, 2))  # in reach of either
    hands.click(at)
    assert not hands.state.selection.points
    assert hands.state.knot.name == "r"
    hands.click(at)
    assert hands.state.selection.points == {(2, 1)}
    assert hands.view.picture().knot_handles == []
