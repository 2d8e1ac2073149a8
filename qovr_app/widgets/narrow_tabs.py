"""Tabs as narrow as their words."""

from __future__ import annotations

from PySide6.QtWidgets import QProxyStyle, QStyle, QStyleOption, QTabBar, QWidget

from qovr_app.style.spacing import SPACE


class NarrowTabs(QTabBar):
    """A bar of tabs with little room beside their words, which a narrow column then need not cut."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        style = _NarrowStyle("Fusion")
        style.setParent(self)
        self.setStyle(style)


class _NarrowStyle(QProxyStyle):
    def pixelMetric(
        self, metric: QStyle.PixelMetric, option: QStyleOption | None = None, widget: QWidget | None = None
    ) -> int:
        if metric is QStyle.PixelMetric.PM_TabBarTabHSpace:
            return 2 * SPACE
        return super().pixelMetric(metric, option, widget)
