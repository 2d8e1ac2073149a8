"""What every test of the window needs: a display, one QApplication, and no silent failures."""

import os
import shutil
import subprocess
import sys

import pytest


@pytest.fixture(scope="session")
def display():
    """The display there is, else a virtual one for this session."""
    if not sys.platform.startswith("linux") or os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"):
        yield
        return
    if shutil.which("Xvfb") is None:
        pytest.skip("there is no display, and no Xvfb to make a virtual one")
    read, write = os.pipe()
    server = subprocess.Popen(
        ["Xvfb", "-displayfd", str(write), "-screen", "0", "2600x1600x24", "-nolisten", "tcp"],
        pass_fds=(write,),
        stderr=subprocess.DEVNULL,
    )
    os.close(write)
    with os.fdopen(read) as answer:
        os.environ["DISPLAY"] = f":{answer.readline().strip()}"
    yield
    server.terminate()
    server.wait(20)


@pytest.fixture(scope="session")
def qt_messages():
    """The warnings that Qt has printed since the list was last cleared."""
    return []


@pytest.fixture(scope="session")
def app(display, qt_messages):
    """The one QApplication of the session."""
    from PySide6.QtCore import QtMsgType, qInstallMessageHandler

    from qovr_app.appearance import make_application

    def on_message(kind, context, text):
        if kind not in (QtMsgType.QtDebugMsg, QtMsgType.QtInfoMsg):
            qt_messages.append(text)

    qInstallMessageHandler(on_message)
    application = make_application(["qovr-tests"])
    application.setQuitOnLastWindowClosed(False)
    yield application
    qInstallMessageHandler(None)


@pytest.fixture(autouse=True)
def _nothing_is_swallowed(qt_messages, request):
    """Fail a test on Qt warnings and on exceptions in slots."""
    raised = []
    hook, sys.excepthook = sys.excepthook, lambda kind, error, _: raised.append(f"{kind.__name__}: {error}")
    qt_messages.clear()
    yield
    if "app" in request.fixturenames:
        request.getfixturevalue("app").processEvents()
    sys.excepthook = hook
    assert raised == []
    assert qt_messages == []
