"""Every intent has a text form that reads back: a session can be written down and replayed."""

import dataclasses
import inspect
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_app.state import intents, knot_intents, looking_intents, net_intents, point_intents, requests
from qovr_app.state.display import DisplaySettings, LayerChoice, Placement
from qovr_app.state.editor_state import DocumentFile, first_state
from qovr_app.state.intent_text import intent_of, intent_text
from qovr_app.state.next_state import next_state
from qovr_app.state.tools import Way
from qovr_core import DocumentError
from qovr_core.edits import CoordinatePlace, Direction, KnotPlace, Zone
from qovr_core.geometry.nodes import Spacing
from qovr_core.net_edits import About, Align, Flatten, Plane, Smooth, Transform
from qovr_core.presets import preset
from qovr_core.symmetry import Source

PLACES = st.one_of(
    st.builds(KnotPlace, st.sampled_from(Direction), st.integers(0, 4), st.sampled_from("rsut")),
    st.builds(CoordinatePlace, st.integers(0, 4), st.integers(0, 4), st.integers(0, 2)),
)
NUMBERS = st.floats(allow_nan=False, allow_infinity=False)
VALUES = st.dictionaries(PLACES, NUMBERS, max_size=4)
TRIPLES = st.tuples(NUMBERS, NUMBERS, NUMBERS)
GESTURES = st.integers(0, 9)
INDICES = st.tuples(st.integers(0, 4), st.integers(0, 4))
EXAMPLES = {
    intents.ValuesEdited: st.builds(intents.ValuesEdited, VALUES, GESTURES),
    intents.ValuesPasted: st.builds(intents.ValuesPasted, VALUES),
    intents.TextTyped: st.builds(intents.TextTyped, PLACES, st.none() | st.text()),
    intents.ZoneSet: st.builds(intents.ZoneSet, st.sampled_from(Zone), VALUES),
    intents.ZoneRead: st.builds(intents.ZoneRead, st.sampled_from(Zone)),
    intents.PointsMoved: st.builds(
        intents.PointsMoved,
        st.lists(INDICES).map(tuple),
        st.lists(TRIPLES).map(tuple),
        GESTURES,
    ),
    knot_intents.KnotsSet: st.builds(
        knot_intents.KnotsSet,
        st.sampled_from(Direction),
        st.none() | st.integers(0, 4),
        st.just(0),
        st.sampled_from("rsut"),
        NUMBERS,
        GESTURES,
    ),
    point_intents.PointsNudged: st.builds(point_intents.PointsNudged, st.lists(INDICES).map(tuple), TRIPLES, NUMBERS),
    point_intents.PointsEdited: st.builds(
        point_intents.PointsEdited,
        st.one_of(
            st.builds(Transform, TRIPLES, TRIPLES, st.integers(0, 2), NUMBERS, st.sampled_from(About)),
            st.builds(Flatten, st.sampled_from(Plane)),
            st.builds(Align, st.integers(0, 2)),
            st.just(Smooth()),
        ),
        st.lists(INDICES).map(tuple),
        GESTURES,
    ),
    point_intents.MadeSymmetric: st.builds(
        point_intents.MadeSymmetric, st.sampled_from(Direction), st.sampled_from(Source)
    ),
    **{
        kind: st.builds(kind, st.sampled_from(Direction), st.integers(0, 9))
        for kind in (
            net_intents.WindowInserted,
            net_intents.WindowRemoved,
            net_intents.JointSmoothed,
            net_intents.JointSharpened,
        )
    },
    net_intents.WindowAppended: st.builds(net_intents.WindowAppended, st.sampled_from(Direction), st.booleans()),
    net_intents.WindowExtracted: st.builds(net_intents.WindowExtracted, INDICES),
    net_intents.JointCreased: st.builds(
        net_intents.JointCreased, st.sampled_from(Direction), st.integers(0, 9), NUMBERS, GESTURES
    ),
    net_intents.KnotsSpaced: st.builds(net_intents.KnotsSpaced, st.sampled_from(Direction), st.sampled_from(Spacing)),
    net_intents.NetReversed: st.builds(net_intents.NetReversed, st.sampled_from(Direction)),
    net_intents.NetResampled: st.builds(net_intents.NetResampled, INDICES, st.booleans(), GESTURES),
    looking_intents.Selected: st.builds(
        looking_intents.Selected,
        st.none() | INDICES,
        st.lists(INDICES).map(tuple),
        st.sampled_from(looking_intents.Picking),
    ),
    looking_intents.WindowFocused: st.builds(looking_intents.WindowFocused, INDICES),
    looking_intents.ToolChosen: st.just(looking_intents.ToolChosen("way", Way.NORMAL)),
    looking_intents.FieldFocused: st.builds(looking_intents.FieldFocused, PLACES),
    looking_intents.DisplayChosen: st.just(looking_intents.DisplayChosen("layer", LayerChoice.BOTH)),
    looking_intents.ComparisonChosen: st.builds(
        looking_intents.ComparisonChosen, st.text(), st.sampled_from([*map(str, Placement), ""]), NUMBERS
    ),
    looking_intents.RangeFixed: st.builds(looking_intents.RangeFixed, NUMBERS, NUMBERS),
    intents.Saved: st.builds(intents.Saved, st.text("abc/.", min_size=1).map(Path), st.text(), GESTURES),
    intents.FileFound: st.builds(intents.FileFound, st.just(Path("a")), st.none() | st.just((1, 2, 3))),
    intents.Reloaded: st.just(intents.Reloaded(preset("fig6d").document, (1, 2, 3))),
    intents.Opened: st.just(intents.Opened(preset("fig6d").document, "a", None, (1, 2), message="b")),
    requests.DocumentAsked: st.just(requests.DocumentAsked(preset("fig8").document, "fig8")),
}
"""How to make intents whose fields are more than numbers, texts and yes or no."""


