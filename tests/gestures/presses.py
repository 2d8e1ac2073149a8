"""What a press takes hold of, and what a click does."""

import numpy as np
from PySide6.QtCore import QPointF, Qt
from PySide6.QtWidgets import QApplication, QMenu

from qovr_app.view3d.scene.probing import parameters_under
from support.hand import RIGHT

from .gesture import Table

TABLE = Table()
_SHIFT, _CONTROL = Qt.Key.Key_Shift, Qt.Key.Key_Control


@TABLE("left drag on a point selects it alone and moves it along z, as one undo")
def _(hand):
    hand.click(hand.place(0, 2))
    before, start = hand.net, hand.place(4, 2)
    hand.press(start)
    hand.move_by(25, -48)
    hand.show()
    assert hand.selected == {(4, 2)}
    assert hand.editor.field("control_points.P_4_2.z").text() == repr(float(hand.net[4, 2, 2]))
    seen = hand.place(4, 2) - start
    assert abs(seen.x()) <= 1
    assert abs(seen.y() + 48) <= 1
    hand.release()
    assert np.argwhere(hand.net != before).tolist() == [[4, 2, 2]]
    assert hand.editor.action("undo").text() == "&Undo Move P 4,2"
    hand.editor.trigger("undo")
    assert np.array_equal(hand.net, before)


@TABLE("left drag on one of several selected points moves them all alike")
def _(hand):
    for index in ((0, 1), (0, 2), (0, 3)):
        hand.hold(_SHIFT)
        hand.click(hand.place(*index))
        hand.let_go(_SHIFT)
    before = hand.net
    hand.press(hand.place(0, 2))
    hand.move_by(0, -40)
    hand.show()
    hand.release()
    moved = hand.net - before
    assert hand.selected == {(0, 1), (0, 2), (0, 3)}
    assert np.argwhere(moved).tolist() == [[0, 1, 2], [0, 2, 2], [0, 3, 2]]
    np.testing.assert_allclose(moved[0, 1:4, 2], moved[0, 2, 2], atol=1e-12)
    assert hand.steps == ["Move 3 points"]


@TABLE("left drag on nothing orbits and keeps the selection")
def _(hand):
    hand.click(hand.place(0, 2))
    camera = hand.camera
    hand.press(hand.beside)
    hand.move_by(60, 25)
    hand.show()
    hand.release()
    assert hand.camera.azimuth < camera.azimuth
    assert hand.camera.elevation > camera.elevation
    assert hand.selected == {(0, 2)}
    assert hand.steps == []


@TABLE("left drag on the surface orbits about what is under the mouse")
def _(hand):
    at, picture, size = hand.on_surface(), hand.view.picture(), hand.view.viewports[0].logical_size
    u, v = parameters_under(picture.scene, hand.camera, size, at.x(), at.y())
    taken = picture.scene.patch.points([u], [v])[0, 0]
    camera = hand.camera
    hand.press(at)
    hand.move_by(70, -30)
    hand.show()
    hand.release()
    assert hand.camera.azimuth != camera.azimuth
    np.testing.assert_allclose(hand.camera.project(taken, size)[:2], [at.x(), at.y()], atol=1e-6)
    assert np.array_equal(hand.net, hand.state.history.first.control_points)


@TABLE("left click on a point selects it and edits nothing, even where the mouse trembles")
def _(hand):
    hand.press(hand.place(0, 3))
    hand.move_by(1, 1)
    hand.release()
    hand.show()
    assert hand.selected == {(0, 3)}
    assert hand.steps == []
    assert hand.editor.message().startswith("P 0,3")
    assert hand.editor.field("control_points.P_0_3.z").is_marked


@TABLE("left click on the surface clears the selection")
def _(hand):
    hand.click(hand.place(0, 2))
    hand.click(hand.on_surface())
    hand.show()
    assert hand.selected == set()


@TABLE("left click on nothing clears the selection")
def _(hand):
    hand.click(hand.place(0, 2))
    hand.click(hand.beside)
    hand.show()
    assert hand.selected == set()


@TABLE("double click on a point opens its fields")
def _(hand):
    hand.double_click(hand.place(4, 2))
    hand.show()
    field = QApplication.focusWidget()
    assert field.objectName() == "control_points.P_4_2.z"
    assert field.selectedText() == field.text()
    hand.type("+0.1")
    hand.tap(Qt.Key.Key_Return)
    assert hand.net[4, 2, 2] == 0.6


@TABLE("double click on a line of the net selects its row or column")
def _(hand):
    hand.double_click((hand.place(0, 1) + hand.place(0, 2)) / 2)
    hand.show()
    assert hand.selected == {(0, j) for j in range(5)}


