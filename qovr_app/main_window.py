"""The main window: wiring, and the commands that need a window."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QSize
from PySide6.QtGui import QCloseEvent, QGuiApplication, QKeySequence
from PySide6.QtWidgets import QFileDialog, QLabel, QMainWindow, QMessageBox

from qovr_app.actions import Command, make_actions
from qovr_app.appearance import NAME, theme
from qovr_app.controller import Controller
from qovr_app.dialogs.figure_dialog import FigureDialog
from qovr_app.menus import fill_menu_bar, make_view_bar
from qovr_app.session import DOCUMENT_SUFFIX, Session
from qovr_app.view3d.settings import DisplaySettings
from qovr_app.view_commands import view_commands
from qovr_app.view_place import ViewPlace
from qovr_core import AlignedPatch, QovrError
from qovr_core.files.sources import PRESET_PREFIX, READERS
from qovr_core.presets import presets

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D

_FIRST_SIZE = QSize(1280, 800)
_MESSAGE_MILLISECONDS = 12_000
_DRAG_HINT = "Drag: in the view plane. Hold X, Y or Z: along that axis. Esc: put the point back."


class MainWindow(QMainWindow):
    """One document, seen and edited.

    Parameters
    ----------
    source : what to open; None shows the paper's own example

    Raises
    ------
    QovrError : the source cannot be read
    """

    def __init__(self, source: str | None = None) -> None:
        super().__init__()
        self.session = Session(self)
        if source is not None:
            self.session.open(source)
        self.controller = Controller(self.session, self)
        self._settings = DisplaySettings(theme=theme())
        self._place = ViewPlace(self)
        self._facts = QLabel(self)
        self._facts.setObjectName("surface.facts")
        self._folder = Path.cwd()
        self._result: AlignedPatch | None = None
        self.commands = make_actions(self._commands(), self)
        self._assemble()
        self._connect()
        self.resize(_FIRST_SIZE)
        self.controller.compute()

    @property
    def view(self) -> View3D:
        """The 3D view; asking for it brings it, if it has not come by itself yet."""
        return self._place.fill()

    def _assemble(self) -> None:
        self.setObjectName("main_window")
        self.setCentralWidget(self._place)
        fill_menu_bar(self.menuBar(), self._table, self.commands)
        self.addToolBar(make_view_bar(self.commands, self))
        self.statusBar().addPermanentWidget(self._facts)
        self._show_location()

    def _connect(self) -> None:
        self._place.filled.connect(self._on_view_came)
        self.session.location_changed.connect(self._show_location)
        self.session.history.cleanChanged.connect(lambda _clean: self._show_location())
        self.session.history.canUndoChanged.connect(self.commands["undo"].setEnabled)
        self.session.history.canRedoChanged.connect(self.commands["redo"].setEnabled)
        self.session.history.undoTextChanged.connect(lambda text: self._name("undo", "&Undo", text))
        self.session.history.redoTextChanged.connect(lambda text: self._name("redo", "&Redo", text))
        self.controller.result_changed.connect(self._on_result_changed)
        self.controller.refused.connect(self.tell)
        QGuiApplication.styleHints().colorSchemeChanged.connect(self._follow_system)

    def _commands(self) -> list[Command]:
        key = QKeySequence.StandardKey
        self._table = [
            Command("open", "&Open…", self.open_dialog, "&File", key.Open),
            *(
                Command(
                    f"preset_{name}",
                    f"{name}  {entry.title}",
                    lambda name=name: self.open_source(f"{PRESET_PREFIX}{name}"),
                    "&File/&Presets of the paper",
                )
                for name, entry in presets().items()
            ),
            Command("save", "&Save", self.save, "&File", key.Save),
            Command("save_as", "Save &As…", self.save_as, "&File", key.SaveAs),
            Command("save_figure", "Save Fi&gure…", self.save_figure, "&File", "Ctrl+G"),
            Command("close", "&Close", self.close, "&File", key.Close),
            Command("undo", "&Undo", self.session.history.undo, "&Edit", key.Undo),
            Command("redo", "&Redo", self.session.history.redo, "&Edit", key.Redo),
            *view_commands(
                self._settings,
                self._set_settings,
                lambda: self._settings,
                self._look,
                self._fit,
            ),
        ]
        return self._table

    # What the window is told

    def _on_view_came(self, view: View3D) -> None:
        view.set_settings(self._settings)
        view.point_dragged.connect(self.controller.drag_point)
        view.drag_cancelled.connect(self.session.cancel)
        view.drag_finished.connect(lambda _gesture: self.statusBar().clearMessage())
        view.point_selected.connect(self._on_point_selected)
        view.fell_back.connect(self._on_fell_back)
        if self._result is not None:
            view.set_result(self._result)
        view.set_camera("paper", animated=False)

    def _on_fell_back(self, reason: str) -> None:
        self.tell(
            f"{reason.rstrip('.')}. The surface is drawn by the 2D painter instead; everything else works.", stay=True
        )

    def _on_point_selected(self, index: tuple[int, int] | None) -> None:
        if index is None:
            self.statusBar().clearMessage()
            return
        i, j = index
        x, y, z = self.session.document.control_points[i, j]
        self.tell(f"P {i},{j} = ({x:.6g}, {y:.6g}, {z:.6g}).  {_DRAG_HINT}", stay=True)

    def _on_result_changed(self, result: AlignedPatch) -> None:
        self._result = result
        document, (degree_u, degree_v) = result.document, result.patch.degree
        n, m = document.samples
        self._facts.setText(f"{document.formulation}   {n} × {m} samples   degree {degree_u} × {degree_v} ")
        if self._place.view is not None:
            self._place.view.set_result(result)

    def _set_settings(self, settings: DisplaySettings) -> None:
        self._settings = settings
        if self._place.view is not None:
            self._place.view.set_settings(settings)

    def _look(self, camera: str) -> None:
        self.view.set_camera(camera)

    def _fit(self) -> None:
        self.view.fit()

    def _follow_system(self) -> None:
        self._set_settings(replace(self._settings, theme=theme()))

    def _name(self, command: str, verb: str, text: str) -> None:
        self.commands[command].setText(f"{verb} {text}".strip())

    def _show_location(self) -> None:
        self.setWindowTitle(f"{self.session.title}[*] - {NAME}")
        self.setWindowModified(self.session.is_changed)
        for name in ("undo", "redo"):
            self.commands[name].setEnabled(getattr(self.session.history, f"can{name.capitalize()}")())

    def tell(self, text: str, *, stay: bool = False) -> None:
        """Say one sentence in the message line."""
        self.statusBar().showMessage(text, 0 if stay else _MESSAGE_MILLISECONDS)

    # What the user asks for

    def open_dialog(self) -> None:
        """Ask for a file and open it."""
        kinds = " ".join(f"*{suffix}" for suffix in READERS)
        name, _ = QFileDialog.getOpenFileName(self, "Open", str(self._folder), f"Documents and workbooks ({kinds})")
        if name:
            self.open_source(name)

    def open_source(self, source: str) -> None:
        """Open a file or a preset, after asking about unsaved changes; what cannot be read changes nothing."""
        if not self._may_leave():
            return
        try:
            self.session.open(source)
        except QovrError as error:
            self.tell(str(error), stay=True)
            return
        if not source.startswith(PRESET_PREFIX):
            self._folder = Path(source).parent
        self.tell(f"Opened {self.session.title}")
        self.view.select(None)
        self.view.fit(animated=False)

    def save(self) -> bool:
        """Save to the document's file, asking for one where there is none; return whether it was saved."""
        if self.session.path is None:
            return self.save_as()
        return self._save_to(self.session.path)

    def save_as(self) -> bool:
        """Ask for a file and save to it; return whether it was saved."""
        first = self._folder / f"{Path(self.session.title).stem}{DOCUMENT_SUFFIX}"
        name, _ = QFileDialog.getSaveFileName(self, "Save As", str(first), f"QOVR documents (*{DOCUMENT_SUFFIX})")
        if not name:
            return False
        path = Path(name)
        return self._save_to(
            path if path.suffix.lower() == DOCUMENT_SUFFIX else path.with_name(path.name + DOCUMENT_SUFFIX)
        )

    def _save_to(self, path: Path) -> bool:
        try:
            self.session.save(path)
        except QovrError as error:
            self.tell(str(error), stay=True)
            return False
        self._folder = path.parent
        self.tell(f"Saved {path.name}")
        return True

    def save_figure(self) -> None:
        """Ask how large and where, and write what is seen."""
        dialog = FigureDialog(self._folder / f"{Path(self.session.title).stem}.png", self)
        if dialog.exec() != FigureDialog.DialogCode.Accepted:
            return
        try:
            self.view.save_figure(dialog.path, dialog.options)
        except QovrError as error:
            self.tell(str(error), stay=True)
            return
        self._folder = dialog.path.parent
        self.tell(f"Saved {dialog.path.name}")

    def _may_leave(self) -> bool:
        """Ask about unsaved changes; return whether the document may go."""
        if not self.session.is_changed:
            return True
        button = QMessageBox.StandardButton
        answer = QMessageBox.question(
            self,
            NAME,
            f"Save the changes to {self.session.title}?",
            button.Save | button.Discard | button.Cancel,
            button.Save,
        )
        if answer == button.Save:
            return self.save()
        return answer == button.Discard

    def closeEvent(self, event: QCloseEvent) -> None:
        if self._may_leave():
            super().closeEvent(event)
        else:
            event.ignore()
