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
from support.view import change, choose

pytest.importorskip("PySide6")

SIZE = (800, 600)
SIZES = (101, 401, 1001)
GOALS = {101: 4, 401: 40, 1001: 200}
STOCK_EDITS = {101: 15, 401: 5, 1001: 2}
EDITS = 60
MANY_EDITS = 20_000
GROWTH_FROM = 1_000
OPENINGS = 200


class Bench:
    """A view of its own size with the session and the controller that feed it."""

    def __init__(self, application):
        from qovr_app.view3d.view import View3D
        from qovr_app.window.controller import Controller
        from qovr_app.window.session import Session

        self.application = application
        self.session = Session()
        self.controller = Controller(self.session)
        self.view = View3D()
        self.painted = 0
        self.view.frame_painted.connect(self._count)
        self.controller.evaluation_changed.connect(self.show)
        self.view.resize(*SIZE)
        self.view.show()
        self.controller.configure()
        self.settle()

    def show(self, evaluation, document):
        change(self.view, evaluation=evaluation, document=document)

    def _count(self):
        self.painted += 1

    def settle(self, seconds=0.6):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.application.processEvents()

    def edit(self, k):
        self.controller.drag_point(2, 2, np.array([2.0, 2.0, 0.5 + 0.1 * np.sin(k + 1)]), gesture=1)

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
    document = edits.set_samples(bench.session.document, (size, size))
    bench.session.apply("Set samples", document)
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
    from qovr_core.presets import preset

    bench.session.apply("Set samples", edits.set_samples(bench.session.document, (101, 101)))
    reference = configure(preset("fig6c").document).transformed_patch
    change(bench.view, reference=reference, reference_name="fig6c", knot=KnotPlace(Direction.ROWS, 4, "s"))
    bench.settle()
    yield bench
    colour_by(bench, "height")


def colour_by(bench, name):
    choose(bench.view, colour_by=name)


@pytest.mark.parametrize("name", ["gaussian", "sensitivity", "zebra", "isophotes"])
def test_switching_what_colours_the_surface(coloured, row, name):
    """To a field that was not asked for before, against drawing the same picture once more."""
    plain, switched = [], []
    for k in range(20):
        colour_by(coloured, "height")
        coloured.frame(coloured.edit, k)
        coloured.settle(0.3)
        plain.append(coloured.frame(lambda _: coloured.view._show(), k))
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

    bench.view.point_dragged.connect(bench.controller.drag_point)
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
from qovr_app.window import main_window
came = main_window.MainWindow._on_view_came
def watch(window, view):
    came(window, view)
    view.frame_painted.connect(lambda: QApplication.exit(0))
main_window.MainWindow._on_view_came = watch
from qovr_app.main import main
main()
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
        bench.frame(bench.edit, k)
    gc.collect()
    before, references = resident_megabytes(), sys.getrefcount(None)
    for k in range(GROWTH_FROM, MANY_EDITS):
        bench.frame(bench.edit, k)
    for k in range(OPENINGS):
        bench.frame(lambda k: bench.session.open(f"paper:{('fig6b', 'fig8')[k % 2]}"), k)
    gc.collect()
    assert sys.getrefcount(None) >= references  # a reference lost at every edit would end the process in time
    viewport = bench.view.viewports[0]
    viewport.makeCurrent()
    assert glGetError() == GL_NO_ERROR
    viewport.doneCurrent()
    row("growth over 20,000 edits and 200 openings, MB", "101 x 101", resident_megabytes() - before, at_most=10)
