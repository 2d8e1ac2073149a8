"""What surrounds a command: closed and full streams, readers that leave, signals, words that are no options."""

import os
import signal
import subprocess
import sys
import time

import pytest

from support.command import QOVR, environment, qovr, refused

posix = pytest.mark.skipif(os.name != "posix", reason="needs a POSIX shell")


def in_a_shell(command, cwd):
    """Run a line of bash in which ``qovr`` is this program."""
    line = f"qovr() {{ '{QOVR}' \"$@\"; }}; {command}"
    return subprocess.run(
        ["bash", "-c", line], cwd=cwd, env=environment(), capture_output=True, text=True, check=False, timeout=120
    )


@posix
@pytest.mark.parametrize(
    ("command", "code", "said"),
    [
        ("qovr info paper:fig5 >&-", 2, "the answer cannot be written: Bad file descriptor"),
        ("qovr info paper:fig5 2>&-", 0, ""),
        ("qovr info paper:fig5 <&- 2>&-", 0, ""),
        ("qovr info missing.qovr 2>&-", 2, ""),
        ("qovr info missing.qovr 2>/dev/full", 2, ""),
        ("qovr info paper:fig5 >/dev/full 2>/dev/full", 2, ""),
        ("qovr --help >/dev/full", 2, "the answer cannot be written: No space left on device"),
        ("qovr --help >&-", 2, "the answer cannot be written"),
        ("qovr --help | true; exit ${PIPESTATUS[0]}", 0, ""),
        ("qovr info paper:fig5 --json | true; exit ${PIPESTATUS[0]}", 0, ""),
        ("qovr info missing.qovr 2>&1 >/dev/null | true; exit ${PIPESTATUS[0]}", 2, ""),
        ("qovr export paper:fig5 a.csv --samples 5 <&- >&- 2>&- && head -c 4 a.csv | grep -q i,j,", 0, ""),
    ],
)
def test_streams_that_are_closed_or_full(command, code, said, tmp_path):
    done = in_a_shell(command, tmp_path)
    assert done.returncode == code, done.stderr
    assert "Traceback" not in done.stderr
    assert "Exception" not in done.stderr
    assert done.stderr.count("\n") == bool(said)
    assert said in done.stderr


@pytest.mark.parametrize(
    "call",
    [
        ("info", "paper:fig5", "--js"),
        ("export", "paper:fig5", "a.npz", "--sample", "5"),
        ("export", "paper:fig5", "a.npz", "--formul", "published"),
        ("figures", "out", "--form", "png"),
        ("figures", "out", "--formats", ","),
        ("figures", "out", "--formats", ""),
        ("figures", "out", "--only", " , "),
        ("figures", "out", "--dpi", "١٠٠"),
        ("export", "paper:fig5", "a.npz", "--samples", "١١"),
        ("export", "paper:fig5", "a.npz", "--samples", "１１x5"),
        ("export", "paper:fig5", "a.npz", "--samples", "1_1"),
        ("export", "paper:fig5", "a.stl", "--tolerance", "0_1.5"),
        ("export", "paper:fig5", "a.stl", "--tolerance", "٠.1"),
        ("compare", "paper:fig5", "--weight", "２"),
        ("compare", "paper:fig5", "--point", "٢,1"),
        ("screenshot", "a.png", "--size", "٨٠٠x600"),
        ("screenshot", "a.png", "--scale", "1_0"),
        ("export", "paper:fig5", ""),
        ("figures", ""),
        ("info", ""),
        ("verify", "paper:fig5", "--counterexamples", ""),
    ],
    ids=" ".join,
)
def test_calls_that_mean_nothing(call, tmp_path):
    assert len(refused(qovr(*call, cwd=tmp_path))) <= 300
    assert list(tmp_path.iterdir()) == []


