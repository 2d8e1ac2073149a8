"""The document's part of the next state: edits, drafts, undo, and the surface that follows."""

from __future__ import annotations

from collections.abc import Callable, Container, Mapping
from dataclasses import replace

from qovr_app.state import intents
from qovr_app.state.display import LayerChoice
from qovr_app.state.editor_state import DocumentFile, EditorState, Gesture, Selection, with_message
from qovr_app.state.focus import check_places, fitted, places_in, renumbered, with_focus
from qovr_app.state.history import History
from qovr_app.state.names import ZONE_TITLES, edit_text
from qovr_app.state.renumbering import Renumbering
from qovr_core import Document, Evaluation, EvaluationError, edits
from qovr_core.edits import Place, value_at
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.knots import KnotPlace
from qovr_core.net_moves import COLUMNS_MIRROR, ROWS_MIRROR
from qovr_core.symmetry import mirrored_values

Edit = Callable[[Document], Document]


def values_edited(state: EditorState, intent: intents.ValuesEdited) -> EditorState:
    check_places(state.document, intent.values)
    wanted = dict(intent.values)
    for place, value in intent.values.items():
        if isinstance(place, KnotPlace):
            wanted |= dict.fromkeys(state.links.places(state.document, place), value)
    before = state.document if state.is_live else state.draft
    for direction in state.tools.symmetries:
        wanted = mirrored_values(before, wanted, direction, state.tools.mirror(direction))
    text = edit_text(list(wanted))
    return edited(state, text, lambda document: edits.set_values(document, wanted), intent, intent.gesture)


def values_pasted(state: EditorState, intent: intents.ValuesPasted) -> EditorState:
    check_places(state.document, intent.values)
    zones = dict.fromkeys(edits.zone_of(place) for place in intent.values)
    text = "Paste " + " and ".join(ZONE_TITLES[zone].lower() for zone in zones)
    state = replace(state, texts=_without(state.texts, intent.values))
    return edited(state, text, lambda document: edits.set_values(document, intent.values), intent)


def text_typed(state: EditorState, intent: intents.TextTyped) -> EditorState:
    if state.texts.get(intent.place) == intent.text:
        return state
    check_places(state.document, [intent.place])
    texts = dict(_without(state.texts, (intent.place,)))
    if intent.text is not None:
        texts[intent.place] = intent.text
    return replace(state, texts=texts)


def zone_set(state: EditorState, intent: intents.ZoneSet) -> EditorState:
    check_places(state.document, intent.typed)
    draft = edits.set_values(state.draft, intent.typed)
    wanted = {place: value_at(draft, place) for place in places_in(intent.zone, state.window)}
    document = edits.set_values(state.document, wanted)
    state = replace(state, draft=draft, texts=_without(state.texts, intent.typed))
    return with_document(state, f"Set {ZONE_TITLES[intent.zone].lower()}", document, intent)


def pending_set(state: EditorState, intent: intents.PendingSet) -> EditorState:
    draft = state.pending
    state = replace(state, draft=draft, texts=_still_typed(state.texts, state.draft, draft))
    return with_document(state, "Set pending values", draft, intent)


def zone_read(state: EditorState, intent: intents.ZoneRead) -> EditorState:
    active = {place: value_at(state.document, place) for place in places_in(intent.zone, state.window)}
    return replace(state, draft=edits.set_values(state.draft, active), texts=_without(state.texts, active))


def formulation_chosen(state: EditorState, intent: intents.FormulationChosen) -> EditorState:
    document = edits.set_formulation(state.document, FORMULATIONS[intent.name])
    return with_document(state, f"Choose {intent.name}", document, intent)


def samples_chosen(state: EditorState, intent: intents.SamplesChosen) -> EditorState:
    n, m = intent.samples
    document = edits.set_samples(state.document, intent.samples)
    return with_document(state, f"Set samples {n} × {m}", document, intent, intent.gesture)


def gesture_begun(state: EditorState, intent: intents.GestureBegun) -> EditorState:
    return replace(state, gesture=Gesture(intent.gesture, state.history, state.draft))


def gesture_ended(state: EditorState, _intent: intents.GestureEnded) -> EditorState:
    is_refused = state.message is not None and state.message.is_refusal
    return replace(state, gesture=None, message=state.message if is_refused else None)


def gesture_cancelled(state: EditorState, intent: intents.GestureCancelled) -> EditorState:
    gesture = state.gesture
    if gesture is None or gesture.number != intent.gesture:
        return state
    history = state.history.without(gesture.number, gesture.history)
    if history is state.history:
        return replace(state, gesture=None)
    back = arrived(state, history)
    return replace(back, draft=back.document if back.is_live else gesture.draft, gesture=None)


def live_switched(state: EditorState, intent: intents.LiveSwitched) -> EditorState:
    state = replace(state, is_live=intent.is_live)
    if not intent.is_live:
        return state
    state = with_document(state, "Set pending values", state.draft, intent)
    return configured(state, intents.Configured()) if state.is_stale else state


def configured(state: EditorState, _intent: intents.Configured) -> EditorState:
    return _with_evaluation(state, Evaluation(state.document, state.evaluation))


