"""Documents of any size that the program accepts: no nan, no inf, no warning, and refusals name what stands there."""

import json
import re
import warnings

import numpy as np
import pytest

from qovr_core import Document, Evaluation, Knots, Layer, QovrError
from qovr_core.edits import Direction
from qovr_core.laboratory.claims_report import findings_text
from qovr_core.laboratory.comparison import compare
from qovr_core.laboratory.comparison_report import comparison_facts, comparison_text
from qovr_core.laboratory.influence import PointMove, influence
from qovr_core.laboratory.one_curve import curve_of
from qovr_core.laboratory.verify import verify
from qovr_core.presets import preset
from qovr_core.report import facts_text, surface_facts
from support.documents import random_net

NETS = {
    "1e-300": 1e-300 * random_net(1),
    "2.4e11": 2.4e11 * np.abs(random_net(2)).clip(0, 4),
    "aspect": random_net(3) * [1e9, 1.0, 1.0],
    "far": 1e9 + 1e-3 * random_net(4),
    "line": np.stack([np.add.outer(np.arange(5.0), np.arange(5.0))] * 3, axis=-1),
    "plane": random_net(5) * [1.0, 1.0, 0.0],
}
NEAR_THE_ENDS = (Knots(1e-12, 0.5, 1 - 1e-12, 0.3),) * 5


def said(text):
    assert not re.search(r"\b(nan|inf)\b", text, re.IGNORECASE), text
    return text


@pytest.fixture(autouse=True)
def strict():
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        yield


@pytest.mark.parametrize("formulation", ["published", "double-sum", "interpolating"])
@pytest.mark.parametrize("knots", [(Knots(),) * 5, NEAR_THE_ENDS], ids=["half", "near the ends"])
@pytest.mark.parametrize("net", NETS)
def test_facts_curves_and_influence_are_numbers(net, knots, formulation):
    document = Document(NETS[net], knots, formulation=formulation, samples=(9, 9))
    json.dumps(surface_facts(Evaluation(document)), allow_nan=False)
    said(facts_text(surface_facts(Evaluation(document))))
    assert np.isfinite(curve_of(document, Direction.ROWS, 4).at([0.0, 0.3, 1.0])).all()
    found = influence(document, PointMove(2, 2, (0.0, 0.0, -0.1 * document.net_size)), Layer.RAW)
    assert np.isfinite([found.largest, *found.edges.values(), *found.corners.ravel()]).all()


@pytest.mark.parametrize("net", ["2.4e11", "1e-300", "plane"])
def test_claims_are_decided_for_any_size(net):
    document = Document(NETS[net], NEAR_THE_ENDS, samples=(9, 9))
    said(findings_text(verify(document)))


def test_verdicts_do_not_depend_on_the_unit():
    document = preset("fig6c").document
    for scale in (2.0**-900, 2.0**37):
        scaled = Document(document.control_points * scale, document.row_knots, document.column_knots)
        for one, other in zip(verify(document), verify(scaled), strict=True):
            assert (one.verdict, one.here.holds, one.here.value) == (other.verdict, other.here.holds, other.here.value)


def test_a_comparison_is_measured_in_the_nets_own_unit():
    large, small = (compare(Document(scale * NETS["plane"])) for scale in (2.0**37, 2.0**-990))
    for comparison in (large, small):
        said(comparison_text(comparison))
        json.dumps(comparison_facts(comparison), allow_nan=False)
    factor = 2.0**-1027
    assert small.measures["bezier"].largest_motion == pytest.approx(large.measures["bezier"].largest_motion * factor)


def test_a_refusal_names_the_number_that_stands_there():
    document = Document(NETS["plane"], (Knots(r=5e-324),) * 5, formulation="interpolating")
    with pytest.raises(QovrError, match=r"row_knots\[4\]\.r = 5e-324"):
        verify(document)
