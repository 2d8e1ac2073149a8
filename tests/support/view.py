"""A 3D view whose owner changes one thing at a time."""

from dataclasses import replace

from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QWheelEvent
from PySide6.QtWidgets import QApplication

from qovr_app.view3d.scene.grid import Grid
from qovr_core import Evaluation


def change(view, **changes):
    """Show the same with these fields of Shown changed; ``document`` changes the surface and its net."""
    if "document" in changes:
        changes["evaluation"] = Evaluation(changes.pop("document"))
    view.display(replace(view.shown, **changes))


def grid(n, m):
    """Return the grid of so many vertices along u and along v of one window."""
    return Grid((n - 1,), (m - 1,))


def choose(view, **settings):
    """Show the same with these display settings changed."""
    change(view, settings=replace(view.shown.settings, **settings))


def select(view, *indices):
    """Mark control points, the last one being the one that was picked last; none to mark none."""
    change(view, selected=frozenset(indices), last_selected=indices[-1] if indices else None)


def wheel(viewport, at, notches):
    """Turn the wheel by so many notches at a pixel."""
    position = QPointF(*at)
    none = Qt.KeyboardModifier.NoModifier
    event = QWheelEvent(
        position,
        viewport.mapToGlobal(position),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        none,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(viewport, event)
