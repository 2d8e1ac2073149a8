"""The message line: one sentence that stays until it is outdated, and is read out."""

from __future__ import annotations

from PySide6.QtCore import QEvent, Qt, QTimer
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QColor, QPalette
from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.state.editor_state import EditorState, Message
from qovr_app.state.looking_intents import MessageOutdated
from qovr_app.store import Dispatch
from qovr_app.style.palette import theme_in_force
from qovr_app.style.symbols import symbols_in_plain
from qovr_app.widgets.plain import plain_tip

_REPORT_MILLISECONDS = 12_000
"""After this long a report has been read; a refusal stays until something else is said."""

_INDENT = 8


class MessageLine(QLabel):
    """A label in the status bar, where the status tips of menus do not wipe it out for good."""

    def __init__(self, dispatch: Dispatch, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("message")
        self.setAccessibleName("Message")
        self.setMinimumWidth(1)
        self.setIndent(_INDENT)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self._is_refusal, self._coloured_for = False, theme_in_force()
        self._end = QTimer(self, singleShot=True, interval=_REPORT_MILLISECONDS)
        self._end.timeout.connect(lambda: dispatch(MessageOutdated()))

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the state's sentence; a new one is announced to who cannot see it."""
        if not after.differs(before, "message"):
            return
        self._end.stop()
        if after.message is None:
            self.clear()
            self.setToolTip("")
        else:
            self._say(after.message)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._coloured_for is not theme_in_force():
            self._colour()

    def _colour(self) -> None:
        self._coloured_for, palette = theme_in_force(), QPalette()
        if self._is_refusal:
            palette.setColor(QPalette.ColorRole.WindowText, QColor(*self._coloured_for.bad))
        self.setPalette(palette)

    def _say(self, message: Message) -> None:
        self._is_refusal = message.is_refusal
        if not message.is_refusal:
            self._end.start()
        self._colour()
        text = " ".join(message.text.split())
        self.setText(symbols_in_plain(text))
        self.setToolTip(plain_tip(self.text()))
        if QAccessible.isActive():
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))
