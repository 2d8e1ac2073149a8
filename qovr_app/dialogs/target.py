"""The one way of asking where a file is to be written."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget

from qovr_app.dialogs.question import Answer, ask


def ask_for_target(parent: QWidget, title: str, first: Path, kinds: Mapping[str, str]) -> Path | None:
    """Return where to write, with one of the suffixes; None where nobody wants to.

    What is there already has been asked about: by the dialog where the name was typed whole, here where the suffix
    makes it another one.

    Parameters
    ----------
    first : what is offered; its suffix is the one that is added to a name without one
    kinds : what is called how, by suffix
    """
    filters = {suffix: f"{name} (*{suffix})" for suffix, name in kinds.items()}
    shown = filters.get(first.suffix.lower(), "")
    name, kind = QFileDialog.getSaveFileName(parent, title, str(first), ";;".join(filters.values()), shown)
    if not name:
        return None
    typed = Path(name)
    suffix = next((suffix for suffix, text in filters.items() if text == kind), first.suffix)
    target = with_suffix_of(typed, kinds, suffix)
    if target == typed or not stands(target) or _may_replace(parent, title, target):
        return target
    return None


def with_suffix_of(path: Path, kinds: Mapping[str, str], suffix: str) -> Path:
    """Return a path that has one of the suffixes: its own, or another one added to its name."""
    return path if path.suffix.lower() in kinds else path.with_name(path.name + suffix)


def stands(path: Path) -> bool:
    """Return whether something is at a path; what cannot be asked counts as nothing: writing will say why."""
    try:
        path.lstat()
    except (OSError, ValueError):
        return False
    return True


def _may_replace(parent: QWidget, title: str, target: Path) -> bool:
    text = f"{target.name} already exists in {target.parent}. Replace it?"
    return ask(parent, title, text, {Answer.Yes: "&Replace", Answer.No: ""}, Answer.No) == Answer.Yes
