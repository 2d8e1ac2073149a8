"""The undo history: one step a gesture, bounded, and a mark that says what lies in the file."""

import tracemalloc
from dataclasses import fields

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_app.state import history as histories
from qovr_app.state.history import History
from qovr_app.state.intents import PointsMoved
from qovr_core import Document
from qovr_core.edits import set_point, set_points, set_values
from qovr_core.geometry.knots import Direction, KnotPlace
from qovr_core.presets import preset

FIRST = preset("fig5").document


def moved(z: float) -> Document:
    return set_point(FIRST, 2, 2, (2.0, 2.0, z))


def pushed(history: History, *heights: float, gesture: int = 0) -> History:
    for z in heights:
        history = history.pushed(f"to {z}", moved(z), None, gesture)
    return history


def test_a_step_is_undone_and_done_again():
    history = pushed(History.of(FIRST), 1.0, 2.0)
    assert (history.undo_text, history.redo_text) == ("to 2.0", None)
    back = history.undone()
    assert back.document == moved(1.0)
    assert (back.undo_text, back.redo_text) == ("to 1.0", "to 2.0")
    assert back.undone().document == FIRST
    assert back.undone().undone().document == FIRST
    assert back.redone().redone().document == moved(2.0)


def test_the_same_document_is_no_step():
    history = pushed(History.of(FIRST), 1.0)
    assert history.pushed("nothing", moved(1.0), None) is history


def test_a_gesture_is_one_step():
    history = pushed(pushed(History.of(FIRST), 1.0), 2.0, 3.0, 4.0, gesture=7)
    assert len(history.steps) == 2
    assert history.undone().document == moved(1.0)


def test_a_gesture_that_comes_back_leaves_no_step():
    history = pushed(History.of(FIRST), 2.0, gesture=7).pushed("back", FIRST, None, 7)
    assert history.undo_text is None
    assert history.is_saved


def test_a_cancelled_gesture_has_never_been():
    before = pushed(History.of(FIRST), 1.0, 2.0).undone()
    after = pushed(before, 3.0, 4.0, gesture=7).without(7, before)
    assert after.document == before.document
    assert after.steps == before.steps
    assert after.redo_text == before.redo_text is not None


def test_what_was_saved_within_a_cancelled_gesture_is_not_what_comes_next():
    before = pushed(History.of(FIRST), 1.0)
    within = pushed(before, 2.0, gesture=7)
    back = within.marked_saved(within.serial).without(7, before)
    assert not back.is_saved
    assert not pushed(back, 3.0).is_saved


def test_what_has_been_since_a_gesture_stays():
    before = pushed(History.of(FIRST), 1.0)
    later = pushed(pushed(before, 2.0, gesture=7), 3.0)
    assert later.without(7, before) is later


def test_a_saved_step_does_not_grow():
    saved = pushed(History.of(FIRST), 2.0, gesture=7)
    saved = saved.marked_saved(saved.serial)
    assert len(pushed(saved, 3.0, gesture=7).steps) == 2


def test_the_mark_says_what_lies_in_the_file():
    history = pushed(History.of(FIRST), 1.0, 2.0)
    assert not history.is_saved
    marked = history.marked_saved(history.serial)
    assert marked.is_saved
    assert not marked.undone().is_saved
    assert marked.undone().redone().is_saved


def test_a_step_after_undo_is_not_taken_for_the_saved_one():
    history = pushed(History.of(FIRST), 1.0)
    other = pushed(history.marked_saved(history.serial).undone(), 5.0)
    assert not other.is_saved


def test_the_oldest_steps_go_first_and_the_mark_survives(monkeypatch):
    monkeypatch.setattr(histories, "MOST_STEPS", 10)
    history = pushed(History.of(FIRST), *range(1, 8))
    history = pushed(history.marked_saved(history.serial), *range(8, 14))
    assert len(history.steps) == 10
    for _ in range(6):
        history = history.undone()
    assert history.document == moved(7)
    assert history.is_saved
    for _ in range(20):
        history = history.undone()
    assert history.document == moved(3)


def test_the_documents_have_room_in_so_many_bytes(monkeypatch):
    one = pushed(History.of(FIRST), 1.0).bytes_held
    monkeypatch.setattr(histories, "MOST_BYTES", 5 * one)
    history = pushed(History.of(FIRST), *range(1, 20))
    assert len(history.steps) == 5
    assert history.bytes_held == 5 * one


def bits(document: Document) -> list[object]:
    """Return all that a document holds, numbers to the last bit."""
    values = [getattr(document, field.name) for field in fields(Document)]
    arrays = [getattr(value, "array", value) for value in values]
    return [value.tobytes() if isinstance(value, np.ndarray) else value for value in arrays]


