"""Jobs are ended when they are to end, and go with their window and their program."""

import os
import subprocess
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from qovr_app.work.worker import Worker
from qovr_core.files.drafts import new_draft
from support import jobs
from support.working import Heard, children, is_alive

# Cancelling


def test_a_cancelled_job_ends_at_its_next_report_and_its_process_goes_on(worker, answer, spin, tmp_path):
    heard, ended = Heard(), []
    job = worker.run(jobs.write_until_cancelled, tmp_path / "a", **heard.callbacks())
    spin(lambda: len(heard) > 2, seconds=60)
    assert Path(heard[0][1]).exists()
    (pid,) = children()
    job.cancel(ended.append)
    told = len(heard)
    spin(lambda: ended == [False])
    assert list(tmp_path.iterdir()) == []
    assert answer(jobs.environment).result["pid"] == pid
    assert len(heard) == told


@pytest.mark.parametrize("function", [jobs.write_and_sleep, jobs.compute_for_ever])
def test_a_job_that_never_reports_is_killed_and_leaves_no_drafts(worker, answer, spin, tmp_path, function):
    target = tmp_path / "a"
    values = [target] if function is jobs.write_and_sleep else []
    heard, ended = Heard(), []
    with new_draft(tmp_path) as of_another:
        job = worker.run(function, *values, **heard.callbacks(), target=target)
        spin(lambda: len(heard) == 1, seconds=60)
        (pid,) = children()
        job.cancel(ended.append)
        assert answer(jobs.environment).result["pid"] != pid
        assert ended == [False]
        assert not is_alive(pid)
        assert list(tmp_path.iterdir()) == [of_another]
    assert len(heard) == 1


def test_a_waiting_job_is_cancelled_at_once(worker, spin):
    first, second, third, ended = Heard(), Heard(), Heard(), []
    job = worker.run(jobs.report_until_cancelled, **first.callbacks())
    waiting = worker.run(jobs.add, 1, 2, **second.callbacks())
    worker.run(jobs.add, 3, 4, **third.callbacks())
    waiting.cancel(ended.append)
    assert ended == [False]
    job.cancel()
    spin(lambda: third.is_over)
    assert second == []


def test_who_cancels_too_late_is_told_that_it_was_done(worker, spin):
    heard, ended = Heard(), []
    job = worker.run(jobs.add, 1, 2, **heard.callbacks())
    time.sleep(3)  # it is done by now, but nobody has been told
    job.cancel(ended.append)
    spin(lambda: ended)
    assert ended == [True]
    assert heard == []
    job.cancel(ended.append)
    assert ended == [True]


def test_cancelling_from_a_callback_is_the_end(worker, spin):
    told, ended = [], []

    def hear(value):
        told.append(value)
        job.cancel(ended.append)

    job = worker.run(jobs.report_until_cancelled, on_progress=hear)
    spin(lambda: ended, seconds=60)
    assert told == ["again"]


def test_many_jobs_cancelled_at_random_leave_the_worker_whole(worker, answer, spin):
    rng = np.random.default_rng(1)
    for _ in range(30):
        job = worker.run(jobs.report_until_cancelled)
        spin(int(rng.integers(0, 30)))
        job.cancel()
    assert answer(jobs.add, 1, 2).result == 3
    assert len(children()) == 1


# The end


def test_closing_ends_everything_and_tells_nobody(app, spin, tmp_path):
    before = threading.active_count()
    worker, heard, written = Worker(), Heard(), []
    worker.run(jobs.write_and_sleep, tmp_path / "a", **heard.callbacks(), target=tmp_path / "a")
    worker.run(jobs.add, 1, 2, **heard.callbacks())
    worker.in_thread(lambda: (time.sleep(0.2), written.append("whole")), on_done=heard.append)
    spin(lambda: len(heard) == 1, seconds=60)
    worker.close()
    assert children() == []
    assert threading.active_count() <= before
    assert list(tmp_path.iterdir()) == []
    assert written == ["whole"]
    worker.run(jobs.add, 1, 2, **heard.callbacks()).cancel()
    spin(300)
    assert len(heard) == 1
    assert children() == []
    worker.close()


@pytest.mark.parametrize("end", ["os._exit(0)", "os.kill(os.getpid(), 9)", "app.quit()"])
def test_a_program_that_ends_any_way_takes_the_process_with_it(tmp_path, end):
    code = (
        "import os, pathlib, sys, time\n"
        "from PySide6.QtCore import QCoreApplication\n"
        "from qovr_app.work.worker import Worker\n"
        "from support import jobs\n"
        "app = QCoreApplication([])\n"
        "worker = Worker()\n"
        "def leave(_):\n"
        "    print(worker._process._process.pid, flush=True)\n"
        f"    {end}\n"
        "worker.run(jobs.write_until_cancelled, pathlib.Path(sys.argv[1]), on_progress=leave)\n"
        "app.exec()\n"
    )
    done = subprocess.run(
        [sys.executable, "-c", code, str(tmp_path / "a")],
        env={**os.environ, "PYTHONPATH": os.pathsep.join(sys.path)},
        stdout=subprocess.PIPE,
        text=True,
        timeout=60,
        check=False,
    )
    pid = int(done.stdout.split()[0])
    end_by = time.monotonic() + 30
    while is_alive(pid) and time.monotonic() < end_by:
        time.sleep(0.05)
    assert not is_alive(pid)
    assert list(tmp_path.iterdir()) == []
