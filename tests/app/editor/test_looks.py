"""What the eye relies on: themes that change while the window is open, sizes, marks, numbers that fit."""

import numpy as np
import pytest
from PySide6.QtGui import QColor
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QLabel

from qovr_app.state.display import ThemeName
from qovr_app.state.looking_intents import Picking
from qovr_app.state.typed import typed_block, typed_number
from qovr_app.style.palette import set_theme, theme_in_force
from qovr_core import DocumentError
from qovr_core.number_texts import number_text
from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, name_of


@pytest.fixture
def themes():
    yield
    set_theme(ThemeName.LIGHT)


def cell_colour(editor, name):
    field = editor.field(name)
    return QColor(field.grab().toImage().pixel(field.width() // 3, field.height() // 2))


def test_an_open_window_follows_light_and_dark(editor, themes):
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.3")
    for name in (ThemeName.DARK, ThemeName.LIGHT):
        set_theme(name)
        editor.settle()
        assert theme_in_force().name is name
        assert editor.window.view.shown.settings.theme is name
        assert cell_colour(editor, "row_knots.C_4.r") == QColor(*theme_in_force().pending_cell)
        assert cell_colour(editor, "row_knots.C_4.t") == QColor(*theme_in_force().cell)
        due = editor.find("row_knots.set", QAbstractButton).palette().button().color()
        assert due == QColor(*theme_in_force().pending)


def ink_of(widget, left, right):
    """Return how light the strongest writing between two parts of a widget's width is, 0 to 255."""
    image = widget.grab().toImage()
    ground = QColor(image.pixel(image.width() // 2, 1)).lightness()
    columns = range(int(left * image.width()), int(right * image.width()))
    lights = [QColor(image.pixel(x, y)).lightness() for x in columns for y in range(image.height())]
    return max(lights, key=lambda light: abs(light - ground))


def test_tables_of_numbers_follow_light_and_dark_and_dim_when_stale(editor, themes):
    for table in map(editor.find, ("surface.boxes", "surface.matrix")):
        for name in (ThemeName.DARK, ThemeName.LIGHT):
            set_theme(name)
            editor.settle()
            headers, numbers = ink_of(table, 0.0, 0.1), ink_of(table, 0.2, 1.0)
            ink = QColor(*theme_in_force().ink).lightness()
            assert abs(numbers - ink) < 30, name
            assert abs(headers - ink) < 30, name  # the corner's; those of the rows are quieter
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.3")
    editor.click("row_knots.set")
    assert abs(ink_of(editor.find("surface.matrix"), 0.2, 1.0) - QColor(*theme_in_force().idle_ink).lightness()) < 30


def test_states_look_like_what_they_are(editor):
    editor.trigger("live")
    editor.type_into("column_knots.K_1.s", "0.95")
    editor.type_into("control_points.P_0_0.z", "1")
    editor.type_into("control_points.P_0_1.z", "x")
    editor.field("row_knots.C_4.r").setFocus()
    editor.settle()
    assert cell_colour(editor, "control_points.P_0_0.z") == QColor(*theme_in_force().pending_cell)
    assert cell_colour(editor, "control_points.P_0_1.z") == QColor(*theme_in_force().bad_cell)
    assert cell_colour(editor, "control_points.P_0_2.z") == QColor(*theme_in_force().cell)
    editor.click("column_knots.set")
    editor.field("row_knots.C_4.r").setFocus()
    assert cell_colour(editor, "column_knots.K_1.s") == QColor(*theme_in_force().cell)
    folding, other = (editor.field(name).grab().toImage() for name in ("column_knots.K_1.s", "row_knots.C_3.s"))
    assert QColor(folding.pixel(3, 3)) == QColor(*theme_in_force().ink)
    assert QColor(other.pixel(3, 3)) == QColor(*theme_in_force().cell)
    assert editor.find("control_points.set").isEnabled()


@pytest.mark.parametrize("size", [(1280, 720), (1440, 900), (2560, 1440)])
def test_everything_fits_its_place(make_editor, size):
    editor = make_editor("paper:fig6c", size)
    window = editor.window
    names = [name_of(place) for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS)]
    names += [f"surface.{part}" for part in ("configure", "export", "figure", "formulation", "boxes", "matrix")]
    for name in names:
        widget = editor.reach(name)
        area = widget.parentWidget().rect()
        assert area.contains(widget.geometry()), name
        assert widget.width() >= widget.minimumSizeHint().width(), name
        assert not widget.visibleRegion().isEmpty(), name
        assert widget.visibleRegion().boundingRect() == widget.rect(), name
    for label in window.parts.findChildren(QLabel):
        if label.isVisible() and not label.wordWrap():
            assert label.width() >= label.minimumSizeHint().width(), label.text()
    assert window.view.width() >= 0.45 * size[0]


def test_the_zones_can_be_put_away(editor):
    editor.trigger("show_panels")
    assert not editor.field("row_knots.C_4.r").isVisible()
    editor.trigger("show_panels")
    assert editor.field("row_knots.C_4.r").isVisible()


def test_a_point_selected_in_the_view_is_framed_and_its_field_selects_it(editor):
    editor.field("control_points.P_3_1.y").setFocus()
    editor.settle()
    assert editor.window.view.picture().last_selected == (3, 1)
    editor.window.view.points_picked.emit(((2, 2),), Picking.REPLACE)
    QTest.qWait(10)
    assert editor.field("control_points.P_2_2.x").is_marked
    assert not editor.field("control_points.P_3_1.x").is_marked
    assert "P 2,2" in editor.message()


@pytest.mark.parametrize("value", [0.5, -0.1, 1e12, 1 / 3, 1e-7, 123456.789, -2.5e-12, 1e300, 5e-324])
def test_what_a_field_shows_may_be_typed(value):
    assert typed_number(number_text(value)) == value
    assert typed_number(number_text(value).replace("-", "−").replace(".", ",")) == value


@pytest.mark.parametrize("text", ["1_000", "１", "1 000", "0x10", "inf", "--1", "1e", "e5", "."])
def test_what_is_no_number(text):
    assert not isinstance(typed_number(text), float)


def test_blocks():
    assert typed_block("1\t2,5\r\n−3\t4e-1\r\n") == [[1, 2.5], [-3, 0.4]]
    with pytest.raises(DocumentError, match="row 2, column 1 of what is pasted is 'x'"):
        typed_block("1\nx")
    assert np.shape(typed_block("\n".join(["1\t2\t3"] * 25))) == (25, 3)
