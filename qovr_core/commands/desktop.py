"""``qovr desktop``: the program in the menus of a Linux desktop, and ``.qovr`` files that open with it."""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

from qovr_core.commands.common import DONE
from qovr_core.errors import QovrError
from qovr_core.files.atomic import replacing
from qovr_core.resources import resource

DESKTOP_NAME = "qovr-studio"
"""What the entry is called, by which a desktop finds the icon and the place of a window."""

_MIME_ICON = "application-x-qovr"

_ELSEWHERE = {
    "win32": "right-click a .qovr file, choose Open with, Another app, and qovr.exe in this Python's Scripts",
    "darwin": "select a .qovr file, choose File, Get Info, and under Open with an application that calls qovr",
}
"""How the same is done by hand where there are no desktop entries."""

_TIMEOUT_SECONDS = 60.0
"""A cache of a desktop is made anew in a second or two."""

_MIME_CACHES = (
    *("XMLnamespaces", "aliases", "generic-icons", "globs", "globs2", "icons", "magic", "mime.cache"),
    *("subclasses", "treemagic", "types", "version"),
)
"""What update-mime-database writes, also where there is nothing to say."""

_QUOTED = '"`$\\'
"""What has a backslash before it inside the quotes of an Exec line."""


def add_command(commands: Any) -> None:
    command = commands.add_parser(
        "desktop", help="put the program into the menus of this user's desktop, or take it out"
    )
    wish = command.add_mutually_exclusive_group(required=True)
    wish.add_argument("--install", action="store_true", help="entry, icon and the file type .qovr; again is no harm")
    wish.add_argument("--remove", action="store_true", help="take all of it away")
    command.set_defaults(command=_desktop)


def _desktop(arguments: argparse.Namespace) -> int:
    if sys.platform in _ELSEWHERE:
        raise QovrError(f"this system has no desktop entries: {_ELSEWHERE[sys.platform]}")
    data = _data_folder()
    if arguments.install:
        done, contents = "installed", _contents(data)
        for path, content in contents.items():
            _write(path, content)
        _refresh(data)
    else:
        done, contents = "removed", {path: b"" for path in _places(data) if path.exists()}
        for path in contents:
            path.unlink()
        _refresh(data)
        _clear(data)
    print("\n".join(f"{done} {path}" for path in contents) or "nothing was installed")
    return DONE


def _write(path: Path, content: bytes) -> None:
    path.parent.mkdir(parents=True, exist_ok=True)
    with replacing(path) as (draft,):
        draft.write_bytes(content)


def _data_folder() -> Path:
    """Return the folder of this user's data, as the XDG base directories say it."""
    told = os.environ.get("XDG_DATA_HOME", "")
    try:
        return Path(told) if Path(told).is_absolute() else Path.home() / ".local" / "share"
    except RuntimeError as error:  # the system knows of no home
        raise QovrError("there is no home folder; expected one, or XDG_DATA_HOME") from error


def _program() -> str:
    """Return where ``qovr`` itself stands: what was called, or what is installed beside this Python."""
    beside = Path(sys.executable).with_name("qovr")
    called = Path(sys.argv[0]).absolute()
    found = str(called) if called.name == "qovr" else str(beside) if beside.exists() else shutil.which("qovr")
    if found is None or "=" in found or "\n" in found:
        raise QovrError(f"{found or 'qovr'}: cannot stand in a desktop entry; expected a path without = and line ends")
    return found


def _places(data: Path) -> tuple[Path, Path, Path, Path]:
    """Return where entry, file type, and the icons of program and files belong."""
    scalable = data / "icons" / "hicolor" / "scalable"
    return (
        data / "applications" / f"{DESKTOP_NAME}.desktop",
        data / "mime" / "packages" / f"{DESKTOP_NAME}.xml",
        scalable / "apps" / f"{DESKTOP_NAME}.svg",
        scalable / "mimetypes" / f"{_MIME_ICON}.svg",
    )


def _contents(data: Path) -> dict[Path, bytes]:
    """Return what belongs where."""
    program = _program()
    entry = resource("desktop", f"{DESKTOP_NAME}.desktop").read_text(encoding="utf-8")
    entry = entry.replace("{exec}", exec_word(program)).replace("{program}", _escaped(program))
    kind = resource("desktop", f"{DESKTOP_NAME}.xml").read_bytes()
    icon = resource("icons", f"{DESKTOP_NAME}.svg").read_bytes()
    return dict(zip(_places(data), (entry.encode(), kind, icon, icon), strict=True))


def exec_word(text: str) -> str:
    """Return a text as one word of an Exec line: quoted as the shell does, then escaped as every value is.

    Examples
    --------
    >>> print(exec_word("/opt/my tools/100%/$x"))
    "/opt/my tools/100%%/\\\\$x"
    """
    quoted = "".join(f"\\{letter}" if letter in _QUOTED else letter for letter in text)
    return _escaped(f'"{quoted}"'.replace("%", "%%"))


def _escaped(text: str) -> str:
    return text.replace("\\", "\\\\")


def _refresh(data: Path) -> None:
    """Let the desktop read anew what it keeps in caches, by its own tools where they are."""
    for tool, folder in (
        ("update-mime-database", data / "mime"),
        ("update-desktop-database", data / "applications"),
    ):
        found = shutil.which(tool)
        if found is not None and folder.is_dir():
            with suppress(OSError, subprocess.TimeoutExpired):
                subprocess.run([found, str(folder)], capture_output=True, timeout=_TIMEOUT_SECONDS, check=False)
    with suppress(OSError):
        os.utime(data / "icons" / "hicolor")  # a cache of icons that is older is read no more


def _clear(data: Path) -> None:
    """Delete caches that say nothing any more, and folders that are empty now, up to the user's data."""
    mime, applications = data / "mime", data / "applications"
    if not any((mime / "packages").glob("*.xml")):
        for name in _MIME_CACHES:
            (mime / name).unlink(missing_ok=True)
    if not any(applications.rglob("*.desktop")):
        (applications / "mimeinfo.cache").unlink(missing_ok=True)
    for folder in (*(path.parent for path in _places(data)), mime / "application"):
        for empty in _up_to(data, folder):
            with suppress(OSError):  # it is in use
                empty.rmdir()


def _up_to(top: Path, folder: Path) -> Iterator[Path]:
    while folder != top:
        yield folder
        folder = folder.parent
