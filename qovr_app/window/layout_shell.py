"""What is asked of the parts in the window: the camera, the keyboard's focus, the clipboard, a range, help."""

from __future__ import annotations

import math

from PySide6.QtWidgets import QDialog, QWidget

from qovr_app.state import requests, view_requests
from qovr_app.state.looking_intents import PaperLookChosen, RangeFixed
from qovr_app.store import Store
from qovr_app.window.clipboard import Clipboard
from qovr_app.window.layout import Layout
from qovr_app.window.net_shell import NetShell
from qovr_app.window.saved_views import SavedViews, SavedViewsShell
from qovr_app.window.shell import Answers
from qovr_app.window.transforming import ask_symmetry, ask_transform
from qovr_app.window.underlay_shell import UnderlayShell


class LayoutShell:
    """Answers what only the parts in the window, or a dialog over them, can."""

    def __init__(self, store: Store, layout: Layout, window: QWidget, views: SavedViews) -> None:
        self._store, self._layout, self._window = store, layout, window
        clipboard = Clipboard(layout, store)
        self.answers: Answers = {
            **UnderlayShell(store, window).answers,
            **NetShell(store, window).answers,
            **SavedViewsShell(views, store, layout.view_frame, window).answers,
            requests.CopyAsked: clipboard.copy,
            requests.PasteAsked: clipboard.paste,
            requests.CameraAsked: layout.view_frame.look,
            view_requests.PaperLookAsked: self._look_as_the_paper,
            requests.ViewRestartAsked: layout.view_frame.restart,
            requests.CameraMoved: lambda moved: layout.view_frame.move_camera(moved.step),
            requests.RangeAsked: self._ask_range,
            requests.TransformAsked: lambda _asked: ask_transform(store, window, layout.view_frame),
            requests.SymmetryAsked: lambda _asked: ask_symmetry(store, window),
            requests.ZoneButtonPressed: self._press_zone_button,
            requests.FocusAsked: lambda asked: layout.focus_part(asked.part),
            requests.CloseAsked: lambda _asked: window.close(),
        }

    def _look_as_the_paper(self, _request: view_requests.PaperLookAsked) -> None:
        """Take the paper's colours and style, and turn to its camera once they are there."""
        self._store.dispatch(PaperLookChosen())
        self._store.flush()
        self._layout.view_frame.look(requests.CameraAsked("paper"))

    def _ask_range(self, _request: requests.RangeAsked) -> None:
        """Ask for the ends of a fixed range; a dialog that is left changes nothing."""
        title, limits = self._layout.view_frame.view.shown_range()
        if not all(map(math.isfinite, limits)) or not limits[0] < limits[1]:
            limits = self._store.state.display.fixed_range
        from qovr_app.dialogs.range_dialog import RangeDialog

        dialog = RangeDialog(title, limits, self._window)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            self._store.dispatch(RangeFixed(*dialog.limits))
        dialog.deleteLater()

    def _press_zone_button(self, request: requests.ZoneButtonPressed) -> None:
        zone = self._layout.current_zone()
        if request.is_set:
            zone.set_values()
        else:
            zone.get_values()
