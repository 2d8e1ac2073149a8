"""The window on screens of several sizes, light and dark, to be looked at.

    cd tests && xvfb-run -a -s "-screen 0 3900x2200x24" ../.venv/bin/python -m gestures.screens FOLDER

Each size is a process of its own: Qt takes its scale factor at the start.
"""

import subprocess
import sys
from pathlib import Path

from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest

from qovr_app.state.display import ThemeName
from qovr_app.state.looking_intents import DisplayChosen, PanelShown
from qovr_app.style.palette import set_theme
from qovr_app.window.application import make_application
from support.editor import Editor
from support.pictures import picture_of

SCREENS = {
    "1280x720": (1280, 720, 1.0),
    "1366x768 at 150": (911, 512, 1.5),
    "1440x900": (1440, 900, 1.0),
    "1920x1080": (1920, 1080, 1.0),
    "3840x2160 at 2": (1920, 1080, 2.0),
    "900x1400": (900, 1400, 1.0),
}
"""Logical width and height, and the scale factor."""

PANELS = ("", "curve", "comparison")
"""What is open beside: nothing, or a panel of the laboratory."""


def take(folder, name):
    """Take a screen's pictures."""
    width, height, scale = SCREENS[name]
    make_application(["screens"], scale=scale)

    from qovr_app.window.main_window import MainWindow

    for theme in ThemeName:
        set_theme(theme)
        editor = Editor(MainWindow("paper:fig5"), (width, height))
        editor.window.move(QPoint(0, 0))
        editor.dispatch(DisplayChosen("theme", theme))
        for panel in PANELS:
            editor.dispatch(PanelShown(panel))
            QTest.qWait(1500 if panel else 600)
            path = Path(folder, f"{name} {theme} {panel}".strip() + ".png")
            assert picture_of(editor.window).save(str(path))
        editor.discard()


if __name__ == "__main__":
    folder, *names = sys.argv[1:]
    Path(folder).mkdir(parents=True, exist_ok=True)
    if names:
        take(folder, *names)
    else:
        for each in SCREENS:
            subprocess.run([sys.executable, "-m", "gestures.screens", folder, each], check=True)
