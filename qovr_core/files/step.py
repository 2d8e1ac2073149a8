"""Writing ``.step`` (ISO 10303-21, AP214): the exact surface as one B-spline face.

Written here and not by a CAD kernel, because kernels cut coordinates to 9 to 12 decimals; here every number reads
back as itself.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from pathlib import Path

import numpy as np

from qovr_core.arrays import Array
from qovr_core.evaluation import Evaluation
from qovr_core.files import bspline
from qovr_core.files.atomic import replacing
from qovr_core.files.format import Format
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, UNIT, origin, timestamp
from qovr_core.files.qovr_document import document_to_json
from qovr_core.geometry.edges import Edge

SCHEMA = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"

_UNCERTAINTY_DIGITS = 8
"""Points closer than the surface's size, rounded up to a power of ten, times 1e-8 are the same to a CAD program."""

_LOOP = ((Edge.V0, True), (Edge.U1, True), (Edge.V1, False), (Edge.U0, False))
"""The boundary, counterclockwise seen from the tip of S_u x S_v, and whether each edge runs with its parameter."""


def write_step(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the exact surface, one face of its true degree, in millimetres.

    Raises
    ------
    FileError : the surface has no area, or the file cannot be written
    """
    patch = bspline.chosen_patch(evaluation, options, path)
    progress(0.0)
    points = bspline.control_points(patch)
    description = origin(evaluation, options)
    data = _data_section(points, path.stem, description, document_to_json(evaluation.document))
    with replacing(path) as (draft,):
        draft.write_text(_header(path, description) + data, encoding="ascii", newline="\n")
        progress(1.0)


STEP = Format(
    suffix=".step",
    name="STEP AP214",
    keeps=f"the exact surface, one B-spline face of its true degree, in {UNIT}",
    loses="nothing of the surface; control net, knots and samples, but for the document as an attribute",
    writer=write_step,
    holds_one_layer=True,
)


def uncertainty(points: Array) -> float:
    """Return the distance below which points of a surface are the same, a power of ten."""
    return float(f"1e{math.ceil(math.log10(bspline.diagonal(points))) - _UNCERTAINTY_DIGITS}")


def real(value: float) -> str:
    """Return the shortest decimal that reads back as the number, as STEP spells it: ``1e-05`` is ``1.E-5``."""
    mantissa, mark, exponent = repr(float(value)).partition("e")
    if not mark:
        return mantissa
    return f"{mantissa if '.' in mantissa else mantissa + '.'}E{int(exponent)}"


def quoted(text: str) -> str:
    """Return a text as a STEP string: quotes and backslashes doubled, all but printable ASCII in hexadecimal."""
    return "'" + "".join(map(_escaped, text)) + "'"


def _escaped(character: str) -> str:
    if character in "'\\":
        return 2 * character
    if " " <= character <= "~":
        return character
    code = ord(character)
    if 0xD800 <= code <= 0xDFFF:  # half a character, from a file name that is no valid text
        return "?"
    return f"\\X2\\{code:04X}\\X0\\" if code <= 0xFFFF else f"\\X4\\{code:08X}\\X0\\"


def _header(path: Path, description: str) -> str:
    return (
        "ISO-10303-21;\nHEADER;\n"
        f"FILE_DESCRIPTION(({quoted(description)}),'2;1');\n"
        f"FILE_NAME({quoted(path.name)},'{timestamp().isoformat()}',(''),(''),{quoted(PROGRAM)},{quoted(PROGRAM)},'');\n"
        f"FILE_SCHEMA(('{SCHEMA}'));\nENDSEC;\n"
    )


class _Entities:
    """The numbered entities of a data section."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, text: str) -> str:
        """Append an entity and return the reference to it."""
        self.lines.append(f"#{len(self.lines) + 1}={text};")
        return f"#{len(self.lines)}"

    def point(self, coordinates: Array) -> str:
        return self.add(f"CARTESIAN_POINT('',({_joined(real(x) for x in coordinates)}))")


def _joined(parts: Iterable[str]) -> str:
    return ",".join(parts)


def _data_section(points: Array, name: str, description: str, document: str) -> str:
    entities = _Entities()
    definition = _product(entities, name, description)
    context = _context(entities, uncertainty(points))
    model = _shell_model(entities, points, name)
    origin_point = entities.point(np.zeros(3))
    axes = [entities.add(f"DIRECTION('',({_joined(map(real, axis))}))") for axis in ((0, 0, 1), (1, 0, 0))]
    placement = entities.add(f"AXIS2_PLACEMENT_3D('',{origin_point},{axes[0]},{axes[1]})")
    shape = entities.add(f"MANIFOLD_SURFACE_SHAPE_REPRESENTATION({quoted(name)},({placement},{model}),{context})")
    meaning = entities.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    entities.add(f"SHAPE_DEFINITION_REPRESENTATION({meaning},{shape})")
    _attribute(entities, definition, context, "QOVR document", document)
    return "DATA;\n" + "\n".join(entities.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"


def _product(entities: _Entities, name: str, description: str) -> str:
    application = entities.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    entities.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    context = entities.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = entities.add(f"PRODUCT({quoted(name)},{quoted(name)},{quoted(description)},({context}))")
    entities.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    formation = entities.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    stage = entities.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    return entities.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")


def _context(entities: _Entities, distance: float) -> str:
    """Add units and uncertainty: millimetres, radians, steradians."""
    length = entities.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))")
    angle = entities.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))")
    solid_angle = entities.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())")
    accuracy = entities.add(
        f"UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(distance)}),{length},"
        "'distance_accuracy_value','points closer than this are the same')"
    )
    return entities.add(
        "(GEOMETRIC_REPRESENTATION_CONTEXT(3)"
        f"GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({accuracy}))"
        f"GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid_angle}))"
        "REPRESENTATION_CONTEXT('','3D'))"
    )


