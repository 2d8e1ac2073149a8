"""STEP and IGES as the kernel that most CAD programs share reads them: one valid face, exact, of the right area."""

import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from qovr_core import configure
from qovr_core.files import ExportOptions, format_for
from qovr_core.files.progress import silent
from qovr_core.layer import Layer
from qovr_core.presets import preset
from support.documents import random_net
from support.opencascade import area, read
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


def read_one(path):
    model = read(path)
    assert model.is_valid
    assert model.roots == 1
    (face,) = model.faces
    return face


def check(document, path, degree):
    surface = configure(document)
    format_for(path).write(surface, path, silent)
    face = read_one(path)
    parameters, points, extent = at_random(surface.patch)
    assert (face.surface.UDegree(), face.surface.VDegree()) == degree
    assert np.abs(face(parameters) - points).max() <= EXACT * extent
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
    face = read_one(path)
    assert np.abs(face(parameters) / millimetres - points).max() <= EXACT * extent


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
    face, patch = read_one(path), surface.layer_patch(layer)
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
