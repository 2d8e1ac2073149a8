"""Looks of the view as a user chooses them in the window."""

from qovr_core.cameras import NAMED_VIEWS


def test_one_command_shows_the_surface_as_the_paper_does(editor, spin):
    view = editor.window.view
    for name in ("style_clay", "colour_by_mean", "scaling_equal", "camera_front"):
        editor.trigger(name)
    editor.trigger("paper_look")
    assert editor.action("style_facets").isChecked()
    assert editor.action("colour_map_jet").isChecked()
    assert editor.action("colour_by_height").isChecked()
    spin(lambda: (view.camera.azimuth, view.camera.elevation) == NAMED_VIEWS["paper"])
    picture = view.picture()
    assert tuple(picture.colouring.table[-1]) == (128, 0, 0)  # the last colour of MATLAB's jet


def test_points_that_wait_to_be_set_are_marked_in_the_view(editor):
    view = editor.window.view
    editor.trigger("live")
    editor.type_into("control_points.P_2_3.z", "0.7")
    editor.type_into("control_points.P_1_1.x", "abc")
    assert view.picture().pending == {(2, 3)}
    assert view.picture().refused == {(1, 1)}
    editor.click("control_points.get")
    assert view.picture().pending == frozenset()
    assert view.picture().refused == frozenset()


def test_that_the_documents_samples_are_drawn_is_remembered(make_editor):
    editor = make_editor()
    assert not editor.action("document_samples").isChecked()
    editor.trigger("document_samples")
    assert editor.window.view.picture().settings.document_samples
    editor.discard()
    assert make_editor().action("document_samples").isChecked()
