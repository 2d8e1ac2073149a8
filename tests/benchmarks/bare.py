"""The least that draws a mesh: a widget that uploads vertices that are ready, and draws them with our shader."""

import time

import numpy as np
from OpenGL.GL import glFinish
from PySide6.QtCore import Signal
from PySide6.QtOpenGLWidgets import QOpenGLWidget

from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.program import link_program
from qovr_app.view3d.gl.support import gl_support, viewport_format
from qovr_app.view3d.gl.surface_buffers import ATTRIBUTES
from qovr_app.view3d.gl.surface_item import defines_of, set_uniforms
from qovr_app.view3d.scene.mesh import sample_places, triangle_indices


class BareWidget(QOpenGLWidget):
    """Shows the document's samples of a picture, coloured by height, and nothing else.

    Parameters
    ----------
    places : arrays (n, m, 3) float32 of which one after the other is uploaded, as if a point was moved
    """

    painted = Signal()

    def __init__(self, picture, places):
        super().__init__()
        self.setFormat(viewport_format(gl_support()))
        self.picture, self.places, self.number = picture, places, 0
        self.frameSwapped.connect(self.painted)

    def initializeGL(self):
        self.array, self.vertices, self.indices = api.make_vertex_array(), api.make_buffer(), api.make_buffer()
        self.colours = api.make_texture(api.Filtering.LINEAR)
        self.program = link_program("surface", defines=sorted(defines_of(self.picture)), attributes=ATTRIBUTES)
        api.bind_vertex_array(self.array)
        api.load_attributes(self.vertices, self.places[0], (3,), location=0, is_resized=True)
        triangles = triangle_indices(self.picture.grid)
        self.count = triangles.size
        api.load_indices(self.indices, triangles)
        api.load_colours(self.colours, self.picture.colouring.table)

    def paintGL(self):
        api.clear(1.0, 1.0, 1.0, 1.0)
        api.bind_vertex_array(self.array)
        api.load_attributes(self.vertices, self.places[self.number], (3,), location=0, is_resized=False)
        self.program.bind()
        api.bind_textures([self.colours])
        size = float(self.width()), float(self.height())
        set_uniforms(self.program, self.picture, self.picture.camera.matrix(size), self.devicePixelRatioF())
        api.draw_in_depth()
        api.draw_triangles(self.count)


class Bare:
    """The widget beside a bench that draws the document's samples."""

    def __init__(self, bench, size):
        picture, places = bench.view.picture(), []
        for k in range(2):
            bench.frame(bench.edit, k)
            places.append(np.empty((*picture.grid.shape, 3), dtype=np.float32))
            sample_places(bench.view.picture().scene.patch, picture.grid, places[-1])
        self.application, self.painted, self.widget = bench.application, 0, BareWidget(picture, places)
        self.widget.painted.connect(self._count)
        self.widget.resize(*size)
        self.widget.show()

    def _count(self):
        self.painted += 1

    def edit(self, k):
        """Upload other vertices, wait for the finished frame, and return the seconds."""
        start, before, self.widget.number = time.perf_counter(), self.painted, k % 2
        self.widget.update()
        while self.painted == before:
            self.application.processEvents()
        self.widget.makeCurrent()
        glFinish()
        self.widget.doneCurrent()
        return time.perf_counter() - start

    def close(self):
        self.widget.close()
        self.widget.deleteLater()
