"""The reference picture under the net: asks for its file and for its place."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtGui import QImage
from PySide6.QtWidgets import QDialog, QFileDialog, QWidget

from qovr_app.state import view_requests
from qovr_app.state.display import Underlay
from qovr_app.state.looking_intents import DisplayChosen, MessageShown
from qovr_app.store import Store
from qovr_app.window.preferences import home_folder
from qovr_app.window.shell import Answers
from qovr_core import Document

_KINDS = "Pictures (*.png *.jpg *.jpeg)"


class UnderlayShell:
    """Asks for a picture and where it lies; it is remembered with the window alone."""

    def __init__(self, store: Store, window: QWidget) -> None:
        self._store, self._window = store, window
        self.answers: Answers = {
            view_requests.UnderlayAsked: self._ask_file,
            view_requests.UnderlayPlaceAsked: self._ask_place,
        }

    def _ask_file(self, _request: view_requests.UnderlayAsked) -> None:
        name, _ = QFileDialog.getOpenFileName(self._window, "Reference Picture", str(self._folder), _KINDS)
        if not name:
            return
        from qovr_app.view3d.painter.underlay import underlay_image

        image = underlay_image(name)
        if image is None:
            text = f"{Path(name).name} holds no picture that can be read; expected a PNG or JPEG file."
            self._store.dispatch(MessageShown(text, is_refusal=True))
            return
        self._store.dispatch(DisplayChosen("underlay", _fitted(name, image, self._store.state.document)))
        text = f"{Path(name).name} lies under the net. View, Reference picture, Place says where, and how clearly."
        self._store.dispatch(MessageShown(text))

    @property
    def _folder(self) -> Path:
        """Where a picture may be: with the one before, or with the document."""
        state = self._store.state
        if state.display.underlay is not None:
            return Path(state.display.underlay.path).parent
        return home_folder() if state.file.path is None else state.file.path.parent

    def _ask_place(self, _request: view_requests.UnderlayPlaceAsked) -> None:
        underlay = self._store.state.display.underlay
        if underlay is None:
            return
        from qovr_app.dialogs.underlay_dialog import UnderlayDialog

        dialog = UnderlayDialog(underlay, self._window)
        if dialog.exec() == QDialog.DialogCode.Accepted:
            self._store.dispatch(DisplayChosen("underlay", dialog.underlay))
        dialog.deleteLater()


def _fitted(path: str, image: QImage, document: Document) -> Underlay:
    """Return a picture in its own proportions about the middle of the net, as large as the net at least."""
    low, high = (getattr(document.control_points[..., :2], end)(axis=(0, 1)) for end in ("min", "max"))
    size = high - low
    pixel = max(size[0] / image.width(), size[1] / image.height()) or 1 / max(image.width(), image.height())
    width, height = float(pixel * image.width()), float(pixel * image.height())
    left, bottom = ((low + high - [width, height]) / 2).tolist()
    return Underlay(path, left, bottom, width, height)
