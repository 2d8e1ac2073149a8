"""The command line as a user runs it: another process."""

import os
import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

QOVR = Path(sys.executable).with_name("qovr")

PUBLISHED = Path(__file__).resolve().parents[3] / "shared/reference/published"


@dataclass
class Run:
    code: int
    out: str
    err: str


def environment(**changes):
    headless = {key: value for key, value in os.environ.items() if key not in ("DISPLAY", "WAYLAND_DISPLAY")}
    return {**headless, **changes}


def qovr(*arguments, cwd=None, **options):
    done = subprocess.run(
        [QOVR, *map(str, arguments)],
        check=False,
        cwd=cwd,
        env=environment(),
        capture_output=True,
        text=True,
        timeout=300,
        **options,
    )
    return Run(done.returncode, done.stdout, done.stderr)


def refused(run):
    """Return the text of a refusal after checking its form: exit 2, one line, no traceback, nothing said besides."""
    assert run.code == 2, (run.code, run.err)
    assert run.out == ""
    assert run.err.startswith("qovr: ")
    assert run.err.count("\n") == 1
    assert "Traceback" not in run.err
    return run.err