def kinds():
    for module in (intents, knot_intents, looking_intents, net_intents, point_intents, requests):
        for _, kind in inspect.getmembers(module, inspect.isclass):
            if dataclasses.is_dataclass(kind) and kind.__module__ == module.__name__:
                yield kind


@pytest.mark.parametrize("kind", list(kinds()), ids=lambda kind: kind.__name__)
def test_every_intent_reads_back(kind):
    if kind is requests.DrawingAsked:
        pytest.skip("it carries what draws, which lives in this process alone")
    examples = EXAMPLES.get(kind, st.builds(kind))

    @given(examples)
    def reads_back(intent):
        text = intent_text(intent)
        assert "\n" not in text
        assert intent_of(text) == intent

    reads_back()


@pytest.mark.parametrize(
    "text", ["", "{}", "[1]", '{"is": "Path", "value": "x"}', '{"is": "Nothing"}', '{"is": "Undone", "x": 1}']
)
def test_another_text_is_refused(text):
    with pytest.raises(DocumentError, match="the text form of an intent"):
        intent_of(text)


def test_a_session_is_replayed_from_its_text():
    start = first_state(preset("fig5").document, DocumentFile("fig5"), DisplaySettings())
    session = [
        intents.Configured(),
        knot_intents.KnotsSet(Direction.ROWS, 4, 0, "s", 0.6),
        intents.PointsMoved(((2, 2),), ((0.0, 0.0, 0.4),), 1),
        intents.GestureEnded(1),
        intents.FormulationChosen("interpolating"),
        intents.Undone(),
    ]
    by_hand = replayed = start
    for intent in session:
        by_hand = next_state(by_hand, intent)
    for line in "\n".join(map(intent_text, session)).splitlines():
        replayed = next_state(replayed, intent_of(line))
    assert replayed.document == by_hand.document
    assert replayed.history.undo_text == by_hand.history.undo_text
    assert replayed.display == by_hand.display
