"""Random actions: no exception, no Qt warning, and fields that always agree with the document."""

import math
import os
import random

import pytest
from PySide6.QtCore import QPoint, Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QComboBox

from qovr_app.window.commands import command_table
from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, name_of
from support.mouse import CONTROL, NONE, SHIFT, Mouse

ACTIONS = int(os.environ.get("QOVR_ACTIONS", "200"))
"""How many of each seed; `make fuzz` does more."""

CHECK_EVERY = 20
NAMES = [name_of(place) for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS)]
NUMBERS = ["0.5", "0,25", "0.875", "1", "0", "-3", "12.5", "1e-3", "1e300", "", "abc", "0.1\t0.2", "0.3333333333333333"]
HEADINGS = ["row_knots.C_2", "row_knots.t", "column_knots.K_0", "control_points.row_1", "control_points.column_4"]
ENDING = {"close", "quit"}
"""Commands that end the window."""

ANSWER_AFTER = 20
"""Milliseconds after which a question is left by Escape."""

BUTTONS = [f"{zone}.{verb}" for zone in ("row_knots", "column_knots", "control_points") for verb in ("get", "set")]
KEYS = [Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_PageUp, Qt.Key.Key_Escape, Qt.Key.Key_Tab, Qt.Key.Key_Return]


def type_into_a_field(editor, rng):
    field = editor.fields[rng.choice(NAMES)]
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, rng.choice(NUMBERS))
    if rng.random() < 0.8:
        QTest.keyClick(field, rng.choice(KEYS))


def press_keys_in_a_field(editor, rng):
    field = editor.fields[rng.choice(NAMES)]
    field.setFocus()
    for _ in range(rng.randrange(1, 4)):
        QTest.keyClick(field, rng.choice(KEYS))


def move_a_slider(editor, rng):
    slider = editor.find(rng.choice(["row_knots.slider", "column_knots.slider"]))
    QTest.keyClick(slider, rng.choice([Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Home, Qt.Key.Key_PageUp]))


def press_a_button(editor, rng):
    QTest.mouseClick(editor.find(rng.choice(BUTTONS), QAbstractButton), Qt.MouseButton.LeftButton)


def run_a_command(editor, rng):
    name = rng.choice(editor.commands)
    if name.startswith(("preset", "new")):
        if rng.random() < 0.7:
            return
        editor.mark_saved()
    editor.action(name).trigger()


def leave_questions():
    """Press Escape in whatever asks something, or lies over the window."""
    asking = QApplication.activeModalWidget() or QApplication.activePopupWidget()
    if asking is not None:
        QTest.keyClick(asking, Qt.Key.Key_Escape)


def choose_a_formulation(editor, rng):
    QTest.keyClick(editor.find("surface.formulation", QComboBox), rng.choice([Qt.Key.Key_Up, Qt.Key.Key_Down]))


def type_samples(editor, rng):
    field = editor.field(rng.choice(["surface.samples_u", "surface.samples_v"]))
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, rng.choice(["2", "3", "41", "1", "5000", "x"]))
    QTest.keyClick(field, Qt.Key.Key_Return)


def drag_a_point(editor, rng):
    viewport = editor.window.view.viewports[0]
    picture = editor.window.view.picture()
    if picture is None:
        return
    spots = picture.camera.project(picture.scene.points.reshape(-1, 3), viewport.logical_size)
    x, y = rng.choice(spots.tolist())[:2]
    if not math.isfinite(x):
        return  # it lies behind the eye
    at = QPoint(round(x), round(y))
    if not viewport.widget.rect().contains(at):
        return
    QTest.mousePress(viewport.widget, Qt.MouseButton.LeftButton, pos=at)
    for _ in range(rng.randrange(4)):
        at += QPoint(rng.randrange(-9, 10), rng.randrange(-9, 10))
        QTest.mouseMove(viewport.widget, at)
        if rng.random() < 0.2:
            QTest.keyClick(viewport.widget, rng.choice([Qt.Key.Key_Escape, Qt.Key.Key_X, Qt.Key.Key_Z]))
        if rng.random() < 0.1:
            run_a_command(editor, rng)
    QTest.mouseRelease(viewport.widget, Qt.MouseButton.LeftButton, pos=at)


def drag_a_number(editor, rng):
    mouse = Mouse(editor, rng.choice([*NAMES, *HEADINGS]))
    for _ in range(rng.randrange(4)):
        mouse.move(rng.randrange(-40, 41), modifiers=rng.choice([NONE, SHIFT, CONTROL]))
        if rng.random() < 0.2:
            QTest.keyClick(QApplication.focusWidget() or editor.window, rng.choice(KEYS))
        if rng.random() < 0.1:
            mouse.press_right()
        if rng.random() < 0.1:
            run_a_command(editor, rng)
    mouse.release()


def change_the_size(editor, rng):
    editor.window.resize(rng.randrange(900, 1600), rng.randrange(560, 1000))


ACTS = [
    *(type_into_a_field,) * 3,
    press_keys_in_a_field,
    move_a_slider,
    press_a_button,
    run_a_command,
    choose_a_formulation,
    type_samples,
    drag_a_point,
    drag_a_number,
    change_the_size,
]


@pytest.mark.slow
@pytest.mark.parametrize("seed", [1, 2])
def test_random_actions(make_editor, seed):
    rng = random.Random(seed)
    editor = make_editor(size=(900, 560))
    editor.fields = {name: editor.field(name) for name in NAMES}
    names = [command.name for command in command_table() if command.name not in ENDING]
    editor.commands = [*names, *["undo", "redo"] * 6]
    answering = QTimer(editor.window, interval=ANSWER_AFTER)
    answering.timeout.connect(leave_questions)
    answering.start()
    for number in range(ACTIONS):
        rng.choice(ACTS)(editor, rng)
        if number % CHECK_EVERY == 0:
            editor.settle()
            assert editor.disagreements() == [], number
            check_marks(editor)
    while editor.action("undo").isEnabled():
        editor.trigger("undo")
    assert editor.window.store.state.history.undo_text is None
    assert editor.disagreements() == []
    assert QApplication.activeModalWidget() is None


def check_marks(editor):
    state = editor.window.store.state
    assert editor.find("surface.export").isEnabled() == (not state.is_stale)
    assert editor.find("surface.formulation", QComboBox).currentText() == str(editor.document.formulation)
    if editor.action("live").isChecked() and state.evaluation is not None:
        assert state.draft == editor.document
