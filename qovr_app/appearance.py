"""The application as a whole: how it is made, and whether it is light or dark."""

from __future__ import annotations

import os
import sys

from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from qovr_app.view3d.probe import set_default_format
from qovr_app.view3d.settings import ThemeName
from qovr_core import QovrError

NAME = "QOVR Studio"

_MIDDLE_LIGHTNESS = 128
_COLORS = {
    ThemeName.LIGHT: {
        "Window": "#f3f4f6",
        "WindowText": "#20242a",
        "Base": "#ffffff",
        "AlternateBase": "#f7f8fa",
        "Text": "#20242a",
        "PlaceholderText": "#8a919b",
        "Button": "#f3f4f6",
        "ButtonText": "#20242a",
        "BrightText": "#ffffff",
        "ToolTipBase": "#ffffff",
        "ToolTipText": "#20242a",
        "Highlight": "#1c64d8",
        "HighlightedText": "#ffffff",
        "Link": "#1c64d8",
        "Light": "#ffffff",
        "Midlight": "#e6e8ec",
        "Mid": "#c4c9d0",
        "Dark": "#9aa1ab",
        "Shadow": "#6b727c",
    },
    ThemeName.DARK: {
        "Window": "#2a2d33",
        "WindowText": "#e8eaee",
        "Base": "#202328",
        "AlternateBase": "#26292f",
        "Text": "#e8eaee",
        "PlaceholderText": "#868d98",
        "Button": "#34383f",
        "ButtonText": "#e8eaee",
        "BrightText": "#ffffff",
        "ToolTipBase": "#34383f",
        "ToolTipText": "#e8eaee",
        "Highlight": "#3d7de0",
        "HighlightedText": "#ffffff",
        "Link": "#5c9dff",
        "Light": "#454a53",
        "Midlight": "#3b4048",
        "Mid": "#2f3339",
        "Dark": "#1b1d21",
        "Shadow": "#101114",
    },
}
"""Greys of the view's own themes and its one accent."""

_FAINT = {ThemeName.LIGHT: "#a3a9b2", ThemeName.DARK: "#6d747f"}


def make_application(arguments: list[str], *, scale: float | None = None) -> QApplication:
    """Return the application, ready for windows.

    Parameters
    ----------
    arguments : as in ``sys.argv``
    scale : scale factor of all windows; None takes the system's

    Raises
    ------
    QovrError : there is no display
    """
    _check_display()
    if scale is not None:
        os.environ["QT_SCALE_FACTOR"] = f"{scale:g}"
    set_default_format()
    application = QApplication(arguments[:1])
    application.setApplicationName(NAME)
    application.setOrganizationName("qovr")
    application.setStyle("Fusion")
    return application


def _check_display() -> None:
    """Refuse in words where Qt would abort the process."""
    if sys.platform != "linux" or os.environ.get("QT_QPA_PLATFORM", "").split(":")[0] in (
        "offscreen",
        "minimal",
        "vnc",
    ):
        return
    if not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise QovrError("there is no display; the window needs one, a virtual one serves (xvfb-run qovr ...)")


def set_theme(name: ThemeName) -> None:
    """Make all windows light or dark, whatever the system says.

    Qt can ask the desktop for it only where there is one; a palette of our own works everywhere.
    """
    QApplication.setPalette(_palette(name))


def theme() -> ThemeName:
    """Return whether windows are light or dark now."""
    is_dark = QGuiApplication.palette().color(QPalette.ColorRole.Window).lightness() < _MIDDLE_LIGHTNESS
    return ThemeName.DARK if is_dark else ThemeName.LIGHT


def _palette(name: ThemeName) -> QPalette:
    role = QPalette.ColorRole
    palette = QPalette()
    for place, color in _COLORS[name].items():
        palette.setColor(role[place], QColor(color))
    faint = QColor(_FAINT[name])
    for place in (role.WindowText, role.Text, role.ButtonText, role.HighlightedText):
        palette.setColor(QPalette.ColorGroup.Disabled, place, faint)
    return palette
