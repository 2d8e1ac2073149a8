"""The paper's pipeline in its order: raw surface, boxes, transformation, transformed surface."""

from __future__ import annotations

from collections.abc import Callable
from threading import RLock
from typing import Any, Final, TypeVar

import numpy as np

from qovr_core.arrays import Array, read_only
from qovr_core.construction import CurveNetwork, bounds_of_windows, build_patch, curve_network, window_rounding
from qovr_core.document import Document
from qovr_core.geometry.alignment import Alignment, align, bounding_box
from qovr_core.geometry.locate import even
from qovr_core.geometry.patch import Patch
from qovr_core.geometry.rounding import NOISE
from qovr_core.layer import Layer

_T = TypeVar("_T")

_ROUNDING = "rounding of windows"
_BOUNDS = "bounds of windows"


def parameters(samples: int) -> Array:
    """Return the sample parameters of one direction, (samples,) from 0 to 1: counted, never accumulated."""
    return read_only(np.linspace(0.0, 1.0, samples))


class Evaluation:
    """What a document's surface is: its exact patch at once, all else when it is asked for, and then once.

    It never changes and may be asked from several threads. Every array is float64 and read-only.

    Parameters
    ----------
    document : what is evaluated
    base : an evaluation from which it may differ in a few windows, which alone are then computed

    Attributes
    ----------
    document : what was evaluated
    patch : the raw surface, exact

    Raises
    ------
    EvaluationError : the coordinates are not finite in double precision

    Examples
    --------
    >>> net = [[[j, i, 0] for j in range(5)] for i in range(5)]
    >>> evaluation = Evaluation(Document(net, formulation="interpolating", samples=(4096, 4096)))
    >>> evaluation.degree, evaluation.flat_axes  # no sample is kept for these
    ((4, 4), ('z',))
    """

    def __init__(self, document: Document, base: Evaluation | None = None) -> None:
        self.document: Final = document
        self.patch: Final[Patch] = build_patch(document, (base.document, base.patch) if base else None)
        self._bases = _known_by_windows(base) if base else {}
        self._known: dict[str, Any] = {}
        self._lock = RLock()

    @property
    def degree(self) -> tuple[int, int]:
        """The surface's degree in u and in v, each 4 or 6."""
        return self.patch.degree

    @property
    def network(self) -> CurveNetwork:
        """The curves C_i(u) and K_j(v) of (42) and (43)."""
        return self._once("network", lambda: curve_network(self.document))

    @property
    def control_box(self) -> Array:
        """The box of the control points, (3, 2) with columns min and max."""
        return self._once("control_box", lambda: bounding_box(self.document.control_points))

    @property
    def raw_box(self) -> Array:
        """The box of the raw samples, (3, 2) with columns min and max; hardly any of them is computed for it."""
        return self._once("raw_box", lambda: self.patch.sampled_box(*self.document.intervals, self._window_bounds))

    @property
    def matrix(self) -> Array:
        """The transformation T of (61)-(65), (4, 4); it acts on columns [x y z 1]."""
        return self._alignment.matrix

    @property
    def flat_axes(self) -> tuple[str, ...]:
        """The axes, of ``x``, ``y``, ``z``, along which the raw samples have no extent, so that T only moves there."""
        return self._alignment.flat_axes

    @property
    def rounding(self) -> Array:
        """Up to what size a raw coordinate, or a difference of two, is no more than rounding, (3,) for x, y and z."""
        windows = self._once(_ROUNDING, lambda: window_rounding(self.document, self._bases.get(_ROUNDING)))
        return self._once("rounding", lambda: read_only(windows.max(axis=(0, 1))))

    def layer_rounding(self, layer: Layer) -> Array:
        """Return up to what size a coordinate of a layer, or a difference of two, is no more than rounding, (3,)."""
        if layer is Layer.RAW:
            return self.rounding
        return read_only(self.matrix.diagonal()[:3] * self.rounding + NOISE * np.abs(self.matrix[:3, 3]))

    @property
    def transformed_patch(self) -> Patch:
        """The transformed surface, exact."""
        return self._once("transformed_patch", lambda: self.patch.transformed(self.matrix))

    def layer_patch(self, layer: Layer) -> Patch:
        """Return the surface of a layer, exact."""
        return self.patch if layer is Layer.RAW else self.transformed_patch

    @property
    def u(self) -> Array:
        """The samples' places along u, ascending: the window, plus the place in it from 0 to 1."""
        return self._once("u", lambda: even(self.document.intervals[0]).place)

    @property
    def v(self) -> Array:
        """The samples' places along v, likewise."""
        return self._once("v", lambda: even(self.document.intervals[1]).place)

    @property
    def raw(self) -> Array:
        """Samples of the raw surface, (N, M, 3) indexed [iu, iv]; where windows do not meet, of that which begins."""
        return self._once("raw", lambda: self.patch.samples(*self.document.intervals))

    @property
    def transformed(self) -> Array:
        """Samples of the transformed surface, (N, M, 3) indexed [iu, iv]."""
        return self._once("transformed", lambda: self.transformed_patch.samples(*self.document.intervals))

    def samples(self, layer: Layer) -> Array:
        """Return the samples of a layer, (n, m, 3) indexed [iu, iv]."""
        return self.raw if layer is Layer.RAW else self.transformed

    def drop_samples(self) -> None:
        """Forget all samples, which may be large; asked for again, they are computed again."""
        with self._lock:
            for name in ("raw", "transformed"):
                self._known.pop(name, None)

    @property
    def _alignment(self) -> Alignment:
        return self._once("alignment", lambda: align(self.raw_box, self.control_box, self.rounding))

    def _window_bounds(self) -> Array:
        return self._once(_BOUNDS, lambda: bounds_of_windows(self.document, self.patch, self._bases.get(_BOUNDS)))

    def _once(self, name: str, compute: Callable[[], _T]) -> _T:
        """Return what is computed at most once, whichever thread asks first."""
        with self._lock:
            if name not in self._known:
                self._known[name] = compute()
            value: _T = self._known[name]
            return value


def _known_by_windows(evaluation: Evaluation) -> dict[str, tuple[Document, Array]]:
    """Return what is known by windows, and of which document: all that the next evaluation keeps of this one."""
    known = {name: evaluation._known[name] for name in (_ROUNDING, _BOUNDS) if name in evaluation._known}
    return evaluation._bases | {name: (evaluation.document, array) for name, array in known.items()}


def configure(document: Document) -> Evaluation:
    """Run the paper's whole pipeline: raw samples, boxes, T, transformed samples (Figure 3, Algorithm 1).

    Raises
    ------
    EvaluationError : the coordinates are not finite in double precision

    Examples
    --------
    >>> import numpy as np, qovr_core
    >>> y, x = np.mgrid[:5, :5]
    >>> document = qovr_core.Document(np.stack([x, y, x * y], axis=-1), formulation="interpolating")
    >>> evaluation = qovr_core.configure(document)
    >>> evaluation.raw.shape, evaluation.transformed.shape, evaluation.matrix.shape
    ((101, 101, 3), (101, 101, 3), (4, 4))
    >>> evaluation.patch.points([0.5], [0.5]).round(9).tolist()
    [[[2.0, 2.0, 4.0]]]
    """
    evaluation = Evaluation(document)
    for layer in Layer:
        evaluation.samples(layer)
    return evaluation
