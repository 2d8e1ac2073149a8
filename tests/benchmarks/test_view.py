"""The view against pyqtgraph's own surface item, against merely orbiting, and against an empty view's start."""

import gc
import os
import subprocess
import sys
import time
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from qovr_core import configure, edits
from qovr_core.presets import preset

pytest.importorskip("PySide6")

SIZE = (800, 600)
SIZES = (101, 401, 1001)
GOALS = {101: 4, 401: 40, 1001: 200}
STOCK_EDITS = {101: 15, 401: 5, 1001: 2}
EDITS = 60
MANY_EDITS = 20_000
GROWTH_FROM = 2_500
"""Edits after which the history is full, and gives its oldest step up at every new one."""

OPENINGS = 200


class Bench:
    """The window's frame with the view in it, alone and of its own size, with the store that feeds it."""

    def __init__(self, application):
        from PySide6.QtCore import QTimer

        from qovr_app.state.display import DisplaySettings
        from qovr_app.state.editor_state import DocumentFile, first_state
        from qovr_app.state.intents import Configured
        from qovr_app.store import Store
        from qovr_app.window.view_frame import ViewFrame

        self.application = application
        self.turn = QTimer(singleShot=True, interval=0)
        state = first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings())
        self.store = Store(state, self.turn.start)
        self.turn.timeout.connect(self.store.flush)
        self.store.dispatch(Configured())
        self.frame_of_view = ViewFrame(self.store)
        self.store.subscribe(self.frame_of_view.show_state)
        self.view = self.frame_of_view.view
        self.painted = 0
        self.view.frame_painted.connect(self._count)
        self.frame_of_view.resize(*SIZE)
        self.frame_of_view.show()
        self.settle()

    def _count(self):
        self.painted += 1

    def settle(self, seconds=0.6):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.application.processEvents()

    def dispatch(self, kind, *facts):
        """Dispatch an intent by the name of its kind."""
        from qovr_app.state import intents, looking_intents

        found = getattr(intents, kind, None) or getattr(looking_intents, kind)
        self.store.dispatch(found(*facts))

    def edit(self, k):
        from qovr_app.state.intents import PointsMoved

        self.store.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, 0.1 * float(np.sin(k + 1))),), gesture=1))

    def step(self, k):
        """Edit as a gesture of its own, up and down by turns."""
        from qovr_app.state.intents import PointsMoved

        self.store.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, 0.001 * (-1) ** k),), gesture=2 + k))

    def orbit(self, _k):
        camera = self.view.camera
        self.view.camera_motion.move(replace(camera, azimuth=camera.azimuth + 1.0))

    def timed(self, act, count=EDITS):
        """Return the seconds from each act to its finished frame."""
        return [self.frame(act, k) for k in range(count)]

    def frame(self, act, k):
        start, before = time.perf_counter(), self.painted
        act(k)
        while self.painted == before:
            self.application.processEvents()
        finish(self.view.viewports[0])
        return time.perf_counter() - start


def finish(widget):
    """Wait until everything that was asked of OpenGL has been drawn."""
    from OpenGL.GL import glFinish

    widget.makeCurrent()
    glFinish()
    widget.doneCurrent()


@pytest.fixture(scope="module")
def bench(app):
    made = Bench(app)
    if not made.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    yield made
    made.view.close()
    made.view.deleteLater()


def stock_seconds(application, document, count):
    """Return the seconds of each edit with pyqtgraph's own item, normals and light included."""
    import pyqtgraph.opengl as gl

    class Stock(gl.GLViewWidget):
        painted = 0

        def paintGL(self):
            super().paintGL()
            self.painted += 1

    view = Stock()
    view.resize(*SIZE)
    n, _ = document.samples
    axis = np.linspace(-5, 5, n)
    heights = 10 * configure(document).transformed[..., 2]
    item = gl.GLSurfacePlotItem(x=axis, y=axis, z=heights, shader="shaded", computeNormals=True, smooth=True)
    view.addItem(item)
    view.show()
    seconds = []
    for k in range(count + 1):
        start, before = time.perf_counter(), view.painted
        edited = edits.set_point(document, 2, 2, (2.0, 2.0, 0.5 + 0.1 * np.sin(k + 1)))
        item.setData(z=10 * configure(edited).transformed[..., 2])
        while view.painted == before:
            application.processEvents()
        finish(view)
        seconds.append(time.perf_counter() - start)
    view.close()
    view.deleteLater()
    return seconds[1:]


@pytest.mark.parametrize("size", SIZES)
def test_an_edit_with_its_redraw(bench, row, size):
    bench.dispatch("SamplesChosen", (size, size))
    document = bench.store.state.document
    bench.settle()
    bench.timed(bench.edit, 5)
    ours = np.median(bench.timed(bench.edit))
    orbit = np.median(bench.timed(bench.orbit))
    stock = np.median(stock_seconds(bench.application, document, STOCK_EDITS[size]))
    at = f"{size} x {size}"
    row("stock surface item / edit with redraw", at, stock / ours, at_least=GOALS[size])
    row("orbiting / edit with redraw", at, orbit / ours, at_least=0.85 if size == 101 else None)


