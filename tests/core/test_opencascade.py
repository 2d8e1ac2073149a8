"""STEP and IGES as the kernel that most CAD programs share reads them: one valid face, exact, of the right area."""

import subprocess
import sys
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np
import pytest

from qovr_core import configure
from qovr_core.files import ExportOptions, format_for
from qovr_core.files.progress import silent
from qovr_core.layer import Layer
from qovr_core.presets import preset
from support.documents import random_net
from support.shapes import CLOSED, COINCIDING, COLLAPSED, at_random, coinciding, of_degree, special

pytestmark = pytest.mark.slow
pytest.importorskip("OCP", reason="OpenCASCADE is not installed: pip install --group cad")

ROOT = Path(__file__).resolve().parents[2]
DEGREES = ((4, 4), (4, 6), (6, 4), (6, 6))
SIZES = (1e-3, 1.0, 1e5)
EXACT = 1e-12
AREA = 0.02
"""OpenCASCADE's quadrature is that coarse on surfaces that fold; a wrong boundary would give half or none of it."""
MESH_AREA = 1e-3
MESH_DEVIATION, MESH_ANGLE = 1e-4, 0.1
"""Of its triangles, which tell the area more closely: their distance as a part of the size, and their angle."""


@dataclass
class Face:
    """The one face of a file."""

    is_valid: bool
    surface: object
    area: float
    shape: object

    def points(self, parameters):
        return np.array([[p.X(), p.Y(), p.Z()] for p in (self.surface.Value(u, v) for u, v in parameters)])


def read(path):
    from OCP.BRep import BRep_Tool
    from OCP.BRepCheck import BRepCheck_Analyzer
    from OCP.BRepGProp import BRepGProp
    from OCP.GProp import GProp_GProps
    from OCP.IFSelect import IFSelect_ReturnStatus
    from OCP.IGESControl import IGESControl_Reader
    from OCP.STEPControl import STEPControl_Reader
    from OCP.TopAbs import TopAbs_ShapeEnum
    from OCP.TopExp import TopExp_Explorer
    from OCP.TopoDS import TopoDS

    reader = STEPControl_Reader() if path.suffix == ".step" else IGESControl_Reader()
    assert reader.ReadFile(str(path)) == IFSelect_ReturnStatus.IFSelect_RetDone
    assert reader.TransferRoots() == 1
    shape = reader.OneShape()
    explorer, faces = TopExp_Explorer(shape, TopAbs_ShapeEnum.TopAbs_FACE), []
    while explorer.More():
        faces.append(explorer.Current())
        explorer.Next()
    (face,) = faces
    face = TopoDS.Face(face)
    properties = GProp_GProps()
    BRepGProp.SurfaceProperties_s(face, properties, 1e-7)
    return Face(BRepCheck_Analyzer(shape).IsValid(), BRep_Tool.Surface_s(face), properties.Mass(), face)


