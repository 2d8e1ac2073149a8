"""The commands that are about the view as a whole: copy it as a picture, begin again with it."""

from PySide6.QtGui import QAction, QGuiApplication

from qovr_app.state.looking_intents import DisplayChosen
from qovr_core.errors import QovrError


def trigger(editor, name):
    editor.window.findChild(QAction, name).trigger()
    editor.settle()


def test_the_view_is_copied_as_a_picture_at_the_devices_resolution(make_editor):
    editor = make_editor()
    trigger(editor, "copy_picture")
    copied, view = QGuiApplication.clipboard().image(), editor.window.view
    ratio = view.devicePixelRatioF()
    assert (copied.width(), copied.height()) == (round(view.width() * ratio), round(view.height() * ratio))
    assert len({copied.pixelColor(x, copied.height() // 2).hue() // 30 for x in range(0, copied.width(), 3)}) > 3
    assert str(copied.width()) in editor.window.store.state.message.text


def test_an_error_while_drawing_is_said_and_the_view_goes_on(make_editor, monkeypatch, silenced, spin):
    from qovr_app.view3d.scene import colouring

    def fail(*arguments, **options):
        raise QovrError("no colour today")

    editor = make_editor()
    with monkeypatch.context() as patch:
        patch.setattr(colouring, "field_range", fail)
        editor.window.store.dispatch(DisplayChosen("colour_by", "gaussian"))
        spin(lambda: bool(silenced))
        editor.settle()
        assert "error of this program" in editor.window.store.state.message.text
    assert silenced
    count = len(silenced)
    editor.window.store.dispatch(DisplayChosen("colour_by", "mean"))
    editor.settle()
    spin(200)
    assert len(silenced) == count
    trigger(editor, "restart_view")
    spin(200)
    assert len(silenced) == count
