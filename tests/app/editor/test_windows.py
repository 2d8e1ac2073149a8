"""Several windows, and windows that come and go."""

import pytest

from qovr_app.state.intents import PointsMoved
from qovr_core.presets import preset

DRAWN = 0.05
"""So many pixels have a hue where a surface is drawn; cividis is grey in its middle."""


def colourful(image):
    """Return how many of some pixels across an image are no greys."""
    places = [(x, y) for x in range(0, image.width(), 7) for y in range(0, image.height(), 7)]
    colours = (image.pixelColor(x, y) for x, y in places)
    return sum(max(c.red(), c.green(), c.blue()) - min(c.red(), c.green(), c.blue()) > 60 for c in colours) / len(
        places
    )


def test_two_windows_show_two_documents_and_one_outlives_the_other(make_editor, spin):
    first_editor, second_editor = make_editor("paper:fig5"), make_editor("paper:fig8")
    first, second = first_editor.window, second_editor.window
    spin(600)
    assert first.store.state.document == preset("fig5").document
    assert second.store.state.document == preset("fig8").document
    first.store.dispatch(PointsMoved(((2, 2),), ((0.1, 0.1, 0.1),), 1))
    spin(300)
    assert second.store.state.document == preset("fig8").document
    assert first.view.image() != second.view.image()
    assert min(colourful(first.view.image()), colourful(second.view.image())) > DRAWN
    first_editor.discard()
    spin(300)
    assert colourful(second.view.image()) > DRAWN


def test_a_window_that_is_hidden_and_shown_again_still_draws(make_editor, spin):
    window = make_editor("paper:fig5").window
    spin(600)
    before = window.view.image()
    window.hide()
    spin(100)
    window.show()
    spin(600)
    after = window.view.image()
    assert after.size() == before.size()
    assert colourful(after) == pytest.approx(colourful(before), abs=0.01)


def test_the_windows_have_the_programs_icon_at_every_size(make_editor):
    icon = make_editor().window.windowIcon()
    for size in (16, 32, 256):
        image = icon.pixmap(size, size).toImage()
        assert image.width() == size
        assert image.pixelColor(0, 0).alpha() < 128  # its corners are round
        assert colourful(image) > 0.1


def test_a_closed_window_is_let_go(make_editor, spin):
    editor = make_editor("paper:fig5")
    gone = []
    editor.window.view.destroyed.connect(lambda: gone.append(None))
    editor.discard()
    spin(lambda: bool(gone))
