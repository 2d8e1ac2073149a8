"""What the numbers of a file mean: their unit, the axis that points up, and how a table spells them."""

from __future__ import annotations

from enum import StrEnum

import numpy as np

from qovr_core.arrays import Array


class Unit(StrEnum):
    """What a document's numbers count.

    >>> Unit("in").metres, Unit.CENTIMETRE.plural
    (0.0254, 'centimetres')
    """

    MILLIMETRE = "mm"
    CENTIMETRE = "cm"
    METRE = "m"
    INCH = "in"

    @property
    def metres(self) -> float:
        """The length of one unit in metres."""
        return {Unit.MILLIMETRE: 0.001, Unit.CENTIMETRE: 0.01, Unit.METRE: 1.0, Unit.INCH: 0.0254}[self]

    @property
    def plural(self) -> str:
        """What people call several of them."""
        return "inches" if self is Unit.INCH else f"{self.name.lower()}s"


class Up(StrEnum):
    """The axis of a file that points up: a document's own z, or y as in animation and games."""

    Z = "z"
    Y = "y"

    def turned(self, vectors: Array) -> Array:
        """Return a document's vectors (..., 3) in the file's axes; with y up, z becomes y and y points away as -z.

        >>> Up.Y.turned(np.array([1.0, 2.0, 3.0]))
        array([ 1.,  3., -2.])
        """
        if self is Up.Z:
            return vectors
        return np.stack([vectors[..., 0], vectors[..., 2], -vectors[..., 1]], axis=-1)


USUAL_UP = {".obj": Up.Y, ".stl": Up.Z, ".ply": Up.Z}
"""As Blender, Rhino and printers take these formats unless they are told otherwise, and turn them upright."""


class CsvDialect(StrEnum):
    """How a table of text spells its cells; a comma cannot both part them and stand in their numbers."""

    COMMA = "comma"
    SEMICOLON = "semicolon"

    @property
    def separator(self) -> str:
        """What stands between two cells."""
        return {CsvDialect.COMMA: ",", CsvDialect.SEMICOLON: ";"}[self]

    @property
    def decimal_sign(self) -> str:
        """What stands before the decimals of a number."""
        return {CsvDialect.COMMA: ".", CsvDialect.SEMICOLON: ","}[self]

    @property
    def wording(self) -> str:
        """How it spells, in words."""
        return f"cells apart by “{self.separator}”, decimal {'point' if self.decimal_sign == '.' else 'comma'}"
