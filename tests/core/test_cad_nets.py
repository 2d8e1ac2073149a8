"""Nets in STEP, IGES and 3DM: a surface for each smooth part, sewn in STEP, read back by other readers."""

import math
from dataclasses import replace

import numpy as np
import pytest

from qovr_core import Evaluation, FileError, Formulation
from qovr_core.cli import main
from qovr_core.files import ExportOptions, format_for, read_source, write_document
from qovr_core.files.progress import silent
from qovr_core.files.qovr_document import document_from_json
from qovr_core.joints import Joint
from support.iges_reader import IgesFile
from support.net_documents import NETS, check_exact, net_of, part_counts, random_net
from support.step_reader import StepFile

SUFFIXES = (".step", ".iges", ".3dm")


def export(document, path, **options):
    format_for(path).write(Evaluation(document), path, silent, ExportOptions(**options))
    return path


class RhinoSurface:
    """A surface of a .3dm file, called with parameters (k, 2)."""

    def __init__(self, geometry):
        assert geometry.IsValid
        self.degree = geometry.OrderU - 1, geometry.OrderV - 1
        self.domain = tuple((geometry.Domain(axis).T0, geometry.Domain(axis).T1) for axis in (0, 1))
        self._geometry = geometry

    def __call__(self, parameters):
        return np.array([[p.X, p.Y, p.Z] for p in (self._geometry.PointAt(u, v) for u, v in parameters.tolist())])


def surfaces_of(path):
    if path.suffix == ".step":
        return StepFile(path).surfaces()
    if path.suffix == ".iges":
        return IgesFile(path).surfaces()
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(path))
    return [RhinoSurface(o.Geometry) for o in model.Objects if isinstance(o.Geometry, rhino3dm.NurbsSurface)]


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("single_face", [False, True])
@pytest.mark.parametrize("name", NETS)
def test_parts_read_back_exactly(suffix, single_face, name, tmp_path):
    document = net_of(name)
    surfaces = surfaces_of(export(document, tmp_path / f"a{suffix}", single_face=single_face))
    assert len(surfaces) == (1 if single_face else math.prod(part_counts(document)))
    check_exact(surfaces, Evaluation(document).patch)


@pytest.mark.parametrize("seed", range(8))
def test_random_nets_read_back_exactly(seed, tmp_path):
    rng = np.random.default_rng(seed)
    m, n = (int(count) for count in rng.integers((1, 1), (6, 7)))
    sharp_u, sharp_v = ({k for k in range(count - 1) if rng.random() < 0.4} for count in (n, m))
    document = random_net(seed, m, n, sharp_u=sharp_u, sharp_v=sharp_v)
    for suffix in SUFFIXES:
        surfaces = surfaces_of(export(document, tmp_path / f"a{suffix}"))
        assert len(surfaces) == (len(sharp_u) + 1) * (len(sharp_v) + 1)
        check_exact(surfaces, Evaluation(document).patch)


def test_knots_are_one_fewer_than_the_degree_at_smooth_joints_and_as_many_at_sharp_ones(tmp_path):
    document = net_of("sharp both ways")
    (whole,) = StepFile(export(document, tmp_path / "a.step", single_face=True)).surfaces()
    assert whole.multiplicities == ([7, 6, 5, 5, 6, 5, 7], [7, 5, 5, 6, 5, 7])
    parts = StepFile(export(document, tmp_path / "b.step")).surfaces()
    assert {tuple(map(tuple, part.multiplicities)) for part in parts} == {
        (u, v) for u in ((7, 7), (7, 5, 5, 7), (7, 5, 7)) for v in ((7, 5, 5, 7), (7, 5, 7))
    }


def test_every_part_is_of_its_own_degree(tmp_path):
    document = net_of("quartic in its first part")
    for suffix in SUFFIXES:
        path = export(document, tmp_path / f"a{suffix}")
        assert sorted(surface.degree for surface in surfaces_of(path)) == [(4, 4), (6, 4)]


