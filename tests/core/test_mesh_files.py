"""Meshes read back by trimesh, by meshio and, for GLB, by a strict reader."""

import json
from dataclasses import replace

import meshio
import numpy as np
import pytest
import trimesh

from qovr_core import FORMULATIONS, Formulation, Patch, configure
from qovr_core.colours import height_colours, linear
from qovr_core.errors import FileError
from qovr_core.files import ExportOptions, format_for, stl, tessellation
from qovr_core.files.mesh_grid import MeshGrid
from qovr_core.files.progress import silent
from qovr_core.files.qovr_document import document_from_json
from support.documents import random_document
from support.glb_reader import GlbFile
from support.obj_reader import ObjFile
from support.shapes import CLOSED, COLLAPSED, configured, of_degree, special

SUFFIXES = (".obj", ".stl", ".ply", ".glb")
Y_UP = (".obj", ".glb")
FLOAT32 = 2.0**-23


def export(surface, path, **options):
    format_for(path).write(surface, path, silent, ExportOptions(**options))
    return path


def diagonal(points):
    return float(np.linalg.norm(np.ptp(points.reshape(-1, 3), axis=0)))


def in_the_document(points, suffix):
    """Return points in the document's axes and unit."""
    if suffix not in Y_UP:
        return np.asarray(points, dtype=float)
    return np.stack([points[:, 0], -points[:, 2], points[:, 1]], axis=-1) * (1000 if suffix == ".glb" else 1)


def triangles_by_trimesh(path):
    """Return the corners (f, 3, 3) of all triangles."""
    read = trimesh.load(path, process=False, force="mesh")
    return in_the_document(read.vertices, path.suffix)[read.faces]


def triangles_by_another(path):
    if path.suffix == ".glb":
        read = GlbFile(path)
        return in_the_document(read.positions, path.suffix)[read.indices]
    if path.suffix == ".obj":
        read = ObjFile(path)
        return in_the_document(read.points, path.suffix)[read.faces]
    read = meshio.read(path)
    (cells,) = read.cells
    return np.asarray(read.points, dtype=float)[cells.data]


def expected_triangles(points):
    a, b, c, d = points[:-1, :-1], points[1:, :-1], points[1:, 1:], points[:-1, 1:]
    return np.stack([np.stack([a, b, c], axis=2), np.stack([a, c, d], axis=2)], axis=2).reshape(-1, 3, 3)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("reader", [triangles_by_trimesh, triangles_by_another])
@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_every_triangle_reads_back(suffix, reader, formulation, tmp_path):
    surface = configure(random_document(41, formulation, low=0.2, high=0.8, samples=(13, 8)))
    points = surface.raw if formulation is Formulation.INTERPOLATING else surface.transformed
    read = reader(export(surface, tmp_path / f"a{suffix}"))
    precision = 1e-15 if suffix in (".ply", ".obj") and reader is triangles_by_another else 4 * FLOAT32
    assert np.abs(read - expected_triangles(points)).max() <= precision * max(diagonal(points), np.abs(points).max())


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_the_raw_layer_on_request(suffix, tmp_path):
    surface = configure(random_document(42, Formulation.PUBLISHED, low=0.2, high=0.8))
    read = triangles_by_another(export(surface, tmp_path / f"a{suffix}", layer="raw"))
    assert np.abs(read - expected_triangles(surface.raw)).max() <= 8 * FLOAT32 * diagonal(surface.raw)


def test_obj_and_ply_lose_no_digit(tmp_path):
    surface = configured(43, 6, 4, 1e-3)
    points = surface.raw.reshape(-1, 3)
    assert np.array_equal(meshio.read(export(surface, tmp_path / "a.ply")).points, points)
    assert np.array_equal(meshio.read(export(surface, tmp_path / "a.obj", up="z")).points, points)
    x, y, z = points.T
    assert np.array_equal(meshio.read(export(surface, tmp_path / "b.obj")).points, np.stack([x, z, -y], axis=-1))


@pytest.mark.parametrize("suffix", [".obj", ".stl", ".ply"])
@pytest.mark.parametrize("up", ["y", "z"])
def test_either_axis_can_point_up(suffix, up, tmp_path):
    document = of_degree(47, 6, 6)
    surface = configure(replace(document, control_points=document.control_points + np.array([1e3, 2e3, 0])))
    path = export(surface, tmp_path / f"a{suffix}", up=up)
    turned = trimesh.load(path, process=False, force="mesh")
    x, y, z = np.moveaxis(expected_triangles(surface.raw), -1, 0)
    expected = np.stack([x, y, z] if up == "z" else [x, z, -y], axis=-1)
    if suffix == ".stl":
        expected += np.array([float(word) for word in path.read_bytes()[9:80].split(b";")[0].split()])
    read = np.asarray(turned.vertices, dtype=float)[turned.faces]
    assert np.abs(read - expected).max() <= (1e-4 if suffix == ".obj" else 4 * FLOAT32 * 2e3)
    normals = np.cross(*np.moveaxis(np.diff(read, axis=1), 1, 0))
    exact = np.cross(*np.moveaxis(np.diff(expected, axis=1), 1, 0))
    assert (np.einsum("ij,ij->i", normals, exact) > 0).all()


