"""The command ``qovr``: the editor, its screenshot, and the headless commands."""

from __future__ import annotations

import argparse
import sys
from typing import TYPE_CHECKING

from qovr_app.window.screenshot import add_screenshot_command
from qovr_core import cli

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow

_EDIT = "edit"


def main() -> None:
    """Run the command line and leave with its exit code."""
    parser, commands = cli.build_parser()
    add_screenshot_command(commands)
    edit = commands.add_parser(_EDIT, help="open the editor; also without this word: qovr [SOURCE]")
    edit.add_argument("source", metavar="SOURCE", nargs="?")
    edit.set_defaults(command=_edit)
    arguments = sys.argv[1:]
    if not arguments or not (arguments[0].startswith("-") or arguments[0] in commands.choices):
        arguments = [_EDIT, *arguments]
    sys.exit(cli.run(parser, arguments))


def create_window(path: str | None = None) -> MainWindow:
    """Return the editor's main window, ready to be shown; a QApplication exists already.

    Parameters
    ----------
    path : a ``.qovr`` file, a workbook in the published layout, or ``paper:NAME``; None for the paper's example

    Raises
    ------
    QovrError : the source cannot be read
    """
    from qovr_app.window.main_window import MainWindow
    from qovr_app.window.preferences import Preferences
    from qovr_app.window.recovery import RecoveryStore

    window = MainWindow(None if path is None else str(path), Preferences())
    window.protect(RecoveryStore())
    return window


def _edit(arguments: argparse.Namespace) -> int:
    from qovr_app.window.application import make_application

    application = make_application(sys.argv)
    window = create_window(arguments.source)
    window.show()
    return application.exec()