def area(patch):
    """Return the area by Gauss-Legendre quadrature on 20 x 20 pieces."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    starts = np.arange(20) / 20
    t = (starts[:, None] + (nodes + 1) / 40).ravel()
    w = np.tile(weights / 40, 20)
    normals = np.cross(patch.derivative(t, t, 1, 0), patch.derivative(t, t, 0, 1))
    return float(w @ np.linalg.norm(normals, axis=-1) @ w)


def check(document, path, degree):
    surface = configure(document)
    format_for(path).write(surface, path, silent)
    face = read(path)
    parameters, points, extent = at_random(surface.patch)
    assert face.is_valid
    assert (face.surface.UDegree(), face.surface.VDegree()) == degree
    assert np.abs(face.points(parameters) - points).max() <= EXACT * extent
    assert face.area == pytest.approx(area(surface.patch), rel=AREA)


def mesh_area(face, size):
    """Return the area of the triangles that OpenCASCADE draws a face with."""
    from OCP.BRep import BRep_Tool
    from OCP.BRepMesh import BRepMesh_IncrementalMesh
    from OCP.TopLoc import TopLoc_Location

    BRepMesh_IncrementalMesh(face.shape, MESH_DEVIATION * size, False, MESH_ANGLE)
    mesh = BRep_Tool.Triangulation_s(face.shape, TopLoc_Location())
    points = np.array([[p.X(), p.Y(), p.Z()] for p in (mesh.Node(k + 1) for k in range(mesh.NbNodes()))])
    a, b, c = points[np.array([mesh.Triangle(k + 1).Get() for k in range(mesh.NbTriangles())]).T - 1]
    return float(np.linalg.norm(np.cross(b - a, c - a), axis=-1).sum() / 2)


@pytest.mark.parametrize("suffix", [".step", ".iges"])
@pytest.mark.parametrize("degree", DEGREES)
@pytest.mark.parametrize("size", SIZES)
def test_one_valid_face_of_its_degree(suffix, degree, size, tmp_path):
    check(of_degree(31, *degree, size), tmp_path / f"a{suffix}", degree)


@pytest.mark.parametrize("suffix", [".step", ".iges"])
@pytest.mark.parametrize("name", [*COLLAPSED, *CLOSED])
@pytest.mark.parametrize("size", SIZES)
def test_collapsed_and_closed_edges(suffix, name, size, tmp_path):
    check(special(name, size=size), tmp_path / f"a{suffix}", (6, 6))


@pytest.mark.parametrize("suffix", [".step", ".iges"])
@pytest.mark.parametrize(("unit", "millimetres"), [("mm", 1), ("cm", 10), ("m", 1000), ("in", 25.4)])
def test_units_are_understood(suffix, unit, millimetres, tmp_path):
    surface = configure(of_degree(31, 6, 6))
    path = tmp_path / f"a{suffix}"
    format_for(path).write(surface, path, silent, ExportOptions(unit=unit))
    parameters, points, extent = at_random(surface.patch, 50)
    face = read(path)
    assert face.is_valid
    assert np.abs(face.points(parameters) / millimetres - points).max() <= EXACT * extent


def overlapping(seed):
    """Return a document whose net lies over itself, as the surface then does."""
    document = of_degree(seed, 6, 6)
    points = random_net(seed)
    points[3] = points[1] + 0.05 * (points[3] - points[1])
    points[:, 3] = points[:, 1] + 0.3 * (points[:, 3] - points[:, 1])
    return replace(document, control_points=points)


@pytest.mark.parametrize(
    "document",
    [*(coinciding(name) for name in COINCIDING), *(overlapping(seed) for seed in (1, 2, 3))],
    ids=[*COINCIDING, *(f"overlapping {seed}" for seed in (1, 2, 3))],
)
@pytest.mark.parametrize("layer", Layer)
def test_corners_at_one_place_and_nets_that_overlap_themselves(layer, document, tmp_path):
    surface = configure(document)
    path = tmp_path / "a.step"
    format_for(path).write(surface, path, silent, ExportOptions(layer))
    face, patch = read(path), surface.layer_patch(layer)
    assert face.is_valid
    assert mesh_area(face, at_random(patch, 50)[2]) == pytest.approx(area(patch), rel=MESH_AREA)


def test_a_picture_of_the_step_file_by_another_program(tmp_path):
    """It stays in the tests' output, build/exported_step.png, to be looked at."""
    from matplotlib.image import imread

    pytest.importorskip("vtkmodules", reason="VTK is not installed")
    step, picture = tmp_path / "fig8.step", ROOT / "build" / "exported_step.png"
    picture.parent.mkdir(exist_ok=True)
    format_for(step).write(configure(preset("fig8").document), step, silent)
    script = [sys.executable, str(ROOT / "tests/support/vtk_picture.py"), str(step), str(picture)]
    done = subprocess.run(script, capture_output=True, text=True, check=False, timeout=120)
    if done.returncode != 0:
        pytest.skip(f"VTK cannot draw here: {done.stderr[-200:]}")
    drawn = imread(picture)
    covered = (drawn[..., :3] < 0.98).any(axis=-1)
    assert 0.1 < covered.mean() < 0.9
    assert np.unique((drawn[covered][:, :3] * 8).astype(int), axis=0).shape[0] > 20
