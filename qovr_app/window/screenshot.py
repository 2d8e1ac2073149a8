"""``qovr screenshot``: the editor's window as a picture, the surface in it."""

from __future__ import annotations

import argparse
import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from qovr_app.starting import starting
from qovr_core import QovrError
from qovr_core.commands.common import number, path
from qovr_core.files.atomic import check_target, replacing

if TYPE_CHECKING:
    from PySide6.QtGui import QImage
    from PySide6.QtWidgets import QApplication

    from qovr_app.window.main_window import MainWindow

_LARGEST_SIDE = 8192
_DEADLINE_MILLISECONDS = 30_000
_REST_MILLISECONDS = 400
"""Longer than the view takes from its last change to its finer grid."""


def add_command(commands: Any) -> None:
    """Add the command to the parser's commands."""
    command = commands.add_parser("screenshot", help="the editor's window as a picture; needs a display")
    command.add_argument("out", metavar="OUT.png", type=path)
    command.add_argument("source", metavar="SOURCE", nargs="?")
    command.add_argument("--size", type=_size, default=(1440, 900), help="of the window, before --scale (1440x900)")
    command.add_argument("--scale", type=_scale, default=1.0, help="scale factor, 1 to 4 (1)")
    command.add_argument("--theme", choices=["light", "dark"], default="light")
    command.add_argument("--camera", choices=["paper", "top"], default="paper")
    command.set_defaults(command=_screenshot)


def _size(text: str) -> tuple[int, int]:
    match = re.fullmatch(r"([0-9]{2,5})[xX]([0-9]{2,5})", text)
    if not match or max(int(match[1]), int(match[2])) > _LARGEST_SIDE:
        raise argparse.ArgumentTypeError(f"'{text}' is no size; expected WIDTHxHEIGHT up to {_LARGEST_SIDE}")
    return int(match[1]), int(match[2])


def _scale(text: str) -> float:
    scale = number(text)
    if not 1.0 <= scale <= 4.0:
        raise argparse.ArgumentTypeError(f"'{text}' is no scale factor; expected a number from 1 to 4")
    return scale


def _screenshot(arguments: argparse.Namespace) -> int:
    if arguments.out.suffix.lower() != ".png":
        raise QovrError(f"{arguments.out}: a screenshot is a PNG; expected a name that ends in .png")
    check_target(arguments.out)
    with starting():
        application, window = _shown_window(arguments)
    picture = take_picture(window, camera=arguments.camera)
    _write(picture, arguments.out)
    window.hide()
    window.deleteLater()
    application.processEvents()
    return 0


def _shown_window(arguments: argparse.Namespace) -> tuple[QApplication, MainWindow]:
    from qovr_app.state.display import ThemeName
    from qovr_app.style.palette import set_theme
    from qovr_app.window.application import make_application
    from qovr_app.window.main_window import MainWindow

    application = make_application(sys.argv, scale=arguments.scale)
    set_theme(ThemeName(arguments.theme))
    window = MainWindow(arguments.source)
    window.resize(*arguments.size)
    window.show()
    if (window.width(), window.height()) != arguments.size:
        least, (width, height) = window.minimumSizeHint(), arguments.size
        raise QovrError(
            f"--size {width} x {height} is too small for the window; "
            f"expected at least {least.width()} x {least.height()}"
        )
    return application, window


def _write(picture: QImage, out: Path) -> None:
    from PySide6.QtCore import QByteArray
    from PySide6.QtGui import QImageWriter

    with replacing(out) as (draft,):
        if not QImageWriter(str(draft), QByteArray(b"png")).write(picture):
            raise QovrError(f"{out}: the picture cannot be written")


def take_picture(window: MainWindow, *, camera: str) -> QImage:
    """Return a shown window as an image at the device's resolution, once its surface has come to rest.

    Raises
    ------
    QovrError : the window draws nothing within half a minute
    """
    from PySide6.QtCore import QEventLoop, QPoint, QTimer

    from qovr_app.style.canvas import painting

    view = window.view
    view.set_camera(camera, animated=False)
    loop = QEventLoop()
    rest = QTimer(singleShot=True, interval=_REST_MILLISECONDS)
    rest.timeout.connect(loop.quit)
    view.frame_painted.connect(rest.start)
    QTimer.singleShot(_DEADLINE_MILLISECONDS, loop, lambda: loop.exit(1))
    if loop.exec() != 0:
        raise QovrError("the window draws nothing; expected a display that shows it")
    picture = window.grab().toImage()
    surface = view.image()
    mark = window.parts.view_frame.stale_mark
    with painting(picture) as painter:
        painter.drawImage(view.mapTo(window, QPoint(0, 0)), surface)
        if mark.isVisible():
            painter.drawPixmap(mark.mapTo(window, QPoint(0, 0)), mark.grab())
    return picture
