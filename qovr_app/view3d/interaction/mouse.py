"""The mouse in a viewport: one press, what it took, and what becomes of it until the button's release."""

from __future__ import annotations

from PySide6.QtCore import QObject, QPoint, QPointF, Qt, Signal
from PySide6.QtGui import QMouseEvent

from qovr_app.state.looking_intents import FieldFocused, Picking, WindowFocused
from qovr_app.view3d.interaction.camera_input import moved_by_mouse, pivot_under
from qovr_app.view3d.interaction.curve_picking import curve_under, points_of
from qovr_app.view3d.interaction.dragging import FREEDOMS, HeldPoints, PointDragger
from qovr_app.view3d.interaction.knot_dragging import KnotDragger
from qovr_app.view3d.interaction.mouse_schemes import motion_of
from qovr_app.view3d.interaction.picking import (
    chosen_of,
    gizmo_under,
    handle_under,
    menu_wish,
    points_under,
    points_within,
    window_under,
)
from qovr_app.view3d.interaction.press import Doing, Press, picking_of, press_to_look
from qovr_app.view3d.scene.camera import Size
from qovr_app.view3d.scene.grip import Freedom
from qovr_app.view3d.scene.hand import Band, MenuPlace
from qovr_app.view3d.scene.picture import Picture
from qovr_app.widgets.dragger import DRAG_START, Dragger
from qovr_core.document import NetIndex

_LEFT, _RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
_SHIFT, _CONTROL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier


class Mouse(QObject):
    """Follows the buttons of the mouse in one viewport.

    Signals
    -------
    camera_requested : a Camera
    picked : control points (i, j), the last one picked last, and what they do to the selection
    opened : the control point whose fields are wanted
    menu_asked : a MenuWish, and the place of the screen
    asked : the name of a view, or a Spot to measure from or to
    wanted : an intent
    changed : something else is to be drawn
    """

    camera_requested = Signal(object)
    picked = Signal(object, object)
    opened = Signal(object)
    menu_asked = Signal(object, QPoint)
    asked = Signal(object)
    wanted = Signal(object)
    changed = Signal()

    def __init__(self, points: PointDragger, knots: KnotDragger) -> None:
        super().__init__(points)
        self._points, self._knots = points, knots
        self._press: Press | None = None
        self._last = QPointF()
        self._clicked: QPointF | None = None

    @property
    def dragger(self) -> Dragger:
        """What follows the mouse with what is held; that of the points where nothing is."""
        return self._knots if self._knots.is_pressed else self._points

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
            self._press = press_to_look(at, picture, size) or self._take(event, picture, size)
        else:
            motion = motion_of(picture.settings.mouse, event.button(), event.modifiers())
            self._press = Press(event.button(), at, Doing.LOOK, motion, pivot_under(picture, size, at))

    def double_click(self, event: QMouseEvent, picture: Picture, size: Size) -> None:
        """Reset a knot, open a point's fields, select a row or column, turn to a window; else press again."""
        x, y = event.position().x(), event.position().y()
        is_mark = gizmo_under(picture, size, x, y) or press_to_look(event.position(), picture, size)
        if event.button() != _LEFT or self._press is not None or is_mark:
            self.press(event, picture, size)
            return
        handle, points = handle_under(picture, size, x, y), points_under(picture, size, x, y)
        curve = curve_under(picture, size, x, y)
        if handle is not None:
            self.wanted.emit(handle.knot.reset(in_view=True))
        elif points:
            self.opened.emit(chosen_of(points, picture))
        elif curve is not None:
            self.picked.emit(points_of(picture, curve), Picking.REPLACE)
            self.wanted.emit(FieldFocused(curve))
        elif (window := window_under(picture, size, x, y)) is not None:
            self.wanted.emit(WindowFocused(window))
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
            self._drag(at, modifiers)
        elif press.doing is Doing.SELECT:
            self.changed.emit()
        elif press.doing is Doing.LOOK and press.motion is not None and press.has_moved:
            self.camera_requested.emit(moved_by_mouse(press.motion, moved, picture.camera, size, press.pivot))

    def follow_modifiers(self, modifiers: Qt.KeyboardModifier) -> None:
        """Go on with other modifiers where the mouse is."""
        if self.dragger.is_dragging:
            self._drag(self._last, modifiers)

    def release(self, event: QMouseEvent, picture: Picture, size: Size) -> None:
        """End what the press began."""
        press = self._press
        if press is None or event.button() != press.button:
            return
        self._press = None
        if press.doing is Doing.MOVE and self.dragger.is_dragging:
            self.dragger.finish()
        elif press.doing is Doing.MOVE:
            self.dragger.finish()
            self._click_on_points(press, picture, size)
        elif press.doing is Doing.SELECT and press.has_moved:
            corner, other = ((at.x(), at.y()) for at in (press.at, event.position()))
            self.picked.emit(tuple(points_within(picture, size, corner, other)), press.picking)
        elif press.doing in (Doing.SELECT, Doing.LOOK) and not press.has_moved:
            self._click(press, picture, size, event)
        self._clicked = None if press.has_moved else press.at
        self.changed.emit()

    def put_back(self) -> None:
        """End what the press began as if it had never been, and wait for the release."""
        self.dragger.cancel()
        if self._press is not None:
            self._press.doing = Doing.WAIT
        self.changed.emit()

    def drop(self) -> None:
        """Let go of what is held, without a word, and wait for the release."""
        self.dragger.drop()
        if self._press is not None:
            self._press.doing = Doing.WAIT

    def commit(self) -> None:
        """End a drag where the points are, and wait for the release."""
        self.dragger.finish()
        if self._press is not None:
            self._press.doing = Doing.WAIT

    @property
    def is_held(self) -> bool:
        """Whether a button is down that was pressed here."""
        return self._press is not None

    def _take(self, event: QMouseEvent, picture: Picture, size: Size) -> Press:
        """Return what a press of the left button begins: gizmo, knot, point, rectangle or camera, in this order."""
        at, modifiers = event.position(), event.modifiers()
        freedom = gizmo_under(picture, size, at.x(), at.y())
        if freedom is not None and picture.last_selected is not None:
            self._hold(picture, size, picture.last_selected, freedom, at)
            return Press(_LEFT, at, Doing.MOVE)
        points = points_under(picture, size, at.x(), at.y())
        handle = self._knots.take(picture, size, at)
        if handle is not None:  # clicked again, it means the point behind it
            is_again = picture.curve is not None and handle.knot.place == picture.curve.place
            return Press(_LEFT, at, Doing.MOVE, point=chosen_of(points, picture) if points and is_again else None)
        if picture.tools.selects or (modifiers & _CONTROL and not points):
            picking = picking_of(modifiers) if picture.tools.selects or modifiers & _SHIFT else Picking.REPLACE
            return Press(_LEFT, at, Doing.SELECT, point=points[0] if points else None, picking=picking)
        if points:
            index = chosen_of(points, picture)
            if modifiers & (_SHIFT | _CONTROL):
                self.picked.emit((index,), picking_of(modifiers))
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
        way = FREEDOMS[picture.tools.way] if freedom is None else freedom
        held = HeldPoints(picture, size, (index, *sorted(others)), way, is_difference=freedom is not None)
        self._points.press(held, at)

    def _drag(self, at: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        self.dragger.move_to(at, is_fine=bool(modifiers & _SHIFT), has_control=bool(modifiers & _CONTROL))

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

    def _click(self, press: Press, picture: Picture, size: Size, event: QMouseEvent) -> None:
        """Ask for a menu, select a point with the tool for it, or clear what is selected, unless a key holds it."""
        if press.asks is not None:
            self.asked.emit(press.asks)
        elif press.button == _RIGHT:
            wish = menu_wish(picture, size, press.at.x(), press.at.y())
            if wish.place is MenuPlace.POINT and not picture.selected.intersection(wish.points):
                self.picked.emit(wish.points[:1], Picking.REPLACE)
            self.menu_asked.emit(wish, event.globalPosition().toPoint())
        elif press.point is not None:
            self.picked.emit((press.point,), press.picking)
        elif press.button == _LEFT and not event.modifiers() & (_SHIFT | _CONTROL):
            self._click_on_curve(press, picture, size)

    def _click_on_curve(self, press: Press, picture: Picture, size: Size) -> None:
        """Turn to the curve that was clicked; beside every curve, let go of what is selected."""
        curve = curve_under(picture, size, press.at.x(), press.at.y())
        if picture.selected or (picture.curve is not None and curve is None):
            self.picked.emit((), Picking.REPLACE)
        if curve is not None:
            self.wanted.emit(FieldFocused(curve))
