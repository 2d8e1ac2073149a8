"""The program starts whatever has become of the places it keeps things in, and asks no disk that nobody wants."""

import os
import stat
import subprocess
import sys
import threading
from pathlib import Path

import pytest
from PySide6.QtCore import QRect, QSettings
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMenu

from qovr_app.window.placing import fitted
from qovr_app.window.preferences import Preferences
from qovr_app.window.recovery import RecoveryStore, recovery_folder
from qovr_app.window.recovery_file import Snapshot
from qovr_core.files import write_document
from qovr_core.presets import preset
from support.editor import wait_until
from support.recovery_reader import kept_in

FIG5 = preset("fig5").document


def as_file(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("no folder")


def as_link_to_itself(path):
    path.parent.mkdir(parents=True, exist_ok=True)
    path.symlink_to(path)


@pytest.mark.parametrize("make", [as_file, as_link_to_itself], ids=lambda make: make.__name__)
@pytest.mark.parametrize("place", ["", ".."])
def test_a_misplaced_store_is_no_obstacle(make_editor, make, place):
    make(Path(os.path.normpath(recovery_folder() / place)))
    editor = make_editor()
    editor.type_into("row_knots.C_0.r", "0.3")
    wait_until(lambda: "A crash would lose the unsaved changes" in editor.message())
    editor.mark_saved()
    assert editor.window.close()


def test_a_store_that_may_only_be_read_still_offers(make_editor, monkeypatch):
    RecoveryStore().keep(Snapshot(FIG5, "theirs"))
    for lock in recovery_folder().glob("*.lock"):
        lock.unlink()
    opened = os.open

    def only_reading(path, flags, *more):
        if flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT) and str(recovery_folder()) in str(path):
            raise PermissionError(13, "Permission denied", str(path))
        return opened(path, flags, *more)

    monkeypatch.setattr(os, "open", only_reading)
    assert make_editor().find("recovery").isVisible()


DAMAGED = {
    "empty": b"",
    "binary": bytes(range(256)),
    "list": b"[]",
    "deep": b"[" * 100_000,
    "number": b'{"title": "a", "path": 7, "document": {}}',
    "huge number": b'{"title": "a", "path": null, "document": ' + b"9" * 5000 + b"}",
}


def test_damaged_recovery_files_are_set_aside_and_the_others_offered(make_editor):
    store = RecoveryStore()
    store.keep(Snapshot(FIG5, "whole"))
    store.release()
    for name, content in DAMAGED.items():
        (recovery_folder() / f"{name}.unsaved").write_bytes(content)
    (recovery_folder() / "folder.unsaved").mkdir()
    os.mkfifo(recovery_folder() / "pipe.unsaved")
    editor = make_editor()
    assert "Unsaved changes to whole" in editor.find("recovery.text").text()
    assert "was set aside as" in editor.message()
    aside = {path.name.removesuffix(".unsaved.damaged") for path in recovery_folder().glob("*.damaged")}
    assert aside == {*DAMAGED, "folder", "pipe"}


@pytest.mark.parametrize(
    "text",
    [
        "1\npython3\nhere\n",
        f"{os.getpid()}\nsomething else\nhere\n",
        "4194303\npython3\nanother-computer\n",
        "",
        "\x00",
    ],
    ids=["first process", "reused number", "other computer", "empty", "binary"],
)
def test_a_stale_lock_keeps_nothing_back(make_editor, text):
    RecoveryStore().keep(Snapshot(FIG5, "theirs"))
    (lock,) = recovery_folder().glob("*.lock")
    lock.unlink()
    lock.write_text(text)
    assert make_editor().find("recovery").isVisible()


