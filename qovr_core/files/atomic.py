"""Files that appear whole or not at all."""

from __future__ import annotations

import os
import secrets
import shutil
import time
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager, suppress
from pathlib import Path

from qovr_core.errors import FileError

DRAFT_PREFIX, DRAFT_SUFFIX = ".qovr-", ".part"
"""What the names of drafts, and of folders with parts of them, begin and end with."""

_ABANDONED_SECONDS = 24 * 3600.0
"""A draft not touched for so long was left by a killed process: no write takes a day."""


@contextmanager
def replacing(*targets: Path) -> Iterator[tuple[Path, ...]]:
    """Yield a new empty file beside each target; on success they take the targets' places, else they vanish.

    Whatever ends the block early - a full disk, an interrupt, a cancelled progress - leaves the targets as
    they were.

    Raises
    ------
    FileError : a file cannot be made, written or put in its place
    """
    places = [Path(os.path.realpath(target)) for target in targets]
    for folder in {place.parent for place in places}:
        _sweep(folder)
    with ExitStack() as stack:
        drafts = tuple(
            stack.enter_context(_draft(target, place)) for target, place in zip(targets, places, strict=True)
        )
        try:
            yield drafts
            for draft in drafts:
                _flush_to_disk(draft)
            for draft, place in zip(drafts, places, strict=True):
                draft.replace(place)
            for folder in {place.parent for place in places}:
                _flush_folder(folder)
        except OSError as error:
            raise unwritable(targets[0], error) from error


def unwritable(path: Path, error: OSError) -> FileError:
    """Return the error to raise where writing a path failed."""
    return FileError(f"{path}: cannot be written: {error.strerror or error}")


@contextmanager
def _draft(target: Path, place: Path) -> Iterator[Path]:
    if place.is_dir():
        raise FileError(f"{target}: cannot be written: it is a folder; expected a file name")
    if not place.parent.is_dir():
        raise FileError(f"{target}: cannot be written: the folder {target.parent} does not exist")
    if place.exists() and not os.access(place, os.W_OK):
        raise FileError(f"{target}: cannot be written: the file is write-protected")
    draft = place.parent / f"{DRAFT_PREFIX}{secrets.token_hex(6)}{DRAFT_SUFFIX}"
    try:
        draft.touch(exist_ok=False)
        if place.exists():
            shutil.copymode(place, draft)
    except OSError as error:
        draft.unlink(missing_ok=True)
        raise unwritable(target, error) from error
    try:
        yield draft
    finally:
        draft.unlink(missing_ok=True)


def _sweep(folder: Path) -> None:
    """Delete what killed processes left in a folder, as far as that can be done."""
    limit = time.time() - _ABANDONED_SECONDS
    with suppress(OSError):
        drafts = list(folder.glob(f"{DRAFT_PREFIX}*{DRAFT_SUFFIX}"))
        for draft in (draft for draft in drafts if draft.lstat().st_mtime < limit):
            if draft.is_dir():
                shutil.rmtree(draft, ignore_errors=True)
            else:
                draft.unlink(missing_ok=True)


def _flush_to_disk(path: Path) -> None:
    with path.open("rb+") as file:
        os.fsync(file.fileno())


def _flush_folder(folder: Path) -> None:
    if os.name != "posix":
        return  # only POSIX systems let a folder be opened and synced
    descriptor = os.open(folder, os.O_RDONLY)
    try:
        os.fsync(descriptor)
    finally:
        os.close(descriptor)
