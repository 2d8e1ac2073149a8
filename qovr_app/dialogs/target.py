"""The one way of asking where a file is to be written."""

from __future__ import annotations

from collections.abc import Container, Mapping
from pathlib import Path

from PySide6.QtWidgets import QFileDialog, QWidget

from qovr_app.dialogs.question import Answer, ask


def ask_for_target(
    parent: QWidget,
    title: str,
    first: Path,
    kinds: Mapping[str, str],
    *,
    other_suffixes: Container[str] = (),
    asks_to_replace: bool = True,
) -> Path | None:
    """Return where to write, with one of the suffixes; None where nobody wants to.

    What is there already has been asked about: by the dialog where the name was typed whole, here where the suffix
    makes it another one.

    Parameters
    ----------
    first : what is offered; its suffix is the one that is added to a name without one
    kinds : what is called how, by suffix
    other_suffixes : which a name may have as well
    asks_to_replace : whether what is there already is asked about here; else whoever asks has to say so
    """
    filters = {suffix: f"{name} (*{suffix})" for suffix, name in kinds.items()}
    call = (parent, title, str(first), ";;".join(filters.values()))
    if asks_to_replace:
        name, kind = QFileDialog.getSaveFileName(*call)
    else:
        shown, unasked = filters.get(first.suffix.lower(), ""), QFileDialog.Option.DontConfirmOverwrite
        name, kind = QFileDialog.getSaveFileName(*call, shown, unasked)
    if not name:
        return None
    typed = Path(name)
    suffix = next((suffix for suffix, text in filters.items() if text == kind), first.suffix)
    has_one = typed.suffix.lower() in kinds or typed.suffix.lower() in other_suffixes
    target = typed if has_one else typed.with_name(typed.name + suffix)
    if not asks_to_replace or target == typed or not stands(target) or _may_replace(parent, title, target):
        return target
    return None


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
