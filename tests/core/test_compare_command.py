"""``qovr compare`` as a user runs it: another process."""

import json
from dataclasses import replace

import pytest

from qovr_core import Formulation, Knots
from qovr_core.edits import set_all_knots
from qovr_core.files.qovr_document import document_to_json
from qovr_core.laboratory.comparison import compare, compared_names
from qovr_core.laboratory.comparison_report import comparison_facts, comparison_text
from qovr_core.presets import presets
from support.command import qovr, refused
from support.documents import random_document


def test_the_table_is_the_comparison_of_the_middle_point():
    run = qovr("compare", "paper:fig6b")
    assert run.code == 0
    assert run.err == ""
    assert run.out.rstrip("\n") == comparison_text(compare(presets()["fig6b"].document))
    assert max(map(len, run.out.splitlines())) <= 100
    for name in ("QOVR", "Bezier", "B-spline", "NURBS", "Catmull-Rom"):
        assert name in run.out


def test_point_and_weight_choose_what_moves_and_how_it_is_weighted(tmp_path):
    document = random_document(3, Formulation.INTERPOLATING, low=0.4, high=0.6)
    (tmp_path / "a.qovr").write_text(document_to_json(document))
    run = qovr("compare", "a.qovr", "--point", "1,3", "--weight", "2.5", "--json", cwd=tmp_path)
    assert run.code == 0
    facts = json.loads(run.out)
    assert facts == json.loads(json.dumps(comparison_facts(compare(document, (1, 3), 2.5))))
    assert (facts["point"], facts["weight"], facts["layer"]) == ([1, 3], 2.5, "raw")
    assert list(facts["surfaces"]) == list(compared_names())
    assert facts["surfaces"]["qovr"]["corner_motion"][1][0] == pytest.approx(facts["step"])
    assert facts["surfaces"]["bezier"]["tangent_jump_degrees"] is None


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (["compare"], "the following arguments are required: SOURCE"),
        (["compare", "missing.qovr"], "missing.qovr: cannot be read: No such file or directory"),
        (["compare", "paper:fig5", "--point", "5,1"], "'5,1' is no control point; expected I,J, each from 0 to 4"),
        (["compare", "paper:fig5", "--point", "2"], "'2' is no control point"),
        (["compare", "paper:fig5", "--weight", "0"], "'0' is no weight; expected a positive number"),
        (["compare", "paper:fig5", "--weight", "nan"], "'nan' is no weight"),
        (["compare", "paper:fig5", "--weight", "heavy"], "'heavy' is no weight"),
    ],
    ids=lambda part: " ".join(part) if isinstance(part, list) else "",
)
def test_bad_calls(call, message, tmp_path):
    assert message in refused(qovr(*call, cwd=tmp_path))


def test_a_net_in_one_place_is_refused(tmp_path):
    content = json.loads(document_to_json(presets()["fig5"].document))
    content["control_points"] = [[[1, 2, 3]] * 5] * 5
    (tmp_path / "a.qovr").write_text(json.dumps(content))
    assert "the control points all lie in one place" in refused(qovr("compare", "a.qovr", cwd=tmp_path))


def test_coordinates_whose_squares_overflow_are_measured_without_a_warning(tmp_path):
    document = set_all_knots(presets()["fig5"].document, Knots(s=1e-120))
    (tmp_path / "a.qovr").write_text(document_to_json(replace(document, formulation=Formulation.INTERPOLATING)))
    run = qovr("compare", "a.qovr", "--json", cwd=tmp_path)
    assert (run.code, run.err) == (0, "")
    facts = json.loads(run.out, parse_constant=pytest.fail)
    assert facts["surfaces"]["qovr"]["largest_displacement"] > 1e200
    assert facts["surfaces"]["bezier"]["distance_of_qovr"] > 1e100
