"""The exact surface in STEP, IGES and 3DM, read back by readers that share nothing with the writers."""

from dataclasses import replace

import numpy as np
import pytest

from qovr_core import FORMULATIONS, Edge, FileError, Formulation, configure
from qovr_core.files import FORMATS, ExportOptions, bspline, format_for, read_source, step
from qovr_core.files.progress import silent
from qovr_core.files.qovr_document import document_from_json
from qovr_core.layer import Layer
from qovr_core.presets import preset
from support.documents import random_document
from support.iges_reader import IgesFile
from support.shapes import CLOSED, COINCIDING, COLLAPSED, at_random, coinciding, configured, of_degree, special
from support.step_reader import StepFile

DEGREES = ((4, 4), (4, 6), (6, 4), (6, 6))
SIZES = (1e-3, 1.0, 1e5)
SUFFIXES = (".step", ".iges", ".3dm")
EXACT = 1e-12


def export(surface, path, **options):
    format_for(path).write(surface, path, silent, ExportOptions(**options))
    return path


def read_surface(path):
    """Return degrees and a function of parameters (k, 2) by the reader of the suffix that is not OpenCASCADE."""
    if path.suffix == ".step":
        return StepFile(path).surface()
    if path.suffix == ".iges":
        degree, _, function = IgesFile(path).surface()
        return degree, function
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(path))
    (surface,) = (entry.Geometry for entry in model.Objects if isinstance(entry.Geometry, rhino3dm.NurbsSurface))
    assert surface.IsValid

    def function(parameters):
        return np.array([[p.X, p.Y, p.Z] for p in (surface.PointAt(u, v) for u, v in parameters)])

    return (surface.OrderU - 1, surface.OrderV - 1), function


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("size", SIZES)
def test_the_surface_reads_back_exactly(suffix, degree, size, tmp_path):
    surface = configured(21, *degree, size)
    assert surface.patch.degree == degree
    parameters, points, extent = at_random(surface.patch)
    found, function = read_surface(export(surface, tmp_path / f"a{suffix}"))
    assert found == degree
    assert np.abs(function(parameters) - points).max() <= EXACT * extent


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
@pytest.mark.parametrize("layer", Layer)
def test_the_chosen_layer_is_written(suffix, formulation, layer, tmp_path):
    surface = configure(random_document(22, formulation, low=0.2, high=0.8))
    patch = surface.patch if layer is Layer.RAW else surface.transformed_patch
    parameters, points, extent = at_random(patch, 50)
    path = tmp_path / f"a{suffix}"
    assert np.abs(read_surface(export(surface, path, layer=layer))[1](parameters) - points).max() <= EXACT * extent
    is_default = (layer is Layer.RAW) == (formulation is Formulation.INTERPOLATING)
    default = read_surface(export(surface, path))[1](parameters)
    assert (np.abs(default - points).max() <= EXACT * extent) == is_default


@pytest.mark.parametrize("degree", DEGREES)
def test_degree_reduction_keeps_corners_and_meets_the_patch(degree):
    patch = build(degree)
    points = spline(patch, degree).points
    assert points.shape == (degree[0] + 1, degree[1] + 1, 3)
    for corner in ((0, 0), (0, -1), (-1, 0), (-1, -1)):
        assert np.array_equal(points[corner], patch.coefficients[0, 0][corner])


def test_a_patch_that_is_not_of_the_degree_it_claims_stays_of_degree_6():
    patch = build((6, 6))
    surface = spline(patch, (4, 4))
    assert np.array_equal(surface.points, patch.coefficients[0, 0])
    assert (surface.u.degree, surface.v.degree) == (6, 6)


def build(degree):
    return configure(of_degree(23, *degree)).patch


def spline(patch, degree):
    return bspline.spline_surface(patch.coefficients, degree, patch.breakpoints, ((), ()))


# --- STEP -------------------------------------------------------------------------------------------------------------


def test_the_boundary_of_a_step_face_runs_around_it_counterclockwise(tmp_path):
    surface = configured(24, 4, 6)
    file = StepFile(export(surface, tmp_path / "a.step"))
    t = np.linspace(0, 1, 21)
    there = [surface.patch.points(u, v).reshape(-1, 3) for u, v in ((t, [0]), ([1], t), (t[::-1], [1]), ([0], t[::-1]))]
    for curve, points in zip(file.boundary(), there, strict=True):
        assert curve(t) == pytest.approx(points, abs=1e-13)


