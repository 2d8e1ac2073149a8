"""The zones' side of the window: all four, or one under its tab; and the laboratory where it takes their place."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QPainter, QPixmap, QResizeEvent
from PySide6.QtWidgets import QApplication, QFrame, QScrollArea, QTabBar, QVBoxLayout, QWidget

from qovr_app.style.canvas import painting
from qovr_app.style.spacing import SPACE
from qovr_app.style.theme import Rgb
from qovr_app.widgets.parts import named
from qovr_app.widgets.wheel import guard_from_wheels

ALL, LABORATORY = "all", "laboratory"
"""The tabs that are no zone's: all zones together, and the laboratory."""

_TITLES = {
    "row_knots": "Rows u",
    "column_knots": "Columns v",
    "control_points": "Points",
    "surface": "Surface",
    ALL: "Zones",
    LABORATORY: "Laboratory",
}
_SHORT = "Lab"
"""The laboratory beside four other tabs."""

_LEAST = QSize(264, 120)
_DOT = 8
"""Logical pixels across the dot on a tab whose zone holds what is not set or was refused."""


class Column(QWidget):
    """Tabs, where there is more than one thing to see; under them the zones, which scroll, or the laboratory.

    Parameters
    ----------
    content : what holds the zones
    above : what stands over all of it
    """

    def __init__(
        self, zones: Mapping[str, QWidget], content: QWidget, above: QWidget, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._zones = zones
        self._names: list[str] = []
        self._zone = "control_points"  # what is pulled in the view is seen there
        self._shows_laboratory = False
        self._marks: dict[str, tuple[Rgb | None, str]] = {}
        self._tabs = named(QTabBar(self), "zones.tabs", "Zones")
        guard_from_wheels(self._tabs)
        self._tabs.setDocumentMode(True)
        self._tabs.setDrawBase(False)
        self._tabs.setExpanding(False)
        self._tabs.setUsesScrollButtons(False)
        self._tabs.setElideMode(Qt.TextElideMode.ElideRight)
        self._tabs.setIconSize(QSize(_DOT, _DOT))
        self._tabs.currentChanged.connect(self._on_current)
        self._area = _ZonesArea(content, self)
        self.drawer = QWidget(self)
        layouts = QVBoxLayout(self), QVBoxLayout(self.drawer)
        for layout in layouts:
            layout.setContentsMargins(0, 0, 0, 0)
            layout.setSpacing(0)
        for part in (above, self._tabs, self._area, self.drawer):
            layouts[0].addWidget(part, int(part in (self._area, self.drawer)))

    @property
    def current(self) -> str:
        """The tab that is seen."""
        return self._names[self._tabs.currentIndex()] if self._names else ALL

    def keep_width(self, *, is_kept: bool) -> None:
        """Take as much width as the zones need not to be scrolled sideways, or be content with less."""
        self._area.keeps_width = is_kept
        self._area.updateGeometry()

    def offer(self, *, zones: bool, one_at_a_time: bool, laboratory: bool) -> None:
        """Have these things to see; what was seen stays, or what has the keyboard, or else a laboratory that comes."""
        names = ([*self._zones] if one_at_a_time else [ALL]) * zones + [LABORATORY] * laboratory
        self.setVisible(bool(names))
        if not names or names == self._names:
            return
        comes, in_use = LABORATORY not in self._names, self._zone_with_keyboard()
        self._zone = in_use or self._zone
        self._shows_laboratory = laboratory and not in_use and (comes or self._shows_laboratory)
        self._names, self._marks = names, {}
        with QSignalBlocker(self._tabs):
            while self._tabs.count():
                self._tabs.removeTab(0)
            for name in names:
                short = name == LABORATORY and len(names) > 2
                number = self._tabs.addTab(_SHORT if short else _TITLES[name])
                self._tabs.setAccessibleTabName(number, _TITLES[name])
        self._tabs.setVisible(len(names) > 1)
        self.bring(LABORATORY if self._shows_laboratory else self._zone)

    def bring(self, name: str) -> None:
        """Bring a zone, or the laboratory, before the user's eyes."""
        if name in self._zones:
            self._zone = name
        known = [each for each in (name, self._zone, ALL, *self._names) if each in self._names]
        if not known or (name == LABORATORY and known[0] != name):
            return
        with QSignalBlocker(self._tabs):
            self._tabs.setCurrentIndex(self._names.index(known[0]))
        self._show()

    def bring_into_sight(self, widget: QWidget) -> None:
        """Scroll until a widget of a zone is seen."""
        content = self._area.widget()
        if content is not None and content.isAncestorOf(widget):
            # Qt's own way would bring no more than the cursor of a line into sight.
            half, middle = widget.size() / 2, widget.mapTo(content, widget.rect().center())
            self._area.ensureVisible(middle.x(), middle.y(), half.width() + SPACE, half.height() + SPACE)

    def mark(self, name: str, colour: Rgb | None, text: str) -> None:
        """Put a dot on a zone's tab, and say why; take it away without a colour."""
        if name in self._names and self._marks.get(name, (None, "")) != (colour, text):
            self._marks[name] = colour, text
            number = self._names.index(name)
            self._tabs.setTabIcon(number, QIcon() if colour is None else _dot(colour, self.devicePixelRatioF()))
            self._tabs.setTabToolTip(number, text)
            self._tabs.setAccessibleTabName(number, f"{_TITLES[name]}, {text}" if text else _TITLES[name])

    def _on_current(self, _number: int) -> None:
        if self.current in self._zones:
            self._zone = self.current
        self._show()

    def _show(self) -> None:
        """Show what the tab says; a keyboard that was in what goes is on the tab from then on."""
        self._shows_laboratory = self.current == LABORATORY
        shown = {name for name in self._zones if self.current in (ALL, name)}
        focused = self._zone_with_keyboard()
        if focused and focused not in shown:
            self._tabs.setFocus()
        self.drawer.setVisible(self._shows_laboratory)
        self._area.setVisible(not self._shows_laboratory)
        if shown:
            for name, zone in self._zones.items():
                zone.setVisible(name in shown)
            seen = {self._zones[name].parentWidget() for name in shown}
            for zone in self._zones.values():
                if (splitter := zone.parentWidget()) is not None:
                    splitter.setVisible(splitter in seen)

    def _zone_with_keyboard(self) -> str:
        focused = QApplication.focusWidget()
        if focused is None:
            return ""
        return next((name for name, zone in self._zones.items() if zone.isAncestorOf(focused)), "")


class _ZonesArea(QScrollArea):
    """Lets the zones scroll where the window is low or narrow."""

    keeps_width = False

    def __init__(self, zones: QWidget, parent: QWidget) -> None:
        super().__init__(parent)
        self._content = zones
        self.setWidget(zones)
        self.setObjectName("zones")
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self.setFocusPolicy(Qt.FocusPolicy.NoFocus)

    def minimumSizeHint(self) -> QSize:
        if not self.keeps_width:
            return _LEAST
        needed = self._content.minimumSizeHint()
        bar = self.verticalScrollBar().sizeHint().width() * (needed.height() > self.height())
        return QSize(needed.width() + bar, _LEAST.height())

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        if event.oldSize().height() != event.size().height():
            self.updateGeometry()

    def sizeHint(self) -> QSize:
        """Return the size of the zones, not Qt's guess."""
        return self._content.sizeHint()


def _dot(colour: Rgb, ratio: float) -> QIcon:
    picture = QPixmap(round(_DOT * ratio), round(_DOT * ratio))
    picture.setDevicePixelRatio(ratio)
    picture.fill(Qt.GlobalColor.transparent)
    with painting(picture) as painter:
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(*colour))
        painter.drawEllipse(0, 0, _DOT, _DOT)
    return QIcon(picture)
