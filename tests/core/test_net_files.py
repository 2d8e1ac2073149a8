"""Files of nets of many windows: read back to the last bit, by this program and by NumPy and SciPy, or refused."""

import csv
import json
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.io import loadmat, savemat

from qovr_core import FORMULATIONS, Document, Evaluation, FileError
from qovr_core.files import export, read_source
from qovr_core.files.npz_arrays import surface_arrays
from qovr_core.files.qovr_document import document_from_json, document_to_json
from qovr_core.joints import Joint
from support.nets import closed_net, random_net_document

ARRAYS = (".npz", ".mat")


@st.composite
def nets(draw):
    """Draw a net with smooth and sharp joints, closed or not, under any formulation."""
    seed, windows = draw(st.integers(0, 10_000)), draw(st.tuples(st.integers(1, 4), st.integers(1, 4)))
    formulation = draw(st.sampled_from(list(FORMULATIONS.values())))
    along = [name for name, count in zip("vu", windows, strict=True) if count > 1 and draw(st.booleans())]
    if along:
        return replace(closed_net(seed, windows, along), formulation=formulation, samples=(9, 7))
    smooth = draw(st.sampled_from([0.0, 0.5, 1.0]))
    return random_net_document(seed, windows, formulation=formulation, smooth=smooth, samples=(9, 7))


