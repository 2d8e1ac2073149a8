"""``.npz`` and ``.mat``: what they hold, the document read back from them, and what is refused."""

import shutil
import subprocess
import zipfile
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from scipy.io import loadmat, savemat, whosmat

from qovr_core import FORMULATIONS, FileError, configure
from qovr_core.files import format_for, read_source
from qovr_core.files.npz_arrays import surface_arrays
from qovr_core.files.progress import silent
from qovr_core.files.workbook_read import read_published_numbers
from qovr_core.reproduce import reproduce
from support.command import qovr, refused
from support.documents import documents, random_document

WHOLE = (".npz", ".mat", ".3dm", ".xlsx", ".qovr")


def export(surface, path):
    format_for(path).write(surface, path, silent)
    return path


@pytest.mark.parametrize("suffix", WHOLE)
@given(document=documents(samples=(3, 2)))
@settings(max_examples=10, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_a_whole_document_reads_back_to_the_last_bit(suffix, tmp_path, document):
    again = read_source(str(export(configure(document), tmp_path / f"a{suffix}")))
    assert again == document
    assert again.control_points.tobytes() == document.control_points.tobytes()


def test_a_number_edited_in_a_workbook_counts(tmp_path):
    import openpyxl

    path = export(configure(random_document(1)), tmp_path / "a.xlsx")
    book = openpyxl.load_workbook(path)
    book.worksheets[0]["G7"].value = 0.25
    book.save(path)
    assert read_source(str(path)).control_points[0, 2, 2] == 0.25


@pytest.mark.parametrize("size", [1e-9, 1e-5, 1.0, 1e5, 1e11])
@pytest.mark.parametrize("far", [0.0, 3e5])
def test_what_was_written_into_a_workbook_is_recognised(size, far, tmp_path, caplog):
    for formulation in FORMULATIONS.values():
        document = random_document(18, formulation, low=0.3, high=0.7)
        document = replace(document, control_points=size * document.control_points + far)
        if np.abs(configure(document).raw).max() > 1e12:
            with pytest.raises(FileError, match=r"the raw coordinates reach .* expected at most 1e"):
                export(configure(document), tmp_path / "a.xlsx")
            assert list(tmp_path.iterdir()) == []
            continue
        caplog.clear()
        path = export(configure(document), tmp_path / "a.xlsx")
        assert formulation in reproduce(path).met_by
        published = read_published_numbers(path)
        steps = np.ptp(configure(document).transformed.reshape(-1, 3), axis=0) / 1000 + 1e-15 * far
        assert (np.abs(published.transformed - configure(document).transformed).max(axis=(0, 1)) <= steps).all()
        assert any("decimals" in message for message in caplog.messages) == (size < 1e-3)
        path.unlink()


def test_another_surface_is_not_recognised(tmp_path):
    document = random_document(18, low=0.3, high=0.7)
    path = export(configure(document), tmp_path / "a.xlsx")
    assert [str(formulation) for formulation in reproduce(path).met_by] == ["interpolating"]


def test_mat_holds_every_array_under_its_name(tmp_path):
    surface = configure(random_document(14))
    path = export(surface, tmp_path / "a.mat")
    shapes = {name: shape for name, shape, _ in whosmat(path)}
    assert shapes == {
        "control_points": (5, 5, 3),
        "row_knots": (5, 4),
        "column_knots": (5, 4),
        "u": (7, 1),
        "v": (5, 1),
        "raw": (7, 5, 3),
        "transformed": (7, 5, 3),
        "control_box": (3, 2),
        "raw_box": (3, 2),
        "matrix": (4, 4),
        "formulation": (1,),
        "program": (1,),
    }
    read = loadmat(path)
    for name, array in surface_arrays(surface).items():
        if not isinstance(array, str):
            assert np.array_equal(read[name].reshape(array.shape), array)
            assert read[name].dtype == np.float64
    assert read["formulation"].tolist() == ["interpolating"]
    assert read["program"][0].startswith("QOVR Studio ")


@pytest.mark.parametrize("compressed", [False, True])
def test_a_file_that_another_program_saved_is_read(compressed, tmp_path):
    """MATLAB compresses by default, and keeps whole numbers in bytes."""
    document = random_document(17)
    arrays = surface_arrays(configure(document)) | {"extra": np.arange(1e5), "other": [{"a": 1}]}
    arrays["control_points"] = np.arange(75, dtype=np.uint8).reshape(5, 5, 3)
    savemat(tmp_path / "a.mat", arrays, do_compression=compressed)
    again = read_source(str(tmp_path / "a.mat"))
    assert again.row_knots == document.row_knots
    assert again.control_points[1, 2].tolist() == [21, 22, 23]


@pytest.mark.skipif(not shutil.which("octave-cli"), reason="GNU Octave is not installed")
def test_octave_reads_mat(tmp_path):
    surface = configure(random_document(15))
    export(surface, tmp_path / "a.mat")
    script = "load a.mat; printf('%s %d %d %d %.17g %.17g', formulation, size(raw), raw(3,2,1), row_knots(4,2))"
    done = subprocess.run(
        ["octave-cli", "--norc", "--eval", script], cwd=tmp_path, capture_output=True, text=True, check=True
    )
    name, *numbers = done.stdout.split()
    assert name == "interpolating"
    assert list(map(float, numbers)) == [7, 5, 3, surface.raw[2, 1, 0], surface.document.row_knots[3, 0].s]


# --- what is refused --------------------------------------------------------------------------------------------------


def saved(path, arrays):
    if path.suffix == ".npz":
        np.savez(path, **arrays)
    else:
        savemat(path, arrays, oned_as="column")


def net_with(value):
    net = np.array(random_document(1).control_points)
    net[3, 1, 2] = value
    return net


def knots_with(value):
    knots = np.full((5, 4), 0.5)
    knots[2, 1] = value
    return knots


BAD_ARRAYS = {
    "no net": ({"control_points": None}, "control_points is missing; expected the arrays control_points"),
    "no formulation": ({"formulation": None}, "formulation is missing"),
    "a flat net": (
        {"control_points": np.zeros((25, 3))},
        "control_points is float64 in 25 x 3; expected numbers in 5 x 5 x 3, or more rows and columns",
    ),
    "a net of text": ({"control_points": np.full((5, 5, 3), "a")}, "expected numbers in 5 x 5 x 3"),
    "complex numbers": ({"row_knots": np.full((5, 4), 0.5j)}, "; expected numbers in 5 x 4"),
    "no number": ({"control_points": net_with(np.nan)}, "control_points[3][1][2] is nan; expected a finite number"),
    "an absurd number": ({"control_points": net_with(1e13)}, "control_points[3][1][2] is 10000000000000.0"),
    "a knot of 1": (
        {"row_knots": knots_with(1.0)},
        "row_knots[2][1] is 1.0; expected a number strictly between 0 and 1",
    ),
    "a formulation": ({"formulation": "tensor"}, "formulation is 'tensor'; expected one of published"),
    "a number for a formulation": ({"formulation": np.eye(2)}, "formulation is "),
    "one sample": ({"u": np.zeros(1)}, "samples[0] is 1; expected a whole number from 2 to 4096"),
}


@pytest.mark.parametrize("name", BAD_ARRAYS)
@pytest.mark.parametrize("suffix", [".npz", ".mat"])
def test_bad_arrays(name, suffix, tmp_path):
    changes, message = BAD_ARRAYS[name]
    arrays = {**surface_arrays(configure(random_document(1))), **changes}
    path = tmp_path / f"bad{suffix}"
    saved(path, {key: value for key, value in arrays.items() if value is not None})
    with pytest.raises(FileError) as caught:
        read_source(str(path))
    assert str(caught.value).startswith(f"{path}: ")
    assert message in str(caught.value)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize("suffix", [".npz", ".mat", ".3dm"])
@pytest.mark.parametrize("content", [b"", b"rubbish", b"\0" * 300, bytes(range(256)) * 40, b"PK\3\4" + b"x" * 99])
def test_rubbish_is_refused_in_one_line(suffix, content, tmp_path):
    (tmp_path / f"bad{suffix}").write_bytes(content)
    refused(qovr("info", f"bad{suffix}", cwd=tmp_path))


@pytest.mark.parametrize("suffix", [".npz", ".mat", ".3dm"])
def test_a_damaged_file_is_refused_or_whole(suffix, tmp_path):
    document = random_document(16)
    whole = export(configure(document), tmp_path / f"a{suffix}").read_bytes()
    rng = np.random.default_rng(0)
    path = tmp_path / f"bad{suffix}"
    for _ in range(60):
        damaged = bytearray(whole[: rng.integers(1, len(whole))] if rng.random() < 0.3 else whole)
        for place in rng.integers(0, min(len(damaged), 3000), 3):
            damaged[place] = rng.integers(256)
        path.write_bytes(damaged)
        message = refusal(path)
        assert "\n" not in message


def refusal(path):
    """Return why a file is refused; empty where it is read."""
    try:
        read_source(str(path))
    except FileError as error:
        return str(error)
    return ""


def test_objects_are_never_unpickled(tmp_path):
    arrays = surface_arrays(configure(random_document(1)))
    np.savez(tmp_path / "bad.npz", **{**arrays, "formulation": np.array({"a": 1}, dtype=object)}, allow_pickle=True)
    with pytest.raises(FileError, match="is no whole NumPy archive: Object arrays cannot be loaded"):
        read_source(str(tmp_path / "bad.npz"))


def test_an_array_that_unpacks_to_far_too_much_is_refused_unread(tmp_path):
    with zipfile.ZipFile(tmp_path / "bad.npz", "w", zipfile.ZIP_DEFLATED) as archive:
        archive.writestr("control_points.npy", b"\0" * 10_000_000)
    with pytest.raises(FileError, match="control_points is 10,000,000 bytes long; expected at most 1,000,000"):
        read_source(str(tmp_path / "bad.npz"))


def test_a_matlab_7_3_file_is_named_as_such(tmp_path):
    header = b"MATLAB 7.3 MAT-file".ljust(124) + b"\x00\x02IM"
    (tmp_path / "a.mat").write_bytes(header + b"\0" * 512)
    with pytest.raises(
        FileError, match=r"a\.mat: cannot be read: its version is 7\.3; expected one saved as -v7 or older"
    ):
        read_source(str(tmp_path / "a.mat"))


@pytest.mark.parametrize("suffix", [".npz", ".mat", ".3dm"])
def test_a_missing_file(suffix, tmp_path):
    with pytest.raises(FileError, match="cannot be read: No such file or directory"):
        read_source(str(tmp_path / f"a{suffix}"))
