"""Writing ``.step`` (ISO 10303-21, AP214): the exact surface, a B-spline face for each smooth part.

Written here and not by a CAD kernel, because kernels cut coordinates to 9 to 12 decimals; here every number reads
back as itself.
"""

from __future__ import annotations

from pathlib import Path

import numpy as np

from qovr_core.evaluation import Evaluation
from qovr_core.files import parts
from qovr_core.files.atomic import replacing
from qovr_core.files.conventions import Unit
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.parts import Sheet
from qovr_core.files.progress import Progress
from qovr_core.files.provenance import PROGRAM, origin, timestamp
from qovr_core.files.qovr_document import document_to_json
from qovr_core.files.step_entities import Entities, joined, quoted, real
from qovr_core.files.step_face import add_shell_model

_SI_PREFIXES = {Unit.MILLIMETRE: ".MILLI.", Unit.CENTIMETRE: ".CENTI.", Unit.METRE: "$"}
_MILLIMETRES_AN_INCH = 25.4

_LONGEST_TEXT = 4000
"""Characters of one string: OpenCASCADE reads no file with a string of more than 16,383, escaped as it stands there."""

SCHEMA = "AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"


def write_step(evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
    """Write the exact surface in the unit of its numbers, a face of true degree for each smooth part, sewn together.

    Raises
    ------
    FileError : the surface has no area, or the file cannot be written
    """
    sheets = parts.sheets(evaluation, options, path)
    progress(0.0)
    description = origin(evaluation, options)
    data = _data_section(sheets, path.stem, description, document_to_json(evaluation.document), options.unit)
    with replacing(path) as (draft,):
        draft.write_text(_header(path, description) + data, encoding="ascii", newline="\n")
        progress(1.0)


def _header(path: Path, description: str) -> str:
    time = timestamp()
    made = time.isoformat() if time else ""
    return (
        "ISO-10303-21;\nHEADER;\n"
        f"FILE_DESCRIPTION(({quoted(description)}),'2;1');\n"
        f"FILE_NAME({quoted(path.name)},'{made}',(''),(''),{quoted(PROGRAM)},{quoted(PROGRAM)},'');\n"
        f"FILE_SCHEMA(('{SCHEMA}'));\nENDSEC;\n"
    )


def _data_section(sheets: tuple[Sheet, ...], name: str, description: str, document: str, unit: Unit) -> str:
    entities = Entities()
    definition = _product(entities, name, description)
    within = parts.uncertainty(sheets)
    context = _context(entities, within, unit)
    model = add_shell_model(entities, sheets, within, name)
    origin_point = entities.point(np.zeros(3))
    axes = [entities.add(f"DIRECTION('',({joined(map(real, axis))}))") for axis in ((0, 0, 1), (1, 0, 0))]
    placement = entities.add(f"AXIS2_PLACEMENT_3D('',{origin_point},{axes[0]},{axes[1]})")
    shape = entities.add(f"MANIFOLD_SURFACE_SHAPE_REPRESENTATION({quoted(name)},({placement},{model}),{context})")
    meaning = entities.add(f"PRODUCT_DEFINITION_SHAPE('','',{definition})")
    entities.add(f"SHAPE_DEFINITION_REPRESENTATION({meaning},{shape})")
    _attribute(entities, definition, context, "QOVR document", document)
    return "DATA;\n" + "\n".join(entities.lines) + "\nENDSEC;\nEND-ISO-10303-21;\n"


def _product(entities: Entities, name: str, description: str) -> str:
    application = entities.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')")
    entities.add(f"APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})")
    context = entities.add(f"PRODUCT_CONTEXT('',{application},'mechanical')")
    product = entities.add(f"PRODUCT({quoted(name)},{quoted(name)},{quoted(description)},({context}))")
    entities.add(f"PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))")
    formation = entities.add(f"PRODUCT_DEFINITION_FORMATION('','',{product})")
    stage = entities.add(f"PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')")
    return entities.add(f"PRODUCT_DEFINITION('design','',{formation},{stage})")


def _context(entities: Entities, distance: float, unit: Unit) -> str:
    """Add units and uncertainty: the length, radians, steradians."""
    length = _length_unit(entities, unit)
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


def _length_unit(entities: Entities, unit: Unit) -> str:
    if unit is Unit.INCH:
        millimetre = _length_unit(entities, Unit.MILLIMETRE)
        factor = entities.add(f"LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE({real(_MILLIMETRES_AN_INCH)}),{millimetre})")
        dimensions = entities.add("DIMENSIONAL_EXPONENTS(1.,0.,0.,0.,0.,0.,0.)")
        return entities.add(f"(CONVERSION_BASED_UNIT('INCH',{factor})LENGTH_UNIT()NAMED_UNIT({dimensions}))")
    return entities.add(f"(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT({_SI_PREFIXES[unit]},.METRE.))")


def _attribute(entities: Entities, definition: str, context: str, name: str, text: str) -> None:
    """Add a text as a user-defined attribute of the product, a long one as numbered items."""
    pieces = [text[k : k + _LONGEST_TEXT] for k in range(0, len(text), _LONGEST_TEXT)]
    names = [name] if len(pieces) == 1 else [f"{name} {k + 1} of {len(pieces)}" for k in range(len(pieces))]
    items = [
        entities.add(f"DESCRIPTIVE_REPRESENTATION_ITEM({quoted(item)},{quoted(piece)})")
        for item, piece in zip(names, pieces, strict=True)
    ]
    meaning = entities.add(f"PROPERTY_DEFINITION({quoted(name)},'user defined attribute',{definition})")
    content = entities.add(f"REPRESENTATION({quoted(name)},({joined(items)}),{context})")
    entities.add(f"PROPERTY_DEFINITION_REPRESENTATION({meaning},{content})")
