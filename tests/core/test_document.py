from dataclasses import FrozenInstanceError, replace

import numpy as np
import pytest

from qovr_core import Document, DocumentError, Formulation, Knots, edits
from qovr_core.edits import Direction
from qovr_core.presets import figure_cases, presets
from support.documents import random_document, random_net, with_knot

NET = random_net(0)


def test_defaults_are_the_papers():
    document = Document(NET)
    assert document.formulation is Formulation.PUBLISHED
    assert document.samples == (101, 101)
    assert document.row_knots.in_window(0) == document.column_knots.in_window(0) == (Knots(0.5, 0.5, 0.5, 0.5),) * 5


def test_nothing_in_it_can_be_changed():
    document = Document(NET)
    with pytest.raises(FrozenInstanceError):
        document.samples = (2, 2)
    with pytest.raises(FrozenInstanceError):
        document.row_knots[0, 0].r = 0.1
    with pytest.raises(ValueError, match="read-only"):
        document.control_points[0, 0, 0] = 1


def test_it_does_not_follow_the_array_it_was_made_from():
    net = NET.copy()
    document = Document(net)
    net[0, 0, 0] = 99
    assert document.control_points[0, 0, 0] == NET[0, 0, 0]


def test_equality_is_that_of_the_numbers():
    assert random_document(3) == random_document(3)
    assert hash(random_document(3)) == hash(random_document(3))
    assert random_document(3) != random_document(4)
    assert random_document(3) != "a document"
    assert Document(NET + 0.0) == Document(NET.tolist())


def net_with(value, i=3, j=1, k=2):
    net = NET.tolist()
    net[i][j][k] = value
    return net


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"control_points": net_with(float("nan"))}, r"control_points\[3\]\[1\]\[2\] is nan; expected a finite number"),
        ({"control_points": np.array(net_with(np.inf))}, r"control_points\[3\]\[1\]\[2\] is inf"),
        ({"control_points": net_with(-1.1e12)}, r"is -1100000000000.0; expected .* magnitude at most 1e\+12"),
        ({"control_points": net_with("0.5")}, r"\[3\]\[1\]\[2\] is '0.5'"),
        ({"control_points": net_with(True)}, r"\[3\]\[1\]\[2\] is True"),
        ({"control_points": net_with(10**400)}, r"\[3\]\[1\]\[2\] is 1000"),
        (
            {"control_points": NET[:4]},
            "control_points is a list of 4 entries; expected a list of 5, 7, 9",
        ),
        ({"control_points": NET[..., :2]}, r"control_points\[0\]\[0\] is a list of 2 entries; expected a list of 3"),
        ({"control_points": 7}, "control_points is 7; expected a list of 5, 7, 9, ... or 203"),
        ({"samples": (1, 101)}, r"samples\[0\] is 1; expected a whole number from 2 to 4096"),
        ({"samples": (101, 4097)}, r"samples\[1\] is 4097"),
        ({"samples": (101, 2.5)}, r"samples\[1\] is 2.5"),
        ({"samples": 101}, "samples is 101"),
        ({"formulation": "tensor"}, "formulation is 'tensor'; expected one of published, double-sum, interpolating"),
        ({"row_knots": (Knots(),) * 4}, "row_knots is a list of 4 entries"),
        ({"column_knots": [0.5] * 5}, r"column_knots\[0\] is 0.5; expected a Knots object"),
    ],
)
def test_refusals(changes, message):
    with pytest.raises(DocumentError, match=message):
        Document(**{"control_points": NET, **changes})


@pytest.mark.parametrize("value", [0, 1, -0.1, 1.5, float("nan"), True, "0.5", None, 1 - 1e-17])
def test_knots_lie_strictly_inside(value):
    with pytest.raises(DocumentError, match="expected a number strictly between 0 and 1"):
        Knots(s=value)


def test_edits_make_a_new_document_and_leave_the_old():
    document = random_document(8)
    copy = replace(document)
    moved = edits.set_point(document, 1, 3, (7, 8, 9))
    assert moved.control_points[1, 3].tolist() == [7, 8, 9]
    assert (moved.control_points != document.control_points).any(axis=-1).sum() == 1
    one = with_knot(document, Direction.COLUMNS, "u", 0.25, curve=2)
    assert [k.u for k in one.column_knots.in_window(0)][2] == 0.25
    assert np.array_equal(np.delete(one.column_knots.array, 2, 0), np.delete(document.column_knots.array, 2, 0))
    linked = with_knot(document, Direction.ROWS, "t", 0.75)
    assert [k.t for k in linked.row_knots.in_window(0)] == [0.75] * 5
    assert edits.set_formulation(document, Formulation.DOUBLE_SUM).formulation is Formulation.DOUBLE_SUM
    assert edits.set_samples(document, (3, 4)).samples == (3, 4)
    assert edits.set_points(document, NET * 2).control_points.tolist() == (NET * 2).tolist()
    assert document == copy


def test_an_edit_names_the_place_it_cannot_change():
    document = random_document(8)
    with pytest.raises(DocumentError, match=r"row_knots\[4\].t is 1; expected"):
        with_knot(document, Direction.ROWS, "t", 1, curve=4)
    with pytest.raises(DocumentError, match=r"control_points\[0\]\[1\]\[0\] is nan"):
        edits.set_point(document, 0, 1, (np.nan, 0, 0))


def test_presets_are_the_papers_cases():
    cases = {name: entry.document for name, entry in presets().items()}
    assert list(cases) == ["fig5", "fig6a", "fig6b", "fig6c", "fig6d", "fig7a", "fig7b", "fig7c", "fig7d", "fig8"]
    for six, seven in zip("abcd", "abcd", strict=True):
        assert cases[f"fig6{six}"] == cases[f"fig7{seven}"]
    v0 = cases["fig5"].control_points
    assert v0[3, 2].tolist() == [2, 3, 0.5]
    assert v0[..., 2].sum() == pytest.approx(11.4)
    assert cases["fig8"].control_points[:, 2, 2].tolist() == [0.75, 0.15, 0.10, 0.15, 0.75]
    assert set(cases["fig6c"].column_knots.in_window(0)) == {Knots(0.4, 0.6, 0.7, 0.4)}
    assert set(cases["fig6d"].row_knots.in_window(0)) == {Knots(0.5, 0.4, 0.3, 0.5)}
    assert set(cases["fig6b"].row_knots.in_window(0)) == {Knots(0.3, 0.5, 0.5, 0.7)}
    assert {document.formulation for document in cases.values()} == {Formulation.PUBLISHED}


def test_there_are_twelve_figures():
    cases = figure_cases()
    assert [name for name, case in cases.items() if case.layer == "raw"] == ["fig5a"]
    assert [name for name, case in cases.items() if case.camera == "top"] == [
        "fig7a",
        "fig7b",
        "fig7c",
        "fig7d",
        "fig8b",
    ]
    assert len(cases) == 12