@pytest.mark.parametrize(
    ("name", "edges", "closed"),
    [
        ("v=0", 3, (".F.", ".F.")),
        ("u=0", 3, (".F.", ".F.")),
        ("v=0 and v=1", 2, (".F.", ".F.")),
        ("tube", 4, (".T.", ".F.")),
        ("torus", 4, (".T.", ".T.")),
        ("sphere", 2, (".T.", ".F.")),
    ],
)
def test_collapsed_edges_are_left_out_and_closed_ones_used_twice(name, edges, closed, tmp_path):
    file = StepFile(export(configure(special(name)), tmp_path / "a.step"))
    curves = file.boundary()
    assert len(curves) == edges
    for k, curve in enumerate(curves):
        assert curve(1.0) == pytest.approx(curves[(k + 1) % edges](0.0), abs=1e-9)
    assert tuple(file.one("B_SPLINE_SURFACE_WITH_KNOTS")[5:7]) == closed
    twice = {"tube": 1, "sphere": 1, "torus": 2}.get(name, 0)
    assert len(file.all("EDGE_CURVE")) == edges - twice
    corners = {"v=0": 3, "u=0": 3, "v=0 and v=1": 2, "tube": 2, "torus": 1, "sphere": 2}[name]
    assert len(file.all("VERTEX_POINT")) == corners


@pytest.mark.parametrize("name", COINCIDING)
def test_corners_at_one_place_are_four_vertices_of_four_edges(name, tmp_path):
    """The reader also checks that each edge's line in the parameters gives its curve in space."""
    surface = configure(coinciding(name))
    file = StepFile(export(surface, tmp_path / "a.step"))
    curves = file.boundary()
    assert len(curves) == len(file.all("EDGE_CURVE")) == len(file.all("VERTEX_POINT")) == 4
    ends = {tuple(line([0.0, 1.0]).ravel()) for line in map(file.parameter_line, file.pcurves())}
    assert ends == {(0, 0, 1, 0), (1, 0, 1, 1), (0, 1, 1, 1), (0, 0, 0, 1)}


def test_a_step_face_whose_whole_boundary_is_one_point(tmp_path):
    file = StepFile(export(configure(special("balloon")), tmp_path / "a.step"))
    assert len(file.all("VERTEX_LOOP")) == len(file.all("VERTEX_POINT")) == 1
    assert not file.all("EDGE_CURVE")


@pytest.mark.parametrize("size", SIZES)
def test_units_uncertainty_and_structure_of_a_step_file(size, tmp_path):
    file = StepFile(export(configured(25, 6, 6, size), tmp_path / "a.step"))
    assert file.header["FILE_SCHEMA"] == [["AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }"]]
    (units,) = (entity for entity in file.entities.values() if "LENGTH_UNIT" in entity)
    assert units["SI_UNIT"] == [".MILLI.", ".METRE."]
    measure, *_ = file.one("UNCERTAINTY_MEASURE_WITH_UNIT")
    assert measure[0] == "LENGTH_MEASURE"
    assert 1e-9 * size < measure[1][0] < 1e-6 * size
    for name in ("PRODUCT", "PRODUCT_DEFINITION", "SHAPE_DEFINITION_REPRESENTATION", "OPEN_SHELL", "ADVANCED_FACE"):
        file.one(name)


NAMES = ["Fläche 'Ünal' \\ 曲面 𝛼.step", "a\nb\t'.step", "''.step", "\udcff.step", "X" * 200 + ".step"]


@pytest.mark.parametrize("name", NAMES)
def test_names_are_escaped(name, tmp_path):
    surface = configured(26, 4, 4)
    file = StepFile(export(surface, tmp_path / name))
    expected = name.removesuffix(".step").replace("\udcff", "?")
    assert file.one("PRODUCT")[0] == expected
    iges = IgesFile(export(surface, tmp_path / name.replace(".step", ".iges")))
    assert len(iges.globals[2]) == len(expected)


def test_numbers_are_the_shortest_that_read_back():
    values = [0.1, -0.0, 1e-5, 1.5e-300, 1e22, 123456789.123, 5e-324, 2 / 3]
    assert [float(step.real(value)) for value in values] == values
    assert step.real(1e-5) == "1.E-5"
    assert step.real(1e22) == "1.E22"
    assert step.real(0.1) == "0.1"


# --- what every file says of itself -----------------------------------------------------------------------------------


