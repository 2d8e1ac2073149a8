"""What takes time: told in order, ended when it is to end, and gone with its window."""

import logging
import os
import signal
import subprocess
import sys
import threading
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QThread

from qovr_app.work.failures import WorkError
from qovr_app.work.notices import Notices
from qovr_app.work.worker import Worker
from qovr_core import DocumentError, configure
from qovr_core.fields import FIELDS, Field
from support import jobs
from support.documents import random_document


class Heard(list):
    """What was told of one job, as (kind, values)."""

    def callbacks(self):
        return {f"on_{kind}": self._hear(kind) for kind in ("progress", "done", "failed")}

    def _hear(self, kind):
        def hear(*values):
            assert QThread.isMainThread()
            self.append((kind, *values))

        return hear

    @property
    def is_over(self):
        return any(kind in ("done", "failed") for kind, *_ in self)

    @property
    def result(self):
        (last,) = [value for kind, value, *_ in self if kind == "done"]
        return last

    @property
    def error(self):
        (last,) = [value for kind, value, *_ in self if kind == "failed"]
        return last


@pytest.fixture
def worker(app):
    made = Worker()
    yield made
    made.close()
    assert children() == []


@pytest.fixture
def answer(worker, spin):
    """A function that runs a job to its end and returns what was told of it."""

    def run(function, *values, **options):
        heard = Heard()
        worker.run(function, *values, **heard.callbacks(), **options)
        spin(lambda: heard.is_over, seconds=60)
        return heard

    return run


