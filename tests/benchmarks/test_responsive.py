"""Frames of an orbit in the editor, by real mouse events, while everything that takes time is done beside them."""

import time

import numpy as np
import pytest

from qovr_core import edits
from qovr_core.files.formats import export
from qovr_core.files.options import DEFAULTS
from qovr_core.presets import preset

from .peers import finish

pytest.importorskip("PySide6")

SIZE = (1280, 720)
FRAMES = 500
SAMPLES = {"orbit.csv": (401, 401), "orbit.xlsx": (301, 301)}


class Orbit:
    """The editor's window, whose view is turned by the mouse."""

    def __init__(self, application, window):
        from PySide6.QtCore import QPoint, Qt
        from PySide6.QtTest import QTest

        self.application, self.window, self.painted = application, window, 0
        window.resize(*SIZE)
        window.show()
        QTest.qWaitForWindowExposed(window)
        self.view = window.view
        self.view.frame_painted.connect(self._count)
        self.viewport = self.view.viewports[0]
        self.corner = QPoint(self.viewport.width() // 2, 8)  # above the surface, where there is no point to drag
        QTest.mousePress(self.viewport, Qt.MouseButton.LeftButton, pos=self.corner)

    def _count(self):
        self.painted += 1

    def frame(self, k):
        """Return the milliseconds from a move of the mouse to its finished frame."""
        from PySide6.QtCore import QPoint
        from PySide6.QtTest import QTest

        start, before = time.perf_counter(), self.painted
        QTest.mouseMove(self.viewport, self.corner + QPoint(1 + k % 97, k % 5))
        while self.painted == before:
            self.application.processEvents()
        finish(self.viewport)
        return 1e3 * (time.perf_counter() - start)

    def frames_until(self, is_over, at_least=1):
        """Return the milliseconds of every frame until something is true."""
        taken = []
        while len(taken) < at_least or not is_over():
            taken.append(self.frame(len(taken)))
        return taken


@pytest.fixture
def orbit(app, tmp_path, monkeypatch):
    from qovr_app.window.main_window import MainWindow

    monkeypatch.chdir(tmp_path)
    window = MainWindow()
    made = Orbit(app, window)
    if not made.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    yield made
    window.close()
    window.deleteLater()


def show(orbit, name):
    """Open a panel, loading what it needs, and return whether it is current, as a function."""
    from PySide6.QtGui import QAction
    from PySide6.QtWidgets import QWidget

    orbit.window.findChild(QAction, f"laboratory_{name}").trigger()
    orbit.frames_until(lambda: orbit.window.findChild(QWidget, f"laboratory.{name}"), at_least=3)
    panel = orbit.window.findChild(QWidget, f"laboratory.{name}")
    return lambda: panel.is_current


def run_export(orbit, path, samples):
    """Begin an export and return whether it has ended, as a function."""
    done = []
    document = edits.set_samples(preset("fig5").document, samples)
    told = {"on_done": done.append, "on_failed": done.append}
    orbit.window.worker.run(export, document, path, DEFAULTS, **told, target=path)
    return lambda: done


def test_frames_beside_what_takes_time(orbit, record, tmp_path):
    alone = orbit.frames_until(lambda: True, FRAMES)
    parts = [orbit.frames_until(show(orbit, name)) for name in ("claims", "comparison")]
    for name, samples in SAMPLES.items():
        parts.append(orbit.frames_until(run_export(orbit, tmp_path / name, samples)))
    beside = np.concatenate(parts)
    while len(beside) < FRAMES:
        beside = np.append(beside, orbit.frames_until(run_export(orbit, tmp_path / "again.csv", SAMPLES["orbit.csv"])))
    for name in SAMPLES:
        assert (tmp_path / name).is_file()
    record("frames alone", [np.median(alone)])
    record("frames beside", [np.percentile(beside, 99)])
    record("frames longest", [np.max(beside)])
