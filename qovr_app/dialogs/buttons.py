"""What the dialogs share."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QIcon
from PySide6.QtWidgets import QDialogButtonBox, QLabel, QPushButton

from qovr_core import QovrError


def without_icons(box: QDialogButtonBox) -> QDialogButtonBox:
    """Return the box with plain buttons: the style's own icons are of another kind than everything else here."""
    for button in box.buttons():
        button.setIcon(QIcon())
    return box


def allow(ok: QPushButton, note: QLabel, read: Callable[[], object]) -> None:
    """Say what is wrong with what is typed, by what reading it raises, and let nothing wrong be accepted."""
    reason = ""
    try:
        read()
    except QovrError as error:
        reason = f"{error}."
    note.setText(reason)
    ok.setEnabled(not reason)
