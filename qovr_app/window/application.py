"""The application as a whole: how it is made, and whether it is light or dark."""

from __future__ import annotations

import os
import sys

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import ThemeName
from qovr_app.style.theme import theme_of
from qovr_app.view3d.gl.support import set_default_format
from qovr_core import QovrError

NAME = "QOVR Studio"


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
    _follow_system()
    application.styleHints().colorSchemeChanged.connect(_follow_system)
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


_ROLES = {
    ThemeName.LIGHT: {
        "Window": "#f3f4f6",
        "WindowText": "#20242a",
        "Base": "#ffffff",
        "AlternateBase": "#f7f8fa",
        "Text": "#20242a",
        "Button": "#fafbfc",
        "ButtonText": "#20242a",
        "ToolTipBase": "#ffffff",
        "ToolTipText": "#20242a",
        "PlaceholderText": "#6c727b",
        "Light": "#ffffff",
        "Midlight": "#e9ebee",
        "Mid": "#d2d5da",
        "Dark": "#a8adb6",
        "Shadow": "#8a8f98",
        "BrightText": "#ffffff",
    },
    ThemeName.DARK: {
        "Window": "#26292f",
        "WindowText": "#e8eaee",
        "Base": "#1e2024",
        "AlternateBase": "#26292f",
        "Text": "#e8eaee",
        "Button": "#353941",
        "ButtonText": "#e8eaee",
        "ToolTipBase": "#353941",
        "ToolTipText": "#e8eaee",
        "PlaceholderText": "#98a0aa",
        "Light": "#4a4f59",
        "Midlight": "#3c4048",
        "Mid": "#3a3e46",
        "Dark": "#17191c",
        "Shadow": "#101114",
        "BrightText": "#ffffff",
    },
}
"""The palette of each theme. Fusion draws everything from these, so that panels and view are of one kind."""

_FADED = {ThemeName.LIGHT: "#a3a8b0", ThemeName.DARK: "#6b717b"}
"""The text of what is disabled."""


def set_theme(name: ThemeName) -> None:
    """Make all windows light or dark, whatever the system says."""
    scheme = Qt.ColorScheme.Dark if name is ThemeName.DARK else Qt.ColorScheme.Light
    QGuiApplication.styleHints().setColorScheme(scheme)
    _use_palette(name)  # some platforms have no scheme to set


def theme() -> ThemeName:
    """Return whether windows are light or dark now."""
    return ThemeName.DARK if QGuiApplication.palette().window().color().lightnessF() < 0.5 else ThemeName.LIGHT


def _follow_system() -> None:
    is_dark = QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark
    _use_palette(ThemeName.DARK if is_dark else ThemeName.LIGHT)


def _use_palette(name: ThemeName) -> None:
    palette = _palette(name)
    QApplication.setPalette(palette)
    # Fusion outlines a box to be checked darker than the window, where on dark nothing is seen.
    palette.setColor(QPalette.ColorRole.Base, palette.color(QPalette.ColorRole.Light))
    QApplication.setPalette(palette, "QCheckBox")


def _palette(name: ThemeName) -> QPalette:
    palette, roles = QPalette(), QPalette.ColorRole
    for role, colour in _ROLES[name].items():
        palette.setColor(roles[role], QColor(colour))
    for role in (roles.WindowText, roles.Text, roles.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(_FADED[name]))
    accent = QColor(*theme_of(name).accent)
    for role in (roles.Highlight, roles.Accent, roles.Link):
        palette.setColor(role, accent)
    palette.setColor(roles.HighlightedText, QColor("#ffffff" if name is ThemeName.LIGHT else "#10141c"))
    return palette
