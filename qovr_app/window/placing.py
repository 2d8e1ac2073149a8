"""Where a window stands on the screens there are."""

from __future__ import annotations

from PySide6.QtCore import QRect
from PySide6.QtWidgets import QWidget

_FRAME = 32
"""Logical pixels that the system's frame may take around and above a window that was not shown yet."""

_ASIDE = 28
"""Logical pixels: a title bar's height, so that the title of the window behind can be read."""


def fit_into_screen(window: QWidget) -> None:
    """Move and shrink a window until all of it is on its screen; one kept from a larger screen need not be."""
    screen = window.screen()
    if screen is None or window.isMaximized() or window.isFullScreen():
        return
    room = screen.availableGeometry()
    inside = fitted(window.geometry(), room)
    if inside != window.geometry():
        window.setGeometry(inside)


def place_beside(window: QWidget, other: QWidget | None) -> None:
    """Give a window the size of another one, and move it a little aside so that both are seen."""
    if other is not None and not other.isMaximized() and not other.isFullScreen():
        window.setGeometry(other.geometry().translated(_ASIDE, _ASIDE))


def fitted(place: QRect, room: QRect) -> QRect:
    """Return the rectangle next to a place that lies in a room, with a frame above it where it had to move."""
    if room.contains(place):
        return place
    width, height = min(place.width(), room.width()), min(place.height(), room.height() - _FRAME)
    left = min(max(place.left(), room.left()), room.left() + room.width() - width)
    top = min(max(place.top(), room.top() + _FRAME), room.top() + room.height() - height)
    return QRect(left, top, width, height)
