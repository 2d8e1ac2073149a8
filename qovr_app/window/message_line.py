"""The message line: one sentence that stays until it is outdated, and is read out."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QColor, QPalette
from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.state.editor_state import EditorState, Message
from qovr_app.state.looking_intents import MessageOutdated
from qovr_app.store import Dispatch
from qovr_app.style.palette import theme_in_force

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

    def _say(self, message: Message) -> None:
        palette = QPalette()
        if message.is_refusal:
            palette.setColor(QPalette.ColorRole.WindowText, QColor(*theme_in_force().bad))
        else:
            self._end.start()
        self.setPalette(palette)
        text = " ".join(message.text.split())
        self.setText(text)
        self.setToolTip(text)
        if QAccessible.isActive():
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))