def children():
    """Return the process ids of this process's living children that are workers."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/stat") if sys.platform == "linux" else []:
        try:
            fields = entry.read_text().rpartition(")")[2].split()
            line = entry.with_name("cmdline").read_bytes()
        except OSError:
            continue
        if int(fields[1]) == os.getpid() and b"qovr_app.work" in line and fields[0] != "Z":
            found.append(int(entry.parent.name))
    return found


def is_alive(pid):
    try:
        os.kill(pid, 0)
    except OSError:
        return False
    return True


def test_a_job_reports_and_returns_in_order(answer):
    heard = answer(jobs.count_to, 500)
    assert heard == [*(("progress", k, k * k) for k in range(500)), ("done", 500)]


def test_jobs_run_one_after_the_other_in_one_process(worker, spin):
    told = []
    for k in range(5):
        worker.run(jobs.add, k, k, on_done=lambda result, k=k: told.append((k, result)))
    pids = Heard()
    worker.run(jobs.environment, **pids.callbacks())
    again = Heard()
    worker.run(jobs.environment, **again.callbacks())
    spin(lambda: again.is_over)
    assert told == [(k, 2 * k) for k in range(5)]
    assert pids.result["pid"] == again.result["pid"] != os.getpid()
    assert len(children()) == 1


def test_no_process_before_the_first_job(worker):
    assert children() == []


def test_arrays_and_documents_travel_whole(answer):
    document = random_document(1)
    assert np.array_equal(answer(jobs.evaluated, document).result, configure(document).raw)


def test_values_larger_than_a_pipe_hold_up_nobody(worker, spin):
    heard = Heard()
    start = time.monotonic()
    worker.run(jobs.size_of, bytes(30_000_000), **heard.callbacks())
    assert time.monotonic() - start < 5.0
    spin(lambda: heard.is_over)
    assert heard.result == 30_000_000


# Where the work is done


def test_the_process_keeps_to_one_thread_and_waits_for_who_draws(answer):
    there = answer(jobs.environment).result
    assert there["grid"] == 1
    if there["nice"] is not None:
        assert there["nice"] > os.nice(0)


def test_the_process_knows_no_window(answer):
    loaded = {name.partition(".")[0] for name in answer(jobs.modules).result}
    assert not loaded & {"PySide6", "shiboken6", "pyqtgraph", "OpenGL", "matplotlib", "scipy"}


def test_nothing_is_imported_from_the_folder_in_which_one_happens_to_be(worker, spin, tmp_path, monkeypatch):
    (tmp_path / "numpy.py").write_text("raise SystemExit('this is no NumPy')")
    (tmp_path / "pickle.py").write_text("raise SystemExit('this is no pickle')")
    monkeypatch.chdir(tmp_path)
    heard = Heard()
    worker.run(jobs.evaluated, random_document(1), **heard.callbacks())
    spin(lambda: heard.is_over)
    assert heard[0][0] == "done"


def test_relative_paths_mean_the_same_there(answer, tmp_path, monkeypatch):
    answer(jobs.add, 1, 2)
    monkeypatch.chdir(tmp_path)
    assert Path(answer(jobs.environment).result["folder"]) == tmp_path


def test_prints_do_not_get_into_the_answers(answer):
    assert answer(jobs.print_a_lot).result == "answered"


# Errors


def test_an_error_of_the_program_s_own_kind_arrives_as_it_is(answer):
    error = answer(jobs.fail_with, "document").error
    assert isinstance(error, DocumentError)
    assert (error.place, error.found, error.expected) == ("samples", "1", "2 to 4096")


def test_one_that_cannot_travel_arrives_as_its_sentence(answer):
    assert str(answer(jobs.fail_with, "strange").error) == "a and b"


def test_no_memory_is_said_in_words(answer):
    error = answer(jobs.fail_with, "memory").error
    assert str(error) == "There is not enough memory for so many points; choose fewer samples"


@pytest.mark.parametrize(
    ("function", "values", "text"),
    [
        (jobs.fail_with, ["bug"], "ZeroDivisionError: division by nothing"),
        (jobs.fail_with, ["exit"], "SystemExit: 3"),
        (jobs.return_what_cannot_travel, [], "AttributeError"),
        (jobs.report_what_cannot_travel, [], "AttributeError"),
    ],
)
def test_an_unexpected_error_is_one_sentence_and_its_traceback_is_logged(
    answer, caplog, silenced, function, values, text
):
    error = answer(function, *values).error
    assert isinstance(error, WorkError)
    assert text.split(":")[0] in str(error)
    assert "\n" not in str(error)
    (record,) = [record for record in caplog.records if record.name == "qovr_app.work"]
    assert record.levelno == logging.ERROR
    assert "Traceback" in record.getMessage()
    assert answer(jobs.add, 1, 2).result == 3  # and the process goes on


def test_a_process_that_crashes_fails_its_job_and_the_next_one_gets_another(answer):
    error = answer(jobs.crash).error
    assert "ended unexpectedly" in str(error)
    assert answer(jobs.add, 1, 2).result == 3


def test_a_process_killed_from_outside_fails_its_job_and_leaves_nothing(worker, answer, spin, tmp_path):
    target = tmp_path / "a"
    target.write_text("old")
    heard = Heard()
    worker.run(jobs.write_and_sleep, target, **heard.callbacks(), target=target)
    spin(lambda: len(heard) == 1, seconds=60)
    (pid,) = children()
    os.kill(pid, signal.SIGTERM)
    spin(lambda: heard.is_over, seconds=60)
    assert "ended unexpectedly" in str(heard.error)
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]
    assert target.read_text() == "old"
    assert answer(jobs.add, 1, 2).result == 3


def test_a_process_killed_while_it_rests_is_not_missed(answer, spin):
    answer(jobs.add, 1, 2)
    (pid,) = children()
    os.kill(pid, signal.SIGTERM)
    spin(lambda: not is_alive(pid))
    assert answer(jobs.add, 1, 2).result == 3


def test_what_the_process_notices_of_files_is_told_here(answer, spin):
    notices, told = Notices(), []
    notices.noticed.connect(told.append)
    answer(jobs.notice, "a.csv: belongs to you now")
    spin(lambda: told)
    notices.close()
    answer(jobs.notice, "something else")
    assert told == ["a.csv: belongs to you now."]


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
    (tmp_path / ".qovr-1-of-another.part").write_text("another process is writing this")
    heard, ended = Heard(), []
    job = worker.run(function, *values, **heard.callbacks(), target=target)
    spin(lambda: len(heard) == 1, seconds=60)
    (pid,) = children()
    job.cancel(ended.append)
    assert answer(jobs.environment).result["pid"] != pid
    assert ended == [False]
    assert not is_alive(pid)
    assert [entry.name for entry in tmp_path.iterdir()] == [".qovr-1-of-another.part"]
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


# What the other process does not know by itself


def test_records_from_outside_travel_with_each_job(answer):
    outside = replace(Field.HEIGHT, name="outside", values=jobs.heights_upside_down)
    with FIELDS.register(outside):
        assert answer(jobs.names_of, "qovr_core.fields", "FIELDS").result[-1] == "outside"
        document = random_document(1)
        assert np.array_equal(
            answer(jobs.values_of, document, outside).result, -answer(jobs.values_of, document, Field.HEIGHT).result
        )
        assert len(children()) == 1
    assert answer(jobs.names_of, "qovr_core.fields", "FIELDS").result == list(FIELDS)


def test_a_record_that_cannot_travel_keeps_the_job_here(answer):
    with FIELDS.register(replace(Field.HEIGHT, name="local", values=lambda *_: None)):
        assert answer(jobs.names_of, "qovr_core.fields", "FIELDS").result[-1] == "local"
        assert children() == []
    answer(jobs.add, 1, 2)
    assert len(children()) == 1


def test_what_is_defined_locally_runs_in_a_thread(worker, spin):
    def local(a, report):
        report(threading.current_thread() is threading.main_thread())
        return a + 1

    heard = Heard()
    worker.run(local, 1, **heard.callbacks())
    spin(lambda: heard.is_over)
    assert heard == [("progress", False), ("done", 2)]
    assert children() == []


def test_so_does_what_the_other_process_cannot_find(worker, spin, monkeypatch):
    module = type(sys)("made_by_hand")
    exec("def double(a, report):\n    return 2 * a", module.__dict__)
    monkeypatch.setitem(sys.modules, "made_by_hand", module)
    heard = Heard()
    worker.run(module.double, 2, **heard.callbacks())
    spin(lambda: heard.is_over, seconds=60)
    assert heard == [("done", 4)]


def test_a_job_in_a_thread_is_cancelled_and_fails_alike(worker, answer, spin, caplog, silenced):
    def local(report):
        jobs.report_until_cancelled(report)

    heard, ended = [], []
    job = worker.run(local, on_progress=heard.append)
    spin(lambda: len(heard) > 2)
    job.cancel(ended.append)
    spin(lambda: ended == [False])
    assert isinstance(answer(lambda report: jobs.fail_with("document", report)).error, DocumentError)
    assert "ZeroDivisionError" in str(answer(lambda report: jobs.fail_with("bug", report)).error)
    assert "division by nothing" in caplog.text


def test_a_script_s_own_functions_and_records_work(tmp_path):
    """A function of the running script is not looked for among those of the other process's."""
    script = tmp_path / "script.py"
    script.write_text(
        "import os, sys\n"
        "from PySide6.QtCore import QCoreApplication\n"
        "from qovr_app.work.worker import Worker\n"
        "print('the script has run')\n"
        "def main(report): return os.getpid()\n"
        "app = QCoreApplication([])\n"
        "worker = Worker()\n"
        "worker.run(main, on_done=lambda pid: (print(pid == os.getpid()), app.quit()))\n"
        "app.exec()\n"
        "worker.close()\n"
    )
    done = subprocess.run([sys.executable, str(script)], capture_output=True, text=True, timeout=60, check=True)
    assert done.stdout.split("\n") == ["the script has run", "True", ""]


