"""The 3D view: the widget that a window places. It shows results and reports intents; it changes no
document."""

from __future__ import annotations

import math
from dataclasses import replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QPoint, QSize, QTimer, Signal
from PySide6.QtGui import QColor, QImage, QResizeEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.display import DisplaySettings, Projection
from qovr_app.view3d.figure.figure import FigureOptions, save_figure
from qovr_app.view3d.interaction.navigator import Navigator
from qovr_app.view3d.interaction.probing import Place, place_under, reading_at
from qovr_app.view3d.interaction.turn import Turn
from qovr_app.view3d.painter.canvas import blank_image, painting
from qovr_app.view3d.painter.readout import readout_text
from qovr_app.view3d.scene.camera import NAMED_VIEWS, Camera, fitted
from qovr_app.view3d.scene.comparison import Rival
from qovr_app.view3d.scene.frame import HALF_EXTENTS
from qovr_app.view3d.scene.picture import Picture, margins
from qovr_app.view3d.scene.scene import NetIndex, Scene
from qovr_app.view3d.scene.scenes import Stage
from qovr_app.view3d.viewports import Panes
from qovr_core import Document, Evaluation, ParametricSurface
from qovr_core.fields import FIELDS, Need, Range
from qovr_core.geometry.knots import KnotPlace

_REST_MILLISECONDS = 150
"""After this long without a change the surface is drawn on its finer grid."""


