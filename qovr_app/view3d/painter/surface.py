"""The surface without OpenGL: cells sorted from far to near and painted over one another."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt
from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QColor, QImage, QPainter, QPen, QPolygonF

from qovr_app.state.display import Style
from qovr_app.style.canvas import blank_image, painting
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grid import Grid, cell_corners
from qovr_app.view3d.scene.mesh import surface_vertices
from qovr_app.view3d.scene.patterns import BELOW, BELOW_PART
from qovr_app.view3d.scene.picture import Picture
from qovr_app.view3d.scene.surface_style import POINT_SIZE, line_opacity, line_width, relief
from qovr_core.arrays import Array

_MOVING_CELLS, _RESTING_CELLS, _SAMPLE_CELLS = 30, 60, 100
"""Cells a side, the last where samples are drawn as they are: painting one takes microseconds, and orbiting has to stay
fluent."""

_KEY_LIGHT = np.array([-0.36, 0.48, 0.80])
"""As in the surface's fragment shader."""

_CELL_LINE = 0.75
"""Every cell is outlined here, where OpenGL draws few lines: each is that much thinner and paler."""

_SEAM = 1.0
"""Width of the outline in a cell's own colour that closes the gaps between antialiased neighbours."""


def surface_image(picture: Picture, size: Size, pixels: tuple[int, int]) -> QImage:
    """Return the surface alone on a transparent image; the picture laid out for ``size`` logical pixels."""
    image = blank_image(pixels, 1.0)
    with painting(image) as painter:
        painter.scale(pixels[0] / size[0], pixels[1] / size[1])
        paint_surface(painter, picture, size)
    return image


def paint_surface(painter: QPainter, picture: Picture, size: Size) -> None:
    """Paint the surface of a picture; the painter's units are logical pixels."""
    scene, settings = picture.scene, picture.settings
    if not settings.surface:
        return
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    grid = _grid(picture)
    vertices = np.concatenate(
        [surface_vertices(scene.patch, grid), picture.colouring.parts(grid)[..., None]], axis=-1, dtype=np.float64
    )
    seen = picture.camera.project(vertices[..., :3], size)
    if settings.style is Style.POINTS:
        _paint_points(painter, picture, vertices, seen)
    else:
        _paint_cells(painter, picture, _cells(vertices, grid), _cells(seen, grid))


def _grid(picture: Picture) -> Grid:
    resting = _SAMPLE_CELLS if picture.settings.document_samples else _RESTING_CELLS
    limit = _MOVING_CELLS if picture.moving else resting
    return picture.grid.within((limit, limit)).fewer(limit)


def _cells(values: Array, grid: Grid) -> Array:
    """Return the four corners of every cell, (cells, 4, k), the first one being the one at which it begins."""
    return np.stack(cell_corners(values, grid), axis=2).reshape(-1, 4, values.shape[-1])


def _paint_cells(painter: QPainter, picture: Picture, cells: Array, corners: Array) -> None:
    """Paint cells (k, 4, 7) whose corners are seen at pixels (k, 4, 3)."""
    style = picture.settings.style
    in_front = np.isfinite(corners).all(axis=(1, 2))
    corners, cells = corners[in_front], cells[in_front]
    order = np.argsort(-corners[..., 2].mean(axis=1))
    colours = _cell_colours(picture, cells)[order].tolist()
    alpha = line_opacity(picture.settings)
    ink = QColor(*picture.theme.surface_line)
    ink.setAlphaF(alpha * _CELL_LINE)
    pen = QPen(ink, line_width(style) * _CELL_LINE)
    pen.setJoinStyle(Qt.PenJoinStyle.RoundJoin)
    for outline, colour in zip(corners[order, :, :2].tolist(), colours, strict=True):
        shape = QPolygonF([QPointF(x, y) for x, y in outline])
        fill = QColor(*colour)
        painter.setPen(QPen(fill, _SEAM))
        if style is Style.WIREFRAME:
            painter.drawPolygon(shape)
            continue
        painter.setBrush(fill)
        painter.drawConvexPolygon(shape)
        if alpha:
            painter.setPen(pen)
            painter.drawPolyline(shape)


def _cell_colours(picture: Picture, cells: Array) -> npt.NDArray[np.uint8]:
    """Return red, green and blue of every cell (k, 4, 7): by its first corner in facets, else by its middle."""
    normals = _unit(_normals(picture, cells) @ picture.camera.axes.T)
    middles, toward = cells[..., :3].mean(axis=1), _toward(picture, cells[..., :3].mean(axis=1))
    if picture.has_facets:
        colours = picture.colouring.colours(cells[:, 0, 6], picture.theme.undefined)
    else:
        colours = _colours(picture, middles, normals, cells[..., 6].mean(axis=1))
    if picture.settings.style is not Style.WIREFRAME:
        is_below = (np.einsum("kd,kd->k", normals, toward) < 0) != picture.scene.is_turned
        tinted = (1 - BELOW_PART) * colours[is_below] + BELOW_PART * np.array(BELOW)
        colours[is_below] = np.rint(tinted).astype(np.uint8)
    if picture.settings.style not in (Style.SMOOTH, Style.CLAY):
        return colours
    normals = normals * np.where(normals[:, 2:] < 0, -1, 1)
    key = np.maximum(normals @ _KEY_LIGHT, 0)
    light = 1 + relief(picture.settings) * (0.52 + 0.44 * key + 0.10 * normals[:, 2] - 1)
    lit: npt.NDArray[np.uint8] = np.clip(colours * light[:, None], 0, 255).astype(np.uint8)
    return lit


def _normals(picture: Picture, cells: Array) -> Array:
    """Return a normal of every cell (k, 4, 7), of no certain length: the surface's, or the flat facet's own."""
    if not picture.settings.document_samples:
        mean: Array = cells[..., 3:6].mean(axis=1)
        return mean
    first, second, third, fourth = cells[..., :3].transpose(1, 0, 2)
    return np.cross(third - first, fourth - second)


def _colours(picture: Picture, points: Array, normals: Array, parts: Array) -> npt.NDArray[np.uint8]:
    """Return the unlit colours at points (k, 3) with unit normals (k, 3) in the camera's axes and parts (k,)."""
    if picture.colouring.pattern is not None:
        parts = picture.colouring.pattern.parts(normals, _toward(picture, points))
    return picture.colouring.colours(parts, picture.theme.undefined)


def _toward(picture: Picture, points: Array) -> Array:
    """Return unit vectors (k, 3) from points (k, 3) to the eye, in the camera's axes."""
    eye = picture.camera.eye
    return _unit((eye[:3] - eye[3] * points) @ picture.camera.axes.T)


def _unit(vectors: Array) -> Array:
    """Return vectors (k, 3) brought to length 1; a vanishing one stays."""
    lengths: Array = np.linalg.norm(vectors, axis=1, keepdims=True)
    return vectors / np.maximum(lengths, np.finfo(float).tiny)


def _paint_points(painter: QPainter, picture: Picture, vertices: Array, seen: Array) -> None:
    flat, places = vertices.reshape(-1, 7), seen.reshape(-1, 3)
    normals = _unit(flat[:, 3:6] @ picture.camera.axes.T)
    colours = _colours(picture, flat[:, :3], normals, flat[:, 6])
    order = np.argsort(-places[:, 2])
    for (x, y, depth), colour in zip(places[order].tolist(), colours[order].tolist(), strict=True):
        if np.isfinite(depth):
            painter.setPen(QPen(QColor(*colour), POINT_SIZE, Qt.PenStyle.SolidLine, Qt.PenCapStyle.RoundCap))
            painter.drawPoint(QPointF(x, y))
