"""What is typed and pasted: one decimal separator a block, headings, tables of spreadsheets; refused with the cell."""

import math

import pytest

from qovr_app.state.html_tables import html_cells, html_table
from qovr_app.state.typed import is_block, text_cells, typed_block
from qovr_app.state.typed_numbers import typed_number, typed_value
from qovr_core import DocumentError
from qovr_core.checks import checked_number


@pytest.mark.parametrize(
    "text", ["-0.5", "−0.5", "‑0,5", "–0,5", "\u00a0-0.5\u202f", "\u2009−,5\ufeff", "\u200e-5e-1\u200b"]
)
def test_a_typed_number(text):
    assert typed_number(text) == -0.5


@pytest.mark.parametrize(
    "text", ["1,234.5", "1 234", "1\u202f234,5", "1.234,5", "1'234", "1’234.5", "1_234", "1,234,567"]
)
def test_a_group_separator_is_never_taken(text):
    with pytest.raises(DocumentError, match=r"X is .*expected a number without group separators"):
        typed_value(text, "X", checked_number)


@pytest.mark.parametrize("text", ["٣", "３.5", "१", "0.²", "-٠٫٥"])
def test_digits_of_other_scripts_are_refused_in_words(text):
    with pytest.raises(DocumentError, match="in the digits 0 to 9"):
        typed_value(text, "X", checked_number)


def test_a_million_digits_are_refused_at_once():
    with pytest.raises(DocumentError) as refused:
        typed_value("9" * 10**6, "X", checked_number)
    assert len(str(refused.value)) < 120
    with pytest.raises(DocumentError) as refused:
        typed_value("9" * 10**6 + "x", "X", checked_number)
    assert len(str(refused.value)) < 120


SAME = [[1.5, 2.0, -3.25], [4.0, 0.5, 6.0]]


@pytest.mark.parametrize(
    "text",
    [
        "1.5\t2\t-3.25\n4\t.5\t6",
        "1,5\t2\t−3,25\r\n4\t0,5\t6\r\n",
        "1.5;2;-3.25\n4;0.5;6",
        "1,5 ; 2 ; -3,25 \n 4;0,5;6;\n".replace("-3,25 \n", "-3,25;\n"),
        "1.5,2,-3.25\n4,0.5,6\n",
        '"1.5", "2", "-3.25"\n"4","0.5","6"',
        '"1,5";"2";"-3,25"\n"4";"0,5";"6"',
        "x\ty\tz\n1.5\t2\t-3.25\n4\t0.5\t6",
        "\tx\ty\tz\nP 0,0\t1.5\t2\t-3.25\nP 0,1\t4\t0.5\t6",
        "i;j;x;y;z\n0;0;1,5;2;-3,25\n0;1;4;0,5;6",
        "0\t0\t1.5\t2\t-3.25\n0\t1\t4\t0.5\t6",
        "\t0\t1\t2\n1\t1.5\t2\t-3.25\n0\t4\t0.5\t6",
        "3\t1.5\t2\t-3.25\n4\t4\t0.5\t6",
        "C_1,1.5,2,-3.25\nC_0,4,0.5,6",
    ],
)
def test_one_table_in_many_hands(text):
    assert is_block(text_cells(text))
    assert typed_block(text, lambda rows, columns: (rows, columns) == (2, 3)) == SAME


@pytest.mark.parametrize(
    ("text", "place"),
    [
        ("1,234\t12.5\t0", r"row 1, column 2 of what is pasted is '12\.5'; expected a decimal comma"),
        ("12.5\t0\n7\t1,234", r"row 2, column 2 of what is pasted is '1,234'; expected a decimal point"),
        ("1,5;2.5", "row 1, column 2"),
        ("1\tx\t3", "row 1, column 2 of what is pasted is 'x'"),
        ("x\ty\n1\t2\n3\t", "row 3, column 2 of what is pasted is empty"),
        ("#DIV/0!\t1\t2", "row 1, column 1"),
        ("nan\t1\t2", "row 1, column 1"),
        ("1,234,567\t2\t3", "row 1, column 1 of what is pasted is '1,234,567'"),
        ("1,234,567\n2,345,678", "row 1 of what is pasted is '1,234,567'; expected .*without group separators"),
        ("1,234.5", "without group separators"),
        ("1\t2\n3", "row 2 of what is pasted is 1 cells long"),
        ("1\t٣", "row 1, column 2"),
        ("x\ty", "row 1, column 2"),
        (" \t \n", "empty"),
        ('"1\t2', "row 1, column 1"),
    ],
)
def test_a_block_is_refused_as_a_whole_with_the_cell(text, place):
    with pytest.raises(DocumentError, match=place):
        typed_block(text)


def test_a_column_with_decimal_commas_is_one_column():
    assert typed_block("0,1\n0,25\n−3,5\n4") == [[0.1], [0.25], [-3.5], [4]]
    assert not is_block(text_cells("0,25\n"))


def test_whole_numbers_that_fit_are_no_index():
    assert typed_block("0\t1\n1\t2", lambda rows, columns: (rows, columns) in ((2, 2), (2, 1))) == [[0, 1], [1, 2]]


def test_numbers_go_through_html_and_back_in_full():
    rows = [["<b>&\"'", 1 / 3], ["", -2.5e-300], ["x", 5e-324], ["y", 123456789.125]]
    text = html_table(rows)
    assert "<b>" not in text
    assert html_cells(text) == rows
    assert text.count('sdnum="1033;"') == text.count('sdval="') == text.count('x:num="') == 4


def test_tables_of_spreadsheets_bring_the_numbers_behind_the_texts():
    german = '<table><tr><td sdval="1,23456" sdnum="1031;">1,23</td><td sdval="-7" sdnum="1031;">-7</td></tr></table>'
    assert html_cells(german) == [[1.23456, -7.0]]
    excel = '<html><body><table><tr><td x:num>2,5</td><td x:num="3.256">3,26</td><td>4,5&nbsp;</td></tr></table>'
    assert typed_block(html_cells(excel)) == [[2.5, 3.256, 4.5]]
    web = "<p>x<table><thead><tr><th>x<th>y<tbody><tr><td>&minus;1.5<td><b>2</b>.5</table><table><tr><td>9</table>"
    assert html_cells(web) == [["x", "y"], ["−1.5", "2.5"]]
    assert typed_block(html_cells(web)) == [[-1.5, 2.5]]


@pytest.mark.parametrize(
    "text", ["", "<p>1.5</p>", "<table></table>", "<table><tr></tr></table>", "<td>1", "<![x", "</table>"]
)
def test_a_page_without_a_table_has_no_cells(text):
    assert html_cells(text) == []


def test_a_number_too_large_to_be_one_is_left_to_the_check():
    assert math.isinf(typed_block("1\t1e999")[0][1])
