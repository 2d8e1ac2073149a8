"""What is typed into a field: numbers, and what makes another of the present one."""

import pytest

from qovr_app.state.typed import typed_number, typed_value


@pytest.mark.parametrize(
    ("text", "number"),
    [
        ("0.5", 0.5),
        ("-0.1", -0.1),
        ("0,25", 0.25),
        ("1/3", 1 / 3),
        ("-1/3", -1 / 3),
        ("2 * -3", -6),
        ("1e5-1", 99999),
        ("3-1*2", 1),
        ("+0.1", 0.8),
        (" + 0,1 ", 0.8),
        ("+1e-1", 0.8),
        ("+-0.1", 0.6),
        ("+\N{MINUS SIGN}0.1", 0.6),
        ("+1/3", 31 / 30),
        ("*2", 1.4),
        ("*1/2", 0.35),
        ("/2", 0.35),
    ],
)
def test_a_calculation_is_worked_out(text, number):
    assert typed_value(text, 0.7) == number


@pytest.mark.parametrize(
    "text", ["abc", "+", "1+", "1/0", "/0", "--1", "-+1", "1 2", "1 2+3", "5%", "1_0", "0x10", "nan"]
)
def test_what_is_no_calculation_comes_back_to_be_refused(text):
    assert typed_value(text, 0.7) == text


def test_nothing_is_nothing_and_a_cell_of_a_block_is_never_a_calculation():
    assert typed_value("  ", 0.7) is None
    assert typed_number("+0.1") == 0.1
    assert typed_number("1/3") == "1/3"