def test_a_lock_of_a_living_process_is_respected(make_editor):
    code = (
        "import sys\nfrom pathlib import Path\nfrom qovr_app.window.recovery import RecoveryStore\n"
        "from qovr_app.window.recovery_file import Snapshot\nfrom qovr_core.presets import preset\n"
        "store = RecoveryStore(Path(sys.argv[1]))\nstore.keep(Snapshot(preset('fig5').document, 'theirs'))\n"
        "print('kept', flush=True)\nsys.stdin.read()\n"
    )
    call = [sys.executable, "-c", code, str(recovery_folder())]
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)}
    with subprocess.Popen(call, env=environment, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as other:
        assert other.stdout.readline() == "kept\n"
        assert not make_editor().find("recovery").isVisible()
        other.kill()
        other.wait()
        assert make_editor().find("recovery").isVisible()


def test_the_old_recovery_file_goes_after_the_new_one_is_there(make_editor, monkeypatch):
    store = RecoveryStore()
    store.keep(Snapshot(FIG5, "theirs"))
    store.release()
    editor = make_editor()

    def full(*_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(RecoveryStore, "keep", full)
        editor.click("recovery.restore")
        wait_until(lambda: "A crash would lose" in editor.message())
        assert len(list(recovery_folder().glob("*.unsaved"))) == 1
    editor.type_into("row_knots.C_0.r", "0.3")
    QTest.qWait(300)
    (kept,) = recovery_folder().glob("*.unsaved")
    _, (document,) = kept_in(kept)
    assert document["row_knots"][0, 0, 0] == 0.3


def settings_file():
    return Path(QSettings("qovr", "QOVR Studio").fileName())


@pytest.mark.parametrize("content", [b"\x00\xff\xfe" * 100, b"[view\nstyle=wire\n=\n", b"[[[[", b"recent=@Invalid()\n"])
def test_damaged_preferences_are_no_obstacle(make_editor, content):
    settings_file().parent.mkdir(parents=True, exist_ok=True)
    settings_file().write_bytes(content)
    editor = make_editor()
    editor.trigger("style_wireframe")
    editor.discard()
    again = make_editor()
    assert again.action("style_wireframe").isChecked()


def test_misplaced_preferences_are_no_obstacle(make_editor):
    settings_file().mkdir(parents=True)
    editor = make_editor()
    assert "preferences" in editor.message()
    editor.trigger("style_wireframe")
    assert editor.action("style_wireframe").isChecked()


def test_nonsense_in_the_preferences_counts_as_never_set(make_editor):
    store = Preferences()._store
    for key in ("folder", "recent", "window/geometry", "window/workspace", "view/style", "export/unit"):
        store.setValue(key, ["a\x00b", "", "relative"])
    store.sync()
    editor = make_editor()
    menu = editor.find("menu.recent", QMenu)
    menu.aboutToShow.emit()
    assert editor.window.isVisible()


def test_two_copies_share_the_preferences(make_editor, home):
    first, second = make_editor(), make_editor()
    first.trigger("style_wireframe")
    second.trigger("show_labels")
    write_document(FIG5, home / "a.qovr")
    write_document(FIG5, home / "b.qovr")
    first.mark_saved()
    Preferences().add_recent(home / "a.qovr")
    Preferences().add_recent(home / "b.qovr")
    second.discard()
    first.discard()
    third = make_editor()
    assert third.action("style_wireframe").isChecked()
    assert not third.action("show_labels").isChecked()
    assert [path.name for path in Preferences().recent] == ["b.qovr", "a.qovr"]


def test_a_share_that_does_not_answer_is_not_asked_before_somebody_wants_it(make_editor, monkeypatch, tmp_path):
    share = tmp_path / "share"
    preferences = Preferences()
    preferences.folder = share
    for k in range(3):
        preferences.add_recent(share / f"{k}.qovr")
    asked, answers = [], threading.Event()

    def hanging(original):
        def ask(path, *more, **options):
            if str(share) in str(path):
                asked.append(path)
                answers.wait(20)
            return original(path, *more, **options)

        return ask

    for name in ("stat", "lstat", "open", "scandir"):
        monkeypatch.setattr(os, name, hanging(getattr(os, name)))
    editor = make_editor()
    menu = editor.find("menu.recent", QMenu)
    menu.aboutToShow.emit()
    assert [action.text()[-6:] for action in menu.actions()[:3]] == ["2.qovr", "1.qovr", "0.qovr"]
    editor.settle()
    assert asked == []
    answers.set()


def test_a_window_from_a_larger_screen_fits_the_present_one():
    room = QRect(0, 0, 1366, 768)
    for place in (QRect(1900, 1000, 1440, 900), QRect(-3000, -50, 800, 600), QRect(0, 0, 5000, 3000)):
        assert room.contains(fitted(place, room))
    assert fitted(QRect(100, 100, 800, 600), room) == QRect(100, 100, 800, 600)


def test_a_file_that_cannot_be_read_opens_the_window_and_is_said(make_editor, home):
    (home / "bad.qovr").write_text("{")
    for source in (home / "bad.qovr", home / "missing.qovr", home, "paper:fig99", home / "picture.jpg"):
        editor = make_editor(str(source))
        assert editor.document == FIG5
        assert editor.message()
        assert editor.window.windowTitle().startswith("fig5")


def test_the_mode_of_a_recovery_file_is_the_user_s(make_editor):
    editor = make_editor()
    editor.type_into("row_knots.C_0.r", "0.3")
    wait_until(lambda: bool(list(recovery_folder().glob("*.lock"))))
    (lock,) = recovery_folder().glob("*.lock")
    assert stat.S_IMODE(lock.stat().st_mode) & 0o077 == 0
