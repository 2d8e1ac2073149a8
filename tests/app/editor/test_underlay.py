"""A reference picture under the net: chosen, placed, seen where it is said to lie, and removed."""

import pytest
from PySide6.QtCore import QTimer
from PySide6.QtGui import QColor, QImage
from PySide6.QtWidgets import QApplication, QDialog, QDialogButtonBox, QFileDialog, QLineEdit

RED, BLUE = (200, 40, 40), (40, 40, 200)


@pytest.fixture
def sheet(home):
    """A picture twice as wide as high, the left half red and the right one blue."""
    image = QImage(200, 100, QImage.Format.Format_RGB32)
    image.fill(QColor(*BLUE))
    for x in range(100):
        for y in range(100):
            image.setPixelColor(x, y, QColor(*RED))
    path = home / "sheet.png"
    image.save(str(path))
    return path


@pytest.fixture
def bare(make_editor, monkeypatch, sheet):
    """An editor that shows nothing but what lies under the net, from above, and chooses the picture when it asks."""
    editor = make_editor("paper:fig8")
    for name in ("surface", "labels", "control_net", "control_points", "axes", "triad"):
        editor.trigger(f"show_{name}")
    editor.window.view.set_camera("top", animated=False)
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(sheet), ""))
    return editor


def seen(editor, x, y):
    """Return the colour of the view at x and y of the document, in the lowest plane."""
    view = editor.window.view
    frame = view.picture().scene.frame
    at = frame.to_unit([x, y, frame.limits[2, 0]])
    across, down, _ = view.camera.project(at, view.viewports[0].logical_size).tolist()
    return view.image().pixelColor(round(across), round(down)).getRgb()[:3]


def answer(name, **texts):
    """Type into the dialog that opens, and accept it."""

    def fill():
        dialog = QApplication.activeModalWidget()
        assert isinstance(dialog, QDialog)
        assert dialog.objectName() == name
        for field, text in texts.items():
            dialog.findChild(QLineEdit, f"{name}.{field}").setText(text)
        ok = dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Ok)
        if ok.isEnabled():
            ok.click()
        else:
            dialog.reject()

    QTimer.singleShot(200, fill)


def test_a_picture_lies_where_it_is_said_to(bare):
    background = bare.window.view.picture().theme.background
    assert seen(bare, 1, 2) == background
    assert not bare.action("underlay_place").isEnabled()
    bare.trigger("underlay")
    assert "sheet.png" in bare.message()
    answer("underlay", left="0", bottom="1", width="4/2", height="1", opacity="1")
    bare.trigger("underlay_place")
    assert [seen(bare, x, y) for x, y in ((0.5, 1.5), (1.5, 1.5), (0.5, 2.5), (2.5, 1.5))] == [
        RED, BLUE, background, background,
    ]  # fmt: skip
    bare.window.view.camera_motion.move(bare.window.view.camera.orbited(40, -50))
    assert seen(bare, 0.3, 1.2) == RED
    answer("underlay", opacity="2", width="-1")
    bare.trigger("underlay_place")
    assert seen(bare, 0.3, 1.2) == RED
    bare.trigger("underlay_remove")
    assert seen(bare, 0.3, 1.2) == background


def test_it_is_fitted_to_the_net_in_its_own_proportions_and_seen_through(bare):
    bare.trigger("underlay")
    underlay = bare.window.store.state.display.underlay
    assert (underlay.left, underlay.bottom, underlay.width, underlay.height) == (-2, 0, 8, 4)
    assert seen(bare, 1, 2) == pytest.approx([0.6 * part + 0.4 * 255 for part in RED], abs=1)


def test_what_holds_no_picture_is_refused(bare, home, sheet):
    sheet.write_text("no picture")
    bare.trigger("underlay")
    assert "expected a PNG or JPEG" in bare.message()
    assert bare.window.store.state.display.underlay is None
