"""Marks as OpenGL draws them: all that lie over one another in one call, their texts from one texture."""

from __future__ import annotations

import itertools
from collections.abc import Hashable, Iterable, Iterator
from dataclasses import dataclass
from functools import partial
from typing import Protocol

import numpy as np
from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QImage, QMatrix3x3, QPolygonF, QTransform
from PySide6.QtOpenGL import QOpenGLShaderProgram

from qovr_app.view3d.gl import api
from qovr_app.view3d.gl.atlas import Atlas, Patch, Pixel
from qovr_app.view3d.gl.mark_rows import DEFINES, DOT, PHOTO, WIDTHS, Rows, shape_rows, sprite_rows
from qovr_app.view3d.gl.program import link_program
from qovr_app.view3d.scene.marks import Mark, Photo, Strip, Text

_ATTRIBUTES = ("a_place", "a_shape", "a_inks", "a_more")
_CORNERS = 6
"""Vertices of a shape that is not a dot: two triangles. The shader knows the corner by the vertex's number."""

_NONE = np.empty((0, sum(WIDTHS)), dtype=np.float32)

Sprite = Text | Strip


class Images(Protocol):
    """Gives what is drawn as an image; every image is in the format ARGB32 premultiplied."""

    def key(self, sprite: Sprite, ratio: float) -> Hashable:
        """Return what decides its pixels, at so many pixels of the device a logical one."""

    def image(self, sprite: Sprite, ratio: float) -> QImage:
        """Return its pixels."""

    def corner(self, sprite: Sprite, ratio: float) -> tuple[int, int]:
        """Return the device's pixel that is its upper left one."""

    def photo(self, path: str) -> QImage | None:
        """Return the picture in a file; the very same while it is the same, and None where there is none."""


@dataclass
class _Objects:
    """What a layer has made in a context: a program for each kind of shape, and what they draw from."""

    programs: dict[int, QOpenGLShaderProgram]
    array: int
    buffer: int
    photo: int


class MarkLayer:
    """Lists of marks, in few calls each. Everything but the construction needs the context to be current."""

    def __init__(self, images: Images) -> None:
        self._images, self._atlas = images, Atlas()
        self.forget()

    def forget(self) -> None:
        """Start without any GL object, as a new context does."""
        self._objects: _Objects | None = None
        self._photo: QImage | None = None
        self._lists: list[list[tuple[int, range]]] = []
        self._atlas.forget()

    def release(self) -> None:
        """Destroy every GL object."""
        self._atlas.release()
        if self._objects is not None:
            api.delete_vertex_array(self._objects.array)
            api.delete_buffers([self._objects.buffer])
            api.delete_textures([self._objects.photo])
        self.forget()

    def load(self, lists: Iterable[Iterable[Mark]], pixels: tuple[int, int], ratio: float) -> None:
        """Bring lists of marks to the driver, for a viewport of so many pixels, of which a logical one has some."""
        objects, marks = self._made(), [list(each) for each in lists]
        rows = _all_rows(marks, self._images, self._atlas, ratio)
        vertices = [_NONE]
        self._lists, count = [], 0
        for each in rows:
            self._lists.append([])
            for kind, run in _runs(each):
                vertices.append(_vertices(kind, run))
                self._lists[-1].append((kind, range(count, count + len(vertices[-1]))))
                count += len(vertices[-1])
        api.bind_vertex_array(objects.array)
        api.load_attributes(objects.buffer, np.concatenate(vertices), WIDTHS, location=0, is_resized=True)
        api.bind_vertex_array(0)
        for kind in {kind for runs in self._lists for kind, _ in runs}:
            program = objects.programs[kind]
            program.bind()
            api.set_floats(program.uniformLocation("u_pixels"), *pixels)
        for photo in (mark for each in marks for mark in each if isinstance(mark, Photo)):
            self._load_photo(objects, photo, ratio)

    def draw(self, number: int) -> None:
        """Draw one of the lists that were loaded over what is there."""
        objects = self._made()
        api.draw_over(blended=True)
        api.show_both_sides()
        api.bind_vertex_array(objects.array)
        for kind, vertices in self._lists[number]:
            objects.programs[kind].bind()
            api.bind_textures([objects.photo if kind == PHOTO else self._atlas.texture])
            (api.draw_points if kind == DOT else api.draw_corners)(vertices)
        api.bind_vertex_array(0)

    def _made(self) -> _Objects:
        if self._objects is None:
            programs = {
                kind: link_program("marks", defines=[define], attributes=_ATTRIBUTES)
                for kind, define in enumerate(DEFINES)
            }
            array, buffer, photo = api.make_vertex_array(), api.make_buffer(), api.make_texture(api.Filtering.LINEAR)
            self._objects = _Objects(programs, array, buffer, photo)
        return self._objects

    def _load_photo(self, objects: _Objects, photo: Photo, ratio: float) -> None:
        """Bring a picture to the driver, and say where in it each pixel of the viewport lies."""
        image = self._images.photo(photo.path)
        if image is None:
            return
        if image is not self._photo:
            self._photo, painted = image, image.convertToFormat(QImage.Format.Format_ARGB32_Premultiplied)
            size = image.width(), image.height()
            api.load_image(objects.photo, np.frombuffer(painted.constBits(), dtype=np.uint8), size)
        seen = QPolygonF([QPointF(x, y) for x, y in (photo.corners * ratio).tolist()])
        whole, onto = QPolygonF(QRectF(0, 0, 1, 1)), QTransform()
        whole.removeLast()  # of a rectangle, a polygon repeats the first one
        QTransform.quadToQuad(seen, whole, onto)  # seen edge on there is none, and nothing to be seen
        program = objects.programs[PHOTO]
        program.bind()
        program.setUniformValue(program.uniformLocation("u_onto"), QMatrix3x3(_numbers(onto)))


