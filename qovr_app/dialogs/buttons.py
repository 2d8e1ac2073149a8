"""What the dialogs share."""

from __future__ import annotations

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QDialogButtonBox


def without_icons(box: QDialogButtonBox) -> QDialogButtonBox:
    """Return the box with plain buttons: the style's own icons are of another kind than everything else here."""
    for button in box.buttons():
        button.setIcon(QIcon())
    return box
