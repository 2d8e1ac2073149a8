"""What the view shows and how: values that the window keeps, compares and hands down whole."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from qovr_core.document import NetIndex
from qovr_core.fields import Field
from qovr_core.layer import Layer

UNCOLOURED = "none"
"""What the colours say where they say nothing."""


class LayerChoice(StrEnum):
    """Which layers are shown; ``BOTH`` shows the two with linked cameras."""

    RAW = "raw"
    TRANSFORMED = "transformed"
    BOTH = "both"

    @property
    def layers(self) -> tuple[Layer, ...]:
        """The layers from left to right."""
        return tuple(Layer) if self is LayerChoice.BOTH else (Layer(self.value),)


class Style(StrEnum):
    """How the surface is drawn. ``FACETS`` is MATLAB's ``surf``: one flat colour a cell, no light; ``CLAY`` is light
    alone.
    """

    FACETS = "facets"
    SMOOTH = "smooth"
    CLAY = "clay"
    WIREFRAME = "wireframe"
    POINTS = "points"


class ColourRange(StrEnum):
    """Which values the ends of the colours stand for: all, all but a few, or two given ones."""

    AUTO = "auto"
    ROBUST = "robust"
    FIXED = "fixed"


class ColourMap(StrEnum):
    """Colours of what has no middle of its own; ``JET`` is MATLAB's, as in the paper's figures."""

    JET = "jet"
    TURBO = "turbo"
    VIRIDIS = "viridis"
    CIVIDIS = "cividis"


class Scaling(StrEnum):
    """``EACH`` stretches every axis by itself to the same box, as MATLAB does; ``EQUAL`` keeps lengths
    comparable."""

    EACH = "each"
    EQUAL = "equal"


class Placement(StrEnum):
    """Where a surface stands that is compared with the document's: in a viewport of its own, or as lines over it."""

    BESIDE = "beside"
    OVER = "over"


class Projection(StrEnum):
    """How depth becomes size."""

    PARALLEL = "parallel"
    PERSPECTIVE = "perspective"


class ThemeName(StrEnum):
    """Which of the two colour sets."""

    LIGHT = "light"
    DARK = "dark"


class ThemeChoice(StrEnum):
    """Which of the two colour sets is wanted: always the same, or the system's."""

    SYSTEM = "system"
    LIGHT = "light"
    DARK = "dark"


class MouseScheme(StrEnum):
    """After which program's habits the middle and the right button of the mouse move the camera."""

    RHINO = "rhino"
    BLENDER = "blender"
    CAD = "cad"


class LaboratoryPlace(StrEnum):
    """Where the user wants the laboratory; ``AUTO`` is where there is most room for it."""

    AUTO = "auto"
    RIGHT = "right"
    BELOW = "below"
    FLOATING = "floating"


@dataclass(frozen=True)
class Underlay:
    """A picture that lies under the net, on the floor of the axes box, for something to be drawn after.

    Parameters
    ----------
    path : of the file
    left, bottom, width, height : where it lies, in the document's units along x and y
    opacity : above 0, up to 1
    """

    path: str
    left: float
    bottom: float
    width: float
    height: float
    opacity: float = 0.6


@dataclass(frozen=True)
class SectionChoice:
    """The plane that cuts the surface.

    Parameters
    ----------
    axis : x, y or z is constant on it, by its number
    place : what it is there; None for the middle of the surface
    through : two control points through which the plane stands upright instead
    """

    axis: int = 1
    place: float | None = None
    through: tuple[NetIndex, NetIndex] | None = None


@dataclass(frozen=True)
class DisplaySettings:
    """Everything a user can choose about the picture and what is around it, apart from the camera; ``replace`` makes
    the next one.

    ``document_samples`` draws the document's samples, all of them, joined by flat facets, in place of the exact surface
    as finely as it is seen. ``colour_by`` is the name of what the colours say: a field, or a pattern that follows the
    camera. ``shares_range`` lets a colour mean the same in both layers where both are shown. ``always_fits`` lets axes
    and colours follow every edit, not only another document, formulation or layer. ``combs_u`` and ``combs_v`` are
    curvature combs on isolines along u and v, their teeth ``comb_scale`` times as long as at first. ``section`` is seen
    while its panel is.
    """

    layer: LayerChoice = LayerChoice.TRANSFORMED
    style: Style = Style.FACETS
    document_samples: bool = False
    colour_map: ColourMap = ColourMap.CIVIDIS
    colour_by: str = Field.HEIGHT.name
    colour_range: ColourRange = ColourRange.AUTO
    fixed_range: tuple[float, float] = (0.0, 1.0)
    scaling: Scaling = Scaling.EACH
    projection: Projection = Projection.PARALLEL
    theme: ThemeName = ThemeName.LIGHT
    surface: bool = True
    parameter_lines: bool = True
    control_points: bool = True
    labels: bool = True
    control_net: bool = True
    row_curves: bool = False
    column_curves: bool = False
    joints: bool = True
    combs_u: bool = False
    combs_v: bool = False
    comb_scale: float = 1.0
    section: SectionChoice | None = None
    control_box: bool = False
    surface_box: bool = False
    knot_handles: bool = True
    axes: bool = True
    colour_bar: bool = True
    triad: bool = True
    legend: bool = True
    shares_range: bool = False
    probe: bool = False
    always_fits: bool = False
    underlay: Underlay | None = None
    mouse: MouseScheme = MouseScheme.BLENDER
    laboratory_place: LaboratoryPlace = LaboratoryPlace.AUTO

    @property
    def shown_colours(self) -> str:
        """The name of what the colours say as the surface is drawn: clay has none."""
        return UNCOLOURED if self.style is Style.CLAY else self.colour_by


PAPER_LOOK: dict[str, object] = {
    "style": Style.FACETS,
    "colour_map": ColourMap.JET,
    "colour_by": Field.HEIGHT.name,
    "colour_range": ColourRange.AUTO,
    "scaling": Scaling.EACH,
    "projection": Projection.PARALLEL,
    "surface": True,
    "parameter_lines": True,
    "axes": True,
    "colour_bar": True,
}
"""How MATLAB draws the paper's figures, by fields of ``DisplaySettings``."""
