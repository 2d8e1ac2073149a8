import numpy as np
import pytest
from hypothesis import given

from qovr_core.geometry.kernels import inverse_kernels, kernels
from support.documents import knot_values


@given(knot_values)
def test_the_closed_form_is_the_inverse(knot):
    assert kernels(knot) @ inverse_kernels(knot) == pytest.approx(np.eye(3), abs=1e-11)


def test_the_kernel_has_the_papers_rows():
    assert kernels(0.3) == pytest.approx(np.array([[0, 0, 1], [0.09, 0.3, 1], [1, 1, 1]]))


def test_the_papers_knot_needs_no_cut():
    exact = [[2, -4, 2], [-3, 4, -1], [1, 0, 0]]
    assert inverse_kernels(0.5).tolist() == exact
    assert inverse_kernels(0.5, decimals=4).tolist() == exact


def test_entries_are_cut_toward_zero_to_four_decimals():
    cut = inverse_kernels(0.3, decimals=4)
    assert cut.tolist() == [[3.3333, -4.7619, 1.4285], [-4.3333, 4.7619, -0.4285], [1, 0, 0]]


def test_an_entry_that_four_decimals_hold_survives_its_rounding():
    # 1 / (1 - 0.6) is 2.5, computed as 2.4999999999999996 or so
    assert inverse_kernels(0.6, decimals=4)[0, 2] == 2.5
    assert inverse_kernels(0.4, decimals=4)[0, 0] == 2.5


def test_many_knots_at_once():
    knots = np.array([[0.2, 0.5], [0.7, 0.9]])
    stacked = inverse_kernels(knots)
    assert stacked.shape == (2, 2, 3, 3)
    assert np.array_equal(stacked[1, 0], inverse_kernels(0.7))