@TABLE("Shift at the press adds a point and never drags")
def _(hand):
    hand.click(hand.place(0, 1))
    hand.hold(_SHIFT)
    hand.press(hand.place(0, 3))
    hand.move_by(0, -40)
    hand.show()
    hand.release()
    hand.click(hand.place(0, 3))
    hand.let_go(_SHIFT)
    assert hand.selected == {(0, 1), (0, 3)}
    assert hand.steps == []


@TABLE("Shift or Ctrl + click beside every point keeps the selection")
def _(hand):
    hand.select((0, 1), (0, 3))
    for key in (_SHIFT, _CONTROL):
        hand.hold(key)
        for at in (hand.beside, hand.on_surface()):
            hand.click(at)
        hand.show()
        hand.let_go(key)
        assert hand.selected == {(0, 1), (0, 3)}


@TABLE("Ctrl at the press toggles a point and never drags")
def _(hand):
    hand.click(hand.place(0, 1))
    hand.hold(_CONTROL)
    hand.press(hand.place(0, 3))
    hand.move_by(0, -40)
    hand.release()
    assert hand.selected == {(0, 1), (0, 3)}
    hand.click(hand.place(0, 1))
    hand.let_go(_CONTROL)
    hand.show()
    assert hand.selected == {(0, 3)}
    assert hand.steps == []


@TABLE("the gizmo is picked before a point that lies under it")
def _(hand):
    hand.editor.trigger("xray")
    hand.editor.trigger("camera_top")
    hand.rest()
    hand.click(hand.place(0, 1))
    arrow = hand.arrow(0)
    below = hand.place(0, 1) + QPointF(0.7 * (arrow.x() - hand.place(0, 1).x()), 0)
    x = (below.x() - hand.place(0, 1).x()) / (hand.place(0, 2).x() - hand.place(0, 1).x())
    hand.editor.type_into("control_points.P_0_2.x", repr(round(1 + x, 4)))
    hand.editor.type_into("control_points.P_0_2.z", "0.6")
    hand.click(hand.beside)
    hand.click(hand.place(0, 1))
    before = hand.net
    hand.press(hand.place(0, 2))
    hand.move_by(20, 0)
    hand.show()
    hand.release()
    assert np.argwhere(hand.net != before).tolist() == [[0, 1, 0]]


@TABLE("a point behind the surface is picked only with X-ray")
def _(hand):
    hand.editor.trigger("xray")
    hand.click(hand.place(1, 1))
    hand.show()
    assert hand.selected == {(1, 1)}
    hand.click(hand.beside)
    hand.editor.trigger("xray")
    hand.click(hand.place(1, 1))
    assert hand.selected == set()


@TABLE("click again in the same place picks the next of the points that lie there")
def _(hand):
    hand.stack()
    picked = []
    for _ in range(4):
        hand.click(hand.place(0, 1))
        picked.append(hand.picked_last)
        assert len(hand.selected) == 1
    hand.show()
    assert set(picked[:3]) == {(0, 1), (0, 2), (0, 3)}
    assert picked[3] == picked[0]
    hand.drag(hand.place(0, 1), 0, -30)
    assert hand.steps[-1] == "Move P {},{}".format(*picked[3])


@TABLE("points that lie in one place are listed in the menu there")
def _(hand):
    hand.stack()
    hand.click(hand.place(0, 1), RIGHT)
    menu = hand.editor.find("context.point", QMenu)
    hand.show()
    names = [action.text() for action in menu.actions()[:3]]
    assert sorted(names) == ["P 0,1", "P 0,2", "P 0,3"]
    menu.actions()[names.index("P 0,3")].trigger()
    menu.close()
    assert hand.picked_last == (0, 3)


@TABLE("tool Select: a drag draws a rectangle that selects, wherever it begins")
def _(hand):
    hand.editor.trigger("tool_select")
    camera = hand.camera
    corners = hand.around((0, 0), (0, 1), (0, 2))
    hand.press(corners[0])
    hand.move(corners[1])
    hand.show()
    hand.release()
    assert hand.selected == {(0, 0), (0, 1), (0, 2)}
    assert hand.camera == camera
    hand.drag(hand.place(0, 3) - QPointF(3, 3), 30, 30)
    assert hand.selected == {(0, 3)}
    assert hand.steps == []


@TABLE("Ctrl + left drag beside the points draws a rectangle with any tool")
def _(hand):
    corners = hand.around((0, 0), (0, 1), (0, 2))
    hand.hold(_CONTROL)
    hand.press(corners[0])
    hand.move(corners[1])
    hand.show()
    hand.release()
    hand.let_go(_CONTROL)
    assert hand.selected == {(0, 0), (0, 1), (0, 2)}
