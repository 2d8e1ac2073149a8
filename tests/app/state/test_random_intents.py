"""Thousands of random intents without a window: whatever is asked in whatever order, the state holds together."""

import random
from itertools import pairwise

import pytest

from qovr_app.state import intents, knot_intents, looking_intents, point_intents
from qovr_app.state.display import DisplaySettings, LayerChoice, Placement
from qovr_app.state.editor_state import DocumentFile, first_state
from qovr_app.state.focus import has_window, in_window, nearest_window
from qovr_app.state.intent_text import intent_of, intent_text
from qovr_app.state.names import in_window_words
from qovr_app.store import Store
from qovr_core import FORMULATIONS, Evaluation, EvaluationError
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, Zone, knots_of
from qovr_core.net_edits import Align, Flatten, Smooth, Transform
from qovr_core.presets import preset, presets
from qovr_core.symmetry import Source
from support.nets import closed_net, random_net_document

INTENTS = 3000
KNOTS = [KnotPlace(direction, k, name) for direction in Direction for k in range(5) for name in "rsut"]
POINTS = [CoordinatePlace(i, j, axis) for i in range(5) for j in range(5) for axis in range(3)]
STARTS = {
    "fig5": preset("fig5").document,
    "net": random_net_document(1, (2, 3), samples=(31, 17)),
    "ring": closed_net(2, (2, 2), ("u", "v")),
}
EDITS = [Transform((0.0, 0.0, 0.1)), Transform(factors=(2.0, 1.0, 0.5), degrees=30.0), Flatten(), Align(2), Smooth()]
WINDOWS = [(0, 0), (0, 0), (0, 1), (1, 0), (1, 1), (1, 2), (2, 2)]
NUMBERS = [0.5, 0.25, 1 / 3, 0.875, 1.0, 0.0, -3.0, 12.5, 1e-3, 1e300, 5e-324]


def some(rng):
    """Return a random intent; many of them are to be refused."""
    place, number = in_window(rng.choice(KNOTS + POINTS), rng.choice(WINDOWS)), rng.choice(NUMBERS)
    gesture = rng.choice([0, 0, 1, 2])
    i, j = rng.randrange(5), rng.randrange(5)
    return rng.choice(
        [
            intents.ValuesEdited({place: number}, gesture),
            intents.ValuesEdited({place: number}, gesture),
            intents.ValuesPasted({rng.choice(KNOTS): number, rng.choice(POINTS): rng.choice(NUMBERS)}),
            knot_intents.KnotsSet(
                rng.choice(list(Direction)),
                rng.choice([None, i]),
                rng.choice([0, 0, 1]),
                rng.choice("rsut"),
                number,
                gesture,
                takes_s=rng.random() < 0.5,
                in_view=rng.random() < 0.5,
            ),
            intents.TextTyped(place, rng.choice([None, "0.5", "abc"])),
            intents.ZoneSet(rng.choice(list(Zone)), {}),
            intents.ZoneRead(rng.choice(list(Zone))),
            intents.PointsMoved(((i, j), (j, i)), ((0.0, 0.1, number), (number, 0.0, 0.0)), 3),
            point_intents.PointsNudged(((i, j),), (0.0, 0.0, number), rng.random()),
            point_intents.PointsEdited(rng.choice(EDITS), ((i, j), (j, i))),
            point_intents.MadeSymmetric(rng.choice(list(Direction)), rng.choice(list(Source))),
            looking_intents.ToolChosen(rng.choice(["soft", "symmetry_rows", "symmetry_columns"]), rng.random() < 0.5),
            intents.GestureBegun(gesture),
            intents.GestureEnded(3),
            intents.GestureCancelled(3),
            intents.FormulationChosen(rng.choice(list(FORMULATIONS))),
            intents.SamplesChosen((rng.choice([1, 2, 31]), rng.choice([3, 17, 5000]))),
            intents.Undone(),
            intents.Redone(),
            intents.Configured(),
            intents.LiveSwitched(rng.random() < 0.7),
            knot_intents.LinkSwitched("curves", rng.random() < 0.5),
            knot_intents.LinkSwitched("directions", rng.random() < 0.5),
            looking_intents.Selected(rng.choice([None, (i, j)]), ((j, i),), rng.choice(list(looking_intents.Picking))),
            looking_intents.FieldFocused(place),
            looking_intents.WindowFocused(rng.choice(WINDOWS)),
            knot_intents.LinkSwitched("windows", rng.random() < 0.3),
            looking_intents.DisplayChosen("layer", rng.choice(list(LayerChoice))),
            looking_intents.ReferencePinned(),
            looking_intents.ReferenceUnpinned(),
            looking_intents.ComparisonChosen("nurbs", rng.choice([*map(str, Placement), ""]), 4.0),
            looking_intents.DistanceMapSwitched(rng.random() < 0.5),
            looking_intents.PanelShown(rng.choice(["", "curve", "comparison"])),
        ]
    )


def has_surface(document):
    try:
        Evaluation(document)
    except EvaluationError:
        return False
    return True


def check(state):
    """What holds in every state."""
    assert state.evaluation is not None
    if state.is_live:
        # back where edits waited, the document may be one that has no surface
        assert not state.is_stale or not has_surface(state.document)
        assert state.draft == state.document
    assert state.is_stale == (state.evaluation.document != state.document)
    for place in state.texts:
        assert state.is_pending(place)
    for direction in Direction:
        knots = knots_of(state.draft, direction).array
        assert ((knots > 0) & (knots < 1)).all()
    for place in (*state.fields.values(), *filter(None, [state.knot])):
        assert nearest_window(state.document, state.window, place) == state.window
    assert has_window(state.document, state.window)
    assert state.selection.last is None or state.selection.last in state.selection.points
    assert state.focus is None or state.focus in (state.knot, state.selection.last)
    assert (state.history.undo_text is None) == (state.history.index == 0)


@pytest.mark.parametrize(
    ("seed", "name"), [*((seed, "fig5") for seed in range(4)), (0, "net"), (1, "net"), (0, "ring")]
)
def test_random_intents(seed, name):
    rng = random.Random(seed)
    shown = []
    store = Store(first_state(STARTS[name], DocumentFile(name), DisplaySettings()), lambda: None)
    store.subscribe(lambda before, after: shown.append((before, after)))
    store.dispatch(intents.Configured())
    for number in range(INTENTS):
        intent = some(rng)
        before = store.state
        refused = store.dispatch(intent_of(intent_text(intent)))
        if refused is not None:
            assert store.state.document is before.document
            assert store.state.history is before.history
            found = str(refused).partition(" is ")[2]  # before it stands the place, which the window calls otherwise
            assert found
            assert in_window_words(found) in store.state.message.text
        check(store.state)
        if number % 7 == 0:
            store.flush()
    steps = store.state.history.index
    store.dispatch(intents.LiveSwitched(False))
    for _ in range(steps):
        store.dispatch(intents.Undone())
    assert store.state.history.document == store.state.history.first == STARTS[name]
    assert all(later[0] is earlier[1] for earlier, later in pairwise(shown))


def test_any_document_can_be_opened_after_any_other():
    store = Store(first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings()), lambda: None)
    store.dispatch(intents.Configured())
    for name, entry in presets().items():
        store.dispatch(intents.Opened(entry.document, name, preset=name))
        check(store.state)
        assert store.state.document == entry.document
        assert not store.state.is_changed
