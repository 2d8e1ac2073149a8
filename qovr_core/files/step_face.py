"""A surface as one face of STEP: its boundary in space and, so that it is never guessed, in its parameters.

A reader that is given curves in space alone looks for their parameters by projecting them, and where the surface meets
itself it may find another sheet's; so every edge says where it runs in the parameters (SURFACE_CURVE and PCURVE).
"""

from __future__ import annotations

import numpy as np

from qovr_core.arrays import Array
from qovr_core.files import bspline
from qovr_core.files.step_entities import Entities, joined, quoted, real
from qovr_core.geometry.edges import Edge

_LOOP = ((Edge.V0, True), (Edge.U1, True), (Edge.V1, False), (Edge.U0, False))
"""The boundary, counterclockwise seen from the tip of S_u x S_v, and whether each edge runs with its parameter."""


def add_shell_model(entities: Entities, points: Array, name: str) -> str:
    """Add a shell of one face and return the reference to it.

    Parameters
    ----------
    points : (p + 1, q + 1, 3) Bernstein coefficients of the surface
    """
    edges = bspline.outline(points, bspline.uncertainty(points))
    surface = _surface(entities, points, edges)
    bound = entities.add(f"FACE_OUTER_BOUND('',{_loop(entities, points, edges, surface)},.T.)")
    face = entities.add(f"ADVANCED_FACE({quoted(name)},({bound}),{surface},.T.)")
    shell = entities.add(f"OPEN_SHELL('',({face}))")
    return entities.add(f"SHELL_BASED_SURFACE_MODEL('',({shell}))")


def _surface(entities: Entities, points: Array, edges: bspline.Outline) -> str:
    p, q = (count - 1 for count in points.shape[:2])
    rows = joined("(" + joined(entities.point(point) for point in row) + ")" for row in points)
    closed = ",".join(".T." if closed else ".F." for closed in (edges.closed_u, edges.closed_v))
    return entities.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('',{p},{q},({rows}),.UNSPECIFIED.,{closed},.F.,"
        f"({p + 1},{p + 1}),({q + 1},{q + 1}),(0.,1.),(0.,1.),.UNSPECIFIED.)"
    )


def _loop(entities: Entities, points: Array, edges: bspline.Outline, surface: str) -> str:
    """Add the boundary: a collapsed edge is left out, the two sides of a closed surface are one edge."""
    vertices = _vertices(entities, points, edges)
    same = {Edge.U1: Edge.U0} if edges.closed_u else {}
    same |= {Edge.V1: Edge.V0} if edges.closed_v else {}
    sides = {edge: same.get(edge, edge) for edge, _ in _LOOP if edge not in edges.collapsed}
    if not sides:
        return entities.add(f"VERTEX_LOOP('',{vertices[0, 0]})")
    plane = entities.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('2D',''))"
    )
    curves = {}
    for kept in dict.fromkeys(sides.values()):
        start, end = (vertices[corner] for corner in kept.corners)
        in_space = _curve(entities, points[kept.position], closed=start == end)
        in_plane = [_parameter_curve(entities, edge, surface, plane) for edge, side in sides.items() if side == kept]
        kind = "SEAM_CURVE" if len(in_plane) > 1 else "SURFACE_CURVE"
        curve = entities.add(f"{kind}('',{in_space},({joined(in_plane)}),.CURVE_3D.)")
        curves[kept] = entities.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")
    oriented = [
        entities.add(f"ORIENTED_EDGE('',*,*,{curves[sides[edge]]},{'.T.' if forward else '.F.'})")
        for edge, forward in _LOOP
        if edge in sides
    ]
    return entities.add(f"EDGE_LOOP('',({joined(oriented)}))")


def _vertices(entities: Entities, points: Array, edges: bspline.Outline) -> dict[tuple[int, int], str]:
    """Add the corners, one vertex for those that an edge without length or the seam of a closed surface joins.

    Other corners at the same place stay two vertices: at one alone the boundary could take the wrong turn.
    """
    pairs = [edge.corners for edge in Edge if edge in edges.collapsed]
    if edges.closed_u:
        pairs += zip(Edge.U0.corners, Edge.U1.corners, strict=True)
    if edges.closed_v:
        pairs += zip(Edge.V0.corners, Edge.V1.corners, strict=True)
    first = {corner: corner for corner in ((0, 0), (-1, 0), (-1, -1), (0, -1))}
    for kept, dropped in pairs:
        first = {corner: first[kept] if known == first[dropped] else known for corner, known in first.items()}
    made = {
        corner: entities.add(f"VERTEX_POINT('',{entities.point(points[corner])})")
        for corner in dict.fromkeys(first.values())
    }
    return {corner: made[known] for corner, known in first.items()}


def _curve(entities: Entities, points: Array, *, closed: bool) -> str:
    degree = len(points) - 1
    references = joined(entities.point(point) for point in points)
    return entities.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},({references}),.UNSPECIFIED.,{'.T.' if closed else '.F.'},.F.,"
        f"({degree + 1},{degree + 1}),(0.,1.),.UNSPECIFIED.)"
    )


def _parameter_curve(entities: Entities, edge: Edge, surface: str, plane: str) -> str:
    """Add the line along which an edge runs in the parameters, at the speed of its curve in space."""
    start, end = (np.array([float(index != 0) for index in corner]) for corner in edge.corners)
    direction = entities.add(f"DIRECTION('',({joined(map(real, end - start))}))")
    vector = entities.add(f"VECTOR('',{direction},1.)")
    line = entities.add(f"LINE('',{entities.point(start)},{vector})")
    content = entities.add(f"DEFINITIONAL_REPRESENTATION('',({line}),{plane})")
    return entities.add(f"PCURVE('',{surface},{content})")
