"""The stage: a result as the scenes of the layers that are shown, in limits that can be held still."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.view3d.frame import Frame
from qovr_app.view3d.scene import Companions, Result, Scene, make_scene, scene_frame
from qovr_app.view3d.settings import DisplaySettings, Layer


def shown_layers(settings: DisplaySettings) -> tuple[Layer, ...]:
    """Return the layers from left to right."""
    return (Layer.RAW, Layer.TRANSFORMED) if settings.layer is Layer.BOTH else (settings.layer,)


class Stage:
    """Holds the result and what is made of it; a scene is the same object until something in it changes."""

    def __init__(self) -> None:
        self._result: Result | None = None
        self.companions = Companions()
        self._frames: dict[Layer, Frame] = {}
        self._scenes: dict[Layer, Scene] = {}

    def scene(self, layer: Layer) -> Scene | None:
        """Return a shown layer's scene; None before the first result."""
        return self._scenes.get(layer)

    def set_result(self, result: Result, settings: DisplaySettings, *, keep_limits: bool) -> None:
        """Take over another result, in limits of its own or in those of the last one."""
        self._result = result
        self.build(settings, keep_limits=keep_limits)

    def build(self, settings: DisplaySettings, *, keep_limits: bool) -> None:
        """Make the scenes of the layers that these settings show."""
        self._scenes = {}
        if self._result is None:
            return
        for layer in shown_layers(settings):
            if layer not in self._frames or not keep_limits:
                self._frames[layer] = scene_frame(self._result, layer, settings.scaling)
            self._scenes[layer] = make_scene(self._result, layer, self._frames[layer], self.companions)

    def set_companions(self, companions: Companions) -> None:
        """Look at what is shown with others."""
        self.companions = companions
        self._scenes = {layer: replace(scene, companions=companions) for layer, scene in self._scenes.items()}
