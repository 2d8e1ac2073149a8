"""SIGTERM, Ctrl-C and a closed terminal end the editor in order, whatever goes on in it."""

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from support.recovery_reader import kept_in
from support.signalled import HEIGHT

TESTS = Path(__file__).resolve().parents[1]


def deliver_signals():
    """Take signals again that whoever runs the tests may have told its children to ignore, as shells and nohup do."""
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


@pytest.fixture
def start(app, tmp_path):
    """A function that starts the editor and waits until something goes on in it."""
    started = []

    def run(going_on):
        environment = {
            **os.environ,
            "PYTHONPATH": os.pathsep.join([str(TESTS), *sys.path]),
            "XDG_CONFIG_HOME": str(tmp_path / "config"),
            "XDG_DATA_HOME": str(tmp_path / "data"),
        }
        command = [sys.executable, "-m", "support.signalled", going_on]
        editor = subprocess.Popen(
            command,
            env=environment,
            cwd=tmp_path,
            stdout=subprocess.PIPE,
            stderr=subprocess.PIPE,
            text=True,
            preexec_fn=deliver_signals if os.name == "posix" else None,
        )
        started.append(editor)
        assert editor.stdout.readline() == "ready\n"
        return editor

    yield run
    for editor in started:
        editor.kill()
        editor.wait()
        editor.stdout.close()
        editor.stderr.close()


@pytest.mark.skipif(os.name != "posix", reason="other systems have no such signals")
@pytest.mark.parametrize(
    ("number", "going_on", "code"),
    [
        (signal.SIGTERM, "nothing", 143),
        (signal.SIGTERM, "question", 143),
        (signal.SIGTERM, "job", 143),
        (signal.SIGINT, "nothing", 130),
        (signal.SIGINT, "question", 130),
        (getattr(signal, "SIGHUP", signal.SIGTERM), "nothing", 129),
    ],
)
def test_a_signal_ends_in_order_and_keeps_what_is_not_saved(start, tmp_path, number, going_on, code):
    editor = start(going_on)
    editor.send_signal(number)
    assert editor.wait(20) == code
    assert editor.stderr.read() == ""
    folder = tmp_path / "data" / "qovr-studio" / "recovery"
    (kept,) = folder.iterdir()
    _, (document,) = kept_in(kept)
    assert document["control_points"][2, 2, 2] == HEIGHT
