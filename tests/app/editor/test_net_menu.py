"""The menu Net by real events: a net grown from the paper's, its joints, and all of it taken back."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QListWidget, QSpinBox

from qovr_app.state.looking_intents import Selected, WindowFocused
from qovr_core import build_patch
from qovr_core.files import read_source
from qovr_core.joints import Joint
from support.hand import Hand
from support.nets import random_net_document
from support.step_reader import StepFile

SMOOTH, SHARP = Joint.SMOOTH, Joint.SHARP


def palette(editor, text):
    """Do the first command that a few letters find, by the keyboard alone; return its line."""
    editor.trigger("palette")
    QTest.keyClicks(QApplication.focusWidget(), text)
    editor.settle()
    line = editor.find("palette.matches", QListWidget).item(0).text()
    editor.key(Qt.Key.Key_Return)
    return line


def note(editor, name):
    return editor.find(f"{name}.note", QLabel).text()


def grown(editor):
    """Grow the paper's net by windows on three sides."""
    editor.trigger("new_paper")
    line = palette(editor, "append after last along u")
    assert line.startswith("Append a window after the last along u")
    editor.trigger("append_before_u")
    editor.trigger("append_after_v")


def creased(editor):
    """Crease the joint after the window in focus, by the dialog."""
    editor.trigger("crease_u")
    assert "moves by at most" in note(editor, "crease")
    (question,) = [label.text() for label in editor.dialog("crease").findChildren(QLabel) if "becomes" in label.text()]
    assert question == "The joint between the windows 1 and 2 along u, on column 5 of the points, becomes a crease."
    assert (editor.document.row_knots.array[:, 1, 3] == 0.3).all()
    field = editor.find("crease.strength", QLineEdit)
    for text in ("0.6", "0.4"):
        field.selectAll()
        QTest.keyClicks(field, text)
        editor.settle()
        assert ("expected a number from 0 to 0.45" in note(editor, "crease")) == (text == "0.6")
    editor.key(Qt.Key.Key_Return, widget=field)


def jump(document):
    """Return how much the surface's derivative jumps at the second joint along u."""
    patch = build_patch(document)
    at, v = patch.breaks[0][1], np.linspace(*patch.domain[1], 9)
    before, after = (patch.derivative([at + step], v, 1, 0) for step in (-1e-9, 0))
    return np.abs(before - after).max()


def test_a_net_of_7_by_9_grows_from_the_papers_and_is_taken_back(editor, tmp_path, monkeypatch):
    grown(editor)
    start = editor.window.store.state.history.first
    assert editor.document.control_points.shape == (7, 9, 3)
    assert editor.document.joints.u == (SMOOTH, SMOOTH)
    assert editor.window.store.state.window == (0, 1)
    assert np.array_equal(editor.document.control_points[:5, 2:7], start.control_points)
    assert editor.message() == "No point of the surface moves."

    editor.type_into("row_knots.C_0.t", "0.4")  # of the window in focus; a smooth joint shares it
    assert (editor.document.row_knots.array[:, [1, 2], [3, 0]] == 0.4).all()
    assert jump(editor.document) < 1e-6
    editor.trigger("sharp_u")
    assert editor.document.joints.u == (SMOOTH, SHARP)
    assert editor.message().endswith("nothing moves yet.")
    creased(editor)
    assert editor.document.row_knots.array[:, 1, 3] == pytest.approx(0.1)
    assert editor.action("undo").text() == "&Undo Crease joint 1 along u"
    assert jump(editor.document) > 0.1

    before = editor.document
    editor.trigger("smooth_u")
    assert "moves by at most" in note(editor, "smooth")
    assert editor.document.joints.u == (SMOOTH, SMOOTH)
    editor.key(Qt.Key.Key_Escape, widget=editor.dialog("smooth"))
    assert editor.document == before
    assert editor.message() == ""
    editor.trigger("smooth_u")
    editor.key(Qt.Key.Key_Return, widget=editor.dialog("smooth"))
    assert editor.document.joints.u == (SMOOTH, SMOOTH)
    assert editor.message().startswith("The surface moves by at most")
    assert not editor.action("smooth_u").isEnabled()
    assert jump(editor.document) < 1e-6

    net = editor.document
    monkeypatch.setattr("qovr_app.window.document_shell.ask_for_target", lambda *_args: tmp_path / "net.qovr")
    editor.trigger("save_as")
    assert read_source(str(tmp_path / "net.qovr")) == net
    while editor.action("undo").isEnabled():
        editor.trigger("undo")
    assert editor.document == start
    while editor.action("redo").isEnabled():
        editor.trigger("redo")
    assert editor.document == net
    assert not editor.window.store.state.is_changed


