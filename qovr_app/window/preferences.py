"""What the program remembers from one start to the next."""

from __future__ import annotations

import os
from contextlib import suppress
from dataclasses import fields, replace
from pathlib import Path
from typing import Any

from PySide6.QtCore import QByteArray, QSettings

from qovr_app.state.display import ColourRange, DisplaySettings
from qovr_app.state.tools import ToolSettings, check_setting
from qovr_app.view3d.scene.patterns import colour_sources
from qovr_core import QovrError
from qovr_core.fields import FIELDS
from qovr_core.files import ExportOptions

_ORGANISATION, _APPLICATION = "qovr", "QOVR Studio"
_MOST_RECENT = 9
"""As many recent files as there are digits to choose them by."""

_FORGOTTEN = (
    "theme", "fixed_range", "underlay", "selects", "measures", "symmetry_rows", "symmetry_columns", "mirror_rows",
    "mirror_columns", "section",
)  # fmt: skip
"""Settings that follow the system, or belong to one document, and are not remembered."""

_CONVENTIONS = ("unit", "up", "csv_dialect")
"""The choices of an export that are of a person's other programs, and not of one document."""

_SET_ASIDE = ".damaged"
"""What is added to the name of a file that cannot be read."""


class Preferences:
    """The settings of this user; what was damaged or is of another version counts as never set.

    They are in QSettings, where each system looks for settings and users have theirs already. It writes by itself: on
    Linux under a lock into a file beside, which then takes the old one's place, as ``isAtomicSyncRequired`` promises;
    elsewhere into the system's own store. Only what changes is written, and at once: so several copies of the program
    share them, and none undoes what another has changed.
    """

    def __init__(self) -> None:
        self._store = QSettings(_ORGANISATION, _APPLICATION)
        self.complaint = self._put_right()
        """What is wrong with the file of the preferences, as a sentence; empty where all is well."""

    @property
    def folder(self) -> Path:
        """The folder in which a file was last opened or written; nobody asks the disk whether it is there still."""
        remembered = self._text("folder")
        return Path(remembered) if Path(remembered).is_absolute() else home_folder()

    @folder.setter
    def folder(self, folder: Path) -> None:
        self._write("folder", str(folder))

    @property
    def recent(self) -> list[Path]:
        """The files opened or saved last, the latest first; nobody asks the disk whether they are there still."""
        self._store.sync()  # another copy of the program may have added some
        value = self._store.value("recent", [])
        texts = [value] if isinstance(value, str) else value if isinstance(value, list) else []
        return [Path(text) for text in texts if isinstance(text, str) and text and "\0" not in text]

    def add_recent(self, path: Path) -> None:
        """Put a file first in the list of recent files."""
        others = [other for other in self.recent if other != path]
        self._write("recent", [str(entry) for entry in [path, *others][:_MOST_RECENT]])

    def clear_recent(self) -> None:
        """Forget all recent files."""
        self._write("recent", [])

    def bytes_of(self, name: str) -> QByteArray:
        """Return a remembered state of a window or splitter; empty where there is none."""
        value = self._store.value(f"window/{name}")
        return value if isinstance(value, QByteArray) else QByteArray()

    def set_bytes(self, name: str, state: QByteArray) -> None:
        """Remember a state of a window or splitter."""
        self._write(f"window/{name}", state)

    def chosen(self, key: str, usual: str) -> str:
        """Return a preference, by the key that holds it."""
        value = self._store.value(key, usual)
        return value if isinstance(value, str) else usual

    def choose(self, key: str, value: str) -> None:
        """Remember a preference."""
        self._write(key, value)

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
            self._write(f"export/{name}", str(getattr(chosen, name) or ""))

    def display(self, first: DisplaySettings) -> DisplaySettings:
        """Return ``first`` with every remembered choice in it."""
        chosen = self._chosen("view", first)
        if chosen.get("colour_by") not in colour_sources():
            chosen.pop("colour_by", None)
        return replace(first, **chosen)

    def note_display(self, before: DisplaySettings, after: DisplaySettings) -> None:
        """Remember what is shown otherwise than before."""
        coloured = FIELDS.get(after.colour_by)
        passing = {
            "colour_by": coloured is not None and coloured.needs is not None,
            "colour_range": after.colour_range is ColourRange.FIXED,
        }  # these mean nothing at the next start, without the reference, knot or numbers they were chosen with
        for field in fields(after):
            value = getattr(after, field.name)
            is_changed = value != getattr(before, field.name)
            if is_changed and field.name not in _FORGOTTEN and not passing.get(field.name):
                self._write(f"view/{field.name}", _choice_text(value))

    @property
    def tools(self) -> ToolSettings:
        """How control points are picked and moved; a size that can be none counts as never set."""
        settings = ToolSettings()
        for name, value in self._chosen("tools", settings).items():
            with suppress(QovrError):
                check_setting(name, value)
                remembered: dict[str, Any] = {name: value}
                settings = replace(settings, **remembered)
        return settings

    def note_tools(self, before: ToolSettings, after: ToolSettings) -> None:
        """Remember what is done otherwise than before."""
        for field in fields(after):
            value = getattr(after, field.name)
            if value != getattr(before, field.name) and field.name not in _FORGOTTEN:
                self._write(f"tools/{field.name}", _choice_text(value))

    def _chosen(self, group: str, first: DisplaySettings | ToolSettings) -> dict[str, Any]:
        """Return the remembered choices of a group that read back, by their names."""
        chosen: dict[str, Any] = {}
        for field in fields(first):
            text = self._store.value(f"{group}/{field.name}")
            if text is None or field.name in _FORGOTTEN:
                continue
            kind = type(getattr(first, field.name))
            with suppress(ValueError):
                chosen[field.name] = str(text) == "true" if kind is bool else kind(str(text))
        return chosen

    def _text(self, key: str) -> str:
        value = self._store.value(key, "")
        return value if isinstance(value, str) and "\0" not in value else ""

    def _write(self, key: str, value: object) -> None:
        if self._store.value(key) != value:
            self._store.setValue(key, value)
            self._store.sync()

    def _put_right(self) -> str:
        """Set a damaged file aside; return what is wrong with the file, if anything is."""
        status, file = self._store.status(), Path(self._store.fileName())
        if status == QSettings.Status.NoError:
            return ""
        if status == QSettings.Status.FormatError:
            aside = file.with_name(file.name + _SET_ASIDE)
            try:
                aside.write_bytes(file.read_bytes())  # what could be read of it is kept in the old place
            except OSError:
                return f"The preferences cannot be read whole: {file}."
            return f"The preferences cannot be read whole; the file was set aside as {aside}."
        return f"The preferences can be neither read nor kept: {file}."


def _choice_text(value: object) -> str:
    return str(value).lower() if isinstance(value, bool) else str(value)


def home_folder() -> Path:
    """Return where files go while nobody has said otherwise."""
    try:
        return Path.home()
    except RuntimeError:  # the system knows of none
        return present_folder()


def present_folder() -> Path:
    """Return the folder in which the program was started, or the root where somebody has deleted it."""
    try:
        return Path.cwd()
    except OSError:
        return Path(os.sep)
