"""What stays in memory after many edits and openings."""

import ctypes
import gc
import os
import sys
from pathlib import Path

import pytest

from qovr_core.presets import preset

pytest.importorskip("PySide6")

from .test_view import bench  # noqa: F401 - a fixture

MANY_EDITS = 20_000
GROWTH_FROM = 2_500
"""Edits after which the history is full, and gives its oldest step up at every new one."""

OPENINGS = 200

MALLINFO2 = ("arena", "ordblks", "smblks", "hblks", "hblkhd", "usmblks", "fsmblks", "uordblks", "fordblks", "keepcost")
"""The fields of glibc's mallinfo2, each a size_t."""


def resident_megabytes():
    with Path("/proc/self/statm").open(encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def megabytes_in_use():
    """Return what the allocator of C has given out and not got back, in and out of its heap."""

    class Mallinfo2(ctypes.Structure):
        _fields_ = [(name, ctypes.c_size_t) for name in MALLINFO2]

    call = ctypes.CDLL(None).mallinfo2
    call.restype = Mallinfo2
    found = call()
    return (found.uordblks + found.hblkhd) / 1e6


@pytest.mark.long
def test_memory_over_many_edits_and_openings(bench, record):  # noqa: F811
    from OpenGL.GL import GL_NO_ERROR, glGetError

    for k in range(GROWTH_FROM):
        bench.frame(bench.step, k)
    gc.collect()
    resident, used, references = resident_megabytes(), megabytes_in_use(), sys.getrefcount(None)
    for k in range(GROWTH_FROM, GROWTH_FROM + MANY_EDITS):
        bench.frame(bench.step, k)
    gc.collect()
    record("growth resident", [resident_megabytes() - resident])
    record("growth in use", [megabytes_in_use() - used])
    for k in range(OPENINGS):
        name = ("fig6b", "fig8")[k % 2]
        bench.frame(lambda _, name=name: bench.dispatch("Opened", preset(name).document, name), k)
    gc.collect()
    assert sys.getrefcount(None) >= references  # a reference lost at every edit would end the process in time
    viewport = bench.view.viewports[0]
    viewport.makeCurrent()
    assert glGetError() == GL_NO_ERROR
    viewport.doneCurrent()
    record("growth openings", [resident_megabytes() - resident])
