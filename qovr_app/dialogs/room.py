"""The room that a dialog may take."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtWidgets import QDialog

_FRAME = QSize(16, 48)
"""Logical pixels that the system's frame, and a bar of its own, may take beside and above a dialog."""


def resize_within_screen(dialog: QDialog, wanted: QSize) -> None:
    """Give a dialog its first size, or what its screen has room for: its buttons have to be reachable."""
    dialog.resize(wanted.boundedTo(dialog.screen().availableSize() - _FRAME))
