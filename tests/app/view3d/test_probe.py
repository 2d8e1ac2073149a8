"""The probe: the exact place under a pixel, in every camera, projection, layer and renderer."""

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice, Scaling
from qovr_app.view3d.painter.readout import readout_rows, readout_text
from qovr_app.view3d.scene.camera import Camera
from qovr_app.view3d.scene.companions import Companions
from qovr_app.view3d.scene.mesh import surface_vertices
from qovr_app.view3d.scene.probing import parameters_under, reading_at
from qovr_app.view3d.scene.scene import make_scene, scene_frame
from qovr_core import Evaluation
from qovr_core.cameras import NAMED_VIEWS
from qovr_core.edits import Direction, KnotPlace, set_formulation
from qovr_core.fields import Field
from qovr_core.laboratory.sensitivity import knot_sensitivity
from qovr_core.layer import Layer
from qovr_core.presets import preset
from support.view import grid

SIZE = (800.0, 600.0)
FIG8 = set_formulation(preset("fig8").document, "interpolating")
CAMERAS = [Camera(*angles, perspective=perspective) for angles in NAMED_VIEWS.values() for perspective in (False, True)]
CAMERAS += [Camera(30, -40), Camera(100, 20, centre=(0.3, 0.1, 0.0), span=1.0, perspective=True)]


def scene_of(document, layer=Layer.RAW, companions=None):
    result = Evaluation(document)
    return make_scene(result, layer, scene_frame(result, layer, Scaling.EACH), companions)


def first_hit(scene, camera, x, y):
    """Return how far from the eye's plane a line of sight first meets a fine mesh (Moeller, Trumbore); else inf."""
    mesh = surface_vertices(scene.patch, grid(121, 121))[..., :3].astype(float)
    a, b, c, d = mesh[:-1, :-1], mesh[1:, :-1], mesh[1:, 1:], mesh[:-1, 1:]
    corner, side_1, side_2 = (
        np.concatenate(parts).reshape(-1, 3)
        for parts in ((a[None], a[None]), ((b - a)[None], (c - a)[None]), ((c - a)[None], (d - a)[None]))
    )
    origin, direction = camera.ray(x, y, SIZE)
    across = np.cross(direction, side_2)
    volume = np.einsum("kd,kd->k", side_1, across)
    with np.errstate(divide="ignore", invalid="ignore"):
        offset = origin - corner
        s = np.einsum("kd,kd->k", offset, across) / volume
        normal = np.cross(offset, side_1)
        t = normal @ direction / volume
        length = np.einsum("kd,kd->k", side_2, normal) / volume
        return length[(s >= 0) & (t >= 0) & (s + t <= 1)].min(initial=np.inf)


def facing(scene, camera, u, v):
    """Return the cosine between the normal and the line of sight."""
    normal = np.cross(scene.patch.derivative_at([u], [v], 1, 0)[0], scene.patch.derivative_at([u], [v], 0, 1)[0])
    toward = camera.eye[:3] - camera.eye[3] * scene.patch.derivative_at([u], [v], 0, 0)[0]
    return abs(normal @ toward) / np.linalg.norm(normal) / np.linalg.norm(toward)


@pytest.mark.parametrize("camera", CAMERAS, ids=str)
@pytest.mark.parametrize(("name", "layer"), [("fig6c", Layer.RAW), ("fig8", Layer.TRANSFORMED)])
def test_the_parameters_under_a_projected_point_are_its_own(name, layer, camera):
    scene = scene_of(set_formulation(preset(name).document, "interpolating"), layer)
    shown = 0
    for u, v in np.random.default_rng(1).uniform(0.02, 0.98, (40, 2)):
        point = scene.patch.points([u], [v])[0, 0]
        x, y, _ = camera.project(point, SIZE)
        origin, direction = camera.ray(x, y, SIZE)
        away = (point - origin) @ direction
        if facing(scene, camera, u, v) < 0.05 or first_hit(scene, camera, x, y) < away - 0.01:
            continue  # seen edge on, or not at all
        place = parameters_under(scene, camera, SIZE, x, y)
        found = scene.patch.points([place[0]], [place[1]])[0, 0]
        assert camera.project(found, SIZE)[:2] == pytest.approx((x, y), abs=1e-7)
        if (found - origin) @ direction < away - 0.01 and facing(scene, camera, *place) < 0.1:
            continue  # an outline lies before the point, which the mesh of the test cuts off
        shown += 1
        assert place == pytest.approx((u, v), abs=1e-9)
    assert shown >= 5


def test_of_two_sheets_the_nearer_is_meant():
    scene, camera = scene_of(FIG8), Camera(-90, 12)
    hits = 0
    for x in np.linspace(250, 550, 20):
        for y in np.linspace(200, 400, 20):
            place, first = parameters_under(scene, camera, SIZE, x, y), first_hit(scene, camera, x, y)
            if place is None or facing(scene, camera, *place) < 0.05:
                continue
            hits += 1
            origin, direction = camera.ray(x, y, SIZE)
            point = scene.patch.points([place[0]], [place[1]])[0, 0]
            assert (point - origin) @ direction == pytest.approx(first, abs=0.01)
    assert hits > 20


def test_beside_the_surface_there_is_nothing():
    assert parameters_under(scene_of(FIG8), Camera(), SIZE, 3.0, 3.0) is None


