"""Fields of window, panels and dialogs: what they show, what a wheel does to them, what they take."""

import pytest
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QFocusEvent, QFontMetrics, QGuiApplication, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QLineEdit,
    QScrollBar,
    QTabBar,
    QWidget,
)

from qovr_app.dialogs.export_choices import ExportChoices
from qovr_app.dialogs.figure_dialog import FigureDialog
from qovr_app.dialogs.transform_dialog import TransformDialog
from qovr_app.laboratory.panels import PANELS
from qovr_app.state.intents import ValuesEdited
from qovr_app.state.looking_intents import PanelShown
from qovr_core.edits import CoordinatePlace
from qovr_core.files.options import ExportOptions
from qovr_core.presets import preset

LONG = "control_points.P_2_2.z"
EXACT = -0.7567891234567


def turn(widget, notches):
    at = QPointF(widget.rect().center())
    event = QWheelEvent(
        at,
        widget.mapToGlobal(at),
        QPoint(),
        QPoint(0, 120 * notches),
        Qt.MouseButton.NoButton,
        Qt.KeyboardModifier.NoModifier,
        Qt.ScrollPhase.NoScrollPhase,
        False,
    )
    QApplication.sendEvent(widget, event)
    return event.isAccepted()


def nothing(_path, _options, _progress):
    """Write no figure."""


def value_of(widget):
    if isinstance(widget, QComboBox | QTabBar):
        return widget.currentIndex()
    return widget.value() if isinstance(widget, QAbstractSlider) else widget.text()


def turnable(parent):
    kinds = (QComboBox, QAbstractSpinBox, QAbstractSlider, QTabBar, QLineEdit)
    found = [widget for kind in kinds for widget in parent.findChildren(kind)]
    return [widget for widget in found if widget.isVisible() and not isinstance(widget, QScrollBar)]


def test_a_wheel_changes_nothing_that_has_not_the_keyboard(editor, tmp_path):
    dialogs = [
        FigureDialog(tmp_path / "x.png", "lines", nothing, editor.window.worker, editor.window),
        ExportChoices(editor.document, ExportOptions()),
        TransformDialog("4 points", 1.0, editor.window),
    ]
    for dialog in dialogs:
        dialog.show()
    seen = 0
    for name in ("", *PANELS):
        editor.dispatch(PanelShown(name))
        for widget in (widget for parent in (editor.window, *dialogs) for widget in turnable(parent)):
            editor.find("message").setFocus()
            (QApplication.focusWidget() or editor.window).clearFocus()
            before = value_of(widget)
            turn(widget, 1)
            turn(widget, -2)
            assert value_of(widget) == before, widget.objectName()
            assert not widget.hasFocus()
            seen += 1
    assert seen > 400
    for dialog in dialogs:
        dialog.close()
        dialog.deleteLater()


def test_a_wheel_and_an_arrow_step_by_what_the_size_means(editor):
    for name, size in ((LONG, 1e-6), (LONG, 4000.0), ("row_knots.C_4.r", 0.0021)):
        editor.type_into(name, repr(size), end=Qt.Key.Key_Return)
        field = editor.field(name)
        before = float(field.text())
        turn(field, 1)
        by_wheel = float(field.text()) - before
        editor.key(Qt.Key.Key_Up, widget=field)
        assert float(field.text()) - before - by_wheel == pytest.approx(by_wheel)
        assert 0 < by_wheel <= max(size, 4.0)
    assert float(editor.text("row_knots.C_4.r")) == pytest.approx(0.0023)
    assert turn(editor.field("row_knots.C_4.s"), 1) is False or editor.text("row_knots.C_4.s") == "0.5"


def painted_text(field, monkeypatch):
    """Return what a field paints while it has not the keyboard."""
    from PySide6.QtGui import QPainter

    texts = []
    original = QPainter.drawText

    def draw(painter, *arguments):
        texts.append(arguments[-1])
        return original(painter, *arguments)

    monkeypatch.setattr(QPainter, "drawText", draw)
    field.grab()
    monkeypatch.undo()
    return texts[-1]