def test_a_point_on_a_joint_is_pulled_and_the_net_goes_to_cad_in_two_faces(editor, tmp_path, monkeypatch):
    grown(editor)
    assert editor.document.joints.u == (SMOOTH, SMOOTH)
    before = editor.document
    hand = Hand(editor)
    hand.press(hand.place(3, 3))
    hand.move_by(0, -60)
    hand.release()
    pulled = editor.document
    moved = np.argwhere((pulled.control_points != before.control_points).any(axis=-1)).tolist()
    assert moved == [[3, 3]]
    assert pulled.control_points[3, 3, 2] > before.control_points[3, 3, 2]
    changed = (build_patch(pulled).coefficients != build_patch(before).coefficients).any(axis=(2, 3, 4))
    assert changed[:, :2].all()  # on both sides of the joint
    assert not changed[:, 2].any()
    assert jump(pulled) < 1e-6

    editor.dispatch(WindowFocused((0, 1)))
    editor.trigger("sharp_u")
    creased(editor)
    monkeypatch.setattr("qovr_app.window.document_shell.ask_for_target", lambda *_args: tmp_path / "net.qovr")
    editor.trigger("save_as")
    again = read_source(str(tmp_path / "net.qovr"))
    assert again == editor.document
    editor.export_to(tmp_path / "net.step")
    faces = StepFile(tmp_path / "net.step").surfaces()
    assert len(faces) == 2  # one on each side of the crease


def test_what_needs_windows_that_meet_says_so_and_the_way_out_is_in_the_menu(editor):
    names = ["append_after_u", "append_before_v", "insert_u", "resample"]
    assert not any(editor.action(name).isEnabled() for name in names)
    editor.trigger("palette")
    QTest.keyClicks(QApplication.focusWidget(), "append after last along u")
    editor.settle()
    line = editor.find("palette.matches", QListWidget).item(0).text()
    assert "Choose the interpolating formulation first" in line
    editor.key(Qt.Key.Key_Escape)
    editor.trigger("make_interpolating")
    assert all(editor.action(name).isEnabled() for name in names)
    assert not editor.action("make_interpolating").isEnabled()
    for name in ("smooth_u", "crease_v", "remove_u", "extract_window"):
        assert not editor.action(name).isEnabled()


def test_a_grey_command_says_in_its_tip_what_it_needs(editor):
    action = editor.action("append_after_u")
    assert not action.isEnabled()
    assert "\nChoose the interpolating formulation first (in the menu Net)" in action.toolTip()
    editor.trigger("make_interpolating")
    assert action.isEnabled()
    assert action.toolTip() == action.statusTip()


def test_commands_act_on_the_window_in_focus(editor):
    from qovr_app.state.intents import Opened

    document = random_net_document(2, (2, 3), smooth=0.0, flatness=0.3)
    editor.dispatch(Opened(document, "net"))
    editor.dispatch(WindowFocused((1, 1)))
    editor.dispatch(Selected((4, 6)))
    assert not editor.action("remove_v").isEnabled()  # no window lies after it along v
    editor.trigger("insert_u")
    assert editor.document.windows == (2, 4)
    assert editor.window.store.state.selection.last == (4, 8)
    editor.trigger("remove_u")
    assert np.array_equal(editor.document.control_points, document.control_points)
    editor.trigger("extract_window")
    assert editor.document.windows == (1, 1)
    assert np.array_equal(editor.document.control_points, document.control_points[2:7, 2:7])
    editor.trigger("undo")
    for name in ("reverse_u", "reverse_v", "transpose", "mirror_x"):
        editor.trigger(name)
        assert editor.action("undo").isEnabled()
    assert editor.document.windows == (3, 2)
    editor.trigger("knots_chord_length_u")
    assert set(editor.document.joints.u) == {SMOOTH}
    assert editor.message().startswith("The surface moves by at most")


def test_another_net_is_run_through_the_surface_and_seen_before_it_is_taken(editor):
    editor.trigger("new_wave")
    wave = editor.document
    editor.trigger("resample")
    for letter, count in (("u", 3), ("v", 2)):
        box = editor.find(f"resample.{letter}", QSpinBox)
        box.setValue(count)
    editor.settle()
    assert editor.document.windows == (2, 3)
    assert "moves by at most" in note(editor, "resample")
    editor.key(Qt.Key.Key_Escape, widget=editor.dialog("resample"))
    assert editor.document == wave
    editor.trigger("resample")
    editor.find("resample.u", QSpinBox).setValue(4)
    editor.dialog("resample").accept()
    editor.settle()
    assert editor.document.windows == (1, 4)
    assert editor.action("undo").text() == "&Undo Resample the net"
    editor.trigger("undo")
    assert editor.document == wave
