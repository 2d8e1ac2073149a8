"""The message line: one sentence that stays until it is outdated, and is read out."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer
from PySide6.QtGui import QAccessible, QAccessibleAnnouncementEvent, QColor, QPalette
from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.style.palette import theme_in_force

_REPORT_MILLISECONDS = 12_000
"""After this long a report has been read; a refusal stays until something else is said."""

_INDENT = 8


class MessageLine(QLabel):
    """A label in the status bar, where the status tips of menus do not wipe it out for good."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName("message")
        self.setAccessibleName("Message")
        self.setMinimumWidth(1)
        self.setIndent(_INDENT)
        self.setTextFormat(Qt.TextFormat.PlainText)
        self._is_refusal = False
        self._end = QTimer(self, singleShot=True, interval=_REPORT_MILLISECONDS)
        self._end.timeout.connect(self.clear)

    def outdate(self) -> None:
        """Take a refusal away: the document has changed since."""
        if self._is_refusal:
            self.clear()

    def say(self, text: str, *, is_refusal: bool) -> None:
        """Show a sentence; it is announced to who cannot see it."""
        self._is_refusal = is_refusal
        palette = QPalette()
        if is_refusal:
            palette.setColor(QPalette.ColorRole.WindowText, QColor(*theme_in_force().bad))
            self._end.stop()
        else:
            self._end.start()
        self.setPalette(palette)
        text = " ".join(text.split())
        self.setText(text)
        self.setToolTip(text)
        if QAccessible.isActive():
            QAccessible.updateAccessibility(QAccessibleAnnouncementEvent(self, text))
