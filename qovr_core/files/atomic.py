"""Files that appear whole or not at all: the one way in which anything is written."""

from __future__ import annotations

import logging
import os
import re
import stat
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, nullcontext, suppress
from pathlib import Path

from qovr_core.errors import FileError, reason_of
from qovr_core.files.drafts import new_draft, sweep, turn

LOGGER = logging.getLogger("qovr_core.files")
"""Tells, as a warning, what a user ought to know of a file that was written all the same."""

IS_WINDOWS = os.name == "nt"

_RESERVED_NAME = re.compile(r"(?:con|prn|aux|nul|com[0-9¹²³]|lpt[0-9¹²³]|conin\$|conout\$) *(?:\..*)?", re.IGNORECASE)
_FORBIDDEN = '<>:"|?*'
"""What Windows keeps for its devices, and what no name there holds: after a colon stands another stream of a file."""


@contextmanager
def replacing(*targets: Path) -> Iterator[tuple[Path, ...]]:
    """Yield a new empty file beside each target; on success they take the targets' places, else they vanish.

    Whatever ends the block early - a full disk, an interrupt, a cancelled progress - leaves the targets as they were.
    Several targets take their places one after the other, with no other process in between. Links are followed. A file
    that was there keeps its mode, and its group and owner where the system allows; a new one gets its mode from the
    system.

    Raises
    ------
    FileError : a file cannot be made, written or put in its place
    """
    places = [check_target(target) for target in targets]
    folders = {place.parent for place in places}
    for folder in folders:
        sweep(folder)
    with ExitStack() as stack:
        drafts = tuple(
            stack.enter_context(_draft(target, place)) for target, place in zip(targets, places, strict=True)
        )
        try:
            yield drafts
            for draft in drafts:
                _flush_to_disk(draft)
            with turn(places[0].parent) if len(places) > 1 else nullcontext():
                for draft, target, place in zip(drafts, targets, places, strict=True):
                    _tell_of_new_owner(target, place, draft)
                    draft.replace(place)
            for folder in folders:
                _flush_folder(folder)
        except OSError as error:
            raise unwritable(targets[0], error) from error


def check_target(target: Path) -> Path:
    """Return where a target really stands, itself no link; nothing needs to be there, and nothing is opened.

    Raises
    ------
    FileError : as far as can be told beforehand, no file can be written there
    """
    try:
        place = Path(os.path.realpath(target))
        reason = _name_refusal(target) or _refusal(target, place)
    except OSError as error:
        raise unwritable(target, error) from error
    except ValueError as error:
        raise FileError(f"{target}: cannot be written: no name holds a NUL character") from error
    if reason:
        raise FileError(f"{target}: cannot be written: {reason}")
    return place


def made_folder(folder: Path) -> Path:
    """Return a folder, which is made where it is not yet.

    Raises
    ------
    FileError : it cannot be made, or a file has its name
    """
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except FileExistsError as error:
        raise FileError(f"{folder}: is a file; expected a folder") from error
    except OSError as error:
        raise FileError(f"{folder}: cannot be made: {reason_of(error)}") from error
    except ValueError as error:
        raise FileError(f"{folder}: cannot be made: no name holds a NUL character") from error
    return folder


def unwritable(path: Path, error: OSError) -> FileError:
    """Return the error to raise where writing a path failed."""
    return FileError(f"{path}: cannot be written: {reason_of(error)}")


def _refusal(target: Path, place: Path) -> str:
    """Return why no file can stand at a place; empty where one can."""
    if not place.parent.is_dir():
        return f"the folder {target.parent} does not exist"
    try:
        mode = place.stat().st_mode
    except FileNotFoundError:
        mode = stat.S_IFREG
        is_writable = True
    else:
        is_writable = os.access(place, os.W_OK)
    if stat.S_ISDIR(mode):
        return "it is a folder; expected a file name"
    if not stat.S_ISREG(mode):
        return "it is a device or a pipe; expected a file"
    if not is_writable:
        return "the file is write-protected"
    if not os.access(place.parent, os.W_OK | os.X_OK):
        return f"Permission denied: no new file may be made in {target.parent}"
    return ""


def _name_refusal(target: Path) -> str:
    """Return why Windows takes no file of a name, empty where it does; other systems take every name."""
    if not IS_WINDOWS:
        return ""
    for part in target.parts[len(target.anchor) > 0 :]:
        if _RESERVED_NAME.fullmatch(part):
            return f"Windows keeps the name {part} for a device"
        if part not in (".", "..") and part != part.rstrip(". "):
            return f"Windows takes no name that ends in a dot or a space, as '{part}'"
        if any(character in _FORBIDDEN or ord(character) < 32 for character in part):
            return f"Windows takes no name with any of {' '.join(_FORBIDDEN)}, as '{part}'"
    return ""


@contextmanager
def _draft(target: Path, place: Path) -> Iterator[Path]:
    with ExitStack() as stack:
        try:
            draft = stack.enter_context(new_draft(place.parent))
            if place.exists():
                _take_over(draft, place.stat())
        except OSError as error:
            raise unwritable(target, error) from error
        yield draft


def _take_over(draft: Path, before: os.stat_result) -> None:
    """Give a draft the owner, group and mode of the file it replaces, as far as the system allows.

    Where the group cannot be kept, another one gets no more than all the others had.
    """
    mode = stat.S_IMODE(before.st_mode)
    if hasattr(os, "chown"):
        for owner, group in ((-1, before.st_gid), (before.st_uid, -1)):
            with suppress(OSError):
                os.chown(draft, owner, group)
        if draft.stat().st_gid != before.st_gid:
            mode = mode & ~stat.S_IRWXG | (mode & stat.S_IRWXO) << 3
    with suppress(OSError):  # some shares refuse; their files have the mode that the share gives them
        draft.chmod(mode)


def _tell_of_new_owner(target: Path, place: Path, draft: Path) -> None:
    if place.exists() and place.stat().st_uid != draft.stat().st_uid:
        LOGGER.warning("%s: belongs to you now; the system does not allow it to be given to its owner again", target)


def _flush_to_disk(path: Path) -> None:
    with path.open("ab") as file:
        os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    """Make the new names last, where that can be asked for: only on POSIX systems, and not on every share."""
    if os.name != "posix":
        return
    with suppress(OSError):
        descriptor = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(descriptor)
        finally:
            os.close(descriptor)
