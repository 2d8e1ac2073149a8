"""Foreign text - names of files, keys, messages - shown letter by letter: never markup, never an access key."""

from __future__ import annotations

import html

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QLabel, QWidget

_PLACE_OF_MARK = "[*]"
"""Where a window's title has the mark of what is not saved; written twice, it stands for itself."""


def plain_tip(text: str) -> str:
    """Return what a tip is given to show a text as it is: tips have no format, and guess one."""
    if "<" not in text and "&" not in text:
        return text
    return f"<span>{html.escape(text, quote=False)}</span>".replace("\n", "<br>")


def menu_text(text: str) -> str:
    """Return what a menu or button is given to show a text as it is; a tab would begin a shortcut there."""
    return " ".join(text.split()).replace("&", "&&")


def title_text(text: str) -> str:
    """Return what a window's title is given to show a text as it is."""
    return " ".join(text.split()).replace(_PLACE_OF_MARK, 2 * _PLACE_OF_MARK)


def plain_label(text: str, parent: QWidget | None = None) -> QLabel:
    """Return a label that takes no text for markup."""
    result = QLabel(parent)
    result.setTextFormat(Qt.TextFormat.PlainText)
    result.setText(text)
    return result
