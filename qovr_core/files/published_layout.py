"""Where everything stands in the published workbooks: sheet 1, titles in row 2, headers in row 4, numbers from row 5.

The sheet spells its headers as the published ones do, a Turkish capital I with dot included.
"""

from __future__ import annotations

TITLE_ROW = 2
FIRST_ROW = 5
LAST_ROW_OF_A_SHEET = 1_048_576
MOST_POINTS = LAST_ROW_OF_A_SHEET - FIRST_ROW + 1

TITLES = {
    "C": "Control Points",
    "I": "Control Points Bounding Box",
    "N": "QOVR Surface Raw Coordinates",
    "R": "Surface Bounding Box",
    "V": "Transformation Matrix",
    "AA": "Transformed QOVR Surface Coordinates",
    "AG": "Row-wise internal parametric knots",
    "AM": "Column-wise internal parametric knots",
}
HEADERS = {
    **dict(zip("BCDEFG", ("#", "İ", "J", "Pij_X", "Pij_Y", "Pij_Z"), strict=True)),
    **dict(zip("JK", ("min", "max"), strict=True)),
    **dict(zip("MNOP", ("#", "Suv_X", "Suv_Y", "Suv_Z"), strict=True)),
    **dict(zip("ST", ("min", "max"), strict=True)),
    **dict(zip("VWXY", "xyzh", strict=True)),
    **dict(zip(("AA", "AB", "AC", "AD"), ("#", "Suv_X'", "Suv_Y'", "Suv_Z'"), strict=True)),
    **dict(zip(("AG", "AH", "AI", "AJ"), ("rip_C", "sip_C", "uip", "tip_C"), strict=True)),
}

NET = "B"
CONTROL_BOX = "I"
RAW = "M"
RAW_BOX = "R"
MATRIX = "V"
TRANSFORMED = "AA"
ROW_KNOTS = "AF"
COLUMN_KNOTS = "AL"

TRANSFORMED_DECIMALS = 5
"""The published workbooks round the transformed coordinates, and only them."""

ROW_CURVE_NAMES = ("C_4", "C_3", "C_2", "C_1", "C_0")
COLUMN_CURVE_NAMES = ("K_0", "K_1", "K_2", "K_3", "K_4")
COLUMN_KNOT_NAMES = ("tip_K", "vip", "sip_K", "rip_K")
"""Downward from the first row: the tables stand as the net lies in space, rows upward; so does the knots' order r, s,
v, t of a column, which is that of a row from left to right."""

RECORD_SHEET = "Document"
"""A second sheet for what the published layout has no place for: formulation, samples, and the exact document."""

RECORD_OF_DOCUMENT = "document"
CELL_ROUNDING = 1e-15
"""Cells hold 16 digits: the recorded document counts where every cell is its number to this part."""


def column_index(letters: str) -> int:
    """Return the zero-based index of a column."""
    index = 0
    for letter in letters:
        index = index * 26 + ord(letter) - ord("A") + 1
    return index - 1


def column_letters(index: int) -> str:
    """Return the letters of a zero-based column."""
    letters = ""
    index += 1
    while index:
        index, rest = divmod(index - 1, 26)
        letters = chr(ord("A") + rest) + letters
    return letters
