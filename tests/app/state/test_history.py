"""The undo history: one step a gesture, bounded, and a mark that says what lies in the file."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from qovr_app.state import history as histories
from qovr_app.state.history import History
from qovr_core import Document
from qovr_core.edits import set_point
from qovr_core.presets import preset

FIRST = preset("fig5").document


def moved(z: float) -> Document:
    return set_point(FIRST, 2, 2, (2.0, 2.0, z))


def pushed(history: History, *heights: float, gesture: int = 0) -> History:
    for z in heights:
        history = history.pushed(f"to {z}", moved(z), None, gesture)
    return history


def test_a_step_is_undone_and_done_again():
    history = pushed(History(FIRST), 1.0, 2.0)
    assert (history.undo_text, history.redo_text) == ("to 2.0", None)
    back = history.undone()
    assert back.document == moved(1.0)
    assert (back.undo_text, back.redo_text) == ("to 1.0", "to 2.0")
    assert back.undone().document == FIRST
    assert back.undone().undone().document == FIRST
    assert back.redone().redone().document == moved(2.0)


def test_the_same_document_is_no_step():
    history = pushed(History(FIRST), 1.0)
    assert history.pushed("nothing", moved(1.0), None) is history


def test_a_gesture_is_one_step():
    history = pushed(pushed(History(FIRST), 1.0), 2.0, 3.0, 4.0, gesture=7)
    assert len(history.steps) == 2
    assert history.undone().document == moved(1.0)


def test_a_gesture_that_comes_back_leaves_no_step():
    history = pushed(History(FIRST), 2.0, gesture=7).pushed("back", FIRST, None, 7)
    assert history.undo_text is None
    assert history.is_saved


def test_a_cancelled_gesture_has_never_been():
    before = pushed(History(FIRST), 1.0, 2.0).undone()
    after = pushed(before, 3.0, 4.0, gesture=7).without(7, before)
    assert after.document == before.document
    assert after.steps == before.steps
    assert after.redo_text == before.redo_text is not None


def test_what_was_saved_within_a_cancelled_gesture_is_not_what_comes_next():
    before = pushed(History(FIRST), 1.0)
    within = pushed(before, 2.0, gesture=7)
    back = within.marked_saved(within.serial).without(7, before)
    assert not back.is_saved
    assert not pushed(back, 3.0).is_saved


def test_what_has_been_since_a_gesture_stays():
    before = pushed(History(FIRST), 1.0)
    later = pushed(pushed(before, 2.0, gesture=7), 3.0)
    assert later.without(7, before) is later


def test_a_saved_step_does_not_grow():
    saved = pushed(History(FIRST), 2.0, gesture=7)
    saved = saved.marked_saved(saved.serial)
    assert len(pushed(saved, 3.0, gesture=7).steps) == 2


def test_the_mark_says_what_lies_in_the_file():
    history = pushed(History(FIRST), 1.0, 2.0)
    assert not history.is_saved
    marked = history.marked_saved(history.serial)
    assert marked.is_saved
    assert not marked.undone().is_saved
    assert marked.undone().redone().is_saved


def test_a_step_after_undo_is_not_taken_for_the_saved_one():
    history = pushed(History(FIRST), 1.0)
    other = pushed(history.marked_saved(history.serial).undone(), 5.0)
    assert not other.is_saved


def test_the_oldest_steps_go_first_and_the_mark_survives(monkeypatch):
    monkeypatch.setattr(histories, "MOST_STEPS", 10)
    history = pushed(History(FIRST), *range(1, 8))
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
    one = pushed(History(FIRST), 1.0).bytes_held
    monkeypatch.setattr(histories, "MOST_BYTES", 5 * one)
    history = pushed(History(FIRST), *range(1, 20))
    assert len(history.steps) == 5
    assert history.bytes_held == 5 * one


@given(st.lists(st.sampled_from(["push", "undo", "redo", "save"]), max_size=60))
def test_any_sequence_keeps_the_account(moves):
    """Against a plain list of documents: what is undone and done again is what was there."""
    history, documents, at, z = History(FIRST), [FIRST], 0, 0.0
    for move in moves:
        if move == "push":
            z += 1
            history = pushed(history, z)
            documents, at = [*documents[: at + 1], moved(z)], at + 1
        elif move == "undo":
            history, at = history.undone(), max(at - 1, 0)
        elif move == "redo":
            history, at = history.redone(), min(at + 1, len(documents) - 1)
        elif move == "save":
            history = history.marked_saved(history.serial)
            assert history.is_saved
        assert np.array_equal(history.document.control_points, documents[at].control_points)
        assert history.bytes_held == sum(histories.document_bytes(step.document) for step in history.steps)


@pytest.mark.parametrize("steps", [0, 1])
def test_undo_and_redo_say_what_they_would_do(steps):
    history = pushed(History(FIRST), *range(1, steps + 1))
    assert (history.undo_text is None) == (steps == 0)
