"""By how much the selected control points are moved, scaled and rotated."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QGridLayout, QLabel, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state.names import AXES
from qovr_app.style.palette import theme_in_force
from qovr_app.style.symbols import coloured, sentence_html
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import named
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import QovrError
from qovr_core.checks import checked_number
from qovr_core.net_edits import About, Transform, Triple
from qovr_core.number_texts import natural_step

_ABOUT = {About.CENTROID: "their centroid", About.LAST: "the point picked last"}


class TransformDialog(QDialog):
    """Asks for a move, a scaling and a rotation; ``edit`` is what the fields say.

    Parameters
    ----------
    points : what is transformed, as "4 points"
    scale : the size of the net, by which the keys' steps are chosen

    Signals
    -------
    changed : the fields say another edit
    """

    changed = Signal(object)

    def __init__(self, points: str, scale: float, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("transform")
        self.setWindowTitle(f"Transform {points}")
        self._scale = scale
        grid = QGridLayout(self)
        for k, letter in enumerate(AXES, start=1):
            grid.addWidget(QLabel(f"<i>{letter}</i>", self), 0, k)
        self._move = self._row(grid, 1, "Move by", "move", 0.0)
        self._factors = self._row(grid, 2, "Scale by", "scale", 1.0)
        self._degrees = self._field("rotate", "Degrees", 0.0)
        self._axis = named(QComboBox(self), "transform.axis", "Axis of the rotation")
        self._axis.addItems([f"about {letter}" for letter in AXES])
        self._axis.setCurrentIndex(len(AXES) - 1)
        self._about = named(QComboBox(self), "transform.about", "What stays where it is")
        guard_from_wheels(self._axis, self._about)
        self._about.addItems(list(_ABOUT.values()))
        for box in (self._axis, self._about):
            box.currentIndexChanged.connect(self._check)
        for row, label, widgets in ((3, "Rotate by °", (self._degrees, self._axis)), (4, "Scale, rotate about", ())):
            grid.addWidget(QLabel(label, self), row, 0)
            for k, widget in enumerate(widgets, start=1):
                grid.addWidget(widget, row, k)
        grid.addWidget(self._about, 4, 1, 1, 3)
        self._note = named(QLabel(self), "transform.note")
        self._note.setTextFormat(Qt.TextFormat.RichText)
        self._note.setWordWrap(True)
        grid.addWidget(self._note, 5, 0, 1, 4)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        grid.addWidget(without_icons(buttons), 6, 0, 1, 4)
        self._move[-1].setFocus()
        self._move[-1].selectAll()

    @property
    def edit(self) -> Transform:
        """What the fields say.

        Raises
        ------
        QovrError : a field holds no number
        """
        x, y, z = (field.typed() for field in self._move)
        a, b, c = (field.typed() for field in self._factors)
        about = list(_ABOUT)[self._about.currentIndex()]
        displacement: Triple = (x, y, z)
        return Transform(displacement, (a, b, c), self._axis.currentIndex(), self._degrees.typed(), about)

    def _row(self, grid: QGridLayout, row: int, label: str, name: str, value: float) -> list[NumberField]:
        grid.addWidget(QLabel(label, self), row, 0)
        fields = [self._field(f"{name}.{letter}", f"{label} {letter}", value) for letter in AXES]
        for k, field in enumerate(fields, start=1):
            grid.addWidget(field, row, k)
        return fields

    def _field(self, name: str, label: str, value: float) -> NumberField:
        field = named(
            NumberField(label, checked_number, lambda number: natural_step(number, self._scale), self),
            f"transform.{name}",
            label,
        )
        field.show_value(value)
        field.textChanged.connect(self._check)
        return field

    def say(self, text: str, *, is_refusal: bool = False) -> None:
        """Say where the points come to stand, or why they cannot."""
        self._note.setText(coloured(sentence_html(text), theme_in_force().bad) if is_refusal else sentence_html(text))
        self._ok.setEnabled(not is_refusal)

    def _check(self) -> None:
        """Report what the fields say; let nothing wrong be accepted."""
        try:
            edit = self.edit
        except QovrError as error:
            self.say(f"{error}.", is_refusal=True)
        else:
            self.changed.emit(edit)
