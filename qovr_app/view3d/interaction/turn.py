"""Short animated turns of the camera."""

from __future__ import annotations

from PySide6.QtCore import QEasingCurve, QObject, QVariantAnimation, Signal

from qovr_app.view3d.scene.camera import Camera

_MILLISECONDS = 240
"""Long enough to see which way the surface turned, too short to wait for."""


class Turn(QObject):
    """Leads a camera to another; ``moved(Camera)`` on the way and, exactly, at the end."""

    moved = Signal(object)

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._start = self._goal = Camera()
        self._animation = QVariantAnimation(self, duration=_MILLISECONDS, startValue=0.0, endValue=1.0)
        self._animation.setEasingCurve(QEasingCurve.Type.OutCubic)
        self._animation.valueChanged.connect(self._on_value_changed)

    def go(self, start: Camera, goal: Camera) -> None:
        """Begin a turn; one that is under way ends where it is."""
        self.stop()
        self._start, self._goal = start, goal
        self._animation.start()

    def stop(self) -> None:
        """Stay where the camera is."""
        self._animation.stop()

    def _on_value_changed(self, part: float) -> None:
        self.moved.emit(self._goal if part == 1.0 else self._start.toward(self._goal, part))
