"""The one way of waiting for something before the next thing can be done, with the window alive and a way out."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, wait
from threading import Thread
from typing import Any

from PySide6.QtCore import QEventLoop, Qt, QTimer
from PySide6.QtWidgets import QLabel, QProgressDialog, QWidget

from qovr_app.work.failures import failure_of
from qovr_app.work.worker import Worker
from qovr_core import QovrError

_UNSEEN_SECONDS = 0.1
"""Nobody notices so short a wait: for it nothing is shown."""

_LOOK_MILLISECONDS = 20
"""How often is looked whether a thread has ended: no wait becomes noticeably longer by it."""


class GivenUpError(QovrError):
    """The user does not want to wait any longer."""


def patiently(parent: QWidget, text: str, function: Callable[..., Any], *values: Any) -> Any:
    """Return what a function returns that waits for files: a share that does not answer holds nothing up.

    It runs in a thread, which goes on where the user gives up.

    Raises
    ------
    GivenUpError : the user did
    QovrError : the function's own, or a sentence made of what it raised
    """
    outcome: Future[Any] = Future()

    def run() -> None:
        try:
            outcome.set_result(function(*values))
        except BaseException as error:  # whatever it is, somebody is waiting to be told
            outcome.set_exception(error)

    Thread(target=run, daemon=True).start()
    wait([outcome], _UNSEEN_SECONDS)
    return _awaited(parent, text, outcome, function)


def at_work(parent: QWidget, worker: Worker, text: str, function: Callable[..., Any], *values: Any) -> Any:
    """Return what a job of the worker returns; giving up cancels it.

    Raises
    ------
    GivenUpError : the user did
    QovrError : why the job has failed
    """
    outcome: Future[Any] = Future()
    job = worker.run(function, *values, on_done=outcome.set_result, on_failed=outcome.set_exception)
    try:
        return _awaited(parent, text, outcome, function)
    finally:
        job.cancel()


def _awaited(parent: QWidget, text: str, outcome: Future[Any], function: Callable[..., Any]) -> Any:
    if not outcome.done():
        _wait_in_sight(parent, text, outcome)
    if not outcome.done():
        raise GivenUpError(f"{text.rstrip('…')} was given up")
    error = outcome.exception()
    if error is not None:
        raise failure_of(function, error) from error
    return outcome.result()


def _wait_in_sight(parent: QWidget, text: str, outcome: Future[Any]) -> None:
    dialog = QProgressDialog(parent)
    dialog.setObjectName("waiting")
    dialog.setWindowTitle(parent.window().windowTitle().replace("[*]", ""))
    label = QLabel(text)
    label.setTextFormat(Qt.TextFormat.PlainText)  # it may hold the name of a file
    dialog.setLabel(label)
    dialog.setRange(0, 0)
    dialog.setMinimumDuration(0)
    dialog.setWindowModality(Qt.WindowModality.ApplicationModal)
    loop = QEventLoop()
    look = QTimer(dialog, interval=_LOOK_MILLISECONDS)
    look.timeout.connect(lambda: loop.quit() if outcome.done() else None)
    dialog.canceled.connect(loop.quit)
    dialog.show()
    look.start()
    loop.exec()
    look.stop()
    dialog.hide()
    dialog.deleteLater()
