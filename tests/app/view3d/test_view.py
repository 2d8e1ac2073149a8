"""The view as a part of a window: cameras, results, fallback, two at once, closing."""

import gc
import subprocess
import sys
import weakref
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMainWindow

from qovr_app.state.display import ColourMap, DisplaySettings, LayerChoice, Projection, Scaling
from qovr_app.view3d.interaction import camera_motion
from qovr_app.view3d.scene.probing import parameters_under
from qovr_core import Formulation
from qovr_core.edits import set_formulation, set_point, set_samples
from qovr_core.presets import preset
from support.view import change, choose, select, wheel


def test_the_camera_stays_when_the_document_changes(make_view, document):
    owner = make_view(document, layer=LayerChoice.RAW)
    camera = owner.view.camera
    owner.show(set_point(document, 2, 2, (9.0, -4.0, 7.0)))
    assert owner.view.camera == camera


def test_the_wheel_zooms_about_the_cursor(make_view, document, expected_pixel):
    owner = make_view(document, layer=LayerChoice.RAW)
    point = document.control_points[3, 1]
    at = expected_pixel(owner.view, point)
    wheel(owner.view.viewports[0], at, 4)
    assert expected_pixel(owner.view, point) == pytest.approx(at, abs=0.1)
    assert owner.view.camera.span < 3


def test_one_can_fly_into_the_picture(make_view, document, spin):
    view = make_view(document, projection=Projection.PERSPECTIVE, row_curves=True, control_box=True).view
    for k in range(60):
        wheel(view.viewports[0], (150 + 5 * k, 250), 1)
        spin(1)
    make_view.settle(view)
    assert view.camera.span < 0.01


def test_a_named_view_is_reached_by_a_turn(make_view, document, spin, monkeypatch):
    monkeypatch.setattr(
        camera_motion, "TURN_MILLISECONDS", 2000
    )  # so long that a busy machine sees the middle of it, too
    view = make_view(document).view
    view.set_camera("front")
    spin(lambda: view.camera.elevation < 64)
    assert view.camera.elevation > 0
    spin(lambda: view.camera.elevation == 0)
    assert view.camera.azimuth == -90


def test_one_looks_back_and_forward(make_view, document, spin):
    view = make_view(document).view
    places = [view.camera]
    for notches in (3, 4):
        wheel(view.viewports[0], (50, 60), notches)
        wheel(view.viewports[0], (50, 60), 1)
        places.append(view.camera)
        spin(camera_motion.REST_MILLISECONDS + 100)
    for place in (places[1], places[0]):
        view.camera_motion.recall(forward=False)
        spin(lambda place=place: view.camera == place)
    view.camera_motion.recall(forward=False)
    spin(50)
    assert view.camera == places[0]
    for place in places[1:]:
        view.camera_motion.recall(forward=True)
        spin(lambda place=place: view.camera == place)


def test_one_looks_at_the_selected_points_from_near(make_view, document, expected_pixel):
    view = make_view(document, layer=LayerChoice.RAW).view
    select(view, (0, 3), (0, 4))
    view.fit(selection=True, animated=False)
    ends = [expected_pixel(view, document.control_points[index]) for index in ((0, 3), (0, 4))]
    assert np.mean(ends, axis=0) == pytest.approx([view.width() / 2, view.height() / 2], abs=1)
    assert np.ptp(ends, axis=0).max() > 100


def test_an_orbit_turns_about_what_is_under_the_mouse(make_view, document):
    view = make_view(document, layer=LayerChoice.RAW, control_points=False).view
    wheel(view.viewports[0], (300, 250), 4)
    picture, size, at = view.picture(), view.viewports[0].logical_size, (320, 270)
    u, v = parameters_under(picture.scene, view.camera, size, *at)
    point = picture.scene.patch.points([u], [v])[0, 0]
    QTest.mousePress(view.viewports[0], Qt.MouseButton.LeftButton, pos=QPoint(*at))
    for step in range(1, 9):
        QTest.mouseMove(view.viewports[0], QPoint(at[0] + 9 * step, at[1] - 4 * step))
    QTest.mouseRelease(view.viewports[0], Qt.MouseButton.LeftButton, pos=QPoint(392, 238))
    assert view.camera.azimuth != picture.camera.azimuth
    assert view.camera.project(point, size)[:2] == pytest.approx(at, abs=1e-6)


