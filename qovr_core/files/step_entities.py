"""The text of ISO 10303-21: numbers, strings and numbered entities."""

from __future__ import annotations

from collections.abc import Iterable


def real(value: float) -> str:
    """Return the shortest decimal that reads back as the number, as STEP spells it: ``1e-05`` is ``1.E-5``."""
    mantissa, mark, exponent = repr(float(value)).partition("e")
    if not mark:
        return mantissa
    return f"{mantissa if '.' in mantissa else mantissa + '.'}E{int(exponent)}"


def quoted(text: str) -> str:
    """Return a text as a STEP string: quotes and backslashes doubled, all but printable ASCII in hexadecimal."""
    return "'" + "".join(map(_escaped, text)) + "'"


def _escaped(character: str) -> str:
    if character in "'\\":
        return 2 * character
    if " " <= character <= "~":
        return character
    code = ord(character)
    if 0xD800 <= code <= 0xDFFF:  # half a character, from a file name that is no valid text
        return "?"
    return f"\\X2\\{code:04X}\\X0\\" if code <= 0xFFFF else f"\\X4\\{code:08X}\\X0\\"


class Entities:
    """The numbered entities of a data section."""

    def __init__(self) -> None:
        self.lines: list[str] = []

    def add(self, text: str) -> str:
        """Append an entity and return the reference to it."""
        self.lines.append(f"#{len(self.lines) + 1}={text};")
        return f"#{len(self.lines)}"

    def point(self, coordinates: Iterable[float]) -> str:
        return self.add(f"CARTESIAN_POINT('',({joined(real(x) for x in coordinates)}))")


def joined(parts: Iterable[str]) -> str:
    return ",".join(parts)
