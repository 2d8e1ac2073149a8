"""What the program says of itself: versions, what to cite, its keys, and what helps to find a fault."""

from __future__ import annotations

import platform
from collections.abc import Iterable
from html import escape

import numpy as np
from PySide6 import __version__ as pyside_version
from PySide6.QtCore import qVersion
from PySide6.QtGui import QAction

from qovr_app.state.intent_text import intent_text
from qovr_app.state.intents import Intent
from qovr_app.window.application import NAME
from qovr_core.version import VERSION

CITATION = """@misc{qovr,
  author = {{\\"U}st{\\"u}nel, Hakan},
  title = {Matrix-Driven Quartic Overhauser ({QOVR}) Surfaces Structural Framework: Continuity Limitations,
           Computer Graphics Algorithms, and Software Implementation},
  howpublished = {Preprint}
}
"""
"""The paper, for BibTeX."""


_KEYS_THERE = {
    "While a point is dragged": {
        "X, Y, Z": "along that axis, and free again",
        "Shift+X, Y, Z": "in the plane across it",
        "Shift, Ctrl": "fine, keep to the step",
        "Digits": "the value itself; Enter takes it",
        "Esc": "put it back",
    },
    "In the view": {
        "Arrows": "go over the points",
        "Ctrl+Arrows": "orbit",
        "Shift, Ctrl and a click": "add a point, add or remove it",
        "Tab": "leave the view",
    },
    "In a field": {
        "Up, Down, PgUp, PgDown": "a step, ten steps",
        "1/3, +0.1, *2, /2, +-0.1": "worked out",
        "Esc": "drop what is typed",
    },
}
"""What keys do where no command is asked for."""


def versions_text() -> str:
    """Return the versions of the program and of what it is built on, one a line."""
    return "\n".join(
        (
            f"{NAME} {VERSION}",
            f"Python {platform.python_version()}, {platform.system()} {platform.release()} {platform.machine()}",
            f"PySide6 {pyside_version}, Qt {qVersion()}, NumPy {np.__version__}",
        )
    )


def report_text(session: Iterable[Intent]) -> str:
    """Return what helps to find a fault: the versions, and what was done, one intent a line."""
    return "\n".join((versions_text(), "", *map(intent_text, session), ""))


def keys_html(actions: Iterable[tuple[str, QAction]]) -> str:
    """Return the sheet of all commands that have a key, menu by menu.

    Parameters
    ----------
    actions : the menu of every command, as "View/Show", and its action
    """
    rows: list[str] = []
    shown = ""
    for menu, action in actions:
        keys = action.shortcut().toString(action.shortcut().SequenceFormat.NativeText)
        title = menu.replace("&", "").split("/")[0]
        if not keys:
            continue
        if title != shown:
            shown = title
            rows.append(f"<tr><td colspan=2><h3>{escape(title)}</h3></td></tr>")
        text = action.iconText() if action.text().startswith(("&Undo", "&Redo")) else action.text()
        rows.append(f"<tr><td><b>{escape(keys)}</b>&nbsp;&nbsp;</td><td>{escape(text.replace('&', ''))}</td></tr>")
    for title, keys_there in _KEYS_THERE.items():
        rows.append(f"<tr><td colspan=2><h3>{title}</h3></td></tr>")
        rows.extend(f"<tr><td><b>{keys}</b>&nbsp;&nbsp;</td><td>{text}</td></tr>" for keys, text in keys_there.items())
    return f"<table>{''.join(rows)}</table>"
