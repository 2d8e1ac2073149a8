"""Pictures of nets for the README: the shapes of many windows as the view draws them, and a net grown by hand.

cd tests && xvfb-run -a -s "-screen 0 2600x1600x24" ../.venv/bin/python -m gestures.gallery ../.github
"""

import sys
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QRect, Qt
from PySide6.QtGui import QImage, QPainter
from PySide6.QtTest import QTest

from qovr_app.state.display import Scaling, Style
from qovr_app.window.application import make_application
from support.editor import Editor
from support.hand import Hand
from support.pictures import picture_of

SIZE, WINDOW = (1280, 900), (1280, 720)
TILE = (560, 420)
SHOWN = {"hood": (-62.0, 34.0), "vase": (-60.0, 18.0), "folded-saddle": (-35.0, 34.0), "terrain": (-58.0, 38.0)}
"""The shapes, and from where each is seen: azimuth and elevation."""

BARE = (
    "control_points",
    "control_net",
    "labels",
    "axes",
    "colour_bar",
    "triad",
    "legend",
    "parameter_lines",
    "knot_handles",
)
REST = 900
NEARER = 0.7
"""The view fits the control points; the surface alone is smaller."""


def grown_net():
    """Return the window with a net of 7 x 9 points grown from the paper's, a crease in it, a point on it in hand."""
    from qovr_app.window.main_window import MainWindow

    editor = Editor(MainWindow("paper:fig5"), WINDOW)
    for command in ("new_paper", "append_after_u", "append_before_u", "append_after_v", "sharp_u", "crease_u"):
        editor.trigger(command)
    editor.key(Qt.Key.Key_Return, widget=editor.dialog("crease"))
    editor.trigger("fit")
    QTest.qWait(REST)
    hand = Hand(editor)
    hand.press(hand.place(3, 5))
    hand.move_by(0, -45)
    picture = picture_of(editor.window, hand.viewport.mapToGlobal(hand.at))
    hand.release()
    editor.discard()
    return picture


def gallery():
    """Return the shapes, two a row."""
    from qovr_app.state.looking_intents import DisplayChosen
    from qovr_app.window.main_window import MainWindow

    columns = 2
    sheet = QImage(TILE[0] * columns, TILE[1] * (-(-len(SHOWN) // columns)), QImage.Format.Format_RGB888)
    painter = QPainter(sheet)
    painter.setRenderHint(QPainter.RenderHint.SmoothPixmapTransform)
    for k, (name, (azimuth, elevation)) in enumerate(SHOWN.items()):
        editor = Editor(MainWindow(f"shape:{name}"), SIZE)
        for fact in BARE:
            editor.dispatch(DisplayChosen(fact, False))
        editor.dispatch(DisplayChosen("style", Style.SMOOTH))
        editor.dispatch(DisplayChosen("scaling", Scaling.EQUAL))
        view = editor.window.view
        view.camera_motion.move(replace(view.camera, azimuth=azimuth, elevation=elevation))
        editor.trigger("fit")
        view.camera_motion.move(replace(view.camera, span=NEARER * view.camera.span))
        QTest.qWait(REST)
        viewport = view.viewports[0]
        corner = viewport.mapTo(editor.window, viewport.rect().topLeft())
        height = min(viewport.height(), viewport.width() * TILE[1] // TILE[0])
        top = corner.y() + (viewport.height() - height) // 2
        part = picture_of(editor.window).toImage().copy(QRect(corner.x(), top, height * TILE[0] // TILE[1], height))
        painter.drawImage(QRect(k % columns * TILE[0], k // columns * TILE[1], *TILE), part)
        editor.discard()
    painter.end()
    return sheet


def main(folder):
    make_application(["gallery"])
    for name, picture in (("net", grown_net()), ("gallery", gallery())):
        assert picture.save(str(Path(folder, f"{name}.png")))


if __name__ == "__main__":
    main(*sys.argv[1:])
