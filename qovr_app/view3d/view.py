"""The 3D view: the widget that a window places. It shows what it is given and reports intents; it changes nothing
else."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QPoint, QSize, Signal
from PySide6.QtGui import QImage, QResizeEvent
from PySide6.QtWidgets import QWidget

from qovr_app.state.display import Projection
from qovr_app.state.figure_options import FigureOptions
from qovr_app.style.theme import theme_of
from qovr_app.view3d.images import FigureWriter, figure_writer, view_image
from qovr_app.view3d.interaction.camera_motion import CameraMotion
from qovr_app.view3d.interaction.interactor import Interactor
from qovr_app.view3d.interaction.pointer import Pointer
from qovr_app.view3d.interaction.refinement import Refinement
from qovr_app.view3d.scene.camera import Camera, fitted, looking_at, named_view
from qovr_app.view3d.scene.frame import HALF_EXTENTS
from qovr_app.view3d.scene.net_flags import flags_of
from qovr_app.view3d.scene.picture import Picture, margins
from qovr_app.view3d.scene.scenes import Scenes
from qovr_app.view3d.scene.shown import Shown
from qovr_app.view3d.viewport import Viewport
from qovr_app.view3d.viewports import Viewports
from qovr_app.view3d.words import colour_words, probe_words
from qovr_app.work.gui_calls import here
from qovr_core.fields import Range
from qovr_core.files.progress import silent


class View3D(QWidget):
    """A surface with its control net, seen through one camera in one viewport or several.

    It holds what belongs to it alone: the camera, and where the mouse is. All else it is given by ``display``.
    ``restart`` begins again with the drawing, and with OpenGL if it can be used by now.

    Signals
    -------
    points_picked : control points (i, j), the one picked last at the end, and what they do to the selection, a Picking
    points_dragged : the points (i, j), how far each is from where it was when the drag began, (k, 3) float64 in the
        document's units, and the drag's gesture number
    point_opened : the control point (i, j) whose fields are wanted
    menu_asked : a MenuWish, and the place of the screen
    radius_turned : by how many notches the wheel went while points were dragged softly
    wanted : an intent
    drag_finished, drag_cancelled : the gesture number; after a cancelled drag the owner puts the point back
    faulted : why the picture could not be drawn: an error of the program; the next picture is tried again
    fell_back : once, why OpenGL is not used
    frame_painted : a frame has reached the window
    """

    points_picked = Signal(object, object)
    points_dragged = Signal(object, object, int)
    point_opened = Signal(object)
    menu_asked = Signal(object, QPoint)
    radius_turned = Signal(float)
    wanted = Signal(object)
    drag_finished = Signal(int)
    drag_cancelled = Signal(int)
    faulted = Signal(str)
    fell_back = Signal(str)
    frame_painted = Signal()

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._shown, self._scenes = Shown(), Scenes()
        self._refinement = Refinement(self)
        self._refinement.rested.connect(self._show)
        self.camera_motion = CameraMotion(self._fitted, self)
        self.camera_motion.moved.connect(lambda: self._show(moving=True))
        self._pointer = Pointer(self.picture, self)
        self._pointer.moved.connect(self._show)
        self._pointer.view_asked.connect(self.set_camera)
        self._viewports = Viewports(self, self.picture)
        self._viewports.interactor_made.connect(self._listen)
        self._viewports.painted.connect(self.frame_painted)
        self._viewports.faulted.connect(self.faulted)
        self._viewports.fell_back.connect(self.fell_back)
        self._viewports.arrange(self._shown.viewports)
        self.restart = self._viewports.restart

    def minimumSizeHint(self) -> QSize:
        return QSize(320, 240)

    # What is shown

    @property
    def shown(self) -> Shown:
        """What the view was given last."""
        return self._shown

    @property
    def camera(self) -> Camera:
        """Where the viewports look from."""
        return self.camera_motion.camera

    @property
    def uses_opengl(self) -> bool:
        """Whether the viewports are drawn by OpenGL, not by the painter."""
        return self._viewports.uses_opengl

    @property
    def viewports(self) -> list[Viewport]:
        """The viewports in use, from left to right."""
        return list(self._viewports.in_use)

    def picture(self, viewport: int = 0, scenes: Scenes | None = None) -> Picture | None:
        """Return what a viewport shows, or would show of other scenes; None where there is no surface yet."""
        shown, scene = self._shown, (scenes or self._scenes).scene(viewport)
        if scene is None:
            return None
        return Picture(
            settings=shown.settings_of(viewport),
            camera=self.camera,
            scene=scene,
            hovered=self._pointer.net_index,
            moving=self._refinement.is_moving,
            probed=None if self._pointer.reading is None else self._pointer.reading[1],
            caption=scene.caption if shown.viewports > 1 else "",
            tools=shown.tools,
            hand=self._viewports.hand(viewport),
            spots=self._pointer.spots,
            **shown.marks,
        )

    def display(self, shown: Shown) -> None:
        """Show this from now on. The camera stays where it is."""
        before, self._shown = self._shown, shown
        if not shown.dragging and before.net is not shown.net:
            self._viewports.drop_drags()  # what is pressed there is no longer what it was
        if before.opening != shown.opening:
            self._pointer.forget()
        self._scenes.update(shown)
        if before.viewports != shown.viewports:
            self._viewports.arrange(shown.viewports)
        if before.settings != shown.settings or before.comparison != shown.comparison:
            self._lay_out()
        if before.evaluation is not shown.evaluation or before.net is not shown.net or before.dragging > shown.dragging:
            self._show(moving=True)
        elif shown.differs_visibly(before):
            self._show()

    def probe_text(self) -> str:
        """Return what the probe says, for the clipboard; empty where it is off or meets no surface."""
        return "" if self._pointer.reading is None else probe_words(self.picture(self._pointer.reading[0]))

    def shown_range(self) -> tuple[str, Range]:
        """Return what the colours say, and the values at their ends; not numbers where there are none."""
        return colour_words(self.picture())

    # The camera

    def set_camera(self, name: str, *, animated: bool = True) -> None:
        """Look from a direction of ``qovr_core.cameras.NAMED_VIEWS`` at the whole surface.

        Raises
        ------
        KeyError : there is no such direction
        """
        self.camera_motion.lead(named_view(name, self.camera), animated=animated and self.isVisible())

    def fit(self, *, selection: bool = False, animated: bool = True) -> None:
        """Show the whole surface, in limits of its own, or the selected points from near, in the camera's direction."""
        picture, is_animated = self.picture(), animated and self.isVisible()
        if selection and picture is not None:
            chosen = picture.scene.points[flags_of(picture.selected, picture.scene.net_shape)]
            if len(chosen):
                self.camera_motion.lead_to(looking_at(self.camera, chosen), animated=is_animated)
                return
        self._scenes.take_limits()
        self._show(moving=True)
        self.camera_motion.lead(self.camera, animated=is_animated)

    def _fitted(self, camera: Camera) -> Camera:
        scene, size = self._scenes.scene(0), self.viewports[0].logical_size
        half = HALF_EXTENTS if scene is None else scene.frame.half_extents
        return fitted(camera, half, size, margins(self._shown.settings, size))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._lay_out()
        self._show()

    def _lay_out(self) -> None:
        """Give the viewports their places, and a fitted camera its distance."""
        self._viewports.lay_out()
        self.camera_motion.refit(perspective=self._shown.settings.projection is Projection.PERSPECTIVE)

    # Images

    def image(self) -> QImage:
        """Return what is seen, or would be if the view were shown, at the device's resolution."""
        if not self.isVisible():
            self._lay_out()
        self._refinement.rest()  # what is kept is looked at longer than a frame
        return view_image(self, self.viewports, theme_of(self._shown.settings.theme))

    def save_figure(self, path: str | Path, options: FigureOptions | None = None) -> None:
        """Write what is seen as PNG, SVG or PDF, by the path's suffix.

        Axes and colours have the limits of what is in the figure.

        Raises
        ------
        qovr_core.FileError : the suffix is another one, or the file cannot be written; nothing is left behind
        """
        self.figure_writer()(Path(path), options or FigureOptions(), silent, here)

    def figure_writer(self) -> FigureWriter:
        """Return what writes as a figure what is seen now, from whatever thread."""
        if not self.isVisible():
            self._lay_out()
        fitting = Scenes()
        fitting.update(self._shown)
        pictures = [self.picture(k, fitting) for k in range(len(self.viewports))]
        seen = zip(self.viewports, pictures, strict=True)
        drawn = [(viewport, picture) for viewport, picture in seen if picture is not None]
        return figure_writer(drawn, refit=self.camera_motion.is_fitted)

    # Intents

    def _listen(self, interactor: Interactor, number: int) -> None:
        """Take the intents of a new viewport's interactor."""
        self._pointer.follow(interactor, number)
        interactor.camera_requested.connect(self.camera_motion.move)
        interactor.changed.connect(self._show)
        interactor.wanted.connect(self.wanted)
        interactor.radius_turned.connect(self.radius_turned)
        interactor.mouse.picked.connect(self.points_picked)
        interactor.mouse.opened.connect(self.point_opened)
        interactor.mouse.menu_asked.connect(self.menu_asked)
        interactor.dragger.dragged.connect(self.points_dragged)
        for dragger in (interactor.dragger, interactor.knot_dragger):
            dragger.finished.connect(self.drag_finished)
            dragger.cancelled.connect(self.drag_cancelled)

    def _show(self, *, moving: bool = False) -> None:
        """Show the present state in the next frame; what moves is drawn on the coarser grid until nothing does."""
        if moving:
            self._refinement.move()
        self._pointer.read_off(self.viewports)
        self._viewports.show()
