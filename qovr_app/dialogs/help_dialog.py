"""The help inside the program."""

from __future__ import annotations

from collections.abc import Iterable

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.dialogs.room import resize_within_screen
from qovr_app.widgets.parts import named
from qovr_core.resources import resource

_SIZE = QSize(720, 640)
_MARGIN = 16


class HelpDialog(QDialog):
    """A page to read beside the work."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Help")
        self.setObjectName("help")
        text = self._text = named(QTextBrowser(self), "help.text")
        text.setOpenExternalLinks(True)
        text.setFrameShape(QTextBrowser.Shape.NoFrame)
        text.document().setDocumentMargin(_MARGIN)
        self._read()
        text.setTextInteractionFlags(
            Qt.TextInteractionFlag.TextBrowserInteraction | Qt.TextInteractionFlag.TextSelectableByKeyboard
        )
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.rejected.connect(self.reject)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, _MARGIN // 2)
        layout.addWidget(text)
        layout.addWidget(without_icons(buttons))
        resize_within_screen(self, _SIZE)

    def show_about(self, names: Iterable[str]) -> None:
        """Show the page where it speaks of the first of these parts of the window that it speaks of at all."""
        self.show()
        self.raise_()
        part = next((name for name in names if f'<a name="{name}">' in self._html), "")
        if part:
            self._text.scrollToAnchor(part)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            place = self._text.verticalScrollBar().value()
            self._read()  # links keep the colour in which they were read
            self._text.verticalScrollBar().setValue(place)

    def _read(self) -> None:
        self._html = resource("help", "help.html").read_text(encoding="utf-8")
        self._text.setHtml(self._html)
