"""The application as a whole: how it is made, and where it refuses to be."""

from __future__ import annotations

import os

from PySide6.QtWidgets import QApplication

from qovr_app.style.icon import program_icon
from qovr_app.style.palette import follow_system
from qovr_app.view3d.gl.support import set_default_format
from qovr_app.window.display import check_display
from qovr_core.commands.desktop import DESKTOP_NAME

NAME = "QOVR Studio"


def make_application(arguments: list[str], *, scale: float | None = None) -> QApplication:
    """Return the application, ready for windows.

    Parameters
    ----------
    arguments : as in ``sys.argv``
    scale : scale factor of all windows; None takes the system's

    Raises
    ------
    QovrError : no window can be had
    """
    check_display()
    if scale is not None:
        os.environ["QT_SCALE_FACTOR"] = f"{scale:g}"
    set_default_format()
    application = QApplication(arguments[:1])
    application.setApplicationName(NAME)
    application.setOrganizationName("qovr")
    application.setDesktopFileName(DESKTOP_NAME)
    application.setWindowIcon(program_icon())
    application.setStyle("Fusion")
    follow_system()
    return application
