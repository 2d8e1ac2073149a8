"""1366 x 768 at 125 % and 150 %, and text half as large again: every control can be reached."""

import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractSlider,
    QApplication,
    QComboBox,
    QLineEdit,
    QScrollArea,
    QScrollBar,
)

from support.editor import COLUMN_FIELDS, POINT_FIELDS, ROW_FIELDS, TABS, name_of, scroll_to

CONTROLS = (QLineEdit, QComboBox, QAbstractButton, QAbstractSlider)


@pytest.fixture(params=[1.0, 1.5])
def scaled_text(app, request):
    before = app.font()
    font = app.font()
    font.setPointSizeF(request.param * font.pointSizeF())
    app.setFont(font)
    yield
    app.setFont(before)


@pytest.mark.parametrize("size", [(911, 512), (1093, 614)])
def test_every_control_of_the_zones_can_be_scrolled_to(make_editor, scaled_text, size):
    editor = make_editor("paper:fig5", size)
    editor.settle()
    assert (editor.window.width(), editor.window.height()) == size
    area, reached = editor.find("zones", QScrollArea), 0
    for tab in TABS.values():
        editor.choose_tab(tab)
        controls = [control for kind in CONTROLS for control in area.widget().findChildren(kind)]
        for control in controls:
            if (
                control.isVisible()
                and not isinstance(control, QScrollBar)
                and not control.objectName().startswith("qt_")
            ):
                scroll_to(area, control)
                seen = control.visibleRegion().boundingRect()
                assert seen == control.rect(), control.objectName()
                assert control.width() >= control.minimumSizeHint().width() or isinstance(control, QAbstractSlider)
                reached += 1
    assert reached > 120


def test_a_wheel_over_what_has_not_the_keyboard_scrolls_the_zones(make_editor):
    editor = make_editor("paper:fig6c", (911, 512))
    bar = editor.find("zones", QScrollArea).verticalScrollBar()
    editor.window.resize(911, 310)  # so low that the zones are higher
    editor.trigger("live")
    editor.type_into("row_knots.C_4.s", "0.9")
    editor.click("row_knots.set")  # which takes another note
    before = editor.document
    for name in ("row_knots.C_2.s", "row_knots.slider", "control_points.P_2_2.y"):
        widget = editor.reach(name)
        bar.setValue(0)
        widget.clearFocus()
        at = widget.mapTo(editor.window, widget.rect().center())
        QTest.wheelEvent(editor.window.windowHandle(), QPointF(at), QPoint(0, -120))
        editor.settle()
        assert bar.value() > 0, name
    assert editor.document == before


def test_the_keyboard_brings_a_zone_into_sight_and_a_wide_window_its_columns_back(make_editor):
    editor = make_editor("paper:fig5", (911, 512))
    assert editor.window.view.width() >= 0.6 * 911
    editor.trigger("go_control_points")
    assert QApplication.focusWidget().visibleRegion().boundingRect() == QApplication.focusWidget().rect()
    editor.window.resize(1440, 900)
    editor.settle()
    names = [name_of(place) for place in (*ROW_FIELDS, *COLUMN_FIELDS, *POINT_FIELDS)]
    for name in (*names, "surface.matrix", "surface.export"):
        widget = editor.find(name)
        assert widget.visibleRegion().boundingRect() == widget.rect(), name
    columns = editor.find("splitter.columns")
    assert columns.orientation() == Qt.Orientation.Horizontal
