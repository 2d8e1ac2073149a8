"""Changing one thing that the view shows."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D


def change(view: View3D, **changes: Any) -> None:
    """Show the same with these fields of ``Shown`` changed."""
    view.display(replace(view.shown, **changes))


def select(view: View3D, index: tuple[int, int] | None) -> None:
    """Mark a control point, or none."""
    change(view, selected=frozenset(() if index is None else (index,)), last_selected=index)