def random_document(seed: int, size: int) -> Document:
    """Return a document that shares with others of its size whatever the seed has them share."""
    random = np.random.default_rng(seed)
    document = Document(NETS[size], samples=(11 + seed % 3, 11), formulation=["published", "interpolating"][seed % 2])
    if seed % 5:
        document = set_point(document, *random.integers(0, 5, 2), random.choice([-0.0, 0.0, 1.5, 1e-320], 3))
    if seed % 3:
        direction = list(Direction)[seed % 2]
        document = set_values(document, {KnotPlace(direction, 0, "s"): random.uniform(0.1, 0.9)})
    return document if seed % 7 else set_points(document, random.normal(size=document.control_points.shape))


NETS = {size: np.random.default_rng(size).normal(size=(size, size, 3)) for size in (5, 9)}
PUSHES = st.tuples(st.just("push"), st.integers(0, 40), st.sampled_from([5, 5, 5, 9]), st.sampled_from([0, 0, 1, 2]))
MOVES = st.tuples(st.sampled_from(["go", "save"]), st.integers(-1, 12))


@given(st.lists(PUSHES | MOVES, max_size=40))
def test_any_sequence_keeps_the_account(moves):
    """Against a plain list of documents: what is undone and done again is what was there, to the last bit."""
    history, documents, at, gestures, saved = History.of(FIRST), [FIRST], 0, [0], 0
    for kind, *values in moves:
        if kind == "push":
            document, gesture = random_document(*values[:2]), values[2]
            if document != documents[at]:
                grows = gesture and 0 < at == len(documents) - 1 != saved and gestures[at] == gesture
                at += not grows
                documents, gestures = [*documents[:at], document], [*gestures[:at], gesture]
                saved = None if saved is not None and saved >= at else saved
                if grows and document == documents[at - 1]:
                    at -= 1
                    documents, gestures = documents[:-1], gestures[:-1]
            history = history.pushed(f"step {at}", document, None, gesture)
        elif kind == "go":
            history, at = history.gone_to(*values), min(max(*values, 0), len(documents) - 1)
        else:
            history, saved = history.marked_saved(history.serial), at
        assert (history.index, len(history.steps)) == (at, len(documents) - 1)
        assert bits(history.document) == bits(documents[at])
        assert history.is_saved == (saved == at)
        assert history.bytes_held == sum(step.bytes_held for step in history.steps)


def net_document(size: int) -> Document:
    return Document(np.random.default_rng(3).normal(size=(size, size, 3)), samples=(201, 201))


def drag_points(history: History, count: int, moves_a_drag: int) -> History:
    """Return the history after so many drags of one point each."""
    size = len(history.document.control_points)
    for k in range(1, count + 1):
        i, j = k % size, k * 7 % size
        for z in range(moves_a_drag):
            intent = PointsMoved(((i, j),), ((0.0, 0.0, z),), k)
            history = history.pushed(f"Move P {i},{j}", set_point(history.document, i, j, (k, 1.0, z)), intent, k)
    return history


def test_two_thousand_moves_of_one_point_take_little_and_come_back_to_the_bit():
    """Of the largest net one document's points alone take a megabyte."""
    first = net_document(203)
    history = drag_points(History.of(first), histories.MOST_STEPS, 1)
    assert len(history.steps) == histories.MOST_STEPS
    assert history.bytes_held < 10e6
    back = history.gone_to(0)
    assert bits(back.document) == bits(first)
    assert bits(back.gone_to(histories.MOST_STEPS).document) == bits(history.document)


def push_whole_nets(history: History, count: int) -> History:
    for k in range(1, count + 1):
        net = history.document.control_points + 0.1 * k
        history = history.pushed(f"step {k}", set_points(history.document, net), None)
    return history


@pytest.mark.parametrize(
    ("push", "size", "steps"),
    [
        (lambda history: drag_points(history, 300, 2), 21, 300),
        (lambda history: push_whole_nets(history, 40), 203, 20),
    ],
    ids=["drags", "whole nets"],
)
def test_what_is_held_is_what_is_taken(push, size, steps, monkeypatch):
    monkeypatch.setattr(histories, "MOST_BYTES", 20_000_000)
    history = History.of(net_document(size))
    tracemalloc.start()
    try:
        history = push(history)
        taken = tracemalloc.get_traced_memory()[0]
    finally:
        tracemalloc.stop()
    assert len(history.steps) == steps
    documents = 3 * history.document.control_points.nbytes  # the first and the last one, and what they were made of
    assert 0.8 * history.bytes_held < taken < 1.1 * history.bytes_held + documents
    assert history.bytes_held <= histories.MOST_BYTES


@pytest.mark.parametrize("steps", [0, 1])
def test_undo_and_redo_say_what_they_would_do(steps):
    history = pushed(History.of(FIRST), *range(1, steps + 1))
    assert (history.undo_text is None) == (steps == 0)
