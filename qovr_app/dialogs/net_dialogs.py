"""What is asked before joints and nets become others: how sharp, of how many windows; and what comes of it."""

from __future__ import annotations

from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QDialog, QDialogButtonBox, QFormLayout, QLabel, QSpinBox, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.style.palette import theme_in_force
from qovr_app.style.symbols import coloured, sentence_html
from qovr_app.widgets.number_field import NumberField
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import QovrError
from qovr_core.checks import checked_number
from qovr_core.document import Window
from qovr_core.structure.change import MOST_WINDOWS
from qovr_core.structure.joints import STRONGEST_CREASE

_FIRST_CREASE = 0.2
_STEP = 0.05


class NetDialog(QDialog):
    """Shows what becomes of the net, and lets it be or puts it back.

    Signals
    -------
    changed : the fields say something else
    """

    changed = Signal()

    def __init__(self, name: str, title: str, question: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setWindowTitle(title)
        self.form = QFormLayout(self)
        self.form.addRow(plain_label(question, self))
        self._note = named(QLabel(self), f"{name}.note")
        self._note.setTextFormat(Qt.TextFormat.RichText)
        self._note.setWordWrap(True)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Ok | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self.accept)
        buttons.rejected.connect(self.reject)
        self._ok = buttons.button(QDialogButtonBox.StandardButton.Ok)
        self.form.addRow(self._note)
        self.form.addRow(without_icons(buttons))

    def say(self, text: str, *, is_refusal: bool = False) -> None:
        """Say how far the surface moves, or why it cannot be."""
        self._note.setText(coloured(sentence_html(text), theme_in_force().bad) if is_refusal else sentence_html(text))
        self._ok.setEnabled(not is_refusal)

    def _insert(self, label: str, field: QWidget) -> None:
        self.form.insertRow(self.form.rowCount() - 2, label, field)


class CreaseDialog(NetDialog):
    """Asks how sharp a crease is; ``strength`` is what the field says."""

    def __init__(self, question: str, parent: QWidget | None = None) -> None:
        super().__init__("crease", "Crease", question, parent)
        self._field = named(
            NumberField("the crease", checked_number, lambda _value: _STEP, self), "crease.strength", "Crease"
        )
        self._field.show_value(_FIRST_CREASE)
        self._field.textChanged.connect(self._check)
        self._insert(f"&Strength, 0 to {STRONGEST_CREASE}", self._field)
        self._field.setFocus()
        self._field.selectAll()

    @property
    def strength(self) -> float:
        """What the field says; raises QovrError where it holds no number."""
        return self._field.typed()

    def _check(self) -> None:
        try:
            _ = self.strength
        except QovrError as error:
            self.say(f"{error}.", is_refusal=True)
        else:
            self.changed.emit()


class ResampleDialog(NetDialog):
    """Asks for the windows of another net; ``windows`` and ``is_even`` are what the fields say."""

    def __init__(self, windows: Window, parent: QWidget | None = None) -> None:
        super().__init__("resample", "Resample", "A net of so many windows runs through the surface.", parent)
        self._v, self._u = (
            self._count(f"resample.{letter}", f"Windows along {letter}", count)
            for letter, count in zip("vu", windows, strict=True)
        )
        self._even = named(QCheckBox("at even steps of the parameters, all knots 0.5", self), "resample.even")
        self._even.setChecked(True)
        self._even.setToolTip(
            "Else where the points there are lie, spread over the windows, and knots that go with them"
        )
        self._insert("Windows along &u", self._u)
        self._insert("Windows along &v", self._v)
        self._insert("", self._even)
        guard_from_wheels(self._u, self._v)
        for box in (self._u, self._v):
            box.valueChanged.connect(lambda _value: self.changed.emit())
        self._even.toggled.connect(lambda _is_on: self.changed.emit())

    @property
    def windows(self) -> Window:
        """Along v and along u."""
        return self._v.value(), self._u.value()

    @property
    def is_even(self) -> bool:
        """Whether the surface is met at even steps of its parameters."""
        return self._even.isChecked()

    def _count(self, name: str, label: str, count: int) -> QSpinBox:
        box = named(QSpinBox(self), name, label)
        box.setRange(1, MOST_WINDOWS)
        box.setValue(count)
        box.setKeyboardTracking(False)
        return box