@pytest.mark.parametrize(("unit", "metres"), [("mm", 0.001), ("cm", 0.01), ("m", 1.0), ("in", 0.0254)])
def test_glb_is_scaled_to_metres_and_others_keep_the_numbers(unit, metres, tmp_path):
    surface = configured(50, 6, 6)
    x, y, z = surface.raw.reshape(-1, 3).T
    read = GlbFile(export(surface, tmp_path / "a.glb", unit=unit)).positions
    assert np.abs(read - np.stack([x, z, -y], axis=-1) * metres).max() <= FLOAT32 * diagonal(surface.raw) * metres
    for suffix in (".obj", ".stl", ".ply"):
        plain, other = (
            export(surface, tmp_path / f"{name}{suffix}", **kind) for name, kind in (("a", {}), ("b", {"unit": unit}))
        )
        assert plain.read_bytes() == other.read_bytes()


# --- normals and colours ----------------------------------------------------------------------------------------------


def vertex_normals(path):
    if path.suffix == ".glb":
        x, y, z = GlbFile(path).attribute("NORMAL").astype(float).T
        return np.stack([x, -z, y], axis=-1)
    if path.suffix == ".obj":
        x, y, z = ObjFile(path).normals.T
        return np.stack([x, -z, y], axis=-1)
    data = meshio.read(path).point_data
    return np.stack([data[f"n{axis}"] for axis in "xyz"], axis=-1)


@pytest.mark.parametrize("suffix", [".obj", ".ply", ".glb"])
@pytest.mark.parametrize("shape", ["plain", "v=0"])
def test_normals_are_those_of_the_patch(suffix, shape, tmp_path):
    document = of_degree(44, 6, 6, samples=(9, 6)) if shape == "plain" else special(shape)
    surface = configure(document)
    read = vertex_normals(export(surface, tmp_path / f"a{suffix}"))
    exact = surface.patch.normals(surface.u, surface.v).reshape(-1, 3)
    found = np.abs(read[:, None] - exact[None]).max(axis=-1).min(axis=1)
    assert found.max() <= 2e-7
    if shape == "plain":
        assert np.abs(read - exact).max() <= 2e-7


def test_facet_normals_of_stl(tmp_path):
    read = np.frombuffer(export(configured(45, 6, 6), tmp_path / "a.stl").read_bytes()[84:], stl._FACET)
    corners = read["points"].astype(float)
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    assert np.abs(read["normal"] - normals).max() < 1e-4
    assert not read["attribute"].any()


def test_colours_by_height(tmp_path):
    surface = configured(46, 6, 6)
    z = surface.raw[..., 2].ravel()
    jet = height_colours(z, z.min(), z.max())
    data = meshio.read(export(surface, tmp_path / "a.ply")).point_data
    read = np.stack([data[name] for name in ("red", "green", "blue")], axis=-1)
    read = read.astype(np.uint8)  # meshio takes uchar for signed
    assert np.abs(read / 255 - jet).max() <= 0.51 / 255
    colours = GlbFile(export(surface, tmp_path / "a.glb")).attribute("COLOR_0")
    assert np.abs(colours[:, :3] / 65535 - linear(jet)).max() <= 0.51 / 65535
    assert (colours[:, 3] == 65535).all()


def test_jet_is_matplotlibs_and_matlabs():
    from matplotlib import colormaps

    heights = np.linspace(0, 1, 256)
    assert np.abs(height_colours(heights, 0, 1) - colormaps["jet"](heights)[:, :3]).max() < 0.15  # its peaks differ
    assert height_colours(np.array([0, 0.375, 0.5, 1]), 0, 1).tolist() == [
        [0, 0, 0.5],
        [0, 1, 1],
        [0.5, 1, 0.5],
        [0.5, 0, 0],
    ]
    assert height_colours(np.array([3.0]), 3.0, 3.0).tolist() == [[0.5, 1, 0.5]]
    assert linear(np.array([0.0, 0.5, 1.0])) == pytest.approx([0, 0.21404114, 1])


# --- one closed index structure ---------------------------------------------------------------------------------------


def directed_edges(faces):
    """Return the edges of all faces in their direction, and how often each occurs."""
    edges = np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]])
    return np.unique(edges, axis=0, return_counts=True)


BOUNDARY_LOOPS = {"plain": 1, "v=0": 1, "u=0": 1, "v=0 and v=1": 1, "tube": 2, "torus": 0, "sphere": 0}


