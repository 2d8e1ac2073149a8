"""The camera of a view in motion: turned by hand, led to a goal, or kept so that everything is seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEasingCurve, QObject, QTimer, QVariantAnimation, Signal

from qovr_app.view3d.scene.camera import Camera

TURN_MILLISECONDS = 240
"""Long enough to see which way the surface turned, too short to wait for."""

REST_MILLISECONDS = 500
"""A pause this long ends one look and begins the next: what came before it can be gone back to."""

MOST_CAMERAS = 100
"""More looks than anybody goes back over."""


class CameraMotion(QObject):
    """Holds the camera and moves it.

    Parameters
    ----------
    fitted : gives a camera, in its direction, that shows everything

    Signals
    -------
    moved : the camera is another one, and may soon be yet another
    """

    moved = Signal()

    def __init__(self, fitted: Callable[[Camera], Camera], parent: QObject) -> None:
        super().__init__(parent)
        self._fitted = fitted
        self._camera = self._start = self._goal = Camera()
        self._is_fitted = True
        self._before: list[Camera] = []
        self._after: list[Camera] = []
        self._rest = QTimer(self, singleShot=True, interval=REST_MILLISECONDS)
        self._animation = QVariantAnimation(self)
        self._animation.setDuration(TURN_MILLISECONDS)
        self._animation.setStartValue(0.0)
        self._animation.setEndValue(1.0)
        self._animation.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._animation.valueChanged.connect(self._on_turned)

    @property
    def camera(self) -> Camera:
        """Where the view looks from now."""
        return self._camera

    @property
    def is_fitted(self) -> bool:
        """Whether everything is kept in view: nobody has moved the camera by hand since it was fitted."""
        return self._is_fitted

    def move(self, camera: Camera) -> None:
        """Look from here, as the hand on the mouse wants it."""
        self._remember()
        self._animation.stop()
        self._is_fitted = False
        self._set(camera)

    def lead(self, camera: Camera, *, animated: bool) -> None:
        """Look in this camera's direction at everything, at once or by a short turn."""
        self._turn(self._fitted(camera), fitted=True, animated=animated)

    def lead_to(self, camera: Camera, *, animated: bool) -> None:
        """Look from here, at once or by a short turn."""
        self._turn(camera, fitted=False, animated=animated)

    def recall(self, *, forward: bool) -> None:
        """Look from where one looked before, or after that again; nothing where there is no such camera."""
        found, others = (self._after, self._before) if forward else (self._before, self._after)
        if found:
            camera = replace(found.pop(), perspective=self._camera.perspective)
            others.append(self._goal if self._animation.state() is self._animation.State.Running else self._camera)
            self._begin_turn(camera, fitted=False, animated=True)

    def _remember(self) -> None:
        """Keep where one looks, unless a move goes on: without a pause, several are one."""
        if not self._rest.isActive():
            self._before = [*self._before, self._camera][-MOST_CAMERAS:]
            self._after = []
        self._rest.start()

    def _turn(self, camera: Camera, *, fitted: bool, animated: bool) -> None:
        self._rest.stop()
        if animated:  # what no user asked for, as the first look at a document, is not gone back to
            self._remember()
            self._rest.stop()
        self._begin_turn(camera, fitted=fitted, animated=animated)

    def _begin_turn(self, camera: Camera, *, fitted: bool, animated: bool) -> None:
        self._animation.stop()
        self._is_fitted = fitted
        self._start, self._goal = self._camera, camera
        if animated:
            self._animation.start()
        else:
            self._set(self._goal)

    def refit(self, *, perspective: bool) -> None:
        """Take another projection, and another distance where everything is kept in view; a turn goes on there."""
        self._camera, self._goal = (self._refitted(each, perspective) for each in (self._camera, self._goal))

    def _refitted(self, camera: Camera, perspective: bool) -> Camera:
        camera = replace(camera, perspective=perspective)
        return self._fitted(camera) if self._is_fitted else camera

    def _set(self, camera: Camera) -> None:
        self._camera = camera
        self.moved.emit()

    def _on_turned(self, part: float) -> None:
        self._set(self._goal if part == 1.0 else self._start.toward(self._goal, part))
