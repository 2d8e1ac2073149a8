"""What the tests of jobs hear of them, and the processes they find."""

import os
import sys
from pathlib import Path

from PySide6.QtCore import QThread


class Heard(list):
    """What was told of one job, as (kind, values)."""

    def callbacks(self):
        return {f"on_{kind}": self._hear(kind) for kind in ("progress", "done", "failed")}

    def _hear(self, kind):
        def hear(*values):
            assert QThread.isMainThread()
            self.append((kind, *values))

        return hear

    @property
    def is_over(self):
        return any(kind in ("done", "failed") for kind, *_ in self)

    @property
    def result(self):
        (last,) = [value for kind, value, *_ in self if kind == "done"]
        return last

    @property
    def error(self):
        (last,) = [value for kind, value, *_ in self if kind == "failed"]
        return last


def children():
    """Return the process ids of this process's living children that are workers."""
    found = []
    for entry in Path("/proc").glob("[0-9]*/stat") if sys.platform == "linux" else []:
        try:
            fields = entry.read_text().rpartition(")")[2].split()
            line = entry.with_name("cmdline").read_bytes()
        except OSError:
            continue
        if int(fields[1]) == os.getpid() and b"qovr_app.work" in line and fields[0] != "Z":
            found.append(int(entry.parent.name))
    return found


def is_alive(pid):
    try:
        os.kill(pid, 0)
    except OSError:
        return False
    return True
