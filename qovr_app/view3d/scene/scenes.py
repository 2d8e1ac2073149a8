"""The scenes of everything that is shown, from left to right, in limits that edits leave alone."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.view3d.scene.comparison import OtherSurface, compared
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.held_ranges import HeldRanges
from qovr_app.view3d.scene.scene import Scene, make_scene, scene_frame
from qovr_app.view3d.scene.shown import Shown
from qovr_core.layer import Layer


class Scenes:
    """What is made of what is shown; a scene is the same object until something in it changes.

    It is the one holder of the limits of axes and colours. They stay while a document is edited, and are taken anew for
    another document, formulation or layer, or when that is asked for.
    """

    def __init__(self) -> None:
        self._shown = Shown()
        self._other: OtherSurface | None = None
        self._frames: dict[Layer, Frame] = {}
        self._held = HeldRanges()
        self._own: dict[Layer, Scene] = {}
        self._scenes: list[Scene] = []

    def scene(self, number: int) -> Scene | None:
        """Return a scene, counted from the left; None where there is none."""
        return self._scenes[number] if number < len(self._scenes) else None

    def update(self, shown: Shown) -> None:
        """Make of what is shown now what differs from before."""
        before, self._shown = self._shown, shown
        has_other_net = before.net is not shown.net
        if has_other_net or before.comparison != shown.comparison:
            self._other = shown.comparison.made_of(shown.net) if shown.comparison and shown.net else None
        if shown.companions_differ(before):
            self._held = HeldRanges()
        begins_anew = _begins_anew(before, shown)
        if has_other_net or before.evaluation is not shown.evaluation or begins_anew:
            self._build(keep_limits=not begins_anew)
        elif shown.companions_differ(before):
            self._own = {
                layer: replace(scene, companions=shown.companions, held=self._held)
                for layer, scene in self._own.items()
            }
            self._compare()

    def take_limits(self) -> None:
        """Take the limits of axes and colours from what is shown now."""
        self._build(keep_limits=False)

    def _build(self, *, keep_limits: bool) -> None:
        """Make the scenes of the layers that are shown, in limits of their own or in those of before."""
        shown, evaluation, before = self._shown, self._shown.evaluation, self._own
        self._own, self._scenes = {}, []
        if evaluation is None:
            return
        if not keep_limits:
            self._held = HeldRanges()
        others = () if self._other is None else (self._other.box,)
        for layer in shown.settings.layer.layers:
            if layer not in self._frames or not keep_limits:
                self._frames[layer] = scene_frame(evaluation, layer, shown.settings.scaling, *others)
            frame, earlier = self._frames[layer], before.get(layer)
            scene = make_scene(evaluation, layer, frame, shown.companions, shown.document, earlier=earlier)
            self._own[layer] = replace(scene, held=self._held)
            if earlier is not None:
                self._own[layer].follow(earlier)
        self._compare()

    def _compare(self) -> None:
        """Put the other surface beside or over the layer that lies on the control net, or the only one."""
        self._scenes = list(self._own.values())
        if self._other is not None and self._scenes:
            resting = self._scenes[-1].evaluation.document.formulation.resting_layer
            own = self._own.get(resting, self._scenes[-1])
            number = self._scenes.index(own)
            self._scenes[number], *beside = compared(own, self._other)
            self._scenes += beside
        layers = [scene for scene in self._scenes if not scene.is_comparison]
        if self._shown.settings.shares_range:
            for scene in layers:
                scene.peers.update(other for other in layers if other is not scene)


def _begins_anew(before: Shown, shown: Shown) -> bool:
    """Return whether the limits of axes and colours are to be taken from what is shown now."""
    return (
        before.evaluation is None
        or before.opening != shown.opening
        or before.formulation is not shown.formulation
        or before.settings.layer is not shown.settings.layer
        or before.settings.scaling is not shown.settings.scaling
        or before.settings.shares_range is not shown.settings.shares_range
        or before.comparison != shown.comparison
        or (shown.settings.always_fits and not shown.dragging and _may_leave(before, shown))
    )


def _may_leave(before: Shown, shown: Shown) -> bool:
    """Return whether what is shown may have left the limits since they were taken."""
    is_same = before.evaluation is shown.evaluation and before.net is shown.net
    return not is_same or before.dragging or not before.settings.always_fits
