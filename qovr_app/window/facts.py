"""What the status bar says of the surface that was configured last."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.state.editor_state import EditorState


class Facts(QLabel):
    """Formulation, samples and degree at the window's lower edge."""

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent)
        self.setObjectName("surface.facts")

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Say what holds in a state."""
        if after.differs(before, "document", "evaluation"):
            self.setText(_facts_text(after))


def _facts_text(state: EditorState) -> str:
    if state.evaluation is None:
        return "no surface "
    (degree_u, degree_v), document = state.evaluation.degree, state.evaluation.document
    n, m = document.samples
    stale = "stale   " if state.is_stale else ""
    return f"{stale}{document.formulation}   {n} × {m} samples   degree {degree_u} × {degree_v} "
