"""The program's own icon, drawn at the sizes that title bars, task bars and switchers ask for."""

from __future__ import annotations

from PySide6.QtCore import QByteArray
from PySide6.QtGui import QIcon, QPixmap
from PySide6.QtSvg import QSvgRenderer

from qovr_app.style.canvas import blank_image, painting
from qovr_core.resources import resource

_SIZES = (16, 22, 24, 32, 48, 64, 128, 256)
"""Pixels."""


def program_icon() -> QIcon:
    """Return the icon."""
    content = resource("icons", "qovr-studio.svg").read_bytes()
    drawing, icon = QSvgRenderer(QByteArray(content)), QIcon()
    for size in _SIZES:
        image = blank_image((size, size), 1.0)
        with painting(image) as painter:
            painter.setRenderHint(painter.RenderHint.Antialiasing)
            drawing.render(painter)
        icon.addPixmap(QPixmap.fromImage(image))
    return icon
