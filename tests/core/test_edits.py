"""Edits of several numbers at once: all or nothing, linked, and on new ground."""

import numpy as np
import pytest
from hypothesis import given

from qovr_core import DocumentError
from qovr_core.edits import (
    CoordinatePlace,
    Direction,
    KnotPlace,
    Zone,
    copy_zone,
    linked_places,
    rebase,
    set_values,
    value_at,
)
from qovr_core.presets import preset
from support.documents import documents, random_document

FIG5 = preset("fig5").document
S_OF_C2 = KnotPlace(Direction.ROWS, 2, "s")
V_OF_K1 = KnotPlace(Direction.COLUMNS, 1, "u")
Z_OF_P34 = CoordinatePlace(3, 4, 2)


def test_set_values_changes_those_places_and_no_others():
    values = {S_OF_C2: 0.25, V_OF_K1: 0.75, Z_OF_P34: -1.5}
    document = set_values(FIG5, values)
    assert {place: value_at(document, place) for place in values} == values
    assert set_values(document, {place: value_at(FIG5, place) for place in values}) == FIG5


@pytest.mark.parametrize(
    ("place", "value", "words"),
    [
        (S_OF_C2, 1.0, "row_knots[2].s is 1.0"),
        (V_OF_K1, 0.0, "column_knots[1].v is 0.0"),
        (Z_OF_P34, np.nan, "control_points[3][4][2] is nan"),
    ],
)
def test_one_bad_value_sets_nothing_and_names_its_place(place, value, words):
    with pytest.raises(DocumentError) as refusal:
        set_values(FIG5, {KnotPlace(Direction.ROWS, 0, "r"): 0.3, place: value})
    assert str(refusal.value).startswith(words)


@pytest.mark.parametrize(
    ("curves", "directions", "count"), [(False, False, 1), (True, False, 5), (False, True, 2), (True, True, 10)]
)
def test_linked_places(curves, directions, count):
    places = linked_places(preset("fig5").document, S_OF_C2, curves=curves, directions=directions)
    assert len(set(places)) == count
    assert S_OF_C2 in places
    assert {place.name for place in places} == {"s"}


@given(documents(), documents())
def test_copying_every_zone_gives_the_source(source, target):
    for zone in Zone:
        target = copy_zone(source, target, zone)
    assert (target.control_points == source.control_points).all()
    assert (target.row_knots, target.column_knots) == (source.row_knots, source.column_knots)


@given(documents(), documents())
def test_rebase_follows_where_nothing_was_changed(before, after):
    assert rebase(before, before, after) == after
    assert rebase(before, after, after).row_knots == before.row_knots


def test_rebase_keeps_what_was_changed():
    after = random_document(3)
    draft = set_values(FIG5, {S_OF_C2: 0.2, Z_OF_P34: 7.0})
    assert rebase(draft, FIG5, after) == set_values(after, {S_OF_C2: 0.2, Z_OF_P34: 7.0})