def test_every_file_says_where_it_comes_from(tmp_path):
    document = replace(preset("fig6c").document, formulation=Formulation.DOUBLE_SUM)
    surface = configure(document)
    file = StepFile(export(surface, tmp_path / "a.step"))
    ((name, text),) = file.all("DESCRIPTIVE_REPRESENTATION_ITEM")
    assert name == "QOVR document"
    assert document_from_json(text) == document
    iges = IgesFile(export(surface, tmp_path / "a.iges"))
    assert document_from_json(iges.start[iges.start.index("{") :]) == document
    for text in (file.header["FILE_DESCRIPTION"][0][0], iges.start, file.one("PRODUCT")[2]):
        assert text.startswith("QOVR Studio 0.")
        assert "formulation double-sum, transformed surface" in text


def test_a_rhino_file_holds_surface_net_points_and_document(tmp_path):
    import rhino3dm

    surface = configured(27, 4, 6)
    model = rhino3dm.File3dm.Read(str(export(surface, tmp_path / "a.3dm")))
    assert model.Settings.ModelUnitSystem == rhino3dm.UnitSystem.Millimeters
    assert [layer.Name for layer in model.Layers] == ["Surface", "Control net", "Control points"]
    geometry = [(entry.Attributes.LayerIndex, entry.Attributes.Name, entry.Geometry) for entry in model.Objects]
    points = {name: [g.Location.X, g.Location.Y, g.Location.Z] for layer, name, g in geometry if layer == 2}
    assert len(points) == 25
    assert points["P3,1"] == surface.document.control_points[3, 1].tolist()
    lines = {name: g for layer, name, g in geometry if layer == 1}
    assert len(lines) == 10
    assert surface.document.control_points[2, 4, 1] == lines["column 4"].Point(2).Y
    assert document_from_json(model.Strings["qovr.document"]) == surface.document
    assert "formulation interpolating, raw surface" in model.Strings["qovr.origin"]
    assert read_source(str(tmp_path / "a.3dm")) == surface.document


@pytest.mark.parametrize("name", [*COLLAPSED, *CLOSED])
def test_special_surfaces_are_valid_in_rhino(name, tmp_path):
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(export(configure(special(name)), tmp_path / "a.3dm")))
    surface = model.Objects[0].Geometry
    assert surface.IsValid
    assert surface.HasBrepForm
    singular = {"v=0": {0}, "u=0": {3}, "v=0 and v=1": {0, 2}, "sphere": {0, 2}, "balloon": {0, 1, 2, 3}}
    south, east, north, west = range(4)
    assert {side for side in (south, east, north, west) if surface.IsSingular(side)} == singular.get(name, set())
    assert [surface.IsClosed(0), surface.IsClosed(1)] == {
        "tube": [True, False],
        "sphere": [True, False],
        "torus": [True, True],
        "balloon": [True, True],
    }.get(name, [False, False])


STEP_UNITS = {"mm": (".MILLI.", None), "cm": (".CENTI.", None), "m": ("$", None), "in": (".MILLI.", 25.4)}


@pytest.mark.parametrize("unit", STEP_UNITS)
def test_every_exact_format_declares_the_unit(unit, tmp_path):
    import rhino3dm

    prefix, factor = STEP_UNITS[unit]
    surface = configured(25, 6, 6)
    file = StepFile(export(surface, tmp_path / "a.step", unit=unit))
    (declared,) = file.one_entity("GLOBAL_UNIT_ASSIGNED_CONTEXT")["GLOBAL_UNIT_ASSIGNED_CONTEXT"][0][:1]
    length = file.entities[declared.number]
    assert "LENGTH_UNIT" in length
    if factor is not None:
        name, conversion = length["CONVERSION_BASED_UNIT"]
        assert name == "INCH"
        measure, base = file.of(conversion)[1]
        assert measure == ("LENGTH_MEASURE", [factor])
        length = file.entities[base.number]
    assert length["SI_UNIT"] == [prefix, ".METRE."]
    iges = IgesFile(export(surface, tmp_path / "a.iges", unit=unit)).globals
    assert iges[13:15] == {"mm": ["2", "MM"], "cm": ["10", "CM"], "m": ["6", "M"], "in": ["1", "IN"]}[unit]
    model = rhino3dm.File3dm.Read(str(export(surface, tmp_path / "a.3dm", unit=unit)))
    names = {"mm": "Millimeters", "cm": "Centimeters", "m": "Meters", "in": "Inches"}
    assert model.Settings.ModelUnitSystem == getattr(rhino3dm.UnitSystem, names[unit])
    for suffix in SUFFIXES:  # the numbers stay what they are
        parameters, points, extent = at_random(surface.patch, 50)
        assert np.abs(read_surface(tmp_path / f"a{suffix}")[1](parameters) - points).max() <= EXACT * extent


