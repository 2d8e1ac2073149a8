"""The standard streams and the signals of a process that runs one command."""

from __future__ import annotations

import os
import signal
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from types import FrameType
from typing import NoReturn, TextIO

from qovr_core.errors import one_line

ENDING_SIGNALS = (signal.SIGINT, signal.SIGTERM)

_MOMENT = 0.002
"""Seconds in which a finaliser has ended, as a rule."""


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
def interruptible() -> Iterator[Callable[[], None]]:
    """Let the first ending signal raise Interrupted, and no later one disturb the tidying up that follows.

    A signal that is ignored stays so, as Ctrl-C for what a shell runs in the background. Where Python passes no
    exception on, as out of a finaliser, the signal comes again a moment later. Libraries in C and C++ that call Python
    may put an error of their own in its place: what is yielded raises Interrupted again where a signal has raised it.
    """
    interruption = _Interruption()

    def interrupt(number: int, frame: FrameType | None) -> None:
        if _is_within(frame, come_again):  # nor does Python pass one on from there: it comes once more
            return
        for other in before:
            signal.signal(other, signal.SIG_IGN)
        interruption.take(number)

    def come_again(lost: sys.UnraisableHookArgs) -> None:
        if not isinstance(lost.exc_value, Interrupted):
            hook_before(lost)
            return
        for other in before:
            signal.signal(other, interrupt)
        interruption.repeat(lost.exc_value.number)

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
        yield interruption.raise_again
    finally:
        interruption.end()  # so that none comes when the signals are others' again
        sys.unraisablehook = hook_before
        for number, handler in before.items():
            signal.signal(number, handler)


class _Interruption:
    """A signal that has been raised, or comes again and again until it is taken."""

    def __init__(self) -> None:
        self._is_taken = True
        self._raised: Interrupted | None = None
        self._threads: list[threading.Thread] = []

    def take(self, number: int) -> NoReturn:
        self._is_taken, self._raised = True, Interrupted(number)
        raise self._raised

    def raise_again(self) -> None:
        if self._raised is not None:
            raise self._raised

    def repeat(self, number: int) -> None:
        self._is_taken, self._raised = False, None
        self._threads.append(threading.Thread(target=self._repeat, args=(number,)))
        self._threads[-1].start()

    def end(self) -> None:
        self._is_taken = True
        for thread in self._threads:
            thread.join()

    def _repeat(self, number: int) -> None:
        while not self._is_taken:
            time.sleep(_MOMENT)
            if not self._is_taken:
                _signal_main_thread(number)


def _signal_main_thread(number: int) -> None:
    """Send a signal to the thread that takes signals: sent to another, it would not end what this one waits for."""
    main = threading.main_thread().ident
    if main is not None and hasattr(signal, "pthread_kill"):
        signal.pthread_kill(main, number)
    else:
        signal.raise_signal(number)


def _is_within(frame: FrameType | None, function: Callable[..., object]) -> bool:
    """Return whether a frame is one of a function, or of what it calls."""
    while frame is not None and frame.f_code is not function.__code__:
        frame = frame.f_back
    return frame is not None


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
