"""What keeps the start of the window short."""

from __future__ import annotations

import builtins
import gc
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def starting() -> Iterator[None]:
    """Import and make what a window needs, without looking through it for garbage on the way.

    What is there at the end stays until the program ends, and so it is not looked through later either.
    """
    gc.disable()
    plain_import = builtins.__import__
    import PySide6.QtCore  # noqa: F401

    # WORKAROUND: from here on PySide6 would read the source of every module that is imported, to see whether it could
    # ask for snake_case names (https://doc.qt.io/qtforpython-6/considerations.html#features). None of these does.
    builtins.__import__ = plain_import
    try:
        yield
    finally:
        gc.freeze()
        gc.enable()
