"""The section of the surface, in the unit space."""

from __future__ import annotations

from qovr_app.state.display import SectionChoice
from qovr_app.state.sections import plane_of_choice, section_name
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, read_only
from qovr_core.geometry.section import section


def section_lines(scene: Scene, choice: SectionChoice) -> tuple[str, list[Array]]:
    """Return the section's name, and its pieces as lines (n, 3); computed once a scene and plane."""
    if ("section", choice) not in scene.cache:
        scene.cache["section", choice] = _made(scene, choice)
    found: tuple[str, list[Array]] = scene.cache["section", choice]
    return found


def _made(scene: Scene, choice: SectionChoice) -> tuple[str, list[Array]]:
    plane = plane_of_choice(choice, scene.document)
    if plane is None:
        return "", []
    offset, pieces = section(scene.surface, plane)
    return section_name(choice, offset), [read_only(scene.frame.to_unit(piece.points)) for piece in pieces]