# Files


def test_files_are_waited_for_in_one_thread_in_order(worker, spin):
    told, threads = [], set()

    def note(k):
        threads.add(threading.get_ident())
        return k

    for k in range(20):
        worker.in_thread(note, k, on_done=told.append)
    spin(lambda: len(told) == 20)
    assert told == list(range(20))
    assert len(threads) == 1
    assert threads != {threading.get_ident()}


def test_a_file_that_cannot_be_written_is_told(worker, spin):
    def refuse():
        raise DocumentError("samples", "1", "2 to 4096")

    told = []
    worker.in_thread(refuse, on_failed=told.append)
    spin(lambda: told)
    assert isinstance(told[0], DocumentError)


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
        [sys.executable, "-c", code, str(tmp_path / "a")], stdout=subprocess.PIPE, text=True, timeout=60, check=False
    )
    pid = int(done.stdout.split()[0])
    end_by = time.monotonic() + 30
    while is_alive(pid) and time.monotonic() < end_by:
        time.sleep(0.05)
    assert not is_alive(pid)
    assert list(tmp_path.iterdir()) == []


def test_how_long_the_first_job_takes(worker, answer, capsys):
    start = time.perf_counter()
    answer(jobs.add, 1, 2)
    first = time.perf_counter() - start
    start = time.perf_counter()
    answer(jobs.add, 1, 2)
    with capsys.disabled():
        print(f"\n  first job {1e3 * first:.0f} ms, second {1e3 * (time.perf_counter() - start):.0f} ms")
