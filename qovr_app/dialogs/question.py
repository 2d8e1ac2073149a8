"""The one way of asking what has to be answered before anything else is done."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QMessageBox, QWidget

Answer = QMessageBox.StandardButton


def ask(parent: QWidget, title: str, text: str, answers: Mapping[Answer, str], default: Answer) -> Answer:
    """Return the answer to a question; leaving it is Cancel, or No.

    Parameters
    ----------
    text : plain text: what is said may hold names of files
    answers : the buttons, and what they say; empty leaves the system's own word
    """
    box = QMessageBox(parent)
    box.setIcon(QMessageBox.Icon.Question)
    box.setWindowTitle(title)
    box.setTextFormat(Qt.TextFormat.PlainText)
    box.setText(text)
    for answer, word in answers.items():
        button = box.addButton(answer)
        if word:
            button.setText(word)
    box.setDefaultButton(default)
    box.exec()
    pressed = box.standardButton(box.clickedButton())
    box.deleteLater()
    return pressed if pressed in answers else Answer.Cancel
