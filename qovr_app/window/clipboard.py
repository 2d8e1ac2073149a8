"""What can be copied for a spreadsheet or a page, and pasted from one."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtGui import QGuiApplication, QImage

from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.requests import CopyAsked, PasteAsked
from qovr_app.store import Dispatch
from qovr_app.widgets.clipboard import copy_table
from qovr_app.window.layout import Layout


class Clipboard:
    """Copies zones, one coordinate of all points, the view as a picture, and what the probe says; pastes blocks."""

    def __init__(self, layout: Layout, dispatch: Dispatch) -> None:
        self._layout, self._dispatch = layout, dispatch
        self._copies: dict[str, Callable[[], str]] = {
            "zone": self._copy_zone,
            "plane": self._copy_plane,
            "probe": self._copy_probe,
            "picture": self._copy_picture,
        }

    def copy(self, request: CopyAsked) -> None:
        """Copy what the request names."""
        self._dispatch(MessageShown(self._copies[request.what]()))

    def paste(self, _request: PasteAsked) -> None:
        """Paste a spreadsheet's block into the zone that has the keyboard."""
        self._layout.current_zone().paste()

    def _copy_zone(self) -> str:
        zone = self._layout.current_zone()
        copy_table(zone.copied_block())
        return f"Copied the {zone.accessibleName().lower()}"

    def _copy_plane(self) -> str:
        copy_table(self._layout.points.copied_plane())
        return "Copied one coordinate of all control points"

    def _copy_probe(self) -> str:
        text = self._layout.view_frame.probe_text()
        if not text:
            return "There is nothing under the probe (F8) to copy."
        QGuiApplication.clipboard().setText(text)
        return "Copied what the probe says"

    def _copy_picture(self) -> str:
        image = self._layout.view_frame.image()
        QGuiApplication.clipboard().setImage(image.convertToFormat(QImage.Format.Format_RGB32))
        return f"Copied the picture of {image.width()} × {image.height()} pixels"
