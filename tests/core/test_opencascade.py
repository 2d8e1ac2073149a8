"""STEP and IGES as the kernel that most CAD programs share reads them: one valid face, exact, of the right area."""

import subprocess
import sys
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest

from qovr_core import configure
from qovr_core.files import format_for
from qovr_core.files.progress import silent
from qovr_core.presets import preset
from support.shapes import CLOSED, COLLAPSED, at_random, of_degree, special

pytestmark = pytest.mark.slow
pytest.importorskip("OCP", reason="OpenCASCADE is not installed: pip install --group cad")

ROOT = Path(__file__).resolve().parents[2]
DEGREES = ((4, 4), (4, 6), (6, 4), (6, 6))
SIZES = (1e-3, 1.0, 1e5)
EXACT = 1e-12
AREA = 0.02
"""OpenCASCADE's quadrature is that coarse on surfaces that fold; a wrong boundary would give half or none of it."""


@dataclass
class Face:
    """The one face of a file."""

    is_valid: bool
    surface: object
    area: float

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
    return Face(BRepCheck_Analyzer(shape).IsValid(), BRep_Tool.Surface_s(face), properties.Mass())


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
