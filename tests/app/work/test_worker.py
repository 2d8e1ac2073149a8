"""Jobs: told in order, in one process beside the window, and what is told of those that fail."""

import logging
import os
import signal
import sys
import threading
import time
from pathlib import Path

import numpy as np
import pytest

from qovr_app.work.failures import WorkError
from qovr_app.work.notices import Notices
from qovr_core import DocumentError, configure
from support import jobs
from support.documents import random_document
from support.working import Heard, children, is_alive


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


@pytest.mark.skipif(sys.platform == "win32", reason="there nobody can delete the folder in which a process is")
def test_a_deleted_folder_keeps_no_job_from_being_done(answer, tmp_path, monkeypatch):
    answer(jobs.add, 1, 2)
    (tmp_path / "gone").mkdir()
    monkeypatch.chdir(tmp_path / "gone")
    (tmp_path / "gone").rmdir()
    assert answer(jobs.add, 1, 2).result == 3


def test_a_result_that_cannot_be_read_ends_the_job(worker, spin, silenced):
    heard = Heard()
    worker.run(jobs.return_what_cannot_be_read, **heard.callbacks())
    spin(lambda: heard.is_over)
    assert "ended unexpectedly" in str(heard.error)
    after = Heard()
    worker.run(jobs.add, 1, 2, **after.callbacks())
    spin(lambda: after.is_over)
    assert after.result == 3


def test_a_value_that_fails_to_be_packed_is_worked_on_here(worker, spin):
    class Strange:
        def __reduce__(self):
            raise ArithmeticError

    heard = Heard()
    worker.run(jobs.size_of, [Strange()], **heard.callbacks())
    spin(lambda: heard.is_over)
    assert heard.result == 1


def test_a_share_that_does_not_answer_does_not_hold_up_the_end(worker, monkeypatch):
    monkeypatch.setattr("qovr_app.work.file_thread._PATIENCE_SECONDS", 0.1)
    answers = threading.Event()
    worker.in_thread(answers.wait, 30)
    began = time.perf_counter()
    worker.close()
    answers.set()
    assert time.perf_counter() - began < 5
