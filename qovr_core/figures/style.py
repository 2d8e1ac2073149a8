"""The settings under which matplotlib draws, the same for everyone, and halos that leave text text."""

from __future__ import annotations

import logging
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from qovr_core.errors import QovrError, reason_of

_BELOW = 0.5
"""By how much a halo lies below its text: the drawing's layers are whole numbers."""


@contextmanager
def house_style() -> Iterator[None]:
    """Draw and write as matplotlib does by default, whatever a user's own ``matplotlibrc`` and locale say.

    Raises
    ------
    QovrError : matplotlib cannot even be loaded with that file
    """
    logging.getLogger("matplotlib").setLevel(logging.ERROR)  # its warnings are about files that are not used here
    try:
        import matplotlib
    except Exception as error:
        raise QovrError(f"matplotlib cannot be loaded with the settings that it finds: {reason_of(error)}") from error
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rc("pdf", fonttype=42)  # TrueType, which journals ask for; many refuse the usual Type 3
        matplotlib.rc("svg", fonttype="none")  # text stays text, to be searched and edited
        matplotlib.rc("svg", hashsalt="qovr")  # of which the names in an SVG are made: the same every time
        yield


def halo(width: float) -> list[Any]:
    """Return the effects that give a text a white halo, in points wide."""
    from matplotlib.patheffects import Stroke, withStroke

    style: dict[str, Any] = {"linewidth": width, "foreground": "white"}
    effect: Any = withStroke(**style)
    effect.alone = Stroke(**style)
    return [effect]


@contextmanager
def text_kept_as_text(figure: Any) -> Iterator[None]:
    """Draw the halos of a figure's texts by themselves: matplotlib makes outlines of a text that has an effect."""
    from matplotlib.text import Text

    drawn = [(text, text.get_path_effects()) for text in figure.findobj(Text) if text.get_path_effects()]
    below = [text.axes.add_artist(_halo_below(text, effects)) for text, effects in drawn]
    for text, _ in drawn:
        text.set_path_effects(None)
    try:
        yield
    finally:
        for artist, (text, effects) in zip(below, drawn, strict=True):
            artist.remove()
            text.set_path_effects(effects)


def _halo_below(text: Any, effects: list[Any]) -> Any:
    """Return an artist that draws the halo of a text alone."""
    from matplotlib.artist import Artist

    class Halo(Artist):
        def draw(self, renderer: Any) -> None:
            text.set_path_effects([effect.alone for effect in effects])
            text.draw(renderer)
            text.set_path_effects(None)

    below = Halo()
    below.set_zorder(text.get_zorder() - _BELOW)
    below.set_in_layout(False)
    return below
