"""Where the mouse is over a view: the control point under it, and the point of the surface that it reads off."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from PySide6.QtCore import QObject, Signal

from qovr_app.view3d.interaction.interactor import Interactor, Watched
from qovr_app.view3d.scene.measuring import MOST_SPOTS, Spot
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.probing import Parameters, parameters_under
from qovr_core.document import NetIndex


class Pointer(QObject):
    """Follows the mouse through the viewports of a view.

    Parameters
    ----------
    picture : gives what a viewport, counted from the left, shows; None before there is anything

    Signals
    -------
    moved : something else is under it
    view_asked : the name of a view was clicked
    """

    moved = Signal()
    view_asked = Signal(str)

    def __init__(self, picture: Callable[[int], Picture | None], parent: QObject) -> None:
        super().__init__(parent)
        self._picture = picture
        self._at: tuple[int, float, float] | None = None
        self._hovered: NetIndex | None = None
        self._probed: tuple[int, Parameters] | None = None
        self._spots: tuple[Spot, ...] = ()

    @property
    def net_index(self) -> NetIndex | None:
        """The control point under the mouse."""
        return self._hovered

    @property
    def reading(self) -> tuple[int, Parameters] | None:
        """The viewport and the parameters of the point of the surface that is read off."""
        return self._probed

    @property
    def spots(self) -> tuple[Spot, ...]:
        """The places between which is measured."""
        return self._spots

    def follow(self, interactor: Interactor, viewport: int) -> None:
        """Follow the mouse in a viewport, too."""
        interactor.pointed.connect(lambda at: self._on_pointed(viewport, at))
        interactor.hovered.connect(self._on_hovered)
        interactor.mouse.asked.connect(self._on_asked)

    def forget(self) -> None:
        """Measure nothing any more: what was measured is there no longer."""
        self._spots = ()

    def read_off(self, viewports: Sequence[Watched]) -> None:
        """Find the point of the surface that is under the mouse now."""
        self._probed = self._found(viewports)

    def _found(self, viewports: Sequence[Watched]) -> tuple[int, Parameters] | None:
        if self._at is None:
            return None
        number, x, y = self._at
        shown = self._picture(number) if number < len(viewports) else None
        if shown is None or not (shown.settings.probe and shown.settings.surface):
            return None
        found = parameters_under(shown.scene, shown.camera, viewports[number].logical_size, x, y)
        return None if found is None else (number, found)

    def _on_pointed(self, viewport: int, at: tuple[float, float] | None) -> None:
        self._at = None if at is None else (viewport, *at)
        picture = self._picture(viewport)
        if picture is not None and picture.settings.probe:
            self.moved.emit()

    def _on_asked(self, spot: str | Spot) -> None:
        """Measure on to a place; after the last one begin anew, and beside everything have none."""
        if isinstance(spot, str):
            self.view_asked.emit(spot)
            return
        begun = self._spots if len(self._spots) < MOST_SPOTS else ()
        self._spots = () if spot == Spot() else (*begun, spot)
        self.moved.emit()

    def _on_hovered(self, index: NetIndex | None) -> None:
        if index != self._hovered:
            self._hovered = index
            self.moved.emit()
