"""A formulation is one record, and so is a fourth one from outside."""

import pickle
from dataclasses import replace

import numpy as np
import pytest

from qovr_core import FORMULATIONS, Document, DocumentError, Evaluation, Formulation, Layer, build_patch, edits
from qovr_core.cli import main
from qovr_core.construction import window_arrays
from qovr_core.edits import Direction, KnotPlace
from qovr_core.files import read_document, write_document
from qovr_core.geometry.knots import KNOT_NAMES
from qovr_core.geometry.weights import weight_coefficients
from qovr_core.laboratory.sensitivity import knot_sensitivity
from qovr_core.laboratory.verify import verify
from support.documents import random_document, random_net

PLACES = [KnotPlace(direction, k, name) for direction in Direction for k in range(5) for name in KNOT_NAMES]


def tensor_product(net, row_knots, column_knots):
    """The tensor product of the weights of C_2 and K_2: a surface that the program does not know."""
    along_u, along_v = weight_coefficients(row_knots[..., 2, :]), weight_coefficients(column_knots[..., 2, :])
    return np.einsum("...aj,...bi,...ijd->...abd", along_u, along_v, net)


TENSOR = Formulation("tensor", "The tensor product.", tensor_product, active_rows=(2,), active_columns=(2,))


@pytest.fixture
def tensor():
    with FORMULATIONS.register(TENSOR):
        yield TENSOR
    assert "tensor" not in FORMULATIONS


def test_a_formulation_is_its_name():
    published = Formulation.PUBLISHED
    assert (str(published), f"{published:<12}|") == ("published", "published   |")
    assert published == replace(published, description="another") != Formulation.DOUBLE_SUM
    assert hash(published) == hash(replace(published, description="another"))
    assert pickle.loads(pickle.dumps(published)) is published
    document = random_document(3)
    assert pickle.loads(pickle.dumps(document)) == document
    assert pickle.loads(pickle.dumps(document)).formulation is Formulation.INTERPOLATING


def test_one_from_outside_is_pickled_as_a_whole(tensor):
    text = pickle.dumps(random_document(3, TENSOR))
    assert pickle.loads(text).formulation == tensor
    with pytest.raises(DocumentError, match="one of published, double-sum, interpolating, tensor"):
        Document(random_net(1), formulation="other")


def test_one_from_outside_survives_a_process_that_has_not_registered_it():
    document = random_document(3, TENSOR)
    again = pickle.loads(pickle.dumps(document))
    assert again == document
    assert np.array_equal(build_patch(again).coefficients[0, 0], build_patch(document).coefficients[0, 0])


def test_a_fourth_formulation_is_in_files_commands_and_claims(tensor, tmp_path, capsys):
    document = random_document(3, "tensor")
    write_document(document, tmp_path / "a.qovr")
    assert read_document(tmp_path / "a.qovr") == document
    assert main(["info", str(tmp_path / "a.qovr")]) == 0
    assert "only C_2, K_2 enter the tensor formulation" in capsys.readouterr().out
    assert main(["export", "paper:fig8", str(tmp_path / "b.npz"), "--formulation", "tensor", "--samples", "5"]) == 0
    assert str(np.load(tmp_path / "b.npz")["formulation"]) == "tensor"
    assert {finding.formulation for finding in verify(document)} == set(FORMULATIONS.values())


@pytest.mark.parametrize("layer", list(Layer))
def test_a_formulation_without_slopes_has_them_numerically(tensor, layer):
    document = random_document(11, tensor, samples=(9, 14), low=0.2, high=0.8)
    result = Evaluation(document)
    slopes = {place: knot_sensitivity(result, place, layer).coefficients[0, 0] for place in PLACES}
    size = max(np.abs(slope).max() for slope in slopes.values())
    for place, slope in slopes.items():
        value, step = edits.value_at(document, place), 1e-6
        below, above = (
            Evaluation(edits.set_values(document, {place: value + sign * step})).layer_patch(layer).coefficients[0, 0]
            for sign in (-1, 1)
        )
        assert slope == pytest.approx((above - below) / (2 * step), abs=1e-7 * size)
        assert slope.any() == (place.curve == 2)


@pytest.mark.parametrize("formulation", [Formulation.DOUBLE_SUM, Formulation.INTERPOLATING], ids=str)
@pytest.mark.parametrize("margin", [0.3, 0.01])
def test_numerical_slopes_are_as_exact_as_is_said(formulation, margin):
    arrays = window_arrays(random_document(5, formulation, low=margin, high=1 - margin))
    numerical = replace(formulation, slope=None)
    for place in PLACES:
        exact = formulation.knot_slope(*arrays, place)
        error = np.abs(numerical.knot_slope(*arrays, place) - exact).max()
        assert error <= 1e-11 * np.abs(formulation.build(*arrays)).max() / margin


def test_cut_kernels_need_a_slope():
    with pytest.raises(ValueError, match="cuts its kernels; expected the slope"):
        replace(Formulation.PUBLISHED, slope=None)