def test_iges_globals(tmp_path):
    surface = configured(28, 6, 4)
    fields = IgesFile(export(surface, tmp_path / "name.iges")).globals
    assert fields[:4] == [",", ";", "name", "name.iges"]
    assert fields[12:15] == ["1.0", "2", "MM"]
    assert float(fields[18].replace("D", "E")) == bspline.uncertainty(spline(surface.patch, (6, 4)).points)
    assert fields[22] == "11"


@pytest.mark.parametrize("name", CLOSED[:3])
def test_iges_tells_closed_surfaces(name, tmp_path):
    _, closed, _ = IgesFile(export(configure(special(name)), tmp_path / "a.iges")).surface()
    assert closed == (True, name == "torus")


@pytest.mark.parametrize("suffix", [suffix for suffix, entry in FORMATS.items() if entry.holds_one_layer])
@pytest.mark.parametrize("net", ["a point", "a line"])
def test_a_surface_without_area_is_refused(suffix, net, tmp_path):
    points = np.zeros((5, 5, 3))
    if net == "a line":
        points[..., 0] = np.arange(5)
    surface = configure(replace(random_document(1), control_points=points))
    with pytest.raises(FileError, match="drawn together into a curve or a point"):
        export(surface, tmp_path / f"a{suffix}")
    assert not list(tmp_path.iterdir())


def test_the_outline_of_a_patch():
    points = configure(special("sphere")).patch.coefficients[0, 0]
    found = bspline.outline(points, 1e-12)
    assert found == bspline.Outline(frozenset({Edge.V0, Edge.V1}), closed_u=True, closed_v=False)
    assert COLLAPSED[0] == Edge.V0


@pytest.mark.parametrize("version", [4, 5, 6, 7, 8])
@pytest.mark.parametrize("count", [1, 25])
def test_points_that_another_program_moved_are_read_where_they_are(version, count, tmp_path, caplog):
    import rhino3dm

    surface = configured(29, 4, 4)
    model = rhino3dm.File3dm.Read(str(export(surface, tmp_path / "a.3dm")))
    expected = surface.document.control_points.copy()
    points = [entry for entry in model.Objects if isinstance(entry.Geometry, rhino3dm.Point)][:count]
    for entry in points:
        i, j = int(entry.Attributes.Name[1]), int(entry.Attributes.Name[3])
        expected[i, j] += (0.125 * i, -3.0, 1e-9)
        entry.Geometry.Location = rhino3dm.Point3d(*expected[i, j].tolist())
    assert model.Write(str(tmp_path / "b.3dm"), version)
    again = read_source(str(tmp_path / "b.3dm"))
    assert again.control_points.tolist() == expected.tolist()
    assert again == replace(surface.document, control_points=expected)
    (said,) = caplog.messages
    assert f"b.3dm: {count} control point" in said


@pytest.mark.parametrize("version", [5, 6, 7, 8])
def test_the_document_survives_another_programs_save(version, tmp_path):
    import rhino3dm

    surface = configured(29, 4, 4)
    model = rhino3dm.File3dm.Read(str(export(surface, tmp_path / "a.3dm")))
    model.Strings["another"] = "text"
    assert model.Write(str(tmp_path / "b.3dm"), version)
    assert read_source(str(tmp_path / "b.3dm")) == surface.document


def test_rubbish_is_no_rhino_file(tmp_path):
    whole = export(configured(29, 4, 4), tmp_path / "a.3dm").read_bytes()
    bad = tmp_path / "bad.3dm"
    key = "qovr.document\0".encode("utf-16-le")
    contents = {
        b"": "is no Rhino file",
        b"rubbish": "is no Rhino file",
        whole[:3000]: "has no user text 'qovr.document'",
        whole[: whole.index(key) + 1000]: "is no JSON",
        whole.replace(key, key + b"\xff\xff\xff\x7f"): "bytes long; expected a document",
    }
    for content, message in contents.items():
        bad.write_bytes(content)
        with pytest.raises(FileError, match=message):
            read_source(str(bad))
