"""Numbers as text: what is typed reads back, what is looked at has a true minus, ticks tell neighbours apart."""

import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_core.number_texts import (
    block_text,
    fitted_text,
    fixed_text,
    knot_step,
    natural_step,
    number_text,
    percent_text,
    power_text,
    rounded_text,
    short_text,
    significant_text,
    stepped,
    summed,
    summed_all,
    tick_texts,
)

finite = st.floats(allow_nan=False, allow_infinity=False)


@given(finite)
def test_a_text_to_type_reads_back_as_the_very_same_number(value):
    text = number_text(value)
    assert float(text) == value
    assert len(text) <= len(repr(value))
    assert "+" not in text


@pytest.mark.parametrize(
    ("value", "text"),
    [(2.0, "2"), (-0.5, "-0.5"), (1e-7, "1e-7"), (1e22, "1e22"), (1e300, "1e300"), (5e-324, "5e-324")],
)
def test_exact_texts(value, text):
    assert number_text(value) == text


@pytest.mark.parametrize("value", [0.5, -0.1, 1e12, 1 / 3, 1e-7, 123456.789, -2.5e-12, 1e300, 5e-324])
def test_fitted_text_keeps_sign_and_magnitude(value):
    for room in range(8, 24):
        text = fitted_text(value, lambda wanted, room=room: len(wanted) <= room)
        assert float(text.replace("…", "")) == pytest.approx(value, rel=0.5)
        assert ("…" in text) == (text != number_text(value))
        assert len(text) <= room or text == fitted_text(value, lambda _wanted: False)


@pytest.mark.parametrize(
    ("value", "rounded", "significant", "fixed"),
    [
        (0.0, "0", "0", "0.000"),
        (-0.123456, "−0.1235", "−0.1235", "−0.123"),
        (123456.0, "123500", "1.235e5", "123456.000"),
        (-2.5e-7, "−2.5e−7", "−2.5e−7", "−0.000"),
        (9999.96, "10000", "1e4", "9999.960"),
    ],
)
def test_digits_and_decimals(value, rounded, significant, fixed):
    assert (rounded_text(value, 4), significant_text(value, 4), fixed_text(value, 3)) == (rounded, significant, fixed)


@pytest.mark.parametrize(
    ("value", "text"),
    [
        (0.0, "0"),
        (0.0634, "0.063"),
        (2.42e-5, "2e−5"),
        (4.44e-16, "4e−16"),
        (6.0, "6"),
        (9.96, "10"),
        (106, "106"),
        (99999, "99999"),
        (1e5, "1e5"),
        (2e7, "2e7"),
    ],
)
def test_short_texts(value, text):
    assert short_text(value) == text


@pytest.mark.parametrize(
    ("part", "text"), [(0.1, "10 %"), (0.01, "1 %"), (0.12345, "12.3 %"), (1, "100 %"), (0, "0 %")]
)
def test_percent(part, text):
    assert percent_text(part) == text


def test_powers_and_blocks():
    assert power_text(-12) == "×10⁻¹²"
    assert block_text([[1.0, -0.5], [1 / 3, 2e20]]) == "1\t-0.5\n0.3333333333333333\t2e20\n"


@given(st.integers(-10_000, 10_000), st.sampled_from([1, 2, 5]), st.integers(-7, 12), st.integers(2, 12))
def test_ticks_tell_neighbours_apart(first, factor, power, count):
    step = factor * 10.0**power
    positions = [(first + k) * step for k in range(count)]
    texts = tick_texts(positions)
    assert len(set(texts)) == count
    shown = [float(text.replace("−", "-")) for text in texts]
    assert shown == pytest.approx(positions, rel=1e-9, abs=1e-9 * step)


@pytest.mark.parametrize(
    ("positions", "texts"),
    [
        ([], []),
        ([-0.0, 1.0], ["0", "1"]),
        ([0.5], ["0.5"]),
        ([1e16, 1e16], ["1e+16", "1e+16"]),
        ([5412.78462, 5412.78464], ["5412.7846200", "5412.7846400"]),  # the step itself is rounded
    ],
)
def test_ticks_in_special_places(positions, texts):
    assert tick_texts(positions) == texts


