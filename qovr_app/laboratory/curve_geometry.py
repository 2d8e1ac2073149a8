"""The curve in its plane: points, parabolas in full and where they are blended, and the places of the knots."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest

import numpy as np
from PySide6.QtCore import Qt
from PySide6.QtGui import QBrush
from PySide6.QtWidgets import QWidget

from qovr_app.laboratory.curve_comb import CombLines
from qovr_app.laboratory.pg import make_brush
from qovr_app.laboratory.plots import Line, Plot
from qovr_app.style.symbols import coloured, symbol_html
from qovr_app.style.theme import Rgb, Theme
from qovr_core.arrays import Array
from qovr_core.geometry.folding import MOST_FOLDS
from qovr_core.laboratory.curve_names import FLATTEST, name_centres, named_places, seen_points
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve
from qovr_core.laboratory.planes import Plane, View, plane_of

_POINT, _RING, _DOT = 9, 15, 7
_BLENDED_ALPHA = 90
_ROOM_FOR_LABELS = 0.2
_ROOM_FOR_KNOTS = 380
"""From this width on the points' labels also name the knots without touching each other."""


class GeometryPlot(Plot):
    """Draws one curve and everything it is made of."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__("laboratory.curve.geometry", "The curve, its points and its three parabolas", parent)
        self.view_box.setDefaultPadding(_ROOM_FOR_LABELS)
        self._shown: tuple[OneCurve, Plane] | None = None
        self._polygon = self.make_line()
        self._comb = CombLines(self)
        self._comb_scale: float | None = None
        self._auxiliary = [self.make_line(bounds=False) for _ in range(3)]
        self._blended = [self.make_line() for _ in range(3)]
        self._whole = [self.make_line() for _ in range(3)]
        self._line = self.make_line()
        self._backward = [self.make_line() for _ in range(MOST_FOLDS)]
        self._rings, self._points = self.make_dots(_RING), self.make_dots(_POINT)
        self._hover_parts, self._hover = self.make_dots(_DOT), self.make_dots(_POINT)
        self._point_texts = [self.make_text() for _ in range(5)]
        self._parabola_texts = [self.make_text() for _ in range(3)]
        self._point_htmls = [""] * 5
        self.view_box.sigResized.connect(self._on_resized)

    def show_theme(self, theme: Theme) -> None:
        super().show_theme(theme)
        parts = theme.series[1:4]
        self._polygon.setPen(self.pen(theme.axis, 1, Qt.PenStyle.DotLine))
        for lines, width, style, alpha in (
            (self._whole, 1.2, Qt.PenStyle.SolidLine, 255),
            (self._blended, 6, Qt.PenStyle.SolidLine, _BLENDED_ALPHA),
            (self._auxiliary, 1.2, Qt.PenStyle.DashLine, 255),
        ):
            for line, colour in zip(lines, parts, strict=True):
                line.setPen(self.pen((*colour, alpha), width, style))
        self._comb.show_theme(theme)
        self._line.setPen(self.pen(theme.ink, 2.4))
        for line in self._backward:
            line.setPen(self.pen(theme.warn, 2.4))
        self._rings.setPen(self.pen(theme.ink, 1.2))
        self._rings.setBrush(None)
        self._points.setPen(self.pen(theme.background, 1))
        self._hover.setPen(self.pen(theme.background, 1))
        self._hover_parts.setPen(self.pen(theme.background, 1))
        for k, text in enumerate(self._parabola_texts):
            text.setHtml(coloured(f"{symbol_html('Q', str(k))}(<i>{'rst'[k]}</i>)", parts[k]))
        if self._shown is not None:
            self._draw(*self._shown)

    def show_curve(self, curve: OneCurve, view: View) -> None:
        """Show a curve in a plane."""
        plane = plane_of(curve.points, view)
        self._shown = curve, plane
        for side, label in zip(("bottom", "left"), plane.labels, strict=True):
            if label != self.getAxis(side).labelText:
                self.setLabel(side, label)
        self._draw(curve, plane)

    def show_comb(self, scale: float | None) -> None:
        """Show the comb with teeth so many times as long as at first; None takes it away."""
        if scale != self._comb_scale:
            self._comb_scale = scale
            if self._shown is not None:
                self._draw(*self._shown)

    def show_hover(self, u: float | None) -> None:
        """Mark the place of a parameter on the curve, and the three that are blended there; None takes marks away."""
        is_shown = u is not None and self._shown is not None
        for dots in (self._hover, self._hover_parts):
            dots.setVisible(is_shown)
        if u is None or self._shown is None:
            return
        curve, plane = self._shown
        places = curve.transformed([u])[0]
        parts = np.concatenate([curve.parabola(p, [places[p]]) for p in range(3)])
        self._hover.setData(pos=plane.drawn(curve.at([u])), brush=make_brush(self.colours.ink))
        self._hover_parts.setData(pos=plane.drawn(parts), brush=_brushes(self.colours.series[1:4]))

    def nearest(self, place: tuple[float, float]) -> float | None:
        """Return the parameter whose point is drawn nearest to a place, as the eye sees it; None without a curve."""
        if self._shown is None:
            return None
        curve, plane = self._shown
        apart = (plane.drawn(curve.at(SAMPLES)) - place) / np.array(self.view_box.viewPixelSize())
        return float(SAMPLES[np.argmin(np.linalg.norm(apart, axis=1))])

    def _draw(self, curve: OneCurve, plane: Plane) -> None:
        drawn = plane.drawn
        points = drawn(curve.points)
        _set(self._polygon, points)
        for p in range(3):
            _set(self._whole[p], drawn(curve.parabola(p, SAMPLES)))
            for line, (first, last) in ((self._blended[p], curve.blended[p]), (self._auxiliary[p], curve.auxiliary[p])):
                _set(line, drawn(curve.parabola(p, np.linspace(first, last, len(SAMPLES)))))
        _set(self._line, drawn(curve.at(SAMPLES)))
        self._comb.show_curve(curve, plane, self._comb_scale)
        parts = [drawn(curve.at(np.linspace(*part, 41))) for part in curve.folding_parts]
        for line, part in zip_longest(self._backward, parts):
            _set(line, points[:0] if part is None else part)
        self._rings.setData(pos=drawn(curve.at(curve.landmarks)))
        self._points.setData(pos=points, brush=_brushes(self.colours.series))
        self._place_texts(curve, plane)
        self.settle()

    def _place_texts(self, curve: OneCurve, plane: Plane) -> None:
        """Put every name where it covers least."""
        for k, text in enumerate(self._point_texts):
            html = self._point_html(curve, k)
            if html != self._point_htmls[k]:  # it takes long to lay out
                self._point_htmls[k] = html
                text.setHtml(html)
        texts = self._point_texts + self._parabola_texts
        sizes = np.array([text.textItem.boundingRect().size().toTuple() for text in texts])
        pixels, box = self._frame(seen_points(curve, plane))
        to_pixels = pixels.__mul__
        places = named_places(curve, plane, to_pixels)
        centres = name_centres(curve, plane, places, to_pixels, sizes, gap=_RING / 2, box=box)
        for text, place, (across, up) in zip(texts, places, (centres - places * pixels) / sizes, strict=True):
            text.setPos(*place)
            text.setAnchor((0.5 - across, 0.5 + up))

    def _frame(self, seen: Array) -> tuple[Array, Array]:
        """Return the pixels to a unit in the range that the plot takes by itself, and that range in pixels, (2, 2)."""
        low, high = seen.min(axis=0), seen.max(axis=0)
        least = FLATTEST * max(*(high - low), np.finfo(float).tiny)
        self.view_box.setLimits(minXRange=least, minYRange=least)
        span = (1 + 2 * _ROOM_FOR_LABELS) * np.maximum(high - low, least)
        pixels = np.array([self.view_box.width(), self.view_box.height()]) / span
        middle = (low + high) / 2
        return pixels, np.array([middle - span / 2, middle + span / 2]) * pixels

    def _point_html(self, curve: OneCurve, k: int) -> str:
        name = coloured(f"<b>{symbol_html('P', str(k))}</b>", self.colours.series[k])
        if k in (0, 4):
            return name
        place = f"<i>{curve.parameter}</i> = {curve.landmarks[k - 1]:.4g}"
        knot = f", <i>{'rst'[k - 1]}</i> = {curve.internal_knots[k - 1]:.4g}"
        text = place + knot if self.width() >= _ROOM_FOR_KNOTS else place
        return f'<div align="center">{name}<br>{coloured(text, self.colours.quiet_ink)}</div>'

    def _on_resized(self) -> None:
        if self._shown is not None:
            self._place_texts(*self._shown)


def _set(line: Line, points: Array) -> None:
    line.setData(points[:, 0], points[:, 1])


def _brushes(colours: Sequence[Rgb]) -> list[QBrush]:
    return [make_brush(colour) for colour in colours]
