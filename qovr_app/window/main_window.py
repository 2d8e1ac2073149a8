"""The main window: assembles the parts, and lets them come and go."""

from __future__ import annotations

from typing import TYPE_CHECKING

from PySide6.QtCore import QByteArray, QEvent, QPoint, QSize, QTimer
from PySide6.QtGui import QCloseEvent
from PySide6.QtWidgets import QMainWindow, QVBoxLayout, QWidget

from qovr_app.state.display import DisplaySettings
from qovr_app.state.editor_state import DocumentFile, EditorState, first_state
from qovr_app.state.intents import Configured
from qovr_app.state.looking_intents import DisplayChosen, MessageShown
from qovr_app.store import Store
from qovr_app.style.palette import set_theme, theme_in_force
from qovr_app.view3d.viewport import screen_position
from qovr_app.widgets.plain import title_text
from qovr_app.window.actions import Actions
from qovr_app.window.application import NAME
from qovr_app.window.commands import command_table
from qovr_app.window.context_menus import show_context_menu
from qovr_app.window.document_shell import DocumentShell
from qovr_app.window.drops import Drops
from qovr_app.window.export_shell import ExportShell
from qovr_app.window.facts import Facts
from qovr_app.window.field_shell import FieldShell
from qovr_app.window.folder import Folder
from qovr_app.window.help_shell import HelpShell
from qovr_app.window.layout import Layout
from qovr_app.window.layout_shell import LayoutShell
from qovr_app.window.lists import add_lists
from qovr_app.window.menus import fill_menu_bar, make_bars
from qovr_app.window.message_line import MessageLine
from qovr_app.window.outside import FileWatch, OutsideOffer
from qovr_app.window.placing import fit_into_screen, place_beside
from qovr_app.window.preferences import Preferences
from qovr_app.window.preferences_shell import preferences_answers
from qovr_app.window.recovery import RecoveryStore
from qovr_app.window.recovery_offer import RecoveryOffer
from qovr_app.window.recovery_writer import RecoveryWriter
from qovr_app.window.saved_views import SavedViews
from qovr_app.window.shell import Shell
from qovr_app.window.sources import opened_source
from qovr_app.window.window_menu import WindowList, window_answers
from qovr_app.window.windows import Windows
from qovr_app.work.notices import Notices
from qovr_app.work.worker import Worker
from qovr_core.files.sources import PRESET_PREFIX

if TYPE_CHECKING:
    from qovr_app.view3d.view import View3D

_FIRST_SIZE = QSize(1440, 900)
_FIRST_SOURCE = f"{PRESET_PREFIX}fig5"
"""The paper's own example, with which the editor opens."""


