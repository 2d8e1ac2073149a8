"""Which edges and corners the faces of a sheet share, so that a reader need not look for what belongs together."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from qovr_core.arrays import Array
from qovr_core.files import bspline
from qovr_core.files.parts import Sheet
from qovr_core.geometry.edges import Edge

Place = tuple[int, int]
"""Where a face stands in its sheet: along u, along v."""

Corner = tuple[int, int]
"""A corner of a face by its indices [iu, iv] in the face's control points, each 0 or -1."""

FaceEdge = tuple[Place, Edge]
FaceCorner = tuple[Place, Corner]

_AFTER = {Edge.U1: (1, 0, Edge.U0), Edge.V1: (0, 1, Edge.V0)}
"""What lies beyond an edge: the step to the neighbour, and the neighbour's edge."""


@dataclass(frozen=True)
class Seams:
    """How the faces of a sheet hang together.

    Parameters
    ----------
    edges : for the edges of all faces, the edge that stands for both where two are one; none that is a point
    corners : for the corners of all faces, the corner that stands for all that are one
    """

    edges: dict[FaceEdge, FaceEdge]
    corners: dict[FaceCorner, FaceCorner]


def places(sheet: Sheet) -> Iterator[Place]:
    """Yield where the faces of a sheet stand."""
    for column, faces in enumerate(sheet):
        for row in range(len(faces)):
            yield column, row


def sewn(sheet: Sheet, within: float) -> Seams:
    """Return what the faces of a sheet share: neighbours an edge, and so do the ends of a sheet that is closed.

    Corners are one where neighbours meet, at the seam of a closed sheet, and where an edge joins them that is a point.
    Others at the same place stay apart: at one alone the boundary could take the wrong turn.

    Parameters
    ----------
    within : the distance at which points count as one
    """
    ends = {
        last: first
        for first, last in _ends(sheet)
        if bspline.coincide(_curve(sheet, first), _curve(sheet, last), within)
    }

    def standing_for(place: Place, edge: Edge) -> FaceEdge:
        if edge in _AFTER:
            along_u, along_v, opposite = _AFTER[edge]
            column, row = place[0] + along_u, place[1] + along_v
            if column < len(sheet) and row < len(sheet[column]):
                return (column, row), opposite
        return ends.get((place, edge), (place, edge))

    edges, pairs = {}, []
    for place in places(sheet):
        outline = bspline.outline(sheet[place[0]][place[1]].points, within)
        edges.update({(place, edge): standing_for(place, edge) for edge in Edge if edge not in outline.collapsed})
        pairs += [_nodes(place, edge) for edge in Edge if edge in outline.collapsed]
    for last, first in ends.items():
        pairs += zip(_nodes(*first), _nodes(*last), strict=True)
    return Seams(edges, _corners(sheet, pairs))


def _ends(sheet: Sheet) -> Iterator[tuple[FaceEdge, FaceEdge]]:
    """Yield the edges at which a sheet begins, each with the one at which it ends across from there."""
    last_column, last_row = len(sheet) - 1, len(sheet[0]) - 1
    for row in range(last_row + 1):
        yield ((0, row), Edge.U0), ((last_column, row), Edge.U1)
    for column in range(last_column + 1):
        yield ((column, 0), Edge.V0), ((column, last_row), Edge.V1)


def _curve(sheet: Sheet, face_edge: FaceEdge) -> Array:
    """Return the control points of an edge."""
    (column, row), edge = face_edge
    points: Array = sheet[column][row].points[edge.position]
    return points


def _nodes(place: Place, edge: Edge) -> tuple[Place, Place]:
    """Return the ends of an edge in the grid of the sheet's corners, that of its first face's first corner at 0, 0."""
    start, end = ((place[0] - iu, place[1] - iv) for iu, iv in edge.corners)
    return start, end


def _corners(sheet: Sheet, pairs: list[tuple[Place, Place]]) -> dict[FaceCorner, FaceCorner]:
    """Return the corner that stands for each, given those in the grid of the sheet's corners that are one besides."""
    last_column, last_row = len(sheet) - 1, len(sheet[0]) - 1
    grid = [(column, row) for column in range(last_column + 2) for row in range(last_row + 2)]
    first = {node: node for node in grid}
    for kept, dropped in pairs:
        label, lost = first[kept], first[dropped]
        first |= {node: label for node, known in first.items() if known == lost}
    result = {}
    for column, row in places(sheet):
        for iu, iv in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
            node = first[column - iu, row - iv]
            face = min(node[0], last_column), min(node[1], last_row)
            result[(column, row), (iu, iv)] = face, (face[0] - node[0], face[1] - node[1])
    return result
