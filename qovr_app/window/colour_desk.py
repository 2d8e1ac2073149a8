"""What colours and probe need beyond settings: a pinned reference, the knot in focus, a range, and the clipboard."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QWidget

from qovr_app.dialogs.range_dialog import RangeDialog
from qovr_app.laboratory.panel import Focus
from qovr_app.state.display import DisplaySettings, LayerChoice
from qovr_app.window.actions import Command
from qovr_app.window.controller import Controller
from qovr_app.window.session import Session
from qovr_app.window.view_changes import change
from qovr_core import ParametricSurface
from qovr_core.edits import KnotPlace
from qovr_core.fields import Range
from qovr_core.layer import Layer

if TYPE_CHECKING:
    from qovr_app.view3d.scene.comparison import ComparisonView
    from qovr_app.view3d.view import View3D


class ColourDesk(QObject):
    """Keeps the reference, which no edit, undo or other document changes, and hands it to the view.

    Signals
    -------
    told : a sentence for the message line
    """

    told = Signal(str)

    def __init__(self, session: Session, controller: Controller, view: Callable[[], View3D], parent: QWidget) -> None:
        super().__init__(parent)
        self._session, self._controller, self._view, self._window = session, controller, view, parent
        self._surface: ParametricSurface | None = None
        self._name = ""
        self._knot: KnotPlace | None = None
        self._comparison: ComparisonView | None = None

    def commands(self) -> list[Command]:
        """Return the commands that pin, unpin, and copy what the probe says."""
        return [
            Command(
                "copy_probe",
                "Copy pro&be",
                self.copy_probe,
                "&Edit",
                "Ctrl+Alt+P",
                tip="Copy what the probe says about the point under the mouse, at full precision",
            ),
            Command(
                "pin_reference",
                "&Pin as reference",
                self.pin,
                "&Laboratory",
                "Ctrl+R",
                tip="Keep the surface as it is now, and take distances from it",
            ),
            Command("unpin_reference", "&Unpin the reference", self.unpin, "&Laboratory", tip="Forget the reference"),
        ]

    def pin(self) -> None:
        """Pin the surface configured last, in the layer that is shown; of two, in the one that lies on the net."""
        evaluation = self._controller.state.evaluation
        if evaluation is None:
            self.told.emit("There is no surface to pin: configure one first (F5).")
            return
        shown = self._view().shown.settings.layer
        formulation = evaluation.document.formulation
        layer = formulation.resting_layer if shown is LayerChoice.BOTH else Layer(shown.value)
        self._set(evaluation.layer_patch(layer), f"{self._session.title}, {formulation}")
        self.told.emit(
            f"Pinned the {layer} surface of {self._session.title} ({formulation}) as the reference. "
            "View, Colour by, Distance shows how far a surface lies from it."
        )

    def unpin(self) -> None:
        """Forget the reference."""
        self.told.emit("There is no reference any more." if self._surface is not None else "There is no reference.")
        self._set(None, "")

    def focus_on(self, focus: Focus) -> None:
        """Take note of a knot that the user has turned to; it stays when they turn to a point."""
        if isinstance(focus, KnotPlace):
            self._knot = focus
            change(self._view(), knot=focus)

    def on_view_came(self, view: View3D) -> None:
        """Tell a view that comes late what the others know."""
        named = {"reference": self._surface, "reference_name": self._name}
        change(view, **named, knot=self._knot, comparison=self._comparison)

    def show_comparison(self, comparison: ComparisonView | None) -> None:
        """Show another surface of the same net beside the document's or over it, or none any more."""
        self._comparison = comparison
        change(self._view(), comparison=comparison)

    def copy_probe(self) -> None:
        """Copy what the probe says."""
        text = self._view().probe_text()
        if text:
            QGuiApplication.clipboard().setText(text)
        self.told.emit("Copied what the probe says" if text else "There is nothing under the probe (F8) to copy.")

    def asked_range(self, settings: DisplaySettings) -> Range | None:
        """Return the ends of a fixed range as the user wants them; None where they leave it as it was."""
        title, limits = self._view().shown_range()
        if not all(map(math.isfinite, limits)) or not limits[0] < limits[1]:
            limits = settings.fixed_range
        dialog = RangeDialog(title, limits, self._window)
        accepted = dialog.exec() == QDialog.DialogCode.Accepted
        dialog.deleteLater()
        return dialog.limits if accepted else None

    def _set(self, surface: ParametricSurface | None, name: str) -> None:
        self._surface, self._name = surface, name
        change(self._view(), reference=surface, reference_name=name)
