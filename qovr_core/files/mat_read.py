"""Reading arrays out of ``.mat`` files of versions 5 to 7, bounds checked.

Written here because SciPy's reader ends the whole process on some damaged files.
"""

from __future__ import annotations

import math
import zlib
from collections.abc import Callable, Container, Iterator
from functools import partial
from typing import Any, BinaryIO

import numpy as np
import numpy.typing as npt

from qovr_core.checks import Verbatim
from qovr_core.files.array_document import LARGEST_INPUT

_HEADER_BYTES, _TAG_BYTES = 128, 8
_ORDERS = {b"IM": "<", b"MI": ">"}
_MATRIX, _COMPRESSED = 14, 15
_NUMBERS = {1: "i1", 2: "u1", 3: "i2", 4: "u2", 5: "i4", 6: "u4", 7: "f4", 9: "f8", 12: "i8", 13: "u8"}
_TEXTS = {16: "utf-8", 17: "utf-16", 18: "utf-32"}
_WHOLE_NUMBERS = _NUMBERS.keys() - {7, 9}
_CELL_CLASS, _CHAR_CLASS, _NUMERIC_CLASSES = 1, 4, range(6, 16)
_COMPLEX = 0x0800

_HEAD_BYTES = 1024
"""Flags, shape and name of an array fit in; so much is looked at of those that are not wanted."""

_MOST_ELEMENTS = 100_000
"""A file of more arrays is taken for a damaged one: each step through it may be as short as eight bytes."""


def read_arrays(file: BinaryIO, wanted: Container[str]) -> dict[str, npt.NDArray[Any] | Verbatim]:
    """Return the arrays of some names; numbers in their shape, a char array as one text.

    A cell array of one cell is what stands in the cell.

    Raises
    ------
    OSError : the file cannot be read
    ValueError : the file is no MATLAB file, is cut off, or a wanted array is larger than an input can be
    """
    header = file.read(_HEADER_BYTES)
    order = _ORDERS.get(header[126:128])
    if order is None:
        raise ValueError("it does not begin with the header of a MATLAB 5 file")
    version = int.from_bytes(header[124:126], "little" if order == "<" else "big")
    if version != 0x0100:
        raise ValueError("its version is 7.3; expected one saved as -v7 or older")
    arrays: dict[str, npt.NDArray[Any] | Verbatim] = {}
    for content, length in _matrices(file, order):
        kind, name = _Fields(content(_HEAD_BYTES), order).head()
        if name in wanted:
            if length > LARGEST_INPUT:
                raise ValueError(f"{name} is {length:,} bytes long; expected at most {LARGEST_INPUT:,}")
            fields = _Fields(content(LARGEST_INPUT), order)
            fields.head()
            arrays[name] = fields.value(kind)
    return arrays


def _matrices(file: BinaryIO, order: str) -> Iterator[tuple[Callable[[int], bytes], int]]:
    """Yield of every matrix what gives its content up to a number of bytes, and its length."""
    for _ in range(_MOST_ELEMENTS):
        if not (tag := file.read(_TAG_BYTES)):
            return
        kind, length = np.frombuffer(_whole(tag, _TAG_BYTES), f"{order}u4").tolist()
        end = file.tell() + length
        stored = _whole(file.read(min(length, LARGEST_INPUT)), min(length, LARGEST_INPUT))
        if is_packed := kind == _COMPRESSED:
            tag = zlib.decompressobj().decompress(stored, _TAG_BYTES)
            kind, length = np.frombuffer(_whole(tag, _TAG_BYTES), f"{order}u4").tolist()
        if kind == _MATRIX:
            yield partial(_content, stored, is_packed), length
        file.seek(end)
    raise ValueError(f"it has more than {_MOST_ELEMENTS:,} elements")


def _content(stored: bytes, is_packed: bool, most: int) -> bytes:
    """Return the first bytes of a matrix's content; no more of it is unpacked."""
    if is_packed:
        return zlib.decompressobj().decompress(stored, _TAG_BYTES + most)[_TAG_BYTES:]
    return stored[:most]


def _whole(content: bytes, length: int) -> bytes:
    if len(content) < length:
        raise ValueError("it is cut off")
    return content


class _Fields:
    """The elements inside one matrix, in their order."""

    def __init__(self, content: bytes, order: str, *, is_in_cell: bool = False) -> None:
        self._content = content
        self._order = order
        self._is_in_cell = is_in_cell
        self._place = 0
        self._shape: list[int] = []

    def head(self) -> tuple[int, str]:
        """Read flags, shape and name; return the flags and the name."""
        flags = self._numbers(_WHOLE_NUMBERS)
        if flags.size < 1:
            raise ValueError("an array has no flags")
        self._shape = self._numbers(_WHOLE_NUMBERS).tolist()
        name = self._numbers(_WHOLE_NUMBERS).astype("u1").tobytes()
        return int(flags[0]), name.decode("ascii", errors="replace")

    def value(self, flags: int) -> npt.NDArray[Any] | Verbatim:
        """Read what the head announced."""
        matrix_class = flags & 0xFF
        if matrix_class == _CHAR_CLASS:
            return np.array(self._text())
        if matrix_class == _CELL_CLASS and math.prod(self._shape) == 1 and not self._is_in_cell:
            kind, content = self._element()
            if kind == _MATRIX:
                fields = _Fields(content, self._order, is_in_cell=True)
                return fields.value(fields.head()[0])
        if matrix_class not in _NUMERIC_CLASSES or flags & _COMPLEX:
            return Verbatim("no array of real numbers and no text")
        numbers = self._numbers(_NUMBERS)
        if min(self._shape) < 0 or math.prod(self._shape) != numbers.size:
            raise ValueError(f"a matrix of shape {self._shape} holds {numbers.size} numbers")
        with np.errstate(invalid="ignore"):  # signalling NaNs
            return numbers.reshape(self._shape, order="F").astype(np.float64)

    def _element(self) -> tuple[int, bytes]:
        tag = _whole(self._content[self._place : self._place + _TAG_BYTES], _TAG_BYTES)
        kind, length = np.frombuffer(tag, f"{self._order}u4").tolist()
        if kind >> 16:  # a small element: type, length and data share the eight bytes
            kind, length = kind & 0xFFFF, kind >> 16
            start, self._place = self._place + 4, self._place + _TAG_BYTES
        else:
            start = self._place + _TAG_BYTES
            self._place = start + length + -length % _TAG_BYTES
        return kind, _whole(self._content[start : start + length], length)

    def _numbers(self, kinds: Container[int]) -> npt.NDArray[Any]:
        kind, content = self._element()
        if kind not in kinds:
            raise ValueError(f"an element of kind {kind} stands where numbers belong")
        return np.frombuffer(content, self._order + _NUMBERS[kind])

    def _text(self) -> str:
        kind, content = self._element()
        if kind in _TEXTS:
            ends = {"<": "-le", ">": "-be"}[self._order] if kind != 16 else ""
            return content.decode(_TEXTS[kind] + ends)
        if kind not in _WHOLE_NUMBERS:
            raise ValueError(f"an element of kind {kind} stands where text belongs")
        return "".join(map(chr, np.frombuffer(content, self._order + _NUMBERS[kind]).tolist()))
