"""Between processes of one user: a later start hands what it was to open over to the one that runs.

Who holds the lock beside the socket listens; the system lets the lock go when its process dies, and so a socket that a
dead process has left is known for what it is. Whoever is not answered soon goes on by itself.
"""

from __future__ import annotations

import hashlib
import json
import os
import stat
import sys
import tempfile
import time
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path

from PySide6.QtCore import QObject, QStandardPaths, Signal
from PySide6.QtNetwork import QLocalServer, QLocalSocket

from qovr_app.window.preferences import present_folder
from qovr_app.window.process_lock import Hold, ProcessLock
from qovr_core import QovrError
from qovr_core.files.sources import MADE_HERE, local_path

_PATIENCE_SECONDS = 3.0
"""A process that has begun to start listens and answers by then, also on a slow machine."""

_TRIAL_MILLISECONDS = 200
_TAKEN = b"taken"
_MOST_BYTES = 1 << 20
"""More than the longest command line of any system."""

_LONGEST_ADDRESS = 100
"""Bytes in the path of a socket; some systems take no more than 103."""


class Post(QObject):
    """The process' end: either it listens for later starts, or it hands over to the one that does.

    Signals
    -------
    came : the sources that a later start was to open, a tuple of texts
    """

    came = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        place = _meeting_place()
        self._address = place[0] if place else ""
        self._lock = ProcessLock(place[1]) if place else None
        self._server: QLocalServer | None = None

    def is_handed_over(self, sources: Sequence[str]) -> bool:
        """Return whether another process opens these sources; if none does, listen for later starts where that can be.

        Parameters
        ----------
        sources : as on the command line; none at all asks for a window with the paper's example
        """
        message = json.dumps([_from_anywhere(source) for source in sources]).encode()
        end = time.monotonic() + _PATIENCE_SECONDS
        while self._lock is not None and time.monotonic() < end:
            hold = self._lock.take()
            if hold is Hold.OURS:
                self._listen()
                return False
            if hold is Hold.NOBODYS:
                return False
            if _is_taken(self._address, message, end):
                return True
            time.sleep(_TRIAL_MILLISECONDS / 1000)
        return False

    def close(self) -> None:
        """Listen no more."""
        if self._server is not None:
            self._server.close()
        if self._lock is not None:
            self._lock.let_go()

    def _listen(self) -> None:
        QLocalServer.removeServer(self._address)  # what a dead process has left: nobody else has the lock
        self._server = QLocalServer(self)
        self._server.setSocketOptions(QLocalServer.SocketOption.UserAccessOption)
        self._server.newConnection.connect(self._on_called)
        self._server.listen(self._address)

    def _on_called(self) -> None:
        while self._server is not None and (caller := self._server.nextPendingConnection()) is not None:
            caller.readyRead.connect(lambda caller=caller: self._read(caller))
            caller.disconnected.connect(caller.deleteLater)
            self._read(caller)

    def _read(self, caller: QLocalSocket) -> None:
        if caller.bytesAvailable() > _MOST_BYTES:
            caller.abort()
        if not caller.canReadLine():
            return
        try:
            sources = json.loads(bytes(caller.readLine().data()))
        except ValueError:
            sources = None
        is_message = isinstance(sources, list) and all(isinstance(source, str) for source in sources)
        if is_message:
            caller.write(_TAKEN)
            caller.flush()
        caller.disconnectFromServer()
        if is_message:
            self.came.emit(tuple(sources))


def _is_taken(address: str, message: bytes, end: float) -> bool:
    """Return whether the process that listens has taken a message."""
    socket = QLocalSocket()
    socket.connectToServer(address)
    if not socket.waitForConnected(_TRIAL_MILLISECONDS):
        return False
    socket.write(message + b"\n")
    answer = b""
    while answer != _TAKEN and (left := end - time.monotonic()) > 0:
        if not socket.bytesAvailable() and not socket.waitForReadyRead(max(1, round(1000 * left))):
            break
        answer += bytes(socket.readAll().data())
    return answer == _TAKEN


def _from_anywhere(source: str) -> str:
    """Return a source as a process with another present folder finds it."""
    if source.startswith(MADE_HERE):
        return source
    try:
        return str(present_folder() / local_path(source))
    except QovrError:
        return source  # the window will say why


def _meeting_place() -> tuple[str, Path] | None:
    """Return where the processes of this user with these settings and on this display meet: address and lock."""
    places = QStandardPaths.StandardLocation.GenericConfigLocation, QStandardPaths.StandardLocation.GenericDataLocation
    display = [os.environ.get(name, "") for name in ("QT_QPA_PLATFORM", "DISPLAY", "WAYLAND_DISPLAY")]
    told = "\0".join([*map(QStandardPaths.writableLocation, places), *display])
    name = f"qovr-{hashlib.sha256(told.encode()).hexdigest()[:16]}"
    folder = _own_folder()
    if folder is None:
        return None
    address = name if sys.platform == "win32" else str(folder / name)
    return (address, folder / f"{name}.lock") if len(os.fsencode(address)) <= _LONGEST_ADDRESS else None


def _own_folder() -> Path | None:
    """Return a folder that nobody else reaches into; None where there is none."""
    if sys.platform == "win32":
        return Path(tempfile.gettempdir())  # it is the user's own there
    runtime = os.environ.get("XDG_RUNTIME_DIR", "")
    if runtime and _is_own(Path(runtime)):
        return Path(runtime)
    folder = Path(tempfile.gettempdir()) / f"qovr-{os.getuid()}"
    with suppress(OSError):
        folder.mkdir(mode=0o700, exist_ok=True)
    return folder if _is_own(folder) else None


def _is_own(folder: Path) -> bool:
    """Return whether a folder is this user's, and closed to everybody else."""
    if sys.platform == "win32":
        return True
    try:
        status = folder.lstat()
    except OSError:
        return False
    others = stat.S_IRWXG | stat.S_IRWXO
    return stat.S_ISDIR(status.st_mode) and status.st_uid == os.getuid() and not status.st_mode & others