def _attribute(entities: _Entities, definition: str, context: str, name: str, text: str) -> None:
    """Add a text as a user-defined attribute of the product."""
    item = entities.add(f"DESCRIPTIVE_REPRESENTATION_ITEM({quoted(name)},{quoted(text)})")
    meaning = entities.add(f"PROPERTY_DEFINITION({quoted(name)},'user defined attribute',{definition})")
    content = entities.add(f"REPRESENTATION({quoted(name)},({item}),{context})")
    entities.add(f"PROPERTY_DEFINITION_REPRESENTATION({meaning},{content})")


def _shell_model(entities: _Entities, points: Array, name: str) -> str:
    edges = bspline.outline(points, uncertainty(points))
    surface = _surface(entities, points, edges)
    bound = entities.add(f"FACE_OUTER_BOUND('',{_loop(entities, points, edges)},.T.)")
    face = entities.add(f"ADVANCED_FACE({quoted(name)},({bound}),{surface},.T.)")
    shell = entities.add(f"OPEN_SHELL('',({face}))")
    return entities.add(f"SHELL_BASED_SURFACE_MODEL('',({shell}))")


def _surface(entities: _Entities, points: Array, edges: bspline.Outline) -> str:
    p, q = (count - 1 for count in points.shape[:2])
    rows = _joined("(" + _joined(entities.point(point) for point in row) + ")" for row in points)
    closed = ",".join(".T." if closed else ".F." for closed in (edges.closed_u, edges.closed_v))
    return entities.add(
        f"B_SPLINE_SURFACE_WITH_KNOTS('',{p},{q},({rows}),.UNSPECIFIED.,{closed},.F.,"
        f"({p + 1},{p + 1}),({q + 1},{q + 1}),(0.,1.),(0.,1.),.UNSPECIFIED.)"
    )


def _loop(entities: _Entities, points: Array, edges: bspline.Outline) -> str:
    """Add the boundary: a collapsed edge is left out, the two sides of a closed surface are one edge."""
    vertices = _vertices(entities, points)
    same = {Edge.U1: Edge.U0} if edges.closed_u else {}
    same |= {Edge.V1: Edge.V0} if edges.closed_v else {}
    curves: dict[Edge, str] = {}
    oriented = []
    for edge, forward in _LOOP:
        if edge in edges.collapsed:
            continue
        kept = same.get(edge, edge)
        if kept not in curves:
            start, end = (vertices[corner] for corner in kept.corners)
            curve = _curve(entities, points[kept.position], closed=start == end)
            curves[kept] = entities.add(f"EDGE_CURVE('',{start},{end},{curve},.T.)")
        oriented.append(entities.add(f"ORIENTED_EDGE('',*,*,{curves[kept]},{'.T.' if forward else '.F.'})"))
    if not oriented:
        return entities.add(f"VERTEX_LOOP('',{vertices[0, 0]})")
    return entities.add(f"EDGE_LOOP('',({','.join(oriented)}))")


def _vertices(entities: _Entities, points: Array) -> dict[tuple[int, int], str]:
    """Add the corners, one vertex for those that are the same point."""
    within = uncertainty(points)
    vertices: dict[tuple[int, int], str] = {}
    for corner in ((0, 0), (-1, 0), (-1, -1), (0, -1)):
        met = [known for known in vertices if np.linalg.norm(points[known] - points[corner]) <= within]
        vertices[corner] = (
            vertices[met[0]] if met else entities.add(f"VERTEX_POINT('',{entities.point(points[corner])})")
        )
    return vertices


def _curve(entities: _Entities, points: Array, *, closed: bool) -> str:
    degree = len(points) - 1
    references = _joined(entities.point(point) for point in points)
    return entities.add(
        f"B_SPLINE_CURVE_WITH_KNOTS('',{degree},({references}),.UNSPECIFIED.,{'.T.' if closed else '.F.'},.F.,"
        f"({degree + 1},{degree + 1}),(0.,1.),.UNSPECIFIED.)"
    )
