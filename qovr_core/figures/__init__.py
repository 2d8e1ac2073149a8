"""The paper's figures 1, 2 and 5 to 8, drawn by matplotlib with no display."""

from qovr_core.figures.paper import FIGURE_FORMATS, figure_names, find_figures, save_figure, write_figure
from qovr_core.figures.surfaces import draw_figure, draw_network

__all__ = [
    "FIGURE_FORMATS",
    "draw_figure",
    "draw_network",
    "figure_names",
    "find_figures",
    "save_figure",
    "write_figure",
]
