"""Every writer against the bare library doing the same write, both to a file that has reached the disk."""

import os
import tracemalloc

import numpy as np
import pytest
import trimesh
from scipy.io import savemat

from qovr_core import Formulation, configure
from qovr_core.files import format_for
from qovr_core.files.npz_arrays import surface_arrays
from qovr_core.files.progress import silent
from support.documents import random_document

from .goals import WRITERS

SIZE = 501
LARGE = 1001
SMALL = 101


def surface(size):
    return configure(random_document(1, Formulation.INTERPOLATING, samples=(size, size), low=0.3, high=0.7))


def bare_mesh(result):
    """Return the mesh with exact normals, and colours that cost nothing to compute."""
    n, m = result.raw.shape[:2]
    index = np.arange(n * m).reshape(n, m)
    a, b, c, d = (part.ravel() for part in (index[:-1, :-1], index[1:, :-1], index[1:, 1:], index[:-1, 1:]))
    faces = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    colours = np.full((n * m, 4), 200, dtype=np.uint8)
    return trimesh.Trimesh(
        result.raw.reshape(-1, 3),
        faces,
        vertex_normals=result.patch.normals(result.u, result.v).reshape(-1, 3),
        vertex_colors=colours,
        process=False,
    )


OPTIONS = {".obj": {"include_normals": True, "include_color": False, "digits": 17}, ".ply": {"vertex_normal": True}}


def bare_write(path, result):
    """Write the same with the library alone."""
    if path.suffix == ".npz":
        np.savez(path, **surface_arrays(result))
    elif path.suffix == ".mat":
        savemat(path, surface_arrays(result), oned_as="column")
    else:
        bare_mesh(result).export(path, **OPTIONS.get(path.suffix, {}))
    with path.open("rb+") as file:
        os.fsync(file.fileno())


@pytest.mark.parametrize("suffix", WRITERS)
def test_writer(measure, suffix, tmp_path):
    result, ours, theirs = surface(SIZE), tmp_path / f"ours{suffix}", tmp_path / f"theirs{suffix}"
    write = format_for(ours).write
    measure(f"write {suffix}", lambda: write(result, ours, silent), lambda: bare_write(theirs, result), rounds=3)


def bare_3dm(path, points):
    """Write the surface alone with rhino3dm."""
    import rhino3dm

    model = rhino3dm.File3dm()
    order = len(points)
    bare = rhino3dm.NurbsSurface.Create(3, False, order, order, order, order)
    for i in range(order):
        for j in range(order):
            bare.Points[i, j] = rhino3dm.Point4d(*points[i, j].tolist(), 1.0)
    for knots in (bare.KnotsU, bare.KnotsV):
        for k in range(2 * order - 2):
            knots[k] = float(k >= order - 1)
    model.Objects.AddSurface(bare)
    assert model.Write(str(path), 8)


@pytest.mark.parametrize("suffix", [".step", ".iges", ".3dm"])
def test_cad_writer(measure, suffix, tmp_path):
    result, path = surface(SMALL), tmp_path / f"a{suffix}"
    bare = lambda: bare_3dm(tmp_path / "bare.3dm", result.patch.coefficients[0, 0])  # noqa: E731
    measure(f"write {suffix}", lambda: format_for(path).write(result, path, silent), bare)


@pytest.mark.parametrize("suffix", [".ply", ".glb"])
def test_large_mesh(measure, record, suffix, tmp_path):
    result, path = surface(LARGE), tmp_path / f"a{suffix}"
    write = lambda: format_for(path).write(result, path, silent)  # noqa: E731
    measure(f"write large {suffix}", write, rounds=2)
    tracemalloc.start()
    write()
    peak = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    record(f"memory {suffix}", [peak / 1e6])
