"""Recovery files: whatever a document holds comes back to the last bit, and no number of it is ever made text."""

from contextlib import suppress

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_app.window.recovery_file import Snapshot, read_snapshot, write_snapshot
from qovr_core import Document, QovrError
from qovr_core.presets import preset
from support.recovery_reader import kept_in

RANDOM = np.random.default_rng(5)
FIG5 = preset("fig5").document
LARGEST = 203


def net(rows, columns):
    points = RANDOM.normal(size=(rows, columns, 3))
    points[0, 0] = -0.0, 5e-324, 1e12
    return points


def closed_net():
    points = net(9, 7)
    points[-3:] = points[:3]
    return Document(points, formulation="interpolating", samples=(31, 41), closed=["v"])


SHARP = Document(
    net(7, 9), row_knots=RANDOM.uniform(0.1, 0.9, (7, 3, 4)), column_knots=RANDOM.uniform(0.1, 0.9, (9, 2, 4))
)
DOCUMENTS = {"paper": FIG5, "sharp": SHARP, "closed": closed_net()}


def bits(document):
    return [
        document.control_points.tobytes(),
        document.row_knots.array.tobytes(),
        document.column_knots.array.tobytes(),
    ]


@pytest.mark.parametrize("name", DOCUMENTS)
def test_a_snapshot_comes_back_to_the_last_bit(name, tmp_path):
    document = DOCUMENTS[name]
    file, there = tmp_path / "kept", tmp_path / "a file.qovr"
    write_snapshot(Snapshot(document, "ünsaved", there, (1_700_000_000_000_000_001, 2, 3), FIG5), file)
    read = read_snapshot(file)
    assert (read.title, read.path, read.stamp) == ("ünsaved", there, (1_700_000_000_000_000_001, 2, 3))
    for before, after in ((document, read.document), (FIG5, read.draft)):
        assert after == before
        assert bits(after) == bits(before)


def test_what_a_snapshot_does_not_have_it_does_not_get(tmp_path):
    write_snapshot(Snapshot(FIG5, "fig5"), tmp_path / "kept")
    read = read_snapshot(tmp_path / "kept")
    assert (read.path, read.stamp, read.draft) == (None, None, None)


def test_no_number_of_the_largest_net_is_made_text(tmp_path):
    document = Document(net(LARGEST, LARGEST), samples=(401, 401))
    write_snapshot(Snapshot(document, "large"), tmp_path / "kept")
    head, (arrays,) = kept_in(tmp_path / "kept")
    assert len(str(head)) < 10_000
    assert arrays["control_points"].tobytes() == document.control_points.tobytes()
    assert arrays["row_knots"].shape == arrays["column_knots"].shape == (LARGEST, 100, 4)


@pytest.fixture(scope="module")
def whole(tmp_path_factory):
    file = tmp_path_factory.mktemp("whole") / "kept"
    write_snapshot(Snapshot(SHARP, "sharp", draft=FIG5), file)
    return file.read_bytes()


@given(st.data())
def test_a_damaged_file_is_refused_or_reads_as_some_document(whole, tmp_path_factory, data):
    content = bytearray(whole)
    start = data.draw(st.integers(0, len(content) - 1))
    end = data.draw(st.integers(start, len(content)))
    content[start:end] = data.draw(st.binary(max_size=20))
    file = tmp_path_factory.getbasetemp() / "damaged"
    file.write_bytes(content)
    with suppress(OSError, ValueError, KeyError, TypeError, RecursionError, QovrError):
        assert isinstance(read_snapshot(file).document, Document)
