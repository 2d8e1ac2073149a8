"""The zone of the control points: the net as it lies in space, every point with its three coordinates."""

from __future__ import annotations

from itertools import product

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.names import AXES, HEIGHT
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.clipboard import Rows
from qovr_app.widgets.header_label import HeaderLabel
from qovr_app.widgets.number_field import Snapping
from qovr_app.widgets.parts import MARGINS
from qovr_app.zones.headings import Headings
from qovr_app.zones.zone import FieldZone, no_place
from qovr_core import Document
from qovr_core.checks import checked_number
from qovr_core.document import NetIndex
from qovr_core.edits import CoordinatePlace, Place, Zone
from qovr_core.geometry.windows import NET_SIZE
from qovr_core.number_texts import natural_step

_ROWS = range(NET_SIZE - 1, -1, -1)
"""Rows from the top of the window down."""

_ROWS_FIRST = 100
"""How much more of the height that is left goes to the rows than under them, until they are as high as they may be."""


class PointsZone(FieldZone):
    """The coordinates of the 25 control points."""

    longest = "-0.123456"
    _check = staticmethod(checked_number)

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(Zone.CONTROL_POINTS, symbol_html("P", "i,j"), store, parent)
        self._snapping = Snapping(lambda: store.state.tools.snap_step, lambda: store.state.tools.snaps)
        self._headings = Headings(store, self.fields, lambda: self.shown_window)
        self._layout.setContentsMargins(SPACE, MARGINS[1], SPACE, MARGINS[3])
        self._layout.addLayout(self._make_grid(), _ROWS_FIRST)
        self._layout.addLayout(self._make_buttons())
        self._layout.addStretch(1)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        super().show_state(before, after)
        if after.differs(before, "selection", "window"):
            for place, field in self.fields.items():
                if isinstance(place, CoordinatePlace):
                    field.set_marked((place.i, place.j) in after.selection.points)

    def copied_block(self) -> Rows:
        return [[self.fields[place].value for place in row] for row in self._points()]

    def copied_plane(self) -> Rows:
        """Return one coordinate of all points, 5 x 5 as the net lies: that of the field that had the keyboard last."""
        return [[self.fields[place].value for place in row] for row in self._plane()]

    @property
    def _coordinate(self) -> CoordinatePlace:
        """The coordinate whose field has, or had last, the keyboard."""
        place = self._place
        return place if isinstance(place, CoordinatePlace) else CoordinatePlace(0, 0, 0)

    def _step(self, coordinate: float) -> float:
        return natural_step(coordinate, self._store.state.draft.net_size)

    def _tip(self, place: Place, _document: Document) -> str:
        if not isinstance(place, CoordinatePlace):
            return ""
        i, j, axis = place.i, place.j, AXES[place.axis]
        return f"P {i},{j}: the {axis} coordinate of the control point in row {i}, column {j}."

    def _points(self) -> list[list[Place]]:
        points = product(range(NET_SIZE), repeat=2)
        return [[self._shown(CoordinatePlace(i, j, axis)) for axis in range(3)] for i, j in points]

    def _plane(self) -> list[list[Place]]:
        axis = self._coordinate.axis
        return [[self._shown(CoordinatePlace(i, j, axis)) for j in range(NET_SIZE)] for i in _ROWS]

    def _places_of_block(self, rows: int, columns: int) -> list[list[Place]]:
        i, j = self._coordinate.i, self._coordinate.j
        point: list[Place] = [CoordinatePlace(i, j, axis) for axis in range(3)]
        shapes = {(25, 3): self._points(), (5, 5): self._plane(), (1, 3): [point], (3, 1): [[place] for place in point]}
        try:
            return shapes[rows, columns]
        except KeyError:
            expected = "25 x 3 for the zone's points, 5 x 5 for one coordinate of them, or three numbers for one point"
            raise no_place(rows, columns, expected) from None

    def _line_header(self, html: str, name: str, points: list[NetIndex], axis: int = HEIGHT) -> HeaderLabel:
        """Return the heading of a line of the net, which changes one coordinate of its points."""
        places = [CoordinatePlace(i, j, axis) for i, j in points]
        header = self._headings.heading(html, f"{self.zone}.{name}", places, points)
        header.set_quiet()
        return header

    def _make_grid(self) -> QGridLayout:
        grid = QGridLayout()
        grid.setHorizontalSpacing(SPACE // 2)  # what is left over is the numbers'
        grid.setVerticalSpacing(1)
        for j in range(NET_SIZE):
            header = self._line_header(f"<i>j</i> = {j}", f"column_{j}", [(i, j) for i in range(NET_SIZE)])
            grid.addWidget(header, 0, j + 2, Qt.AlignmentFlag.AlignRight)
            grid.setColumnStretch(j + 2, 1)
        line = 1
        for i in _ROWS:
            row = [(i, j) for j in range(NET_SIZE)]
            grid.addWidget(self._line_header(f"<i>i</i> = {i}", f"row_{i}", row), line, 0)
            for axis, letter in enumerate(AXES):
                header = self._line_header(f"<i>{letter}</i>", f"row_{i}.{letter}", row, axis)
                grid.addWidget(header, line + axis, 1)
                grid.setRowStretch(line + axis, 1)
            for j in range(NET_SIZE):
                for axis in range(3):
                    field = self._make_field(CoordinatePlace(i, j, axis), self._step)
                    grid.addWidget(field, line + axis, j + 2)
            line += 4
            if i:
                grid.setRowMinimumHeight(line - 1, SPACE)
        return grid