sizes = st.one_of(st.just(0.0), st.floats(1e-300, 1e12), st.integers(-300, 12).map(lambda power: 10.0**power))


@given(sizes, sizes, st.sampled_from([-1.0, 1.0]))
def test_a_natural_step_is_a_power_of_ten_about_a_hundredth_of_the_size_and_changes_the_number(size, scale, sign):
    value = sign * size
    step = natural_step(value, scale)
    assert step == float(f"1e{round(math.log10(step))}")
    assert stepped(value, 1, step) > value > stepped(value, -1, step)
    if scale and abs(value) < 1e12 * scale:
        assert 0.00099 * scale <= step <= 0.010001 * scale


@pytest.mark.parametrize(
    ("value", "scale", "step"),
    [
        (2.0, 4.0, 0.01),
        (0.5, 0.3 - 0.2, 0.001),
        (0.0, 0.0, 0.01),
        (-40.0, 0.0, 0.1),
        (1e12, 1e-3, 0.01),
        (0.0, 1e12, 1e10),
    ],
)
def test_natural_steps_of_coordinates(value, scale, step):
    assert natural_step(value, scale) == step


@given(st.floats(1e-300, 1, exclude_max=True))
def test_a_step_of_a_knot_stays_inside(knot):
    step = knot_step(knot)
    assert 0 < stepped(knot, -1, step) < knot < stepped(knot, 1, step)
    assert stepped(knot, 1, step) < 1 or knot > 1 - 1e-12
    assert (step == 0.01) == (0.1 <= knot <= 0.9) or min(knot, 1 - knot) == pytest.approx(0.1)


@pytest.mark.parametrize(
    ("value", "count", "step", "result"),
    [
        (0.1, 20, 0.01, 0.3),
        (0.1 + 0.2, 1, 0.1, 0.4),
        (0.123456, 1, 0.01, 0.133456),
        (0.03, -3, 0.01, 0.0),
        (1e-300, -1, 0.01, -0.01),
        (3e-300, 1, 1e-302, 3.01e-300),
        (1e12, -1, 1e10, 9.9e11),
        (123456789012.25, 10, 0.01, 123456789012.35),
    ],
)
def test_what_is_stepped_is_a_round_decimal(value, count, step, result):
    after = stepped(value, count, step)
    assert after == result
    assert math.copysign(1.0, after) == 1.0 or after < 0


@pytest.mark.parametrize(
    ("value", "amount", "total"),
    [(2.0, 1.07, 3.07), (0.5, -0.499, 0.001), (1e12, 0.25, 1000000000000.25), (0.0, 5e-324, 5e-324), (-0.7, 0.7, 0.0)],
)
def test_a_sum_has_the_decimals_of_its_parts(value, amount, total):
    assert summed(value, amount) == summed(amount, value) == total


places = st.integers(-24, 4)
decimals = st.builds(lambda digits, places: float(f"{digits}e{places}"), st.integers(-(10**16), 10**16), places)
numbers = st.one_of(decimals, st.floats(-1e100, 1e100), st.sampled_from([0.0, -0.0, 1e15, 999999999999999.0, 1e22]))


@given(st.lists(st.tuples(numbers, numbers), max_size=8))
def test_sums_at_once_are_those_one_by_one_to_the_last_bit(pairs):
    values, amounts = np.array(pairs).reshape(-1, 2).T
    expected = np.array([summed(value, amount) for value, amount in pairs])
    assert summed_all(values, amounts).tobytes() == expected.tobytes()


@given(st.floats(-1e12, 1e12), st.floats(-1e12, 1e12))
def test_a_sum_is_the_binary_one_to_rounding(value, amount):
    # The smallest number of all stands for rounding where numbers are too small for 53 bits.
    assert abs(summed(value, amount) - (value + amount)) <= max(1e-15 * max(abs(value), abs(amount)), 5e-324)
