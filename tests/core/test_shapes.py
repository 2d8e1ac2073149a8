"""The shapes to begin with: each is what its name says."""

import numpy as np
import pytest

from qovr_core import Evaluation, SourceError, build_patch
from qovr_core.files.sources import read_source
from qovr_core.geometry.folding import folds
from qovr_core.joints import Joint
from qovr_core.shapes import SHAPES
from support.command import qovr


@pytest.mark.parametrize("name", SHAPES)
def test_each_is_a_surface_without_folds(name):
    document = SHAPES[name].document()
    assert not folds(document.row_knots.array).any()
    assert not folds(document.column_knots.array).any()
    evaluation = Evaluation(document)
    assert np.isfinite(evaluation.raw).all()
    assert not np.signbit(document.control_points[document.control_points == 0]).any()  # no field says -0
    assert read_source(f"shape:{name}") == document


def test_the_vase_closes_without_a_gap_or_a_kink():
    patch = build_patch(SHAPES["vase"].document())
    (start, end), (low, high) = patch.domain
    v = np.linspace(low, high, 50)
    before, after = patch.derivative([np.nextafter(end, 0)], v, 1, 0), patch.derivative([start], v, 1, 0)
    assert patch.points([end], v) == pytest.approx(patch.points([start], v), abs=1e-14)
    assert before == pytest.approx(after, abs=1e-9)
    assert np.hypot(*patch.points([0.3], v)[0, :, :2].T).min() > 0.1


def test_the_crease_is_one_line_across():
    document = SHAPES["folded-saddle"].document()
    assert document.joints.u == (Joint.SMOOTH, Joint.SHARP, Joint.SMOOTH)
    patch = build_patch(document)
    at = patch.breakpoints[0][2]
    left, right = (patch.normals([u], [1.0, 2.0])[0] for u in (np.nextafter(at, 0), at))
    angle = np.degrees(np.arccos((left * right).sum(axis=-1)))
    assert (angle > 30).all()


def test_a_shape_that_is_not_there_is_named():
    with pytest.raises(SourceError, match="there is no shape 'cube'; expected one of paper, flat"):
        read_source("shape:cube")


def test_they_are_listed():
    listed = qovr("presets").out.splitlines()
    assert [line.split()[0] for line in listed if line.startswith("shape:")] == [f"shape:{name}" for name in SHAPES]
