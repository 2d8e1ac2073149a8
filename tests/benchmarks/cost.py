"""How cost grows with the work: times over how much there is to do, and the picture of them with their slopes."""

from dataclasses import dataclass

import numpy as np
from matplotlib.figure import Figure

COLOURS = ("#0b5cad", "#c2410c", "#15803d")
MARKERS = "os^"
INCHES, DOTS = (11, 7), 90


@dataclass(frozen=True)
class Line:
    """One line of the picture.

    Parameters
    ----------
    over : what there is more and more of; lines over the same share a panel
    what : what is timed
    amounts, milliseconds : (k,) each, growing amounts
    """

    over: str
    what: str
    amounts: tuple[float, ...]
    milliseconds: tuple[float, ...]

    @property
    def slope(self):
        """The exponent p of cost ~ amount^p, by least squares over all points."""
        return _slope(self.amounts, self.milliseconds)

    @property
    def last_slope(self):
        """The same of the two largest amounts, where what is always to do weighs least."""
        return _slope(self.amounts[-2:], self.milliseconds[-2:])


def _slope(amounts, milliseconds):
    return float(np.polyfit(np.log(amounts), np.log(milliseconds), 1)[0])


def as_text(lines):
    """Return the lines as a table of values separated by commas."""
    head = "over,what,amount,milliseconds,slope,slope at the end"
    return "\n".join(
        [head]
        + [
            f'"{line.over}","{line.what}",{amount:g},{taken:.4g},{line.slope:.2f},{line.last_slope:.2f}'
            for line in lines
            for amount, taken in zip(line.amounts, line.milliseconds, strict=True)
        ]
    )


def draw(lines, path):
    """Draw a panel for each amount, both axes logarithmic; the slope stands beside each line's name."""
    panels = list(dict.fromkeys(line.over for line in lines))
    figure = Figure(figsize=INCHES, layout="constrained", facecolor="white")
    for axes, over in zip(figure.subplots(2, 2).flat, panels, strict=False):
        of_panel = [line for line in lines if line.over == over]
        for line, colour, marker in zip(of_panel, COLOURS, MARKERS, strict=False):
            label = f"{line.what}: slope {line.slope:.2f}, at the end {line.last_slope:.2f}"
            axes.loglog(line.amounts, line.milliseconds, color=colour, marker=marker, markersize=5, label=label)
        least, most = (end(value for line in of_panel for value in line.milliseconds) for end in (min, max))
        axes.set_ylim(least / 2, most * 10)  # room above for the names
        axes.set_xlabel(over)
        axes.set_ylabel("milliseconds")
        axes.grid(which="major", color="#dddddd")
        axes.legend(loc="upper left", fontsize="small", frameon=False)
    figure.savefig(path, dpi=DOTS)
