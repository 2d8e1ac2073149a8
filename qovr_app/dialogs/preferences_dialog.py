"""What a person prefers: a row for each choice, which holds as soon as it is made."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QComboBox, QDialog, QDialogButtonBox, QFormLayout, QVBoxLayout, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.parts import named, words
from qovr_app.widgets.wheel import guard_from_wheels

_NOTE = "Preferences never change what the command line writes."
_LEAST_WIDTH = 460
"""Logical pixels: the longest choice in one line."""


@dataclass(frozen=True)
class PreferenceRow:
    """One choice.

    Parameters
    ----------
    name : what the field is called by programs, after "preferences."
    label : what stands before it, with its access key
    tip : what it is for, in one sentence
    choices : what can be chosen, and how it is said
    usual : what holds while nobody has chosen
    """

    name: str
    label: str
    tip: str
    choices: Mapping[str, str]
    usual: str


class PreferencesDialog(QDialog):
    """Shows the choices and tells of each that is made.

    Parameters
    ----------
    rows : the choices, each with what holds now

    Signals
    -------
    chosen : the name of a row, and the choice
    """

    chosen = Signal(str, str)

    def __init__(self, rows: Sequence[tuple[PreferenceRow, str]], parent: QWidget) -> None:
        super().__init__(parent)
        self.setWindowTitle("Preferences")
        self.setObjectName("preferences")
        self.setMinimumWidth(_LEAST_WIDTH)
        form = QFormLayout()
        form.setFieldGrowthPolicy(QFormLayout.FieldGrowthPolicy.AllNonFixedFieldsGrow)
        form.setVerticalSpacing(2 * SPACE)
        self._boxes: list[tuple[PreferenceRow, QComboBox]] = []
        for row, now in rows:
            form.addRow(row.label, self._box(row, now))
        note = words("preferences.note", self)
        note.setText(_NOTE)
        buttons = QDialogButtonBox(
            QDialogButtonBox.StandardButton.RestoreDefaults | QDialogButtonBox.StandardButton.Close, self
        )
        usual = named(buttons.button(QDialogButtonBox.StandardButton.RestoreDefaults), "preferences.usual")
        usual.setAutoDefault(False)
        buttons.button(QDialogButtonBox.StandardButton.Close).setDefault(True)
        usual.clicked.connect(lambda _checked: self._restore())
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setSpacing(3 * SPACE)
        layout.addLayout(form)
        layout.addWidget(note)
        layout.addWidget(without_icons(buttons))

    def _box(self, row: PreferenceRow, now: str) -> QComboBox:
        box = named(QComboBox(self), f"preferences.{row.name}", row.label.replace("&", ""))
        box.setToolTip(row.tip)
        guard_from_wheels(box)
        for value, text in row.choices.items():
            box.addItem(text, value)
        box.setCurrentIndex(box.findData(now))
        box.currentIndexChanged.connect(lambda _index: self.chosen.emit(row.name, box.currentData()))
        self._boxes.append((row, box))
        return box

    def _restore(self) -> None:
        for row, box in self._boxes:
            box.setCurrentIndex(box.findData(row.usual))
