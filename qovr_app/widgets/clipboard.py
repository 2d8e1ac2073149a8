"""The clipboard as tables see it: texts and HTML tables, out and in."""

from __future__ import annotations

from collections.abc import Sequence

from PySide6.QtCore import QMimeData
from PySide6.QtGui import QGuiApplication

from qovr_app.state.html_tables import Shown, html_cells, html_table
from qovr_app.state.latex_tables import latex_table
from qovr_app.state.typed import Cell, Cells, text_cells
from qovr_core.number_texts import block_text

Rows = Sequence[Sequence[Cell | Shown]]
"""What is copied: numbers and words, row by row."""


def copy_table(rows: Rows) -> None:
    """Copy rows as a text parted by tabs, with decimal points, and as an HTML table with numbers as numbers."""
    data = QMimeData()
    data.setText(block_text([[cell.text if isinstance(cell, Shown) else cell for cell in row] for row in rows]))
    data.setHtml(html_table(rows))
    QGuiApplication.clipboard().setMimeData(data)


def copy_latex(rows: Rows) -> None:
    """Copy rows, the first of which are headings, as a table for LaTeX."""
    QGuiApplication.clipboard().setText(latex_table(rows))


def pasted_cells() -> Cells:
    """Return the cells on the clipboard: those of its HTML table, which says numbers in full, else those of its text.

    Raises
    ------
    DocumentError : the text can be read in two ways
    """
    data = QGuiApplication.clipboard().mimeData()
    return (html_cells(data.html()) if data.hasHtml() else []) or text_cells(data.text())
