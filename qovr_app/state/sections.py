"""The section of a document's surface by the plane that was chosen."""

from __future__ import annotations

from dataclasses import replace

from qovr_app.state.display import DisplaySettings, SectionChoice
from qovr_app.state.names import AXES
from qovr_core import Document
from qovr_core.geometry.section import CuttingPlane, plane_across, upright_plane

PANEL = "section"
"""The panel while which is shown the view shows the section."""


def settings_shown(display: DisplaySettings, panel: str) -> DisplaySettings:
    """Return how the view shows the surface while a panel of the laboratory is open: with a section or without."""
    section = (display.section or SectionChoice()) if panel == PANEL else None
    return display if section == display.section else replace(display, section=section)


def plane_of_choice(choice: SectionChoice, document: Document) -> CuttingPlane | None:
    """Return the plane; None where its two points stand over each other, or are no points of the document."""
    if choice.through is None:
        return plane_across(choice.axis, choice.place)
    rows, columns = document.control_points.shape[:2]
    if any(i >= rows or j >= columns for i, j in choice.through):
        return None
    start, end = (document.control_points[index] for index in choice.through)
    return upright_plane(start, end)


def section_name(choice: SectionChoice, offset: float) -> str:
    """Return what a legend calls the section."""
    if choice.through is not None:
        return "Section P_{},{} to P_{},{}".format(*choice.through[0], *choice.through[1])
    return f"Section {AXES[choice.axis]} = {offset:.4g}"
