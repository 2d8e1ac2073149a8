"""The paper's job as its reader does it: type the case, Set, Configure, Export; then the workbook is compared."""

import numpy as np
import pytest

from qovr_core import configure
from qovr_core.edits import value_at
from qovr_core.files.workbook_read import read_published_numbers
from qovr_core.presets import preset
from qovr_core.reproduce import reproduce
from support.command import PUBLISHED
from support.documents import random_document
from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, name_of

CASES = ["fig5", "fig6b", "fig6c", "fig6d", "fig8"]
"""Every document of the paper once; the other figures show the same ones."""

_SMALL = (900, 600)
"""Little of the view, which is painted again after each of the two hundred edits."""

WORKBOOKS = {
    "fig5": "QOVR_S_Ctrl_Pts_v0_all_intl_param_knots_05.xlsx",
    "fig6b": "QOVR_S_Ctrl_Pts_v0_all_intl_param_knots_03_05_05_07.xlsx",
    "fig8": "QOVR_S_Ctrl_Pts_v1_all_intl_param_knots_05.xlsx",
}


def type_by_hand(editor, document):
    """Type every number that differs from what the field shows, Tab after each, and set the three zones."""
    for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS):
        wanted = value_at(document, place)
        if editor.field(name_of(place)).value != wanted:
            editor.type_into(name_of(place), repr(wanted).replace(".", ","))
    for zone in ("row_knots", "column_knots", "control_points"):
        editor.click(f"{zone}.set")
        assert not editor.message().startswith("Nothing was set")


@pytest.fixture
def staged(make_editor, home):
    """An editor in the paper's staged way, opened with something else than any of its cases."""
    from qovr_core.files import write_document

    write_document(random_document(2, "published", (101, 101)), home / "other.qovr")
    editor = make_editor(str(home / "other.qovr"), size=_SMALL)
    editor.trigger("live")
    return editor


@pytest.mark.parametrize("name", CASES)
def test_a_case_typed_by_hand_exports_the_papers_numbers(staged, home, name):
    document = preset(name).document
    type_by_hand(staged, document)
    assert staged.document == document
    assert not staged.reach("surface.export").isEnabled()
    staged.click("surface.configure")
    staged.export_to(home / "by_hand.xlsx")
    numbers, surface = read_published_numbers(home / "by_hand.xlsx"), configure(document)
    assert numbers.document == document
    assert np.allclose(numbers.raw, surface.raw, rtol=1e-14, atol=1e-14)
    assert np.allclose(numbers.transformed, surface.transformed, atol=5.1e-6)
    assert np.allclose(numbers.matrix, surface.matrix, rtol=1e-14, atol=1e-14)
    assert [str(formulation) for formulation in reproduce(home / "by_hand.xlsx").met_by][:1] == ["published"]


@pytest.mark.parametrize("name", list(WORKBOOKS))
def test_the_exported_workbook_is_the_published_one(make_editor, home, name):
    published = PUBLISHED / WORKBOOKS[name]
    if not published.is_file():
        pytest.skip(f"the published workbooks are not at {PUBLISHED}")
    editor = make_editor(f"paper:{name}")
    editor.export_to(home / "again.xlsx")
    mine, theirs = read_published_numbers(home / "again.xlsx"), read_published_numbers(published)
    assert mine.document == theirs.document
    assert np.allclose(mine.raw, theirs.raw, atol=1e-8)
    assert np.allclose(mine.transformed, theirs.transformed, atol=5.1e-6)


def test_setting_a_text_without_any_key_is_set_as_well(staged):
    """Other programs fill fields in one go and press Set."""
    for place in ROW_FIELDS:
        staged.field(name_of(place)).setText("0.25")
    staged.click("row_knots.set")
    assert {value for knots in staged.document.row_knots.in_window(0) for value in knots} == {0.25}
    staged.settle()
    assert staged.disagreements() == []
