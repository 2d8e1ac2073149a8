"""The theme in force: the application's palette, from which Fusion draws all widgets."""

from __future__ import annotations

from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QGuiApplication, QPalette
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import ThemeChoice, ThemeName
from qovr_app.style.theme import Rgb, Theme, theme_of

_ROLE = QPalette.ColorRole
_DARK_BELOW = 0.5
"""The lightness of a window's ground below which the theme is the dark one."""

_BRIGHT: Rgb = (255, 255, 255)

_chosen = [ThemeChoice.SYSTEM]
"""What was chosen last; the palette itself says what is in force."""

_CHECK_BOX: Any = "QCheckBox"
"""WORKAROUND: PySide6 declares the class name as bytes, and refuses bytes."""


def theme_in_force() -> Theme:
    """Return the theme in force."""
    is_dark = QGuiApplication.palette().window().color().lightnessF() < _DARK_BELOW
    return theme_of(ThemeName.DARK if is_dark else ThemeName.LIGHT)


def set_theme(name: ThemeName) -> None:
    """Make all windows light or dark, whatever the system says."""
    choose_theme(ThemeChoice(name))


def choose_theme(choice: ThemeChoice) -> None:
    """Make all windows light or dark at once; as the system is, now and whenever it changes, where that is chosen."""
    hints, _chosen[0] = QGuiApplication.styleHints(), choice
    if choice is ThemeChoice.SYSTEM:
        hints.unsetColorScheme()
        _use_scheme(hints.colorScheme())
        return
    hints.setColorScheme(Qt.ColorScheme.Dark if choice is ThemeChoice.DARK else Qt.ColorScheme.Light)
    _use_palette(ThemeName(choice))  # some platforms have no scheme to set


def follow_system() -> None:
    """Make all windows light or dark as the system is, now and whenever it changes, until another theme is chosen."""
    hints = QGuiApplication.styleHints()
    _use_scheme(hints.colorScheme())
    hints.colorSchemeChanged.connect(_use_scheme)


def see_through(palette: QPalette) -> QPalette:
    """Return a palette whose fields have no background of their own: the cell behind is painted by the field."""
    result = QPalette(palette)
    result.setColor(_ROLE.Base, QColor(0, 0, 0, 0))
    return result


def _use_scheme(scheme: Qt.ColorScheme) -> None:
    if _chosen[0] is ThemeChoice.SYSTEM:
        _use_palette(ThemeName.DARK if scheme is Qt.ColorScheme.Dark else ThemeName.LIGHT)


def _use_palette(name: ThemeName) -> None:
    palette = _palette_of(theme_of(name))
    QApplication.setPalette(palette)
    # Fusion outlines a box to be checked darker than the window, where on dark nothing is seen.
    palette.setColor(_ROLE.Base, palette.color(_ROLE.Light))
    QApplication.setPalette(palette, _CHECK_BOX)


def _palette_of(colours: Theme) -> QPalette:
    palette = QPalette()
    for role, colour in {
        _ROLE.Window: colours.window,
        _ROLE.WindowText: colours.ink,
        _ROLE.Base: colours.cell,
        _ROLE.AlternateBase: colours.pane,
        _ROLE.Text: colours.ink,
        _ROLE.Button: colours.button,
        _ROLE.ButtonText: colours.ink,
        _ROLE.ToolTipBase: colours.tool_tip,
        _ROLE.ToolTipText: colours.ink,
        _ROLE.PlaceholderText: colours.placeholder_ink,
        _ROLE.Light: colours.light,
        _ROLE.Midlight: colours.midlight,
        _ROLE.Mid: colours.mid,
        _ROLE.Dark: colours.dark,
        _ROLE.Shadow: colours.shadow,
        _ROLE.BrightText: _BRIGHT,
        _ROLE.Highlight: colours.accent,
        _ROLE.Accent: colours.accent,
        _ROLE.Link: colours.accent,
        _ROLE.HighlightedText: colours.selected_ink,
    }.items():
        palette.setColor(role, QColor(*colour))
    for role in (_ROLE.WindowText, _ROLE.Text, _ROLE.ButtonText):
        palette.setColor(QPalette.ColorGroup.Disabled, role, QColor(*colours.faded_ink))
    return palette
