"""The colours of the picture, light and dark: quiet greys, one accent, the surface alone is colourful."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.display import ThemeName

Rgb = tuple[int, int, int]


@dataclass(frozen=True)
class Theme:
    """One set of colours, each red, green and blue from 0 to 255.

    ``ink`` writes on ``background``, ``pane`` and ``grid`` are the axes box, ``accent`` is the control
    points and what is selected, ``row_curve`` and ``column_curve`` are C_i and K_j, ``rim`` parts marks
    from the surface, ``undefined`` is the surface where what it shows has no value,
    ``rival`` the lines of another surface over it; ``series`` are five lines in one plot, by P_0..P_4
    where they belong to points.
    """

    background: Rgb
    pane: Rgb
    grid: Rgb
    axis: Rgb
    ink: Rgb
    quiet_ink: Rgb
    accent: Rgb
    rim: Rgb
    net: Rgb
    row_curve: Rgb
    column_curve: Rgb
    surface_line: Rgb
    series: tuple[Rgb, Rgb, Rgb, Rgb, Rgb]
    undefined: Rgb
    rival: Rgb


_THEMES = {
    ThemeName.LIGHT: Theme(
        background=(255, 255, 255),
        pane=(247, 248, 250),
        grid=(221, 224, 229),
        axis=(120, 126, 135),
        ink=(32, 36, 42),
        quiet_ink=(92, 98, 107),
        accent=(28, 100, 216),
        rim=(255, 255, 255),
        net=(70, 78, 90),
        row_curve=(16, 20, 26),
        column_curve=(28, 100, 216),
        surface_line=(0, 0, 0),
        series=((201, 57, 43), (190, 112, 0), (20, 132, 88), (28, 100, 216), (128, 62, 178)),
        undefined=(146, 149, 155),
        rival=(190, 24, 120),
    ),
    ThemeName.DARK: Theme(
        background=(32, 35, 40),
        pane=(38, 41, 47),
        grid=(60, 64, 72),
        axis=(128, 134, 144),
        ink=(232, 234, 238),
        quiet_ink=(166, 172, 181),
        accent=(92, 157, 255),
        rim=(24, 26, 30),
        net=(190, 196, 206),
        row_curve=(245, 246, 248),
        column_curve=(92, 157, 255),
        surface_line=(0, 0, 0),
        series=((255, 122, 108), (238, 176, 66), (74, 200, 142), (92, 157, 255), (190, 142, 245)),
        undefined=(146, 149, 155),
        rival=(255, 120, 200),
    ),
}


def theme_of(name: ThemeName) -> Theme:
    """Return the colours that go by a name."""
    return _THEMES[ThemeName(name)]
