"""Views that a user has given a name: stored, looked from again, and deleted."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from PySide6.QtWidgets import QDialogButtonBox, QInputDialog, QMenu, QWidget

from qovr_app.dialogs.buttons import without_icons
from qovr_app.state import view_requests
from qovr_app.state.looking_intents import MessageShown
from qovr_app.store import Dispatch, Store
from qovr_app.view3d.scene.camera import Camera
from qovr_app.widgets.plain import menu_text
from qovr_app.window.preferences import Preferences
from qovr_app.window.shell import Answers
from qovr_app.window.view_frame import ViewFrame

if TYPE_CHECKING:
    from collections.abc import Mapping

_KEY = "saved_views"
_LONGEST_NAME = 60


class SavedViews:
    """The cameras by their names: with the preferences, or for as long as a window that remembers nothing is open."""

    def __init__(self, preferences: Preferences | None) -> None:
        self._preferences = preferences
        self._text = "{}"

    def cameras(self) -> dict[str, Camera]:
        """Return every stored camera by its name; what is damaged counts as never stored."""
        text = self._text if self._preferences is None else self._preferences.chosen(_KEY, "{}")
        try:
            stored = json.loads(text)
            return {str(name): _camera(values) for name, values in stored.items()}
        except (ValueError, TypeError, AttributeError):
            return {}

    def keep(self, cameras: Mapping[str, Camera]) -> None:
        """Keep these and no others."""
        self._text = json.dumps({name: _values(camera) for name, camera in cameras.items()})
        if self._preferences is not None:
            self._preferences.choose(_KEY, self._text)


def _values(camera: Camera) -> list[float]:
    return [camera.azimuth, camera.elevation, *camera.centre, camera.span]


def _camera(values: Any) -> Camera:
    azimuth, elevation, x, y, z, span = map(float, values)
    return Camera(azimuth, elevation, (x, y, z), span)


class SavedViewsShell:
    """Stores where the view looks from under a name that is asked for, looks from there, and forgets it."""

    def __init__(self, views: SavedViews, store: Store, view_frame: ViewFrame, window: QWidget) -> None:
        self._views, self._store, self._frame, self._window = views, store, view_frame, window
        self.answers: Answers = {
            view_requests.ViewStoreAsked: self._store_view,
            view_requests.SavedViewAsked: self._look,
            view_requests.SavedViewDropped: self._drop,
        }

    def _store_view(self, _request: view_requests.ViewStoreAsked) -> None:
        dialog = QInputDialog(self._window)
        dialog.setObjectName("store_view")
        dialog.setWindowTitle("Store View")
        dialog.setLabelText("Name of the view")
        for buttons in dialog.findChildren(QDialogButtonBox):
            without_icons(buttons)
        if not dialog.exec():
            return
        name = " ".join(dialog.textValue().split())[:_LONGEST_NAME]
        if name:
            self._views.keep({**self._views.cameras(), name: self._frame.view.camera})
            self._say(f"View, Camera, Saved views, {name} looks from here again.")

    def _look(self, request: view_requests.SavedViewAsked) -> None:
        camera = self._views.cameras().get(request.name)
        if camera is None:  # another window has deleted it since the menu was opened
            self._say(f"There is no view {request.name} any more.")
        else:
            view = self._frame.view
            there = replace(camera, perspective=view.camera.perspective)
            view.camera_motion.lead_to(there, animated=view.isVisible())

    def _drop(self, request: view_requests.SavedViewDropped) -> None:
        self._views.keep({name: camera for name, camera in self._views.cameras().items() if name != request.name})
        self._say(f"The view {request.name} is forgotten.")

    def _say(self, text: str) -> None:
        self._store.dispatch(MessageShown(text))


class SavedViewsMenu(QMenu):
    """The views that were stored, read whenever the menu opens: to look from there, or to delete one."""

    def __init__(self, names: Callable[[], Mapping[str, Camera]], dispatch: Dispatch, parent: QWidget) -> None:
        super().__init__("Sa&ved views", parent)
        self.setObjectName("menu.saved_views")
        self._names, self._dispatch = names, dispatch
        self._delete = QMenu("&Delete", self)
        self._delete.setObjectName("menu.saved_views.delete")
        self.aboutToShow.connect(self._fill)
        self._fill()

    def _fill(self) -> None:
        self.clear()
        self._delete.clear()
        names = list(self._names())
        for name in names:
            self.addAction(menu_text(name), partial(self._dispatch, view_requests.SavedViewAsked(name)))
            self._delete.addAction(menu_text(name), partial(self._dispatch, view_requests.SavedViewDropped(name)))
        if names:
            self.addSeparator()
            self.addMenu(self._delete)
        else:
            self.addAction("No views yet").setEnabled(False)
