"""The command ``qovr``: the editor, its screenshot, and the headless commands."""

from __future__ import annotations

import argparse
import os
import signal
import sys
from contextlib import suppress
from functools import cache
from pathlib import Path
from typing import TYPE_CHECKING, Any, NoReturn

if TYPE_CHECKING:
    from qovr_app.window.main_window import MainWindow
    from qovr_app.window.windows import Windows

_EDIT = "edit"


def main() -> None:
    """Run the command line and leave with its exit code.

    What it needs is imported only here, when a signal no longer ends in a traceback.
    """
    _leave_on_signals()
    from qovr_core import cli
    from qovr_core.later import later

    screenshot = later("qovr_app.window.screenshot", "add_command")
    commands = {**cli.COMMANDS, "screenshot": screenshot, _EDIT: _add_edit}
    arguments = sys.argv[1:]
    if not arguments or not (arguments[0].startswith("-") or arguments[0] in commands):
        arguments = [_EDIT, *arguments]
    sys.exit(cli.run(commands, arguments))


def _add_edit(commands: Any) -> None:
    command = commands.add_parser(_EDIT, help="open the editor; also without this word: qovr [SOURCE...]")
    command.add_argument("sources", metavar="SOURCE", nargs="*", help="each opens in a window; in the one that runs")
    command.set_defaults(command=_edit)


def _leave_on_signals() -> None:
    """End at once on Ctrl-C and SIGTERM while nothing is begun yet, and when all is done."""

    def leave(number: int, _frame: object) -> NoReturn:
        with suppress(OSError):
            os.write(2, b"qovr: interrupted; no unfinished file is left\n")
        os._exit(128 + number)

    for number, usual in ((signal.SIGINT, signal.default_int_handler), (signal.SIGTERM, signal.SIG_DFL)):
        if signal.getsignal(number) == usual:
            signal.signal(number, leave)


def create_window(path: str | None = None) -> MainWindow:
    """Return the editor's main window, ready to be shown; a QApplication exists already.

    Parameters
    ----------
    path : a ``.qovr`` file, a workbook in the published layout, ``paper:NAME`` or ``shape:NAME``; None for the paper's
        example, which is also shown where the source cannot be read: then the message line says why. What is large
        comes when the window is shown.
    """
    from PySide6.QtCore import QTimer

    from qovr_app.state.looking_intents import MessageShown
    from qovr_app.state.requests import SourceAsked
    from qovr_app.window.main_window import MainWindow
    from qovr_app.window.preferences import Preferences
    from qovr_app.window.recovery import RecoveryStore
    from qovr_app.window.sources import is_large
    from qovr_core import QovrError

    preferences = Preferences()
    source, refusal = None if path is None else str(path), preferences.complaint
    comes_late = source is not None and is_large(source)
    try:
        window = MainWindow(None if comes_late else source, preferences, open_windows())
    except (QovrError, OSError, ValueError) as error:
        refusal = f"{error}."
        window = MainWindow(None, preferences, open_windows())
    window.protect(RecoveryStore())
    if refusal:
        window.store.dispatch(MessageShown(refusal, is_refusal=True))
    if comes_late and source is not None:
        QTimer.singleShot(0, window, lambda: window.store.dispatch(SourceAsked(source)))
    return window


def _edit(arguments: argparse.Namespace) -> int:
    from qovr_app.starting import starting
    from qovr_core.cli import SIGNALLED

    for source in arguments.sources:
        _check_call(source)
    codes: list[int] = []

    def end(number: int) -> None:
        codes.append(SIGNALLED + number)
        open_windows().end()
        application.exit()

    with starting():
        from qovr_app.window.application import make_application
        from qovr_app.window.post import Post
        from qovr_app.window.preferences import Preferences
        from qovr_app.window.preferences_shell import apply_preferences
        from qovr_app.window.signals import EndSignals
        from qovr_app.window.tour import offer_tour

        application = make_application(sys.argv)
        post = Post(application)
        if post.is_handed_over(arguments.sources):
            return 0
        ends = EndSignals(application)
        ends.came.connect(end)
        apply_preferences(Preferences(), open_windows())
        post.came.connect(open_windows().open_all)
        open_windows().open_all(arguments.sources)
        if not arguments.sources:
            offer_tour(open_windows().all[0], Preferences())
    code = application.exec()
    post.close()
    ends.close()
    return codes[0] if codes else code


@cache
def open_windows() -> Windows:
    """Return the windows of this process."""
    from qovr_app.window.windows import Windows

    return Windows(create_window)


def _check_call(source: str) -> None:
    """Refuse a word that can only be a mistyped command; whatever else cannot be read, the window says.

    Raises
    ------
    SourceError : the word names no file, and nothing that could be one
    """
    from qovr_core.files.sources import MADE_HERE, read_source, source_suffixes

    is_meant = source.startswith(MADE_HERE) or Path(source).suffix.lower() in source_suffixes()
    if not is_meant and not os.path.lexists(source):
        read_source(source)
