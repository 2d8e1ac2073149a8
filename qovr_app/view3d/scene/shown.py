"""Everything that a view is given to show, as one value."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Any

from qovr_app.state.display import DisplaySettings
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.state.tools import ToolSettings
from qovr_app.view3d.scene.companions import Companions
from qovr_app.view3d.scene.comparison import ComparisonView
from qovr_core import Document, Evaluation, ParametricSurface
from qovr_core.document import NetIndex, Window
from qovr_core.fields import FIELDS
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import KnotPlace

_MARKS = ("selected", "last_selected", "pending", "refused", "put_away", "curve", "window")


@dataclass(frozen=True, eq=False)
class Shown:
    """What is shown and how, apart from what belongs to the view alone: its camera and its mouse.

    Parameters
    ----------
    evaluation : the surface; None where there is none yet
    document : whose control points and curves are shown; None for the evaluation's own
    settings : how it is shown
    tools : how control points are picked and moved
    selected : the control points that are marked
    last_selected : the one of them that was picked last; None where none is
    pending, refused : the control points over which something is typed that is not set, and that cannot be
    put_away : the control points that are not shown
    reference : a surface in the document's units, from which distances are taken; None without one
    reference_name : what to call it
    knot : the knot to which the sensitivity is shown; None without one
    curve : the knot that is turned to, whose curve has handles; None for none
    window : the window of the net through which the zones look, which is outlined; None for none
    comparison : another surface of the same control net beside the document's, or over it; None for none
    opening : which of the documents that were opened this is: another one gets limits of its own
    dragging : a control point is being dragged, so that the limits of the axes stay whatever is chosen
    """

    evaluation: Evaluation | None = None
    document: Document | None = None
    settings: DisplaySettings = field(default_factory=DisplaySettings)
    tools: ToolSettings = field(default_factory=ToolSettings)
    selected: frozenset[NetIndex] = frozenset()
    last_selected: NetIndex | None = None
    pending: frozenset[NetIndex] = frozenset()
    refused: frozenset[NetIndex] = frozenset()
    put_away: frozenset[NetIndex] = frozenset()
    reference: ParametricSurface | None = None
    reference_name: str = ""
    knot: KnotPlace | None = None
    curve: KnotInHand | None = None
    window: Window | None = None
    comparison: ComparisonView | None = None
    opening: int = 0
    dragging: bool = False

    @property
    def companions(self) -> Companions:
        """What the surface is looked at with."""
        return Companions(self.reference, self.reference_name, self.knot)

    @property
    def viewports(self) -> int:
        """How many viewports it takes: one a layer, and one for a surface beside them."""
        is_beside = self.comparison is not None and self.comparison.is_beside
        return len(self.settings.layer.layers) + is_beside

    def settings_of(self, viewport: int) -> DisplaySettings:
        """Return how a viewport shows its surface: of layers with one range of colours the last has the bar for all."""
        layers = len(self.settings.layer.layers)
        if self.settings.shares_range and viewport < layers - 1:
            return replace(self.settings, colour_bar=False)
        return self.settings

    def differs_visibly(self, before: Shown) -> bool:
        """Return whether something is seen that was not before, apart from the surface and its net."""
        field = FIELDS.get(self.settings.colour_by)
        shows_companions = self.settings.probe or (field is not None and field.needs is not None)
        return (
            self.settings != before.settings
            or self.comparison != before.comparison
            or (self.marks, self.tools) != (before.marks, before.tools)
            or (shows_companions and self.companions_differ(before))
        )

    @property
    def marks(self) -> dict[str, Any]:
        """What is marked, by fields that a picture has too."""
        return {name: getattr(self, name) for name in _MARKS}

    def companions_differ(self, before: Shown) -> bool:
        """Return whether the surface is looked at with something else than before."""
        named = (self.reference_name, self.knot) != (before.reference_name, before.knot)
        return named or self.reference is not before.reference

    @property
    def formulation(self) -> Formulation | None:
        """How the surface is made; None where there is none."""
        return None if self.evaluation is None else self.evaluation.document.formulation

    @property
    def net(self) -> Document | None:
        """The document whose control net is shown."""
        return self.document or (None if self.evaluation is None else self.evaluation.document)