@pytest.mark.parametrize("value", [EXACT, -0.757, -1.25e-300, -123456789.125, -1e12, 0.09876543])
def test_sign_and_first_digits_are_never_cut(make_editor, value, monkeypatch):
    editor = make_editor("paper:fig5", (833, 600))
    editor.dispatch(ValuesEdited({CoordinatePlace(2, 2, 2): value}))
    editor.field("control_points.P_0_0.x").setFocus()
    field = editor.field(LONG)
    text = painted_text(field, monkeypatch)
    assert QFontMetrics(field.font()).horizontalAdvance(text) <= field.width()
    exact = field.text()
    assert float(exact) == value
    if text != exact:
        assert "…" in text
        shown = float(text.removesuffix("e…").replace("…", ""))
        assert shown == -1.0 if text.endswith("e…") else shown == pytest.approx(value, rel=0.5)
    assert exact in field.toolTip()


def test_a_field_with_the_keyboard_shows_all_digits(make_editor):
    editor = make_editor("paper:fig5", (833, 600))
    editor.type_into(LONG, repr(EXACT))
    field = editor.field(LONG)
    cell = field.geometry()
    for name in (LONG, "control_points.P_2_0.z"):
        editor.type_into(name, repr(EXACT))
        grown = editor.field(name)
        grown.setFocus()
        editor.settle()
        assert QFontMetrics(grown.font()).horizontalAdvance(grown.text()) < grown.width()
        assert grown.parentWidget().rect().contains(grown.geometry())
    assert field.geometry() == cell


@pytest.mark.parametrize("locale", ["de_DE", "en_US", "ar_EG"])
def test_the_figure_dialog_takes_point_and_comma_and_never_a_group(editor, tmp_path, locale):
    from PySide6.QtCore import QLocale

    before = QLocale()
    QLocale.setDefault(QLocale(locale))
    try:
        dialog = FigureDialog(tmp_path / "x.png", "lines", nothing, editor.window.worker, editor.window)
        dialog.show()
        width, dpi = dialog.findChild(QWidget, "figure.width"), dialog.findChild(QWidget, "figure.dpi")
        for text, value in (("1234,5", 1234.5), ("1234.5", 1234.5), ("85*2", 170), ("2*421-29,5", 812.5)):
            width.setFocus()
            width.selectAll()
            QTest.keyClicks(width, text)
            QApplication.sendEvent(width, QFocusEvent(QEvent.Type.FocusOut))
            assert width.value() == value
            assert width.text() == f"{value:g}"
        for text in ("1,234.5", "1.234,5", "٥٠"):
            width.setFocus()
            width.selectAll()
            width.lineEdit().insert(text)
            QApplication.sendEvent(width, QFocusEvent(QEvent.Type.FocusOut))
            assert (width.value(), width.text()) == (812.5, "812.5")
        dpi.lineEdit().selectAll()
        QTest.keyClicks(dpi, "1200")
        assert (dpi.value(), dpi.text()) == (1200, "1200")
    finally:
        QLocale.setDefault(before)
        dialog.close()
        dialog.deleteLater()


def test_a_number_is_pasted_in_full_into_a_field_and_a_table_offers_its_numbers(editor):
    from PySide6.QtCore import QMimeData

    data = QMimeData()
    data.setText("1,23\n")
    data.setHtml('<table><tr><td sdval="1,23456789" sdnum="1031;">1,23</td></tr></table>')
    QGuiApplication.clipboard().setMimeData(data)
    field = editor.field(LONG)
    field.setFocus()
    field.selectAll()
    editor.key(Qt.Key.Key_V, Qt.KeyboardModifier.ControlModifier, field)
    editor.key(Qt.Key.Key_Return, widget=field)
    assert editor.document.control_points[2, 2, 2] == 1.23456789
    editor.trigger("copy_zone")
    copied = QGuiApplication.clipboard().mimeData()
    assert copied.html().count("sdval=") == 75
    assert 'sdval="1.23456789" sdnum="1033;"' in copied.html()
    assert copied.text().splitlines()[12] == "2\t2\t1.23456789"


def test_a_mixed_block_is_refused_with_its_cell(editor):
    QGuiApplication.clipboard().setText("1,234\t12.5\t0\n")
    editor.field(LONG).setFocus()
    editor.trigger("paste_zone")
    assert editor.document == preset("fig5").document
    assert "row 1, column 2 of what is pasted is '12.5'" in editor.message()
