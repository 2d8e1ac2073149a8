"""What the dialogs that write a file have in common: they stay until it is written, and say what goes wrong."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractButton, QDialog, QProgressBar, QWidget

from qovr_app.widgets.parts import named, words
from qovr_app.work.job import Job
from qovr_app.work.worker import Worker

_PROGRESS_PARTS = 1000


class WritingDialog(QDialog):
    """Has a file written by a job; ``note`` says how it went, ``bar`` how far it is.

    A dialog of this kind makes ``inputs``, what cannot be used while a job is being done, and ``cancel_button``, what
    cancels the job.

    Signals
    -------
    written : the path
    """

    written = Signal(object)

    inputs: list[QWidget]
    cancel_button: QAbstractButton

    def __init__(self, name: str, title: str, worker: Worker, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(title)
        self.setObjectName(name)
        self._worker = worker
        self._job: Job | None = None
        self.note = words(f"{name}.note", self)
        self.bar = named(QProgressBar(self), f"{name}.progress")
        self.bar.setVisible(False)

    @property
    def is_writing(self) -> bool:
        """Whether a job is being done."""
        return self._job is not None

    def write(self, function: Callable[..., object], *values: Any, path: Path) -> None:
        """Have a job write a path."""
        self._set_writing(True)
        self._job = self._worker.run(
            function,
            *values,
            on_progress=self._show_progress,
            on_done=lambda _: self._on_done(path),
            on_failed=lambda error: self._stop(f"{error}."),
            target=path,
        )

    def reject(self) -> None:
        if self._job is None:
            super().reject()
        else:
            path = self._job.target
            self.cancel_button.setEnabled(False)
            self.note.setText("Cancelling…")
            self._job.cancel(lambda was_done: self._on_cancelled(path, was_done))

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() == Qt.Key.Key_Escape:
            self.reject()
        else:
            super().keyPressEvent(event)

    def _show_progress(self, part: float) -> None:
        self.bar.setRange(0, _PROGRESS_PARTS)
        self.bar.setValue(round(part * _PROGRESS_PARTS))

    def _set_writing(self, is_writing: bool) -> None:
        for widget in self.inputs:
            widget.setEnabled(not is_writing)
        self.cancel_button.setEnabled(True)
        self.bar.setRange(0, 0)  # until the job says how far it is
        self.bar.setVisible(is_writing)

    def _on_done(self, path: Path) -> None:
        self._set_writing(False)
        self._job = None
        self.written.emit(path)
        self.accept()

    def _on_cancelled(self, path: Path | None, was_done: bool) -> None:
        if was_done and path is not None:
            self._on_done(path)
        else:
            self._stop("Cancelled; nothing was written.")

    def _stop(self, reason: str) -> None:
        self._set_writing(False)
        self._job = None
        self.note.setText(reason)