class MainWindow(QMainWindow):
    """One document, seen and edited.

    Parameters
    ----------
    source : what to open; None shows the paper's own example
    preferences : what is remembered from one start to the next; None for a window that remembers nothing
    windows : those of this process, which it joins; None for a window by itself

    Raises
    ------
    QovrError : the source cannot be read
    """

    def __init__(
        self, source: str | None = None, preferences: Preferences | None = None, windows: Windows | None = None
    ) -> None:
        super().__init__()
        self.setObjectName("main_window")
        self._preferences, self._is_asked = preferences, False
        self._windows = windows or Windows(MainWindow)
        self.recovery: RecoveryWriter | None = None
        turn = QTimer(self, singleShot=True, interval=0)
        self.store = Store(_first_state(source, preferences), turn.start)
        turn.timeout.connect(self.store.flush)
        self.worker, self._notices = Worker(self), Notices(self)
        self.parts = Layout(self.store, self.worker, self)
        folder, commit = Folder(preferences), self.parts.commit_typed
        self._documents = DocumentShell(
            self.store, self, folder, self.worker, commit_typed=commit, windows=self._windows
        )
        view_writer = self.parts.view_frame.figure_writer
        exports = ExportShell(
            self.store, self, folder, self.worker, preferences, view_writer=view_writer, commit_typed=commit
        )
        self._offer = RecoveryOffer(self._documents, self._windows, self.worker, self)
        self._outside, self._watch = OutsideOffer(self.store, self), FileWatch(self.store, self)
        views = SavedViews(preferences)
        parts = LayoutShell(self.store, self.parts, self, views)
        shell = Shell(
            parts.answers,
            HelpShell(lambda: self._actions, self).answers,
            FieldShell(self.store, self.parts, lambda: self._actions, self).answers,
            window_answers(self._windows, self),
            preferences_answers(self._windows, preferences, self),
            self._documents.answers,
            exports.answers,
            self._offer.answers,
        )
        self.store.answer_with(shell.perform)
        self._actions = Actions(command_table(), self.store, self)
        self._facts = Facts(self)
        self._actions.give_single_keys(self.parts.view_frame)
        self.parts.view_frame.menu_asked.connect(
            lambda wish, at: show_context_menu(wish, at, self._actions, self.store, self)
        )
        self._message = MessageLine(self.store.dispatch, self)
        self._notices.noticed.connect(lambda text: self.store.dispatch(MessageShown(text)))
        self._assemble(folder, views)
        self._restore_layout()
        self.store.dispatch(Configured())
        self.store.flush()
        own = (self._actions.show_state, self._message.show_state, self._outside.show_state, self._facts.show_state)
        for show in (*self.parts.shows, *own, self._show_state):
            self.store.subscribe(show)
        Drops(self, self.store.dispatch)
        self._windows.add(self)

    @property
    def view(self) -> View3D:
        """The 3D view; asking for it brings it, if it has not come by itself yet."""
        return self.parts.view_frame.view

    def screen_position(self, i: int, j: int) -> QPoint:
        """Return where control point (i, j) stands in the view, in global logical pixels, so that others can aim at it.

        Raises
        ------
        IndexError, QovrError : there is no such point, or it cannot be seen
        """
        return screen_position(self.view.viewports[0], self.view.picture(), i, j)

    def protect(self, recovery: RecoveryStore) -> None:
        """Keep what is not saved where a crash does not reach it, and offer what an earlier run left there."""
        self.recovery = RecoveryWriter(recovery, self.worker, self)
        self.recovery.failed.connect(lambda reason: self.store.dispatch(MessageShown(reason, is_refusal=True)))
        self.store.subscribe(self.recovery.show_state)
        self._offer.offer(recovery)

    def _assemble(self, folder: Folder, views: SavedViews) -> None:
        middle = QWidget(self)
        layout = QVBoxLayout(middle)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(make_bars(self._actions, self))
        layout.addWidget(self._offer.notice)
        layout.addWidget(self._outside.notice)
        layout.addWidget(self.parts, 1)
        self.setCentralWidget(middle)
        self.parts.view_frame.setFocus()  # else Qt would choose a field, and with it a point or a knot
        menus = fill_menu_bar(self.menuBar(), self._actions)
        add_lists(menus, self._actions, self.store, folder, views)
        WindowList(self._windows, menus["Window"], self)
        self.statusBar().addWidget(self._message, 1)
        self.statusBar().addPermanentWidget(self._facts)

    def _show_state(self, before: EditorState | None, after: EditorState) -> None:
        if after.display.theme is not theme_in_force().name:
            set_theme(after.display.theme)  # the palette, and so every widget, follows the state
        if before is not None and self._preferences and after.display != before.display:
            self._preferences.note_display(before.display, after.display)
        if before is not None and self._preferences and after.tools != before.tools:
            self._preferences.note_tools(before.tools, after.tools)
        if after.differs(before, "history", "file", "draft", "texts"):
            self.setWindowTitle(f"{title_text(after.file.title)}[*] - {NAME}")
            if after.is_changed is not self.isWindowModified():  # Qt would tell the window manager at every edit
                self.setWindowModified(after.is_changed)

    # Coming and going

    def changeEvent(self, event: QEvent) -> None:
        super().changeEvent(event)
        is_built = self.centralWidget() is not None
        if (
            event.type() == QEvent.Type.PaletteChange
            and is_built
            and self.store.state.display.theme is not theme_in_force().name
        ):
            self.store.dispatch(DisplayChosen("theme", theme_in_force().name))

    def _restore_layout(self) -> None:
        self.resize(_FIRST_SIZE)
        if self._preferences:
            self.restoreGeometry(self._preferences.bytes_of("geometry"))
            for name in self.parts.layout_states():
                self.parts.restore_layout(name, self._preferences.bytes_of(name))
        place_beside(self, self._windows.last_used)
        fit_into_screen(self)
        self._places = self._layout_states()

    def _layout_states(self) -> dict[str, QByteArray]:
        return {"geometry": self.saveGeometry(), **self.parts.layout_states()}

    def _remember_layout(self) -> None:
        """Remember what was moved here: what stayed may have been moved in another copy of the program."""
        for name, state in self._layout_states().items():
            if self._preferences and state != self._places[name]:
                self._preferences.set_bytes(name, state)

    def may_close(self) -> bool:
        """Ask about what is not saved, what is just being typed included; return whether the window may go."""
        self.parts.commit_typed()
        return self._documents.may_leave()

    def leave(self) -> None:
        """Close; what is not saved was asked about."""
        self._is_asked = True
        self.close()

    def closeEvent(self, event: QCloseEvent) -> None:
        if not self._is_asked and not self.may_close():
            event.ignore()
            return
        self._end(keeps_unsaved=False)
        super().closeEvent(event)

    def end(self) -> None:
        """End at once, without a question: what is not saved is offered at the next start."""
        self.parts.commit_typed()
        self.store.flush()
        self._end(keeps_unsaved=True)

    def _end(self, *, keeps_unsaved: bool) -> None:
        self._windows.remove(self)
        self._watch.close()
        self._remember_layout()
        self._offer.release()
        self.worker.close()
        self._notices.close()
        if self.recovery is not None:
            self.recovery.close(is_wanted=keeps_unsaved)


def _first_state(source: str | None, preferences: Preferences | None) -> EditorState:
    """Return the state with which a window begins that shows a source."""
    opened = opened_source(source or _FIRST_SOURCE)
    display = DisplaySettings(theme=theme_in_force().name)
    tools = None
    if preferences:
        display, tools = preferences.display(display), preferences.tools
    file = DocumentFile(opened.title, opened.path, opened.stamp, opened.stamp, opening=int(source is not None))
    return first_state(opened.document, file, display, tools)
