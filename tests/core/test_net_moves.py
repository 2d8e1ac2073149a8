"""Mirror images and soft moves over nets of any size."""

import itertools

import numpy as np
import pytest

from qovr_core.net_moves import COLUMNS_MIRROR, ROWS_MIRROR, mirrored, softened

SIZES = [(5, 5), (7, 9), (4, 6), (5, 11)]


def moves(shape, of):
    field, moved = np.zeros((*shape, 3)), np.zeros(shape, dtype=bool)
    for index, displacement in of.items():
        field[index], moved[index] = displacement, True
    return field, moved


@pytest.mark.parametrize("shape", SIZES)
@pytest.mark.parametrize("mirror", [ROWS_MIRROR, COLUMNS_MIRROR], ids=["rows", "columns"])
def test_the_partner_moves_by_the_mirrored_displacement(shape, mirror):
    field, moved = mirrored(moves(shape, {(1, 0): (0.1, 0.2, 0.3)}), mirror, (1, 0))
    rows, columns = shape
    partner = (rows - 2, 0) if mirror is ROWS_MIRROR else (1, columns - 1)
    expected = [0.1, -0.2, 0.3] if mirror is ROWS_MIRROR else [-0.1, 0.2, 0.3]
    assert field[1, 0].tolist() == [0.1, 0.2, 0.3]
    assert field[partner].tolist() == expected
    assert sorted(map(tuple, np.argwhere(moved))) == sorted([(1, 0), partner])


def test_the_middle_stays_in_its_plane():
    field, _ = mirrored(moves((5, 5), {(3, 2): (0.1, 0.2, 0.3)}), COLUMNS_MIRROR, (3, 2))
    np.testing.assert_allclose(field[3, 2], [0, 0.2, 0.3])


def test_of_a_pair_the_side_in_hand_leads():
    both = {(1, 1): (0.1, 0, 0.3), (1, 3): (0.1, 0, 0.3)}
    field, _ = mirrored(moves((5, 5), both), COLUMNS_MIRROR, (1, 3))
    assert field[1, 3].tolist() == [0.1, 0, 0.3]
    assert field[1, 1].tolist() == [-0.1, 0, 0.3]
    field, _ = mirrored(moves((5, 5), both), COLUMNS_MIRROR, (0, 2))
    np.testing.assert_allclose(field[1, [1, 3]], [[0, 0, 0.3]] * 2)


@pytest.mark.parametrize("shape", SIZES)
def test_soft_moves_fade_with_the_steps_along_the_net(shape):
    field, moved = softened(moves(shape, {(1, 2): (0, 0, 2.0)}), 3)
    for i, j in itertools.product(*map(range, shape)):
        steps = abs(i - 1) + abs(j - 2)
        share = max(1 - steps / 3, 0)
        assert field[i, j, 2] == pytest.approx(2 * share**2 * (3 - 2 * share))
        assert moved[i, j] == (steps < 3)


def test_softly_moved_points_stay_as_they_were_moved_and_ties_take_the_mean():
    field, _ = softened(moves((5, 5), {(2, 1): (0.4, 0, 1), (2, 3): (-0.4, 0, 1)}), 2)
    np.testing.assert_allclose(field[2, 2], [0, 0, 0.5])
    assert field[2, 1].tolist() == [0.4, 0, 1]
    np.testing.assert_array_equal(softened(moves((5, 5), {(2, 1): (0, 0, 1)}), 1.0)[1].sum(), 1)


def test_a_large_net_is_softened_at_once():
    field, moved = softened(moves((203, 203), {(101, 101): (0, 0, 1)}), 50)
    assert moved.sum() == 2 * 50 * 49 + 1
    assert field.max() == 1
