"""An editor that edits, saves and exports without end, to be killed at any moment.

It prints a line ``set JSON`` for every document right after it was set and had its turn of the event loop.
"""

import random
import sys
from pathlib import Path

from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication

from qovr_app.appearance import make_application
from qovr_app.desk import ExportDialog
from qovr_app.main import create_window
from qovr_core.files.qovr_document import document_to_json
from support.editor import Editor


def main():
    folder, seed = Path(sys.argv[1]), int(sys.argv[2])
    random.seed(seed)
    make_application(["victim"])
    editor = Editor(create_window(str(folder / "kept.qovr")), (900, 600))
    print("ready", flush=True)
    while True:
        value = f"{random.uniform(0.1, 0.9):.6f}"
        editor.type_into(f"row_knots.C_{random.randrange(5)}.{random.choice('rsut')}", value)
        QTest.qWait(1)
        print("set", document_to_json(editor.document).replace("\n", " "), flush=True)
        if random.random() < 0.3:
            editor.window.desk._save_to(folder / "kept.qovr")
        if random.random() < 0.3:
            dialog = ExportDialog(editor.document, folder / "kept", editor.window)
            dialog._choose(random.choice([".xlsx", ".npz", ".csv"]))
            dialog._run()
            QApplication.processEvents()


if __name__ == "__main__":
    main()
