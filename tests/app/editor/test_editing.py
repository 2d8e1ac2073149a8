"""Editing with fields and sliders, live and staged, through the window alone."""

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from qovr_core import Formulation, Knots
from qovr_core.presets import preset
from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, name_of

FIG5 = preset("fig5").document


@pytest.fixture
def editor(shared_editor):
    return shared_editor


def test_it_opens_with_the_papers_example_configured(editor):
    assert editor.document == FIG5
    assert editor.disagreements() == []
    matrix = editor.find("surface.matrix")
    assert [matrix.item(k, k).text() for k in range(4)] == ["0.2", "0.1", "0.3125", "1"]
    assert [matrix.item(k, 3).text() for k in range(4)] == ["-2", "-2", "0.125", "1"]


def test_every_promised_name_is_there_once_and_can_be_said(editor):
    for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS):
        assert editor.field(name_of(place)).accessibleName()
    assert editor.field("row_knots.C_2.s").accessibleName() == "s internal knot of curve C 2"
    assert editor.field("column_knots.K_1.v").accessibleName() == "v internal knot of curve K 1"
    for zone in ("row_knots", "column_knots", "control_points"):
        assert editor.find(f"{zone}.get").accessibleName()
        assert editor.find(f"{zone}.set").accessibleName()
    for name in ("row_knots.slider", "column_knots.slider", "surface.formulation", "surface.samples_u"):
        assert editor.find(name).accessibleName()
    for name in ("surface.samples_v", "surface.configure", "surface.export", "surface.figure"):
        assert editor.find(name)
    for name in ("live", "link_curves", "link_directions", "undo", "redo", "open", "save", "save_as", "fit"):
        assert editor.action(name)


@pytest.mark.parametrize("typed", ["0.35", "0,35", " 3.5e-1 ", ".35", ",35"])
def test_live_a_typed_knot_is_set_on_all_linked_curves(editor, typed):
    editor.type_into("row_knots.C_1.s", typed)
    assert [knots.s for knots in editor.document.row_knots.in_window(0)] == [0.35] * 5
    assert editor.document.column_knots == FIG5.column_knots
    assert editor.text("row_knots.C_4.s") == "0.35"
    assert editor.disagreements() == []
    assert editor.action("undo").text() == "&Undo Set sᵢₚ of C₀..C₄"


def test_links_reach_as_far_as_they_say(editor):
    editor.trigger("link_curves")
    editor.type_into("column_knots.K_3.v", "0.3")
    assert [knots.u for knots in editor.document.column_knots.in_window(0)] == [0.5, 0.5, 0.5, 0.3, 0.5]
    editor.trigger("link_directions")
    editor.type_into("row_knots.C_0.u", "0.6")
    assert [knots.u for knots in editor.document.row_knots.in_window(0)] == [0.6, 0.5, 0.5, 0.5, 0.5]
    assert [knots.u for knots in editor.document.column_knots.in_window(0)] == [0.6, 0.5, 0.5, 0.3, 0.5]
    assert editor.action("undo").text() == "&Undo Set uᵢₚ of C₀ and vᵢₚ of K₀"


@pytest.mark.parametrize("typed", ["1", "0", "-0.2", "1,2,3", "abc", "", "nan", "1e400", "0.5 0.6"])
def test_a_bad_knot_stays_is_marked_and_writes_nothing(editor, typed):
    editor.type_into("row_knots.C_2.t", typed or " ")
    field = editor.field("row_knots.C_2.t")
    assert editor.document == FIG5
    assert field.text().strip() == typed
    assert field.error
    assert "tᵢₚ of C₂" in editor.message()
    assert "strictly between 0 and 1" in editor.message()
    editor.key(Qt.Key.Key_Escape, widget=field)
    assert (field.text(), field.error) == ("0.5", "")


def test_set_writes_all_or_nothing(editor):
    editor.trigger("live")
    editor.trigger("link_curves")
    editor.type_into("row_knots.C_0.r", "0.2")
    editor.type_into("row_knots.C_1.r", "7")
    editor.click("row_knots.set")
    assert editor.document == FIG5
    assert editor.field("row_knots.C_1.r").hasFocus()
    assert editor.message().startswith("Nothing was set: rᵢₚ of C₁ is 7.0")
    editor.type_into("row_knots.C_1.r", "0.7")
    editor.click("row_knots.set")
    assert [knots.r for knots in editor.document.row_knots.in_window(0)] == [0.2, 0.7, 0.5, 0.5, 0.5]
    assert editor.action("undo").text() == "&Undo Set row-wise knots"


def test_get_restores(editor):
    editor.trigger("live")
    editor.type_into("control_points.P_2_3.z", "9")
    editor.type_into("control_points.P_0_0.x", "no")
    assert editor.field("control_points.P_2_3.z").is_pending
    editor.click("control_points.get")
    assert (editor.text("control_points.P_2_3.z"), editor.text("control_points.P_0_0.x")) == ("0.45", "0")
    assert editor.document == FIG5
    assert editor.disagreements() == []


