"""The paper's figures by name, and figures as files."""

from __future__ import annotations

from collections.abc import Iterable
from contextlib import nullcontext
from datetime import UTC
from pathlib import Path
from typing import Any

from qovr_core.errors import SourceError
from qovr_core.evaluation import Evaluation
from qovr_core.figures.curves import draw_knots, draw_parabolas, draw_sensitivity
from qovr_core.figures.style import house_style, text_kept_as_text
from qovr_core.figures.surfaces import draw_figure, draw_network
from qovr_core.files.atomic import replacing
from qovr_core.files.provenance import timestamp
from qovr_core.laboratory.one_curve import OneCurve
from qovr_core.presets import curve_case, figure_cases, network_case

FIGURE_FORMATS = ("png", "svg", "pdf")

_CURVE_FIGURES = {"fig1a": draw_parabolas, "fig1b": draw_knots, "fig1c": draw_sensitivity}

_NETWORK_FIGURE = "fig2"


def figure_names() -> tuple[str, ...]:
    """Return the names of all figures in the paper's order."""
    return (*_CURVE_FIGURES, _NETWORK_FIGURE, *figure_cases())


def find_figures(only: Iterable[str]) -> list[str]:
    """Return the names of the figures that are asked for in the paper's order, all of them where none is.

    A name may also be that of several, as ``fig6`` for ``fig6a`` to ``fig6d``.

    Raises
    ------
    SourceError : a name is no figure's
    """
    known = figure_names()
    chosen: set[str] = set()
    for name in only:
        matching = {figure for figure in known if figure == name or figure.rstrip("abcd") == name}
        if not matching:
            raise SourceError(f"there is no figure '{name}'; expected one of {', '.join(known)}")
        chosen |= matching
    return [name for name in known if name in chosen or not chosen]


def save_figure(name: str, path: Path, *, dpi: int = 300) -> None:
    """Draw one of the paper's figures into a file of the kind that its suffix names, whole or not at all.

    Parameters
    ----------
    name : one of ``figure_names()``
    path : ends in ``.png``, ``.svg`` or ``.pdf``
    dpi : resolution of a ``.png``

    Raises
    ------
    FileError : the file cannot be written
    """
    title = f"QOVR surfaces, Figure {name.removeprefix('fig')}"
    write_figure(_draw(name), path, dpi=dpi, title=title)


@house_style()
def write_figure(
    figure: Any, path: Path, *, dpi: float, transparent: bool = False, title: str = "QOVR surface"
) -> None:
    """Write a matplotlib Figure as PNG, SVG or PDF, by the path's suffix, whole or not at all.

    Texts of SVG and PDF stay text, in TrueType, and both carry the title.

    Raises
    ------
    FileError : the file cannot be written
    """
    kind = path.suffix.lower().removeprefix(".")
    time = timestamp()
    told: dict[str, dict[str, Any]] = {
        "svg": {"Title": title, "Date": time.isoformat() if time else None},
        "pdf": {"Title": title, "CreationDate": time.replace(tzinfo=UTC) if time else None},
    }
    keeping = text_kept_as_text(figure) if kind in told else nullcontext()
    with replacing(path) as (draft,), keeping:
        figure.savefig(draft, format=kind, dpi=dpi, transparent=transparent, metadata=told.get(kind))


def _draw(name: str) -> Any:
    if name == _NETWORK_FIGURE:
        return draw_network(network_case().document)
    if name in _CURVE_FIGURES:
        return _CURVE_FIGURES[name](OneCurve(*curve_case()))
    case = figure_cases()[name]
    return draw_figure(Evaluation(case.preset.document), layer=case.layer, camera=case.camera)