def opened(state: EditorState, intent: intents.Opened) -> EditorState:
    history = History.of(intent.document, is_saved=intent.is_saved)
    file = DocumentFile(intent.title, intent.path, intent.stamp, intent.stamp, intent.preset, state.file.opening + 1)
    state = replace(state, file=file, texts={}, selection=Selection(), knot_came_last=True, gesture=None)
    state = with_focus(replace(state, put_away=frozenset()), (0, 0))
    state = with_message(state, intent.message) if intent.message else state
    # Where the planes of symmetry stand is meant for one document.
    state = replace(state, tools=replace(state.tools, mirror_rows=ROWS_MIRROR, mirror_columns=COLUMNS_MIRROR))
    draft = intent.document if intent.draft is None else intent.draft
    # What was typed and not set can only wait where edits wait.
    state = replace(state, is_live=state.is_live and draft == intent.document)
    return _surface_shown(replace(arrived(state, history), draft=draft))


def reloaded(state: EditorState, intent: intents.Reloaded) -> EditorState:
    file = replace(state.file, stamp=intent.stamp, found=intent.stamp)
    state = with_message(replace(state, file=file, gesture=None), f"Reloaded {file.title}")
    history = state.history.pushed(f"Reload {file.title}", intent.document, None)
    return _surface_shown(arrived(state, history.marked_saved(history.serial)))


def file_found(state: EditorState, intent: intents.FileFound) -> EditorState:
    if intent.path != state.file.path or intent.stamp == state.file.found:
        return state
    return replace(state, file=replace(state.file, found=intent.stamp))


def outside_kept(state: EditorState, _intent: intents.OutsideKept) -> EditorState:
    file = replace(state.file, stamp=state.file.found)
    return replace(state, file=file, history=state.history.marked_saved(None))


def saved(state: EditorState, intent: intents.Saved) -> EditorState:
    file = replace(state.file, path=intent.path, title=intent.title, stamp=intent.stamp, found=intent.stamp)
    state = replace(state, history=state.history.marked_saved(intent.serial), file=file)
    return with_message(state, f"Saved {intent.title}")


# The one way


def edited(state: EditorState, text: str, edit: Edit, intent: intents.Intent, gesture: int = 0) -> EditorState:
    """Return the state after an edit of the document, or of the draft where edits wait."""
    if state.is_live:
        return with_document(state, text, edit(state.document), intent, gesture)
    draft = edit(state.draft)
    return replace(state, draft=draft, texts=_still_typed(state.texts, state.draft, draft))


def with_document(
    state: EditorState,
    text: str,
    document: Document,
    intent: intents.Intent,
    gesture: int = 0,
    *,
    renumbering: Renumbering | None = None,
) -> EditorState:
    """Return the state whose document is another one, as one named step; refused where it has no surface.

    Where rows and columns have other numbers afterwards, what is selected and in focus follows.
    """
    if document == state.document:
        return state
    evaluation = Evaluation(document, state.evaluation)
    if state.is_live:
        state = _with_evaluation(state, evaluation)
    history = state.history.pushed(text, document, intent, gesture, renumbering=renumbering)
    return arrived(state if renumbering is None else renumbered(state, renumbering), history)


def arrived(state: EditorState, history: History) -> EditorState:
    """Return the state after the history has moved: draft and texts follow, and the surface where edits are live."""
    before, after = state.document, history.document
    draft = after if state.is_live else edits.rebase(state.draft, before, after)
    texts = _still_typed(state.texts, state.draft, draft)
    state = replace(state, history=history, draft=draft, texts=texts)
    if before.windows != after.windows:
        state = fitted(state)
    if before != after and state.message and (state.message.is_refusal or state.message.is_of_step):
        state = replace(state, message=None)
    return _surface_shown(state) if state.is_live else state


def _surface_shown(state: EditorState) -> EditorState:
    """Return the state that shows its document's surface, or says why there is none."""
    if not state.is_stale:
        return state
    try:
        return _with_evaluation(state, Evaluation(state.document, state.evaluation))
    except EvaluationError as error:
        return with_message(state, f"{error}.", is_refusal=True)


def _with_evaluation(state: EditorState, evaluation: Evaluation) -> EditorState:
    """Return the state with another surface; where its formulation is new here, its resting layer is shown."""
    before = state.evaluation.document.formulation if state.evaluation else None
    state = replace(state, evaluation=evaluation)
    return state if evaluation.document.formulation == before else _with_layer_in_place(state, evaluation)


def _with_layer_in_place(state: EditorState, evaluation: Evaluation) -> EditorState:
    """Return the state that shows the layer which lies on the control net, unless both are shown."""
    layer = LayerChoice(str(evaluation.document.formulation.resting_layer))
    if state.display.layer in (LayerChoice.BOTH, layer):
        return state
    return replace(state, display=replace(state.display, layer=layer))


def _still_typed(texts: Mapping[Place, str], before: Document, after: Document) -> Mapping[Place, str]:
    """Return the texts over numbers that have stayed: another number drops what was typed over the one before, and a
    net of another shape all.
    """
    if not texts or before is after:
        return texts
    if before.windows != after.windows:
        return {}
    return {place: text for place, text in texts.items() if value_at(before, place) == value_at(after, place)}


def _without(texts: Mapping[Place, str], places: Container[Place]) -> Mapping[Place, str]:
    return {place: text for place, text in texts.items() if place not in places} if texts else texts
