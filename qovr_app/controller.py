"""From intents to steps of the session, and from the session's document to what the view shows."""

from __future__ import annotations

from PySide6.QtCore import QObject, QTimer, Signal

from qovr_app.session import Session
from qovr_core import AlignedPatch, Document, QovrError, align_patch, edits
from qovr_core.arrays import Array


class Controller(QObject):
    """Turns what the user wants into the next document, and every new document into a result.

    However often the document changes within one turn of the event loop, it is computed once.

    Signals
    -------
    result_changed : an AlignedPatch to show
    refused : one sentence that says why something was not done
    """

    result_changed = Signal(object)
    refused = Signal(str)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._turn = QTimer(self, singleShot=True, interval=0)
        self._turn.timeout.connect(self._compute)
        session.document_changed.connect(self._on_document_changed)

    def compute(self) -> None:
        """Compute the document as it stands, in this turn of the event loop."""
        self._turn.start()

    def drag_point(self, i: int, j: int, point: Array, gesture: int) -> None:
        """Move a control point as part of a drag; ``point`` is (3,) in the document's units."""
        try:
            document = edits.set_point(self._session.document, i, j, point)
        except QovrError as error:
            self.refused.emit(str(error))
            return
        self._session.apply(f"Move P {i},{j}", document, gesture)

    def _on_document_changed(self, _before: Document, _after: Document) -> None:
        self._turn.start()

    def _compute(self) -> None:
        try:
            result: AlignedPatch = align_patch(self._session.document)
        except QovrError as error:
            self.refused.emit(str(error))
            return
        self.result_changed.emit(result)