@pytest.fixture
def coloured(bench):
    """The bench with a pinned reference and a knot in focus; colours are those of heights again at the end."""
    from qovr_core.edits import Direction, KnotPlace

    bench.dispatch("SamplesChosen", (101, 101))
    bench.dispatch("Opened", preset("fig6c").document, "fig6c")
    bench.dispatch("ReferencePinned")
    bench.dispatch("Opened", preset("fig5").document, "fig5")
    bench.dispatch("FieldFocused", KnotPlace(Direction.ROWS, 4, "s"))
    bench.settle()
    yield bench
    colour_by(bench, "height")


def colour_by(bench, name):
    bench.dispatch("DisplayChosen", "colour_by", name)


@pytest.mark.parametrize("name", ["gaussian", "sensitivity", "zebra", "isophotes"])
def test_switching_what_colours_the_surface(coloured, row, name):
    """To a field that was not asked for before, against drawing the same picture once more."""
    plain, switched = [], []
    for k in range(20):
        colour_by(coloured, "height")
        coloured.frame(coloured.edit, k)
        coloured.settle(0.3)
        plain.append(coloured.frame(lambda _: coloured.view.viewports[0].update(), k))
        switched.append(coloured.frame(lambda _: colour_by(coloured, name), k))
    row(f"switch to {name} / plain redraw", "101 x 101", np.median(switched) / np.median(plain), at_most=2)


@pytest.mark.parametrize("name", ["gaussian", "distance", "sensitivity", "zebra", "isophotes"])
def test_an_edit_in_other_colours(coloured, row, name):
    medians = {}
    for by in ("height", name):
        colour_by(coloured, by)
        coloured.settle(0.3)
        coloured.timed(coloured.edit, 5)
        medians[by] = np.median(coloured.timed(coloured.edit))
    goal = None if name == "distance" else 1.5
    row(f"edit with {name} / with height", "101 x 101", medians[name] / medians["height"], at_most=goal)


def test_from_a_drag_event_to_its_frame(bench, row):
    """Real mouse events on a control point; milliseconds, which hold for this machine only."""
    from PySide6.QtCore import QPoint, Qt
    from PySide6.QtTest import QTest

    viewport = bench.view.viewports[0]
    picture = bench.view.picture()
    start = bench.view.camera.project(picture.scene.points[2, 2], SIZE)
    place = QPoint(round(start[0]), round(start[1]))
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=place)
    seconds = bench.timed(lambda k: QTest.mouseMove(viewport, place + QPoint(k % 40, 6 + k % 17)), 200)
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=place)
    row("drag event to finished frame, median, ms", "101 x 101", 1e3 * np.median(seconds))
    row("drag event to finished frame, 99 %, ms", "101 x 101", 1e3 * np.percentile(seconds, 99))


EMPTY_VIEW = """
import sys
from PySide6.QtWidgets import QApplication
import pyqtgraph.opengl as gl
class View(gl.GLViewWidget):
    def paintGL(self):
        super().paintGL()
        QApplication.exit(0)
app = QApplication(sys.argv)
view = View(); view.resize(1280, 800); view.show()
app.exec()
"""

EDITOR = """
import sys
sys.argv = ["qovr"]
from PySide6.QtWidgets import QApplication
from PySide6.QtCore import QTimer
from qovr_app import main as program
from qovr_app.view3d import view
make = program.create_window
def watched(*arguments):
    window = make(*arguments)
    ask = QTimer(window, interval=0)
    def listen():
        found = window.findChildren(view.View3D)
        if found:
            ask.stop()
            found[0].frame_painted.connect(lambda: QApplication.exit(0))
    ask.timeout.connect(listen)
    ask.start()
    return window
program.create_window = watched
program.main()
"""


def test_cold_start(row, app):
    seconds = {"editor": [], "empty": []}
    for _ in range(7):
        for name, code in (("empty", EMPTY_VIEW), ("editor", EDITOR)):
            start = time.perf_counter()
            subprocess.run([sys.executable, "-c", code], check=True)
            seconds[name].append(time.perf_counter() - start)
    ratio = np.median(seconds["editor"]) / np.median(seconds["empty"])
    row("start of qovr / start of an empty GLViewWidget", "", ratio, at_most=1.35)


def resident_megabytes():
    with Path("/proc/self/statm").open(encoding="ascii") as file:
        return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 1e6


def test_memory_over_many_edits_and_openings(bench, row):
    from OpenGL.GL import GL_NO_ERROR, glGetError

    for k in range(GROWTH_FROM):
        bench.frame(bench.step, k)
    gc.collect()
    before, references = resident_megabytes(), sys.getrefcount(None)
    for k in range(GROWTH_FROM, GROWTH_FROM + MANY_EDITS):
        bench.frame(bench.step, k)
    for k in range(OPENINGS):
        name = ("fig6b", "fig8")[k % 2]
        bench.frame(lambda _, name=name: bench.dispatch("Opened", preset(name).document, name), k)
    gc.collect()
    assert sys.getrefcount(None) >= references  # a reference lost at every edit would end the process in time
    viewport = bench.view.viewports[0]
    viewport.makeCurrent()
    assert glGetError() == GL_NO_ERROR
    viewport.doneCurrent()
    row("growth over 20,000 edits and 200 openings, MB", "101 x 101", resident_megabytes() - before, at_most=10)
