"""What is wrong with a field, said at the field."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, QRect, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter, QPainterPath, QPaintEvent
from PySide6.QtWidgets import QApplication, QLabel, QWidget

from qovr_app.style.palette import theme_in_force
from qovr_app.style.symbols import sentence_html

_WIDEST = 280
_TIP = 6
"""Height of the tip that points at the field, and half its width."""

_RADIUS = 4.0
_FROM_EDGE = 4
_LEAST_ROWS, _LEAST_WIDTH = 5, 200
"""A part of the window that is lower than so many fields, or narrower, as a bar, has no room for a bubble."""


class Bubble(QLabel):
    """Lies over a part of the window, beside the field that it speaks of; one for all fields of that part."""

    def __init__(self, host: QWidget) -> None:
        super().__init__(host)
        self._host = host
        self.setObjectName("field.error")
        self.setTextFormat(Qt.TextFormat.RichText)
        self.setWordWrap(True)
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self.field: QWidget | None = None
        self._is_below = True
        self.setVisible(False)
        host.installEventFilter(self)
        if isinstance(application := QApplication.instance(), QApplication):
            application.focusChanged.connect(self._on_focus_changed)

    def speak(self, field: QWidget, text: str) -> None:
        """Say what is wrong with a field."""
        self.field = field
        is_symbol = text[1:2] == "_"  # r_ip begins no sentence as R_ip
        self.setText(sentence_html(f"{text if is_symbol else text[:1].upper() + text[1:]}."))
        self._place()
        self.show()
        self.raise_()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.Resize, QEvent.Type.LayoutRequest) and self.isVisible():
            self._place()
        return False

    def _on_focus_changed(self) -> None:
        if self.isVisible():
            self._place()

    def _place(self) -> None:
        """Lie under the field, or over it where there is more room, and not over what has the keyboard."""
        host, field = self._host, self.field
        if field is None:
            return
        width = min(_WIDEST, host.width() - 2 * _FROM_EDGE)
        self.setContentsMargins(8, 4, 8, 4)
        size = QSize(width, self.heightForWidth(width) + _TIP)
        at = QRect(field.mapTo(host, QPoint()), field.size())
        left = min(max(at.right() - width, _FROM_EDGE), host.width() - width - _FROM_EDGE)
        below, above = (QRect(QPoint(left, y), size) for y in (at.bottom() + 1, at.top() - size.height()))
        fits = [rect for rect in (below, above) if host.rect().contains(rect)] or [below]
        free = [rect for rect in fits if not rect.intersects(self._keyboard())]
        rect = (free or fits)[0]
        self._is_below = rect == below
        self.setContentsMargins(8, 4 + _TIP * self._is_below, 8, 4 + _TIP * (not self._is_below))
        self.setGeometry(rect)

    def _keyboard(self) -> QRect:
        """Return where the widget that has the keyboard lies."""
        widget, host = QApplication.focusWidget(), self._host
        if widget is None or not host.isAncestorOf(widget):
            return QRect()
        return QRect(widget.mapTo(host, QPoint()), widget.size())

    def paintEvent(self, event: QPaintEvent) -> None:
        colours = theme_in_force()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(*colours.bad))
        painter.setBrush(QColor(*colours.bad_cell))
        painter.drawPath(self._outline())
        painter.end()
        super().paintEvent(event)

    def _outline(self) -> QPainterPath:
        body = QRectF(self.rect()).adjusted(0.5, 0.5, -0.5, -0.5)
        body = body.adjusted(0, _TIP, 0, 0) if self._is_below else body.adjusted(0, 0, 0, -_TIP)
        path = QPainterPath()
        path.addRoundedRect(body, _RADIUS, _RADIUS)
        if self.field is None:
            return path
        middle = self.mapFrom(self._host, self.field.mapTo(self._host, self.field.rect().center())).x()
        x = min(max(float(middle), body.left() + 2 * _TIP), body.right() - 2 * _TIP)
        edge, end = (body.top(), body.top() - _TIP) if self._is_below else (body.bottom(), body.bottom() + _TIP)
        tip = QPainterPath(QPointF(x - _TIP, edge))
        tip.lineTo(x, end)
        tip.lineTo(x + _TIP, edge)
        tip.closeSubpath()
        return path.united(tip)


def say_at(field: QWidget, text: str) -> None:
    """Say at a field what is wrong with it; empty where nothing is, or is any longer."""
    host = _host_of(field)
    bubble = host.findChild(Bubble, options=Qt.FindChildOption.FindDirectChildrenOnly)
    if text:
        (bubble or Bubble(host)).speak(field, text)
    elif bubble is not None and bubble.field is field:
        bubble.field = None
        bubble.hide()


def _host_of(field: QWidget) -> QWidget:
    """Return the smallest part of the window around a field that has room for a bubble."""
    host = field.parentWidget()
    while host is not None and not host.isWindow():
        if host.height() >= _LEAST_ROWS * field.height() and host.width() >= _LEAST_WIDTH:
            return host
        host = host.parentWidget()
    return host or field
