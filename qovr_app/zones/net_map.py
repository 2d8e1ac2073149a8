"""The windows of the net as a small map: a click or an arrow key brings one into focus."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QLineF, QPointF, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QHelpEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QToolTip, QWidget

from qovr_app.state.editor_state import EditorState
from qovr_app.state.focus import beside
from qovr_app.state.looking_intents import WindowFocused
from qovr_app.state.names import window_words
from qovr_app.store import Store
from qovr_app.style.canvas import painting
from qovr_app.style.fonts import small_number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.style.theme import Rgb
from qovr_app.widgets.parts import named
from qovr_app.zones.net_facts import joint_before, joints_text, net_text, points_text, structure_of
from qovr_core import Document
from qovr_core.document import Window
from qovr_core.edits import knots_of
from qovr_core.geometry.knots import Direction
from qovr_core.joints import Joint

_MARGIN = 6.0
_CELL = QSize(72, 22)
"""The largest a window is drawn."""

_LEAST_CELL = 2
"""Pixels of height that a window has where there are very many."""

_HEIGHT = 110
"""As high as the map of a net grows before its windows get smaller."""

_LINED = 5.0
"""Pixels from which on windows are parted by lines where their joint is smooth."""

_SHARP, _THIN, _FOCUS = 2.5, 1.0, 2.0
_LEAST_FOCUS = 5.0
"""Pixels across the window in focus, however small windows are."""

_STEPS: dict[int, Window] = {
    Qt.Key.Key_Left: (0, -1),
    Qt.Key.Key_Right: (0, 1),
    Qt.Key.Key_Down: (-1, 0),
    Qt.Key.Key_Up: (1, 0),
}


class NetMap(QWidget):
    """Shows the windows as the net lies, rows upward; which is in focus, which joints are sharp, where it is closed."""

    def __init__(self, store: Store, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._store = store
        named(self, "net.map", "Map of the windows of the net")
        self.setFont(small_number_font(self.font()))
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setSizePolicy(QSizePolicy.Policy.Preferred, QSizePolicy.Policy.Fixed)
        self.setVisible(False)

    @property
    def _document(self) -> Document:
        return self._store.shown.document

    def show_state(self, before: EditorState | None, after: EditorState) -> None:
        """Show the windows of a net."""
        document = after.document
        if before is not None and (structure_of(before.document), before.window) == (
            structure_of(document),
            after.window,
        ):
            return
        if before is None or before.document.windows != document.windows:
            self.updateGeometry()
        said = (
            window_words(after.window, document.windows),
            points_text(after.window),
            joints_text(document, after.window),
        )
        self.setAccessibleDescription(", ".join(said))
        self.update()

    def sizeHint(self) -> QSize:
        m, n = self._document.windows
        height = max(min(m * _CELL.height(), _HEIGHT), m * _LEAST_CELL)
        return QSize(n * _CELL.width(), height) + QSize(1, 1) * round(2 * _MARGIN)

    def minimumSizeHint(self) -> QSize:
        return QSize(0, self.sizeHint().height())

    def cell(self, window: Window) -> QRectF:
        """Return where a window is drawn."""
        (a, b), (m, n), area = window, self._document.windows, self._area()
        width, height = area.width() / n, area.height() / m
        return QRectF(area.left() + b * width, area.bottom() - (a + 1) * height, width, height)

    def _area(self) -> QRectF:
        room = QRectF(self.rect()).adjusted(_MARGIN, _MARGIN, -_MARGIN, -_MARGIN)
        room.setWidth(min(room.width(), self._document.windows[1] * _CELL.width()))
        return room

    def _window_at(self, at: QPointF) -> Window | None:
        area, (m, n) = self._area(), self._document.windows
        if not area.adjusted(-1, -1, 1, 1).contains(at):
            return None
        a = int((area.bottom() - at.y()) / area.height() * m)
        b = int((at.x() - area.left()) / area.width() * n)
        return min(max(a, 0), m - 1), min(max(b, 0), n - 1)

    # Mouse and keys

    def mousePressEvent(self, event: QMouseEvent) -> None:
        if event.button() == Qt.MouseButton.LeftButton:
            self._focus_at(event.position())

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        if event.buttons() & Qt.MouseButton.LeftButton:
            self._focus_at(event.position())

    def _focus_at(self, at: QPointF) -> None:
        window = self._window_at(at)
        if window is not None and window != self._store.state.window:
            self._store.dispatch(WindowFocused(window))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        step = _STEPS.get(event.key())
        if step is None or event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
            super().keyPressEvent(event)
        elif (window := beside(self._store.state, step)) is not None:
            self._store.dispatch(WindowFocused(window))

    def event(self, event: QEvent) -> bool:
        if event.type() == QEvent.Type.ToolTip and isinstance(event, QHelpEvent):
            window = self._window_at(QPointF(event.pos()))
            QToolTip.showText(event.globalPos(), self._tip(window), self)
            return True
        if event.type() in (QEvent.Type.FocusIn, QEvent.Type.FocusOut):
            self.update()
        return super().event(event)

    def _tip(self, window: Window | None) -> str:
        document = self._document
        if window is None:
            return net_text(document)
        a, b = window
        return f"Window {a},{b}: {points_text(window)}\n{joints_text(document, window)}"

    # Looks

    def paintEvent(self, _event: QPaintEvent) -> None:
        theme, area = theme_in_force(), self._area()
        with painting(self) as painter:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.fillRect(area, QColor(*theme.cell))
            for direction in Direction:
                self._paint_joints(painter, direction, are_sharp=False)
            self._paint_focus(painter)
            for direction in Direction:
                self._paint_joints(painter, direction, are_sharp=True)
            self._paint_names(painter)
            if self.hasFocus():
                painter.setBrush(Qt.BrushStyle.NoBrush)
                painter.setPen(QPen(QColor(*theme.accent), _THIN))
                painter.drawRoundedRect(area.adjusted(-4, -4, 4, 4), 3, 3)

    def _paint_joints(self, painter: QPainter, direction: Direction, *, are_sharp: bool) -> None:
        """Draw the sharp joints, or all others and the ends of the net, dashed where it is closed."""
        theme, document, first = theme_in_force(), self._document, self.cell((0, 0))
        count = knots_of(document, direction).windows
        size = min(first.width(), first.height())
        for k in range(count + 1):
            joint = joint_before(document, direction, k % count)
            is_end = k in (0, count)
            is_sharp = joint is Joint.SHARP
            if is_sharp is not are_sharp or (not is_end and not is_sharp and size < _LINED):
                continue
            colour: Rgb = theme.sharp_joint if is_sharp else theme.axis if is_end else theme.edge
            pen = QPen(QColor(*colour), _SHARP if is_sharp and size >= _LINED else _THIN)
            if is_end and document.is_closed(direction):
                pen.setStyle(Qt.PenStyle.DashLine)
            painter.setPen(pen)
            painter.drawLine(self._line(direction, k))

    def _line(self, direction: Direction, k: int) -> QLineF:
        """Return where the k-th of the lines is drawn at which windows begin and end."""
        area, first = self._area(), self.cell((0, 0))
        if direction is Direction.ROWS:
            x = area.left() + k * first.width()
            return QLineF(x, area.top(), x, area.bottom())
        y = area.bottom() - k * first.height()
        return QLineF(area.left(), y, area.right(), y)

    def _paint_focus(self, painter: QPainter) -> None:
        theme, cell = theme_in_force(), self.cell(self._store.shown.window)
        more = [max(_LEAST_FOCUS - side, 0.0) / 2 for side in (cell.width(), cell.height())]
        shown, fill = cell.adjusted(-more[0], -more[1], *more), QColor(*theme.selected)
        fill.setAlpha(48)
        painter.setBrush(fill)
        painter.setPen(QPen(QColor(*theme.selected), _FOCUS))
        painter.drawRect(shown)

    def _paint_names(self, painter: QPainter) -> None:
        """Write which window is which, where there is room for it."""
        m, n = self._document.windows
        metrics, cell = self.fontMetrics(), self.cell((0, 0))
        if metrics.horizontalAdvance(f" {m - 1},{n - 1} ") > cell.width() or metrics.height() > cell.height():
            return
        painter.setPen(QColor(*theme_in_force().quiet_ink))
        for a in range(m):
            for b in range(n):
                painter.drawText(self.cell((a, b)), Qt.AlignmentFlag.AlignCenter, f"{a},{b}")
