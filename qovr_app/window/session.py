"""The session: one document, where it is kept, and its history; the only place that changes any of them."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QUndoCommand, QUndoStack

from qovr_core import Document
from qovr_core.files import read_source, write_document
from qovr_core.files.sources import PRESET_PREFIX
from qovr_core.presets import preset

FIRST_PRESET = "fig5"
"""The paper's own example, with which the editor opens."""

DOCUMENT_SUFFIX = ".qovr"


class _Replace(QUndoCommand):
    """One step of the history: the document before and after it."""

    def __init__(self, session: Session, text: str, after: Document, gesture: int | None) -> None:
        super().__init__(text)
        self._session = session
        self.before, self.after = session.document, after
        self.gesture = gesture
        self.is_cancelled = False

    def redo(self) -> None:
        self._session._show(self.after)

    def undo(self) -> None:
        self._session._show(self.before)
        self.setObsolete(self.is_cancelled)


class Session(QObject):
    """A document with its file and its undo history.

    Signals
    -------
    document_changed : before and after, two Documents; also when a file is opened
    location_changed : the file or the title is another one
    opened : the document is another one altogether, with a history of its own
    """

    document_changed = Signal(object, object)
    location_changed = Signal()
    opened = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self.history = QUndoStack(self)
        self._document = preset(FIRST_PRESET).document
        self._path: Path | None = None
        self._title = FIRST_PRESET

    @property
    def document(self) -> Document:
        """The active state."""
        return self._document

    @property
    def path(self) -> Path | None:
        """The ``.qovr`` file that Save writes; None where the document has none yet."""
        return self._path

    @property
    def title(self) -> str:
        """What to call the document in a window's title."""
        return self._title

    @property
    def is_changed(self) -> bool:
        """Whether there is something that was never saved."""
        return not self.history.isClean()

    def apply(self, text: str, document: Document, gesture: int | None = None) -> None:
        """Make a document the active state, as one named step that can be undone.

        Parameters
        ----------
        text : the step's name, as "Move P 2,3"
        gesture : a number that all steps of one drag share; they become one step
        """
        if document == self._document:
            return
        step = self._step_of(gesture)
        if step is None:
            self.history.push(_Replace(self, text, document, gesture))
        elif document == step.before:
            self.cancel(gesture)
        else:
            # Not by Qt's merging of commands: PySide keeps what was merged for ever.
            step.after = document
            self._show(document)

    def cancel(self, gesture: int) -> None:
        """Take a gesture back as if it had never been."""
        step = self._step_of(gesture)
        if step is not None:
            step.is_cancelled = True
            self.history.undo()

    def _step_of(self, gesture: int | None) -> _Replace | None:
        """Return the last step where it is a gesture's own and can still grow; a saved one cannot."""
        is_last = 0 < self.history.index() == self.history.count()
        if gesture is None or not is_last or self.history.isClean():
            return None
        step = self.history.command(self.history.index() - 1)
        return step if isinstance(step, _Replace) and step.gesture == gesture else None

    def open(self, source: str) -> None:
        """Open a ``.qovr`` file, a workbook in the published layout, or ``paper:NAME``.

        Raises
        ------
        QovrError : the source cannot be read; the session stays as it was
        """
        document = read_source(source)
        is_preset = source.startswith(PRESET_PREFIX)
        path = None if is_preset else Path(source).resolve()
        self._title = source.removeprefix(PRESET_PREFIX) if path is None else path.name
        self._path = path if path and path.suffix.lower() == DOCUMENT_SUFFIX else None
        self.history.clear()
        self._begin(document)

    def start(self, document: Document, title: str) -> None:
        """Go on with a new document, which has no file yet."""
        self._title, self._path = title, None
        self.history.clear()
        self._begin(document)

    def restore(self, document: Document, title: str, path: Path | None) -> None:
        """Go on with a document that was never saved to its file."""
        self._title, self._path = title, path
        self.history.clear()
        self.history.resetClean()
        self._begin(document)

    def save(self, path: Path | None = None) -> None:
        """Write the document to its file, or to another that becomes its file.

        Raises
        ------
        FileError : the file cannot be written; nothing changes
        ValueError : there is no file yet and none is given
        """
        target = path or self._path
        if target is None:
            raise ValueError("the document has no file yet; expected a path to save it to")
        write_document(self._document, target)
        self._path, self._title = target.resolve(), target.name
        self.history.setClean()
        self.location_changed.emit()

    def _begin(self, document: Document) -> None:
        self._show(document)
        self.opened.emit()
        self.location_changed.emit()

    def _show(self, document: Document) -> None:
        before, self._document = self._document, document
        if before != document:
            self.document_changed.emit(before, document)
