"""A write that is killed, at every call of the system it makes: the old file whole, or the new one."""

import os
import signal
import subprocess
import sys

import pytest

from qovr_core import configure
from qovr_core.files import FORMATS, read_source
from qovr_core.files.atomic import replacing
from qovr_core.files.progress import silent
from support.command import environment
from support.documents import random_document

pytestmark = pytest.mark.skipif(not hasattr(os, "fork"), reason="processes that can be forked and killed are of POSIX")

CALLS = (
    "open",
    "close",
    "fsync",
    "replace",
    "rename",
    "unlink",
    "rmdir",
    "mkdir",
    "chmod",
    "chown",
    "write",
    "stat",
    "lstat",
)
"""Functions of ``os`` that a write goes through; between two of them nothing changes on the disk but a draft."""

OLD, NEW = random_document(1), random_document(2)


def killed_at(number, write):
    """Write in a child that kills itself before its call of a number; return whether it came that far."""
    child = os.fork()
    if child == 0:
        calls = iter(range(1, 10**6))

        def counted(function):
            def call(*arguments, **options):
                if next(calls) == number:
                    os.kill(os.getpid(), signal.SIGKILL)
                return function(*arguments, **options)

            return call

        for name in CALLS:
            setattr(os, name, counted(getattr(os, name)))
        try:
            write()
        finally:
            os._exit(0)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == -signal.SIGKILL


def write(document, path):
    FORMATS[path.suffix].write(configure(document), path, silent)


@pytest.mark.parametrize("suffix", [".qovr", ".npz", ".csv"])
def test_killed_at_every_call_the_file_is_whole(suffix, tmp_path):
    path = tmp_path / f"a{suffix}"
    beside = [path, path.with_suffix(".inputs.json")] if suffix == ".csv" else [path]
    contents = []
    for document in (OLD, NEW):
        write(document, path)
        contents.append([file.read_bytes() for file in beside])
    number, seen = 1, [set() for _ in beside]
    while True:
        for file, content in zip(beside, contents[0], strict=True):
            file.write_bytes(content)
        was_killed = killed_at(number, lambda: write(NEW, path))
        for k, file in enumerate(beside):
            content = file.read_bytes()
            assert content in (contents[0][k], contents[1][k]), number
            seen[k].add(content == contents[1][k])
        if not was_killed:
            break
        number += 1
    assert number > 10
    assert seen == [{False, True}] * len(beside)
    write(NEW, path)  # clears away what the killed ones left
    assert sorted(entry.name for entry in tmp_path.iterdir()) == sorted(file.name for file in beside)


def test_what_another_process_is_writing_is_left_alone(tmp_path):
    code = (
        "import sys, pathlib\nfrom qovr_core.files.atomic import replacing\n"
        "with replacing(pathlib.Path(sys.argv[1])) as (draft,):\n"
        "    draft.write_text('theirs')\n    print('ready', flush=True)\n    sys.stdin.read()\n"
    )
    call = [sys.executable, "-c", code, str(tmp_path / "a")]
    other = subprocess.Popen(call, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True)
    assert other.stdout.readline() == "ready\n"
    with replacing(tmp_path / "a") as (draft,):
        draft.write_text("ours")
    assert (tmp_path / "a").read_text() == "ours"
    other.communicate()
    assert (tmp_path / "a").read_text() == "theirs"
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]


def test_of_two_processes_that_write_one_file_the_last_wins_whole(tmp_path):
    """Both files of a table come from one of them, too."""
    documents = [random_document(seed, samples=(30, 30)) for seed in (1, 2)]
    contents = []
    for k, document in enumerate(documents):
        write(document, tmp_path / f"in{k}.qovr")
        write(document, tmp_path / "a.csv")
        contents.append(((tmp_path / "a.csv").read_bytes(), (tmp_path / "a.inputs.json").read_bytes()))
    code = (
        "import sys\nfrom qovr_core.cli import main\n"
        "for _ in range(6):\n    assert main(['export', sys.argv[1], 'a.csv', 'a.npz']) == 0\n"
    )
    running = [
        subprocess.Popen([sys.executable, "-c", code, f"in{k}.qovr"], cwd=tmp_path, env=environment()) for k in range(2)
    ]
    assert [process.wait(timeout=120) for process in running] == [0, 0]
    assert ((tmp_path / "a.csv").read_bytes(), (tmp_path / "a.inputs.json").read_bytes()) in contents
    assert read_source(str(tmp_path / "a.npz")) in documents
    names = sorted(entry.name for entry in tmp_path.iterdir())
    assert names == ["a.csv", "a.inputs.json", "a.npz", "in0.qovr", "in1.qovr"]
