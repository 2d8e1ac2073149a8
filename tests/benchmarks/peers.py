"""Other programs' views of a document's samples, in which a point of the net is moved as in ours."""

import contextlib
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

from qovr_core import Document, edits
from qovr_core.evaluation import Evaluation
from qovr_core.presets import preset

SIZE = (800, 600)


def regular_document(size):
    """Return a document whose samples lie over a regular grid of x and y: all that a plot of heights can show."""
    net = preset("fig5").document.control_points
    return Document(net, formulation="interpolating", samples=(size, size))


def moved_samples(document, k):
    """Return the samples after the k-th move of a point, (n, m, 3)."""
    return Evaluation(edits.set_point(document, 2, 2, (2.0, 2.0, 0.5 + 0.1 * float(np.sin(k + 1))))).raw


def finish(widget):
    """Wait until everything that was asked of OpenGL has been drawn."""
    from OpenGL.GL import glFinish

    widget.makeCurrent()
    glFinish()
    widget.doneCurrent()


class Empty:
    """An empty widget of OpenGL's that is drawn again."""

    def __init__(self, application):
        from PySide6.QtOpenGLWidgets import QOpenGLWidget

        self.application, self.painted, self.widget = application, 0, QOpenGLWidget()
        self.widget.frameSwapped.connect(self._count)
        self.widget.resize(*SIZE)
        self.widget.show()

    def _count(self):
        self.painted += 1

    def draw(self):
        """Wait for the finished frame."""
        before = self.painted
        self.widget.update()
        while self.painted == before:
            self.application.processEvents()
        finish(self.widget)

    def close(self):
        """Take it off the screen."""
        self.widget.close()
        self.widget.deleteLater()


class Stock:
    """A view with pyqtgraph's own surface item of all samples.

    Parameters
    ----------
    document : over a regular grid
    look : how the item is drawn; without any, as cheaply as it can: coloured by height, without normals or light
    """

    def __init__(self, application, document, **look):
        import pyqtgraph
        import pyqtgraph.opengl as gl

        class View(gl.GLViewWidget):
            painted = 0

            def paintGL(self):
                super().paintGL()
                self.painted += 1

        self.application, self.document, self.view = application, document, View()
        self.view.resize(*SIZE)
        samples = Evaluation(document).raw
        axes = {"x": samples[:, 0, 0], "y": samples[0, :, 1]}
        look = look or {"shader": "heightColor", "computeNormals": False}
        self.item = gl.GLSurfacePlotItem(**axes, z=samples[..., 2], smooth=True, **look)
        self.view.addItem(self.item)
        middle = pyqtgraph.Vector(samples.mean(axis=(0, 1)))
        self.view.setCameraPosition(pos=middle, distance=1.2 * float(axes["x"][-1]))
        self.view.show()

    def edit(self, k):
        """Move a point and wait for the finished frame."""
        before = self.view.painted
        self.item.setData(z=moved_samples(self.document, k)[..., 2])
        while self.view.painted == before:
            self.application.processEvents()
        finish(self.view)

    def close(self):
        self.view.close()
        self.view.deleteLater()


class PyVista:
    """PyVista in a process of its own, which draws all samples.

    Parameters
    ----------
    size : samples each way
    antialiasing : ``none``, as our viewports have it where no graphics card draws, or ``default`` for what is unasked
    """

    def __init__(self, size, antialiasing="none"):
        pytest.importorskip("pyvista", reason="PyVista is not installed: .venv/bin/pip install --group peers")
        call = [sys.executable, "-m", "benchmarks.pyvista_peer", str(size), antialiasing]
        tests = Path(__file__).parents[1]
        self.process = subprocess.Popen(call, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, cwd=tests)
        self.edit()

    def edit(self):
        """Move a point and wait for the finished frame."""
        try:
            self.process.stdin.write("\n")
            self.process.stdin.flush()
        except BrokenPipeError:
            pass
        if not self.process.stdout.readline():
            self.close()
            pytest.skip(f"PyVista draws nothing here: it ended with {self.process.returncode}")

    def close(self):
        with contextlib.suppress(BrokenPipeError):
            self.process.stdin.close()
        self.process.wait()
        self.process.stdout.close()
