"""What a file format is to the program: one record, which the format's own module defines."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from qovr_core.document import Document
from qovr_core.evaluation import Evaluation
from qovr_core.files.conventions import Up
from qovr_core.files.options import DEFAULTS, ExportOptions
from qovr_core.files.progress import Progress

Writer = Callable[[Evaluation, Path, Progress, ExportOptions], None]


def _any_size(_document: Document, _path: Path) -> None:
    """Accept every document."""


def _nothing_to_say(_document: Document) -> str:
    """Announce nothing."""
    return ""


@dataclass(frozen=True)
class Format:
    """One way out, and for some formats back in.

    Parameters
    ----------
    suffix : of the file, with its dot
    name : what people call it
    keeps : what it holds, in one line
    loses : what it cannot hold, in one line; empty where it loses nothing
    writer : writes an evaluation to a path, whole or not at all, telling its progress; asks the evaluation only for
        what it writes, since samples may be large
    reader : gives back the document of a file that carries a whole one, or raises FileError; None where none does
    check : refuses, before any work, a document that the format cannot hold
    holds_one_layer : whether ``ExportOptions.layer`` decides what is written
    is_mesh : whether ``ExportOptions.tolerance`` decides how fine
    has_unit : whether ``ExportOptions.unit`` is declared in it, or decides its size
    usual_up : the axis that its readers expect to point up, where ``ExportOptions.up`` may choose another; else None
    has_parts : whether ``ExportOptions.single_face`` decides in how many surfaces it holds a net
    is_text_table : whether ``ExportOptions.csv_dialect`` decides how it spells its cells
    other_suffixes : under which it is known too, as ``.stp``
    suffixes_read : of kinds of files that it reads but does not write
    announce : says of a document, before the work, how long and how large it will be; empty where that is little
    """

    suffix: str
    name: str
    keeps: str
    loses: str
    writer: Writer
    reader: Callable[[Path], Document] | None = None
    check: Callable[[Document, Path], None] = _any_size
    holds_one_layer: bool = False
    is_mesh: bool = False
    has_unit: bool = False
    usual_up: Up | None = None
    has_parts: bool = False
    is_text_table: bool = False
    other_suffixes: tuple[str, ...] = ()
    suffixes_read: tuple[str, ...] = ()
    announce: Callable[[Document], str] = _nothing_to_say

    def write(self, evaluation: Evaluation, path: Path, progress: Progress, options: ExportOptions = DEFAULTS) -> None:
        """Write a surface to a path, whole or not at all; ``progress`` rises to 1, and what it raises cancels.

        Raises
        ------
        FileError : the format cannot hold the surface, or the file cannot be written
        """
        self.writer(evaluation, path, progress, options)
