"""Whether a window can be had, asked before Qt is: where it cannot, Qt ends the process without a word to anybody."""

from __future__ import annotations

import ctypes
import os
import socket
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, cast

from PySide6.QtCore import QCoreApplication, QPluginLoader

from qovr_core import QovrError

_X, _WAYLAND = "xcb", ("wayland", "wayland-egl", "wayland-brcm")
_ALWAYS = ("offscreen", "minimal", "vnc", "windows", "cocoa")
"""Platforms that need nothing which could be missing."""

_PLATFORM, _PLUGIN_PATH = "QT_QPA_PLATFORM", "QT_QPA_PLATFORM_PLUGIN_PATH"
_SECONDS = 10.0
"""After this long something does not answer."""

_PAUSE = 0.2
"""Seconds in which a display that starts anew is there again."""

_TRIAL = "from PySide6.QtGui import QGuiApplication; QGuiApplication(['qovr'])"


def check_display() -> None:
    """Refuse in words where Qt would abort the process.

    Raises
    ------
    QovrError : no window can be had; it says why, and for an unknown platform which ones there are
    """
    wanted = os.environ.get(_PLATFORM, "")
    names = [part.partition(":")[0].strip() for part in wanted.split(";")] if wanted else _by_environment()
    if sys.platform != "linux" and not wanted:
        return
    if not names:
        raise QovrError("there is no display; the window needs one, a virtual one serves (xvfb-run qovr ...)")
    reasons = [_reason_against(name) for name in names]
    if all(reasons):
        raise QovrError(f"no window can be opened: {reasons[0]}")


def _by_environment() -> list[str]:
    """Return the platforms among which Qt chooses where it is not told."""
    variables = {"WAYLAND_DISPLAY": _WAYLAND[0], "DISPLAY": _X}
    return [name for variable, name in variables.items() if os.environ.get(variable)]


def _reason_against(name: str) -> str:
    """Return why Qt cannot use a platform; empty where it can."""
    plugins = _plugins()
    if name not in plugins:
        return f"{_PLATFORM} is {name!r}; expected one of {', '.join(sorted(plugins))}"
    loader = QPluginLoader(str(plugins[name]))
    if not loader.load():
        return " ".join(f"the platform {name!r} cannot be loaded: {loader.errorString()}".split())
    if name == _X:
        return _reason_against_x()
    if name in _WAYLAND:
        return _reason_against_wayland()
    return "" if name in _ALWAYS or _is_tried(name) else f"the platform {name!r} does not start on this machine"


def _plugins() -> dict[str, Path]:
    """Return the files of Qt's platforms by their names."""
    folders = [Path(path) / "platforms" for path in QCoreApplication.libraryPaths()]
    folders += [Path(path) for path in os.environ.get(_PLUGIN_PATH, "").split(os.pathsep) if path]
    files = [file for folder in folders if folder.is_dir() for file in sorted(folder.iterdir())]
    described = {file: cast("dict[str, Any]", QPluginLoader(str(file)).metaData()) for file in files}
    return {key: file for file, data in described.items() for key in data.get("MetaData", {}).get("Keys", [])}


def _reason_against_x() -> str:
    """Return why the X display cannot be used, as the library says that Qt will ask.

    A connection that stands is left open: a virtual display whose last client goes starts anew, and for a moment, in
    which Qt would ask, lets nobody in.
    """
    display = os.environ.get("DISPLAY", "")
    try:
        xcb = ctypes.CDLL("libxcb.so.1")
    except OSError as error:
        return f"the library of X is missing ({error})"
    xcb.xcb_connect.restype = ctypes.c_void_p
    xcb.xcb_connection_has_error.argtypes = xcb.xcb_disconnect.argtypes = [ctypes.c_void_p]
    for pause in (_PAUSE, _PAUSE, 0.0):
        connection = xcb.xcb_connect(None, None)
        if not xcb.xcb_connection_has_error(connection):
            return ""
        xcb.xcb_disconnect(connection)
        time.sleep(pause)
    return f"the display {display!r} (DISPLAY) does not answer, or lets nobody in"


def _reason_against_wayland() -> str:
    display = os.environ.get("WAYLAND_DISPLAY") or "wayland-0"
    path = Path(os.environ.get("XDG_RUNTIME_DIR", "/")) / display
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.settimeout(_SECONDS)
        try:
            connection.connect(str(path))
        except OSError:
            return f"the display {display!r} (WAYLAND_DISPLAY) does not answer"
    return ""


def _is_tried(name: str) -> bool:
    """Return whether a process with nothing to lose gets on with a platform that depends on the machine's devices."""
    try:
        trial = subprocess.run(
            [sys.executable, "-c", _TRIAL],
            env={**os.environ, _PLATFORM: name},
            capture_output=True,
            timeout=_SECONDS,
            check=False,
        )
    except (OSError, subprocess.TimeoutExpired):
        return False
    return trial.returncode == 0
