"""A view on the screen, with the smallest owner that makes its intents come true."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import numpy as np
import pytest

from qovr_app.state.display import DisplaySettings
from qovr_core import Document, Formulation
from qovr_core.edits import set_formulation, set_point, set_points, set_samples
from qovr_core.presets import preset
from support.view import change, select


def _expected_pixel(view: object, point: np.ndarray, viewport: int = 0) -> tuple[float, float]:
    """Return where a point of the document belongs in a viewport, in logical pixels, parallel projection."""
    picture, camera = view.picture(viewport), view.camera
    frame = picture.scene.frame
    unit = [
        (value - (low + high) / 2) * scale - centre
        for value, (low, high), scale, centre in zip(point, frame.limits, frame.scale, camera.centre, strict=True)
    ]
    azimuth, elevation = math.radians(camera.azimuth), math.radians(camera.elevation)
    across = -math.sin(azimuth) * unit[0] + math.cos(azimuth) * unit[1]
    away = math.cos(azimuth) * unit[0] + math.sin(azimuth) * unit[1]
    upward = math.cos(elevation) * unit[2] - math.sin(elevation) * away
    width, height = view.viewports[viewport].width(), view.viewports[viewport].height()
    pixels = min(width, height) / camera.span
    return width / 2 + across * pixels, height / 2 - upward * pixels


def _colour_at(image: object, x: float, y: float) -> tuple[int, int, int]:
    """Return red, green and blue of an image at a logical pixel."""
    ratio = image.devicePixelRatioF()
    colour = image.pixelColor(round(x * ratio), round(y * ratio))
    return colour.red(), colour.green(), colour.blue()


@pytest.fixture
def expected_pixel() -> Callable[..., tuple[float, float]]:
    """An independent projection: trigonometry on single points, nothing of the view's matrices."""
    return _expected_pixel


@pytest.fixture
def colour_at() -> Callable[..., tuple[int, int, int]]:
    return _colour_at


@pytest.fixture(params=["opengl", "painter"])
def renderer(request: pytest.FixtureRequest) -> str:
    """Both ways of drawing."""
    if request.param == "painter":
        request.getfixturevalue("no_opengl")
    return request.param


class Owner:
    """Holds a document, moves its points as the view asks, and remembers every intent."""

    def __init__(self, view: object, document: Document) -> None:
        self.view, self.document, self.before = view, document, document
        self.drags: list[tuple[tuple[tuple[int, int], ...], np.ndarray, int]] = []
        self.ends: list[tuple[str, int]] = []
        self.selections: list[object] = []
        self.reasons: list[str] = []
        self.faults: list[str] = []
        view.points_dragged.connect(self._on_dragged)
        view.drag_finished.connect(self._on_finished)
        view.drag_cancelled.connect(self._on_cancelled)
        view.points_picked.connect(self._on_picked)
        view.fell_back.connect(self.reasons.append)
        view.faulted.connect(self.faults.append)
        change(view, document=document)

    def show(self, document: Document) -> None:
        self.document = document
        change(self.view, document=document)

    def _on_dragged(self, indices: tuple[tuple[int, int], ...], moved: np.ndarray, gesture: int) -> None:
        if not self.drags or self.drags[-1][2] != gesture:
            self.before = self.document
        self.drags.append((indices, moved, gesture))
        net = self.before.control_points.copy()
        for index, way in zip(indices, moved, strict=True):
            net[index] = np.round(net[index] + way, 12)
        self.document = set_points(self.document, net)
        change(self.view, document=self.document, dragging=True)

    def _on_finished(self, gesture: int) -> None:
        self.ends.append(("finished", gesture))
        change(self.view, dragging=False)

    def _on_cancelled(self, gesture: int) -> None:
        self.ends.append(("cancelled", gesture))
        self.document = self.before
        change(self.view, document=self.document, dragging=False)

    def _on_picked(self, picked: tuple[tuple[int, int], ...], picking: str) -> None:
        self.selections.append(picked)
        before = {} if picking == "replace" else dict.fromkeys(sorted(self.view.shown.selected))
        marked = [index for index in before if picking == "add" or index not in picked]
        marked += [index for index in picked if picking != "toggle" or index not in before]
        select(self.view, *marked)


@pytest.fixture
def document() -> Document:
    """The paper's net under the interpolating formulation, which is not symmetric once a corner is lifted."""
    base = set_formulation(preset("fig8").document, Formulation.INTERPOLATING)
    return set_samples(set_point(base, 0, 4, (4.0, 0.0, 0.9)), (31, 31))


@pytest.fixture
def make_view(app: object, spin: Callable[..., None]) -> Iterator[Callable[..., Owner]]:
    """A function that shows a view of some logical size with a document and waits for its first frame."""
    from qovr_app.view3d.view import View3D

    views = []

    def make(
        document: Document, *, size: tuple[int, int] = (700, 560), at_rest: bool = True, **settings: object
    ) -> Owner:
        view = View3D()
        views.append(view)
        view.resize(*size)
        change(view, settings=DisplaySettings(**settings))
        owner = Owner(view, document)
        frames: list[None] = []
        view.frame_painted.connect(lambda: frames.append(None))
        view.show()
        spin(lambda: bool(frames))
        view.set_camera("paper", animated=False)
        owner.make_rest = lambda: settle(view)
        if at_rest:
            settle(view)
        return owner

    def settle(view: object) -> None:
        """Wait until the picture is the one at rest."""
        spin(lambda: not view.picture().moving)
        spin(30)

    make.settle = settle
    yield make
    for view in views:
        view.close()
        view.deleteLater()
    app.processEvents()


@pytest.fixture
def no_opengl(monkeypatch: pytest.MonkeyPatch) -> None:
    """Views made here have no OpenGL."""
    from qovr_app.view3d import viewports
    from qovr_app.view3d.gl import support as gl_support

    monkeypatch.setattr(viewports, "gl_support", lambda: gl_support.GlSupport(usable=False, reason="switched off"))
