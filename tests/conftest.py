"""What every test that needs a window shares: a display, and one QApplication whose warnings are kept."""

from __future__ import annotations

import gc
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator

import pytest
from hypothesis import settings

pytest.register_assert_rewrite("gestures")

if "PYTEST_XDIST_WORKER" in os.environ:  # one a core: threads of the library below NumPy would wait for each other
    os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

SCREEN = "2600x1600x24"
_XVFB_SECONDS = 20

# How long an example takes depends on who else runs. The tests try the same examples each time; `make fuzz` others.
settings.register_profile("tests", deadline=None, derandomize=True)
settings.register_profile("exploring", deadline=None, print_blob=True)
settings.load_profile("tests")


def pytest_collection_finish() -> None:
    """Look for circles only in what tests make: with all that was collected it took a tenth of their time."""
    gc.freeze()


def _needs_display() -> bool:
    return sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or os.environ.get("QT_QPA_PLATFORM")
    )


@pytest.fixture(scope="session")
def display() -> Iterator[None]:
    """A display: the one there is, or a virtual one for this session; every worker of a parallel run is a session."""
    if not _needs_display():
        yield
        return
    if shutil.which("Xvfb") is None:
        pytest.skip("there is no display, and no Xvfb to make a virtual one")
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", SCREEN, "-nolisten", "tcp"]
    server = subprocess.Popen(command, pass_fds=(write,), stderr=subprocess.DEVNULL)
    os.close(write)
    with os.fdopen(read) as answer:
        number = answer.readline().strip()
    if not number:
        pytest.skip("Xvfb did not start")
    os.environ["DISPLAY"] = f":{number}"
    yield
    server.terminate()
    server.wait(_XVFB_SECONDS)
    del os.environ["DISPLAY"]


@pytest.fixture(scope="session")
def qt_messages() -> list[str]:
    """The warnings that Qt has printed since the list was last cleared."""
    return []


@pytest.fixture(scope="session")
def app(display: None, qt_messages: list[str]) -> Iterator[object]:
    """The one QApplication of the session."""
    from PySide6.QtCore import QtMsgType, qInstallMessageHandler

    from qovr_app.window.application import make_application

    def on_message(kind: QtMsgType, context: object, text: str) -> None:
        if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
            qt_messages.append(text)

    qInstallMessageHandler(on_message)
    application = make_application(["qovr-tests"])
    application.setQuitOnLastWindowClosed(False)
    yield application
    qInstallMessageHandler(None)
    application.shutdown()  # while its display still is there


@pytest.fixture
def spin(app: object) -> Callable[..., None]:
    """A function that lets the event loop run until something is true, or for some milliseconds."""
    from PySide6.QtTest import QTest

    def run(until: Callable[[], bool] | int, *, seconds: float = 60.0) -> None:
        if isinstance(until, int):
            QTest.qWait(until)
            return
        for _ in range(int(seconds * 100)):
            if until():
                return
            QTest.qWait(10)
        raise AssertionError("it did not happen in time")

    return run
