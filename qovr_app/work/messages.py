"""What the program and its worker process say to each other, and how it goes through a pipe."""

from __future__ import annotations

import logging
import pickle
import struct
from dataclasses import dataclass
from typing import IO, Any

from qovr_core import QovrError

_LENGTH = struct.Struct("!Q")


@dataclass(frozen=True)
class Run:
    """Begin a job: its number, the call as ``calls.packed`` makes it, and the folder in which relative paths begin."""

    number: int
    call: bytes
    folder: str


@dataclass(frozen=True)
class Cancel:
    """End a job at its next report."""

    number: int


@dataclass(frozen=True)
class Reported:
    """What a job has handed to its ``report``."""

    number: int
    values: tuple[Any, ...]


@dataclass(frozen=True)
class Done:
    """A job has returned this."""

    number: int
    result: Any


@dataclass(frozen=True)
class Failed:
    """A job has ended with an error."""

    number: int
    error: QovrError


@dataclass(frozen=True)
class Cancelled:
    """A job has ended where it was told to."""

    number: int


@dataclass(frozen=True)
class Unknown:
    """A job's function or values mean nothing in the other process."""

    number: int


@dataclass(frozen=True)
class Logged:
    """Something for the log, which is the program's."""

    record: logging.LogRecord


def write_message(stream: IO[bytes], message: object) -> None:
    """Write one message and send it off.

    Raises
    ------
    OSError : nobody reads any more
    Exception : whatever being pickled raises where something in it cannot; nothing is written then
    """
    content = pickle.dumps(message)
    stream.write(_LENGTH.pack(len(content)))
    stream.write(content)
    stream.flush()


def read_message(stream: IO[bytes]) -> Any:
    """Return the next message, or None where nobody writes any more."""
    head = stream.read(_LENGTH.size)
    if len(head) < _LENGTH.size:
        return None
    (length,) = _LENGTH.unpack(head)
    content = stream.read(length)
    return pickle.loads(content) if len(content) == length else None
