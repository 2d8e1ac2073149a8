"""The same net the other way round: rows for columns, backwards, or its mirror image."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from qovr_core.document import Document
from qovr_core.geometry.knots import Direction, KnotTable
from qovr_core.joints import Joints
from qovr_core.symmetry import OTHER_END, reversed_knots


def transpose(document: Document) -> Document:
    """Return the document with rows and columns exchanged: S(v, u) of the interpolating surface."""
    return Document(
        document.control_points.swapaxes(0, 1),
        document.column_knots,
        document.row_knots,
        document.formulation,
        document.samples[::-1],
        joints=Joints(document.joints.v, document.joints.u),
        closed=["uv"["vu".index(letter)] for letter in document.closed],
    )


def along_rows(document: Document, direction: Direction, edit: Callable[[Document], Document]) -> Document:
    """Return a document edited along the curves of a direction by what edits along the rows."""
    if direction is Direction.ROWS:
        return edit(document)
    return transpose(edit(transpose(document)))


def reverse(document: Document, direction: Direction) -> Document:
    """Return the document whose curves of a direction run the other way, their knots (1-t, 1-s, 1-u, 1-r).

    The interpolating surface is the same; others sum up differently from the other end.
    """

    def backwards(rows: Document) -> Document:
        turned = from_the_end(rows)
        return replace(turned, row_knots=KnotTable(reversed_knots(rows.row_knots.array)))

    return along_rows(document, direction, backwards)


def from_the_end(document: Document) -> Document:
    """Return the document with its columns and windows counted from the last, r and t exchanged, no number changed."""
    joints, inner = document.joints.u, document.windows[1] - 1
    return replace(
        document,
        control_points=document.control_points[:, ::-1],
        row_knots=KnotTable(document.row_knots.array[:, ::-1, OTHER_END]),
        column_knots=KnotTable(document.column_knots.array[::-1]),
        joints=replace(document.joints, u=joints[:inner][::-1] + joints[inner:]),
    )


def mirror_in_space(document: Document, axis: int) -> Document:
    """Return the document mirrored in the plane across axis 0, 1 or 2 through the middle of its points' box."""
    net = document.control_points.copy()
    along = net[..., axis]
    net[..., axis] = along.min() + (along.max() - along)
    return replace(document, control_points=net)