def test_messages_stay_short_whatever_stands_in_the_call(tmp_path):
    long = "x" * 3000
    for call in (
        ("info", long),
        ("info", f"{long}.qovr"),
        ("info", f"{'d/' * 2000}a.qovr"),
        ("info", f"paper:{long}"),
        ("export", "paper:fig5", f"{long}.npz"),
        ("export", "paper:fig5", f"{'d/' * 2000}a.npz"),
        ("export", "paper:fig5", f"a.{long}"),
        ("figures", "out", "--only", long),
        ("reproduce", f"{long}.xlsx"),
        ("info", f"--{long}"),
    ):
        assert len(refused(qovr(*call, cwd=tmp_path))) <= 300


@posix
@pytest.mark.parametrize("module", ["qovr_core", "qovr_app"])
def test_the_packages_run_as_modules(module, tmp_path):
    for call, code in ((["info", "paper:fig5"], 0), (["info", "missing.qovr"], 2)):
        done = subprocess.run(
            [sys.executable, "-m", module, *call],
            cwd=tmp_path,
            env=environment(),
            capture_output=True,
            text=True,
            check=False,
        )
        assert done.returncode == code
        assert done.stderr == ("" if code == 0 else "qovr: missing.qovr: cannot be read: No such file or directory\n")


def is_of_python_itself(err):
    """Return whether Python was interrupted before the program's first line."""
    return "KeyboardInterrupt" in err and ", in main\n" not in err and "/qovr_core/" not in err


SWALLOWED = """
import signal, sys, time
from qovr_core import streams
from qovr_core.streams import Interrupted, interruptible

streams._MOMENT = float(sys.argv[1])

class Finalised:
    def __del__(self):
        signal.raise_signal(signal.SIGTERM)

try:
    with interruptible():
        Finalised()
        time.sleep(60)
except Interrupted as interrupt:
    print(interrupt.number)
"""


@posix
@pytest.mark.parametrize("moment", [0.0, 1e-4, 0.002])
def test_a_signal_in_a_finaliser_is_not_lost(moment):
    """Nor is it where it comes again before Python is out of the hook that sends it, and it ends what is waited for."""
    command = [sys.executable, "-c", SWALLOWED, str(moment)]
    run = subprocess.run(command, check=False, env=environment(), capture_output=True, text=True, timeout=40)
    assert (run.stdout, run.stderr) == (f"{int(signal.SIGTERM)}\n", "")


DISGUISED = """
import signal, sys
from qovr_core.cli import run

def disguised(arguments):
    try:
        signal.raise_signal(signal.SIGTERM)
    except KeyboardInterrupt:
        raise ValueError("as what calls Python out of C++ may have it")

def add_command(commands):
    commands.add_parser("disguised").set_defaults(command=disguised)

sys.exit(run({"disguised": add_command}, ["disguised"]))
"""


@posix
def test_a_signal_in_whose_place_another_error_is_raised_is_told():
    command = [sys.executable, "-c", DISGUISED]
    run = subprocess.run(command, check=False, env=environment(), capture_output=True, text=True, timeout=40)
    assert (run.returncode, run.stderr) == (128 + signal.SIGTERM, "qovr: interrupted; no unfinished file is left\n")


COMMANDS = (
    ("figures", ".", "--only", "fig5a,fig8b", "--dpi", "40"),
    ("export", "paper:fig5", "a.csv", "a.xlsx", "a.step", "--samples", "60"),
    ("verify", "paper:fig5", "--counterexamples", "."),
)


@posix
@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: command[0])
@pytest.mark.parametrize("kind", [signal.SIGINT, signal.SIGTERM], ids=["ctrl-c", "sigterm"])
def test_a_signal_at_any_moment(command, kind, tmp_path):
    """Right after the start Python itself decides: a signal before the program's first line kills it as any other."""
    for delay in (0.15, 0.3, 0.6, 1.0):
        running = subprocess.Popen(
            [QOVR, *command],
            cwd=tmp_path,
            env=environment(),
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
        )
        time.sleep(delay)
        running.send_signal(kind)
        _, err = running.communicate(timeout=60)
        if not is_of_python_itself(err):
            assert running.returncode in (0, 128 + kind, -kind)
            assert err in ("", "qovr: interrupted; no unfinished file is left\n")
        assert [entry.name for entry in tmp_path.iterdir() if entry.name.startswith(".")] == []
