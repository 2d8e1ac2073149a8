"""Tables for LaTeX, with nothing but what every LaTeX knows."""

from __future__ import annotations

import re
from collections.abc import Sequence

from qovr_app.state.html_tables import Shown
from qovr_app.state.typed import Cell
from qovr_app.state.typed_numbers import typed_number
from qovr_core.number_texts import MINUS

_SIGNS = {
    **{sign: f"\\{sign}" for sign in "&%$#_{}"},
    "\\": r"\textbackslash{}",
    "~": r"\textasciitilde{}",
    "^": r"\textasciicircum{}",
    "<": "$<$",
    ">": "$>$",
    "|": "$|$",
    MINUS: "$-$",
    "×": r"$\times$",
    "…": r"\ldots{}",
    "\n": " ",
}
"""What has a meaning of its own in LaTeX, or is in no font of its first encoding."""

_POWER = re.compile(rf"(?<![\w.])([-{MINUS}]?\d+(?:\.\d+)?)e([-+{MINUS}]?\d+)(?!\w)")


def latex_table(rows: Sequence[Sequence[Cell | Shown]]) -> str:
    """Return rows, the first of which are headings, as a ``tabular``; columns of numbers stand to the right."""
    texts = [[cell.text if isinstance(cell, Shown) else str(cell) for cell in row] for row in rows]
    width = max(map(len, texts), default=0)
    texts = [row + [""] * (width - len(row)) for row in texts]
    columns = "".join("r" if _is_of_numbers([row[k] for row in texts[1:]]) else "l" for k in range(width))
    head, *lines = (" & ".join(map(latex_text, row)) + r" \\" for row in texts) if texts else ("",)
    return "\n".join([rf"\begin{{tabular}}{{{columns}}}", head, r"\hline", *lines, r"\end{tabular}", ""])


def latex_text(text: str) -> str:
    """Return a text as LaTeX reads it; numbers with an exponent become powers of ten.

    Examples
    --------
    >>> print(latex_text("s_ip: 5 % & 2e-5"))
    s\\_ip: 5 \\% \\& $2 \\times 10^{-5}$
    """
    parts, end = [], 0
    for power in _POWER.finditer(text):
        mantissa, exponent = (part.replace(MINUS, "-").removeprefix("+") for part in power.groups())
        parts += [_escaped(text[end : power.start()]), rf"${mantissa} \times 10^{{{exponent}}}$"]
        end = power.end()
    return "".join([*parts, _escaped(text[end:])])


def _escaped(text: str) -> str:
    return "".join(_SIGNS.get(sign, sign) for sign in text)


def _is_of_numbers(texts: Sequence[str]) -> bool:
    """Whether most of what stands in a column is a number, perhaps with a per cent sign."""
    filled = [text for text in texts if text]
    numbers = [text for text in filled if isinstance(typed_number(text.removesuffix("%").strip()), float)]
    return 2 * len(numbers) > len(filled)
