"""Size and ground of a figure: what a user chooses before one is written."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from qovr_core import FileError

SUFFIXES = (".png", ".svg", ".pdf")

INCH = 25.4
"""Millimetres."""

_LARGEST_SIDE = 20_000
"""Pixels; Qt's painter itself ends at 32767."""

_PRINT_DPI = 300
_SCREEN_DPI = 96


HEIGHT_OF_WIDTH = 0.75
"""The height of a figure whose width alone is asked for."""

WIDTHS = {"One column, 85 mm": 85.0, "One and a half, 114 mm": 114.0, "Two columns, 174 mm": 174.0}
"""Millimetres, as most journals set their columns."""


@dataclass(frozen=True)
class FigureOptions:
    """Size and ground of a figure.

    Parameters
    ----------
    width, height : in millimetres, or in pixels where ``dpi`` is None
    dpi : pixels per inch of the image, and of the surface inside SVG and PDF; None counts sizes in pixels
    transparent : leave the background out, in PNG and SVG
    """

    width: float = 160.0
    height: float = 120.0
    dpi: float | None = _PRINT_DPI
    transparent: bool = False

    @property
    def pixels(self) -> tuple[int, int]:
        """Width and height in pixels."""
        scale = 1.0 if self.dpi is None else self.dpi / INCH
        return max(1, round(self.width * scale)), max(1, round(self.height * scale))

    @property
    def millimetres(self) -> tuple[float, float]:
        """Width and height on paper; pixels count as those of a 96 dpi screen."""
        if self.dpi is not None:
            return self.width, self.height
        return self.width * INCH / _SCREEN_DPI, self.height * INCH / _SCREEN_DPI

    def check(self, path: Path) -> None:
        """Refuse what no figure is written as.

        Raises
        ------
        FileError : the path ends in another suffix, or the figure is of an absurd size
        """
        if path.suffix.lower() not in SUFFIXES:
            raise FileError(f"{path}: a figure is written as {', '.join(SUFFIXES)}, by the file name's end")
        if max(self.pixels) > _LARGEST_SIDE:
            width, height = self.pixels
            raise FileError(f"{path}: {width} x {height} pixels; expected at most {_LARGEST_SIDE} a side")
