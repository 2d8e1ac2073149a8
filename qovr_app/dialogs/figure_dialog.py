"""How large a figure is, of which kind, and where it goes."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtWidgets import QCheckBox, QComboBox, QDialogButtonBox, QFormLayout, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.dialogs.target import ask_for_target
from qovr_app.dialogs.writing_dialog import WritingDialog
from qovr_app.state.figure_options import HEIGHT_OF_WIDTH, SUFFIXES, WIDTHS, FigureOptions
from qovr_app.widgets.parts import named
from qovr_app.widgets.spin_boxes import CountBox, NumberBox
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_app.work.worker import Worker

_FIRST = FigureOptions()
_MILLIMETRES = "millimetres"
_PIXELS = "pixels"
_OWN = "Width and height below"


FigureWriter = Callable[[Path, FigureOptions, Any], None]
"""Writes a figure of these options into a file, telling its progress, or raises QovrError."""


class FigureDialog(WritingDialog):
    """Asks for the options of Save Figure, then for the file, and has it written.

    Parameters
    ----------
    path : what is offered
    vectors : what SVG and PDF hold
    draw : writes the figure
    """

    def __init__(
        self, path: Path, vectors: str, draw: FigureWriter, worker: Worker, parent: QWidget | None = None
    ) -> None:
        super().__init__("figure", "Save Figure", worker, parent)
        self._path, self._vectors, self._draw = path, vectors, draw
        self._size = named(QComboBox(self), "figure.size")
        self._size.addItems([_OWN, *WIDTHS])
        self._unit = named(QComboBox(self), "figure.unit")
        guard_from_wheels(self._size, self._unit)
        self._unit.addItems([_MILLIMETRES, _PIXELS])
        self._width = self._length("figure.width", _FIRST.width)
        self._height = self._length("figure.height", _FIRST.height)
        self._dpi = named(CountBox(30, 2400, round(_FIRST.dpi or 300), self), "figure.dpi")
        self._transparent = named(QCheckBox("Transparent background (PNG and SVG)", self), "figure.transparent")
        self._buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel)
        self.cancel_button = self._buttons.button(QDialogButtonBox.StandardButton.Cancel)
        save = self._buttons.button(QDialogButtonBox.StandardButton.Save)
        self.inputs = [self._size, self._unit, self._width, self._height, self._dpi, self._transparent, save]
        self._buttons.accepted.connect(self._choose_file)
        self._buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow("&Size", self._size)
        form.addRow("&Unit", self._unit)
        form.addRow("&Width", self._width)
        form.addRow("&Height", self._height)
        form.addRow("&Resolution (dpi)", self._dpi)
        form.addRow(self._transparent)
        form.addRow(self.note)
        form.addRow(self.bar)
        form.addRow(without_icons(self._buttons))
        self._unit.currentTextChanged.connect(self._change_unit)
        self._size.textActivated.connect(self._take_width)
        for changed in (self._width.valueChanged, self._height.valueChanged, self._dpi.valueChanged):
            changed.connect(self._show_size)
        self._show_size()

    @property
    def options(self) -> FigureOptions:
        """What was chosen."""
        in_pixels = self._unit.currentText() == _PIXELS
        return FigureOptions(
            width=self._width.value(),
            height=self._height.value(),
            dpi=None if in_pixels else float(self._dpi.value()),
            transparent=self._transparent.isChecked(),
        )

    def _length(self, name: str, value: float) -> NumberBox:
        return named(NumberBox(10.0, 20_000.0, 1, value, self), name)

    def _take_width(self, size: str) -> None:
        """Take the width of a journal's column, and a height that goes with it."""
        if size in WIDTHS:
            self._unit.setCurrentText(_MILLIMETRES)
            self._width.setValue(WIDTHS[size])
            self._height.setValue(HEIGHT_OF_WIDTH * WIDTHS[size])

    def _change_unit(self, unit: str) -> None:
        """Keep the figure's size when its unit changes."""
        scale = self._dpi.value() / 25.4
        for field in (self._width, self._height):
            field.setDecimals(0 if unit == _PIXELS else 1)
            field.setValue(field.value() * scale if unit == _PIXELS else field.value() / scale)
        self._dpi.setEnabled(unit == _MILLIMETRES)
        self._show_size()

    def _show_size(self) -> None:
        width, height = self.options.pixels
        in_millimetres = self.options.width if self.options.dpi is not None else None
        self._size.setCurrentText(next((text for text, each in WIDTHS.items() if each == in_millimetres), _OWN))
        self.note.setText(f"{width} × {height} pixels; in SVG and PDF {self._vectors}")

    def _set_writing(self, is_writing: bool) -> None:
        super()._set_writing(is_writing)
        self._dpi.setEnabled(not is_writing and self._unit.currentText() == _MILLIMETRES)

    def _choose_file(self) -> None:
        path = ask_for_target(self, "Save Figure", self._path, {suffix: suffix[1:].upper() for suffix in SUFFIXES})
        if path is not None:
            self._path = path
            self._show_size()
            self.write(self._draw, path, self.options, path=path)
