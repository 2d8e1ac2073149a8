"""What is typed into a field: numbers, and what makes another of the present one."""

import pytest

from qovr_app.state.typed_numbers import typed_value
from qovr_core import DocumentError
from qovr_core.checks import checked_number


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
    assert typed_value(text, "X", checked_number, 0.7) == number


NONE = ["", "abc", "+", "1+", "1/0", "/0", "--1", "-+1", "1 2", "1 2+3", "5%", "1_0", "0x10", "nan", "1e999*2"]


@pytest.mark.parametrize("text", [*NONE, "1+" * 500 + "1"])
def test_what_is_no_calculation_is_refused(text):
    with pytest.raises(DocumentError, match="; expected a "):
        typed_value(text, "X", checked_number, 0.7)


def test_a_cell_of_a_block_is_never_a_calculation():
    assert typed_value("+0.1", "X", checked_number) == 0.1
    with pytest.raises(DocumentError):
        typed_value("1/3", "X", checked_number)
