"""The application as a whole: how it is made, and whether it is light or dark."""

from __future__ import annotations

import os
import sys

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QApplication

from qovr_app.view3d.probe import set_default_format
from qovr_app.view3d.settings import ThemeName
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
    """Make all windows light or dark, whatever the system says."""
    scheme = Qt.ColorScheme.Dark if name is ThemeName.DARK else Qt.ColorScheme.Light
    QGuiApplication.styleHints().setColorScheme(scheme)


def theme() -> ThemeName:
    """Return whether windows are light or dark now."""
    is_dark = QGuiApplication.styleHints().colorScheme() is Qt.ColorScheme.Dark
    return ThemeName.DARK if is_dark else ThemeName.LIGHT
