"""From intents to steps of the session, and from the session's document to what zones and view show."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import TypeVar

from PySide6.QtCore import QObject, QTimer, Signal

from qovr_app.state.names import ZONE_TITLES, edit_text
from qovr_app.window.session import Session
from qovr_core import Document, Evaluation, Formulation, QovrError, edits
from qovr_core.arrays import Array
from qovr_core.edits import KnotPlace, Place, Zone

_T = TypeVar("_T")


@dataclass(frozen=True, eq=False)
class State:
    """Everything that zones and window show.

    Parameters
    ----------
    document : the active state
    draft : the same with what is edited and not yet set
    evaluation : of the document configured last; None where there is none
    """

    document: Document
    draft: Document
    evaluation: Evaluation | None

    @property
    def is_stale(self) -> bool:
        """Whether the surface is not that of the document."""
        return self.evaluation is None or self.evaluation.document != self.document


class Controller(QObject):
    """Turns what the user wants into the next document, and every new document into an evaluation.

    Live, an edit is set at once and the surface follows. Staged, an edit goes into the draft, ``set_zone`` brings a
    zone of the draft into the document, and ``configure`` computes. However often the document changes within one turn
    of the event loop, it is computed and shown once.

    Signals
    -------
    evaluation_changed : an Evaluation to show, and the document whose net is shown: a stale surface has a newer one
    state_changed : a State
    refused : one sentence that says why something was not done; empty when that is outdated
    """

    evaluation_changed = Signal(object, object)
    state_changed = Signal(object)
    refused = Signal(str)

    def __init__(self, session: Session, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._session = session
        self._draft = session.document
        self._evaluation: Evaluation | None = None
        self._shown: tuple[Evaluation | None, Document | None] = (None, None)
        self._is_live = self._links_curves = True
        self._links_directions = False
        self._turn = QTimer(self, singleShot=True, interval=0)
        self._turn.timeout.connect(self.settle)
        session.document_changed.connect(self._on_document_changed)
        session.opened.connect(self._on_opened)

    @property
    def state(self) -> State:
        """What is to be shown now."""
        return State(self._session.document, self._draft, self._evaluation)

    # How edits are taken

    def set_live(self, is_live: bool) -> None:
        """Choose whether edits are set at once; choosing so sets what is pending."""
        self._is_live = is_live
        if is_live:
            self._session.apply("Set pending values", self._draft)
        self._turn.start()

    def link_curves(self, is_linked: bool) -> None:
        """Choose whether the five curves of a direction share their knots from now on."""
        self._links_curves = is_linked

    def link_directions(self, is_linked: bool) -> None:
        """Choose whether rows and columns share their knots from now on."""
        self._links_directions = is_linked

    # Intents

    def edit(self, values: Mapping[Place, float], gesture: int = 0) -> None:
        """Change numbers, and those that are linked to them."""
        wanted = dict(values)
        for place, value in values.items():
            if isinstance(place, KnotPlace):
                links = {"curves": self._links_curves, "directions": self._links_directions}
                wanted |= dict.fromkeys(edits.linked_places(place, **links), value)
        self._change(edit_text(list(wanted)), lambda document: edits.set_values(document, wanted), gesture)

    def paste(self, values: Mapping[Place, float]) -> None:
        """Change exactly these numbers."""
        kinds = {
            Zone(place.direction.value) if isinstance(place, KnotPlace) else Zone.CONTROL_POINTS for place in values
        }
        name = " and ".join(ZONE_TITLES[zone].lower() for zone in kinds)
        self._change(f"Paste {name}", lambda document: edits.set_values(document, values))

    def set_zone(self, zone: Zone, typed: Mapping[Place, float]) -> None:
        """Bring a zone of the draft, and what is typed over it, into the document."""
        with_typed = self._tried(lambda: edits.set_values(self._draft, typed))
        if with_typed is not None:
            self._draft = with_typed
            document = edits.copy_zone(with_typed, self._session.document, zone)
            self._session.apply(f"Set {ZONE_TITLES[zone].lower()}", document)
            self._turn.start()

    def get_zone(self, zone: Zone) -> None:
        """Bring a zone of the document into the draft."""
        self._draft = edits.copy_zone(self._session.document, self._draft, zone)
        self._turn.start()

    def set_formulation(self, formulation: Formulation) -> None:
        """Choose another formulation."""
        self._set(f"Choose {formulation}", lambda document: edits.set_formulation(document, formulation))

    def set_samples(self, samples: tuple[int, int]) -> None:
        """Choose other sample counts along u and v."""
        n, m = samples
        self._set(f"Set samples {n} × {m}", lambda document: edits.set_samples(document, samples))

    def drag_point(self, i: int, j: int, point: Array, gesture: int) -> None:
        """Move a control point as part of a drag; ``point`` is (3,) in the document's units."""

        def move(document: Document) -> Document:
            return edits.set_point(document, i, j, point)

        if self._set(f"Move P {i},{j}", move, gesture):
            self._draft = move(self._draft)

    def configure(self) -> None:
        """Compute the surface of the document as it stands, now."""
        evaluation = self._tried(lambda: Evaluation(self._session.document))
        if evaluation is not None:
            self._evaluation = evaluation
        self._show()

    def settle(self) -> None:
        """Compute and show now what this turn of the event loop would end with."""
        if self._evaluation is None or (self._is_live and self.state.is_stale):
            self.configure()
        else:
            self._show()

    # The one way

    def _change(self, text: str, edit: Callable[[Document], Document], gesture: int = 0) -> None:
        """Apply an edit to the document, or to the draft where edits are staged."""
        if self._is_live:
            self._set(text, edit, gesture)
            return
        draft = self._tried(lambda: edit(self._draft))
        self._draft = draft or self._draft
        self._turn.start()

    def _set(self, text: str, edit: Callable[[Document], Document], gesture: int = 0) -> bool:
        document = self._tried(lambda: edit(self._session.document))
        if document is not None:
            self._session.apply(text, document, gesture or None)
        self._turn.start()
        return document is not None

    def _tried(self, work: Callable[[], _T]) -> _T | None:
        try:
            return work()
        except QovrError as error:
            self.refused.emit(f"{error}.")
            return None

    def _on_document_changed(self, before: Document, after: Document) -> None:
        self._draft = after if self._is_live else edits.rebase(self._draft, before, after)
        self._turn.start()

    def _on_opened(self) -> None:
        self._draft = self._session.document
        self._turn.start()

    def _show(self) -> None:
        self._turn.stop()
        state = self.state
        evaluation, shown = state.evaluation, (state.evaluation, state.document)
        if evaluation is not None and shown != self._shown:
            self._shown = shown
            # A later document's net is shown, but not its knots: they may be such that no curve can be drawn.
            document = edits.copy_zone(state.document, evaluation.document, Zone.CONTROL_POINTS)
            self.evaluation_changed.emit(evaluation, document if state.is_stale else evaluation.document)
        self.state_changed.emit(state)
