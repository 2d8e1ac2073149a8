"""How the cells of the claims are painted: texts below each other, each broken into lines so that none is cut."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from enum import Enum, auto

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QColor, QFont, QFontMetrics, QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem, QTableWidget

from qovr_app.style.fonts import small_number_font
from qovr_app.style.palette import theme_in_force
from qovr_app.style.spacing import SPACE
from qovr_app.style.theme import Rgb

Index = QModelIndex | QPersistentModelIndex

_FLAGS = Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignTop | Qt.TextFlag.TextWordWrap
_OLD_OPACITY = 0.4
_ENDLESS = 10_000

BLOCKS, IS_OLD = (Qt.ItemDataRole.UserRole + k for k in range(2))
"""A cell's texts from top to bottom, and whether they are of the document before."""


class Style(Enum):
    """What a text of a cell is; each is read without colour, too."""

    PLAIN = auto()
    TRUE = auto()
    TRUE_IF = auto()
    FALSE = auto()
    SMALL = auto()
    QUIET = auto()

    @property
    def ink(self) -> Rgb:
        """Its colour in the theme in force."""
        theme = theme_in_force()
        return {Style.TRUE_IF: theme.warn, Style.FALSE: theme.bad, Style.QUIET: theme.quiet_ink}.get(self, theme.ink)


Block = tuple[str, Style]


class BlockDelegate(QStyledItemDelegate):
    """Paints the blocks of a cell, and says how high they are in its column's width."""

    def __init__(self, table: QTableWidget) -> None:
        super().__init__(table)
        self._table = table
        strong, small = QFont(table.font()), small_number_font(table.font())
        strong.setBold(True)
        self._fonts = {
            **dict.fromkeys((Style.TRUE, Style.TRUE_IF, Style.FALSE), strong),
            **dict.fromkeys((Style.SMALL, Style.QUIET), small),
            Style.PLAIN: table.font(),
        }

    def sizeHint(self, _option: QStyleOptionViewItem, index: Index) -> QSize:
        width = self._table.columnWidth(index.column())
        area = self._area(QRect(0, 0, width, _ENDLESS))
        *_, (_, _, last) = [(None, None, area.adjusted(0, 0, 0, -area.height())), *self._placed(area, index)]
        return QSize(width, last.bottom() + 1 + SPACE)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Index) -> None:
        painter.save()
        if option.state & QStyle.StateFlag.State_Selected:
            painter.fillRect(option.rect, QColor(*theme_in_force().accent_cell))
            if option.widget.hasFocus():
                painter.setPen(QColor(*theme_in_force().accent))
                painter.drawRect(option.rect.adjusted(0, 0, -1, -1))
        if index.data(IS_OLD):
            painter.setOpacity(_OLD_OPACITY)
        for text, style, place in self._placed(self._area(option.rect), index):
            painter.setFont(self._fonts[style])
            painter.setPen(QColor(*style.ink))
            painter.drawText(place, _FLAGS, text)
        painter.restore()

    def _area(self, cell: QRect) -> QRect:
        return cell.adjusted(2 * SPACE, SPACE, -SPACE, -SPACE)

    def _placed(self, area: QRect, index: Index) -> Iterator[tuple[str, Style, QRect]]:
        """Yield each text of a cell with its place in an area."""
        blocks: Sequence[Block] = index.data(BLOCKS) or ()
        top = area.top()
        for text, style in blocks:
            room = QRect(area.left(), top, area.width(), _ENDLESS)
            place = QFontMetrics(self._fonts[style]).boundingRect(room, _FLAGS, text)
            place.setWidth(area.width())
            yield text, style, place
            top = place.bottom() + 1