def test_staged_nothing_is_computed_or_exported_before_configure(editor):
    editor.trigger("live")
    matrix = editor.find("surface.matrix")
    before = matrix.item(2, 2).text()
    editor.type_into("control_points.P_4_2.z", "0.9")
    assert editor.document == FIG5
    assert editor.find("surface.export").isEnabled()
    editor.click("control_points.set")
    assert editor.document.control_points[4, 2, 2] == 0.9
    assert not editor.find("surface.export").isEnabled()
    assert editor.find("view.stale").isVisible()
    assert matrix.item(2, 2).text() == before
    editor.click("surface.configure")
    assert editor.find("surface.export").isEnabled()
    assert not editor.find("view.stale").isVisible()
    assert matrix.item(2, 2).text() != before


def test_pending_text_of_one_zone_outlives_a_set_and_an_undo_of_another(editor):
    editor.trigger("live")
    editor.type_into("control_points.P_1_1.x", "3")
    editor.type_into("column_knots.K_0.r", "0.25")
    editor.click("column_knots.set")
    editor.trigger("undo")
    assert editor.document == FIG5
    assert editor.text("control_points.P_1_1.x") == "3"
    assert editor.field("control_points.P_1_1.x").is_pending
    editor.trigger("live")
    assert editor.document.control_points[1, 1, 0] == 3
    assert editor.disagreements() == []


def test_a_slider_drag_is_one_step_and_the_surface_follows(editor):
    editor.field("column_knots.K_2.s").setFocus()
    results = []
    editor.on_evaluation(results.append)
    editor.drag_slider("column_knots.slider", [5, 5, 5, 5, 5])
    assert len(results) >= 4
    assert editor.document.column_knots[0, 0].s > 0.55
    assert editor.disagreements() == []
    assert len(editor.window.store.state.history.steps) == 1
    editor.trigger("undo")
    assert editor.document == FIG5


def test_keys_on_a_slider_are_one_step_while_they_follow_each_other(editor):
    editor.field("row_knots.C_4.u").setFocus()
    editor.move_slider("row_knots.slider", 12)
    assert editor.document.row_knots[4, 0].u == pytest.approx(0.62)
    assert len(editor.window.store.state.history.steps) == 1


def test_arrow_keys_step_a_field(editor):
    field = editor.field("control_points.P_2_2.z")
    field.setFocus()
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_PageUp, Qt.Key.Key_Down):
        editor.key(key, widget=field)
    assert editor.document.control_points[2, 2, 2] == 0.61
    assert len(editor.window.store.state.history.steps) == 1
    assert editor.action("undo").text() == "&Undo Move P 2,2"


def test_undo_keys_belong_to_the_document_where_nothing_is_typed(editor):
    editor.type_into("row_knots.C_0.r", "0.3", Qt.Key.Key_Return)
    field = editor.field("row_knots.C_0.r")
    editor.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier, field)
    assert editor.document == FIG5
    assert field.text() == "0.5"
    editor.key(Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier, field)
    assert editor.document.row_knots[0, 0].r == 0.3


def test_undo_to_the_start_gives_the_very_document(make_editor, home):
    from qovr_core.files import write_document
    from support.documents import random_document

    write_document(random_document(11), home / "start.qovr")
    editor = make_editor(str(home / "start.qovr"))
    start = editor.document
    editor.type_into("row_knots.C_1.s", "0.123456789012345")
    editor.type_into("control_points.P_3_1.y", "-7,25")
    editor.choose("surface.formulation", "double-sum")
    editor.type_into("surface.samples_u", "33")
    editor.field("column_knots.K_2.s").setFocus()
    editor.move_slider("column_knots.slider", -7)
    assert len(editor.window.store.state.history.steps) == 5
    for _ in range(5):
        editor.trigger("undo")
    assert editor.document == start
    assert not editor.window.isWindowModified()
    assert editor.disagreements() == []


def test_fields_keep_the_exact_value_and_show_as_much_as_fits(editor):
    third = repr(1 / 3)
    editor.type_into("row_knots.C_4.r", third)
    assert editor.document.row_knots[4, 0].r == 1 / 3
    editor.type_into("row_knots.C_4.s", "0.5")
    assert editor.text("row_knots.C_4.r") == third
    assert editor.document.row_knots[4, 0].r == 1 / 3


def test_samples_are_whole_and_in_range(editor):
    editor.type_into("surface.samples_v", "41")
    assert editor.document.samples == (101, 41)
    for typed in ("1", "4097", "3.5", "x"):
        editor.type_into("surface.samples_u", typed)
        assert editor.document.samples == (101, 41)
        assert "samples along u" in editor.message()


