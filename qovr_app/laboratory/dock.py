"""The laboratory, wherever it has its place: one panel at a time, made when it is first asked for."""

from __future__ import annotations

from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import (
    QFrame,
    QHBoxLayout,
    QLabel,
    QMenu,
    QScrollArea,
    QStackedWidget,
    QToolButton,
    QVBoxLayout,
    QWidget,
)

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.laboratory.panels import PANELS, PanelRecord
from qovr_app.laboratory.places import PLACES
from qovr_app.state.editor_state import EditorState
from qovr_app.state.looking_intents import DisplayChosen, PanelShown
from qovr_app.store import Store
from qovr_app.style.spacing import SPACE
from qovr_app.widgets.narrow_tabs import NarrowTabs
from qovr_app.widgets.parts import named
from qovr_app.widgets.seen_part import SeenPart
from qovr_app.widgets.wheel import guard_from_wheels
from qovr_app.work.worker import Worker

_FIRST_SIZE = QSize(640, 330)
_LEAST_SIZE = QSize(264, 160)
_ENOUGH = 250
"""Less height than its panel needs the laboratory takes only where that is more; then the panel is scrolled."""


class LaboratoryDock(QWidget):
    """Tabs over the panel that is shown; hidden while none is. A window gives it its place.

    Only the panel that is seen follows the state; another one is brought up to date when it is seen again.
    """

    def __init__(self, store: Store, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._store, self._worker = store, worker
        self._records = tuple(PANELS.values())
        self.setObjectName("laboratory")
        self.setAccessibleName("Laboratory")
        self.setAutoFillBackground(True)
        self.setVisible(False)
        self._panels: dict[str, LaboratoryPanel] = {}
        self._seen: dict[str, SeenPart] = {}
        self._tabs = self._make_tabs()
        self._stale = named(QLabel("older than what is set", self), "laboratory.stale")
        self._stale.setToolTip("All panels are of the surface configured last.")
        self._stale.setVisible(False)
        self._stack = QStackedWidget(self)
        self._arrange()

    def sizeHint(self) -> QSize:
        return _FIRST_SIZE

    def minimumSizeHint(self) -> QSize:
        panel = self._panels.get(self._store.shown.panel)
        needed = _LEAST_SIZE.height() if panel is None else self._tabs.height() + panel.minimumSizeHint().height()
        return QSize(_LEAST_SIZE.width(), max(_LEAST_SIZE.height(), min(needed, _ENOUGH)))

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the panel that the state names, or none, and the state in it."""
        self._stale.setVisible(after.is_stale)
        if after.differs(before, "panel"):
            self._open(after.panel)
        for seen in self._seen.values():
            seen.show_state(before, after)

    def _open(self, name: str) -> None:
        """Bring a panel to the front, made now if it has not been shown before; give the room back without a name."""
        if name:
            number = [record.name for record in self._records].index(name)
            if name not in self._panels:
                self._panels[name] = self._make_panel(self._records[number])
            with QSignalBlocker(self._tabs):
                self._tabs.setCurrentIndex(number)
            self._stack.setCurrentIndex(list(self._panels).index(name))
            self.updateGeometry()
        self.setVisible(bool(name))

    def _make_panel(self, record: PanelRecord) -> LaboratoryPanel:
        panel = record.make(self._store, self._worker)
        panel.setObjectName(f"laboratory.{record.name}")
        panel.setAccessibleName(record.title.replace("&", ""))
        area = QScrollArea(self)
        area.setFrameShape(QFrame.Shape.NoFrame)
        area.setWidgetResizable(True)
        area.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        area.setWidget(panel)
        self._stack.addWidget(area)
        self._seen[record.name] = SeenPart(panel, panel.show_state, self._store)
        return panel

    def _make_tabs(self) -> NarrowTabs:
        tabs = named(NarrowTabs(self), "laboratory.tabs", "Panels of the laboratory")
        guard_from_wheels(tabs)
        tabs.setDocumentMode(True)
        tabs.setDrawBase(False)
        tabs.setExpanding(False)
        tabs.setUsesScrollButtons(False)  # in a narrow place they would hide a tab; shortened ones have tips
        tabs.setElideMode(Qt.TextElideMode.ElideRight)
        for number, record in enumerate(self._records):
            tabs.addTab(record.tab)
            tabs.setAccessibleTabName(number, record.title.replace("&", ""))
            tabs.setTabToolTip(number, record.tip)
        tabs.currentChanged.connect(lambda number: self._store.dispatch(PanelShown(self._records[number].name)))
        return tabs

    def _make_places(self, parent: QWidget) -> QMenu:
        menu = named(QMenu(parent), "laboratory.places")
        group = QActionGroup(menu)
        for place, text in PLACES.items():
            action = group.addAction(text)
            action.setCheckable(True)
            action.triggered.connect(
                lambda _checked, place=place: self._store.dispatch(DisplayChosen("laboratory_place", place))
            )
            menu.aboutToShow.connect(
                lambda action=action, place=place: action.setChecked(
                    self._store.state.display.laboratory_place is place
                )
            )
        menu.addActions(group.actions())
        return menu

    def _arrange(self) -> None:
        place = named(QToolButton(self), "laboratory.place", "Place of the laboratory")
        place.setText("⋮")
        place.setToolTip("Where the laboratory stands")
        place.setAutoRaise(True)
        place.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        place.setStyleSheet("QToolButton::menu-indicator { image: none; }")
        place.setMenu(self._make_places(place))
        close = named(QToolButton(self), "laboratory.close", "Close the laboratory")
        close.setText("×")
        close.setToolTip("Close the laboratory")
        close.setAutoRaise(True)
        close.clicked.connect(lambda _checked: self._store.dispatch(PanelShown("")))
        head = QHBoxLayout()
        head.setContentsMargins(SPACE, SPACE // 2, SPACE, 0)
        head.addWidget(self._tabs, 1)
        head.addWidget(self._stale)
        head.addWidget(place)
        head.addWidget(close)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addLayout(head)
        layout.addWidget(self._stack, 1)
