"""Export Data: which format, what it keeps, where to, and how far it is."""

from __future__ import annotations

import os
from math import prod
from pathlib import Path

from PySide6.QtCore import QSignalBlocker, QSize, Qt
from PySide6.QtWidgets import (
    QDialogButtonBox,
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QLineEdit,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from qovr_app.dialogs.buttons import without_icons
from qovr_app.dialogs.export_choices import ExportChoices
from qovr_app.dialogs.format_list import FormatList
from qovr_app.dialogs.room import resize_within_screen
from qovr_app.dialogs.target import ask_for_target, stands
from qovr_app.dialogs.writing_dialog import WritingDialog
from qovr_app.widgets.parts import named
from qovr_app.work.worker import Worker
from qovr_core import Document, QovrError
from qovr_core.document import Window
from qovr_core.edits import extract_window
from qovr_core.files import FORMATS, ExportOptions, find_format
from qovr_core.files.formats import export

_WIDTH = 760
_COLUMN_GAP = 16
_FIRST_FORMAT = ".xlsx"


class ExportDialog(WritingDialog):
    """Writes one configured document in a format of the one table of formats.

    Parameters
    ----------
    first : the unit, axis and dialect that are chosen first
    window : the window of a net that may be written by itself
    """

    def __init__(
        self,
        document: Document,
        stem: Path,
        worker: Worker,
        first: ExportOptions,
        parent: QWidget | None = None,
        *,
        window: Window = (0, 0),
    ) -> None:
        super().__init__("export", "Export Data", worker, parent)
        self._whole, self._alone = document, extract_window(document, window)
        self._formats = FormatList("export.format", self)
        self._formats.choose(_FIRST_FORMAT)
        self._choices = ExportChoices(document, first, self, window=window)
        self._path = named(QLineEdit(str(stem.with_suffix(_FIRST_FORMAT)), self), "export.path")
        self._browse = named(QPushButton("&Browse…", self), "export.browse")
        self._buttons = QDialogButtonBox(self)
        start = self._buttons.addButton("&Export", QDialogButtonBox.ButtonRole.AcceptRole)
        self._start = named(start, "export.start")
        self.cancel_button = named(self._buttons.addButton(QDialogButtonBox.StandardButton.Cancel), "export.cancel")
        self.inputs = [self._formats, self._choices, self._path, self._browse, self._start]
        self._arrange()
        self._connect()
        self._describe()

    @property
    def path(self) -> Path | None:
        """Where to, with the chosen format's suffix; None where no file is named."""
        text = self._path.text().strip()
        path = Path(text)
        if not path.name or text.endswith(("/", os.sep)):
            return None
        entry = self._formats.entry
        return path if find_format(path) is entry else path.with_name(path.name + entry.suffix)

    @property
    def conventions(self) -> ExportOptions:
        """The unit, axis and dialect that are chosen."""
        return self._choices.conventions

    @property
    def _document(self) -> Document:
        """What is to be written: the whole net, or one window by itself."""
        return self._alone if self._choices.is_window else self._whole

    def _arrange(self) -> None:
        grid = QGridLayout()
        file_label = QLabel("&File", self)
        file_label.setBuddy(self._path)
        grid.addWidget(file_label, 0, 0)
        grid.addWidget(self._path, 0, 1)
        grid.addWidget(self._browse, 0, 2)
        upper = QHBoxLayout()
        upper.setSpacing(_COLUMN_GAP)
        upper.addWidget(self._formats)
        upper.addWidget(self._choices, 1, Qt.AlignmentFlag.AlignTop)
        layout = QVBoxLayout(self)
        layout.addLayout(upper, 1)
        layout.addLayout(grid)
        layout.addWidget(self.note)
        layout.addWidget(self.bar)
        layout.addWidget(without_icons(self._buttons))
        resize_within_screen(self, QSize(_WIDTH, self.sizeHint().height()))

    def _connect(self) -> None:
        self._formats.currentItemChanged.connect(self._on_format_chosen)
        self._formats.itemActivated.connect(lambda *_: self._run())
        self._path.textEdited.connect(self._on_path_typed)
        self._choices.choices_changed.connect(self._describe)
        self._browse.clicked.connect(self._on_browse)
        self._buttons.accepted.connect(self._run)
        self._buttons.rejected.connect(self.reject)

    def _on_format_chosen(self) -> None:
        path = Path(self._path.text())
        if find_format(path):
            path = path.with_suffix(self._formats.entry.suffix)
        self._path.setText(str(path))
        self._describe()

    def _on_path_typed(self, text: str) -> None:
        if found := find_format(Path(text)):
            with QSignalBlocker(self._formats):
                self._formats.choose(found.suffix)
        self._describe()

    def _describe(self) -> None:
        self._choices.describe(self._formats.entry, holds_net=self._holds_net())
        n, m = self._document.samples
        parts = [f"{n} × {m} samples, {prod(self._document.samples):,} points."]
        if announcement := self._formats.entry.announce(self._document):
            parts = [f"{announcement}."]
        path = self.path
        if path is not None and stands(path):
            parts.append(f"{path.name} exists and will be replaced.")
        refusal = self._refusal(path)
        self.note.setText(refusal or "  ".join(parts))
        self._start.setEnabled(path is not None and not refusal)

    def _holds_net(self) -> bool:
        """Return whether the chosen format can hold the document with all its windows."""
        try:
            self._formats.entry.check(self._whole, self.path or Path(f"surface{self._formats.entry.suffix}"))
        except QovrError:
            return self._whole.is_one_window
        return True

    def _refusal(self, path: Path | None) -> str:
        """Return why the document cannot be written so; empty where it can."""
        try:
            self._choices.options(self._formats.entry)
            if path is not None:
                self._formats.entry.check(self._document, path)
        except QovrError as error:
            return f"{error}."
        return ""

    def _on_browse(self) -> None:
        kinds = {entry.suffix: entry.name for entry in FORMATS.values()}
        others = {suffix for entry in FORMATS.values() for suffix in entry.other_suffixes}
        first = self.path or Path(f"surface{self._formats.entry.suffix}")
        target = ask_for_target(
            self, "Export Data", first, kinds, other_suffixes=others, asks_to_replace=False
        )  # the note says what is there
        if target is not None:
            self._path.setText(str(target))
            self._on_path_typed(str(target))

    def _run(self) -> None:
        path = self.path
        if self.is_writing or path is None:
            return
        said = self.note.text()
        self._describe()
        if not self._start.isEnabled() or (stands(path) and self.note.text() != said):
            return  # what has come there since it was last said is said first
        options = self._choices.options(self._formats.entry)
        self.write(export, self._document, path, options, path=path)
