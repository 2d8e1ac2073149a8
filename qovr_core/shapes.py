"""New documents to begin with: nets made by formulas, all of them interpolating."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from qovr_core.arrays import Array
from qovr_core.document import Document
from qovr_core.errors import SourceError, quoted
from qovr_core.formulations import Formulation
from qovr_core.geometry.knots import KNOT_NAMES, KnotTable
from qovr_core.geometry.windows import NET_SIZE, window_count
from qovr_core.joints import Joint
from qovr_core.presets import network_case

_R, _T = (KNOT_NAMES.index(name) for name in "rt")

_FOLD = 0.25
"""How far the knots beside a crease stand from 0.5: a right-angled corner keeps a clear edge."""

_DECIMALS = 4
"""Of the points of nets that formulas make: fields show them whole."""

Height = Callable[[Array, Array], Array]
"""Heights over x and y, both from -1 to 1."""


@dataclass(frozen=True)
class Shape:
    """A net to begin with.

    Parameters
    ----------
    title : what menus say
    document : makes it
    """

    title: str
    document: Callable[[], Document]


def _over_grid(height: Height) -> Callable[[], Document]:
    """Return what makes a net over the paper's grid, x = j and y = i."""

    def make() -> Document:
        y, x = np.mgrid[:NET_SIZE, :NET_SIZE].astype(np.float64)
        half = (NET_SIZE - 1) / 2
        z = np.broadcast_to(height(x / half - 1, y / half - 1), x.shape)
        return Document(np.stack([x, y, z], axis=-1), formulation=Formulation.INTERPOLATING)

    return make


def _papers_net() -> Document:
    return Document(network_case().document.control_points, formulation=Formulation.INTERPOLATING)


def _net(rows: int, columns: int) -> tuple[Array, Array]:
    """Return how far along v and u each point of a net lies, both from 0 to 1 inside, and beyond at its rim."""
    v, u = np.meshgrid(np.arange(rows) - 1.0, np.arange(columns) - 1.0, indexing="ij")
    return v / (rows - 3), u / (columns - 3)


def _hood() -> Document:
    """A sheet like a car's bonnet: crowned, falling to the nose, two soft lines along it."""
    v, u = _net(11, 13)
    across, along = 2 * u - 1, v
    crown = 1 - 0.35 * across**2
    fall = 0.9 * along - 0.45 * along**2
    lines = 0.05 * np.exp(-(((np.abs(across) - 0.45 - 0.1 * along) / 0.12) ** 2)) * along
    x = across * (0.9 + 0.18 * along - 0.1 * along**2)
    y = 1.35 * along - 0.12 * (1 - across**2) * (1 - along)
    z = 0.42 * crown * (0.35 + 0.75 * fall) + lines
    return _interpolating(x, y, z)


def _vase() -> Document:
    """A turned vessel whose net closes along u."""
    rows, around = 15, 12
    v, _ = _net(rows, around + 3)
    angle = 2 * np.pi * np.arange(around) / around
    angle = np.concatenate([angle, angle[:3]])
    radius = 0.44 + 0.2 * np.sin(5.9 * v - 0.6) + 0.12 * np.clip(v, 0, None) ** 8
    return _interpolating(radius * np.cos(angle), radius * np.sin(angle), 1.6 * v, closed=["u"])


def _folded_saddle() -> Document:
    """A saddle with a crease across its middle."""
    v, u = _net(9, 11)
    x, y = 2 * u - 1, 2 * v - 1
    z = 0.35 * (x**2 - y**2) - 0.45 * np.abs(x)
    smooth = _interpolating(x, y, z)
    knots = smooth.row_knots.array.copy()
    last = knots.shape[1] // 2
    knots[:, last - 1, _T], knots[:, last, _R] = 0.5 - _FOLD, 0.5 + _FOLD
    joints = [Joint.SHARP if joint == last - 1 else Joint.SMOOTH for joint in range(knots.shape[1] - 1)]
    return replace(smooth, row_knots=KnotTable(knots), joints=replace(smooth.joints, u=tuple(joints)))


def _terrain() -> Document:
    """Hills of 41 x 41 points: ridges of waves, each shorter and lower than the one before, bent by it."""
    v, u = _net(41, 41)
    x, y = 4 * u, 4 * v
    height, bend = np.zeros_like(x), np.zeros_like(x)
    for octave in range(4):
        scale = 1.9**octave
        turned = 0.8 * x + 0.6 * y, 0.8 * y - 0.6 * x
        wave = np.sin(scale * turned[0] + 1.7 * octave + bend) * np.cos(scale * turned[1] - 0.9 * octave)
        height += (1 - 2 * np.abs(wave)) * 0.55 / scale**1.15
        bend, (x, y) = bend + 0.9 * wave, turned
    return _interpolating(4 * u, 4 * v, 0.6 * height)


def _interpolating(x: Array, y: Array, z: Array, closed: Sequence[str] = ()) -> Document:
    """Return a document with all knots 0.5, samples ten a window and more."""
    net = np.stack(np.broadcast_arrays(x, y, z), axis=-1).round(_DECIMALS) + 0.0
    samples = [max(101, 10 * window_count(count) + 1) for count in net.shape[1::-1]]
    return Document(net, formulation=Formulation.INTERPOLATING, samples=samples, closed=closed)


SHAPES = {
    "paper": Shape("Paper's net", _papers_net),
    "flat": Shape("Flat", _over_grid(lambda _x, _y: np.zeros(1))),
    "dome": Shape("Dome", _over_grid(lambda x, y: 2 - x**2 - y**2)),
    "saddle": Shape("Saddle", _over_grid(lambda x, y: x**2 - y**2)),
    "wave": Shape("Wave", _over_grid(lambda x, _y: np.sin(np.pi * x) / 2)),
    "hood": Shape("Car hood, 5 x 4 windows", _hood),
    "vase": Shape("Vase, closed around", _vase),
    "folded-saddle": Shape("Saddle with a crease", _folded_saddle),
    "terrain": Shape("Terrain, 41 x 41 points", _terrain),
}
"""What File, New offers, by name; also sources, as ``shape:vase``."""


def shape(name: str) -> Shape:
    """Return a shape by name.

    Raises
    ------
    SourceError : there is no such shape
    """
    try:
        return SHAPES[name]
    except KeyError:
        raise SourceError(f"there is no shape '{quoted(name)}'; expected one of {', '.join(SHAPES)}") from None