def test_fit_shows_everything_again(make_view, document):
    view = make_view(document).view
    fitted = view.camera
    wheel(view.viewports[0], (50, 60), 9)
    view.fit(animated=False)
    assert view.camera.span == pytest.approx(fitted.span)
    assert view.camera.centre == pytest.approx(fitted.centre)


def test_settings_change_projection_and_scaling(make_view, document):
    view = make_view(document).view
    change(view, settings=DisplaySettings(projection=Projection.PERSPECTIVE, scaling=Scaling.EQUAL))
    assert view.camera.perspective
    assert np.ptp(view.picture().scene.frame.scale) == 0


def test_limits_follow_by_choice_but_wait_while_a_point_is_dragged(make_view, document, expected_pixel):
    owner = make_view(document, layer=LayerChoice.RAW, always_fits=True)
    viewport = owner.view.viewports[0]
    at = QPoint(*(round(value) for value in expected_pixel(owner.view, document.control_points[0, 4])))
    limits = owner.view.picture().scene.frame.limits
    QTest.mousePress(viewport, Qt.MouseButton.LeftButton, pos=at)
    QTest.mouseMove(viewport, at + QPoint(0, -150))
    assert owner.drags
    np.testing.assert_array_equal(owner.view.picture().scene.frame.limits, limits)
    QTest.mouseRelease(viewport, Qt.MouseButton.LeftButton, pos=at + QPoint(0, -150))
    assert (owner.view.picture().scene.frame.limits != limits).any()


@pytest.mark.parametrize("change_of", ["formulation", "opening", "layer"])
def test_limits_are_taken_anew_for_something_else(make_view, document, change_of):
    owner = make_view(document, layer=LayerChoice.RAW)
    owner.show(set_point(document, 2, 2, (2.0, 2.0, 7.0)))
    assert owner.view.picture().leaves_frame
    if change_of == "formulation":
        owner.show(set_formulation(owner.document, Formulation.DOUBLE_SUM))
    elif change_of == "opening":
        change(owner.view, opening=1)
    else:
        choose(owner.view, layer=LayerChoice.TRANSFORMED)
    assert not owner.view.picture().leaves_frame


def test_the_grid_is_coarse_in_motion_and_fine_at_rest(make_view, document, spin):
    owner = make_view(set_samples(document, (1001, 1001)))
    owner.show(set_point(owner.document, 2, 2, (2.0, 2.0, 0.3)))
    assert max(owner.view.picture().grid.cells) <= 100
    spin(lambda: owner.view.picture().grid.cells == (200, 200))


def test_the_selection_can_be_set_and_cleared(make_view, document):
    owner = make_view(document)
    select(owner.view, (3, 4))
    assert owner.view.picture().last_selected == (3, 4)
    select(owner.view)
    assert owner.view.picture().last_selected is None
    assert owner.selections == []


def test_any_number_of_points_can_be_selected(make_view, document, expected_pixel):
    owner = make_view(document, layer=LayerChoice.RAW, labels=False, surface=False, control_net=False, axes=False)

    def ringed():
        """Return the points around which there is ink where a ring is, and nothing is drawn otherwise."""
        image, ground = owner.view.image(), owner.view.picture().theme.background
        found = set()
        for index in np.ndindex(5, 5):
            x, y = expected_pixel(owner.view, document.control_points[index])
            at = [(x + 10 * np.cos(a), y + 10 * np.sin(a)) for a in np.linspace(0, 2 * np.pi, 24)]
            ratio = image.devicePixelRatioF()
            colours = [image.pixelColor(round(ratio * p), round(ratio * q)).getRgb()[:3] for p, q in at]
            if sum(colour != ground for colour in colours) > 16:
                found.add(index)
        return found

    assert ringed() == set()
    select(owner.view, (1, 2), (3, 0), (4, 4))
    assert ringed() == {(1, 2), (3, 0), (4, 4)}
    assert owner.view.picture().last_selected == (4, 4)