@pytest.mark.parametrize("shape", BOUNDARY_LOOPS)
def test_the_index_structure_is_closed_but_for_the_surface_s_own_boundary(shape, tmp_path):
    document = of_degree(47, 6, 6, samples=(9, 6)) if shape == "plain" else special(shape, samples=(9, 6))
    faces = ObjFile(export(configure(document), tmp_path / "a.obj")).faces
    directed, counts = directed_edges(faces)
    assert counts.max() == 1, "two neighbours run along an edge the same way"
    known = set(map(tuple, directed.tolist()))
    boundary = {a: b for a, b in known if (b, a) not in known}
    loops = 0
    while boundary:
        loops += 1
        start, place = boundary.popitem()
        while place != start:
            place = boundary.pop(place)
    assert loops == BOUNDARY_LOOPS[shape]
    used = np.unique(faces)
    assert np.array_equal(used, np.arange(len(used)))


@pytest.mark.parametrize("shape", [*COLLAPSED, *CLOSED])
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_special_surfaces_have_no_empty_triangle(shape, suffix, tmp_path):
    surface = configure(special(shape, samples=(9, 6)))
    triangles = triangles_by_another(export(surface, tmp_path / f"a{suffix}"))
    areas = np.linalg.norm(np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0]), axis=1)
    assert areas.min() > 1e-9 * diagonal(triangles) ** 2


def test_stl_of_a_torus_is_watertight(tmp_path):
    read = trimesh.load(export(configure(special("torus", samples=(30, 30))), tmp_path / "a.stl"))
    assert read.is_watertight
    assert read.is_winding_consistent


# --- digits -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".stl", ".glb"])
def test_a_surface_far_from_the_origin_keeps_its_digits(suffix, tmp_path):
    document = of_degree(48, 6, 6)
    far = np.array([1e6, -3e5, 2e7])
    surface = configure(replace(document, control_points=document.control_points + far))
    path = export(surface, tmp_path / f"a{suffix}")
    moved = np.zeros(3)
    if suffix == ".stl":
        header = path.read_bytes()[:80].decode("ascii")
        assert header.startswith("moved by ")
        moved = np.array([float(x) for x in header.removeprefix("moved by ").split(";")[0].split()])
    triangles = triangles_by_another(path) - moved
    assert np.abs(triangles - expected_triangles(surface.raw)).max() <= 2 * FLOAT32 * diagonal(surface.raw)


def test_a_surface_near_the_origin_stays_where_it_is(tmp_path):
    header = export(configured(49, 6, 6), tmp_path / "a.stl").read_bytes()[:80].decode("ascii")
    assert header.strip() == "QOVR Studio 0.1.0, formulation interpolating, raw surface"


def test_glb_is_metres_with_y_up(tmp_path):
    surface = configured(50, 6, 6)
    file = GlbFile(export(surface, tmp_path / "a.glb"))
    x, y, z = surface.raw.reshape(-1, 3).T
    assert np.abs(file.positions - np.stack([x, z, -y], axis=-1) / 1000).max() <= FLOAT32 * diagonal(surface.raw) / 1000
    box = file.attribute("POSITION")
    assert np.abs(box.max(axis=0) + box.min(axis=0)).max() <= FLOAT32 * diagonal(surface.raw) / 1000
    assert file.json["materials"][0]["doubleSided"] is True


# --- tolerance --------------------------------------------------------------------------------------------------------


def largest_distance(patch, triangles, samples=121):
    """Return the largest of the distances from points of the surface to the nearest triangle, and how they lie."""
    t = np.linspace(0, 1, samples)
    points = patch.points(t, t).reshape(-1, 3)
    target = trimesh.Trimesh(*merged(triangles), process=False)
    _, distances, _ = trimesh.proximity.closest_point_naive(target, points[::37])
    return float(distances.max())


def merged(triangles):
    vertices, inverse = np.unique(triangles.reshape(-1, 3), axis=0, return_inverse=True)
    return vertices, inverse.reshape(-1, 3)


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("tolerance", [0.05, 0.005])
def test_no_point_of_the_surface_is_farther_than_the_tolerance(suffix, tolerance, tmp_path):
    surface = configure(of_degree(51, 6, 4))
    triangles = triangles_by_another(export(surface, tmp_path / f"a{suffix}", tolerance=tolerance))
    assert largest_distance(surface.patch, triangles) <= tolerance


@pytest.mark.parametrize("seed", range(8))
def test_the_grid_is_fine_enough_and_not_wastefully_fine(seed):
    patch = configure(of_degree(60 + seed, 6, 6)).patch
    size = diagonal(patch.coefficients[0, 0])
    tolerance = 1e-4 * size
    grid = MeshGrid.of(tessellation.intervals_within(patch, tolerance), is_joined=True)
    n, m = grid.shape
    measured = tessellation.deviation(patch, grid, grid.points(patch))
    assert measured <= tolerance
    assert measured >= 0.3 * tolerance
    dense = 4
    fine = patch.points(np.linspace(0, 1, dense * (n - 1) + 1), np.linspace(0, 1, dense * (m - 1) + 1))
    assert interpolation_error(fine, dense) <= tolerance


