"""What can be copied for a spreadsheet or a page, and pasted from one."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from PySide6.QtGui import QGuiApplication, QImage

from qovr_app.state.intents import ValuesPasted
from qovr_app.state.looking_intents import MessageShown
from qovr_app.state.names import points_text
from qovr_app.state.requests import CopyAsked, PasteAsked
from qovr_app.state.typed import typed_block
from qovr_app.store import Store
from qovr_app.widgets.clipboard import copy_table, pasted_cells
from qovr_app.window.about import CITATION, report_text
from qovr_app.window.layout import Layout
from qovr_core import DocumentError, QovrError
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, Place

_ORDER = "row 0 of the net first"
"""In which points follow each other in a table."""


class Clipboard:
    """Copies zones, one coordinate of their points, the view as a picture, and what the probe says; pastes blocks."""

    def __init__(self, layout: Layout, store: Store) -> None:
        self._layout, self._store, self._dispatch = layout, store, store.dispatch
        self._copies: dict[str, Callable[[], str]] = {
            "zone": self._copy_zone,
            "plane": self._copy_plane,
            "probe": self._copy_probe,
            "measure": self._copy_measure,
            "points": self._copy_points,
            "picture": self._copy_picture,
            "citation": self._copy_citation,
            "report": self._copy_report,
        }

    def copy(self, request: CopyAsked) -> None:
        """Copy what the request names."""
        self._dispatch(MessageShown(self._copies[request.what]()))

    def paste(self, request: PasteAsked) -> None:
        """Paste a spreadsheet's block over the selected points, or into the zone that has the keyboard."""
        if request.over_points:
            self._paste_over_points()
        else:
            self._layout.current_zone().paste()

    def _selected(self) -> list[NetIndex]:
        """Return the selected points as tables have them: in the net's order."""
        return sorted(self._store.state.selection.points)

    def _paste_over_points(self) -> None:
        """Paste over the selected points; where none is selected, over all."""
        points = self._selected() or list(np.ndindex(self._store.state.document.control_points.shape[:2]))
        whose = "selected " if self._selected() else ""
        try:
            rows = typed_block(pasted_cells(), lambda rows, columns: (rows, columns) == (len(points), 3))
            if len(rows) != len(points) or len(rows[0]) != 3:
                found = f"{len(rows)} x {len(rows[0])} numbers"
                raise DocumentError("the block", found, f"{len(points)} x 3, a row for each {whose}point, {_ORDER}")
        except QovrError as error:
            self._dispatch(MessageShown(f"Nothing was pasted: {error}.", is_refusal=True))
            return
        values: dict[Place, float] = {
            CoordinatePlace(i, j, axis): row[axis]
            for (i, j), row in zip(points, rows, strict=True)
            for axis in range(3)
        }
        self._dispatch(ValuesPasted(values))

    def _copy_points(self) -> str:
        points, net = self._selected(), self._store.state.document.control_points
        copy_table([net[index].tolist() for index in points])
        return f"Copied {points_text(points)}"

    def _copy_citation(self) -> str:
        QGuiApplication.clipboard().setText(CITATION)
        return "Copied the paper's entry for BibTeX"

    def _copy_report(self) -> str:
        QGuiApplication.clipboard().setText(report_text(self._store.session))
        return "Copied versions and what was done, documents and names of files included; paste it into your report"

    def _copy_zone(self) -> str:
        zone = self._layout.current_zone()
        copy_table(zone.copied_block())
        return f"Copied the {zone.accessibleName().lower()}"

    def _copy_plane(self) -> str:
        copy_table(self._layout.zones.told(self._layout.zones.points).copied_plane())
        return "Copied one coordinate of the 25 points in the zone"

    def _copy_probe(self) -> str:
        text = self._layout.view_frame.probe_text()
        if not text:
            return "There is nothing under the probe (F8) to copy."
        QGuiApplication.clipboard().setText(text)
        return "Copied what the probe says"

    def _copy_measure(self) -> str:
        from qovr_app.view3d.words import measure_words

        text = measure_words(self._layout.view_frame.view.picture())
        if not text:
            return "Nothing is measured: choose Points, Tool, Measure and click two places."
        QGuiApplication.clipboard().setText(text)
        return "Copied what is measured"

    def _copy_picture(self) -> str:
        image = self._layout.view_frame.image()
        QGuiApplication.clipboard().setImage(image.convertToFormat(QImage.Format.Format_RGB32))
        return f"Copied the picture of {image.width()} × {image.height()} pixels"
