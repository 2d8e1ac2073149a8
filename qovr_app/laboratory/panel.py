"""What every panel of the laboratory is told, and what it may ask for."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtGui import QAction
from PySide6.QtWidgets import QWidget

from qovr_app.style.theme import Theme
from qovr_app.view3d.scene.scene import NetIndex
from qovr_app.work.worker import Worker
from qovr_core import Document
from qovr_core.edits import KnotPlace

Focus = KnotPlace | NetIndex | None
"""The knot whose field has the keyboard, or the control point (i, j) that is selected, whichever came last."""


class LaboratoryPanel(QWidget):
    """A panel that shows something of the configured surface and changes nothing by itself.

    While it is visible, its place tells it the theme, the focus and the latest document: once when it becomes visible,
    and then whenever they change. A document comes at most once in a turn of the event loop, before the turn's frame.

    Signals
    -------
    document_requested : a Document to open as a new one, and its title
    values_edited : a dict of places and values that one intent changes, and its gesture, 0 for none
    figure_requested : a name for the file, and a function of its path and FigureOptions that writes it
    told : a sentence for the message line, and whether it is a refusal
    comparison_requested : a ComparisonView for the view to show beside or over the surface, or None
    """

    document_requested = Signal(object, str)
    values_edited = Signal(object, int)
    figure_requested = Signal(str, object)
    told = Signal(str, bool)
    comparison_requested = Signal(object)

    def use_commands(self, commands: dict[str, QAction]) -> None:
        """Take the window's commands by name, once; panels that need none of them do nothing."""

    def use_worker(self, worker: Worker) -> None:
        """Take the window's worker, once; panels whose work takes no time do nothing."""

    def show_document(self, document: Document) -> None:
        """Show the document of the surface in the view; every panel does it in its own way."""

    def show_focus(self, focus: Focus) -> None:
        """Show what belongs to the knot or point in focus; panels that have nothing to do with it do nothing."""

    def show_theme(self, theme: Theme) -> None:
        """Draw in other colours; panels that take all of theirs from the palette do nothing."""