def _runs(rows: Rows) -> list[tuple[int, Rows]]:
    """Return the rows of one kind after those of another, each with the kind."""
    kinds = rows[:, 4].astype(int)
    ends = [0, *(np.flatnonzero(np.diff(kinds)) + 1).tolist(), len(kinds)]
    return [(int(kinds[a]), rows[a:b]) for a, b in itertools.pairwise(ends) if b > a]


def _vertices(kind: int, rows: Rows) -> Rows:
    """Return the vertices of rows of a kind, of which others begin at a whole number of shapes."""
    if kind == DOT:
        return np.pad(rows, ((0, -len(rows) % _CORNERS), (0, 0)))
    return np.repeat(rows, _CORNERS, axis=0)


def _numbers(onto: QTransform) -> list[float]:
    """Return a transform as the rows of a matrix that is multiplied by columns."""
    return [
        *(onto.m11(), onto.m21(), onto.m31()),
        *(onto.m12(), onto.m22(), onto.m32()),
        *(onto.m13(), onto.m23(), onto.m33()),
    ]


def _all_rows(lists: list[list[Mark]], images: Images, atlas: Atlas, ratio: float) -> list[Rows]:
    """Return the rows of each of several lists of marks."""
    sprites = [mark for marks in lists for mark in marks if isinstance(mark, Text | Strip)]
    keys = [images.key(sprite, ratio) for sprite in sprites]
    found = atlas.places({key: partial(images.image, each, ratio) for key, each in zip(keys, sprites, strict=True)})
    drawn = iter(_of_sprites(sprites, [images.corner(each, ratio) for each in sprites], [found[key] for key in keys]))
    return [np.concatenate([_NONE, *_in_order(marks, drawn, ratio)]) for marks in lists]


def _in_order(marks: list[Mark], sprites: Iterator[Rows], ratio: float) -> Iterator[Rows]:
    for mark in marks:
        if isinstance(mark, Text | Strip):
            yield next(sprites)
        else:
            yield from shape_rows(mark, ratio)


def _of_sprites(sprites: list[Sprite], corners: list[Pixel], patches: list[Patch]) -> Iterator[Rows]:
    """Yield the row of each sprite, whose image has its upper left pixel at a corner."""
    if not sprites:
        return
    begin = np.array(corners) + [patch.inset for patch in patches]
    sizes = np.array([patch.size for patch in patches])
    opacities = np.array([sprite.opacity if isinstance(sprite, Text) else 1.0 for sprite in sprites])
    rows = sprite_rows(np.hstack([begin, begin + sizes]), np.array([patch.corner for patch in patches]), opacities)
    yield from rows[:, None]
