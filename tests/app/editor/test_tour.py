"""The tour: five steps done by hand or shown, left at any time, and nothing of it stays but by wish."""

from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QLabel, QWidget

from qovr_app.state.intents import SamplesChosen
from qovr_app.window.preferences import Preferences
from qovr_app.window.tour import offer_tour
from qovr_core.presets import preset
from support.editor import opened_windows, wait_until

FIG5 = preset("fig5").document


def step(editor):
    return editor.find("tour.text", QLabel).text()[:12]


def is_framed(editor, part):
    """Return whether the frame stands around a part of the window."""
    wait_until(lambda: editor.find("highlight").isVisible())
    frame, target = editor.find("highlight"), editor.find(part)
    seen = target.visibleRegion().boundingRect().translated(target.mapTo(editor.window, QPoint(0, 0)))
    wait_until(lambda: frame.geometry().contains(seen & editor.window.rect().adjusted(9, 9, -9, -9)))
    return frame.width() < seen.width() + 12


def test_every_step_waits_until_it_is_done_by_hand(editor):
    editor.trigger("tour")
    assert step(editor) == "Tour, 1 of 5"
    assert is_framed(editor, "view_frame")
    viewport = editor.window.view.viewports[0]
    at = viewport.mapFromGlobal(editor.window.screen_position(4, 2))
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=at)
    for k in range(1, 5):
        QTest.mouseMove(viewport, at - QPoint(0, 6 * k))
        editor.settle()
    assert step(editor) == "Tour, 1 of 5"  # the drag is not over
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=at - QPoint(0, 24))
    editor.settle()
    assert step(editor) == "Tour, 2 of 5"
    assert is_framed(editor, "zone.row_knots")
    editor.type_into("row_knots.C_2.u", "0.7")
    assert step(editor) == "Tour, 3 of 5"
    assert is_framed(editor, "surface.configure")
    editor.trigger("live")
    editor.type_into("row_knots.C_2.u", "0.4")
    editor.click("row_knots.set")
    assert step(editor) == "Tour, 3 of 5"
    editor.click("surface.configure")
    assert step(editor) == "Tour, 4 of 5"
    assert editor.window.store.state.is_live
    editor.trigger("colour_by_mean")
    assert step(editor) == "Tour, 5 of 5"
    assert is_framed(editor, "surface.export")
    editor.click("tour.next")
    assert not editor.find("tour").isVisible()
    made = editor.document
    editor.click("tour.end.keep")
    assert editor.document == made != FIG5
    assert editor.window.isWindowModified()
    assert editor.window.findChildren(QWidget, "highlight") == []


def test_the_program_shows_every_step_and_puts_all_back(editor):
    editor.trigger("tour")
    coloured = editor.window.store.state.display.colour_by
    for k in range(1, 5):
        assert step(editor) == f"Tour, {k} of 5"
        editor.click("tour.show")
    assert editor.document.control_points[2, 2, 2] > FIG5.control_points[2, 2, 2]
    assert editor.document.row_knots[2, 0].u == 0.35
    assert editor.window.store.state.display.colour_by != coloured
    editor.click("tour.show")
    editor.dialog("export").close()
    editor.window.activateWindow()  # there is no window manager to do so
    wait_until(editor.window.isActiveWindow)
    editor.key(Qt.Key.Key_Escape)
    assert editor.find("tour.end").isVisible()
    editor.key(Qt.Key.Key_Escape)
    assert editor.document == FIG5
    assert not editor.window.isWindowModified()
    assert editor.window.store.state.is_live
    assert not editor.window.store.state.is_stale
    assert editor.window.store.state.display.colour_by == coloured
    assert editor.window.findChildren(QWidget, "tour.text") == []


def test_escape_is_the_fields_first_and_then_the_tours(editor):
    editor.trigger("tour")
    field = editor.field("row_knots.C_2.u")
    field.setFocus()
    editor.settle()
    QTest.keyClicks(field, "0.9")
    editor.settle()
    editor.key(Qt.Key.Key_Escape, widget=field)
    assert not field.has_own_text
    assert editor.find("tour").isVisible()
    editor.key(Qt.Key.Key_Escape, widget=field)
    assert editor.window.findChildren(QWidget, "tour.text") == []
    assert editor.document == FIG5


def test_work_in_hand_is_left_alone(editor):
    editor.dispatch(SamplesChosen((7, 9)))
    mine = editor.document
    editor.trigger("tour")
    (other,) = (window for window in opened_windows() if window is not editor.window)
    assert other.store.state.document == FIG5
    assert other.findChild(QLabel, "tour.text").isVisible()
    assert editor.window.findChildren(QLabel, "tour.text") == []
    assert editor.document == mine
    other.leave()


def test_another_document_ends_it(editor):
    editor.trigger("tour")
    editor.trigger("preset_fig8")
    editor.settle()
    assert editor.window.findChildren(QWidget, "tour.text") == []
    assert editor.document == preset("fig8").document


def test_it_is_offered_once(editor, make_editor):
    offer_tour(editor.window, Preferences())
    assert editor.find("tour.offer").isVisible()
    again = make_editor()
    offer_tour(again.window, Preferences())
    assert again.window.findChildren(QWidget, "tour.offer") == []
    editor.click("tour.offer.take")
    assert step(editor) == "Tour, 1 of 5"
    assert editor.window.findChildren(QWidget, "tour.offer") == []
