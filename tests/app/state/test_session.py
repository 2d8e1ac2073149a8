"""What a report says of what was done: bounded, and of a drag where it went last."""

import pytest

from qovr_app.state import session as sessions
from qovr_app.state.intents import PointsMoved, Undone
from qovr_app.state.session import Session


def noted(*intents):
    session = Session()
    for intent in intents:
        session.note(intent)
    return list(session)


def move(points, gesture=0):
    indices = tuple((k, k) for k in range(points))
    return PointsMoved(indices, ((0.0, 0.0, 1.0),) * points, gesture)


def test_of_a_drag_stays_where_it_went_last():
    first, last, other = move(1, 7), move(2, 7), move(1, 8)
    assert noted(first, last, other) == [last, other]


def test_the_oldest_go_where_there_are_too_many(monkeypatch):
    monkeypatch.setattr(sessions, "LONGEST", 3)
    intents = [move(k) for k in range(5)]
    assert noted(*intents) == intents[2:]


@pytest.mark.parametrize("gesture", [0, 5])
def test_moves_of_many_points_leave_room_for_few(gesture, monkeypatch):
    monkeypatch.setattr(sessions, "MOST_ENTRIES", 1000)
    small, large = [Undone()] * 20, [move(200, gesture + k) for k in range(4)]
    assert noted(*small, *large) == large[2:]
    assert noted(*small, *[move(200, 9)] * 10) == [*small, move(200, 9)]
    assert noted(*small, move(9000)) == [move(9000)]
