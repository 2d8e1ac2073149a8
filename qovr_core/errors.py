"""The errors a user can meet: each one sentence with what is wrong, where, and what would be right."""

from __future__ import annotations


class QovrError(Exception):
    """Base of every error this package raises on purpose; its text is fit to be shown as it is."""


class DocumentError(QovrError):
    """A value that a document cannot hold.

    Parameters
    ----------
    place : where it stands, in the document's own words, such as ``control_points[3][1][2]``
    found : what stands there
    expected : what would be right

    Examples
    --------
    >>> error = DocumentError("row_knots[2].r", "1.5", "a number strictly between 0 and 1")
    >>> print(error)
    row_knots[2].r is 1.5; expected a number strictly between 0 and 1
    """

    def __init__(self, place: str, found: str, expected: str) -> None:
        super().__init__(f"{place} is {found}; expected {expected}")
        self.place = place
        self.found = found
        self.expected = expected

    def __reduce__(self) -> tuple[type[DocumentError], tuple[str, str, str]]:
        return type(self), (self.place, self.found, self.expected)


class EvaluationError(QovrError):
    """A valid document whose surface has no finite coordinates in double precision."""


class FileError(QovrError):
    """A file that cannot be read or written; the text begins with its path."""


class SourceError(QovrError):
    """A source, preset, figure or format name that this program does not know."""
