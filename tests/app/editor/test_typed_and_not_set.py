"""With Live off, what is typed and not set is never lost without a question, whichever way the document goes."""

import pytest
from PySide6.QtCore import Qt, QTimer
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox

from qovr_app.state.requests import SourceAsked
from qovr_core.presets import preset

BUMP = "control_points.P_2_2.z"


@pytest.fixture
def editor(shared_editor):
    shared_editor.trigger("live")
    return shared_editor


def asked_when(call):
    """Do something, leave the question it asks with Cancel, and return what was asked."""
    texts = []

    def leave():
        box = QApplication.activeModalWidget()
        if isinstance(box, QMessageBox):
            texts.append(box.text())
            QTest.mouseClick(box.button(QMessageBox.StandardButton.Cancel), Qt.MouseButton.LeftButton)

    QTimer.singleShot(50, leave)
    call()
    QTest.qWait(80)
    return "\n".join(texts)


@pytest.mark.parametrize("typed", ["0.75", "1/3", "*2"])
@pytest.mark.parametrize("is_taken", [True, False], ids=["taken", "in the field"])
def test_every_way_out_asks(editor, typed, is_taken):
    editor.type_into(BUMP, typed, end=Qt.Key.Key_Tab if is_taken else None)
    ways = {
        "close": editor.window.close,
        "new": lambda: editor.trigger("new_flat"),
        "preset": lambda: editor.dispatch(SourceAsked("paper:fig6c")),
    }
    for name, go in ways.items():
        assert "Numbers are typed that are not set" in asked_when(go), name
        assert editor.window.isVisible()
        assert editor.document == preset("fig5").document
        assert editor.field(BUMP).is_pending


def test_a_text_that_is_no_number_is_no_work_to_ask_about(editor):
    editor.type_into(BUMP, "abc", end=Qt.Key.Key_Tab)
    assert asked_when(lambda: editor.trigger("new_flat")) == ""


def test_set_is_all_or_nothing_and_says_where_it_failed(editor):
    editor.type_into("control_points.P_0_0.x", "0.5")
    editor.type_into(BUMP, "abc")
    editor.click("control_points.set")
    assert editor.document == preset("fig5").document
    assert editor.message().startswith("Nothing was set: Z of P 2,2 is 'abc'")
    assert editor.window.focusWidget() is editor.field(BUMP)
    editor.type_into(BUMP, "1/3")
    editor.click("control_points.set")
    assert editor.document.control_points[0, 0, 0] == 0.5
    assert editor.document.control_points[2, 2, 2] == 1 / 3
    assert editor.window.store.state.history.index == 1
