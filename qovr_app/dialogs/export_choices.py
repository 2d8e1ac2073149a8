"""What a chosen format keeps and loses, and what may be chosen of it."""

from __future__ import annotations

from dataclasses import replace
from enum import StrEnum
from typing import TypeVar

from PySide6.QtCore import QSignalBlocker, Signal
from PySide6.QtWidgets import QCheckBox, QComboBox, QFormLayout, QLabel, QLineEdit, QSizePolicy, QWidget

from qovr_app.state.typed_numbers import typed_number
from qovr_app.widgets.parts import named, words
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_core import Document, DocumentError
from qovr_core.document import Window
from qovr_core.files import Format
from qovr_core.files.conventions import CsvDialect, Unit, Up
from qovr_core.files.options import ExportOptions
from qovr_core.joints import Joint
from qovr_core.layer import Layer
from qovr_core.number_texts import number_text

_Kind = TypeVar("_Kind", bound=StrEnum)


class ExportChoices(QWidget):
    """Describes one format, and offers the choices it knows.

    Parameters
    ----------
    document : what is to be written
    first : the unit, axis and dialect that are chosen first
    window : the window of a net that may be written by itself

    Signals
    -------
    choices_changed : something else is chosen
    """

    choices_changed = Signal()

    def __init__(
        self, document: Document, first: ExportOptions, parent: QWidget | None = None, *, window: Window = (0, 0)
    ) -> None:
        super().__init__(parent)
        self._part = named(QComboBox(self), "export.window", "The whole net or one window")
        guard_from_wheels(self._part)
        self._part.addItems(["the whole net", "window {},{} alone".format(*window)])
        self._part.setToolTip("One window is a surface of its own: T is made anew from its boxes.")
        self._is_net = not document.is_one_window
        self._keeps = self._text("export.keeps")
        self._loses = self._text("export.loses")
        self._layer = named(QComboBox(self), "export.layer", "Which surface")
        guard_from_wheels(self._layer)
        self._layer.addItems([str(layer) for layer in Layer])
        self._layer.setCurrentText(str(document.formulation.resting_layer))
        self._tolerance = named(QLineEdit(self), "export.tolerance", "Largest distance of the mesh from the surface")
        self._tolerance.setPlaceholderText("as the document's samples")
        self._tolerance.setToolTip(
            "How far the mesh may be from the surface, in the document's unit. Empty: its vertices are the samples."
        )
        self._unit = self._choice("export.units", "What the document's numbers count", Unit, first.unit)
        self._up = self._choice("export.up", "The axis of the file that points up", Up, first.up)
        self._up.insertItem(0, "")
        self._up.setCurrentIndex(self._up.findData(first.up.value) if first.up else 0)
        self._dialect = self._choice("export.csv_dialect", "How the table is spelt", CsvDialect, first.csv_dialect)
        for k, dialect in enumerate(CsvDialect):
            self._dialect.setItemText(k, dialect.wording)
        self._single_face = named(QCheckBox("across sharp joints", self), "export.single_face", "One face")
        self._single_face.setToolTip("Keep the surface in one face. Else each smooth part is a face of its own.")
        self._has_parts = document.formulation.is_continuous and Joint.SHARP in document.joints.u + document.joints.v
        self._part.currentIndexChanged.connect(self.choices_changed)
        self._layer.currentTextChanged.connect(self.choices_changed)
        self._tolerance.textChanged.connect(self.choices_changed)
        self._form = QFormLayout(self)
        self._form.setContentsMargins(0, 0, 0, 0)
        self._form.addRow("Keeps", self._keeps)
        self._form.addRow("Loses", self._loses)
        self._form.addRow("Par&t", self._part)
        self._form.addRow("&Surface", self._layer)
        self._form.addRow("Mesh &within", self._tolerance)
        self._form.addRow("&Units", self._unit)
        self._form.addRow("U&p", self._up)
        self._form.addRow("&Spelling", self._dialect)
        self._form.addRow("One &face", self._single_face)

    def describe(self, entry: Format, *, holds_net: bool = True) -> None:
        """Show a format; choices it does not know go away, and what cannot hold the whole net gets the window."""
        self._form.setRowVisible(self._part, self._is_net)
        if holds_net is not self._part.isEnabled():
            with QSignalBlocker(self._part):
                self._part.setCurrentIndex(int(not holds_net))
            self._part.setEnabled(holds_net)
        self._keeps.setText(entry.keeps)
        self._loses.setText(entry.loses or "nothing")
        self._form.setRowVisible(self._layer, entry.holds_one_layer)
        self._form.setRowVisible(self._tolerance, entry.is_mesh)
        self._form.setRowVisible(self._unit, entry.has_unit)
        self._form.setRowVisible(self._up, entry.usual_up is not None)
        self._form.setRowVisible(self._dialect, entry.is_text_table)
        self._form.setRowVisible(self._single_face, entry.has_parts and self._has_parts)
        self._up.setItemText(0, f"usual for {entry.suffix}: {entry.usual_up}")

    @property
    def is_window(self) -> bool:
        """Whether one window is to be written by itself."""
        return self._part.currentIndex() > 0

    @property
    def conventions(self) -> ExportOptions:
        """The unit, axis and dialect that are chosen, whichever of them the format heeds."""
        up = self._up.currentData()
        unit, dialect = Unit(self._unit.currentData()), CsvDialect(self._dialect.currentData())
        return ExportOptions(unit=unit, up=Up(up) if up else None, csv_dialect=dialect)

    def options(self, entry: Format) -> ExportOptions:
        """Return what is chosen for a format.

        Raises
        ------
        DocumentError : the tolerance is no positive number
        """
        layer = Layer(self._layer.currentText()) if entry.holds_one_layer else None
        tolerance = self._typed_tolerance() if entry.is_mesh else None
        single_face = entry.has_parts and self._single_face.isChecked()
        return replace(self.conventions, layer=layer, tolerance=tolerance, single_face=single_face)

    def _choice(self, name: str, spoken: str, kind: type[_Kind], chosen: _Kind | None) -> QComboBox:
        """Return a list of all values of a kind; each item's data is the value's text."""
        box = named(QComboBox(self), name, spoken)
        guard_from_wheels(box)
        for value in kind:
            box.addItem(value.value, value.value)
        box.setCurrentIndex(box.findData(chosen.value) if chosen else 0)
        return box

    def _typed_tolerance(self) -> float | None:
        typed = typed_number(self._tolerance.text())
        if typed is None:
            return None
        if not isinstance(typed, float) or not 0 < typed < float("inf"):
            found = number_text(typed) if isinstance(typed, float) else repr(typed)
            raise DocumentError("the mesh's distance", found, "a positive number, or nothing for the samples")
        return typed

    def _text(self, name: str) -> QLabel:
        label = words(name, self)
        label.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Minimum)
        return label
