"""The animation of the README: five gestures, done by real events and taken frame by frame from the window.

cd tests && xvfb-run -a -s "-screen 0 2600x1600x24" ../.venv/bin/python -m gestures.animation ../.github/gestures.gif
"""

import sys
from pathlib import Path

from PIL import Image
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QColor, QImage, QPainter
from PySide6.QtTest import QTest

from qovr_app.state.display import DisplaySettings
from qovr_app.state.intents import FormulationChosen
from qovr_app.state.looking_intents import DisplayChosen
from qovr_app.window.application import make_application
from support.editor import Editor
from support.pictures import picture_of

from .gesture import GestureHand

SIZE = (1280, 720)
SHOWN = (880, 495)
"""Pixels of the animation."""

COLOURS = 96
FRAME, PAUSE = 90, 900
"""Milliseconds of a frame that moves, and of one that is to be read."""

MOST_BYTES = 2_000_000


class Film(GestureHand):
    """A hand whose every step is a frame."""

    def __init__(self, editor):
        super().__init__(editor)
        self.frames, self.times, self.caption = [], [], ""

    def take(self, milliseconds=FRAME):
        picture = picture_of(self.editor.window, self.viewport.mapToGlobal(self.at), rest=0).toImage()
        picture = picture.scaled(
            *SHOWN, Qt.AspectRatioMode.IgnoreAspectRatio, Qt.TransformationMode.SmoothTransformation
        )
        _write(picture, self.caption)
        picture = picture.convertToFormat(QImage.Format.Format_RGB888)
        image = Image.frombytes("RGB", SHOWN, bytes(picture.constBits()), "raw", "RGB", picture.bytesPerLine())
        self.frames.append(image)
        self.times.append(milliseconds)

    def go(self, at, steps=6):
        """Move the mouse there in so many frames."""
        start = self.at
        for step in range(1, steps + 1):
            self.move(start + (QPointF(at) - start) * step / steps)
            self.take()

    def go_by(self, dx, dy, steps=7):
        self.go(self.at + QPointF(dx, dy), steps)

    def rest_at(self, milliseconds=PAUSE):
        QTest.qWait(250)
        self.take(milliseconds)

    def begin(self, caption):
        self.caption = caption
        self.take(PAUSE)


def _write(picture, caption):
    """Write what is done into the picture, at the bottom of its middle."""
    painter = QPainter(picture)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    font = painter.font()
    font.setPixelSize(17)
    painter.setFont(font)
    width = painter.fontMetrics().horizontalAdvance(caption) + 28
    plate = QRectF((SHOWN[0] - width) / 2, SHOWN[1] - 42, width, 30)
    painter.setPen(Qt.PenStyle.NoPen)
    painter.setBrush(QColor(28, 32, 38))
    painter.drawRoundedRect(plate, 6, 6)
    painter.setPen(QColor("white"))
    painter.drawText(plate, Qt.AlignmentFlag.AlignCenter, caption)
    painter.end()


def _pull(film):
    film.begin("Pull a point: it moves along z, its numbers beside it")
    film.go(film.place(2, 2))
    film.press()
    film.go_by(6, -42, 7)
    film.rest_at()
    film.release()


def _plane(film):
    film.begin("Arrows and squares move along axes and in planes")
    film.go(film.square(2))
    film.press()
    film.go_by(46, 26)
    film.rest_at()
    film.tap(Qt.Key.Key_Escape)
    film.release()
    film.take(400)


def _soft(film):
    film.begin("Soft and mirrored: the neighbours follow, on both sides")
    for command in ("soft", "symmetry_columns"):
        film.editor.trigger(command)
    film.go(film.place(2, 1))
    film.press()
    film.go_by(4, -40, 7)
    film.rest_at()
    film.release()
    for command in ("soft", "symmetry_columns"):
        film.editor.trigger(command)


def _knot(film):
    film.begin("Drag a knot along its chord: where the middle point lies")
    film.editor.field("row_knots.C_2.u").setFocus()
    film.editor.settle()
    first, last = film.place(2, 1), film.place(2, 3)
    film.go(first + 0.5 * (last - first))
    film.press()
    film.go(first + 0.62 * (last - first))
    film.go(first + 0.44 * (last - first), 7)
    film.rest_at()
    film.release()
    film.tap(Qt.Key.Key_Escape)


def _rectangle(film):
    film.begin("Select with a rectangle, and flatten")
    film.viewport.setFocus()
    film.editor.trigger("xray")
    corner, other = film.around((0, 0), (0, 1), (0, 2), (0, 3), (0, 4))
    film.go(corner)
    film.hold(Qt.Key.Key_Control)
    film.press()
    film.go(other)
    film.release()
    film.let_go(Qt.Key.Key_Control)
    film.rest_at()
    film.editor.trigger("flatten_height")
    film.rest_at(1600)


def main(path):
    application = make_application(["animation"])

    from qovr_app.window.main_window import MainWindow

    editor = Editor(MainWindow("paper:fig8"), SIZE)
    editor.dispatch(FormulationChosen("interpolating"))
    for setting, value in {"theme": DisplaySettings().theme, "labels": False}.items():
        editor.dispatch(DisplayChosen(setting, value))
    QTest.qWait(800)
    film = Film(editor)
    film.at = QPointF(film.viewport.width() / 2, film.viewport.height() - 80)
    for part in (_pull, _plane, _soft, _knot, _rectangle):
        part(film)
        editor.trigger("fit")
        film.rest()
    editor.discard()
    _save(film, path)
    application.quit()


def _save(film, path):
    """Write all frames in one palette; what stays the same from frame to frame costs nothing."""
    montage = Image.new("RGB", (SHOWN[0], SHOWN[1] * 5))
    for k in range(5):
        montage.paste(film.frames[k * (len(film.frames) - 1) // 4], (0, k * SHOWN[1]))
    palette = montage.quantize(COLOURS, dither=Image.Dither.NONE)
    first, *others = (frame.quantize(palette=palette, dither=Image.Dither.NONE) for frame in film.frames)
    first.save(path, save_all=True, append_images=others, duration=film.times, loop=0, optimize=False)
    size = Path(path).stat().st_size
    print(f"{path}: {len(film.frames)} frames, {size / 1e6:.2f} MB")
    assert size < MOST_BYTES


if __name__ == "__main__":
    main(*sys.argv[1:])
