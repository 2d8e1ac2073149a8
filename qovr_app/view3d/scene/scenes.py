"""The stage: an evaluation as the scenes of the layers that are shown, in limits that can be held still."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.state.display import DisplaySettings
from qovr_app.view3d.scene.comparison import Rival, RivalSurface, face_rival
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.scene import Companions, Scene, make_scene, scene_frame
from qovr_core import Document, Evaluation, Layer


class Stage:
    """Holds the evaluation and what is made of it; a scene is the same object until something in it changes."""

    def __init__(self) -> None:
        self._evaluation: Evaluation | None = None
        self._document: Document | None = None
        self.companions = Companions()
        self._rival: Rival | None = None
        self._facing: RivalSurface | None = None
        self._frames: dict[Layer, Frame] = {}
        self._own: dict[Layer, Scene] = {}
        self._scenes: list[Scene] = []

    def count(self, settings: DisplaySettings) -> int:
        """Return how many scenes there are, or will be with the first evaluation."""
        beside = self._rival is not None and self._rival.is_beside
        return len(settings.layer.layers) + beside

    def scene(self, number: int) -> Scene | None:
        """Return a scene, counted from the left; None before the first evaluation."""
        return self._scenes[number] if number < len(self._scenes) else None

    def set_evaluation(
        self, evaluation: Evaluation, document: Document, settings: DisplaySettings, *, keep_limits: bool
    ) -> None:
        """Take over another evaluation and control net, in limits of its own or in those of the last one."""
        self._evaluation, self._document = evaluation, document
        self._meet()
        self.build(settings, keep_limits=keep_limits)

    def set_rival(self, rival: Rival | None, settings: DisplaySettings) -> None:
        """Compare with another kind of surface, or with none."""
        self._rival = rival
        self._meet()
        self.build(settings, keep_limits=False)

    def build(self, settings: DisplaySettings, *, keep_limits: bool) -> None:
        """Make the scenes of the layers that these settings show."""
        self._own = {}
        if self._evaluation is None:
            return
        others = () if self._facing is None else (self._facing.box,)
        for layer in settings.layer.layers:
            if layer not in self._frames or not keep_limits:
                self._frames[layer] = scene_frame(self._evaluation, layer, settings.scaling, *others)
            self._own[layer] = make_scene(self._evaluation, layer, self._frames[layer], self.companions, self._document)
        self._place()

    def set_companions(self, companions: Companions) -> None:
        """Look at what is shown with others."""
        self.companions = companions
        self._own = {layer: replace(scene, companions=companions) for layer, scene in self._own.items()}
        self._place()

    def _meet(self) -> None:
        """Make the rival's surface of the control net."""
        is_met = self._rival is not None and self._document is not None
        self._facing = RivalSurface(self._rival, self._rival.surface_of(self._document)) if is_met else None

    def _place(self) -> None:
        """Put the rival beside or over the layer that lies on the control net, or the only one."""
        self._scenes = list(self._own.values())
        if self._facing is not None and self._own:
            layer = self._evaluation.document.formulation.resting_layer
            own = self._own.get(layer, self._scenes[-1])
            number = self._scenes.index(own)
            scenes = face_rival(own, self._facing)
            self._scenes[number] = scenes[0]
            self._scenes += scenes[1:]