def test_rows_without_effect_say_so_and_the_way_out(editor):
    note = editor.find("row_knots.note")
    assert note.isVisible()
    assert "have no effect" in note.text()
    note.linkActivated.emit(str(Formulation.INTERPOLATING))
    editor.settle()
    assert editor.document.formulation is Formulation.INTERPOLATING
    assert not note.isVisible()


def test_a_curve_that_folds_back_is_marked_not_forbidden(editor):
    editor.type_into("column_knots.K_0.s", "0.2")
    assert not editor.find("column_knots.note").isVisible()
    editor.type_into("column_knots.K_0.v", "0.2")
    assert editor.document.column_knots[0, 0] == Knots(0.5, 0.2, 0.2, 0.5)
    assert "fold back" in editor.find("column_knots.note").text()
    assert "runs backwards for v from 0.65 to 0.907" in editor.field("column_knots.K_2.s").toolTip()
    editor.trigger("undo")
    assert not editor.find("column_knots.note").isVisible()


def test_blocks_go_to_a_spreadsheet_and_back_in_full(editor):
    net = np.random.default_rng(4).normal(size=(25, 3)) / 3
    text = "\n".join("\t".join(repr(x).replace(".", ",") for x in row) for row in net.tolist()) + "\n"
    field = editor.field("control_points.P_4_0.x")
    field.setFocus()
    QApplication.clipboard().setText(text)
    editor.key(Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier, field)
    assert np.array_equal(editor.document.control_points, net.reshape(5, 5, 3))
    assert len(editor.window.store.state.history.steps) == 1
    editor.trigger("copy_zone")
    assert QApplication.clipboard().text() == text.replace(",", ".")


def test_one_coordinate_of_all_points_is_a_block_as_the_net_lies(editor):
    z = np.arange(25.0).reshape(5, 5)
    editor.field("control_points.P_2_2.z").setFocus()
    QApplication.clipboard().setText("\n".join("\t".join(map(str, row)) for row in z.tolist()))
    editor.trigger("paste_zone")
    assert np.array_equal(editor.document.control_points[::-1, :, 2], z)
    assert np.array_equal(editor.document.control_points[..., :2], FIG5.control_points[..., :2])
    editor.trigger("copy_plane")
    assert np.array_equal(np.loadtxt(QApplication.clipboard().text().splitlines()), z)


@pytest.mark.parametrize("text", ["1\t2\n3", "1\t2", "1\tx\t3", "1\t\t3"])
def test_a_block_that_does_not_fit_pastes_nothing(editor, text):
    field = editor.field("control_points.P_0_0.x")
    field.setFocus()
    QApplication.clipboard().setText(text)
    editor.key(Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier, field)
    assert editor.document == FIG5
    assert editor.message().startswith("Nothing was pasted")
    assert editor.disagreements() == []


@pytest.mark.parametrize("text", ["", "\n", "\n\n", "word"])
def test_pasting_what_is_no_block_says_so(editor, text):
    QApplication.clipboard().setText(text)
    editor.trigger("paste_zone")
    assert editor.document == FIG5
    assert editor.message().startswith("Nothing was pasted")


def test_a_table_of_knots_is_pasted_as_it_stands(editor):
    rows = [[0.1 + 0.01 * (4 * r + c) for c in range(4)] for r in range(5)]
    editor.field("row_knots.C_0.t").setFocus()
    QApplication.clipboard().setText("\n".join("\t".join(map(repr, row)) for row in rows))
    editor.trigger("paste_zone")
    assert [list(knots) for knots in editor.document.row_knots.in_window(0)] == rows[::-1]
    editor.field("row_knots.C_0.t").setFocus()
    QApplication.clipboard().setText("0.5\t0.5")
    editor.trigger("paste_zone")
    assert "what fits" in editor.message()


def test_numbers_can_be_selected_and_copied(editor):
    table = editor.find("surface.boxes")
    table.setFocus()
    QTest.keyClick(table, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
    QTest.keyClick(table, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    rows = np.loadtxt(QApplication.clipboard().text().splitlines())
    assert np.allclose(rows, [[0, 4, 10, 30], [0, 4, 20, 60], [0.4, 0.5, 0.88, 1.2]], atol=1e-12)


def test_the_view_shows_the_layer_that_lies_on_the_net(editor):
    editor.choose("surface.formulation", "interpolating")
    assert editor.action("layer_raw").isChecked()
    assert editor.window.view.shown.settings.layer == "raw"
    editor.choose("surface.formulation", "published")
    assert editor.window.view.shown.settings.layer == "transformed"
    editor.trigger("layer_both")
    editor.choose("surface.formulation", "interpolating")
    assert editor.window.view.shown.settings.layer == "both"
