"""A short page beside the work: the keys, the versions."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QTextBrowser, QVBoxLayout, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.dialogs.room import resize_within_screen
from qovr_app.widgets.parts import named


class Sheet(QDialog):
    """Shows a page; it is gone when it is closed."""

    def __init__(self, name: str, title: str, html: str, size: QSize, parent: QWidget) -> None:
        super().__init__(parent)
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.setWindowTitle(title)
        self.setObjectName(name)
        text = named(QTextBrowser(self), f"{name}.text", title)
        text.setHtml(html)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Close, self)
        buttons.rejected.connect(self.close)
        layout = QVBoxLayout(self)
        layout.addWidget(text)
        layout.addWidget(without_icons(buttons))
        resize_within_screen(self, size)
