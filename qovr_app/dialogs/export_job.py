"""Export in a thread of its own, so that the window lives while a million points are written."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, QThread, Signal

from qovr_core import Document, QovrError, configure
from qovr_core.files import Format
from qovr_core.files.options import ExportOptions


class _CancelledError(Exception):
    """Raised by the progress to end the writer, which then leaves nothing behind."""


class ExportJob(QThread):
    """Computes a document's surface and writes it in one format. Documents never change, so this is a copy's work.

    Signals
    -------
    progressed : the part done, 0 to 1
    ended : why the file was not written; empty where it was, None where the job was cancelled
    """

    progressed = Signal(float)
    ended = Signal(object)

    def __init__(
        self, document: Document, entry: Format, path: Path, options: ExportOptions, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._entry, self._path, self._options = document, entry, path, options

    def cancel(self) -> None:
        """Ask the job to end as soon as it can."""
        self.requestInterruption()

    def run(self) -> None:
        self.ended.emit(self._outcome())

    def _outcome(self) -> str | None:
        try:
            self._entry.check(self._document, self._path)
            surface = configure(self._document)
            self._report(0.0)
            self._entry.write(surface, self._path, self._report, self._options)
        except _CancelledError:
            return None
        except QovrError as error:
            return f"{error}."
        except MemoryError:
            return "There is not enough memory for so many points; choose fewer samples."
        return ""

    def _report(self, part: float) -> None:
        if self.isInterruptionRequested():
            raise _CancelledError
        self.progressed.emit(part)
