"""The errors a user can meet: each one sentence with what is wrong, where, and what would be right."""

from __future__ import annotations

LONGEST_TEXT = 250
"""Characters of an error's text: with the words that a window or the command line sets around it, a message stays below
300."""

LONGEST_QUOTE = 60
"""Characters of a name or a value that a text quotes."""

_CUT = "..."


def one_line(text: str, longest: int = LONGEST_TEXT) -> str:
    r"""Return a text as one short line: what is not printable escaped, what is too much left out of the middle.

    The middle, since a message begins with a path and ends with what is expected.

    Examples
    --------
    >>> one_line("two\nlines")
    'two\\nlines'
    >>> one_line("0123456789", longest=7)
    '01...89'
    """
    if len(text) > 2 * longest:  # before each character is looked at
        text = text[:longest] + text[-longest:]
    line = "".join(
        character if character.isprintable() else character.encode("unicode_escape").decode() for character in text
    )
    if len(line) <= longest:
        return line
    kept = longest - len(_CUT)
    return line[: kept // 2] + _CUT + line[len(line) - (kept - kept // 2) :]


def quoted(text: str) -> str:
    """Return a foreign name, such as a key in a file, as a message quotes it."""
    return one_line(text, LONGEST_QUOTE) or "''"


def reason_of(error: BaseException) -> str:
    """Return why something failed: in the words of the system, else of the error, else its kind."""
    text = (error.strerror if isinstance(error, OSError) else None) or str(error) or type(error).__name__
    return one_line(" ".join(text.split()))


class QovrError(Exception):
    """Base of every error this package raises on purpose; its text is one line, fit to be shown as it is."""

    def __str__(self) -> str:
        return one_line(super().__str__())


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
