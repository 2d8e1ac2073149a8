"""The shell: answers what only the world outside the state can - files, dialogs, clipboard, camera, focus."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from PySide6.QtWidgets import QDialog, QWidget

from qovr_app.dialogs.help_dialog import HelpDialog
from qovr_app.dialogs.range_dialog import RangeDialog
from qovr_app.state import requests
from qovr_app.state.intents import RangeFixed, Request
from qovr_app.store import Store
from qovr_app.window.clipboard import Clipboard
from qovr_app.window.file_shell import FileShell
from qovr_app.window.layout import Layout
from qovr_app.window.recovery_offer import RecoveryOffer


class Shell:
    """Hands every kind of request to the part of the window that answers it."""

    def __init__(
        self, store: Store, layout: Layout, files: FileShell, recovery: RecoveryOffer, window: QWidget
    ) -> None:
        self._store, self._layout, self._window = store, layout, window
        self._help: HelpDialog | None = None
        clipboard = Clipboard(layout, layout.view_frame.probe_text, store.dispatch)
        self._answers: dict[type[Request], Callable[[Any], object]] = {
            requests.OpenAsked: files.ask_for_source,
            requests.SourceAsked: files.open_source,
            requests.DocumentAsked: files.open_document,
            requests.RecentCleared: files.clear_recent,
            requests.SaveAsked: files.save,
            requests.ExportAsked: files.export,
            requests.FigureAsked: files.save_figure,
            requests.DrawingAsked: files.save_drawing,
            requests.RecoveryAnswered: recovery.answer,
            requests.CopyAsked: clipboard.copy,
            requests.PasteAsked: clipboard.paste,
            requests.CameraAsked: layout.view_frame.look,
            requests.RangeAsked: self._ask_range,
            requests.ZoneButtonPressed: self._press_zone_button,
            requests.FocusAsked: self._focus,
            requests.HelpAsked: self._show_help,
            requests.CloseAsked: lambda _request: window.close(),
        }

    def perform(self, request: Request) -> None:
        """Answer a request."""
        self._answers[type(request)](request)

    def _ask_range(self, _request: requests.RangeAsked) -> None:
        """Ask for the ends of a fixed range; a dialog that is left changes nothing."""
        title, limits = self._layout.view_frame.view.shown_range()
        if not all(map(math.isfinite, limits)) or not limits[0] < limits[1]:
            limits = self._store.state.display.fixed_range
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

    def _focus(self, request: requests.FocusAsked) -> None:
        self._layout.focus_part(request.part)

    def _show_help(self, _request: requests.HelpAsked) -> None:
        if self._help is None:
            self._help = HelpDialog(self._window)
        self._help.show()
        self._help.raise_()
