"""What the program remembers from one start to the next."""

from __future__ import annotations

from contextlib import suppress
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QSettings

from qovr_app.state.display import ColourRange, DisplaySettings
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_core.fields import FIELDS
from qovr_core.files import ExportOptions

_ORGANISATION, _APPLICATION = "qovr", "QOVR Studio"
_MOST_RECENT = 9
"""As many recent files as there are digits to choose them by."""

_FORGOTTEN = ("theme", "fixed_range")
"""Display settings that follow the system, or belong to one document, and are not remembered."""

_CONVENTIONS = ("unit", "up", "csv_dialect")
"""The choices of an export that are of a person's other programs, and not of one document."""


class Preferences:
    """The settings of this user; what was damaged or is of another version counts as never set.

    They are in QSettings, where each system looks for settings and users have theirs already. It writes by itself: on
    Linux under a lock into a file beside, which then takes the old one's place, as ``isAtomicSyncRequired`` promises;
    elsewhere into the system's own store.
    """

    def __init__(self) -> None:
        self._store = QSettings(_ORGANISATION, _APPLICATION)

    @property
    def folder(self) -> Path:
        """The folder in which a file was last opened or written."""
        remembered = Path(str(self._store.value("folder", "")))
        return remembered if remembered.is_absolute() and remembered.is_dir() else Path.home()

    @folder.setter
    def folder(self, folder: Path) -> None:
        self._store.setValue("folder", str(folder.absolute()))

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last, the latest first."""
        value = self._store.value("recent", [])
        texts = [value] if isinstance(value, str) else value if isinstance(value, list) else []
        return [Path(text) for text in texts]

    def add_recent(self, path: Path) -> None:
        """Put a file first in the list of recent files."""
        path = path.absolute()
        others = [other for other in self.recent if other != path]
        self._store.setValue("recent", [str(entry) for entry in [path, *others][:_MOST_RECENT]])

    def clear_recent(self) -> None:
        """Forget all recent files."""
        self._store.setValue("recent", [])

    def bytes_of(self, name: str) -> QByteArray:
        """Return a remembered state of a window or splitter; empty where there is none."""
        value = self._store.value(f"window/{name}")
        return value if isinstance(value, QByteArray) else QByteArray()

    def set_bytes(self, name: str, state: QByteArray) -> None:
        """Remember a state of a window or splitter."""
        self._store.setValue(f"window/{name}", state)

    @property
    def conventions(self) -> ExportOptions:
        """The unit, axis and dialect with which a surface was last exported."""
        chosen = ExportOptions()
        for name in _CONVENTIONS:
            remembered: dict[str, Any] = {name: self._store.value(f"export/{name}")}
            with suppress(ValueError):
                chosen = replace(chosen, **remembered) if remembered[name] else chosen
        return chosen

    @conventions.setter
    def conventions(self, chosen: ExportOptions) -> None:
        for name in _CONVENTIONS:
            self._store.setValue(f"export/{name}", str(getattr(chosen, name) or ""))

    def display(self, first: DisplaySettings) -> DisplaySettings:
        """Return ``first`` with every remembered choice in it."""
        chosen: dict[str, Any] = {}
        for field in fields(first):
            text = self._store.value(f"view/{field.name}")
            if text is None or field.name in _FORGOTTEN:
                continue
            kind = type(getattr(first, field.name))
            try:
                chosen[field.name] = str(text) == "true" if kind is bool else kind(str(text))
            except ValueError:
                continue
        if chosen.get("colour_by") not in colour_sources():
            chosen.pop("colour_by", None)
        return replace(first, **chosen)

    def set_display(self, settings: DisplaySettings) -> None:
        """Remember how the surface is shown."""
        coloured = FIELDS.get(settings.colour_by)
        passing = {
            "colour_by": coloured is not None and coloured.needs is not None,
            "colour_range": settings.colour_range is ColourRange.FIXED,
        }  # these mean nothing at the next start, without the reference, knot or numbers they were chosen with
        for field in fields(settings):
            value = getattr(settings, field.name)
            if field.name not in _FORGOTTEN and not passing.get(field.name):
                self._store.setValue(
                    f"view/{field.name}", str(value).lower() if isinstance(value, bool) else str(value)
                )
