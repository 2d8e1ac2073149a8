"""A theme that changes while the window is open, and keys under layouts of other scripts."""

import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QGuiApplication, QKeyEvent
from PySide6.QtWidgets import QLabel, QTextBrowser

from qovr_app.state.display import ThemeName
from qovr_app.state.looking_intents import DisplayChosen, MessageShown
from qovr_app.style.palette import set_theme, theme_in_force
from qovr_app.view3d.interaction.keys import axis_of


@pytest.fixture
def dark():
    set_theme(ThemeName.LIGHT)
    yield lambda: set_theme(ThemeName.DARK)
    set_theme(ThemeName.LIGHT)


def colours(image):
    """Return every colour of an image."""
    return {image.pixel(x, y) & 0xFFFFFF for x in range(image.width()) for y in range(image.height())}


def rgb(colour):
    return colour[0] << 16 | colour[1] << 8 | colour[2]


def test_links_and_messages_follow_the_theme(editor, dark):
    note = editor.find("row_knots.note", QLabel)
    editor.trigger("help")
    text = editor.window.findChild(QTextBrowser, "help.text")
    editor.dispatch(MessageShown("Nothing was done.", is_refusal=True))
    message = editor.find("message", QLabel)
    light = theme_in_force()
    assert rgb(light.accent) in colours(note.grab().toImage())
    dark()
    editor.settle()
    now = theme_in_force()
    assert now is not light
    for widget in (note, text.viewport(), message):
        seen = colours(widget.grab().toImage())
        assert rgb(light.accent) not in seen
        assert rgb(light.bad) not in seen
    assert rgb(now.accent) in colours(note.grab().toImage())
    assert rgb(now.bad) in colours(message.grab().toImage())
    links = text.document().firstBlock()
    while links.isValid():
        for part in links.textFormats():
            if part.format.anchorHref():
                assert part.format.foreground().color() == QGuiApplication.palette().link().color()
        links = links.next()


def test_palette_and_widgets_follow_the_state_in_every_window(make_editor, dark):
    first, second = make_editor(), make_editor()
    first.dispatch(DisplayChosen("theme", ThemeName.DARK))
    second.settle()
    assert theme_in_force().name is ThemeName.DARK
    for editor in (first, second):
        assert editor.window.store.state.display.theme is ThemeName.DARK
        assert editor.window.view.shown.settings.theme is ThemeName.DARK
    dark()
    set_theme(ThemeName.LIGHT)
    first.settle()
    assert first.window.store.state.display.theme is second.window.store.state.display.theme is ThemeName.LIGHT


@pytest.mark.parametrize(
    ("key", "scan", "axis"),
    [
        (Qt.Key.Key_X, 53, 0),
        (Qt.Key.Key_Z, 29, 2),  # a German keyboard has Z where an English one has Y
        (Qt.Key.Key_Y, 52, 1),
        (0x0427, 53, 0),  # Cyrillic che, on the key of X
        (0x042F, 52, 2),  # Cyrillic ya, on that of Z
        (0x03A5, 29, 1),  # Greek upsilon
        (0x03A7, 53, 0),  # Greek chi
        (0x05D6, 52, 2),  # Hebrew zayin
        (Qt.Key.Key_unknown, 29, 1),
        (Qt.Key.Key_W, 52, None),  # a French keyboard has W where an English one has Z
        (0x0416, 47, None),
        (Qt.Key.Key_Escape, 9, None),
        (Qt.Key.Key_Shift, 50, None),
        (Qt.Key.Key_Odiaeresis, 53, None),
    ],
)
def test_the_axis_keys_are_found_under_any_layout(app, key, scan, axis):
    event = QKeyEvent(QEvent.Type.KeyPress, key, Qt.KeyboardModifier.NoModifier, scan, 0, 0)
    assert axis_of(event) == axis