def test_a_reading_is_in_the_documents_units():
    knot, other = KnotPlace(Direction.ROWS, 3, "r"), Evaluation(preset("fig5").document)
    result = Evaluation(FIG8)
    surface = result.transformed_patch
    scene = scene_of(FIG8, Layer.TRANSFORMED, Companions(other.patch, "fig5", knot))
    assert Field.SENSITIVITY not in reading_at(scene, (0.3, 0.8), "height").others
    reading = reading_at(scene, (0.3, 0.8), "sensitivity")
    assert reading.point == pytest.approx(surface.points([0.3], [0.8])[0, 0], abs=1e-12)
    assert reading.normal == pytest.approx(surface.normals([0.3], [0.8])[0, 0], abs=1e-12)
    gaussian, mean, k1, k2 = reading.curvatures.values()
    assert (gaussian, mean) == pytest.approx((k1 * k2, (k1 + k2) / 2))
    assert k1 > k2
    dense = other.patch.points(np.linspace(0, 1, 301), np.linspace(0, 1, 301))
    assert reading.others[Field.DISTANCE] == pytest.approx(
        np.linalg.norm(dense - reading.point, axis=-1).min(), rel=1e-3
    )
    slope = knot_sensitivity(result, knot, Layer.TRANSFORMED).points([0.3], [0.8])[0, 0]
    assert reading.others[Field.SENSITIVITY] == pytest.approx(np.linalg.norm(slope))


def test_a_reading_says_only_what_there_is():
    reading = reading_at(scene_of(FIG8), (0.25, 0.5), "height")
    assert [name for name, _ in readout_rows(reading)] == ["u, v", "x, y, z", "normal", "K, H", "k_1, k_2"]
    lines = readout_text(reading).splitlines()
    assert lines[0] == "u, v\t0.25\t0.5"
    assert [float(number) for number in lines[1].split("\t")[1:]] == reading.point.tolist()
    with_distance = replace(reading, others={Field.DISTANCE: 0.125})
    assert readout_text(with_distance).splitlines()[-1] == "distance\t0.125"


def move(viewport, x, y):
    position = QPointF(x, y)
    none = Qt.MouseButton.NoButton
    event = QMouseEvent(
        QEvent.Type.MouseMove, position, viewport.mapToGlobal(position), none, none, Qt.KeyboardModifier.NoModifier
    )
    QApplication.sendEvent(viewport, event)


@pytest.mark.parametrize("renderer", ["opengl", "painter"])
@pytest.mark.parametrize("layer", list(LayerChoice))
def test_the_mouse_reads_the_point_it_is_over(make_view, document, renderer, layer, request, expected_pixel):
    if renderer == "painter":
        request.getfixturevalue("no_opengl")
    view = make_view(document, layer=layer, probe=True, size=(900, 560)).view
    number = len(view.viewports) - 1
    result = Evaluation(document)
    surface = result.patch if layer is LayerChoice.RAW else result.transformed_patch
    goal = surface.points([0.37], [0.58])[0, 0]
    move(view.viewports[number], *expected_pixel(view, goal, number))
    for k in range(number + 1):
        assert view.picture(k).probed == pytest.approx((0.37, 0.58), abs=1e-6)  # the event rounds its position
    assert view.probe_text().startswith("u, v\t0.3")
    QApplication.sendEvent(view.viewports[number], QEvent(QEvent.Type.Leave))
    assert view.picture().probed is None
    assert view.probe_text() == ""


def test_what_is_read_follows_the_surface_and_the_camera(make_view, document, expected_pixel):
    owner = make_view(document, layer=LayerChoice.RAW, probe=True)
    viewport = owner.view.viewports[0]
    x, y = expected_pixel(owner.view, Evaluation(document).patch.points([0.5], [0.5])[0, 0])
    move(viewport, x, y)
    before = owner.view.picture().probed
    owner.view.camera_motion.move(owner.view.camera.orbited(20.0, 0.0))
    after = owner.view.picture().probed
    assert after != before
    scene, size = owner.view.picture().scene, viewport.logical_size
    seen = owner.view.camera.project(scene.patch.points([after[0]], [after[1]])[0, 0], size)
    assert seen[:2] == pytest.approx((x, y), abs=1e-3)


def test_the_readout_and_the_mark_are_seen_and_stay_in_the_view(make_view, document, expected_pixel):
    plain, probed = (
        make_view(document, layer=LayerChoice.RAW, probe=probe, size=(330, 250)) for probe in (False, True)
    )
    for owner in (plain, probed):
        make_view.settle(owner.view)
        move(
            owner.view.viewports[0], *expected_pixel(owner.view, Evaluation(document).patch.points([0.5], [0.5])[0, 0])
        )
        make_view.settle(owner.view)
    images = [owner.view.image() for owner in (plain, probed)]
    changed = [
        (x, y)
        for x in range(330)
        for y in range(250)
        if abs(images[0].pixelColor(x, y).lightness() - images[1].pixelColor(x, y).lightness()) > 12
    ]
    assert len(changed) > 300
    assert max(x for x, _ in changed) < 325


def test_switched_off_it_reads_nothing(make_view, document, expected_pixel):
    view = make_view(document, layer=LayerChoice.RAW).view
    move(view.viewports[0], 350, 280)
    assert view.picture().probed is None
