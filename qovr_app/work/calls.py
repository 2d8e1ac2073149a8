"""Calls that another process can make: functions, values, and records that it would not know by itself."""

from __future__ import annotations

import io
import pickle
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack
from importlib import import_module
from types import FunctionType
from typing import Any

from qovr_core.registry import Registry

Call = tuple[Callable[..., Any], tuple[Any, ...]]
"""A function and its values, but for the last: where to report to."""

_TABLES_OF = "qovr_core."
"""Where tables of records are."""


def packed(call: Call) -> bytes | None:
    """Return a call with the records registered from outside; None where it only can be made here.

    Functions and records go by reference. What a script or a function has defined for itself has none that another
    process could follow.
    """
    buffer = io.BytesIO()
    try:
        pickler = _Pickler(buffer)
        pickler.dump(_extras())
        pickler.clear_memo()
        pickler.dump(call)
    except Exception:  # whatever a value's own way of being pickled raises
        return None
    return buffer.getvalue()


def unpacked(content: bytes, registered: ExitStack) -> Call:
    """Return a packed call, its records registered until ``registered`` ends.

    Raises
    ------
    Exception : whatever following a reference raises where it leads nowhere
    """
    buffer = io.BytesIO(content)
    for module, name, record in pickle.load(buffer):
        registered.enter_context(getattr(import_module(module), name).register(record))
    call: Call = pickle.load(buffer)
    return call


class _Pickler(pickle.Pickler):
    """Refuses what is found by its name in the running script: that of the other process is another one."""

    def reducer_override(self, value: Any) -> Any:
        if isinstance(value, (FunctionType, type)) and value.__module__ == "__main__":
            raise pickle.PicklingError(f"{value.__qualname__} is of the running script")
        return NotImplemented


def _extras() -> list[tuple[str, str, object]]:
    """Return every record that was registered from outside, with its table's module and name there."""
    return [(module, name, record) for module, name, table in _tables() for record in table.extras()]


def _tables() -> Iterator[tuple[str, str, Registry[Any]]]:
    """Yield every table once, by one of its names. A module that nobody has imported has been given no record."""
    seen: set[int] = set()
    for module, content in list(sys.modules.items()):
        if not module.startswith(_TABLES_OF):
            continue
        for name, value in list(vars(content).items()):
            if isinstance(value, Registry) and id(value) not in seen:
                seen.add(id(value))
                yield module, name, value
