"""How a displacement falls off with the distance from where it is largest."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from qovr_core.arrays import Array, read_only

EXPONENTIAL_MISFIT = 0.02
"""An exponential that misses the envelope by more than this part of the largest displacement does not describe it:
2 % is seen at a glance in a plot, and far above the 0.1 % with which bins of this width know the envelope."""

_BIN = 0.025
"""Width of a bin of distances: more than twice the step of a 101 x 101 grid, so that no bin is empty."""

_LENGTHS = (1e-3, 1e3)
"""Between these L is sought: shorter falls within a single bin, longer does not fall over the whole square."""

_CANDIDATES = 60
_ROUNDS = 6
"""Every round narrows L to two of 59 intervals: six leave less than 1e-8 of it."""


@dataclass(frozen=True)
class Exponential:
    """The exponential ``amplitude * exp(-d / length)`` nearest to an envelope.

    Parameters
    ----------
    amplitude : A, in the unit of the displacement
    length : L, the parameter distance over which it falls to 1 / e
    misfit : root mean square of its deviations from the envelope, as part of the largest displacement
    """

    amplitude: float
    length: float
    misfit: float

    @property
    def fits(self) -> bool:
        """Whether the displacement can be called exponential at all."""
        return self.misfit <= EXPONENTIAL_MISFIT

    def at(self, distance: Array) -> Array:
        """Return its values at distances, of the same shape."""
        return self.amplitude * np.exp(-distance / self.length)


@dataclass(frozen=True, eq=False)
class Falloff:
    """Displacement against distance.

    The distance is sqrt((u - u*)^2 + (v - v*)^2), measured in the parameters from the place (u*, v*) of the largest
    displacement: from any other place it would not even begin with its largest value.

    Parameters
    ----------
    distance : (n, m) distance of every sample
    envelope : (k, 2) distance and displacement of the sample that moves most in each bin of distances, the
        largest displacement itself first
    exponential : the best one through the envelope
    """

    distance: Array
    envelope: Array
    exponential: Exponential


def falloff(u: Array, v: Array, magnitude: Array, peak: tuple[float, float, float]) -> Falloff:
    """Return how a displacement falls off.

    Parameters
    ----------
    u, v : (n,) and (m,) parameters of the samples
    magnitude : (n, m) length of the displacement, indexed [iu, iv]
    peak : where it is largest, u* and v*, and how large it is there; above 0
    """
    u_peak, v_peak, largest = peak
    distance = np.hypot((u - u_peak)[:, None], (v - v_peak)[None, :])
    envelope = np.vstack([[0.0, largest], _envelope(distance.ravel(), magnitude.ravel())])
    return Falloff(read_only(distance), read_only(envelope), fit_exponential(envelope[:, 0], envelope[:, 1]))


def fit_exponential(distance: Array, displacement: Array) -> Exponential:
    """Return the exponential nearest to displacements in the sense of least squares.

    Parameters
    ----------
    distance, displacement : (k,) each; a displacement above 0 among them
    """
    largest = displacement.max()
    wanted = displacement / largest
    low, high = _LENGTHS
    for _ in range(_ROUNDS):
        lengths = np.geomspace(low, high, _CANDIDATES)
        best, amplitude, deviations = best_decay(distance, wanted, lengths)
        low, high = lengths[max(best - 1, 0)], lengths[min(best + 1, _CANDIDATES - 1)]
    misfit = np.sqrt((deviations**2).mean())
    return Exponential(float(largest * amplitude), float(lengths[best]), float(misfit))


def best_decay(distance: Array, values: Array, lengths: Array) -> tuple[int, float, Array]:
    """Return the number of the length L at which A exp(-d / L) meets values best by least squares, A, and what is off.

    Parameters
    ----------
    distance, values : (k,) each
    lengths : (n,) the lengths to choose from

    Returns
    -------
    the number, A, and the deviations (k,) of that exponential from the values
    """
    shapes = np.exp(-distance / lengths[:, None])
    amplitudes = shapes @ values / np.einsum("lk,lk->l", shapes, shapes)
    deviations = amplitudes[:, None] * shapes - values
    best = int(np.einsum("lk,lk->l", deviations, deviations).argmin())
    return best, float(amplitudes[best]), deviations[best]


def _envelope(distance: Array, magnitude: Array) -> Array:
    """Return distance and displacement of the sample that moves most in every bin, (k, 2), by growing distance."""
    bins = (distance / _BIN).astype(np.intp)
    most = np.zeros(bins.max() + 1)
    np.maximum.at(most, bins, magnitude)
    moves_most = np.flatnonzero(magnitude == most[bins])
    of_bin = np.full(most.size, -1)
    of_bin[bins[moves_most]] = moves_most  # of several the last
    samples = of_bin[of_bin >= 0]
    return np.column_stack([distance[samples], magnitude[samples]])
