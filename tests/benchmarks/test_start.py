"""How long programs take from their call to what they were called for, beside ones that do as little as can be."""

import subprocess
import sys

import pytest

pytest.importorskip("PySide6")

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


def program(code):
    """Return a call that runs a program from its start to its end."""
    return lambda: subprocess.run([sys.executable, "-c", code], check=True)


def test_the_editor(measure, app):
    measure("start", program(EDITOR), program(EMPTY_VIEW), rounds=5)
