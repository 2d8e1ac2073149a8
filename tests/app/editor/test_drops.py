"""Files from elsewhere: dropped with any key held, several at once, addresses, names that look like markup."""

import pytest
from PySide6.QtCore import QMimeData, QPoint, Qt, QUrl
from PySide6.QtGui import QAction, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QApplication, QLabel, QTextBrowser, QWidget

from qovr_app.laboratory.panels import PANELS
from qovr_app.state.intents import SamplesChosen
from qovr_app.state.looking_intents import PanelShown
from qovr_app.state.requests import SourceAsked
from qovr_core.files import read_source, write_document
from support.documents import random_document
from support.editor import opened_windows

NAMES = ["a b.qovr", "a%20b.qovr", "a#b?c&d.qovr", "ä µ.qovr", "<b>&x[*]<img src=x>.qovr"]
MARKUP = NAMES[-1]


def drop(editor, paths, modifiers=Qt.KeyboardModifier.NoModifier, actions=None):
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path)) for path in paths])
    actions = actions or Qt.DropAction.CopyAction | Qt.DropAction.MoveAction
    enter = QDragEnterEvent(QPoint(9, 9), actions, data, Qt.MouseButton.LeftButton, modifiers)
    QApplication.sendEvent(editor.window, enter)
    event = QDropEvent(QPoint(9, 9), actions, data, Qt.MouseButton.LeftButton, modifiers)
    event.setDropAction(Qt.DropAction.MoveAction)
    QApplication.sendEvent(editor.window, event)
    return enter, event


def test_a_drop_is_a_copy_and_asks_when_it_has_ended(editor, home, monkeypatch):
    write_document(random_document(1), home / "one.qovr")
    editor.dispatch(SamplesChosen((7, 9)))
    asked = []
    monkeypatch.setattr(editor.window._documents, "may_leave", lambda: asked.append(True) or False)
    enter, event = drop(editor, [home / "one.qovr"], Qt.KeyboardModifier.ShiftModifier)
    assert event.isAccepted()
    assert enter.dropAction() == event.dropAction() == Qt.DropAction.CopyAction
    assert asked == []
    editor.settle()
    assert asked == [True]


def test_each_of_several_files_is_opened(editor, home):
    for k, name in enumerate(NAMES):
        write_document(random_document(k), home / name)
    (home / "notes.txt").write_text("x")
    drop(editor, [home / name for name in [*NAMES, "notes.txt"]])
    editor.settle()
    shown = opened_windows()
    assert shown[0] is editor.window
    assert [window.store.state.document for window in shown] == [random_document(k) for k in range(len(NAMES))]
    for window in shown[1:]:
        window.close()


def test_what_cannot_be_opened_is_not_accepted(editor, home):
    enter, _event = drop(editor, [home / "notes.txt"])
    editor.settle()
    assert not enter.isAccepted()
    assert opened_windows() == [editor.window]


@pytest.mark.parametrize("name", NAMES)
def test_names_and_addresses_are_what_they_are(editor, home, name):
    document = random_document(3)
    write_document(document, home / name)
    address = bytes(QUrl.fromLocalFile(str(home / name)).toEncoded()).decode()
    written_out = f"file://{home}/{name}".replace("%", "%25").replace(" ", "%20")
    for source in (str(home / name), address, written_out, address.replace("file://", "file://localhost")):
        assert read_source(source) == document
    editor.dispatch(SourceAsked(address))
    assert editor.window.store.state.file.path == (home / name).resolve()
    editor.dispatch(SourceAsked("paper:fig5"))
    drop(editor, [home / name])
    editor.settle()
    assert editor.document == document


def test_an_address_of_another_machine_is_refused_in_words(editor):
    editor.dispatch(SourceAsked("file://far.example/a.qovr"))
    assert "far.example" in editor.message()


def is_markup(widget, text):
    """Return whether a text in a widget is read as markup there."""
    kind = Qt.TextFormat.PlainText if not isinstance(widget, QLabel) else widget.textFormat()
    if kind == Qt.TextFormat.AutoText:
        kind = Qt.TextFormat.RichText if "<" in text else Qt.TextFormat.PlainText
    return kind == Qt.TextFormat.RichText and "<img" in text


def test_foreign_text_is_never_markup(editor, home):
    write_document(random_document(4), home / MARKUP)
    editor.dispatch(SourceAsked(str(home / MARKUP)))
    editor.trigger("pin_reference")
    menu = editor.find("menu.recent")
    menu.aboutToShow.emit()
    (recent,) = [action for action in menu.actions() if MARKUP.replace("&", "&&") in action.text()]
    assert recent.text() == f"&1  {MARKUP.replace('&', '&&')}"
    assert "<img" not in recent.toolTip()
    title = editor.window.windowTitle()
    assert title.startswith("<b>&x[*][*]<img src=x>.qovr[*] - ")
    editor.dispatch(SourceAsked(str(home / f"missing{MARKUP}")))
    assert MARKUP in editor.message()
    for name in ("", *PANELS):
        editor.dispatch(PanelShown(name))
        for widget in editor.window.findChildren(QWidget):
            assert "<img" not in widget.toolTip(), widget.objectName()
            if isinstance(widget, QLabel):
                assert not is_markup(widget, widget.text()), widget.objectName()
            if isinstance(widget, QTextBrowser):
                assert "<img" not in widget.toHtml()
    for action in editor.window.findChildren(QAction):
        assert "<img" not in action.toolTip()
    for widget in QApplication.topLevelWidgets():
        assert "<img" not in widget.toolTip()
