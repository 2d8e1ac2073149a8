"""Functions that are imported when they are called: a table can name what only one of its records needs."""

from __future__ import annotations

from collections.abc import Callable
from importlib import import_module
from typing import Any


def later(module: str, name: str) -> Callable[..., Any]:
    """Return a function that calls another one, whose module is imported the first time.

    >>> root = later("math", "sqrt")
    >>> root(9.0)
    3.0
    """

    def call(*arguments: Any, **options: Any) -> Any:
        return getattr(import_module(module), name)(*arguments, **options)

    call.__module__, call.__name__ = module, name
    return call
