"""In which planes rows and columns mirror each other."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtWidgets import QCheckBox, QComboBox, QDialog, QDialogButtonBox, QGridLayout, QLabel, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state.names import AXES
from qovr_app.style.symbols import sentence_html
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import named
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import QovrError
from qovr_core.arrays import Array
from qovr_core.checks import checked_number
from qovr_core.net_moves import Mirror
from qovr_core.number_texts import natural_step

_WHAT = {0: "row", 1: "column"}
"""What a mirror turns round, by the axis of the net."""


class SymmetryDialog(QDialog):
    """Asks for the axis and the place of both planes; ``mirrors`` is what the fields say, in the order given.

    Parameters
    ----------
    net : the control points, (rows, columns, 3), whose middle lines are what a plane stands at by itself
    """

    def __init__(self, mirrors: tuple[Mirror, ...], net: Array, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("symmetry")
        self.setWindowTitle("Planes of Symmetry")
        grid = QGridLayout(self)
        self._rows = [_PlaneRow(self, grid, line, mirror, net) for line, mirror in enumerate(mirrors)]
        self._note = named(QLabel(self), "symmetry.note")
        self._note.setWordWrap(True)
        grid.addWidget(self._note, len(mirrors), 0, 1, 4)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        grid.addWidget(without_icons(buttons), len(mirrors) + 1, 0, 1, 4)
        for row in self._rows:
            row.on_changed(self._check)
        self._check()

    @property
    def mirrors(self) -> tuple[Mirror, ...]:
        """The planes as the fields say them.

        Raises
        ------
        QovrError : a field holds no number
        """
        return tuple(row.mirror for row in self._rows)

    def _check(self) -> None:
        """Say what the planes do; let nothing wrong be accepted."""
        try:
            _ = self.mirrors
        except QovrError as error:
            self._note.setText(sentence_html(f"{error}."))
            self._ok.setEnabled(False)
        else:
            self._note.setText("Symmetric moves use the axes, Make symmetric the places too.")
            self._ok.setEnabled(True)


class _PlaneRow:
    """One plane: its axis, and whether it stands at the mean of the middle line, or where else."""

    def __init__(self, dialog: QWidget, grid: QGridLayout, line: int, mirror: Mirror, net: Array) -> None:
        self._net, self._turned, what = net, mirror.axis, _WHAT[mirror.axis]
        self._axis = named(QComboBox(dialog), f"symmetry.{what}s.axis", f"Axis across {what}s")
        guard_from_wheels(self._axis)
        self._axis.addItems([f"{letter} =" for letter in AXES])
        self._axis.setCurrentIndex(mirror.coordinate)
        self._place = named(
            NumberField(f"the place across {what}s", checked_number, lambda value: natural_step(value, 0.0), dialog),
            f"symmetry.{what}s.place",
            f"Place of the plane across {what}s",
        )
        self._middle = named(QCheckBox(f"mean of the middle {what}", dialog), f"symmetry.{what}s.middle")
        self._middle.setChecked(mirror.at is None)
        self._place.show_value(mirror.place(net))
        for column, widget in enumerate((QLabel(f"Across {what}s", dialog), self._axis, self._place, self._middle)):
            grid.addWidget(widget, line, column)
        self._axis.currentIndexChanged.connect(self._follow)
        self._middle.toggled.connect(self._follow)
        self._place.textEdited.connect(lambda _text: self._middle.setChecked(False))
        self._place.gesture_begun.connect(lambda _gesture: self._middle.setChecked(False))

    @property
    def mirror(self) -> Mirror:
        place = None if self._middle.isChecked() else self._place.typed()
        return Mirror(self._turned, self._axis.currentIndex(), place)

    def on_changed(self, call: Callable[[], object]) -> None:
        self._place.textChanged.connect(lambda _text: call())
        self._axis.currentIndexChanged.connect(lambda _index: call())
        self._middle.toggled.connect(lambda _is_on: call())

    def _follow(self) -> None:
        """Show where the middle line lies while the plane stands there."""
        if self._middle.isChecked():
            self._place.show_value(Mirror(self._turned, self._axis.currentIndex()).place(self._net))
            self._place.revert()
