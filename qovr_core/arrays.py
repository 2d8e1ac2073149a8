"""The array types of the package and the one way to hand an array out."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[np.float64]
Floats = npt.NDArray[np.float64] | npt.NDArray[np.float32]
Indices = npt.NDArray[np.intp]
Flags = npt.NDArray[np.bool_]


def read_only(array: npt.NDArray[Any]) -> npt.NDArray[Any]:
    """Return the array itself, locked against writing."""
    array.setflags(write=False)
    return array


def handed_out(array: npt.NDArray[Any], out: npt.NDArray[Any] | None) -> npt.NDArray[Any]:
    """Return an array, locked against writing unless it is the caller's own."""
    return array if out is not None else read_only(array)


def checked_out(out: npt.NDArray[Any] | None, shape: tuple[int, ...]) -> npt.NDArray[Any]:
    """Return the array to which values of a shape are written: the caller's, or else a new one of float64.

    The caller's may have gaps, as a part of a larger array has, but not its axes in another order, for it would be
    filled at a fraction of the speed.

    Raises
    ------
    TypeError : it is no array of float64 or float32
    ValueError : it has another shape, is not in C order, or is read-only
    """
    if out is None:
        return np.empty(shape)
    if not isinstance(out, np.ndarray):
        raise TypeError(f"out is of type {type(out).__name__}; expected an array of float64 or float32")
    if out.dtype not in (np.float64, np.float32):
        raise TypeError(f"out has dtype {out.dtype}; expected float64 or float32")
    if out.shape != shape:
        raise ValueError(f"out has shape {out.shape}; expected {shape}")
    if not out.flags.writeable:
        raise ValueError("out is read-only; expected an array that can be written to")
    inner = out.itemsize
    for count, stride in zip(shape[::-1], out.strides[::-1], strict=True):
        if count > 1 and stride < inner:
            raise ValueError(f"out has strides {out.strides}; expected C order, in which the last index runs fastest")
        inner = max(inner, count * stride)
    return out
