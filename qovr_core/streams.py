"""The standard streams and the signals of a process that runs one command."""

from __future__ import annotations

import os
import signal
import sys
import threading
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from typing import NoReturn, TextIO

from qovr_core.errors import one_line

ENDING_SIGNALS = (signal.SIGINT, signal.SIGTERM)

_MOMENT = 0.002
"""Seconds in which a finaliser has ended."""


class Interrupted(KeyboardInterrupt):
    """Ctrl-C or SIGTERM came.

    Parameters
    ----------
    number : of the signal
    """

    def __init__(self, number: int) -> None:
        super().__init__()
        self.number = number


@contextmanager
def interruptible() -> Iterator[None]:
    """Let the first ending signal raise Interrupted, and no later one disturb the tidying up that follows.

    A signal that is ignored stays so, as Ctrl-C for what a shell runs in the background. Where Python passes no
    exception on, as out of a finaliser, the signal comes again a moment later.
    """

    def interrupt(number: int, _frame: object) -> NoReturn:
        for other in before:
            signal.signal(other, signal.SIG_IGN)
        raise Interrupted(number)

    def come_again(lost: sys.UnraisableHookArgs) -> None:
        if not isinstance(lost.exc_value, Interrupted):
            hook_before(lost)
            return
        for other in before:
            signal.signal(other, interrupt)
        threading.Timer(_MOMENT, signal.raise_signal, (lost.exc_value.number,)).start()

    hook_before = sys.unraisablehook
    before = {
        number: handler
        for number in ENDING_SIGNALS
        if (handler := signal.getsignal(number)) not in (signal.SIG_IGN, None)
    }
    try:
        sys.unraisablehook = come_again
        for number in before:
            signal.signal(number, interrupt)
        yield
    finally:
        sys.unraisablehook = hook_before
        for number, handler in before.items():
            signal.signal(number, handler)


def mend_streams() -> None:
    """Open those standard streams that were closed, and let names that are no valid text be printed.

    Else the next file to be opened would take a closed stream's place. Nothing can be written to the stand-in of
    stdout, so that an answer nobody gets is told from one that was given.
    """
    for descriptor, (name, flags, mode) in enumerate(_STREAMS):
        if getattr(sys, name) is None:
            with suppress(OSError):
                opened = os.open(os.devnull, flags)
                if opened == descriptor:
                    setattr(sys, name, os.fdopen(opened, mode, closefd=False))
                else:  # the stream is open, but Python has none, as without a console on Windows
                    os.close(opened)
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


_STREAMS = (("stdin", os.O_RDONLY, "r"), ("stdout", os.O_RDONLY, "w"), ("stderr", os.O_WRONLY, "w"))


def say(text: str) -> None:
    """Write one line to stderr; where that cannot be, the exit code says what there is to say."""
    try:
        sys.stderr.write(f"qovr: {one_line(text)}\n")
        sys.stderr.flush()
    except OSError:
        forsake(sys.stderr)


def forsake(stream: TextIO | None) -> None:
    """Send what a stream still holds to nowhere, so that Python does not try it again at its end."""
    with suppress(OSError, ValueError, AttributeError):
        nowhere = os.open(os.devnull, os.O_WRONLY)
        os.dup2(nowhere, stream.fileno() if stream is not None else nowhere)
        os.close(nowhere)
