"""From a drag event to its finished frame, in this program against another edition of it, in turn in one run.

    cd tests && xvfb-run -a .venv/bin/python -m benchmarks.drag_ratio ROOT_OF_THE_OTHER

Every run is a process of its own with the window of that edition; what is compared is pairs of runs one after the
other, so that a machine that others use slows both. Seconds on the clock, and of the processor.
"""

import json
import os
import subprocess
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parents[2]
PAIRS = 8
EVENTS = 120

RUN = """
import json, sys, time
import numpy as np
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from qovr_app.window.application import make_application
application = make_application(["drag"])
from qovr_app.window.main_window import MainWindow
from OpenGL.GL import glFinish
window = MainWindow("paper:fig5")
window.resize(1440, 900)
window.show()
QTest.qWait(900)
view = window.view
painted = [0]
view.frame_painted.connect(lambda: painted.__setitem__(0, painted[0] + 1))
viewport = view.viewports[0]
place = viewport.mapFromGlobal(window.screen_position(2, 2))
QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=place)
clock, processor = [], []
for k in range(EVENTS + 20):
    before, start, used = painted[0], time.perf_counter(), time.process_time()
    QTest.mouseMove(viewport, place + QPoint(k % 3, -6 - k % 29))
    while painted[0] == before:
        application.processEvents()
    viewport.makeCurrent(); glFinish(); viewport.doneCurrent()
    if k >= 20:
        clock.append(time.perf_counter() - start)
        processor.append(time.process_time() - used)
print(json.dumps([float(np.median(clock)), float(np.median(processor))]))
import os
os._exit(0)
"""


def run(root):
    """Return the medians of one run of the edition that lies at a root: seconds on the clock, and of the processor."""
    code = f"EVENTS = {EVENTS}\n{RUN}"
    environment = {**os.environ, "PYTHONPATH": str(root), "XDG_CONFIG_HOME": "/nonexistent"}
    call = [sys.executable, "-c", code]
    done = subprocess.run(call, capture_output=True, text=True, env=environment, cwd=root, check=True)
    return json.loads(done.stdout.strip().splitlines()[-1])


def main(other):
    pairs = []
    for k in range(PAIRS):
        order = (HERE, Path(other)) if k % 2 else (Path(other), HERE)
        found = dict(zip(order, map(run, order), strict=True))
        pairs.append([found[HERE], found[Path(other)]])
        print(*(f"{1e3 * value:7.2f}" for edition in pairs[-1] for value in edition), flush=True)
    ours, theirs = np.array(pairs).transpose(1, 0, 2)
    for name, ratio in zip(("clock", "processor"), (ours / theirs).T, strict=True):
        print(f"{name}: median of {PAIRS} ratios {np.median(ratio):.3f}, from {ratio.min():.3f} to {ratio.max():.3f}")


if __name__ == "__main__":
    main(*sys.argv[1:])
