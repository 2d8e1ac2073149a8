"""What the window beside the view costs while a point is dragged, beside orbiting in the same window."""

import time
from dataclasses import replace

import numpy as np
import pytest

from .peers import finish
from .timing import RUNS

pytest.importorskip("PySide6")

SIZE = (1280, 800)
EDITS = 200
PANELS = ("curve", "influence", "comparison", "section", "claims")


class Window:
    """The editor's window, in which a point is dragged or the view turned, a frame each time."""

    def __init__(self, application, window):
        self.application, self.window, self.store, self.painted = application, window, window.store, 0
        window.resize(*SIZE)
        window.show()
        self.view = window.view
        self.view.frame_painted.connect(self._count)
        self.gesture = 1000
        self.wait(1.0)

    def _count(self):
        self.painted += 1

    def wait(self, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            self.application.processEvents()

    def frame(self, act, k):
        before = self.painted
        act(k)
        while self.painted == before:
            self.application.processEvents()
        finish(self.view.viewports[0])

    def edit(self, k):
        from qovr_app.state.intents import PointsMoved

        moved = ((0.0, 0.0, 0.1 * float(np.sin(k + 1))),)
        self.store.dispatch(PointsMoved(((2, 2),), moved, gesture=self.gesture))

    def orbit(self, _k):
        camera = self.view.camera
        self.view.camera_motion.move(replace(camera, azimuth=camera.azimuth + 1.0))

    def taken(self, act, count):
        """Return the milliseconds of so many frames, on the clock and of this thread; the drag's end included."""
        from qovr_app.state.intents import GestureEnded

        self.gesture += 1
        start, used = time.perf_counter(), time.thread_time()
        for k in range(count):
            self.frame(act, k)
        self.store.dispatch(GestureEnded(self.gesture))
        self.application.processEvents()
        return 1e3 * np.array([time.perf_counter() - start, time.thread_time() - used])

    def show(self, panel):
        from qovr_app.state.looking_intents import PanelShown, ZonesShown

        self.store.dispatch(ZonesShown(bool(panel)))
        self.store.dispatch(PanelShown(panel))
        self.wait(0.5)
        self.taken(self.edit, 5)
        self.taken(self.orbit, 5)


@pytest.fixture
def behind(monkeypatch):
    """A list of how many milliseconds each state waited until the panel was told it or a later one."""
    from qovr_app.laboratory.panel import LaboratoryPanel
    from qovr_app.widgets.seen_part import SeenPart

    waited, since = [], {}
    show_state, tell = SeenPart.show_state, SeenPart.tell

    def on_state(part, before, after):
        if before is not None and isinstance(part.parent(), LaboratoryPanel) and part.parent().isVisible():
            since.setdefault(part, time.perf_counter())
        show_state(part, before, after)

    def on_tell(part):
        tell(part)
        if part in since:
            waited.append(1e3 * (time.perf_counter() - since.pop(part)))

    monkeypatch.setattr(SeenPart, "show_state", on_state)
    monkeypatch.setattr(SeenPart, "tell", on_tell)
    return waited


@pytest.fixture
def shown(app, behind, tmp_path, monkeypatch):
    from qovr_app.state.looking_intents import Selected
    from qovr_app.window.main_window import MainWindow

    monkeypatch.chdir(tmp_path)
    window = MainWindow()
    made = Window(app, window)
    if not made.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    made.store.dispatch(Selected((2, 2)))
    yield made
    window.leave()
    window.deleteLater()


def test_edits_beside_steps_of_an_orbit(shown, behind, record):
    """All panels are open one after the other, for a part of the edits each."""
    found, late = {"hidden": [], "open": []}, [0.0]
    for _ in range(RUNS):
        for name, panels in (("hidden", ("",)), ("open", PANELS)):
            edits, steps = np.zeros(2), np.zeros(2)
            for panel in panels:
                shown.show(panel)
                behind.clear()
                edits += shown.taken(shown.edit, EDITS // len(panels))
                late += behind
                steps += shown.taken(shown.orbit, EDITS // len(panels))
            found[name].append((edits, steps))
    for name, runs in found.items():
        for number, what in enumerate(("wall", "CPU")):
            record(f"panels {name} {what}", *([run[which][number] for run in runs] for which in (0, 1)))
    record("panels behind", [max(late)])
