"""The one way in which files are opened for reading: whatever goes wrong is one sentence that begins with the path."""

from __future__ import annotations

import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from qovr_core.errors import DocumentError, FileError, reason_of


@contextmanager
def reading(path: Path, refusal: str = "") -> Iterator[BinaryIO]:
    """Yield a file that is open for reading.

    Whatever the block raises becomes a FileError, since a damaged file fails in as many ways as there are decoders.

    Parameters
    ----------
    refusal : words before the reason, such as ``is no whole NumPy archive:``, where a library gives it

    Raises
    ------
    FileError : there is no such file, it may not be read, or is none; or its content is not what the block expects
    """
    try:
        check_readable(path)
        with path.open("rb") as file:
            yield file
    except (FileError, MemoryError):
        raise
    except DocumentError as error:
        raise FileError(f"{path}: {error}") from error
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {reason_of(error)}") from error
    except Exception as error:
        raise FileError(f"{path}: {refusal}{refusal and ' '}{reason_of(error)}") from error


def check_readable(path: Path) -> None:
    """Refuse what is no file, without opening it: a pipe would wait for ever, a device may act.

    Raises
    ------
    FileError : nothing is there, what is there is no file, or it cannot be asked
    """
    try:
        mode = path.stat().st_mode
    except OSError as error:
        raise FileError(f"{path}: cannot be read: {reason_of(error)}") from error
    except ValueError as error:
        raise FileError(f"{path}: cannot be read: no name holds a NUL character") from error
    if stat.S_ISDIR(mode):
        raise FileError(f"{path}: is a folder; expected a file")
    if not stat.S_ISREG(mode):
        raise FileError(f"{path}: is a device or a pipe; expected a file")
