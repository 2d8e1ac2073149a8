"""The menus that list what there is at the moment: files, steps, stored views."""

from __future__ import annotations

from PySide6.QtWidgets import QMenu

from qovr_app.store import Store
from qovr_app.window.actions import Actions
from qovr_app.window.folder import Folder
from qovr_app.window.history_menu import HistoryMenu
from qovr_app.window.menus import RecentMenu
from qovr_app.window.saved_views import SavedViews, SavedViewsMenu


def add_lists(menus: dict[str, QMenu], actions: Actions, store: Store, folder: Folder, views: SavedViews) -> None:
    """Put the recent files, the steps of the history and the stored views into their menus."""
    file, edit, camera = menus["File"], menus["Edit"], menus["View/Camera"]
    recent = RecentMenu(lambda: folder.recent, store.dispatch, file)
    file.insertMenu(menus["File/New from preset"].menuAction(), recent)
    edit.insertMenu(actions["copy"], HistoryMenu(lambda: store.state.history, store.dispatch, edit))
    camera.addMenu(SavedViewsMenu(views.cameras, store.dispatch, camera))
