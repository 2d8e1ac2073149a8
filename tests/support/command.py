"""The command line as a user runs it: another process."""

import multiprocessing
import os
import sys
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryDirectory

from qovr_app.main import main
from qovr_core.cli import COMMANDS
from qovr_core.files.formats import FORMATS

QOVR = Path(sys.executable).with_name("qovr")
"""The command itself, for tests of what surrounds it: how it starts, its streams, its signals."""

_IMPORTED = {add_command.__module__ for add_command in COMMANDS.values()} | {
    entry.writer.__module__ for entry in FORMATS.values()
}
"""What commands import when they are called."""

_HAS_FORKS = "forkserver" in multiprocessing.get_all_start_methods()
_PROCESSES = multiprocessing.get_context("forkserver" if _HAS_FORKS else "spawn")
_PROCESSES.set_forkserver_preload([*_IMPORTED, "openpyxl", "xlsxwriter"])

_SECONDS = 300

PUBLISHED = Path(__file__).resolve().parents[3] / "shared/reference/published"


@dataclass
class Run:
    code: int
    out: str
    err: str


def environment(**changes):
    headless = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return {**headless, **changes}


def qovr(*arguments, cwd=None, largest_file=None):
    """Run the command in a process of its own, forked from one that has imported what every command imports.

    Parameters
    ----------
    cwd : the folder in which it runs
    largest_file : bytes; a write beyond them fails, as on a full disk
    """
    with TemporaryDirectory() as folder:
        out, err = Path(folder, "out"), Path(folder, "err")
        values = [*map(str, arguments)], cwd, largest_file, environment(), (out, err)
        process = _PROCESSES.Process(target=_be_the_command, args=values)
        process.start()
        process.join(_SECONDS)
        process.kill()
        process.join()
        return Run(process.exitcode, out.read_text(), err.read_text())


def _be_the_command(arguments, cwd, largest_file, variables, files):
    for descriptor, file in enumerate(files, start=1):
        os.dup2(os.open(file, os.O_WRONLY | os.O_CREAT), descriptor)
    os.chdir(cwd or ".")
    os.environ.clear()
    os.environ.update(variables)
    if largest_file is not None:
        import resource

        resource.setrlimit(resource.RLIMIT_FSIZE, (largest_file, largest_file))
    sys.argv = ["qovr", *arguments]
    main()


def refused(run):
    """Return the text of a refusal after checking its form: exit 2, one line, no traceback, nothing said besides."""
    assert run.code == 2, (run.code, run.err)
    assert run.out == ""
    assert run.err.startswith("qovr: ")
    assert run.err.count("\n") == 1
    assert "Traceback" not in run.err
    return run.err
