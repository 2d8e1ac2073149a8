"""Zip archives, bounded: by what their directory says before anything is unpacked, and by what comes out."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import PurePosixPath
from typing import BinaryIO

from qovr_core.errors import quoted

LARGEST_DIRECTORY = 1_000_000
"""Bytes; the directory of a workbook or of a NumPy archive takes a few thousand."""

_BLOCK = 1 << 20
_ENCRYPTED = 1

_KINDS = (zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED)
"""What workbooks and NumPy archives are packed with; the others unpack without a bound on what comes out at once."""


class _Bounded(io.BufferedReader):
    """A file of which not more is read at once than a directory may be long."""

    def read(self, size: int | None = -1, /) -> bytes:
        if size is not None and size > LARGEST_DIRECTORY + _BLOCK:
            raise ValueError(f"its directory claims {size:,} bytes; expected at most {LARGEST_DIRECTORY:,}")
        return super().read(LARGEST_DIRECTORY if size is None or size < 0 else size)


@contextmanager
def opened_archive(file: BinaryIO) -> Iterator[zipfile.ZipFile]:
    """Yield the archive in a file that is open for reading.

    Raises
    ------
    ValueError, zipfile.BadZipFile, OSError : it is no archive, or its directory is far too long
    """
    with io.FileIO(file.fileno(), closefd=False) as raw, zipfile.ZipFile(_Bounded(raw)) as archive:
        yield archive


def has(archive: zipfile.ZipFile, name: str) -> bool:
    """Return whether an archive has a member of a name."""
    return name in archive.NameToInfo


def blocks(archive: zipfile.ZipFile, name: str, largest: int) -> Iterator[bytes]:
    """Yield a member's content in blocks of at most a megabyte.

    Raises
    ------
    ValueError : there is no such member, it is packed in an unusual way, or it is longer than ``largest``, as the
        directory says or as it comes out
    zipfile.BadZipFile, zlib.error, EOFError : it is damaged
    """
    info, part = archive.NameToInfo.get(name), PurePosixPath(name).stem
    if info is None:
        raise ValueError(f"it has no part {quoted(name)}")
    if info.flag_bits & _ENCRYPTED:
        raise ValueError(f"{part} is encrypted")
    if info.compress_type not in _KINDS:
        raise ValueError(f"{part} is packed in a way that is not read; expected deflate")
    if info.file_size > largest:
        raise ValueError(f"{part} is {info.file_size:,} bytes long; expected at most {largest:,}")
    with archive.open(info) as member:
        length = 0
        while block := member.read(_BLOCK):
            length += len(block)
            if length > largest:
                raise ValueError(f"{part} unpacks to more than {largest:,} bytes")
            yield block


def content(archive: zipfile.ZipFile, name: str, largest: int) -> bytes:
    """Return a member's whole content; raises as ``blocks`` does."""
    return b"".join(blocks(archive, name, largest))
