"""The command ``qovr`` with something going on in its window, to be sent signals.

It says ``ready`` when that goes on.
"""

import sys

from PySide6.QtCore import QTimer

from qovr_app import main as program
from qovr_app.state.intents import ValuesEdited
from qovr_core.edits import CoordinatePlace
from support.jobs import report_until_cancelled

HEIGHT = 0.625


def main():
    going_on = sys.argv.pop(1)
    create = program.create_window

    def create_window(path):
        window = create(path)
        QTimer.singleShot(500, window, lambda: begin(window, going_on))
        return window

    program.create_window = create_window
    program.main()


def begin(window, going_on):
    window.store.dispatch(ValuesEdited({CoordinatePlace(2, 2, 2): HEIGHT}))
    if going_on == "job":
        window.worker.run(report_until_cancelled, on_progress=lambda _: print("ready", flush=True))
    elif going_on == "question":
        QTimer.singleShot(300, window, lambda: print("ready", flush=True))
        window.close()
    else:
        print("ready", flush=True)


if __name__ == "__main__":
    main()
