"""The laboratory's place under the 3D view: one panel at a time, made when it is first asked for."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from importlib import import_module
from typing import Any

from PySide6.QtCore import QEvent, QSignalBlocker, QSize, QTimer, Signal
from PySide6.QtGui import QAction, QShowEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QStackedWidget, QTabBar, QToolButton, QVBoxLayout, QWidget

from qovr_app.laboratory.panel import Focus, LaboratoryPanel
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.window.actions import Command
from qovr_app.work.worker import Worker
from qovr_core import Document

_FIRST_SIZE = QSize(640, 330)
_LEAST_SIZE = QSize(320, 160)
"""What leaves the 3D view its own least height in a window of 1280 x 720."""


@dataclass(frozen=True)
class PanelEntry:
    """One panel.

    Parameters
    ----------
    name : the panel is called ``laboratory.NAME``, its command ``laboratory_NAME``
    title : what the menu says, and the tab without the mark of its access key
    tip : one sentence on what it shows
    module, kind : where its class is, below ``qovr_app.laboratory``; imported when the panel is first shown
    """

    name: str
    title: str
    tip: str
    module: str
    kind: str

    def make(self) -> LaboratoryPanel:
        """Return a new panel."""
        return getattr(import_module(f"qovr_app.laboratory.{self.module}"), self.kind)()


PANELS = (
    PanelEntry("curve", "One &curve", "One curve of the surface with all its parts", "curve_panel", "CurvePanel"),
    PanelEntry(
        "influence",
        "&Influence",
        "What one point or knot moves, and how far",
        "influence_panel",
        "InfluencePanel",
    ),
    PanelEntry(
        "comparison",
        "Co&mparison",
        "Bezier, B-spline, NURBS and Catmull-Rom of the same net: in the view, and measured",
        "comparison_panel",
        "ComparisonPanel",
    ),
    PanelEntry(
        "claims", "C&laims", "What the paper says of its surfaces, and what is so", "claims_panel", "ClaimsPanel"
    ),
)
"""All panels, in the order of their tabs."""

_NEVER = object()
_FIRST_NUMBER = 6
"""Alt and the numbers below go to the zones and the view."""


class LaboratoryPlace(QWidget):
    """Tabs over the panel that is shown.

    Hidden until a panel is asked for. Panels are told the latest theme, focus and document, while they are seen.

    Signals
    -------
    panel_changed : the name of the panel that is shown now; empty when the place is closed
    document_requested, values_edited, figure_requested, told, comparison_requested : those of all panels
    """

    panel_changed = Signal(str)
    document_requested = Signal(object, str)
    values_edited = Signal(object, int)
    figure_requested = Signal(str, object)
    told = Signal(str, bool)
    comparison_requested = Signal(object)

    def __init__(self, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._worker = worker
        self._theme = theme_in_force()
        self.setObjectName("laboratory")
        self.setAccessibleName("Laboratory")
        self.setAutoFillBackground(True)
        self.setVisible(False)
        self.panels: dict[str, LaboratoryPanel] = {}
        self._commands: dict[str, QAction] = {}
        self._document: Document | None = None
        self._focus: Focus = None
        self._last_told: dict[str, dict[str, Any]] = {}
        self._due = QTimer(self, singleShot=True, interval=0)
        self._due.timeout.connect(self._tell_panel)
        self._tabs = self._make_tabs()
        self._stale = QLabel("older than what is set", self, objectName="laboratory.stale")
        self._stale.setToolTip("All panels are of the surface configured last.")
        self._stale.setVisible(False)
        self._stack = QStackedWidget(self)
        self._arrange()

    def sizeHint(self) -> QSize:
        return _FIRST_SIZE

    def minimumSizeHint(self) -> QSize:
        return super().minimumSizeHint().expandedTo(_LEAST_SIZE)

    @property
    def shown(self) -> str:
        """The name of the panel that is shown; empty where the place is closed."""
        return "" if self.isHidden() else PANELS[self._tabs.currentIndex()].name

    def open(self, name: str) -> None:
        """Show a panel, made now if it has not been shown before."""
        number = [entry.name for entry in PANELS].index(name)
        panel = self.panels.get(name) or self._make_panel(PANELS[number])
        with QSignalBlocker(self._tabs):
            self._tabs.setCurrentIndex(number)
        self._stack.setCurrentWidget(panel)
        self.setVisible(True)
        self._due.start()
        self.panel_changed.emit(name)

    def close_panels(self) -> None:
        """Give the room back to the view."""
        self.setVisible(False)
        self.panel_changed.emit("")

    def set_stale(self, is_stale: bool) -> None:
        """Say whether the panels show a surface that is not the document's."""
        self._stale.setVisible(is_stale)

    def use_commands(self, commands: dict[str, QAction]) -> None:
        """Take the window's commands, for panels that offer one of them."""
        self._commands = commands

    def show_document(self, document: Document) -> None:
        """Take the document of the surface in the view; told at once, so that both reach the screen in one frame."""
        self._document = document
        self._tell_panel()

    def show_focus(self, focus: Focus) -> None:
        """Take the knot or point in focus."""
        self._focus = focus
        self._tell_panel()

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and self._theme is not theme_in_force():
            self._theme = theme_in_force()
            self._due.start()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._due.start()

    def _tell_panel(self) -> None:
        """Tell the panel that is seen what it has not been told yet."""
        panel = self.panels.get(self.shown)
        if panel is None or not panel.isVisible():
            return
        last = self._last_told.setdefault(self.shown, {})
        news = {"theme": self._theme, "focus": self._focus, "document": self._document}
        for subject, fact in news.items():
            if fact is not last.get(subject, _NEVER) and not (subject == "document" and fact is None):
                last[subject] = fact
                getattr(panel, f"show_{subject}")(fact)

    def _make_panel(self, entry: PanelEntry) -> LaboratoryPanel:
        panel = entry.make()
        panel.use_commands(self._commands)
        panel.use_worker(self._worker)
        panel.setObjectName(f"laboratory.{entry.name}")
        panel.setAccessibleName(entry.title.replace("&", ""))
        for signal in ("document_requested", "values_edited", "figure_requested", "told", "comparison_requested"):
            getattr(panel, signal).connect(getattr(self, signal))
        self._stack.addWidget(panel)
        self.panels[entry.name] = panel
        return panel

    def _make_tabs(self) -> QTabBar:
        tabs = QTabBar(self, objectName="laboratory.tabs", accessibleName="Panels of the laboratory")
        tabs.setDocumentMode(True)
        tabs.setDrawBase(False)
        tabs.setExpanding(False)
        for number, entry in enumerate(PANELS):
            tabs.addTab(entry.title.replace("&", ""))
            tabs.setTabToolTip(number, entry.tip)
        tabs.currentChanged.connect(lambda number: self.open(PANELS[number].name))
        return tabs

    def _arrange(self) -> None:
        close = QToolButton(self, objectName="laboratory.close", accessibleName="Close the laboratory")
        close.setText("×")
        close.setToolTip("Close the laboratory")
        close.setAutoRaise(True)
        close.clicked.connect(self.close_panels)
        head = QHBoxLayout()
        head.setContentsMargins(SPACE, SPACE // 2, SPACE, 0)
        head.addWidget(self._tabs, 1)
        head.addWidget(self._stale)
        head.addWidget(close)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(head)
        layout.addWidget(self._stack, 1)


def laboratory_commands(place: LaboratoryPlace) -> list[Command]:
    """Return the commands of the menu Laboratory, each of which opens its panel or closes it."""

    def switch(name: str) -> Callable[[bool], None]:
        return lambda checked: place.open(name) if checked else place.close_panels()

    return [
        Command(
            f"laboratory_{entry.name}",
            entry.title,
            switch(entry.name),
            "&Laboratory",
            f"Alt+{number}",
            checked=False,
            tip=entry.tip,
        )
        for number, entry in enumerate(PANELS, start=_FIRST_NUMBER)
    ]


def check_shown(actions: dict[str, QAction], name: str) -> None:
    """Check the command of the panel that is shown, and no other."""
    for entry in PANELS:
        actions[f"laboratory_{entry.name}"].setChecked(entry.name == name)
