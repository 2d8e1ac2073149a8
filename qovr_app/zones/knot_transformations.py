"""Under the knots: what they do to the curve's parameters, with the knots as handles."""

from __future__ import annotations

from PySide6.QtCore import QSize
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QLabel, QVBoxLayout, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import in_window, opposite
from qovr_app.state.knot_in_hand import KnotInHand
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.style.symbols import symbol_html
from qovr_app.widgets.knot_canvas import LOWEST
from qovr_app.widgets.knot_plot import KnotPlot
from qovr_core.edits import Zone, knots_of
from qovr_core.geometry.knots import Direction, KnotPlace


class KnotTransformations(QWidget):
    """The transformations of the curve of a direction that was turned to last, as its knots are in the draft."""

    def __init__(self, direction: Direction, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._direction = direction
        self._title = QLabel(self)
        self._plot = KnotPlot(f"{direction}.transformations", store, self)
        self._title.setFont(self._plot.small_font)
        self._plot.hovered.connect(self._plot.show_hover)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 2 * SPACE, 0, 0)
        layout.setSpacing(SPACE)
        layout.addWidget(self._title)
        layout.addWidget(self._plot, 1)

    def sizeHint(self) -> QSize:
        """Return no height of its own: it fills what the fields leave."""
        return self.minimumSizeHint()

    def minimumSizeHint(self) -> QSize:
        return QSize(self._plot.minimumSizeHint().width(), 0)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._title.setVisible(self.height() >= LOWEST + self._title.sizeHint().height() + 3 * SPACE)

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the curve in focus, or the one whose knot had the keyboard last; at first, the first that counts."""
        if not after.differs(before, "draft", "fields", "window"):
            return
        place = after.fields.get(Zone(self._direction.value))
        if not isinstance(place, KnotPlace):
            first, *_ = after.draft.formulation.active_curves(self._direction) or (0,)
            place = in_window(KnotPlace(self._direction, first, "u"), after.window)
        knots = knots_of(after.draft, self._direction)[place.curve, place.window]
        self._plot.show_curve(KnotInHand(place, knots))
        name = symbol_html(self._direction.letter, str(in_window(place, opposite(after.window)).curve))
        self._title.setText(f"Transformations of {name}(<i>{self._direction.parameter}</i>)")