class View3D(QWidget):
    """A surface with its control net, seen through one camera in one viewport or, for ``both``, two.

    Signals
    -------
    point_hovered, point_selected : (i, j) or None
    point_dragged : i, j, the wanted coordinates (3,) float64, and the drag's gesture number
    drag_finished, drag_cancelled : the gesture number; after a cancelled drag the owner puts the point back
    fell_back : once, why OpenGL is not used
    frame_painted : a frame has reached the window
    """

    point_hovered = Signal(object)
    point_selected = Signal(object)
    point_dragged = Signal(int, int, object, int)
    drag_finished = Signal(int)
    drag_cancelled = Signal(int)
    fell_back = Signal(str)
    frame_painted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._settings, self._camera = DisplaySettings(), Camera()
        self._stage = Stage()
        self._selected: NetIndex | None = None
        self._hovered: NetIndex | None = None
        self._pointer: tuple[int, float, float] | None = None
        self._probed: Place | None = None
        self._moving = False
        self._is_fitted, self._dragging = True, False
        self._panes = Panes(self, self.picture)
        self._panes.navigator_made.connect(self._listen)
        self._panes.painted.connect(self.frame_painted)
        self._panes.fell_back.connect(self._on_fell_back)
        self._rest = QTimer(self, singleShot=True, interval=_REST_MILLISECONDS)
        self._rest.timeout.connect(self._refine)
        self._turn = Turn(self)
        self._turn.moved.connect(self._move_to)
        self._panes.arrange(self._count)

    def minimumSizeHint(self) -> QSize:
        return QSize(320, 240)

    # What is shown

    @property
    def settings(self) -> DisplaySettings:
        """How the surface is shown."""
        return self._settings

    @property
    def camera(self) -> Camera:
        """Where the viewports look from."""
        return self._camera

    @property
    def uses_opengl(self) -> bool:
        """Whether the viewports are drawn by OpenGL, not by the painter."""
        return self._panes.uses_gl

    @property
    def viewports(self) -> list[QWidget]:
        """The viewports in use, from left to right."""
        return [self._panes[k] for k in range(self._count)]

    def picture(self, viewport: int = 0) -> Picture:
        """Return what a viewport shows."""
        scene = self._stage.scene(viewport)
        return Picture(
            settings=self._settings,
            camera=self._camera,
            scene=scene,
            selected=self._selected,
            hovered=self._hovered,
            moving=self._moving,
            probed=self._probed,
            caption=_caption(scene) if scene is not None and self._count > 1 else "",
        )

    def set_evaluation(self, evaluation: Evaluation, document: Document | None = None) -> None:
        """Show an evaluation. The camera stays where it is; during a drag the axes' limits stay too.

        Parameters
        ----------
        document : whose control points and curves are shown; None for the evaluation's own
        """
        shown = document or evaluation.document
        self._stage.set_evaluation(evaluation, shown, self._settings, keep_limits=self._dragging)
        self._show_moving()

    def set_settings(self, settings: DisplaySettings) -> None:
        """Show the surface in another way."""
        before, self._settings = self._settings, settings
        if (before.layer, before.scaling) != (settings.layer, settings.scaling):
            self._stage.build(settings, keep_limits=False)
        perspective = settings.projection is Projection.PERSPECTIVE
        self._camera = replace(self._camera, perspective=perspective)
        if before.layer is not settings.layer:
            self._panes.arrange(self._count)
        if self._is_fitted:
            self._camera = self._fitted(self._camera)
        self._show()

    def set_rival(self, rival: Rival | None) -> None:
        """Show another surface of the same control net beside the document's or over it, or none any more."""
        self._stage.set_rival(rival, self._settings)
        self._panes.arrange(self._count)
        self._lay_out()

    def set_reference(self, surface: ParametricSurface | None, name: str = "") -> None:
        """Take distances from a surface in the document's units, or from none; it stays what it is now."""
        self._look_with(Need.REFERENCE, reference=surface, reference_name=name)

    def set_focus_knot(self, knot: KnotPlace | None) -> None:
        """Show the sensitivity to a knot, or to none."""
        self._look_with(Need.KNOT, knot=knot)

    def _look_with(self, need: Need, **changes: Any) -> None:
        self._stage.set_companions(replace(self._stage.companions, **changes))
        field = FIELDS.get(self._settings.colour_by)
        if field is not None and field.needs is need:
            self._show()

    def select(self, i: int | None, j: int | None = None) -> None:
        """Mark a control point, or none."""
        self._selected = None if i is None or j is None else (i, j)
        self._show()

    def probe_text(self) -> str:
        """Return what the probe says, for the clipboard; empty where it is off or meets no surface."""
        if self._probed is None:
            return ""
        return readout_text(reading_at(self.picture(self._pointer[0]).scene, self._probed, self._settings.colour_by))

    def shown_range(self) -> tuple[str, Range]:
        """Return what the colours say, and the values at their ends; not numbers where there are none."""
        picture = self.picture()
        if picture.scene is None:
            return "", (math.nan, math.nan)
        return picture.colouring.title, picture.colouring.limits

    # The camera

    def set_camera(self, name: str, *, animated: bool = True) -> None:
        """Look from a named direction, ``paper``, ``top``, ``front`` or ``right``, at the whole surface.

        Raises
        ------
        KeyError : there is no such direction
        """
        azimuth, elevation = NAMED_VIEWS[name]
        goal = replace(self._camera, azimuth=azimuth, elevation=elevation)
        self._is_fitted = True
        self._turn_to(self._fitted(goal), animated=animated)

    def fit(self, *, animated: bool = True) -> None:
        """Show the whole surface from where the camera looks now."""
        self._is_fitted = True
        self._turn_to(self._fitted(self._camera), animated=animated)

    def _fitted(self, camera: Camera) -> Camera:
        scene = self.picture().scene
        half = HALF_EXTENTS if scene is None else scene.frame.half_extents
        size = self.viewports[0].logical_size
        return fitted(camera, half, size, margins(self._settings, size))

    def _turn_to(self, goal: Camera, *, animated: bool) -> None:
        self._turn.stop()
        if animated and self.isVisible():
            self._turn.go(self._camera, goal)
        else:
            self._move_to(goal)

    def _move_to(self, camera: Camera) -> None:
        self._camera = camera
        self._show_moving()

    def _on_camera_requested(self, camera: Camera) -> None:
        self._turn.stop()
        self._is_fitted = False
        self._move_to(camera)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._lay_out()

    def _lay_out(self) -> None:
        """Give the viewports their places, and a fitted camera its distance."""
        self._panes.lay_out()
        if self._is_fitted:
            self._turn.stop()
            self._camera = self._fitted(self._camera)
        self._show()

    # Images

    def image(self) -> QImage:
        """Return what is seen, or would be if the view were shown, at the device's resolution."""
        if not self.isVisible():
            self._lay_out()
        self._refine()  # what is kept is looked at longer than a frame
        ratio = self.devicePixelRatioF()
        result = blank_image((self.width(), self.height()), ratio)
        result.fill(QColor(*self.picture().theme.grid))
        with painting(result) as painter:
            for viewport in self.viewports:
                part = viewport.image()
                part.setDevicePixelRatio(ratio)
                painter.drawImage(viewport.mapTo(self, QPoint(0, 0)), part)
        return result

    def save_figure(self, path: str | Path, options: FigureOptions | None = None) -> None:
        """Write what is seen as PNG, SVG or PDF, by the path's suffix.

        Raises
        ------
        qovr_core.FileError : the suffix is another one, or the file cannot be written; nothing is left behind
        """
        if not self.isVisible():
            self._lay_out()
        panels = []
        for k, viewport in enumerate(self.viewports):
            picture = replace(self.picture(k), moving=False, hovered=None)
            panels.append((picture, viewport.logical_size, viewport.surface_image))
        save_figure(Path(path), panels, options or FigureOptions(), refit=self._is_fitted)

    # Viewports

    @property
    def _count(self) -> int:
        return self._stage.count(self._settings)

    def _listen(self, navigator: Navigator, number: int) -> None:
        """Take the intents of a new viewport's navigator."""
        navigator.camera_requested.connect(self._on_camera_requested)
        navigator.pointed.connect(lambda at: self._on_pointed(number, at))
        navigator.hovered.connect(self._on_hovered)
        navigator.selected.connect(self._on_selected)
        navigator.drag_started.connect(self._on_drag_started)
        navigator.dragged.connect(self.point_dragged)
        navigator.drag_finished.connect(self._on_drag_finished)
        navigator.drag_cancelled.connect(self._on_drag_cancelled)

    def _on_fell_back(self, reason: str) -> None:
        self._show()
        self.fell_back.emit(reason)

    # Intents

    def _on_pointed(self, viewport: int, at: tuple[float, float] | None) -> None:
        self._pointer = None if at is None else (viewport, *at)
        if self._settings.probe:
            self._show()

    def _on_hovered(self, index: NetIndex | None) -> None:
        if index != self._hovered:
            self._hovered = index
            self._show()
            self.point_hovered.emit(index)

    def _on_selected(self, index: NetIndex | None) -> None:
        if index != self._selected:
            self._selected = index
            self._show()
            self.point_selected.emit(index)

    def _on_drag_started(self, gesture: int) -> None:  # noqa: ARG002
        self._dragging = True

    def _on_drag_finished(self, gesture: int) -> None:
        self._end_drag()
        self.drag_finished.emit(gesture)

    def _on_drag_cancelled(self, gesture: int) -> None:
        self._end_drag()
        self.drag_cancelled.emit(gesture)

    def _end_drag(self) -> None:
        """Let the axes' limits follow the surface again."""
        self._dragging = False
        self._stage.build(self._settings, keep_limits=False)
        self._show_moving()

    # Drawing

    def _show_moving(self) -> None:
        """Show the present state on the coarser grid, and on the finer one when it has come to rest."""
        self._moving = True
        self._show()
        self._rest.start()

    def _refine(self) -> None:
        self._moving = False
        self._show()

    def _place_under_pointer(self) -> Place | None:
        if self._pointer is None or not self._settings.probe or not self._settings.surface:
            return None
        number, x, y = self._pointer
        scene = self.picture(number).scene if number < self._count else None
        if scene is None:
            return None
        return place_under(scene, self._camera, self.viewports[number].logical_size, x, y)

    def _show(self) -> None:
        self._probed = self._place_under_pointer()
        for k, viewport in enumerate(self.viewports):
            viewport.set_picture(self.picture(k))


def _caption(scene: Scene) -> str:
    """Return what tells a viewport from the one beside it."""
    layer = "" if scene.is_rival else str(scene.layer)
    text = ", ".join(part for part in (scene.name, layer) if part)
    return text[0].upper() + text[1:]