@pytest.mark.parametrize("suffix", [*ARRAYS, ".qovr"])
@given(document=nets())
@settings(max_examples=20, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_a_net_reads_back_to_the_last_bit(suffix, document, tmp_path):
    export(document, tmp_path / f"a{suffix}")
    again = read_source(str(tmp_path / f"a{suffix}"))
    assert again == document
    assert again.control_points.tobytes() == document.control_points.tobytes()


def arrays_of(path):
    if path.suffix == ".npz":
        with np.load(path) as archive:
            return dict(archive)
    return {name: array for name, array in loadmat(path).items() if not name.startswith("__")}


@pytest.mark.parametrize("suffix", ARRAYS)
@pytest.mark.parametrize("windows", [(2, 3), (3, 1), (1, 2)])
def test_the_arrays_of_a_net(suffix, windows, tmp_path):
    m, n = windows
    document = random_net_document(4, windows, smooth=0.5, samples=(14, 11))
    evaluation = Evaluation(document)
    export(document, tmp_path / f"a{suffix}")
    read = arrays_of(tmp_path / f"a{suffix}")
    expected = {
        "control_points": ((2 * m + 3, 2 * n + 3, 3), document.control_points),
        "row_knots": ((2 * m + 3, n, 4), document.row_knots.array),
        "column_knots": ((2 * n + 3, m, 4), document.column_knots.array),
        "u": ((14,), evaluation.u),
        "v": ((11,), evaluation.v),
        "raw": ((14, 11, 3), evaluation.raw),
        "transformed": ((14, 11, 3), evaluation.transformed),
        "control_box": ((3, 2), evaluation.control_box),
        "raw_box": ((3, 2), evaluation.raw_box),
        "matrix": ((4, 4), evaluation.matrix),
        "lengths_u": ((n,), np.diff(evaluation.patch.breakpoints[0])),
        "lengths_v": ((m,), np.diff(evaluation.patch.breakpoints[1])),
        "smooth_u": ((n - 1,), [joint is Joint.SMOOTH for joint in document.joints.u]),
        "smooth_v": ((m - 1,), [joint is Joint.SMOOTH for joint in document.joints.v]),
        "closed": ((2,), [False, False]),
    }
    assert set(read) == {*expected, "formulation", "program"}
    for name, (shape, values) in expected.items():
        found = read[name] if suffix == ".npz" or len(shape) > 1 else read[name].ravel()
        assert found.shape == shape
        assert np.array_equal(found, values)
    assert (read["u"].ravel()[-1], read["v"].ravel()[-1]) == (n, m)


def test_a_table_of_a_net_says_windows_and_places(tmp_path):
    document = random_net_document(4, (2, 3), samples=(12, 6))
    evaluation = Evaluation(document)
    export(document, tmp_path / "a.csv")
    with (tmp_path / "a.csv").open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert [float(row["u"]) for row in rows[::6]][:6] == [0, 0.25, 0.5, 0.75, 1, 1.25]
    table = np.array([[float(row[f"{layer}_{axis}"]) for layer in ("raw",) for axis in "xyz"] for row in rows])
    assert np.array_equal(table.reshape(12, 6, 3), evaluation.raw)
    for row in rows:
        assert evaluation.u[int(row["i"])] == float(row["u"])
        assert evaluation.v[int(row["j"])] == float(row["v"])
    inputs = json.loads((tmp_path / "a.inputs.json").read_text())
    assert document_from_json(json.dumps(inputs["document"])) == document


@pytest.mark.parametrize("suffix", [*ARRAYS, ".qovr"])
def test_the_largest_net_reads_back(suffix, tmp_path):
    document = random_net_document(2, (100, 100), smooth=0.5, samples=(101, 101))
    assert document.control_points.shape == (203, 203, 3)
    export(document, tmp_path / f"a{suffix}")
    assert read_source(str(tmp_path / f"a{suffix}")) == document


@pytest.mark.parametrize("suffix", ARRAYS)
def test_joints_that_are_not_told_are_as_smooth_as_the_knots_allow(suffix, tmp_path):
    document = random_net_document(5, (2, 3), smooth=0.5)
    arrays = surface_arrays(Evaluation(document))
    save(tmp_path / f"a{suffix}", {name: arrays[name] for name in arrays if not name.startswith(("smooth", "closed"))})
    assert read_source(str(tmp_path / f"a{suffix}")) == document


def save(path, arrays):
    if path.suffix == ".npz":
        np.savez(path, **arrays)
    else:
        savemat(path, arrays, oned_as="column")


NET = random_net_document(5, (2, 3), smooth=0.0, samples=(9, 7))


def changed(name, index, value):
    array = np.array(surface_arrays(Evaluation(NET))[name], dtype=np.float64)
    array[index] = value
    return {name: array}


BAD_ARRAYS = {
    "a point": (
        changed("control_points", (6, 8, 1), np.nan),
        "control_points[6][8][1] is nan; expected a finite number",
    ),
    "a knot": (changed("row_knots", (2, 1, 3), 1), "row_knots[2][1][3] is 1.0; expected a number strictly between"),
    "knots of one window": (
        {"row_knots": np.full((7, 4), 0.5)},
        "row_knots is float64 in 7 x 4; expected numbers in 7 x 3 x 4",
    ),
    "knots the wrong way round": (
        {"column_knots": np.full((2, 9, 4), 0.5)},
        "column_knots is float64 in 2 x 9 x 4; expected numbers in 9 x 2 x 4",
    ),
    "an even net": ({"control_points": np.zeros((7, 8, 3))}, "row_knots is float64 in 7 x 3 x 4; expected numbers in"),
    "a joint too many": ({"smooth_u": np.zeros(3)}, "smooth_u is float64 in 3"),
    "a joint of both kinds": ({"smooth_u": np.array([0, 0.5])}, "smooth_u[1] is 0.5; expected 0 or 1"),
    "joints in words": ({"smooth_v": np.array("a")}, "smooth_v is "),
    "a smooth joint that is not": (
        {"smooth_u": np.array([1, 0])},
        "joints.u[0] is smooth; expected sharp, or one value on all rows for t",
    ),
    "closed where it is not": (
        {"closed": np.array([1, 0]), "smooth_u": np.zeros(3)},
        "control_points is another column 6; expected that of column 0",
    ),
    "too few samples": ({"u": np.zeros(3)}, "samples[0] is 3; expected at least 4, for the net has 3 windows there"),
}


@pytest.mark.parametrize("name", BAD_ARRAYS)
@pytest.mark.parametrize("suffix", ARRAYS)
def test_bad_arrays_of_a_net_are_refused_at_their_place(name, suffix, tmp_path):
    changes, message = BAD_ARRAYS[name]
    path = tmp_path / f"bad{suffix}"
    save(path, {**surface_arrays(Evaluation(NET)), **changes})
    with pytest.raises(FileError) as caught:
        read_source(str(path))
    assert str(caught.value).startswith(f"{path}: {message}")


def at(data, path, value):
    *way, last = path
    for key in way:
        data = data[key]
    data[last] = value


BAD_TEXTS = {
    "a coordinate": (("control_points", 3, 1, 2), "1", "control_points[3][1][2] is '1'; expected a finite number"),
    "a truth": (("control_points", 3, 1, 2), True, "control_points[3][1][2] is True; expected a finite number"),
    "a huge number": (("control_points", 3, 1, 2), 10**400, "control_points[3][1][2] is 1000"),
    "a short row": (("control_points", 3), [[0, 0, 0]], "control_points[3] is a list of 1 entries; expected"),
    "a short point": (("control_points", 3, 1), [0, 0], "control_points[3][1] is a list of 2 entries; expected"),
    "a knot": (("row_knots", 2, 1, "r"), 1, "row_knots[2][1].r is 1; expected a number strictly between 0 and 1"),
    "a knot of text": (("row_knots", 2, 1, "u"), "a", "row_knots[2][1].u is 'a'; expected a number strictly between"),
    "a true knot": (("column_knots", 8, 1, "v"), True, "column_knots[8][1].v is True; expected a number strictly"),
    "a wrong key": (("column_knots", 8, 1), dict.fromkeys("rsut", 0.5), "column_knots[8][1].u is no key of a document"),
    "a missing key": (("row_knots", 2, 1), dict.fromkeys("rsu", 0.5), "row_knots[2][1].t is missing"),
    "a curve too short": (("row_knots", 2), [], "row_knots[2] is a list of 0 entries; expected a list of 3 entries"),
    "no list": (("row_knots", 2), 1, "row_knots[2] is 1; expected a list"),
    "a joint": (("joints", "u", 0), "round", "joints.u[0] is 'round'; expected one of smooth, sharp"),
    "a smooth joint that is not": (("joints", "u", 0), "smooth", "joints.u[0] is smooth; expected sharp, or one value"),
    "closed": (("closed",), ["w"], "closed[0] is 'w'; expected one of u, v"),
}


@pytest.mark.parametrize("name", BAD_TEXTS)
def test_a_bad_document_of_a_net_is_refused_at_its_place(name, tmp_path):
    place, value, message = BAD_TEXTS[name]
    data = json.loads(document_to_json(NET))
    at(data, place, value)
    (tmp_path / "bad.qovr").write_text(json.dumps(data))
    with pytest.raises(FileError) as caught:
        read_source(str(tmp_path / "bad.qovr"))
    assert str(caught.value).startswith(f"{tmp_path / 'bad.qovr'}: {message}")


def test_whole_numbers_are_read_as_numbers():
    data = json.loads(document_to_json(NET))
    data["control_points"] = [[[j, i, 0] for j in range(9)] for i in range(7)]
    points = document_from_json(json.dumps(data)).control_points
    assert points.dtype == np.float64
    assert points[6, 8].tolist() == [8, 6, 0]
    assert isinstance(document_from_json(json.dumps(data)), Document)