def interpolation_error(fine, dense):
    """Return the largest distance between a fine grid and the triangles over every ``dense``-th point of it."""
    corners = fine[::dense, ::dense]
    a, b, c, d = corners[:-1, :-1], corners[1:, :-1], corners[1:, 1:], corners[:-1, 1:]
    largest = 0.0
    for i in range(dense + 1):
        for j in range(dense + 1):
            s, t = i / dense, j / dense
            flat = (1 - s) * a + (s - t) * b + t * c if s >= t else (1 - t) * a + (t - s) * d + s * c
            exact = fine[i::dense, j::dense][: flat.shape[0], : flat.shape[1]]
            largest = max(largest, float(np.linalg.norm(exact - flat, axis=-1).max()))
    return largest


def test_a_flat_bilinear_surface_needs_one_cell():
    a = np.linspace(0, 1, 7)
    flat = Patch(np.stack(np.broadcast_arrays(a[:, None], a[None, :], 0 * a[None, :]), axis=-1))
    grid = MeshGrid.of(tessellation.intervals_within(flat, 1e-3), is_joined=True)
    assert grid.shape == (2, 2)
    assert tessellation.deviation(flat, grid, grid.points(flat)) <= 1e-15


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_tolerance_that_cannot_be_met_is_refused_with_one_that_can(suffix, tmp_path):
    surface = configured(52, 6, 6)
    with pytest.raises(FileError, match=r"a tolerance of 1e-12 .*; expected at least (\S+)"):
        export(surface, tmp_path / f"a{suffix}", tolerance=1e-12)
    assert not list(tmp_path.iterdir())


# --- what every file says of itself -----------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_comments_hold_origin_tolerance_and_document(suffix, tmp_path):
    surface = configured(53, 4, 4)
    text = export(surface, tmp_path / f"a{suffix}", tolerance=0.01).read_bytes().decode("latin-1")
    mark = {".obj": "# ", ".ply": "comment "}[suffix]
    lines = [line.removeprefix(mark) for line in text.split("\n") if line.startswith(mark)]
    assert lines[0] == "QOVR Studio 0.1.0, formulation interpolating, raw surface"
    assert lines[1].startswith("largest distance from the surface 0.0")
    assert document_from_json("\n".join(lines[3:])) == surface.document
    assert max(map(len, lines)) < 1000  # some readers of PLY hold no longer line


def test_glb_extras_hold_origin_tolerance_and_document(tmp_path):
    surface = configured(54, 4, 4)
    extras = GlbFile(export(surface, tmp_path / "a.glb", tolerance=0.01)).json["asset"]["extras"]
    assert extras["origin"] == "QOVR Studio 0.1.0, formulation interpolating, raw surface"
    assert document_from_json(json.dumps(extras["document"])) == surface.document
    assert extras["tolerance"] == 0.01
    assert 0 < extras["deviation"] <= 0.01


# --- limits -----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("suffix", SUFFIXES)
@pytest.mark.parametrize("far", [0.0, 1e6])
def test_samples_without_area_are_refused_in_a_line(suffix, far, tmp_path):
    """The four corners, which alone are sampled, are one place or lie on one line; the surface between is a surface."""
    document = of_degree(55, 4, 4, samples=(2, 2))
    for corners in (np.full((2, 2), 2.0), np.array([[0.0, 1.0], [2.0, 3.0]])):
        points = document.control_points.copy()
        points[1:4:2, 1:4:2] = corners[..., None] * np.array([1.0, 2.0, 0.5])
        surface = configure(replace(document, control_points=points + far))
        with pytest.raises(FileError, match=r"at 2 x 2 samples the mesh has no area; expected more samples"):
            export(surface, tmp_path / f"a{suffix}")
    assert not list(tmp_path.iterdir())
    export(configure(replace(surface.document, samples=(9, 9))), tmp_path / f"a{suffix}")


@pytest.mark.parametrize("size", [1e-300, 1e-40])
def test_what_32_bits_cannot_hold_is_refused(size, tmp_path):
    surface = configure(of_degree(56, 6, 6, size))
    for suffix in (".stl", ".glb"):
        with pytest.raises(FileError, match="across; expected 1e-30 to 1e"):
            export(surface, tmp_path / f"a{suffix}")
    assert not list(tmp_path.iterdir())
    export(surface, tmp_path / "a.ply")
    assert np.isfinite(meshio.read(tmp_path / "a.ply").points).all()
