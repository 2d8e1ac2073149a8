"""Meshes of nets of many windows, read back by trimesh, by meshio and by strict readers of OBJ and GLB."""

import json
import re
from dataclasses import replace

import meshio
import numpy as np
import pytest
import trimesh
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from qovr_core import Document, Evaluation, FileError, Formulation
from qovr_core.edits import extract_window
from qovr_core.files import ExportOptions, export, tessellation
from qovr_core.files.mesh_grid import MeshGrid
from qovr_core.files.qovr_document import document_from_json
from qovr_core.joints import Joint
from support.glb_reader import GlbFile
from support.net_documents import NETS, net_of, random_net
from support.nets import random_net_document
from support.obj_reader import ObjFile

SUFFIXES = (".obj", ".stl", ".ply", ".glb")
FLOAT32 = 2.0**-23


def written(document, path, **options):
    export(document, path, ExportOptions(**options))
    return path


def in_the_document(points, suffix):
    """Return points in the document's axes and unit."""
    points = np.asarray(points, dtype=float)
    if suffix not in (".obj", ".glb"):
        return points
    return np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=-1) * (1000 if suffix == ".glb" else 1)


def read(path):
    """Return points and triangles; where a vertex has one normal, as many points as normals."""
    if path.suffix == ".glb":
        file = GlbFile(path)
        return in_the_document(file.positions, path.suffix), file.indices
    if path.suffix == ".obj":  # meshio's reader wants as many points as normals
        file = ObjFile(path)
        return in_the_document(file.points, path.suffix), file.faces
    mesh = meshio.read(path)
    (cells,) = mesh.cells
    return in_the_document(mesh.points, path.suffix), cells.data


def triangles_by_trimesh(path):
    mesh = trimesh.load(path, process=False, force="mesh")
    return in_the_document(mesh.vertices, path.suffix)[mesh.faces]


def triangles_by_another(path):
    points, faces = read(path)
    return points[faces]


def expected_triangles(document):
    """Return the triangles of all windows, each evaluated alone, (f, 3, 3)."""
    m, n = document.windows
    windows = (Evaluation(extract_window(document, (a, b))).raw for b in range(n) for a in range(m))
    return np.concatenate([triangles_of(points) for points in windows])


def triangles_of(points):
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2).reshape(-1, 3, 3)


@pytest.mark.parametrize("reader", [triangles_by_trimesh, triangles_by_another])
@pytest.mark.parametrize("suffix", SUFFIXES)
@given(
    seed=st.integers(0, 1000),
    windows=st.tuples(st.integers(1, 3), st.integers(1, 4)),
    formulation=st.sampled_from(list(Formulation.table.values())),
    smooth=st.sampled_from([0.0, 0.5, 1.0]),
)
@settings(max_examples=8, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_every_triangle_reads_back(suffix, reader, seed, windows, formulation, smooth, tmp_path):
    document = random_net_document(seed, windows, formulation=formulation, smooth=smooth, samples=(14, 11), margin=0.3)
    found = reader(written(document, tmp_path / f"a{suffix}", layer="raw"))
    expected = expected_triangles(document)
    assert found.shape == expected.shape
    assert np.abs(found - expected).max() <= 8 * FLOAT32 * np.abs(expected).max()


@pytest.mark.parametrize("name", NETS)
def test_one_mesh_of_a_net_that_is_continuous(name, tmp_path):
    document = net_of(name, samples=(41, 31))
    mesh = trimesh.load(written(document, tmp_path / "a.ply"), process=False)
    welded = trimesh.Trimesh(*merged(mesh.triangles), process=False)
    assert len(welded.faces) == 2 * 40 * 30
    assert welded.body_count == 1
    assert welded.is_winding_consistent
    assert welded.is_watertight == (len(document.closed) == 2)
    assert welded.euler_number == (0 if document.closed else 1)
    assert len(welded.vertices) == (41 - ("u" in document.closed)) * (31 - ("v" in document.closed))
    assert welded.area_faces.min() > 0


def merged(triangles):
    vertices, inverse = np.unique(np.asarray(triangles).reshape(-1, 3), axis=0, return_inverse=True)
    return vertices, inverse.reshape(-1, 3)


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".glb"])
def test_only_creases_have_two_normals(suffix, tmp_path):
    """A vertex on a sharp joint has the normals of both its windows, one anywhere else a single one."""
    document = random_net(5, 3, 4, sharp_u={1}, sharp_v={0}, samples=(41, 31))
    points, normals = vertices_with_normals(written(document, tmp_path / f"a{suffix}"))
    m, n = document.windows
    patch = Evaluation(document).patch
    count = 0
    for a in range(m):
        for b in range(n):
            window = patch.window(a, b)
            u, v = (np.linspace(0, 1, k + 1) for k in (10, 10))
            exact, there = window.normals(u, v).reshape(-1, 3), window.points(u, v).reshape(-1, 3)
            distance = np.abs(points[:, None] - there[None]).max(axis=-1)
            for k in range(len(there)):
                own = normals[distance[:, k] < 1e-5 * np.abs(points).max()]
                assert np.abs(own - exact[k]).max(axis=-1).min() <= 1e-5
            count += len(there)
    single = 41 * 31
    on_creases = 31 + 41 + 1  # the place where the creases cross has four
    assert len(normals) == single + on_creases


