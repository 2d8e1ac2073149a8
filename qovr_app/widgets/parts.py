"""Small widgets that zones, panels and dialogs share."""

from __future__ import annotations

from typing import TypeVar

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QColor, QPalette, QResizeEvent
from PySide6.QtWidgets import QLabel, QPushButton, QSizePolicy, QWidget

from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.plain import plain_label

W = TypeVar("W", bound=QWidget)

_DUE_INK = QColor(24, 20, 8)
"""Writes on amber, which is light in both themes."""


class CompactButton(QPushButton):
    """A push button no wider than its text, which can be the one thing to do next."""

    def __init__(self, text: str, name: str, tip: str, parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setObjectName(name)
        self.setToolTip(tip)
        self._is_due = False
        self._coloured_for = theme_in_force()
        self.setSizePolicy(QSizePolicy.Policy.Maximum, QSizePolicy.Policy.Fixed)
        self.setAutoDefault(False)

    def set_due(self, is_due: bool) -> None:
        """Colour the button, as what is pending, while it is what comes next."""
        if is_due != self._is_due:
            self._is_due = is_due
            self._colour()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._is_due and self._coloured_for is not theme_in_force():
            self._colour()

    def _colour(self) -> None:
        palette = QPalette()
        self._coloured_for = theme_in_force()
        if self._is_due:
            palette.setColor(QPalette.ColorRole.Button, QColor(*self._coloured_for.pending))
            palette.setColor(QPalette.ColorRole.ButtonText, _DUE_INK)
        self.setPalette(palette)


class Note(QLabel):
    """Some lines of explanation, with links that the keyboard reaches; no room where there is nothing to say."""

    def __init__(self, name: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setObjectName(name)
        self.setWordWrap(True)
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setTextInteractionFlags(
            Qt.TextInteractionFlag.LinksAccessibleByMouse | Qt.TextInteractionFlag.LinksAccessibleByKeyboard
        )
        self.setVisible(False)

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange:
            text = self.text()  # links keep the colour in which they were read
            self.clear()
            self.setText(text)

    def minimumSizeHint(self) -> QSize:
        """Return a size with all lines, at the present width: a splitter asks for no other."""
        return QSize(super().minimumSizeHint().width(), self.heightForWidth(self.width()))

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.size().width() != event.oldSize().width():
            self.updateGeometry()

    def say(self, html: str) -> None:
        """Show a text; an empty one takes the note away."""
        if html != self.text():
            self.setText(html)
            self.setVisible(bool(html))


def named(widget: W, name: str, spoken: str = "") -> W:
    """Return the widget under the name by which programs find it, and the one that is spoken, if any."""
    widget.setObjectName(name)
    if spoken:
        widget.setAccessibleName(spoken)
    return widget


def words(name: str, parent: QWidget | None = None) -> QLabel:
    """Return a label that breaks lines and takes no text for markup, under a name."""
    result = named(plain_label("", parent), name)
    result.setWordWrap(True)
    return result


def symbol(html: str, *, quiet: bool = False, parent: QWidget | None = None) -> QLabel:
    """Return a label that shows a symbol, for the eye only: fields carry their spoken names themselves."""
    result = QLabel(html, parent)
    result.setTextFormat(Qt.TextFormat.RichText)
    result.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
    if quiet:
        result.setForegroundRole(QPalette.ColorRole.PlaceholderText)
    return result


def title_html(title: str, aside: str) -> str:
    """Return a zone's title with the paper's symbol beside it."""
    return f"<b>{title}</b>&nbsp;&nbsp;{aside}"


MARGINS = (2 * SPACE, SPACE + 2, 2 * SPACE, SPACE + 2)
