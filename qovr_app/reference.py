"""The pinned reference: the surface as it was, from which distances are taken."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, Signal

from qovr_app.actions import Command
from qovr_app.controller import Controller
from qovr_app.session import Session
from qovr_app.view3d.settings import DisplaySettings, Layer
from qovr_core import Patch
from qovr_core.pipeline import Layer as SurfaceLayer
from qovr_core.pipeline import default_layer

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D


class Reference(QObject):
    """Keeps the pinned surface; what is edited, undone or opened later leaves it alone.

    Signals
    -------
    changed : the surface, a Patch in the document's units or None, and what to call it
    told : a sentence for the message line
    """

    changed = Signal(object, str)
    told = Signal(str)

    def __init__(
        self, session: Session, controller: Controller, settings: Callable[[], DisplaySettings], parent: QObject
    ) -> None:
        super().__init__(parent)
        self._session, self._controller, self._settings = session, controller, settings
        self._surface: Patch | None = None
        self._name = ""

    def pin(self) -> None:
        """Pin the surface that is configured now, in the layer that is shown; of two, in the one on the net."""
        result = self._controller.state.result
        if result is None:
            self.told.emit("There is no surface to pin: configure one first (F5).")
            return
        shown = self._settings().layer
        layer = default_layer(result.document) if shown is Layer.BOTH else SurfaceLayer(shown.value)
        self._set(result.layer_patch(layer), self._session.title)
        self.told.emit(
            f"Pinned the {layer} surface of {self._name} ({result.document.formulation}) as the reference. "
            "View, Colour by, Distance shows how far other surfaces lie from it."
        )

    def unpin(self) -> None:
        """Forget the reference."""
        self._set(None, "")
        self.told.emit("There is no reference now.")

    def show_in(self, view: View3D) -> None:
        """Give a view that comes late the reference, and every later one."""
        self.changed.connect(view.set_reference)
        view.set_reference(self._surface, self._name)

    def commands(self) -> list[Command]:
        """Return the commands of the menu Laboratory that pin and unpin."""
        return [
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

    def _set(self, surface: Patch | None, name: str) -> None:
        self._surface, self._name = surface, name
        self.changed.emit(surface, name)