def vertices_with_normals(path):
    """Return the places and the normals of all normals."""
    if path.suffix == ".glb":
        file = GlbFile(path)
        x, y, z = file.attribute("NORMAL").astype(float).T
        return in_the_document(file.positions, ".glb"), np.stack([x, -z, y], axis=-1)
    if path.suffix == ".obj":
        file = ObjFile(path)
        places = np.empty(len(file.normals), dtype=int)
        places[file.corners] = file.faces
        return in_the_document(file.points[places], ".obj"), in_the_document(file.normals, ".obj")
    mesh = meshio.read(path)
    return np.asarray(mesh.points), np.stack([mesh.point_data[f"n{axis}"] for axis in "xyz"], axis=-1)


@pytest.mark.parametrize(
    ("name", "normals"),
    [
        ("tube", 40 * 31),
        ("tube with a sharp seam", 41 * 31),
        ("torus", 40 * 30),
        ("torus of parts", 41 * 32),
    ],
)
def test_seams_have_two_normals_where_they_are_sharp(name, normals, tmp_path):
    document = net_of(name, samples=(41, 31))
    assert len(vertices_with_normals(written(document, tmp_path / "a.ply"))[1]) == normals


def test_where_windows_meet_in_a_point_normals_are_limits_within_each(tmp_path):
    """The joint between two rows of windows is one point, as the waist of an hourglass."""
    document = random_net(3, 2, 2, sharp_v={0}, samples=(13, 11))
    net = document.control_points.copy()
    net[3] = waist = [3.0, 3.0, 1.0]
    document = replace(document, control_points=net)
    points, normals = vertices_with_normals(written(document, tmp_path / "a.ply"))
    found = normals[np.abs(points - waist).max(axis=-1) <= 1e-9]
    alone = [Evaluation(extract_window(document, window)).patch for window in np.ndindex(2, 2)]
    ends = (patch.normals(np.linspace(0, 1, 7), [1 - a]) for patch, (a, _) in zip(alone, np.ndindex(2, 2), strict=True))
    exact = np.concatenate([each[:, 0] for each in ends])
    assert len(found) >= 20
    assert np.abs(found[:, None] - exact).max(axis=-1).min(axis=1).max() <= 1e-6


def test_a_smooth_net_has_one_normal_a_point(tmp_path):
    document = random_net(6, 4, 5, samples=(61, 41))
    assert len(vertices_with_normals(written(document, tmp_path / "a.ply"))[1]) == 61 * 41


def test_a_sharp_joint_of_a_flat_net_shows_no_crease(tmp_path):
    rng = np.random.default_rng(1)
    net = np.stack([*np.meshgrid(np.arange(9.0), np.arange(7.0)), np.zeros((7, 9))], axis=-1)
    document = Document(net, rng.uniform(0.45, 0.55, (7, 3, 4)), formulation="interpolating", samples=(31, 21))
    assert Joint.SMOOTH not in document.joints.u
    assert len(vertices_with_normals(written(document, tmp_path / "a.ply"))[1]) == 31 * 21


@pytest.mark.parametrize("formulation", [Formulation.PUBLISHED, Formulation.DOUBLE_SUM], ids=str)
@pytest.mark.parametrize("options", [{}, {"tolerance": 0.5}], ids=["samples", "tolerance"])
def test_where_windows_do_not_meet_each_has_a_mesh_of_its_own(formulation, options, tmp_path):
    document = random_net_document(2, (2, 3), formulation=formulation, samples=(31, 21))
    points, faces = read(written(document, tmp_path / "a.ply", **options))
    mesh = trimesh.Trimesh(points, faces, process=False)
    assert mesh.body_count == 6
    assert mesh.euler_number == 6
    if not options:
        assert len(points) == (31 + 2) * (21 + 1)


def net_with_pole(samples=(25, 19)):
    """A net whose edge v = 0 is one point, as the top of a dome."""
    document = random_net(3, 2, 3, samples=samples)
    net = document.control_points.copy()
    net[1] = [4.0, 0.5, 1.0]
    return replace(document, control_points=net)


def test_an_edge_that_is_one_point_is_one_vertex(tmp_path):
    document = net_with_pole()
    mesh = trimesh.load(written(document, tmp_path / "a.ply"), process=False)
    welded = trimesh.Trimesh(*merged(mesh.triangles), process=False)
    assert welded.euler_number == 1
    assert len(welded.vertices) == 25 * 19 - 24
    assert len(welded.faces) == 2 * 24 * 18 - 24
    assert welded.area_faces.min() > 0