def test_windows_too_unlike_for_one_parameter_are_parts(tmp_path):
    """Across this joint the surface is smooth, but lengths in one parameter would differ by more than 1e6."""
    knots = np.full((5, 2, 4), 0.5)
    knots[:, 0, 3] = knots[:, 1, 0] = knots[:, 0, 2] = 1 - 1e-4
    y, x = np.mgrid[:5, :7].astype(float)
    document = replace(net_of("smooth", m=1, n=2), control_points=np.stack([x, y, np.sin(x + y)], -1), row_knots=knots)
    assert document.joints.u == (Joint.SMOOTH,)
    for suffix in SUFFIXES:
        surfaces = surfaces_of(export(document, tmp_path / f"a{suffix}"))
        assert len(surfaces) == 2
        check_exact(surfaces, Evaluation(document).patch)


@pytest.mark.parametrize("name", NETS)
def test_parts_are_sewn_in_step(name, tmp_path):
    """Neighbours share an edge, and run along it in opposite senses; so do the ends of a closed net."""
    document = net_of(name)
    file = StepFile(export(document, tmp_path / "a.step"))
    along_u, along_v = part_counts(document)
    lines_u, lines_v = (count + (letter not in document.closed) for letter, count in (("u", along_u), ("v", along_v)))
    assert len(file.all("EDGE_CURVE")) == lines_u * along_v + lines_v * along_u
    assert len(file.all("VERTEX_POINT")) == lines_u * lines_v
    uses = [sorted(senses) for senses in file.edge_uses().values()]
    outer = (0 if "u" in document.closed else 2 * along_v) + (0 if "v" in document.closed else 2 * along_u)
    assert uses.count([".F.", ".T."]) == len(uses) - outer
    (faces,) = (faces for _, faces in file.all("OPEN_SHELL"))
    assert len(faces) == along_u * along_v
    for face in file.all("ADVANCED_FACE"):
        curves = file.boundary_of(face)
        for k, curve in enumerate(curves):
            ahead = curves[(k + 1) % len(curves)](0.0)
            assert np.allclose(curve(1.0), ahead, rtol=0, atol=1e-9 * np.abs(ahead).max())


def test_a_part_that_is_closed_by_itself_has_a_seam(tmp_path):
    closed = {surface.closed_u for surface in StepFile(export(net_of("tube"), tmp_path / "a.step")).surfaces()}
    assert closed == {".T."}
    (surface,) = IgesFile(export(net_of("torus"), tmp_path / "a.iges")).surfaces()
    assert surface.closed == (True, True)
    parts = IgesFile(export(net_of("torus of parts"), tmp_path / "b.iges")).surfaces()
    assert {part.closed for part in parts} == {(False, False)}


@pytest.mark.parametrize("formulation", [Formulation.PUBLISHED, Formulation.DOUBLE_SUM])
@pytest.mark.parametrize("single_face", [False, True])
def test_windows_with_gaps_between_them_are_faces_of_their_own(formulation, single_face, tmp_path):
    document = random_net(3, 2, 3, formulation=formulation)
    file = StepFile(export(document, tmp_path / "a.step", single_face=single_face))
    assert len(file.all("OPEN_SHELL")) == len(file.all("ADVANCED_FACE")) == 6
    assert len(file.all("EDGE_CURVE")) == 24
    for suffix in SUFFIXES:
        surfaces = surfaces_of(export(document, tmp_path / f"a{suffix}"))
        assert len(surfaces) == 6
        check_exact(surfaces, Evaluation(document).transformed_patch)


def test_poles_are_vertices_of_several_faces(tmp_path):
    """The first and last curves of a tube of four parts are drawn together into a point each."""
    document = net_of("tube", sharp_u={0, 1, 2, 3})
    points = document.control_points.copy()
    points[1], points[-2] = points[1, 1], points[-2, 1]
    file = StepFile(export(replace(document, control_points=points), tmp_path / "a.step"))
    assert len(file.all("ADVANCED_FACE")) == 4
    assert len(file.all("EDGE_CURVE")) == 4
    assert len(file.all("VERTEX_POINT")) == 2
    for face in file.all("ADVANCED_FACE"):
        first, second = file.boundary_of(face)
        assert np.allclose(first([0.0, 1.0]), second([1.0, 0.0]))


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_part_without_area_is_refused(suffix, tmp_path):
    document = net_of("one sharp joint")
    points = document.control_points.copy()
    points[:, 4:] = points[0, 4]
    with pytest.raises(FileError, match=r"the part that begins with window 0,2 is drawn together into a curve"):
        export(replace(document, control_points=points), tmp_path / f"a{suffix}")
    assert not list(tmp_path.iterdir())


