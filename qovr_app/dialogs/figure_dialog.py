"""How large a figure is, of which kind, and where it goes."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QFileDialog,
    QFormLayout,
    QWidget,
)

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state.figure_options import SUFFIXES, FigureOptions
from qovr_app.widgets.parts import named
from qovr_app.widgets.plain import plain_label
from qovr_app.widgets.spin_boxes import CountBox, NumberBox
from qovr_app.widgets.wheel import guard_from_wheels

_FIRST = FigureOptions()
_MILLIMETRES = "millimetres"
_PIXELS = "pixels"


class FigureDialog(QDialog):
    """Asks for the options of Save Figure, then for the file.

    ``path`` and ``options`` hold the answer once the dialog was accepted; ``vectors`` says what SVG and PDF hold.
    """

    def __init__(self, path: Path, vectors: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Save Figure")
        self.path, self._vectors = path, vectors
        self._unit = named(QComboBox(self), "figure.unit")
        guard_from_wheels(self._unit)
        self._unit.addItems([_MILLIMETRES, _PIXELS])
        self._width = self._length("figure.width", _FIRST.width)
        self._height = self._length("figure.height", _FIRST.height)
        self._dpi = named(CountBox(30, 2400, round(_FIRST.dpi or 300), self), "figure.dpi")
        self._transparent = named(QCheckBox("Transparent background (PNG and SVG)", self), "figure.transparent")
        self._note = named(plain_label("", self), "figure.note")
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Save | QDialogButtonBox.StandardButton.Cancel)
        buttons.accepted.connect(self._choose_file)
        buttons.rejected.connect(self.reject)
        form = QFormLayout(self)
        form.addRow("&Unit", self._unit)
        form.addRow("&Width", self._width)
        form.addRow("&Height", self._height)
        form.addRow("&Resolution (dpi)", self._dpi)
        form.addRow(self._transparent)
        form.addRow(self._note)
        form.addRow(without_icons(buttons))
        self._unit.currentTextChanged.connect(self._change_unit)
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
        self._note.setText(f"{width} × {height} pixels; in SVG and PDF {self._vectors}")

    def _choose_file(self) -> None:
        kinds = ";;".join(f"{suffix[1:].upper()} (*{suffix})" for suffix in SUFFIXES)
        name, kind = QFileDialog.getSaveFileName(self, "Save Figure", str(self.path), kinds)
        if not name:
            return
        path = Path(name)
        if path.suffix.lower() not in SUFFIXES:
            path = path.with_name(f"{path.name}.{kind[:3].lower()}")
        self.path = path
        self.accept()