@pytest.mark.parametrize("where", ["upload", "shader"])
def test_an_opengl_call_that_fails_leads_to_the_painter_until_the_view_is_restarted(
    make_view, document, monkeypatch, silenced, where
):
    from qovr_app.view3d.gl import api
    from qovr_app.view3d.gl import program as gl_program
    from qovr_app.view3d.gl.calls import GL, gl

    def fail(*args, **kwargs):
        gl("glEnable", GL.FLOAT)  # there is no such thing

    owner = make_view(document)
    if not owner.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    with monkeypatch.context() as patch:
        if where == "shader":
            patch.setattr(gl_program, "shader_source", lambda name: "void main() { this is no shader; }")
            change(owner.view, settings=DisplaySettings(parameter_lines=False))
        else:
            patch.setattr(api, "load_attributes", fail)
            owner.show(set_point(document, 2, 2, (2.0, 2.0, 0.4)))
        QTest.qWait(400)
    assert len(owner.reasons) == 1
    assert owner.reasons[0].startswith("OpenGL failed while drawing:")
    assert not owner.view.uses_opengl
    assert shows_colours(owner.view)
    assert len(silenced) == 1
    owner.view.restart()
    QTest.qWait(100)
    assert owner.view.uses_opengl
    assert shows_colours(owner.view)
    assert (len(owner.reasons), owner.faults) == (1, [])


def shows_colours(view):
    """Return whether the picture has the colours of a surface."""
    return np.ptp(np.array([view.image().pixelColor(x, 300).hue() for x in range(150, 450, 10)])) > 20


@pytest.mark.parametrize("where", ["upload", "overlay", "painter"])
def test_an_error_of_the_program_while_drawing_is_said_as_that_and_the_next_state_is_drawn(
    make_view, document, monkeypatch, silenced, where, request
):
    from qovr_app.view3d import gl_viewport, painter_viewport
    from qovr_app.view3d.gl import surface_buffers

    def fail(*args, **kwargs):
        raise ZeroDivisionError("a step of nothing\nat all")

    if where == "painter":
        request.getfixturevalue("no_opengl")
    owner = make_view(document)
    used, reasons = owner.view.uses_opengl, list(owner.reasons)
    part, name = {
        "upload": (surface_buffers, "surface_vertices"),
        "overlay": (gl_viewport, "overlay"),
        "painter": (painter_viewport, "overlay"),
    }[where]
    with monkeypatch.context() as patch:
        patch.setattr(part, name, fail)
        owner.show(set_point(document, 2, 2, (2.0, 2.0, 0.4)))
        QTest.qWait(400)
    assert owner.reasons == reasons
    assert owner.view.uses_opengl == used
    assert owner.faults
    assert all("error of this program" in fault and "OpenGL" not in fault for fault in owner.faults)
    assert all(fault.endswith(": a step of nothing at all") and len(fault) <= 300 for fault in owner.faults)
    assert silenced[0].exc_info[0] is ZeroDivisionError
    faults = len(owner.faults)
    owner.show(set_point(document, 2, 2, (2.0, 2.0, 0.5)))
    QTest.qWait(300)
    assert len(owner.faults) == faults
    assert shows_colours(owner.view)


def test_a_failure_in_two_viewports_is_one_message(make_view, document, spin, monkeypatch, silenced):
    from qovr_app.view3d.gl import api
    from qovr_app.view3d.gl.calls import DriverError

    owner = make_view(document, layer=LayerChoice.BOTH)

    def fail(*args, **kwargs):
        raise DriverError("lost")

    monkeypatch.setattr(api, "load_attributes", fail)
    select(owner.view, (1, 1))
    spin(lambda: bool(owner.reasons))
    spin(100)
    assert len(owner.reasons) == 1
    assert len(owner.view.viewports) == 2