# --- the document in the file -----------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["sharp both ways", "torus of parts"])
def test_files_carry_the_document(name, tmp_path):
    document = net_of(name)
    file = StepFile(export(document, tmp_path / "a.step"))
    items = file.all("DESCRIPTIVE_REPRESENTATION_ITEM")
    assert [item for item, _ in items] == [f"QOVR document {k + 1} of {len(items)}" for k in range(len(items))]
    assert document_from_json("".join(text for _, text in items)) == document
    (of_document,) = (entry for entry in file.all("REPRESENTATION") if entry[0] == "QOVR document")
    assert len(of_document[1]) == len(items) > 1
    iges = IgesFile(export(document, tmp_path / "a.iges"))
    assert document_from_json(iges.start[iges.start.index("{") :]) == document
    assert read_source(str(export(document, tmp_path / "a.3dm"))) == document


def test_a_rhino_file_holds_the_whole_net(tmp_path):
    import rhino3dm

    document = net_of("sharp both ways")
    model = rhino3dm.File3dm.Read(str(export(document, tmp_path / "a.3dm")))
    names = [entry.Attributes.Name for entry in model.Objects]
    assert len(set(names)) == len(names)
    assert [name for name in names if name.startswith("QOVR")] == [f"QOVR surface {k}" for k in range(1, 7)]
    ids = {str(entry.Attributes.Id) for entry in model.Objects}
    assert len(ids) == len(names)
    points = {e.Attributes.Name: e.Geometry for e in model.Objects if isinstance(e.Geometry, rhino3dm.Point)}
    assert len(points) == 13 * 15
    place = points["P12,10"].Location
    assert document.control_points[12, 10].tolist() == [place.X, place.Y, place.Z]
    lines = {e.Attributes.Name: e.Geometry for e in model.Objects if isinstance(e.Geometry, rhino3dm.PolylineCurve)}
    assert [lines["row 12"].PointCount, lines["column 14"].PointCount] == [15, 13]


@pytest.mark.parametrize("version", [5, 8])
@pytest.mark.parametrize("name", ["sharp both ways", "tube", "torus of parts"])
def test_points_of_nets_that_another_program_moved_are_read_where_they_are(version, name, tmp_path, caplog):
    import rhino3dm

    document = net_of(name)
    model = rhino3dm.File3dm.Read(str(export(document, tmp_path / "a.3dm")))
    (rows, columns), expected = document.control_points.shape[:2], document.control_points.copy()
    points = {e.Attributes.Name: e.Geometry for e in model.Objects if isinstance(e.Geometry, rhino3dm.Point)}
    alike = rows - 3 if "v" in document.closed else rows, columns - 3 if "u" in document.closed else columns
    assert len(points) == math.prod(alike)
    for k, (i, j) in enumerate([(0, 0), (1, 2), (4, 5)]):
        place = expected[i, j] + (0.125 * k, -1.0, 1e-9)
        points[f"P{i},{j}"].Location = rhino3dm.Point3d(*place.tolist())
        for row in range(i, rows, alike[0]):
            for column in range(j, columns, alike[1]):
                expected[row, column] = place
    assert model.Write(str(tmp_path / "b.3dm"), version)
    assert read_source(str(tmp_path / "b.3dm")) == replace(document, control_points=expected)
    (said,) = caplog.messages
    assert "b.3dm: 3 control points were moved" in said


def test_the_command_keeps_one_face(tmp_path, capsys):
    document = net_of("one sharp joint")
    write_document(document, tmp_path / "a.qovr")
    call = ["export", str(tmp_path / "a.qovr"), str(tmp_path / "a.step")]
    assert main(call) == 0
    assert len(surfaces_of(tmp_path / "a.step")) == 2
    assert main([*call, "--single-face"]) == 0
    assert len(surfaces_of(tmp_path / "a.step")) == 1
    assert main([*call[:2], str(tmp_path / "a.npz"), "--single-face"]) == 2
    assert "--single-face is for an exact surface; expected an OUT that ends in .step, .iges, .3dm" in (
        capsys.readouterr().err
    )
