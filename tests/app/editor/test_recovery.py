"""What a crash leaves: whole files, and the last document that was set."""

import os
import random
import signal
import subprocess
import sys
import time
import zipfile
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtTest import QTest

from qovr_app.state.intents import Opened, PointsMoved
from qovr_app.window.recovery import recovery_folder
from qovr_core.files import read_document, write_document
from qovr_core.files.qovr_document import document_from_json
from qovr_core.joints import Joint
from qovr_core.presets import preset
from support.editor import opened_windows, wait_until
from support.jobs import report_until_cancelled
from support.nets import random_net_document
from support.working import children

TESTS = Path(__file__).resolve().parents[2]
KILLS = int(os.environ.get("QOVR_KILLS", "4"))
"""How many; `make fuzz` does more."""


def start_victim(home, seed):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path])}
    command = [sys.executable, "-m", "support.victim", str(home), str(seed)]
    return subprocess.Popen(command, env=environment, stdout=subprocess.PIPE, text=True)


def crash(editor, home):
    """Leave a window as a dead process would: with its recovery file and no living owner."""
    QTest.qWait(400)
    for lock in recovery_folder().glob("*.lock"):
        lock.unlink()
    editor.settle()


def recovery_files():
    return sorted(path.name.split(".", 1)[1] for path in recovery_folder().glob("*"))


def test_nothing_is_offered_after_a_regular_end(make_editor):
    first = make_editor()
    first.type_into("row_knots.C_0.r", "0.3")
    QTest.qWait(400)
    assert recovery_files() == ["lock", "unsaved"]
    first.discard()
    assert recovery_files() == []
    assert not make_editor().find("recovery").isVisible()


def test_a_crashed_document_is_offered_and_restored(make_editor, home):
    first = make_editor()
    first.type_into("control_points.P_2_2.z", repr(1 / 3))
    crash(first, home)
    second = make_editor()
    assert "Unsaved changes to fig5" in second.find("recovery.text").text()
    assert second.document == preset("fig5").document
    second.click("recovery.restore")
    assert second.document == first.document
    assert second.window.isWindowModified()
    assert second.disagreements() == []
    assert not second.find("recovery").isVisible()
    QTest.qWait(400)
    crash(second, home)
    third = make_editor()
    third.click("recovery.discard")
    assert not third.find("recovery").isVisible()
    assert not make_editor().find("recovery").isVisible()


def test_a_net_is_kept_whole_whatever_becomes_of_the_worker(make_editor, home):
    net = random_net_document(3, (3, 4), smooth=0.5)
    first = make_editor()
    first.window.worker.run(report_until_cancelled)
    wait_until(lambda: bool(children()))
    first.dispatch(Opened(net, "net", is_saved=False))
    first.dispatch(PointsMoved(((4, 5),), ((0.0, 0.0, 1 / 3),)))
    os.kill(children()[0], signal.SIGKILL)
    crash(first, home)
    second = make_editor()
    second.click("recovery.restore")
    assert second.document == first.document
    assert Joint.SMOOTH in second.document.joints.u + second.document.joints.v
    assert second.document.control_points[4, 5, 2] == pytest.approx(net.control_points[4, 5, 2] + 1 / 3)


def test_a_living_window_keeps_its_own(make_editor):
    first = make_editor()
    first.type_into("row_knots.C_0.r", "0.3")
    QTest.qWait(400)
    second = make_editor()
    assert not second.find("recovery").isVisible()
    second.type_into("row_knots.C_0.r", "0.7")
    QTest.qWait(400)
    assert recovery_files() == ["lock", "lock", "unsaved", "unsaved"]


def test_each_of_several_documents_is_restored_in_a_window_of_its_own(make_editor, home):
    heights = {0.71, 0.82, 0.93}
    for height in heights:
        lost = make_editor()
        lost.type_into("control_points.P_2_2.z", str(height))
        QTest.qWait(200)
    crash(lost, home)
    editor = make_editor()
    assert "(2 more)" in editor.find("recovery.text").text()
    for _ in heights:
        editor.click("recovery.restore")
    assert not editor.find("recovery").isVisible()
    restored = opened_windows()[-len(heights) :]
    assert restored[0] is editor.window
    assert {window.store.state.document.control_points[2, 2, 2] for window in restored} == heights
    assert all(window.isWindowModified() for window in restored)
    for window in restored[1:]:
        window.leave()


def test_an_offer_that_was_not_answered_is_made_again(make_editor, home):
    first = make_editor()
    first.type_into("row_knots.C_0.r", "0.3")
    crash(first, home)
    make_editor().discard()
    assert make_editor().find("recovery").isVisible()


def test_damaged_recovery_files_are_no_offer(make_editor, home):
    from qovr_app.window.recovery import recovery_folder

    recovery_folder().mkdir(parents=True)
    for number, text in enumerate(("", "[]", "{}", '{"title": "a", "path": 7, "document": {}}', "\x00")):
        (recovery_folder() / f"{number}.unsaved").write_text(text)
    assert not make_editor().find("recovery").isVisible()


@pytest.mark.slow
def test_a_kill_at_any_moment_loses_nothing(make_editor, home):
    random.seed(1)
    write_document(preset("fig5").document, home / "kept.qovr")
    for seed in range(KILLS):
        before = read_document(home / "kept.qovr")
        victim = start_victim(home, seed)
        assert victim.stdout.readline() == "ready\n"
        time.sleep(random.uniform(0.1, 1.5))
        victim.send_signal(signal.SIGKILL)
        report = victim.stdout.read()
        assert victim.wait() == -signal.SIGKILL  # and did not end by itself before
        victim.stdout.close()
        check_exports(home)
        editor = make_editor(str(home / "kept.qovr"))
        if editor.find("recovery").isVisible():
            editor.click("recovery.restore")
        assert editor.document in kept_or_later(report, before)
        assert editor.disagreements() == []
        editor.discard()
        while (other := make_editor()).find("recovery").isVisible():
            other.click("recovery.discard")
        other.discard()


def kept_or_later(report, before):
    """Return the document that was known to be on the disk last, and those that were to be set after it."""
    documents = [before]
    for line in report.splitlines(keepends=True):
        if line == "kept\n":
            documents = documents[-1:]
        elif line.endswith("\n"):
            documents.append(document_from_json(line.removeprefix("set ")))
    return documents


def check_exports(home):
    for path in home.iterdir():
        if path.suffix == ".xlsx":
            with zipfile.ZipFile(path) as book:
                assert book.testzip() is None
        elif path.suffix == ".npz":
            with np.load(path) as arrays:
                assert arrays["raw"].shape == (101, 101, 3)
        elif path.suffix == ".csv":
            assert len(path.read_text().splitlines()) == 101 * 101 + 1
