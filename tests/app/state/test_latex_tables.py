"""Tables for LaTeX."""

import pytest

from qovr_app.state.html_tables import Shown
from qovr_app.state.latex_tables import latex_table, latex_text


def test_a_table_has_its_headings_over_a_line_and_numbers_to_the_right():
    rows = [["measure", "QOVR", "B-spline"], ["area > 1 %", Shown("73.6 %", 0.736), "no joints"], ["a_b", 0.25, ""]]
    assert latex_table(rows) == (
        "\\begin{tabular}{lrl}\n"
        "measure & QOVR & B-spline \\\\\n"
        "\\hline\n"
        "area $>$ 1 \\% & 73.6 \\% & no joints \\\\\n"
        "a\\_b & 0.25 &  \\\\\n"
        "\\end{tabular}\n"
    )


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("M^-1 {x} # 5$ ~ \\", r"M\textasciicircum{}-1 \{x\} \# 5\$ \textasciitilde{} \textbackslash{}"),
        ("off by 2e\N{MINUS SIGN}5, at most 1.5e+300", r"off by $2 \times 10^{-5}$, at most $1.5 \times 10^{300}$"),
        ("\N{MINUS SIGN}0.5", "$-$0.5"),
        ("name3e4x", "name3e4x"),
        ("P&Q\nR", r"P\&Q R"),
    ],
)
def test_what_latex_would_take_for_its_own_is_escaped(text, expected):
    assert latex_text(text) == expected