def test_what_a_context_held_is_drawn_again_in_the_next_one(make_view, document):
    view = make_view(document).view
    if not view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    viewport = view.viewports[0]
    for _ in range(2):
        viewport.context().aboutToBeDestroyed.emit()
        viewport.initializeGL()
        assert shows_colours(view)


def test_a_context_that_is_lost_is_replaced_by_another_one(make_view, document, monkeypatch, spin):
    from qovr_app.view3d import gl_viewport
    from qovr_app.view3d.gl import api
    from qovr_app.view3d.gl.calls import DriverError

    class LostContext:
        def isValid(self):
            return False

    owner = make_view(document)
    if not owner.view.uses_opengl:
        pytest.skip("there is no OpenGL here")
    before = owner.view.viewports[0]

    def fail(*args, **kwargs):
        raise DriverError("the context is lost")

    with monkeypatch.context() as patch:
        patch.setattr(gl_viewport.GlViewport, "context", lambda viewport: LostContext())
        patch.setattr(api, "load_attributes", fail)
        select(owner.view, (1, 1))
        before.repaint()
    spin(lambda: owner.view.viewports[0] is not before)
    spin(100)
    assert owner.view.uses_opengl
    assert shows_colours(owner.view)
    assert (owner.reasons, owner.faults) == ([], [])


def test_without_opengl_the_painter_says_why_once(make_view, document, no_opengl, spin):
    owner = make_view(document, layer=LayerChoice.BOTH)
    spin(lambda: bool(owner.reasons))
    assert owner.reasons == ["switched off"]


@pytest.mark.parametrize("platform", ["offscreen", "minimal"])
def test_platforms_without_opengl_are_known(platform):
    code = (
        "from qovr_app.view3d.gl import support; support.set_default_format();"
        "from PySide6.QtWidgets import QApplication; import sys; app = QApplication(['', *sys.argv[1:]]);"
        "support = support.gl_support(); assert not support.usable; print(support.reason)"
    )
    command = [sys.executable, "-c", code, "-platform", platform]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    assert run.returncode == 0, run.stderr
    assert platform in run.stdout


def test_two_views_at_once(make_view, document, colour_at):
    first = make_view(document, colour_map=ColourMap.JET).view
    second = make_view(preset("fig6c").document, colour_map=ColourMap.JET).view
    for view in (first, second):
        image = view.image()
        hues = {image.pixelColor(x, image.height() // 2).hue() // 30 for x in range(100, image.width() - 150, 5)}
        assert len(hues) > 3


def test_a_floating_view_goes_on_drawing(make_view, document, spin):
    view = make_view(document, colour_map=ColourMap.JET).view
    window = QMainWindow()
    window.resize(640, 480)
    window.setCentralWidget(view)
    window.show()
    spin(300)
    view.setParent(None)
    view.show()
    spin(300)
    image = view.image()
    hues = {image.pixelColor(x, image.height() // 2).hue() // 30 for x in range(100, image.width() - 150, 5)}
    assert len(hues) > 3
    window.close()
    window.deleteLater()


def test_closed_views_are_gone(app, document, spin):
    from qovr_app.view3d.view import View3D

    gone = []
    for _ in range(3):
        view = View3D()
        change(view, document=document)
        view.show()
        spin(60)
        gone.append(weakref.ref(view))
        view.close()
        view.deleteLater()
        del view
        spin(20)
    gc.collect()
    assert [reference() for reference in gone] == [None, None, None]


def test_many_edits_leave_nothing_behind(make_view, document, app):
    """A drag of many edits keeps no scene, picture or buffer but the last."""
    owner = make_view(document)

    def resident():
        gc.collect()
        return int(Path("/proc/self/statm").read_text().split()[1]) * 4096

    if not sys.platform.startswith("linux"):
        pytest.skip("memory is read from /proc")
    for k in range(300):
        owner.show(set_point(document, 2, 2, (2.0, 2.0, 0.3 + 0.0005 * k)))
        app.processEvents()
        if k == 100:
            before = resident()
    assert resident() - before < 5e6
