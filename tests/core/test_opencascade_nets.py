"""Nets in STEP and IGES as OpenCASCADE reads them: valid faces, one for each smooth part, sewn, and exact."""

import math

import pytest

from qovr_core import Evaluation
from qovr_core.files import ExportOptions, format_for
from qovr_core.files.progress import silent
from support.net_documents import NETS, check_exact, net_of, part_counts, random_net
from support.opencascade import area, read

pytestmark = pytest.mark.slow
pytest.importorskip("OCP", reason="OpenCASCADE is not installed: pip install --group cad")

AREA = 0.02
"""OpenCASCADE's quadrature is that coarse; a wrong boundary would give half or none of it."""


def write(document, path, **options):
    evaluation = Evaluation(document)
    format_for(path).write(evaluation, path, silent, ExportOptions(**options))
    return evaluation.patch


@pytest.mark.parametrize("suffix", [".step", ".iges"])
@pytest.mark.parametrize("single_face", [False, True])
@pytest.mark.parametrize("name", NETS)
def test_parts_are_valid_faces(suffix, single_face, name, tmp_path):
    """OpenCASCADE leaves a face whole whose surface has sharp joints inside, in IGES as in STEP."""
    document, path = net_of(name), tmp_path / f"a{suffix}"
    patch = write(document, path, single_face=single_face)
    model = read(path)
    assert model.is_valid
    assert len(model.faces) == (1 if single_face else math.prod(part_counts(document)))
    check_exact(model.faces, patch)
    windows = [patch.window(a, b) for a in range(patch.windows[0]) for b in range(patch.windows[1])]
    assert sum(face.area for face in model.faces) == pytest.approx(sum(map(area, windows)), rel=AREA)


@pytest.mark.parametrize("name", NETS)
def test_step_parts_share_their_edges(name, tmp_path):
    document = net_of(name)
    write(document, tmp_path / "a.step")
    model = read(tmp_path / "a.step")
    along_u, along_v = part_counts(document)
    lines_u, lines_v = along_u + ("u" not in document.closed), along_v + ("v" not in document.closed)
    assert (model.roots, model.shells) == (1, 1)
    assert model.edges == lines_u * along_v + lines_v * along_u
    assert model.vertices == lines_u * lines_v


def test_windows_with_gaps_are_shells_of_their_own(tmp_path):
    document = random_net(3, 2, 3, formulation="published")
    write(document, tmp_path / "a.step")
    model = read(tmp_path / "a.step")
    assert model.is_valid
    assert (len(model.faces), model.shells, model.edges) == (6, 6, 24)


def test_a_large_net_is_read(tmp_path):
    """The document is longer than any string that OpenCASCADE reads, and is cut."""
    document = random_net(5, 20, 20)
    patch = write(document, tmp_path / "a.step")
    model = read(tmp_path / "a.step")
    assert model.is_valid
    assert len(model.faces) == 1
    check_exact(model.faces, patch)
