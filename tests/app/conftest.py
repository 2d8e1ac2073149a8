<<<<<<< HEAD
"""Tests of the window fail on what would otherwise pass in silence."""
=======
"""What every test of the window needs: a display, one QApplication, and no silent failures."""
>>>>>>> 41d2982403217141c0fbdc92355eee881f9599e0

from __future__ import annotations

import logging
<<<<<<< HEAD
import sys
from collections.abc import Iterator

import pytest

=======
import os
import shutil
import subprocess
import sys
from collections.abc import Callable, Iterator

import pytest

SCREEN = "1920x1440x24"
_XVFB_SECONDS = 20


def _needs_display() -> bool:
    return sys.platform.startswith("linux") and not (
        os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY") or os.environ.get("QT_QPA_PLATFORM")
    )


@pytest.fixture(scope="session")
def display() -> Iterator[None]:
    """A display: the one there is, or a virtual one for this session."""
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
    from PySide6.QtWidgets import QApplication

    from qovr_app.view3d.probe import set_default_format

    def on_message(kind: QtMsgType, context: object, text: str) -> None:
        if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
            qt_messages.append(text)

    qInstallMessageHandler(on_message)
    set_default_format()
    application = QApplication.instance() or QApplication(["qovr-tests"])
    application.setQuitOnLastWindowClosed(False)
    yield application
    qInstallMessageHandler(None)

>>>>>>> 41d2982403217141c0fbdc92355eee881f9599e0

@pytest.fixture
def painting_errors() -> list[logging.LogRecord]:
    """The errors raised while painting."""
    return []


@pytest.fixture
def silenced(painting_errors: list[logging.LogRecord]) -> list[logging.LogRecord]:
    """The errors raised while painting, for tests that provoke them: there they are no failures."""
    return painting_errors


@pytest.fixture(autouse=True)
def _nothing_is_swallowed(
    qt_messages: list[str], painting_errors: list[logging.LogRecord], request: pytest.FixtureRequest
) -> Iterator[None]:
    """Fail a test on Qt warnings, on errors while painting, and on exceptions in slots."""
    from qovr_app.view3d.failures import LOGGER

    raised: list[str] = []
    handler = logging.Handler(logging.ERROR)
    handler.emit = painting_errors.append
    hook, sys.excepthook = sys.excepthook, lambda kind, error, _: raised.append(f"{kind.__name__}: {error}")
    LOGGER.addHandler(handler)
    qt_messages.clear()
    yield
    if "app" in request.fixturenames:
        request.getfixturevalue("app").processEvents()
    sys.excepthook = hook
    LOGGER.removeHandler(handler)
    assert raised == []
    if "silenced" not in request.fixturenames:
        formatter = logging.Formatter()
        assert [formatter.format(record) for record in painting_errors] == []
        assert qt_messages == []
<<<<<<< HEAD
=======


@pytest.fixture
def spin(app: object) -> Callable[..., None]:
    """A function that lets the event loop run until something is true, or for some milliseconds."""
    from PySide6.QtTest import QTest

    def run(until: Callable[[], bool] | int, *, seconds: float = 10.0) -> None:
        if isinstance(until, int):
            QTest.qWait(until)
            return
        for _ in range(int(seconds * 100)):
            if until():
                return
            QTest.qWait(10)
        raise AssertionError("it did not happen in time")

    return run
>>>>>>> 41d2982403217141c0fbdc92355eee881f9599e0
