"""What the worker process does not know by itself: records from outside, functions of nobody else; and files."""

import subprocess
import sys
import threading
from dataclasses import replace

import numpy as np

from qovr_core import FORMULATIONS, DocumentError, Formulation, configure
from qovr_core.fields import FIELDS, Field
from qovr_core.files.format import Format
from qovr_core.files.formats import FORMATS, export
from qovr_core.files.options import DEFAULTS
from qovr_core.laboratory.claims import CLAIMS
from qovr_core.laboratory.verify import verify
from support import jobs
from support.documents import random_document
from support.working import Heard, children

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


def test_a_document_of_a_formulation_from_outside_is_the_same_there(answer):
    with FORMULATIONS.register(
        replace(Formulation.INTERPOLATING, name="outside", build=jobs.doubled, slope=None)
    ) as outside:
        document = replace(random_document(1), formulation=outside)
        assert np.array_equal(answer(jobs.evaluated, document).result, configure(document).raw)
        findings = answer(verify, document, (0, 0))
        assert sum(heard[0] == "progress" for heard in findings) == len(CLAIMS) * len(FORMULATIONS)
        assert findings.result[-1].formulation == outside
        assert len(children()) == 1


def test_a_format_from_outside_is_written_there(answer, tmp_path):
    with FORMATS.register(Format(".txt", "Text", "its name", "all else", jobs.write_formulation)):
        answer(export, random_document(1), tmp_path / "a.txt", DEFAULTS)
    assert (tmp_path / "a.txt").read_text() == f"{random_document(1).formulation} {children()[0]}"


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
