"""What stands on the screen, with the mouse's arrow drawn where the hand has it."""

from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPen, QPolygonF
from PySide6.QtTest import QTest

from qovr_app.style.canvas import painting

REST_MILLISECONDS = 300
"""Longer than the view takes from its last change to its finer grid."""

_ARROW = [(0, 0), (0, 17), (4, 13.5), (6.5, 19.5), (9, 18.5), (6.5, 12.5), (11.5, 12.5)]


def picture_of(window, at=None, rest=REST_MILLISECONDS):
    """Return a window as it stands on the screen, with what lies over it, and an arrow at a global place."""
    QTest.qWait(rest)
    frame = window.frameGeometry()
    picture = window.screen().grabWindow(0, frame.x(), frame.y(), frame.width(), frame.height())
    if at is not None:
        with painting(picture) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.translate(QPointF(at) - QPointF(frame.topLeft()))
            painter.setPen(QPen(QColor("white"), 1.2))
            painter.setBrush(QColor("black"))
            painter.drawPolygon(QPolygonF([QPointF(x, y) for x, y in _ARROW]))
    return picture
