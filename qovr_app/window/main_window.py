"""The main window: wiring, and the commands that need a window."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QCloseEvent, QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QLabel, QMainWindow, QVBoxLayout, QWidget

from qovr_app.dialogs.help_dialog import HelpDialog
from qovr_app.laboratory.dock import check_shown, laboratory_commands
from qovr_app.state.display import ColourRange, DisplaySettings, LayerChoice
from qovr_app.style.palette import theme_in_force
from qovr_app.window.actions import make_actions
from qovr_app.window.application import NAME
from qovr_app.window.colour_desk import ColourDesk
from qovr_app.window.controller import Controller, State
from qovr_app.window.desk import Desk
from qovr_app.window.layout import Workspace
from qovr_app.window.menus import RecentMenu, fill_menu_bar, make_edit_bar, make_view_bar
from qovr_app.window.message_line import MessageLine
from qovr_app.window.preferences import Preferences
from qovr_app.window.recovery import Keeper, RecoveryStore
from qovr_app.window.session import Session
from qovr_app.window.view_changes import change, select
from qovr_app.window.view_commands import view_commands
from qovr_app.window.window_commands import go_commands, help_commands, window_commands
from qovr_app.work.notices import Notices
from qovr_app.work.worker import Worker
from qovr_core import Document, Evaluation, Formulation
from qovr_core.files import readable_suffixes
from qovr_core.presets import figure_cases

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D

_FIRST_SIZE = QSize(1440, 900)
_DRAG_HINT = "Drag: in the view plane. Hold X, Y or Z: along that axis. Esc: put the point back."


class MainWindow(QMainWindow):
    """One document, seen and edited.

    Parameters
    ----------
    source : what to open; None shows the paper's own example
    preferences : what is remembered from one start to the next; None for a window that remembers nothing

    Raises
    ------
    QovrError : the source cannot be read
    """

    def __init__(self, source: str | None = None, preferences: Preferences | None = None) -> None:
        super().__init__()
        self.setObjectName("main_window")
        self.setAcceptDrops(True)
        self.session = Session(self)
        if source is not None:
            self.session.open(source)
        self.controller = Controller(self.session, self)
        self.worker = Worker(self)
        self._notices = Notices(self)
        self._preferences = preferences
        self._settings = DisplaySettings(theme=theme_in_force().name)
        if preferences:
            self._settings = preferences.display(self._settings)
        self.workspace = Workspace(self.controller, self.worker, self)
        self.desk = Desk(self.session, self.controller, lambda: self.view, preferences, self, worker=self.worker)
        self.colours = ColourDesk(self.session, self.controller, lambda: self.view, self)
        self._keeper: Keeper | None = None
        self._shown: tuple[Evaluation, Document] | None = None
        self._help: HelpDialog | None = None
        self._facts = QLabel(self, objectName="surface.facts")
        self._message = MessageLine(self)
        self._make_commands()
        self._assemble()
        self._connect()
        self._restore_layout()
        self.link_curves(True)
        self.controller.configure()

    @property
    def view(self) -> View3D:
        """The 3D view; asking for it brings it, if it has not come by itself yet."""
        return self.workspace.place.fill()

    def protect(self, store: RecoveryStore) -> None:
        """Keep what is not saved where a crash does not reach it, and offer what an earlier run left there."""
        self._keeper = Keeper(self.session, store, self.worker, self)
        self._keeper.failed.connect(lambda reason: self.tell(reason, refused=True))
        self.desk.offer(store)

    def _make_commands(self) -> None:
        self._table = [
            *window_commands(self),
            *view_commands(self._set_settings, lambda: self._settings, self._look, self._fit, self._ask_range),
            *go_commands(self),
            *laboratory_commands(self.workspace.laboratory),
            *self.colours.commands(),
            *help_commands(self),
        ]
        self.commands = make_actions(self._table, self)
        self.workspace.laboratory.use_commands(self.commands)

    def _assemble(self) -> None:
        self.workspace.add_bars(make_edit_bar(self.commands, self), make_view_bar(self.commands, self))
        middle = QWidget(self)
        layout = QVBoxLayout(middle)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.desk.notice)
        layout.addWidget(self.workspace, 1)
        self.setCentralWidget(middle)
        menus = fill_menu_bar(self.menuBar(), self._table, self.commands)
        presets = menus["File/Presets of the paper"].menuAction()
        menus["File"].insertMenu(presets, RecentMenu(self.desk, self))
        self.statusBar().addWidget(self._message, 1)
        self.statusBar().addPermanentWidget(self._facts)
        self._show_location()

    def _connect(self) -> None:
        space, surface, history = self.workspace, self.workspace.surface, self.session.history
        space.place.filled.connect(self._on_view_came)
        space.points.point_focused.connect(self._on_point_focused)
        surface.export_requested.connect(self.export)
        surface.figure_requested.connect(self.desk.save_figure)
        space.laboratory.panel_changed.connect(lambda name: check_shown(self.commands, name))
        space.laboratory.document_requested.connect(self.desk.open_document)
        space.laboratory.figure_requested.connect(self.desk.save_drawing)
        space.laboratory.told.connect(lambda text, refused: self.tell(text, refused=refused))
        space.laboratory.comparison_requested.connect(self.colours.show_comparison)
        space.focus_changed.connect(self.colours.focus_on)
        self.colours.told.connect(self.tell)
        self._notices.noticed.connect(self.tell)
        self.desk.told.connect(lambda text, refused: self.tell(text, refused=refused))
        self.desk.opened.connect(self._on_opened)
        self.session.opened.connect(space.drop_text)
        self.session.document_changed.connect(self._message.outdate)
        self.session.location_changed.connect(self._show_location)
        history.cleanChanged.connect(self._show_location)
        history.canUndoChanged.connect(self.commands["undo"].setEnabled)
        history.canRedoChanged.connect(self.commands["redo"].setEnabled)
        history.undoTextChanged.connect(self._on_undo_text_changed)
        history.redoTextChanged.connect(self._on_redo_text_changed)
        self.controller.evaluation_changed.connect(self._on_evaluation_changed)
        self.controller.state_changed.connect(self._on_state_changed)
        self.controller.refused.connect(lambda text: self.tell(text, refused=True))

    # What the window is told

    def _on_view_came(self, view: View3D) -> None:
        change(view, settings=self._settings)
        self.colours.on_view_came(view)
        view.point_dragged.connect(lambda *_drag: change(view, dragging=True))
        view.point_dragged.connect(self.controller.drag_point)
        view.drag_cancelled.connect(self.session.cancel)
        view.drag_finished.connect(lambda _gesture: self._message.clear())
        for ended in (view.drag_cancelled, view.drag_finished):
            ended.connect(lambda _gesture: change(view, dragging=False))
        view.point_selected.connect(self._on_point_selected)
        view.fell_back.connect(self._on_fell_back)
        if self._shown is not None:
            change(view, evaluation=self._shown[0], document=self._shown[1])
        view.set_camera("paper", animated=False)

    def _on_fell_back(self, reason: str) -> None:
        self.tell(f"{reason.rstrip('.')}. The surface is drawn by the 2D painter instead; everything else works.")

    def _on_point_selected(self, index: tuple[int, int] | None) -> None:
        self.workspace.points.mark_point(index)
        select(self.view, index)
        self.workspace.set_focus(index)
        if index is None:
            self._message.clear()
            return
        self.tell("P {},{}.  {}".format(*index, _DRAG_HINT))

    def _on_point_focused(self, i: int, j: int) -> None:
        self.workspace.points.mark_point((i, j))
        if self.workspace.place.view is not None:
            select(self.workspace.place.view, (i, j))

    def _on_opened(self, preset: str) -> None:
        self.workspace.points.mark_point(None)
        select(self.view, None)
        cameras = {case.camera for case in figure_cases().values() if case.preset.name == preset}
        if len(cameras) == 1:
            self.view.set_camera(cameras.pop(), animated=False)
        else:
            self.view.fit(animated=False)

    def _on_evaluation_changed(self, evaluation: Evaluation, document: Document) -> None:
        before = self._shown[0].document.formulation if self._shown else Formulation.PUBLISHED
        self._shown = (evaluation, document)
        if evaluation.document.formulation != before:
            self._show_layer_in_place(evaluation)
        if self.workspace.place.view is not None:
            change(self.workspace.place.view, evaluation=evaluation, document=document)

    def _show_layer_in_place(self, evaluation: Evaluation) -> None:
        """Show the layer that lies on the control net, unless both are shown."""
        layer = evaluation.document.formulation.resting_layer
        if self._settings.layer not in (LayerChoice.BOTH, layer):
            self.commands[f"layer_{layer}"].trigger()

    def _on_state_changed(self, state: State) -> None:
        self.commands["export"].setEnabled(not state.is_stale)
        if state.evaluation is None:
            self._facts.setText("no surface ")
            return
        (degree_u, degree_v), (n, m) = state.evaluation.degree, state.evaluation.document.samples
        stale = "stale   " if state.is_stale else ""
        name = state.evaluation.document.formulation
        self._facts.setText(f"{stale}{name}   {n} × {m} samples   degree {degree_u} × {degree_v} ")

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        is_built = self.centralWidget() is not None
        if event.type() == QEvent.Type.PaletteChange and is_built and self._settings.theme is not theme_in_force().name:
            self._set_settings(replace(self._settings, theme=theme_in_force().name))

    def _on_undo_text_changed(self, text: str) -> None:
        self._name("undo", "&Undo", text)

    def _on_redo_text_changed(self, text: str) -> None:
        self._name("redo", "&Redo", text)

    def _name(self, command: str, verb: str, text: str) -> None:
        self.commands[command].setText(f"{verb} {text}".strip())
        self.commands[command].setToolTip(f"{verb} {text}".replace("&", "").strip())
        self.commands[command].setIconText(verb.replace("&", ""))

    def _show_location(self) -> None:
        self.setWindowTitle(f"{self.session.title}[*] - {NAME}")
        self.setWindowModified(self.session.is_changed)
        for name in ("undo", "redo"):
            self.commands[name].setEnabled(getattr(self.session.history, f"can{name.capitalize()}")())

    def tell(self, text: str, *, refused: bool = False) -> None:
        """Say one sentence in the message line."""
        self._message.say(text, is_refusal=refused)

    # What the user asks for

    def link_curves(self, is_linked: bool) -> None:
        """Choose whether the five curves of a direction share their knots from now on."""
        self.controller.link_curves(is_linked)
        self._show_links()

    def link_directions(self, is_linked: bool) -> None:
        """Choose whether rows and columns share their knots from now on."""
        self.controller.link_directions(is_linked)
        self._show_links()

    def _show_links(self) -> None:
        curves, directions = (self.commands[name].isChecked() for name in ("link_curves", "link_directions"))
        for zone in (self.workspace.rows, self.workspace.columns):
            zone.set_links(curves=curves, directions=directions)

    def save(self) -> None:
        """Save the document, with what is just being typed."""
        self.workspace.commit_typed()
        self.desk.save()

    def save_as(self) -> None:
        """Save the document, with what is just being typed, to another file."""
        self.workspace.commit_typed()
        self.desk.save_as()

    def export(self) -> None:
        """Export the configured surface, with what is just being typed where edits are live."""
        self.workspace.commit_typed()
        self.controller.settle()
        self.desk.export()

    def show_help(self) -> None:
        """Show the help beside the work."""
        if self._help is None:
            self._help = HelpDialog(self)
        self._help.show()
        self._help.raise_()

    def focus_view(self) -> None:
        """Bring the keyboard to the 3D view."""
        self.view.viewports[0].widget.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def _look(self, camera: str) -> None:
        self.view.set_camera(camera)

    def _fit(self) -> None:
        self.view.fit()

    def _ask_range(self) -> None:
        limits = self.colours.asked_range(self._settings)
        if limits is not None:
            self._set_settings(replace(self._settings, colour_range=ColourRange.FIXED, fixed_range=limits))
        self.commands[f"colour_range_{self._settings.colour_range}"].setChecked(True)

    def _set_settings(self, settings: DisplaySettings) -> None:
        self._settings = settings
        if self.workspace.place.view is not None:
            change(self.workspace.place.view, settings=settings)

    # Coming and going

    def _restore_layout(self) -> None:
        self.resize(_FIRST_SIZE)
        if self._preferences:
            self.restoreGeometry(self._preferences.bytes_of("geometry"))
            for name in self.workspace.layout_states():
                self.workspace.restore_layout(name, self._preferences.bytes_of(name))

    def _remember_layout(self) -> None:
        if self._preferences:
            self._preferences.set_bytes("geometry", self.saveGeometry())
            for name, state in self.workspace.layout_states().items():
                self._preferences.set_bytes(name, state)
            self._preferences.set_display(self._settings)

    def dragEnterEvent(self, event: QDragEnterEvent) -> None:
        if _dropped_source(event):
            event.acceptProposedAction()

    def dropEvent(self, event: QDropEvent) -> None:
        event.acceptProposedAction()
        self.desk.open_source(_dropped_source(event))

    def closeEvent(self, event: QCloseEvent) -> None:
        self.workspace.commit_typed()
        if not self.desk.may_leave():
            event.ignore()
            return
        self._remember_layout()
        self.desk.release()
        self.worker.close()
        self._notices.close()
        if self._keeper is not None:
            self._keeper.close()
        super().closeEvent(event)


def _dropped_source(event: QDropEvent) -> str:
    """Return the first dropped file that can be opened; empty where there is none."""
    paths = (url.toLocalFile() for url in event.mimeData().urls())
    return next((path for path in paths if path.lower().endswith(readable_suffixes())), "")
