"""Labels that stand clear of lines and of each other."""

import numpy as np
import pytest

from qovr_core.laboratory.labels import free_place, label_places, place_labels


def test_labels_stand_apart():
    x = np.linspace(0, 1, 101)
    places = label_places(np.stack([x, 1 - x, 0 * x - 3], axis=1))
    assert set(places[:2]) <= {10, 90}
    with_bump = np.stack([0 * x, np.exp(-200 * (x - 0.3) ** 2)], axis=1)
    assert label_places(with_bump).tolist() == [30, 30]
    side_by_side = np.stack([0 * x, 0 * x + 0.01, x], axis=1)
    first, second, _ = label_places(side_by_side)
    assert abs(first - second) >= 12


def test_labels_stay_where_their_function_is_in_the_drawing():
    x = np.linspace(0, 1, 101)
    steep = np.where(x < 0.4, 1 + 5 * x, np.nan)
    first, second = label_places(np.stack([steep, x], axis=1))
    assert 10 <= first < 40
    assert 10 <= second < 91


def test_the_free_place_is_the_one_farthest_away():
    line = np.stack([np.linspace(0, 10, 11), np.zeros(11)], axis=1)
    assert free_place(line, np.array([[0.0, 0.0], [10.0, 0.0]])) == 5
    assert free_place(line, np.array([[9.0, 1.0]])) == 0


BOX = np.array([[0.0, 0.0], [300.0, 200.0]])
NONE = np.empty((0, 2))


def placed(places, sizes, wanted, lines=NONE):
    arrays = (np.array(values, dtype=float) for values in (places, sizes, wanted))
    return place_labels(*arrays, lines, gap=4.0, box=BOX)


def overlap(centre, size, other_centre, other_size):
    return (np.abs(centre - other_centre) < (np.array(size) + other_size) / 2 - 1e-9).all()


def test_a_label_goes_where_it_is_wanted_unless_a_line_is_there():
    place, size = [(100, 100)], [(30, 10)]
    assert placed(place, size, [(0, 2)])[0] == pytest.approx([100, 109])
    line = np.stack([np.linspace(60, 140, 81), np.full(81, 109.0)], axis=1)
    (centre,) = placed(place, size, [(0, 1)], line)
    assert not (np.abs(line - centre) <= np.array(size) / 2).all(axis=1).any()


def test_labels_keep_off_each_other_and_inside():
    places, size = [(25, 190), (45, 190), (75, 190)], (30, 12)
    centres = placed(places, [size] * 3, [(0, 1)] * 3)
    for k in range(3):
        assert (centres[k] - np.array(size) / 2 >= BOX[0]).all()
        assert (centres[k] + np.array(size) / 2 <= BOX[1]).all()
        assert not any(overlap(centres[k], size, centres[other], size) for other in range(k))
