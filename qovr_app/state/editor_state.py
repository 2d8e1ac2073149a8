"""The one state of an editor's window: every fact has its one holder here, or is derived from what is here."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import lru_cache
from pathlib import Path

from qovr_app.state.display import DisplaySettings, Placement
from qovr_app.state.history import History
from qovr_app.state.intents import Stamp
from qovr_app.state.knot_links import Links
from qovr_app.state.pending import with_typed
from qovr_app.state.tools import ToolSettings
from qovr_core import Document, Evaluation, ParametricSurface
from qovr_core.document import NetIndex, Window
from qovr_core.edits import Place, Zone, copy_zone, value_at
from qovr_core.geometry.knots import KnotPlace
from qovr_core.laboratory.comparison import DEFAULT_POINT, DEFAULT_WEIGHT

Focus = KnotPlace | NetIndex | None
"""The knot whose field has the keyboard, or the control point (i, j) that is selected, whichever came last."""

COMPARISON_PANEL = "comparison"
"""The panel of the laboratory while which is shown the view shows the surface compared with."""


@dataclass(frozen=True)
class Selection:
    """The selected control points; ``last`` is the one that was picked last, None where none is selected."""

    last: NetIndex | None = None
    points: frozenset[NetIndex] = frozenset()

    @property
    def indices(self) -> tuple[NetIndex, ...]:
        """The points in the net's order, after the one that was picked last."""
        first = () if self.last is None else (self.last,)
        return (*first, *sorted(self.points - {self.last}))


@dataclass(frozen=True, eq=False)
class Reference:
    """A surface in the document's units from which distances are taken; no edit and no other document changes it."""

    surface: ParametricSurface
    name: str


@dataclass(frozen=True)
class ComparisonChoice:
    """What the document's surface is compared with.

    Parameters
    ----------
    surface : the name of a record of ``COMPARISON_SURFACES``
    placement : where the view shows it; None for nowhere
    weight : of the measured point, in the surface that has weights
    """

    surface: str = "b-spline"
    placement: Placement | None = Placement.OVER
    weight: float = DEFAULT_WEIGHT


@dataclass(frozen=True)
class DocumentFile:
    """Where the document is kept.

    Parameters
    ----------
    title : what to call the document
    path : the ``.qovr`` file that Save writes; None where there is none yet
    stamp : the file's when it was read or written last
    found : the file's when it was looked at last
    preset : the name of the preset that the document was opened as, else empty
    opening : how many documents this window has opened
    """

    title: str
    path: Path | None = None
    stamp: Stamp | None = None
    found: Stamp | None = None
    preset: str = ""
    opening: int = 0

    @property
    def is_changed_outside(self) -> bool:
        """Whether somebody else has written or deleted the file since."""
        return self.path is not None and self.found != self.stamp


@dataclass(frozen=True)
class Message:
    """One sentence for the message line; a repeated one has another serial. What is said of a step is over with the
    next one, as a refusal is."""

    text: str
    is_refusal: bool = False
    serial: int = 0
    is_of_step: bool = False


@dataclass(frozen=True, eq=False)
class Gesture:
    """A drag in hand, and what it began with, which comes back where it is cancelled."""

    number: int
    history: History
    draft: Document


