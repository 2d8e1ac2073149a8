"""Files in and out: one module a format, one table of formats."""

from qovr_core.files.format import Format
from qovr_core.files.formats import FORMATS, export, find_format, format_for
from qovr_core.files.options import ExportOptions
from qovr_core.files.qovr_document import read_document, write_document
from qovr_core.files.sources import read_source, readable_suffixes, source_suffixes

__all__ = [
    "FORMATS",
    "ExportOptions",
    "Format",
    "export",
    "find_format",
    "format_for",
    "read_document",
    "read_source",
    "readable_suffixes",
    "source_suffixes",
    "write_document",
]
