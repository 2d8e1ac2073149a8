"""The dialogs of moves by numbers: what they ask, and what is seen of it meanwhile."""

from __future__ import annotations

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QWidget

from qovr_app.state.gestures import next_gesture
from qovr_app.state.intents import GestureBegun, GestureCancelled, GestureEnded
from qovr_app.state.looking_intents import ToolChosen
from qovr_app.state.names import points_text
from qovr_app.state.point_intents import PointsEdited
from qovr_app.state.readouts import moved_text
from qovr_app.store import Store
from qovr_core.net_edits import Transform

_FROM_EDGE = 24


def ask_transform(store: Store, window: QWidget, view: QWidget) -> None:
    """Ask by how much the points that are selected now are to be moved; the view shows it at once, Cancel puts back."""
    from qovr_app.dialogs.transform_dialog import TransformDialog

    begun, gesture = store.state.document, next_gesture()
    indices = store.state.selection.indices
    dialog = TransformDialog(points_text(indices), begun.net_size, window)

    def preview(edit: Transform) -> None:
        error = store.dispatch(PointsEdited(edit, indices, gesture))
        dialog.say(f"{error}." if error else moved_text(indices, begun, store.state.document), is_refusal=bool(error))

    store.dispatch(GestureBegun(gesture))
    preview(Transform())
    dialog.changed.connect(preview)
    dialog.accepted.connect(lambda: store.dispatch(GestureEnded(gesture)))
    dialog.rejected.connect(lambda: store.dispatch(GestureCancelled(gesture)))
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()
    # in a corner of the view: the numbers that change meanwhile stay in sight, and so does most of the surface
    place = QPoint(view.width() - dialog.width() - _FROM_EDGE, view.height() - dialog.height() - _FROM_EDGE)
    dialog.move(view.mapToGlobal(QPoint(max(0, place.x()), max(0, place.y()))))


def ask_symmetry(store: Store, window: QWidget) -> None:
    """Ask in which planes rows and columns mirror each other."""
    from qovr_app.dialogs.symmetry_dialog import SymmetryDialog

    state = store.state
    dialog = SymmetryDialog(
        (state.tools.mirror_columns, state.tools.mirror_rows), state.document.control_points, window
    )

    def choose() -> None:
        for setting, mirror in zip(("mirror_columns", "mirror_rows"), dialog.mirrors, strict=True):
            store.dispatch(ToolChosen(setting, mirror))

    dialog.accepted.connect(choose)
    dialog.finished.connect(dialog.deleteLater)
    dialog.open()
