"""Selections of several points, and the commands and tools that move them."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QApplication, QDialog

from support.hand import ALT, CONTROL

from .gesture import Table

TABLE = Table()


def _add_selections():
    wanted = {
        "all points": (("select_all",), 25),
        "the others": (("select_invert",), 23),
        "the rows": (("select_rows",), 10),
        "the columns": (("select_columns",), 10),
        "none": (("select_none",), 0),
    }
    for what, ((command,), count) in wanted.items():

        @TABLE(f"of two selected points, select {what}")
        def _(hand, command=command, count=count):
            hand.select((0, 1), (4, 2))
            hand.editor.trigger(command)
            hand.show()
            assert len(hand.selected) == count
            if command != "select_invert" and count:
                assert hand.picked_last == (4, 2)


_add_selections()


@TABLE("Ctrl+M moves the selected points by exact numbers")
def _(hand):
    hand.select((4, 2), (0, 1), (0, 2))
    before = hand.net
    hand.tap(Qt.Key.Key_M, CONTROL)
    dialog = hand.editor.dialog("transform")
    assert dialog.windowTitle() == "Transform 3 points"
    hand.type("0.1")
    hand.show(dialog.geometry().center())
    hand.tap(Qt.Key.Key_Return)
    assert hand.editor.window.findChild(QDialog, "transform") is None
    moved = (hand.net - before).round(12)
    assert np.argwhere(moved).tolist() == [[0, 1, 2], [0, 2, 2], [4, 2, 2]]
    assert moved[moved != 0].tolist() == [0.1, 0.1, 0.1]
    assert len(hand.steps) == 1


@TABLE("what is no number is refused in the dialog, and Escape leaves all as it was")
def _(hand):
    hand.select((4, 2), (0, 1))
    hand.tap(Qt.Key.Key_M, CONTROL)
    dialog = hand.editor.dialog("transform")
    hand.type("abc")
    hand.tap(Qt.Key.Key_Return)
    hand.show(dialog.geometry().center())
    assert dialog.isVisible()
    assert "abc" in hand.editor.find("transform.note").text()
    for _ in range(2):  # the field's own text, then the dialog
        hand.tap(Qt.Key.Key_Escape)
    assert hand.editor.window.findChild(QDialog, "transform") is None
    assert hand.editor.document == hand.state.history.first


@TABLE("Ctrl+M scales and rotates about the point picked last")
def _(hand):
    hand.select((0, 1), (0, 2), (0, 0))
    before = hand.net
    hand.tap(Qt.Key.Key_M, CONTROL)
    dialog = hand.editor.dialog("transform")
    for name, text in {"transform.scale.x": "2", "transform.rotate": "90"}.items():
        field = hand.editor.field(name)
        field.setFocus()
        field.selectAll()
        hand.type(text)
    about = hand.editor.find("transform.about")
    about.setFocus()
    hand.tap(Qt.Key.Key_Down)
    hand.show(dialog.geometry().center())
    field.setFocus()
    hand.tap(Qt.Key.Key_Return)
    np.testing.assert_allclose(hand.net[0, :3, :2], [[0, 0], [0, 2], [0, 4]], atol=1e-12)
    np.testing.assert_array_equal(hand.net[0, :3, 2], before[0, :3, 2])
    np.testing.assert_array_equal(hand.net[1:], before[1:])


def _add_edits():
    def flat(before, after, points):
        return np.ptp(after[points][:, 2]) < 1e-12 and np.isclose(after[points][0, 2], before[points][:, 2].mean())

    def plane(before, after, points):
        middle = after[points] - after[points].mean(axis=0)
        return np.linalg.svd(middle)[1][-1] < 1e-9 < np.linalg.svd(before[points] - before[points].mean(axis=0))[1][-1]

    def aligned(axis):
        return lambda before, after, points: (after[points][:, axis] == before[4, 2, axis]).all()

    def smoother(before, after, points):
        def rough(net):
            return np.abs(np.diff(net[..., 2], n=2, axis=0)).sum() + np.abs(np.diff(net[..., 2], n=2, axis=1)).sum()

        return rough(after) < rough(before)

    edits = {
        "flatten_height": ("flattened to their mean height", flat),
        "flatten_plane": ("flattened to their best plane", plane),
        "align_x": ("aligned to the x of the last", aligned(0)),
        "align_y": ("aligned to the y of the last", aligned(1)),
        "align_z": ("aligned to the z of the last", aligned(2)),
        "smooth_points": ("smoothed", smoother),
    }
    for command, (what, holds) in edits.items():

        @TABLE(f"selected points are {what}")
        def _(hand, command=command, holds=holds):
            hand.select((0, 0), (0, 1), (2, 0), (0, 3), (4, 2))
            hand.editor.window.view.viewports[0].widget.setFocus()
            hand.tap(Qt.Key.Key_PageUp, ALT)
            before, chosen = hand.net, tuple(np.array(sorted(hand.selected)).T)
            hand.editor.trigger(command)
            hand.show()
            assert holds(before, hand.net, chosen)
            others = np.ones(before.shape[:2], dtype=bool)
            others[chosen] = False
            np.testing.assert_array_equal(hand.net[others], before[others])
            assert len(hand.steps) == 2


_add_edits()


@TABLE("F4 repeats the last edit with what is selected now")
def _(hand):
    hand.select((0, 1), (0, 2), (0, 3))
    hand.editor.trigger("smooth_points")
    hand.select((0, 4), (4, 2))
    hand.tap(Qt.Key.Key_F4)
    hand.show()
    assert hand.steps == ["Smooth 3 points", "Smooth 2 points"]


@TABLE("a soft drag lets the points around follow, by smoothstep of the steps along the net")
def _(hand):
    hand.editor.trigger("soft")
    before = hand.net
    hand.press(hand.place(4, 2))
    hand.move_by(0, -50)
    hand.show()
    hand.release()
    moved = (hand.net - before)[..., 2]
    steps = np.add.outer(4 - np.arange(5), abs(np.arange(5) - 2)) / 2
    share = np.clip(1 - steps, 0, 1)
    assert moved[4, 2] > 0
    np.testing.assert_allclose(moved / moved[4, 2], share**2 * (3 - 2 * share), atol=1e-9)
    assert hand.steps == ["Move P 4,2"]


def _add_symmetries():
    cases = {
        "columns": (("symmetry_columns",), lambda net: net[:, ::-1], 0, [(0, 1), (0, 3)]),
        "rows": (("symmetry_rows",), lambda net: net[::-1], 1, [(0, 1), (4, 1)]),
        "rows and columns": (
            ("symmetry_columns", "symmetry_rows"),
            lambda net: net[::-1, ::-1],
            None,
            [(0, 1), (0, 3), (4, 1), (4, 3)],
        ),
    }
    for what, (commands, mirror, axis, points) in cases.items():

        @TABLE(f"symmetry across {what}: the mirror image moves along")
        def _(hand, commands=commands, mirror=mirror, axis=axis, points=points):
            hand.editor.trigger("move_view")
            for command in commands:
                hand.editor.trigger(command)
            before = hand.net
            hand.press(hand.place(0, 1))
            hand.move_by(-20, -40)
            hand.show()
            hand.release()
            moved = hand.net - before
            assert {(i, j) for i, j, _ in np.argwhere(moved).tolist()} == set(points)
            image = mirror(moved)
            for k in range(3):
                sign = -1 if k == axis or (axis is None and k < 2) else 1
                np.testing.assert_allclose(moved[..., k], sign * image[..., k], atol=1e-12)


_add_symmetries()


@TABLE("Make symmetric from one side: the other becomes its mirror image, in one undo")
def _(hand):
    hand.drag(hand.place(0, 1), 0, -40)
    hand.editor.trigger("symmetric_columns_first")
    hand.show()
    z = hand.net[..., 2]
    np.testing.assert_array_equal(z, z[:, ::-1])
    assert z[0, 3] != pytest.approx(0.4)
    assert len(hand.steps) == 2


@TABLE("Ctrl+Z and Ctrl+Shift+Z go back and forward with the keyboard in the view")
def _(hand):
    hand.drag(hand.place(4, 2), 0, -40)
    moved = hand.net
    hand.tap(Qt.Key.Key_Z, CONTROL)
    assert hand.editor.document == hand.state.history.first
    hand.editor.trigger("redo")
    hand.show()
    np.testing.assert_array_equal(hand.net, moved)
    assert QApplication.focusWidget() is hand.viewport
