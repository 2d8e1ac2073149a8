"""Sheets as shells of STEP: the boundary of each face in space and, so that it is never guessed, in its parameters.

A reader that is given curves in space alone looks for their parameters by projecting them, and where the surface meets
itself it may find another sheet's; so every edge says where it runs in the parameters (SURFACE_CURVE and PCURVE).
"""

from __future__ import annotations

from qovr_core.files import bspline
from qovr_core.files.bspline import KnotVector, SplineSurface
from qovr_core.files.parts import Sheet
from qovr_core.files.sewing import FaceCorner, FaceEdge, Place, Seams, places, sewn
from qovr_core.files.step_entities import Entities, joined, quoted, real
from qovr_core.geometry.edges import Edge

_LOOP = ((Edge.V0, True), (Edge.U1, True), (Edge.V1, False), (Edge.U0, False))
"""The boundary, counterclockwise seen from the tip of S_u x S_v, and whether each edge runs with its parameter."""


def add_shell_model(entities: Entities, sheets: tuple[Sheet, ...], within: float, name: str) -> str:
    """Add a shell for each sheet and return the reference to the model of them.

    Parameters
    ----------
    within : the distance at which points count as one
    """
    shells = [_shell(entities, sheet, within, name) for sheet in sheets]
    return entities.add(f"SHELL_BASED_SURFACE_MODEL('',({joined(shells)}))")


def _shell(entities: Entities, sheet: Sheet, within: float, name: str) -> str:
    seams = sewn(sheet, within)
    surfaces = {place: _surface(entities, sheet[place[0]][place[1]], within) for place in places(sheet)}
    vertices = _vertices(entities, sheet, seams)
    curves = _curves(entities, sheet, seams, surfaces, vertices)
    faces = []
    for place, surface in surfaces.items():
        oriented = [
            entities.add(f"ORIENTED_EDGE('',*,*,{curves[seams.edges[place, edge]]},{'.T.' if forward else '.F.'})")
            for edge, forward in _LOOP
            if (place, edge) in seams.edges
        ]
        loop = (
            entities.add(f"EDGE_LOOP('',({joined(oriented)}))")
            if oriented
            else entities.add(f"VERTEX_LOOP('',{vertices[seams.corners[place, (0, 0)]]})")
        )
        bound = entities.add(f"FACE_OUTER_BOUND('',{loop},.T.)")
        faces.append(entities.add(f"ADVANCED_FACE({quoted(name)},({bound}),{surface},.T.)"))
    return entities.add(f"OPEN_SHELL('',({joined(faces)}))")


def _surface(entities: Entities, surface: SplineSurface, within: float) -> str:
    rows = joined("(" + joined(entities.point(point) for point in row) + ")" for row in surface.points)
    outline = bspline.outline(surface.points, within)
    closed = ",".join(".T." if closed else ".F." for closed in (outline.closed_u, outline.closed_v))
    counts, values = (joined(lists) for lists in zip(*map(_knots, (surface.u, surface.v)), strict=True))
    return entities.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('',{surface.u.degree},{surface.v.degree},({rows}),.UNSPECIFIED.,{closed},.F.,"
        f"{counts},{values},.UNSPECIFIED.)"
    )


def _vertices(entities: Entities, sheet: Sheet, seams: Seams) -> dict[FaceCorner, str]:
    """Add the corners, one vertex for those that are one."""
    return {
        ((column, row), corner): entities.add(f"VERTEX_POINT('',{entities.point(sheet[column][row].points[corner])})")
        for (column, row), corner in dict.fromkeys(seams.corners.values())
    }


def _curves(
    entities: Entities, sheet: Sheet, seams: Seams, surfaces: dict[Place, str], vertices: dict[FaceCorner, str]
) -> dict[FaceEdge, str]:
    """Add the edges, one for two that are one, with the lines along which it runs in the parameters of its faces."""
    uses: dict[FaceEdge, list[FaceEdge]] = {}
    for place in surfaces:
        for edge, _ in _LOOP:
            if (place, edge) in seams.edges:
                uses.setdefault(seams.edges[place, edge], []).append((place, edge))
    if not uses:
        return {}
    plane = entities.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(2)PARAMETRIC_REPRESENTATION_CONTEXT()REPRESENTATION_CONTEXT('2D',''))"
    )
    curves = {}
    for (place, edge), users in uses.items():
        start, end = (vertices[seams.corners[place, corner]] for corner in edge.corners)
        in_space = _curve(entities, sheet[place[0]][place[1]], edge, closed=start == end)
        in_plane = [
            _parameter_curve(entities, sheet[column][row], side, surfaces[column, row], plane)
            for (column, row), side in users
        ]
        kind = "SEAM_CURVE" if len({user for user, _ in users}) < len(users) else "SURFACE_CURVE"
        curve = entities.add(f"{kind}('',{in_space},({joined(in_plane)}),.CURVE_3D.)")
        curves[place, edge] = entities.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")
    return curves


def _curve(entities: Entities, surface: SplineSurface, edge: Edge, *, closed: bool) -> str:
    points = surface.points[edge.position]
    knots = surface.v if edge in (Edge.U0, Edge.U1) else surface.u
    counts, values = _knots(knots)
    references = joined(entities.point(point) for point in points)
    return entities.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{knots.degree},({references}),.UNSPECIFIED.,{'.T.' if closed else '.F.'},.F.,"
        f"{counts},{values},.UNSPECIFIED.)"
    )


def _parameter_curve(entities: Entities, surface: SplineSurface, edge: Edge, reference: str, plane: str) -> str:
    """Add the line along which an edge runs in the parameters, at the speed of its curve in space."""
    indices = list(zip(edge.position, (surface.u, surface.v), strict=True))
    start = [0.0 if isinstance(index, slice) else knots.values[index] for index, knots in indices]
    along = [float(isinstance(index, slice)) for index, _ in indices]
    direction = entities.add(f"DIRECTION('',({joined(map(real, along))}))")
    vector = entities.add(f"VECTOR('',{direction},1.)")
    line = entities.add(f"LINE('',{entities.point(start)},{vector})")
    content = entities.add(f"DEFINITIONAL_REPRESENTATION('',({line}),{plane})")
    return entities.add(f"PCURVE('',{reference},{content})")


def _knots(knots: KnotVector) -> tuple[str, str]:
    """Return the multiplicities and the distinct knots as lists; a whole number ends in its point."""
    values = (real(value).removesuffix(".0") for value in knots.values)
    shortest = (text if "." in text else f"{text}." for text in values)
    return f"({joined(map(str, knots.multiplicities))})", f"({joined(shortest)})"
