"""Several windows, one document each: opened, found again, listed, and left together; across processes too."""

import signal
import socket
import subprocess
from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMenu, QMessageBox

from qovr_app.dialogs import question
from qovr_app.main import open_windows
from qovr_app.state.intents import ValuesEdited
from qovr_app.state.requests import SourceAsked
from qovr_app.window import post as post_module
from qovr_app.window.post import Post
from qovr_app.window.process_lock import Hold
from qovr_app.window.windows import is_untouched
from qovr_core.edits import CoordinatePlace
from qovr_core.files import read_document, write_document
from support.command import QOVR
from support.documents import random_document
from support.editor import opened_windows


@pytest.fixture
def files(home):
    paths = [home / name for name in ("one.qovr", "two.qovr", "three.qovr")]
    for k, path in enumerate(paths):
        write_document(random_document(k), path)
    return paths


@pytest.fixture
def others(editor):
    """The windows besides the editor's own."""
    return lambda: [window for window in opened_windows() if window is not editor.window]


@pytest.fixture
def answers(monkeypatch):
    """Questions are answered by these buttons, one after the other, and say what they asked."""
    waiting, asked = [], []

    def answer(_parent, _title, text, *_others):
        asked.append(text)
        return waiting.pop(0)

    monkeypatch.setattr("qovr_app.window.document_shell.ask", answer)
    return waiting, asked


def documents(windows):
    return [window.store.state.document for window in windows]


def test_a_file_opens_in_an_untouched_window_and_beside_one_in_use(editor, files, others, monkeypatch):
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_args: (str(files[0]), ""))
    editor.trigger("open_elsewhere")
    assert editor.document == random_document(0)
    assert others() == []
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_args: (str(files[1]), ""))
    editor.trigger("open_elsewhere")
    assert editor.document == random_document(0)
    assert documents(others()) == [random_document(1)]
    (other,) = others()
    assert other.geometry().topLeft() != editor.window.geometry().topLeft()
    assert not other.store.state.is_changed


def test_a_file_that_another_window_has_open_is_shown_there(editor, files, others, spin):
    editor.dispatch(SourceAsked(str(files[0])))
    editor.trigger("new_window")
    (other,) = others()
    link = files[0].with_name("link.qovr")
    link.symlink_to(files[0])
    for name in (files[0], link):
        other.activateWindow()
        spin(other.isActiveWindow)
        other.store.dispatch(SourceAsked(str(name)))
        spin(editor.window.isActiveWindow)
    assert len(others()) == 1
    assert is_untouched(other.store.state)


def test_no_window_saves_over_the_file_of_another(editor, files, others, monkeypatch):
    editor.dispatch(SourceAsked(str(files[0])))
    editor.trigger("new_window")
    (other,) = others()
    monkeypatch.setattr("qovr_app.window.document_shell.ask_for_target", lambda *_args: files[0])
    other.findChild(type(editor.action("save_as")), "save_as").trigger()
    assert "one.qovr is open in another window" in other.store.state.message.text
    assert read_document(files[0]) == random_document(0)


def test_the_menu_lists_the_windows_and_brings_one_forward(editor, files, others, spin):
    editor.dispatch(SourceAsked(str(files[0])))
    editor.dispatch(SourceAsked(str(files[1]), elsewhere=True))
    editor.type_into("control_points.P_2_2.z", "0.7")
    menu = editor.find("menu.window", QMenu)
    menu.aboutToShow.emit()
    listed = [action for action in menu.actions() if action.objectName().startswith("window.")]
    assert [action.text() for action in listed] == ["&1  one.qovr *", "&2  two.qovr"]
    assert [action.isChecked() for action in listed] == [True, False]
    listed[1].trigger()
    (other,) = others()
    spin(other.isActiveWindow)
    other.findChild(type(listed[0]), "next_window").trigger()
    spin(editor.window.isActiveWindow)
    menu.aboutToShow.emit()
    assert sum(action.objectName().startswith("window.") for action in menu.actions()) == 2


def test_quit_asks_for_each_changed_window_and_cancel_keeps_all(editor, files, others, answers):
    waiting, asked = answers
    editor.dispatch(SourceAsked(str(files[0])))
    for path in files[1:]:
        editor.dispatch(SourceAsked(str(path), elsewhere=True))
    second, third = others()
    editor.type_into("control_points.P_2_2.z", "0.7")
    third.store.dispatch(ValuesEdited({CoordinatePlace(2, 2, 2): 0.7}))
    waiting[:] = [question.Answer.Discard, question.Answer.Cancel]
    second.findChild(type(editor.action("quit")), "quit").trigger()
    assert [text.splitlines()[0] for text in asked] == [f"Save the changes to {files[k].name}?" for k in (0, 2)]
    assert len(opened_windows()) == 3
    assert editor.window.isWindowModified()
    waiting[:] = [QMessageBox.StandardButton.Discard, QMessageBox.StandardButton.Save]
    editor.trigger("quit")
    assert open_windows().all == ()
    assert read_document(files[0]) == random_document(0)
    assert read_document(files[2]).control_points[2, 2, 2] == 0.7


@pytest.fixture
def post(app, home):
    made = Post()
    yield made
    made.close()


def test_a_later_start_hands_its_files_to_the_one_that_runs(post, files, spin):
    came = []
    post.came.connect(came.append)
    assert not post.is_handed_over([])
    call = [QOVR, "two.qovr", "paper:fig8"]
    later = subprocess.Popen(call, stderr=subprocess.PIPE, text=True, cwd=files[0].parent)
    spin(lambda: later.poll() is not None)
    assert (later.returncode, later.stderr.read()) == (0, "")
    later.stderr.close()
    spin(lambda: bool(came))
    assert came == [(str(files[1]), "paper:fig8")]


def test_what_a_dead_process_left_is_no_hindrance_and_one_that_hangs_is_not_waited_for(post, spin, monkeypatch):
    address = post._address
    with socket.socket(socket.AF_UNIX) as left:
        left.bind(address)
    assert not post.is_handed_over([])
    monkeypatch.setattr(post_module, "_PATIENCE_SECONDS", 0.3)
    assert not Post().is_handed_over(["paper:fig5"])  # nobody lets the first one answer here
    assert Path(address).stat().st_mode & 0o077 == 0
    post.close()
    holder = Post()
    assert holder._lock.take() is Hold.OURS
    assert not Post().is_handed_over([])
    holder.close()


def is_answered(address):
    """Return whether a process listens and its event loop runs: what is no message is hung up on."""
    with socket.socket(socket.AF_UNIX) as caller:
        try:
            caller.connect(address)
            caller.sendall(b"\n")
            caller.settimeout(0.2)
            return caller.recv(9) == b""
        except OSError:
            return False


def test_the_command_opens_a_window_once_and_ends_at_once_where_one_runs(app, files, post, spin):
    first = subprocess.Popen([QOVR, "one.qovr"], cwd=files[0].parent, stderr=subprocess.PIPE, text=True)
    try:
        spin(lambda: is_answered(post._address))
        call = [QOVR, "one.qovr", "two.qovr"]
        run = subprocess.run(call, cwd=files[0].parent, capture_output=True, text=True, check=False, timeout=60)
        assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
        assert first.poll() is None
    finally:
        first.send_signal(signal.SIGTERM)
        assert first.wait(30) == 143
        assert first.stderr.read() == ""
        first.stderr.close()
