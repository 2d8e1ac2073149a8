"""An influence in numbers: as the table shows them, and in full for a spreadsheet."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import Qt
from PySide6.QtGui import QPalette
from PySide6.QtWidgets import QAbstractItemView, QHeaderView, QWidget

from qovr_app.laboratory.wording import list_text, motion_text, value_text
from qovr_app.style.fonts import number_font
from qovr_app.style.palette import see_through
from qovr_app.widgets.clipboard import Rows
from qovr_app.widgets.quiet_table import QuietTable
from qovr_core import Document
from qovr_core.laboratory.falloff import EXPONENTIAL_MISFIT, Exponential, Falloff
from qovr_core.laboratory.influence import Influence, Reach
from qovr_core.number_texts import percent_text

DISTANCE = "d is the distance in u and v from the place of the largest displacement."
_ROW_BEYOND_TEXT = 2


@dataclass(frozen=True)
class Fact:
    """One line of the table: a name, what it comes to, and what it means."""

    name: str
    text: str
    tip: str


def facts(influence: Influence, fall: Falloff) -> list[Fact]:
    """Return the lines of the table for an influence and how it falls off."""
    (u, v), corner = influence.place, float(influence.corners.max())
    still = zip("uv", (influence.still_u, influence.still_v), strict=True)
    return [
        Fact("Largest", value_text(influence.largest), "Length of the largest displacement"),
        Fact("at", f"u {u:.3f}, v {v:.3f}", "Where the displacement is largest"),
        *map(_reach_fact, influence.reaches),
        *(
            Fact(f"Edge {edge.replace('=', ' = ')}", motion_text(motion), "Largest motion along this edge")
            for edge, motion in influence.edges.items()
        ),
        Fact("Corners", motion_text(corner) if corner else "stay", "Largest motion of the four corners"),
        *(
            Fact(f"Still at {name}", list_text(values) or "none", f"Lines of constant {name} that do not move at all")
            for name, values in still
        ),
        *_exponential_facts(fall.exponential),
    ]


def _reach_fact(reach: Reach) -> Fact:
    part = percent_text(reach.part)
    return Fact(
        f"Over {part}",
        f"{percent_text(reach.area)}, to d {reach.distance:.2f}",
        f"Share of the unit square of u and v that moves by more than {part} of the largest displacement, "
        f"and the farthest distance d at which it does. {DISTANCE}",
    )


def _exponential_facts(best: Exponential) -> list[Fact]:
    return [
        Fact(
            "Exponential",
            "fits" if best.fits else "does not fit",
            f"It fits where it misses the envelope by no more than {percent_text(EXPONENTIAL_MISFIT)} of the largest "
            "displacement",
        ),
        Fact(
            "nearest",
            f"A {best.amplitude:.3g}, L {best.length:.3g}",
            f"A e^(−d/L), nearest to the envelope by least squares. {DISTANCE}",
        ),
        Fact(
            "off by",
            f"{percent_text(best.misfit)} (rms)",
            "Root mean square distance of the envelope from that exponential, in percent of the largest displacement",
        ),
    ]


def copied_rows(what: str, document: Document, influence: Influence, fall: Falloff) -> Rows:
    """Return all numbers with every digit, and the envelope as a table below them."""
    best = fall.exponential
    lines: list[tuple[str, float]] = [
        ("largest displacement", influence.largest),
        ("at u", influence.place[0]),
        ("at v", influence.place[1]),
    ]
    for reach in influence.reaches:
        lines.append((f"share of the unit square above {percent_text(reach.part)}", reach.area))
        lines.append((f"farthest distance above {percent_text(reach.part)}", reach.distance))
    lines += [(f"largest motion of edge {edge}", motion) for edge, motion in influence.edges.items()]
    lines += [(f"motion of corner u={u} v={v}", float(influence.corners[u, v])) for u in (0, 1) for v in (0, 1)]
    lines += [("line that stays, u", c) for c in influence.still_u]
    lines += [("line that stays, v", c) for c in influence.still_v]
    lines += [("exponential A", best.amplitude), ("exponential L", best.length), ("misfit", best.misfit)]
    head = [("change", what), ("surface", f"{document.formulation}, {influence.layer}"), *lines]
    return [*head, (), ("distance", "largest displacement"), *fall.envelope.tolist()]


class FactTable(QuietTable):
    """Two columns, names and what they come to."""

    def __init__(self, name: str, spoken: str, parent: QWidget | None = None) -> None:
        super().__init__((0, 2), name, spoken, parent)
        self.setFont(number_font(self.font()))
        self.setPalette(see_through(self.palette()))
        self.setSelectionBehavior(QAbstractItemView.SelectionBehavior.SelectRows)
        self.setWordWrap(False)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        across, down = self.horizontalHeader(), self.verticalHeader()
        for header in (across, down):
            header.setVisible(False)
            header.setMinimumSectionSize(8)
        down.setDefaultSectionSize(self.fontMetrics().height() + _ROW_BEYOND_TEXT)
        across.setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        across.setSectionResizeMode(1, QHeaderView.ResizeMode.Stretch)

    def show_facts(self, lines: list[Fact]) -> None:
        """Show these lines instead of those before."""
        if self.rowCount() != len(lines):
            self.setRowCount(len(lines))
        for row, fact in enumerate(lines):
            for column, text in enumerate((fact.name, fact.text)):
                item = self.item(row, column)
                if item.text() != text or item.toolTip() != fact.tip:
                    item.setText(text)
                    item.setToolTip(fact.tip)
        self.style_headers()

    def style_headers(self) -> None:
        """Write the names, which head their lines, in the quiet ink of the theme in force."""
        for row in range(self.rowCount()):
            self.item(row, 0).setForeground(self.palette().brush(QPalette.ColorRole.PlaceholderText))

    @property
    def whole_height(self) -> int:
        """How high it is with all its lines."""
        return self.verticalHeader().defaultSectionSize() * self.rowCount() + 2
