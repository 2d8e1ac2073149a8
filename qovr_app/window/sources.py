"""Documents as they come from files: read here or in the worker process, with the file's stamp."""

from __future__ import annotations

from pathlib import Path

from qovr_app.state.intents import Opened, Stamp
from qovr_core import Document, SourceError
from qovr_core.files import read_source, write_document
from qovr_core.files.sources import MADE_HERE, PRESET_PREFIX, SHAPE_PREFIX, local_path

DOCUMENT_SUFFIX = ".qovr"

_LARGE_BYTES = 1 << 18
"""The slowest reader takes a tenth of a second for so large a file."""


def opened_source(source: str) -> Opened:
    """Return what came of opening a file that carries a document, ``paper:NAME`` or ``shape:NAME``.

    Raises
    ------
    QovrError : the source cannot be read
    OSError : its path cannot be asked
    """
    if source.startswith(PRESET_PREFIX):
        name = source.removeprefix(PRESET_PREFIX)
        return Opened(read_source(source), name, preset=name, message=f"Opened {name}")
    if source.startswith(SHAPE_PREFIX):
        name = source.removeprefix(SHAPE_PREFIX)
        return Opened(read_source(source), name, message=f"Opened {name}")
    source = local_path(source)
    stamp = _stamp_if_told(Path(source))  # before it is read: a change on the way is noticed later
    document = read_source(source)
    path = Path(source).resolve()
    own = path if path.suffix.lower() == DOCUMENT_SUFFIX else None
    return Opened(document, path.name, own, stamp, message=f"Opened {path.name}")


def opened_by_worker(source: str, _report: object) -> Opened:
    """Do the same as a job."""
    return opened_source(source)


def opened_if_small(source: str) -> Opened | None:
    """Do the same; return None where reading takes so long that another process has to do it."""
    return None if is_large(source) else opened_source(source)


def is_large(source: str) -> bool:
    """Return whether reading a source takes so long that another process has to do it."""
    try:
        return not source.startswith(MADE_HERE) and Path(local_path(source)).stat().st_size > _LARGE_BYTES
    except (OSError, ValueError, SourceError):
        return False  # reading will say why


def place_of(source: str) -> Path | None:
    """Return where a source really stands; None for what is no file.

    Raises
    ------
    QovrError, OSError : it cannot be told
    """
    return None if source.startswith(MADE_HERE) else Path(local_path(source)).resolve()


def written_document(document: Document, path: Path) -> tuple[Path, Stamp | None]:
    """Write a document to a path; return where it really stands, and its stamp.

    Raises
    ------
    FileError : the file cannot be written
    OSError : its path cannot be asked
    """
    write_document(document, path)
    return path.resolve(), _stamp_if_told(path)


def file_stamp(path: Path) -> Stamp | None:
    """Return the stamp of a file; None where there is none.

    Raises
    ------
    OSError : it cannot be told
    """
    try:
        found = path.stat()
    except (FileNotFoundError, NotADirectoryError):
        return None
    return found.st_mtime_ns, found.st_size, found.st_ino


def _stamp_if_told(path: Path) -> Stamp | None:
    try:
        return file_stamp(path)
    except (OSError, ValueError):
        return None
