"""An editor that edits, saves and exports without end, to be killed at any moment.

It prints a line ``set JSON`` for every document right before it is set, and ``kept`` whenever the last one is known to
be on the disk.
"""

import random
import sys
from pathlib import Path

import numpy as np
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLineEdit

from qovr_app.dialogs.export_dialog import ExportDialog
from qovr_app.main import create_window
from qovr_app.window.application import make_application
from qovr_app.window.recovery import recovery_folder
from qovr_core.edits import Direction, KnotPlace, linked_places, set_values
from qovr_core.files import ExportOptions
from qovr_core.files.qovr_document import document_to_json
from support.editor import Editor, name_of, wait_until
from support.recovery_reader import kept_in


def lies_in_recovery(document):
    """Return whether the recovery folder holds a document as unsaved."""
    kept = (kept_in(file)[1][0] for file in recovery_folder().glob("*.unsaved"))
    wanted = [document.control_points, document.row_knots.array, document.column_knots.array]
    return any(all(map(np.array_equal, arrays.values(), wanted)) for arrays in kept)


def main():
    folder, seed = Path(sys.argv[1]), int(sys.argv[2])
    random.seed(seed)
    make_application(["victim"])
    editor = Editor(create_window(str(folder / "kept.qovr")), (900, 600))
    print("ready", flush=True)
    while True:
        place = KnotPlace(Direction.ROWS, random.randrange(5), random.choice("rsut"))
        value = f"{random.uniform(0.1, 0.9):.6f}"
        linked = linked_places(editor.document, place, curves=True, directions=False)
        following = set_values(editor.document, dict.fromkeys(linked, float(value)))
        print("set", document_to_json(following).replace("\n", " "), flush=True)
        editor.type_into(name_of(place), value)
        assert editor.document == following
        if random.random() < 0.5:
            QTest.qWait(1)
            wait_until(lambda document=following: lies_in_recovery(document))
            print("kept", flush=True)
        if random.random() < 0.3:
            editor.trigger("save")
        if random.random() < 0.3:
            window = editor.window
            dialog = ExportDialog(editor.document, folder / "kept", window.worker, ExportOptions(), window)
            path = dialog.findChild(QLineEdit, "export.path")
            path.selectAll()
            QTest.keyClicks(path, str(folder / f"kept{random.choice(['.xlsx', '.npz', '.csv'])}"))
            dialog.findChild(QAbstractButton, "export.start").click()
            QApplication.processEvents()


if __name__ == "__main__":
    main()
