"""How fast the view follows an edit, against pyqtgraph's own surface in the same run; frames are waited for.

Run it by its path: ``python -m pytest tests/app/view3d/speed.py -s``. Ratios hold from machine to machine,
times do not.
"""

import gc
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEventLoop

from qovr_core import configure
from qovr_core.edits import set_point
from qovr_core.presets import preset

SIZE = (800, 600)
LEAST_OF_STOCK = {101: 4.0, 401: 40.0, 1001: 200.0}
"""How many times as fast as the stock item an edit has to be, by samples a side."""

LEAST_OF_ORBIT = 0.85
EDITS = {101: (80, 12), 401: (60, 4), 1001: (30, 2)}
LARGEST_GROWTH = 10e6


def document_after(samples, edit):
    document = replace(preset("fig5").document, samples=(samples, samples))
    x, y, z = document.control_points[2, 2]
    return set_point(document, 2, 2, (x, y, z + 0.001 * np.sin(edit)))


def frame_times(signal, act, count):
    """Return the seconds from each act until the signal that its frame is there."""
    times = []
    for k in range(count):
        loop = QEventLoop()
        signal.connect(loop.quit)
        start = time.perf_counter()
        act(k)
        loop.exec()
        times.append(time.perf_counter() - start)
        signal.disconnect(loop.quit)
    return np.array(times)


def stock_edits(samples, count):
    """Return the frame times of the same edits with ``GLSurfacePlotItem`` and its normals."""
    from pyqtgraph.opengl import GLSurfacePlotItem, GLViewWidget

    widget, result = GLViewWidget(), configure(document_after(samples, 0))
    widget.resize(*SIZE)
    item = GLSurfacePlotItem(x=result.u, y=result.v, z=result.transformed[..., 2], shader="shaded")
    widget.addItem(item)
    widget.setCameraPosition(distance=2)
    widget.show()
    frame_times(widget.frameSwapped, lambda _: widget.update(), 2)

    def edit(k):
        item.setData(z=configure(document_after(samples, k + 1)).transformed[..., 2])
        widget.update()

    times = frame_times(widget.frameSwapped, edit, count)
    widget.close()
    widget.deleteLater()
    return times


@pytest.mark.parametrize("samples", list(LEAST_OF_STOCK))
def test_an_edit_against_the_stock_item(make_view, samples):
    ours, stock = EDITS[samples]
    view = make_view(document_after(samples, 0), size=SIZE).view

    def edit(k):
        view.set_result(configure(document_after(samples, k + 1)))

    def orbit(k):
        view._on_camera_requested(view.camera.orbited(1.0, 0.0))

    frame_times(view.frame_painted, edit, 5)
    edits, orbits = (frame_times(view.frame_painted, act, ours) for act in (edit, orbit))
    others = stock_edits(samples, stock)
    median = float(np.median(edits))
    of_stock, of_orbit = float(np.median(others)) / median, float(np.median(orbits)) / median
    print(
        f"\n{samples} x {samples}: an edit {1000 * median:.1f} ms "
        f"(99 % {1000 * np.percentile(edits, 99):.1f}), {of_stock:.1f} x stock, {of_orbit:.2f} x orbiting"
    )
    assert of_stock >= LEAST_OF_STOCK[samples]
    if samples == 101:
        assert of_orbit >= LEAST_OF_ORBIT


def test_twenty_thousand_edits_keep_nothing(make_view):
    if not sys.platform.startswith("linux"):
        pytest.skip("memory is read from /proc")

    def resident():
        gc.collect()
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096

    view = make_view(document_after(101, 0), size=SIZE).view
    for start, stop in ((0, 1000), (1000, 20_000)):
        before = resident()
        frame_times(
            view.frame_painted, lambda k: view.set_result(configure(document_after(101, k))), stop - start
        )
    print(f"\n20,000 edits: {(resident() - before) / 1e6:+.1f} MB after the first 1,000")
    assert resident() - before < LARGEST_GROWTH
