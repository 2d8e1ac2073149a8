"""The view against pyqtgraph's own surface item, and against merely orbiting."""

import itertools
import time
from dataclasses import replace

import numpy as np
import pytest

from qovr_core.presets import preset

pytest.importorskip("PySide6")

from .peers import SIZE, Empty, PyVista, Stock, finish, regular_document
from .timing import RUNS

STOCK_EVERY = {101: 1, 401: 5, 1001: 15}
EDITS = 20


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

    def milliseconds(self, act, count=EDITS):
        """Return the median milliseconds from an act to its finished frame."""
        return 1e3 * float(np.median(self.timed(act, count)))

    def frame(self, act, k):
        start, before = time.perf_counter(), self.painted
        act(k)
        while self.painted == before:
            self.application.processEvents()
        finish(self.view.viewports[0])
        return time.perf_counter() - start


@pytest.fixture(scope="module")
def bench(app):
    made = Bench(app)
    if not made.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    yield made
    made.view.close()
    made.view.deleteLater()


def counting(act):
    """Return a call that counts how often it was called, for acts that are to differ each time."""
    count = itertools.count()
    return lambda: act(next(count))


def edited(bench):
    """Return a call that edits a point and waits for the finished frame."""
    return counting(lambda k: bench.frame(bench.edit, k))


def test_a_moving_frame_beside_an_empty_widget(bench, measure):
    empty = Empty(bench.application)
    bench.settle()
    measure("frame", counting(lambda k: bench.frame(bench.orbit, k)), empty.draw, rounds=3 * EDITS)
    empty.close()


@pytest.mark.parametrize("size", STOCK_EVERY)
def test_an_edit_with_its_redraw(bench, record, measure, size):
    bench.dispatch("SamplesChosen", (size, size))
    bench.settle()
    bench.timed(bench.edit, 5)
    runs = [[bench.milliseconds(act, 3 * EDITS) for act in (bench.edit, bench.orbit)] for _ in range(RUNS)]
    record(f"edit/orbit {size}", *np.transpose(runs))
    stock = Stock(bench.application, regular_document(size), shader="shaded", computeNormals=True)
    measure(f"stock {size}", edited(bench), counting(stock.edit), every=STOCK_EVERY[size])
    stock.close()


def test_an_edit_with_its_redraw_beside_pyvista(bench, measure):
    bench.dispatch("SamplesChosen", (1001, 1001))
    bench.settle()
    other = PyVista(1001)
    measure("pyvista 1001", edited(bench), other.edit, every=3)
    other.close()


@pytest.fixture
def samples_drawn(bench):
    """A function that has so many samples a side drawn; no picture at rest is drawn while a peer is timed."""

    def draw(size):
        bench.dispatch("SamplesChosen", (size, size))
        bench.dispatch("DisplayChosen", "document_samples", True)
        bench.settle()
        bench.timed(bench.edit, 3)

    pause = bench.view._refinement._pause
    usual = pause.interval()
    pause.setInterval(10**6)
    yield draw
    pause.setInterval(usual)
    bench.dispatch("DisplayChosen", "document_samples", False)
    bench.settle()


def test_an_edit_of_all_samples_beside_a_bare_widget(bench, samples_drawn, measure):
    """Vertices that are ready, in a buffer as ours by the same triangles, shader and antialiasing."""
    from .bare import Bare

    samples_drawn(1001)
    bare = Bare(bench, SIZE)
    measure("bare mesh 1001", edited(bench), counting(bare.edit))
    bare.close()


@pytest.mark.parametrize("size", STOCK_EVERY)
def test_an_edit_of_all_samples_beside_the_stock_item(bench, samples_drawn, measure, size):
    samples_drawn(size)
    stock = Stock(bench.application, regular_document(size))
    measure(f"stock mesh {size}", edited(bench), counting(stock.edit), every=STOCK_EVERY[size])
    stock.close()


@pytest.mark.parametrize("size", [101, 1001])
def test_an_edit_of_all_samples_beside_pyvista(bench, samples_drawn, measure, size):
    other = PyVista(size)
    samples_drawn(size)
    measure(f"pyvista mesh {size}", edited(bench), other.edit, every=3)
    other.close()


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


def switch_seconds(bench, name, k):
    """Return the seconds of drawing the same picture once more, and of switching to a field not asked for before."""
    colour_by(bench, "height")
    bench.frame(bench.edit, k)
    bench.settle(0.3)
    plain = bench.frame(lambda _: bench.view.viewports[0].update(), k)
    return bench.frame(lambda _: colour_by(bench, name), k), plain


@pytest.mark.parametrize("name", ["gaussian", "sensitivity", "zebra", "isophotes"])
def test_switching_what_colours_the_surface(coloured, record, name):
    runs = [np.median([switch_seconds(coloured, name, 9 * run + k) for k in range(9)], axis=0) for run in range(RUNS)]
    record(f"switch {name}", *(1e3 * np.transpose(runs)))


@pytest.mark.parametrize("name", ["gaussian", "distance", "sensitivity", "zebra", "isophotes"])
def test_an_edit_in_other_colours(coloured, record, name):
    found = {name: [], "height": []}
    for _, by in itertools.product(range(RUNS), found):
        colour_by(coloured, by)
        coloured.settle(0.3)
        coloured.timed(coloured.edit, 5)
        found[by].append(coloured.milliseconds(coloured.edit, 2 * EDITS))
    record(f"edit {name}", *found.values())


def test_from_a_drag_event_to_its_frame(bench, record):
    """Real mouse events on a control point."""
    from PySide6.QtCore import QPoint, Qt
    from PySide6.QtTest import QTest

    viewport = bench.view.viewports[0]
    start = bench.view.camera.project(bench.view.picture().scene.points[2, 2], SIZE)
    place = QPoint(round(start[0]), round(start[1]))
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=place)
    move = lambda k: QTest.mouseMove(viewport, place + QPoint(k % 40, 6 + k % 17))  # noqa: E731
    runs = [np.percentile(bench.timed(move, 100), (50, 99)) for _ in range(RUNS)]
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=place)
    for key, seconds in zip(("drag median", "drag 99"), np.transpose(runs), strict=True):
        record(key, 1e3 * seconds)
