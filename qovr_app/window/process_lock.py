"""A file that is locked for as long as its process lives: the system itself lets it go when the process dies.

Nothing is concluded from what the file says - a process number may be another one's by now, and a computer may have got
another name.
"""

from __future__ import annotations

import os
import sys
from contextlib import suppress
from enum import Enum
from pathlib import Path

if sys.platform == "win32":
    import msvcrt

    def _lock(descriptor: int) -> None:
        msvcrt.locking(descriptor, msvcrt.LK_NBLCK, 1)

else:
    import fcntl

    def _lock(descriptor: int) -> None:
        fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)


class Hold(Enum):
    """What came of asking for a lock."""

    OURS = "ours"
    OTHERS = "others"
    NOBODYS = "nobody's"
    """It cannot be had here, as in a folder that may only be read; but nobody else has it either."""


class ProcessLock:
    """The lock on one path."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._descriptor: int | None = None

    def take(self) -> Hold:
        """Ask for the lock, without waiting."""
        while True:
            try:
                descriptor = self._opened()
            except OSError:
                return Hold.NOBODYS
            try:
                _lock(descriptor)
            except BlockingIOError:
                os.close(descriptor)
                return Hold.OTHERS
            except PermissionError:  # how Windows says that it is locked
                os.close(descriptor)
                return Hold.OTHERS
            except OSError:  # a share without locks
                os.close(descriptor)
                return Hold.NOBODYS
            if self._is_the_file(descriptor):
                self._descriptor = descriptor
                return Hold.OURS
            os.close(descriptor)  # somebody has let it go meanwhile, and its file with it

    def let_go(self) -> None:
        """Let the lock go, and delete its file, where it is held."""
        if self._descriptor is None:
            return
        if sys.platform != "win32":
            self._delete()
        os.close(self._descriptor)
        self._descriptor = None
        if sys.platform == "win32":
            self._delete()

    def _delete(self) -> None:
        with suppress(OSError):
            self._path.unlink(missing_ok=True)

    def _opened(self) -> int:
        try:
            return os.open(self._path, os.O_RDWR | os.O_CREAT, 0o600)
        except OSError:
            return os.open(self._path, os.O_RDONLY)

    def _is_the_file(self, descriptor: int) -> bool:
        try:
            return os.path.samestat(os.fstat(descriptor), self._path.stat())
        except OSError:
            return False
