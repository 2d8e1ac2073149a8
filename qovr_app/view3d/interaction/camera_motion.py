"""The camera of a view in motion: turned by hand, led to a goal, or kept so that everything is seen."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtCore import QEasingCurve, QObject, QVariantAnimation, Signal

from qovr_app.view3d.scene.camera import Camera

TURN_MILLISECONDS = 240
"""Long enough to see which way the surface turned, too short to wait for."""


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
        self._animation.stop()
        self._is_fitted = False
        self._set(camera)

    def lead(self, camera: Camera, *, animated: bool) -> None:
        """Look in this camera's direction at everything, at once or by a short turn."""
        self._animation.stop()
        self._is_fitted = True
        self._start, self._goal = self._camera, self._fitted(camera)
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
