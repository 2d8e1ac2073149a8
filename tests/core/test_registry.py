"""Tables of records: order, names, what comes from outside, and how records go to another process."""

import pickle
from dataclasses import dataclass
from typing import ClassVar

import pytest

from qovr_core.registry import Record, Registry


@dataclass(frozen=True, eq=False)
class Colour(Record):
    name: str
    red: float
    table: ClassVar[Registry["Colour"]]


COLOURS = Colour.table = Registry("colour")
RED = Colour("red", 1.0)


@pytest.fixture(autouse=True)
def filled():
    with COLOURS.register(RED), COLOURS.register(Colour("blue", 0.0)):
        COLOURS.seal()
        yield
    assert not COLOURS


def test_records_stand_in_their_order_by_their_names():
    assert list(COLOURS) == ["red", "blue"]
    assert COLOURS["red"] is RED
    with pytest.raises(KeyError):
        COLOURS["green"]


def test_what_comes_from_outside_is_told_apart_and_goes_again():
    green = Colour("green", 0.5)
    with COLOURS.register(green) as entered:
        assert entered is green
        assert list(COLOURS) == ["red", "blue", "green"]
        assert COLOURS.extras() == (green,)
    assert list(COLOURS) == ["red", "blue"]
    assert COLOURS.extras() == ()


def test_a_record_is_in_at_once():
    registration = COLOURS.register(Colour("green", 0.5))
    assert "green" in COLOURS
    with registration:
        pass
    assert "green" not in COLOURS


def test_a_second_record_of_one_name_is_refused():
    with pytest.raises(ValueError, match="there is a colour 'red' already"):
        COLOURS.register(Colour("red", 0.3))
    assert COLOURS["red"] is RED


def test_a_record_stands_for_its_name():
    assert str(RED) == "red"
    assert f"{RED:<6}|" == "red   |"
    assert Colour("red", 0.2) == RED
    assert hash(RED) == hash(Colour("red", 0.2))
    assert Colour("blue", 1.0) != RED
    assert RED != "red"


def test_own_records_are_pickled_as_their_names_and_others_as_their_fields():
    assert pickle.loads(pickle.dumps(RED)) is RED
    with COLOURS.register(Colour("green", 0.5)) as green:
        sent = pickle.dumps(green)
    assert vars(pickle.loads(sent)) == vars(green)
