"""Values are written into an array of the caller, as by NumPy: the same values, and no other memory."""

import tracemalloc

import numpy as np
import pytest

from qovr_core import Formulation, build_patch
from qovr_core.geometry import locate
from support.documents import random_document
from support.nets import random_net_document

ONE = build_patch(random_document(1, Formulation.DOUBLE_SUM))
NET = build_patch(random_net_document(2, (2, 3), flatness=0.3))
PATCHES = {"one window": ONE, "net": NET}
LIMIT = 64 * 1024
"""Bytes that a frame of a drag may take."""


def scattered(patch, count):
    """Return parameters in no order, so that windows come and go."""
    (_, u), (_, v) = patch.domain
    rng = np.random.default_rng(3)
    return rng.uniform(0, u, count), rng.uniform(0, v, count)


CALLS = {
    "points": lambda patch, out: patch.points(*scattered(patch, 40), out=out),
    "points in order": lambda patch, out: patch.points(*map(np.sort, scattered(patch, 40)), out=out),
    "samples": lambda patch, out: patch.samples(*intervals(patch, 7), out=out),
    "derivative": lambda patch, out: patch.derivative(*scattered(patch, 40), 1, 2, out=out),
    "derivative at places": lambda patch, out: patch.derivative_at(*scattered(patch, 40), 2, 1, out=out),
    "normals": lambda patch, out: patch.normals(*scattered(patch, 400), out=out),
}


def intervals(patch, count):
    m, n = patch.windows
    return np.full(n, count), np.full(m, count + 1)


@pytest.mark.parametrize("patch", PATCHES.values(), ids=PATCHES)
@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_the_given_array_holds_the_same_values(call, patch):
    expected = call(patch, None)
    assert not expected.flags.writeable
    for dtype in (np.float64, np.float32):
        out = np.full(expected.shape, np.nan, dtype=dtype)
        assert call(patch, out) is out
        assert out.flags.writeable
        assert np.array_equal(out, expected.astype(dtype))


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_a_part_of_a_larger_array_is_written_alone(call):
    expected = call(NET, None)
    for dtype in (np.float64, np.float32):
        vertices = np.full((*expected.shape[:-1], 6), 7, dtype=dtype)
        call(NET, vertices[..., :3])
        assert np.array_equal(vertices[..., :3], expected.astype(dtype))
        assert (vertices[..., 3:] == 7).all()


REFUSED = {
    "another shape": (np.empty((5, 4, 3)), ValueError, r"^out has shape \(5, 4, 3\); expected \(4, 5, 3\)$"),
    "integers": (np.empty((4, 5, 3), dtype=int), TypeError, "^out has dtype int64; expected float64 or float32$"),
    "half precision": (np.empty((4, 5, 3), dtype=np.float16), TypeError, "^out has dtype float16; expected float64 or"),
    "columns first": (np.empty((4, 5, 3), order="F"), ValueError, "^out has strides .*; expected C order, in which"),
    "turned": (np.empty((5, 4, 3)).transpose(1, 0, 2), ValueError, "^out has strides .*; expected C order"),
    "backwards": (np.empty((4, 5, 3))[::-1], ValueError, "^out has strides .*; expected C order"),
    "one row for all": (
        np.lib.stride_tricks.as_strided(np.empty((5, 3)), (4, 5, 3), (0, 24, 8)),
        ValueError,
        "C order",
    ),
    "read-only": (
        np.broadcast_to(np.empty(3), (4, 5, 3)),
        ValueError,
        "^out is read-only; expected an array that can be",
    ),
    "a list": ([0.0], TypeError, "^out is of type list; expected an array of float64 or float32$"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_cannot_be_written_to_is_refused(name):
    out, error, text = REFUSED[name]
    u, v = np.linspace(0, 1, 4), np.linspace(0, 1, 5)
    for call in (ONE.points, ONE.normals):
        with pytest.raises(error, match=text):
            call(u, v, out=out)


@pytest.mark.parametrize("dtype", [np.float64, np.float32])
@pytest.mark.parametrize("shape", [(101, 101), (101, 4096), (4096, 101)], ids=str)
def test_no_memory_is_taken_that_grows_with_the_grid(shape, dtype):
    along_u, along_v = (np.array([count - 1]) for count in shape)
    at_u, at_v = locate.even(along_u, from_both_sides=True), locate.even(along_v, from_both_sides=True)
    out = np.empty((*shape, 3), dtype=dtype)

    def evaluate():
        ONE.samples(along_u, along_v, out=out)
        ONE.points(at_u, at_v, out=out)
        ONE.derivative(at_u, at_v, 1, 0, out=out)

    evaluate()
    tracemalloc.start()
    try:
        evaluate()
        peak = tracemalloc.get_traced_memory()[1]
    finally:
        tracemalloc.stop()
    assert peak < LIMIT
