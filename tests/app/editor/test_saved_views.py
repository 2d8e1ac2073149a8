"""Views with names: stored, looked from in the next window too, and deleted."""

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication, QInputDialog, QMenu

from qovr_app.window.preferences import Preferences


def store(editor, name):
    """Store where the view looks from by the command and its dialog."""

    def fill():
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QInputDialog)
        dialog.setTextValue(name)
        dialog.accept()

    QTimer.singleShot(200, fill)
    editor.trigger("store_view")


def entries(editor, name="menu.saved_views"):
    menu = editor.find(name, QMenu)
    menu.aboutToShow.emit()
    return {action.text(): action for action in menu.actions() if not action.isSeparator()}


def test_a_stored_view_is_there_in_the_next_window_and_can_be_deleted(make_editor, spin):
    first = make_editor()
    assert list(entries(first)) == ["No views yet"]
    view = first.window.view
    camera = view.camera.orbited(70, -30)
    view.camera_motion.move(camera)
    store(first, "  from   the side & below ")
    view.camera_motion.move(camera.orbited(40, 20))
    second = make_editor()
    choose = entries(second)["from the side && below"]
    choose.trigger()
    spin(lambda: second.window.view.camera == camera)
    entries(second)
    entries(second, "menu.saved_views.delete")["from the side && below"].trigger()
    second.settle()
    assert "forgotten" in second.message()
    assert list(entries(first)) == ["No views yet"]


def test_a_name_is_stored_anew_and_none_is_not_stored(make_editor, spin):
    editor = make_editor()
    for name, turn in (("a", 10), ("a", 30), ("", 50)):
        editor.window.view.camera_motion.move(editor.window.view.camera.orbited(turn, 0))
        store(editor, name)
        if name:
            camera = editor.window.view.camera
    assert set(entries(editor)) == {"a", "&Delete"}
    entries(editor)["a"].trigger()
    spin(lambda: editor.window.view.camera == camera)


def test_damaged_views_count_as_never_stored(make_editor):
    for text in ("[1]", "{", '{"a": [1, 2]}', '{"a": null}'):
        Preferences().choose("saved_views", text)
        assert list(entries(make_editor())) == ["No views yet"]