# --- tolerance --------------------------------------------------------------------------------------------------------


def interpolation_error(window, along_u, along_v, dense=6):
    """Return the largest distance between a patch and the triangles of its cells, at many places in each of them."""
    fine = window.points(*(np.linspace(0, 1, dense * count + 1) for count in (along_u, along_v)))
    corners = fine[::dense, ::dense]
    a, b, c, d = corners[:-1, :-1], corners[1:, :-1], corners[1:, 1:], corners[:-1, 1:]
    largest = 0.0
    for i, j in np.ndindex(dense + 1, dense + 1):
        s, t = i / dense, j / dense
        flat = (1 - s) * a + (s - t) * b + t * c if s >= t else (1 - t) * a + (t - s) * d + s * c
        exact = fine[i::dense, j::dense][: flat.shape[0], : flat.shape[1]]
        largest = max(largest, float(np.linalg.norm(exact - flat, axis=-1).max()))
    return largest


@given(seed=st.integers(0, 1000), part=st.sampled_from([1e-2, 1e-3, 2e-4]))
@settings(max_examples=12)
def test_windows_are_as_fine_as_the_tolerance_needs_and_not_wastefully_fine(seed, part):
    document = random_net_document(seed, (2, 3), smooth=0.5, margin=0.3, flatness=0.6)
    patch = Evaluation(document).patch
    tolerance = part * float(np.linalg.norm(np.ptp(patch.coefficients.reshape(-1, 3), axis=0)))
    along_u, along_v = tessellation.intervals_within(patch, tolerance)
    grid = MeshGrid.of((along_u, along_v), is_joined=True)
    measured = tessellation.deviation(patch, grid, grid.points(patch))
    errors = [interpolation_error(patch.window(a, b), along_u[b], along_v[a]) for a in range(2) for b in range(3)]
    assert measured <= max(errors) * (1 + 1e-9) + 1e-12
    assert max(errors) <= tolerance
    if part < 1e-2:
        assert measured >= 0.15 * tolerance


def test_a_window_that_bends_more_is_finer():
    net = np.stack([*np.meshgrid(np.arange(11.0), np.arange(5.0)), np.zeros((5, 11))], axis=-1)
    net[:, 8, 2] = 1.0
    patch = Evaluation(Document(net, formulation="interpolating")).patch
    along_u, along_v = tessellation.intervals_within(patch, 1e-3)
    assert along_u[0] == 1
    assert along_u[3] > 10 * along_u[0]
    assert along_v.tolist() == [1]


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_no_point_is_farther_than_the_tolerance(suffix, tmp_path):
    document = random_net(8, 2, 3, sharp_u={1})
    triangles = triangles_by_another(written(document, tmp_path / f"a{suffix}", tolerance=0.02))
    patch = Evaluation(document).patch
    points = patch.points(*(np.linspace(*ends, 25) for ends in patch.domain)).reshape(-1, 3)
    target = trimesh.Trimesh(*merged(triangles), process=False)
    assert target.body_count == 1
    assert trimesh.proximity.closest_point_naive(target, points)[1].max() <= 0.02


@pytest.mark.parametrize("windows", [(1, 2), (2, 3), (5, 1)])
def test_a_tolerance_that_cannot_be_met_is_refused_with_one_that_can(windows, tmp_path):
    document = random_net_document(3, windows, margin=0.35)
    with pytest.raises(FileError, match=r"a tolerance of 1e-12 needs more .*; expected at least (\S+)") as refused:
        export(document, tmp_path / "a.ply", ExportOptions(tolerance=1e-12))
    proposed = float(re.search(r"at least (\S+)", str(refused.value))[1])
    along_u, along_v = tessellation.intervals_within(Evaluation(document).patch, proposed)
    assert max(along_u.sum(), along_v.sum()) <= 4095
    assert max(along_u.sum(), along_v.sum()) >= 3000


# --- what files say of themselves -------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_the_document_stands_in_short_comments(suffix, tmp_path):
    document = random_net_document(2, (2, 60), samples=(121, 9))
    text = written(document, tmp_path / f"a{suffix}").read_bytes().decode("latin-1")
    mark = {".obj": "# ", ".ply": "comment "}[suffix]
    lines = [line.removeprefix(mark) for line in text.split("\n") if line.startswith(mark)]
    assert max(map(len, lines)) < 1000
    assert document_from_json("\n".join(lines[2:])) == document


def test_glb_holds_the_document(tmp_path):
    document = random_net_document(2, (2, 3))
    extras = GlbFile(written(document, tmp_path / "a.glb")).json["asset"]["extras"]
    assert document_from_json(json.dumps(extras["document"])) == document
