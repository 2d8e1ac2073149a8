"""The panels of the laboratory: one record each, in one table."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.store import Store
from qovr_app.work.worker import Worker
from qovr_core.registry import Registry


@dataclass(frozen=True)
class PanelRecord:
    """One panel.

    Parameters
    ----------
    name : the panel is called ``laboratory.NAME``, its command ``laboratory_NAME``
    title : what the menu says
    tip : one sentence on what it shows
    make : returns a new panel that shows the states of a store, dispatches to it, and does in a worker what takes time
    """

    name: str
    title: str
    tip: str
    make: Callable[[Store, Worker], LaboratoryPanel]

    @property
    def tab(self) -> str:
        """What the tab says: the one word of the title that tells it from the others, whole in a narrow column."""
        return self.title.replace("&", "").split()[-1].capitalize()


def _lazily(module: str, kind: str) -> Callable[[Store, Worker], LaboratoryPanel]:
    """Return what makes a panel whose module, with the libraries it draws with, is imported when it is first shown."""

    def make(store: Store, worker: Worker) -> LaboratoryPanel:
        panel: LaboratoryPanel = getattr(import_module(f"qovr_app.laboratory.{module}"), kind)(store, worker)
        return panel

    return make


PANELS: Registry[PanelRecord] = Registry("panel")
"""All panels, in the order of their tabs."""

for record in (
    PanelRecord(
        "curve", "One &curve", "One curve of the surface with all its parts", _lazily("curve_panel", "CurvePanel")
    ),
    PanelRecord(
        "influence",
        "&Influence",
        "What one point or knot moves, and how far",
        _lazily("influence_panel", "InfluencePanel"),
    ),
    PanelRecord(
        "comparison",
        "Co&mparison",
        "Bezier, B-spline, NURBS and Catmull-Rom of the same net: in the view, and measured",
        _lazily("comparison_panel", "ComparisonPanel"),
    ),
    PanelRecord(
        "section",
        "&Section",
        "Where a plane cuts the surface: in the view, as a curve with its length, and as points",
        _lazily("section_panel", "SectionPanel"),
    ),
    PanelRecord(
        "claims",
        "C&laims",
        "What the paper says of its surfaces, and what is so",
        _lazily("claims_panel", "ClaimsPanel"),
    ),
):
    PANELS.register(record)
PANELS.seal()
