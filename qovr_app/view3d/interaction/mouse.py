"""The mouse in a viewport: one press, what it took, and what becomes of it until the button's release."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from qovr_app.state.looking_intents import Picking
from qovr_app.state.tools import Way
from qovr_app.view3d.interaction.camera_input import moved_by_mouse, pivot_under
from qovr_app.view3d.interaction.dragging import DRAG_START, HeldPoints, PointDragger
from qovr_app.view3d.interaction.mouse_schemes import motion_of
from qovr_app.view3d.interaction.picking import gizmo_under, menu_wish, net_line_under, points_under, points_within
from qovr_app.view3d.interaction.press import Doing, Press
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grip import ALONG_NORMAL, IN_VIEW, Freedom, along
from qovr_app.view3d.scene.hand import Band, MenuPlace
from qovr_app.view3d.scene.picture import Picture
from qovr_core.document import NetIndex

_LEFT, _RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
_SHIFT, _CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier

_FREEDOMS = {Way.Z: along(2), Way.VIEW: IN_VIEW, Way.NORMAL: ALONG_NORMAL}
"""What may change of a point that is itself dragged."""


class Mouse(QObject):
    """Follows the buttons of the mouse in one viewport.

    Signals
    -------
    camera_requested : a Camera
    picked : control points (i, j), the last one picked last, and what they do to the selection
    opened : the control point whose fields are wanted
    menu_asked : a MenuWish
    changed : something else is to be drawn
    """

    camera_requested = Signal(object)
    picked = Signal(object, object)
    opened = Signal(object)
    menu_asked = Signal(object)
    changed = Signal()

    def __init__(self, dragger: PointDragger) -> None:
        super().__init__(dragger)
        self._dragger = dragger
        self._press: Press | None = None
        self._last = QPointF()
        self._clicked: QPointF | None = None

    @property
    def band(self) -> Band | None:
        """The rectangle that is drawn; None where none is."""
        press = self._press
        if press is None or press.doing is not Doing.SELECT or not press.has_moved:
            return None
        return press.at.x(), press.at.y(), self._last.x(), self._last.y()

    def press(self, event: QMouseEvent, picture: Picture, size: Size) -> None:
        """Take what is under the mouse, or give back what is held."""
        if self._press is not None:
            if event.button() == _RIGHT:
                self.put_back()
            return
        at = self._last = event.position()
        if event.button() == _LEFT:
            self._press = self._take(event, picture, size)
        else:
            motion = motion_of(picture.settings.mouse, event.button(), event.modifiers())
            self._press = Press(event.button(), at, Doing.LOOK, motion, pivot_under(picture, size, at))

    def double_click(self, event: QMouseEvent, picture: Picture, size: Size) -> None:
        """Open the fields of a control point, or select a row or column; elsewhere it is another press."""
        x, y = event.position().x(), event.position().y()
        if event.button() != _LEFT or self._press is not None or gizmo_under(picture, size, x, y):
            self.press(event, picture, size)
            return
        points, line = points_under(picture, size, x, y), net_line_under(picture, size, x, y)
        if points:
            self.opened.emit(_chosen(points, picture))
        elif line:
            self.picked.emit(tuple(line), Picking.REPLACE)
        else:
            self.press(event, picture, size)
            return
        self._press = Press(_LEFT, event.position(), Doing.WAIT)

    def move(self, event: QMouseEvent, modifiers: Qt.KeyboardModifier, picture: Picture, size: Size) -> None:
        """Go on with what the press began, with these modifiers held."""
        press, at = self._press, event.position()
        moved, self._last = at - self._last, at
        if press is None:
            return
        if not event.buttons() & press.button:  # the release went elsewhere
            self.put_back()
            self._press = None
            return
        press.has_moved = press.has_moved or (at - press.at).manhattanLength() >= DRAG_START
        if press.doing is Doing.MOVE:
            self._drag(at, modifiers, picture)
        elif press.doing is Doing.SELECT:
            self.changed.emit()
        elif press.doing is Doing.LOOK and press.motion is not None and press.has_moved:
            self.camera_requested.emit(moved_by_mouse(press.motion, moved, picture.camera, size, press.pivot))

    def follow_modifiers(self, modifiers: Qt.KeyboardModifier, picture: Picture) -> None:
        """Go on with other modifiers where the mouse is."""
        if self._dragger.is_dragging:
            self._drag(self._last, modifiers, picture)

    def release(self, event: QMouseEvent, picture: Picture, size: Size) -> None:
        """End what the press began."""
        press = self._press
        if press is None or event.button() != press.button:
            return
        self._press = None
        if press.doing is Doing.MOVE and self._dragger.is_dragging:
            self._dragger.finish()
        elif press.doing is Doing.MOVE:
            self._dragger.finish()
            self._click_on_points(press, picture, size)
        elif press.doing is Doing.SELECT and press.has_moved:
            corner, other = ((at.x(), at.y()) for at in (press.at, event.position()))
            self.picked.emit(tuple(points_within(picture, size, corner, other)), press.picking)
        elif press.doing in (Doing.SELECT, Doing.LOOK) and not press.has_moved:
            self._click(press, picture, size)
        self._clicked = None if press.has_moved else press.at
        self.changed.emit()

    def put_back(self) -> None:
        """End what the press began as if it had never been, and wait for the release."""
        self._dragger.cancel()
        if self._press is not None:
            self._press.doing = Doing.WAIT
        self.changed.emit()

    def drop(self) -> None:
        """Let go of what is held, without a word, and wait for the release."""
        self._dragger.drop()
        if self._press is not None:
            self._press.doing = Doing.WAIT

    def commit(self) -> None:
        """End a drag where the points are, and wait for the release."""
        self._dragger.finish()
        if self._press is not None:
            self._press.doing = Doing.WAIT

    @property
    def is_held(self) -> bool:
        """Whether a button is down that was pressed here."""
        return self._press is not None

    def _take(self, event: QMouseEvent, picture: Picture, size: Size) -> Press:
        """Return what a press of the left button begins: gizmo, point, rectangle or camera, in this order."""
        at, modifiers = event.position(), event.modifiers()
        freedom = gizmo_under(picture, size, at.x(), at.y())
        if freedom is not None and picture.last_selected is not None:
            self._hold(picture, size, picture.last_selected, freedom, at)
            return Press(_LEFT, at, Doing.MOVE)
        points = points_under(picture, size, at.x(), at.y())
        if picture.tools.selects or (modifiers & _CONTROL and not points):
            picking = _picking(modifiers) if picture.tools.selects or modifiers & _SHIFT else Picking.REPLACE
            return Press(_LEFT, at, Doing.SELECT, point=points[0] if points else None, picking=picking)
        if points:
            index = _chosen(points, picture)
            if modifiers & (_SHIFT | _CONTROL):
                self.picked.emit((index,), _picking(modifiers))
                return Press(_LEFT, at, Doing.WAIT)
            if index not in picture.selected:
                self.picked.emit((index,), Picking.REPLACE)
            self._hold(picture, size, index, None, at)
            return Press(_LEFT, at, Doing.MOVE, point=index if index in picture.selected else None)
        motion = motion_of(picture.settings.mouse, _LEFT, modifiers)
        return Press(_LEFT, at, Doing.LOOK, motion, pivot_under(picture, size, at))

    def _hold(self, picture: Picture, size: Size, index: NetIndex, freedom: Freedom | None, at: QPointF) -> None:
        """Hold a point and, where it is selected, all that are selected with it."""
        others = picture.selected - {index} if index in picture.selected else frozenset()
        way = _FREEDOMS[picture.tools.way] if freedom is None else freedom
        held = HeldPoints(picture, size, (index, *sorted(others)), way, is_difference=freedom is not None)
        self._dragger.press(held, at)

    def _drag(self, at: QPointF, modifiers: Qt.KeyboardModifier, picture: Picture) -> None:
        snaps = picture.tools.snaps is not bool(modifiers & _CONTROL)
        self._dragger.move_to(at, is_fine=bool(modifiers & _SHIFT), snaps=snaps)

    def _click_on_points(self, press: Press, picture: Picture, size: Size) -> None:
        """Select the point that was clicked alone; of several in one place the next, where it was clicked before."""
        if press.point is None:
            return
        points = points_under(picture, size, press.at.x(), press.at.y())
        is_again = self._clicked is not None and (press.at - self._clicked).manhattanLength() < DRAG_START
        if is_again and press.point in points:
            wanted = points[(points.index(press.point) + 1) % len(points)]
        else:
            wanted = press.point
        if picture.selected != {wanted}:
            self.picked.emit((wanted,), Picking.REPLACE)

    def _click(self, press: Press, picture: Picture, size: Size) -> None:
        """Ask for a menu, select a point with the tool for it, or clear the selection."""
        if press.button == _RIGHT:
            wish = menu_wish(picture, size, press.at.x(), press.at.y())
            if wish.place is MenuPlace.POINT and not picture.selected.intersection(wish.points):
                self.picked.emit(wish.points[:1], Picking.REPLACE)
            self.menu_asked.emit(wish)
        elif press.point is not None:
            self.picked.emit((press.point,), press.picking)
        elif press.button == _LEFT and picture.selected:
            self.picked.emit((), Picking.REPLACE)


def _picking(modifiers: Qt.KeyboardModifier) -> Picking:
    """Return what points do to the selection that are picked with modifiers held."""
    if modifiers & _SHIFT:
        return Picking.ADD
    return Picking.TOGGLE if modifiers & _CONTROL else Picking.REPLACE


def _chosen(points: list[NetIndex], picture: Picture) -> NetIndex:
    """Return the point of several in one place that a press means: one that is selected, or else the first."""
    if picture.last_selected in points:
        return picture.last_selected
    return next((index for index in points if index in picture.selected), points[0])
