"""What the colours of the surface say: the values behind them, the range they are spread over, and its title."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from weakref import ref

import numpy as np
import numpy.typing as npt

from qovr_app.state.display import ColourRange, DisplaySettings, Scaling
from qovr_app.state.names import label
from qovr_app.style.colour_maps import DIVERGING, ENTRIES, colour_table
from qovr_app.style.theme import Rgb
from qovr_app.view3d.scene.frame import Frame
from qovr_app.view3d.scene.grid import Grid
from qovr_app.view3d.scene.mesh import FloatArray
from qovr_app.view3d.scene.patterns import PATTERNS, Pattern
from qovr_app.view3d.scene.scene import Scene
from qovr_core.arrays import Array, read_only
from qovr_core.fields import FIELDS, Field, Need, Range, field_range, field_rounding

UNDEFINED = -1e6
"""The part of the colours that a vertex without a value has: no other comes near it, and no driver tampers with it."""

_FARTHEST = 1e3
"""Parts of the colours are cut here on their way into single precision, far beyond where colours end."""

_NO_RANGE = (np.nan, np.nan)
_LONGEST_NAME = 24

SINGULAR_NOTE = "There is no curvature: the surface is drawn together into a line or a point"
SIZE_NOTE = "There is no curvature: at this size its numbers are too large or too small for a computer"
FAR_NOTE = "Between its samples the surface runs far out of the picture"

_STRETCHED = " (stretched)"


@dataclass(frozen=True, eq=False)
class Colouring:
    """The meaning of the colours of one viewport.

    Parameters
    ----------
    table : (256, 3) uint8, the colours from the lower to the upper limit
    title : for the colour bar; the letters after ``_`` are a subscript
    limits : the values at the ends of the colours; NaN where nothing has a value
    beyond : whether values lie below the lower limit, and above the upper one
    note : what keeps the picture from saying more, and how to change that; else empty
    values : gives the values at the vertices of a grid, (n, m) float64, NaN where there are none, while the scene lives
    pattern : what the colours show instead of values; None where they show values
    ramp : what ``parts`` of a coordinate is of x, y, z in the unit space and 1, (4,); None of what is no coordinate
    """

    table: npt.NDArray[np.uint8]
    title: str
    limits: Range = _NO_RANGE
    beyond: tuple[bool, bool] = (False, False)
    note: str = ""
    values: Callable[[Grid], Array] = lambda grid: np.full(grid.shape, np.nan)
    pattern: Pattern | None = None
    ramp: Array | None = None

    def parts(self, grid: Grid) -> FloatArray:
        """Return where in the colours the values on a grid lie: 0 and 1 are the ends, ``UNDEFINED`` is nowhere.

        Returns
        -------
        (n, m) float32, read-only
        """
        values, (low, high) = self.values(grid), self.limits
        parts = np.subtract(values, low)
        if high > low:
            parts /= high - low
        else:
            parts[np.isfinite(parts)] = 0.5
        result = np.clip(parts, -_FARTHEST, _FARTHEST, out=parts).astype(np.float32)
        result[np.isnan(result)] = UNDEFINED
        return read_only(result)

    def colours(self, parts: Array, undefined: Rgb) -> npt.NDArray[np.uint8]:
        """Return red, green and blue (..., 3) of parts of the colours; ``undefined`` where there is no value."""
        entries = np.clip(parts * ENTRIES, 0, ENTRIES - 1).astype(np.intp)
        is_undefined = parts < UNDEFINED / 2
        return np.where(is_undefined[..., None], np.array(undefined, dtype=np.uint8), self.table[entries])


def colouring_of(scene: Scene, settings: DisplaySettings, grid: Grid, *, moving: bool) -> Colouring:
    """Return what the colours say of a scene; while the same is asked, the very same object.

    Parameters
    ----------
    grid : from whose vertices limits are taken where the settings leave them open
    moving : something moves, so that costly values are taken from a coarser grid
    """
    ranged = (settings.colour_range, settings.fixed_range, settings.document_samples)
    key = (settings.shown_colours, settings.colour_map, settings.scaling, *ranged)
    found = scene.cache.get((key, grid, moving))
    if found is None:
        if settings.shown_colours in PATTERNS:
            found = _pattern_colouring(PATTERNS[settings.shown_colours], settings)
        else:
            found = _field_colouring(scene, settings, grid, moving)
        scene.cache[key, grid, moving] = found
    return found


def _pattern_colouring(pattern: Pattern, settings: DisplaySettings) -> Colouring:
    title = pattern.title + (_STRETCHED if settings.scaling is Scaling.EACH else "")
    limits = (pattern.ticks[0], pattern.ticks[-1]) if pattern.ticks else _NO_RANGE
    table = _steps(pattern.colours) if pattern.colours else colour_table(settings.colour_map)
    return Colouring(table, title, limits, pattern=pattern)


@lru_cache(maxsize=8)
def _steps(colours: tuple[Rgb, ...]) -> npt.NDArray[np.uint8]:
    """Return a table of few colours, (256, 3) uint8."""
    steps = np.linspace(0, len(colours), ENTRIES, endpoint=False).astype(np.intp)
    return read_only(np.array(colours, dtype=np.uint8)[steps])


def _field_colouring(scene: Scene, settings: DisplaySettings, grid: Grid, moving: bool) -> Colouring:
    field = FIELDS[settings.colour_by]
    title, note = _title(scene, field), _missing(scene, field)
    colour_map = DIVERGING if field.is_diverging else settings.colour_map
    if note:
        return Colouring(colour_table(colour_map), title, note=note)

    # The scene keeps what its colours say: were it held by that in turn, it would stay, with all that it has made,
    # until Python looks for circles, which it does by the number of objects, not by their size.
    of_scene = ref(scene)

    def values(grid: Grid) -> Array:
        alive = of_scene()
        assert alive is not None, "colours are asked of a picture, which holds its scene"
        return alive.values(field, grid, moving=moving)

    alike = [scene, *(peer for peer in scene.peers if not _missing(peer, field))]
    if settings.document_samples and field.axis is not None and settings.colour_range is not ColourRange.ROBUST:
        seen = np.concatenate([each.surface_box[field.axis] for each in alike])  # their samples are what is seen
    else:
        seen = np.concatenate([each.values(field, grid.over(each.surface), moving=moving).ravel() for each in alike])
    limits, beyond = _limits(scene, settings, field, seen, moving)
    table = _section(colour_map, _reach(limits), limits) if colour_map == DIVERGING else colour_table(colour_map)
    ramp = None if field.axis is None else _ramp(scene.frame, field.axis, limits)
    return Colouring(table, title, limits, beyond, _remark(scene, field, limits), values, ramp=ramp)


def _ramp(frame: Frame, axis: int, limits: Range) -> Array:
    """Return (4,) what the part of the colours is of x, y, z in the unit space, and 1."""
    ramp, (low, high) = np.array([0.0, 0.0, 0.0, 0.5]), limits
    if high > low:
        ramp[axis] = 1 / (frame.scale[axis] * (high - low))
        ramp[3] = (frame.centre[axis] - low) / (high - low)
    return read_only(ramp)


def _limits(
    scene: Scene, settings: DisplaySettings, field: Field, values: Array, moving: bool
) -> tuple[Range, tuple[bool, bool]]:
    """Return the limits, and whether values lie below or above them."""
    rounding = scene.evaluation.layer_rounding(scene.layer)
    least, every = field_rounding(field, scene.surface_box.T, rounding), values
    if field.axis is not None:  # coordinates are those of the document's samples, like the boxes that are printed
        every = np.array([each.surface_box[field.axis] for each in (scene, *scene.peers)])
    if not np.isfinite(values).any():
        return field_range(field, every, robust=False, least=least), (False, False)
    limits = settings.fixed_range
    if settings.colour_range is not ColourRange.FIXED:
        robust = settings.colour_range is ColourRange.ROBUST
        own = field_range(field, values if robust else every, robust=robust, least=least)
        key = (scene.layer, scene.is_comparison, field.name, settings.colour_range, settings.style)
        limits = scene.held.range_of(key, own, scene.evaluation, moving=moving)
        if limits == own and not robust:
            return limits, (False, False)
    finite = values[np.isfinite(values)]
    return limits, (bool(finite.min() < limits[0] - least), bool(finite.max() > limits[1] + least))


def _reach(limits: Range) -> float:
    return max(abs(limits[0]), abs(limits[1]))


@lru_cache(maxsize=8)
def _section(colour_map: str, reach: float, limits: Range) -> npt.NDArray[np.uint8]:
    """Return the colours between two values of a map that is spread over [-reach, reach], (256, 3) uint8."""
    table, (low, high) = colour_table(colour_map), limits
    if not high > low or low == -high:
        return table
    places = (np.linspace(low, high, ENTRIES) / reach + 1) / 2 * (ENTRIES - 1)
    channels = [np.interp(places, np.arange(ENTRIES), table[:, channel]) for channel in range(3)]
    return read_only(np.rint(np.stack(channels, axis=1)).astype(np.uint8))


def _title(scene: Scene, field: Field) -> str:
    name = _name_beside(scene, field.needs)
    return field.title_beside.format(name) if name else field.title


def _name_beside(scene: Scene, need: Need | None) -> str:
    """Return the name of what a field with this need is given; empty where there is none."""
    companions = scene.companions
    if need is Need.REFERENCE:
        name = companions.reference_name
        return name if len(name) <= _LONGEST_NAME else name[: _LONGEST_NAME - 1] + "…"
    return label(companions.knot) if need is Need.KNOT and companions.knot is not None else ""


def _missing(scene: Scene, field: Field) -> str:
    """Return what has to be done before there is anything to show."""
    if field.needs is Need.KNOT and scene.is_comparison:
        return f"A {scene.name} surface has no internal knots"
    return field.missing if field.needs is not None and scene.beside(field.needs) is None else ""


def _remark(scene: Scene, field: Field, limits: Range) -> str:
    """Return what the values leave to be said."""
    if np.isnan(limits[0]):
        return SINGULAR_NOTE if _has_products(scene.surface_box) else SIZE_NOTE
    slope = scene.knot_slope if field.needs is Need.KNOT else None
    if slope is not None and not slope.coefficients.any():
        return f"{_name_beside(scene, field.needs)} has no effect on the {scene.document.formulation} surface"
    return FAR_NOTE if scene.leaves_sight else ""


def _has_products(box: Array) -> bool:
    """Return whether the products of four lengths, of which curvature is made, are numbers for a surface in a box."""
    extent = float(np.ptp(box, axis=1).max())
    with np.errstate(over="ignore", under="ignore"):
        return bool(0 < np.float64(extent) ** 4 < np.inf) or extent == 0