@dataclass(frozen=True, eq=False)
class EditorState:
    """Everything that a window shows; never changed, only followed by the next one.

    Parameters
    ----------
    history : the document, and those before and after it
    draft : the document with what is edited and not yet set
    texts : what fields hold that is not their number, by place
    evaluation : the surface configured last; None where there is none
    is_live : whether edits are set at once and the surface follows
    links : what shares a knot that is edited
    window : the window (a, b) of the net through which the zones read
    selection : the selected control points
    put_away : those that are shown only while they are selected
    fields : of every zone the field that had the keyboard last, the latest of them last
    knot : the knot whose field had the keyboard last
    knot_came_last : whether that was after the last point was selected
    measured_point : the control point that was selected last, whether or not it still is
    reference : from which distances are taken
    comparison : what the surface is compared with
    tools : how control points are picked and moved
    display : how the surface is shown
    colours_before : what coloured the surface before the distance map; empty without one
    panel : the panel of the laboratory that is shown; empty for none
    shows_zones : whether the zones are shown beside the view
    file : where the document is kept
    message : what the message line says
    gesture : the drag in hand; None for none
    """

    history: History
    draft: Document
    file: DocumentFile
    evaluation: Evaluation | None = None
    texts: Mapping[Place, str] = field(default_factory=dict)
    is_live: bool = True
    links: Links = field(default_factory=Links)
    window: Window = (0, 0)
    selection: Selection = Selection()
    put_away: frozenset[NetIndex] = frozenset()
    fields: Mapping[Zone, Place] = field(default_factory=dict)
    knot: KnotPlace | None = None
    knot_came_last: bool = True
    measured_point: NetIndex = DEFAULT_POINT
    reference: Reference | None = None
    comparison: ComparisonChoice = ComparisonChoice()
    tools: ToolSettings = field(default_factory=ToolSettings)
    display: DisplaySettings = field(default_factory=DisplaySettings)
    colours_before: str = ""
    panel: str = ""
    shows_zones: bool = True
    message: Message | None = None
    gesture: Gesture | None = None

    @property
    def document(self) -> Document:
        """The active state of the document."""
        return self.history.document

    def document_before(self, gesture: int) -> Document:
        """Return the document from which a gesture's moves are counted: where it began, or as it stands."""
        return self.gesture.history.document if self.gesture and self.gesture.number == gesture else self.document

    def draft_before(self, gesture: int) -> Document:
        """Return the same of the draft."""
        return self.gesture.draft if self.gesture and self.gesture.number == gesture else self.draft

    @property
    def is_changed(self) -> bool:
        """Whether there is something that was never saved, be it typed and not set."""
        return not self.history.is_saved or self.has_pending

    @property
    def pending(self) -> Document:
        """The document as it would be if all that is typed were set."""
        return with_typed(self.draft, self.texts)

    @property
    def has_pending(self) -> bool:
        """Whether numbers are typed that are not set."""
        return (self.draft is not self.document or bool(self.texts)) and self.pending != self.document

    @property
    def is_stale(self) -> bool:
        """Whether the surface is not that of the document."""
        return self.evaluation is None or self.evaluation.document != self.document

    @property
    def shown_document(self) -> Document | None:
        """What view and panels show: the surface configured last, over the net as it is now; the same while it is."""
        if self.evaluation is None:
            return None
        shown = self.evaluation.document
        is_alike = (shown.windows, shown.closed) == (self.document.windows, self.document.closed)
        return _over_net(shown, self.document) if self.is_stale and is_alike else shown

    @property
    def focus(self) -> Focus:
        """What the user has turned to last; letting go leaves nothing."""
        return self.knot if self.knot_came_last else self.selection.last

    @property
    def shown_comparison(self) -> ComparisonChoice | None:
        """What the view shows beside or over the surface, while the panel for it is shown."""
        is_shown = self.panel == COMPARISON_PANEL and self.comparison.placement is not None
        return self.comparison if is_shown else None

    def differs(self, before: EditorState | None, *names: str) -> bool:
        """Return whether one of these facts is another object than before, or nothing was shown before."""
        return before is None or any(getattr(before, name) is not getattr(self, name) for name in names)

    def is_pending(self, place: Place) -> bool:
        """Whether what a field holds is not set."""
        return place in self.texts or value_at(self.draft, place) != value_at(self.document, place)

    def count_pending(self, places: Iterable[Place]) -> int:
        """Return how many of some fields hold what is not set."""
        return sum(map(self.is_pending, places)) if self.texts or self.draft is not self.document else 0


@lru_cache(maxsize=2)
def _over_net(document: Document, of_net: Document) -> Document:
    return copy_zone(of_net, document, Zone.CONTROL_POINTS)


def first_state(
    document: Document, file: DocumentFile, display: DisplaySettings, tools: ToolSettings | None = None
) -> EditorState:
    """Return the state with which a window begins, before its surface is configured."""
    return EditorState(History.of(document), document, file, display=display, tools=tools or ToolSettings())


def with_message(state: EditorState, text: str, *, is_refusal: bool = False, is_of_step: bool = False) -> EditorState:
    """Return the state that says one sentence."""
    serial = state.message.serial + 1 if state.message else 1
    return replace(state, message=Message(text, is_refusal, serial, is_of_step))
