"""The two themes, light and dark: every colour of window, plots and picture, in one table. The surface alone is
colourful."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.display import ThemeName

Rgb = tuple[int, int, int]
"""Red, green and blue from 0 to 255."""


KNOT_SERIES = {"r": 1, "s": 2, "u": 2, "t": 3}
"""Which of a theme's series the knots are drawn in, in plots and in the view: u in that of s, with which it is one."""


@dataclass(frozen=True)
class Theme:
    """One set of colours.

    Of picture and plots: ``ink`` writes on ``background``, ``pane`` and ``grid`` are the axes box, ``point`` is a
    control point and ``selected`` what is selected, ``row_curve`` and ``column_curve`` are C_i and K_j,
    ``smooth_joint`` and ``sharp_joint`` where windows of the net meet, ``rim`` parts marks from the surface,
    ``undefined`` is the surface where what it shows has no value, ``comparison`` the lines of another surface over it,
    ``section`` where a plane cuts it; ``series`` are five lines in one plot, by P_0..P_4 where they belong to points.

    Of fields and marks: ``cell`` and ``edge`` are a field at rest, ``hover`` its edge under the pointer, ``idle_ink``
    writes a number without effect; ``accent`` is the keyboard's focus, ``selected`` what is selected, ``pending`` what
    is not set yet, ``bad`` what is refused, ``warn`` what will surprise; the ``*_cell`` colours lie behind text.

    Of the palette, from which Fusion draws all else: ``window``, ``button`` and ``tool_tip`` are grounds, ``light`` to
    ``shadow`` the shades of raised edges, ``faded_ink`` writes what is disabled, ``placeholder_ink`` what stands in a
    field until something is typed, ``selected_ink`` on the accent.
    """

    name: ThemeName
    background: Rgb
    pane: Rgb
    grid: Rgb
    axis: Rgb
    ink: Rgb
    quiet_ink: Rgb
    accent: Rgb
    point: Rgb
    selected: Rgb
    rim: Rgb
    net: Rgb
    row_curve: Rgb
    column_curve: Rgb
    smooth_joint: Rgb
    sharp_joint: Rgb
    surface_line: Rgb
    series: tuple[Rgb, Rgb, Rgb, Rgb, Rgb]
    undefined: Rgb
    comparison: Rgb
    section: Rgb
    cell: Rgb
    edge: Rgb
    hover: Rgb
    idle_ink: Rgb
    accent_cell: Rgb
    pending: Rgb
    pending_cell: Rgb
    warn: Rgb
    bad: Rgb
    bad_cell: Rgb
    window: Rgb
    button: Rgb
    tool_tip: Rgb
    light: Rgb
    midlight: Rgb
    mid: Rgb
    dark: Rgb
    shadow: Rgb
    faded_ink: Rgb
    placeholder_ink: Rgb
    selected_ink: Rgb


_THEMES = {
    ThemeName.LIGHT: Theme(
        name=ThemeName.LIGHT,
        background=(255, 255, 255),
        pane=(247, 248, 250),
        grid=(221, 224, 229),
        axis=(120, 126, 135),
        ink=(32, 36, 42),
        quiet_ink=(92, 98, 107),
        accent=(28, 100, 216),
        point=(52, 60, 72),
        selected=(208, 90, 0),
        rim=(255, 255, 255),
        net=(70, 78, 90),
        row_curve=(16, 20, 26),
        column_curve=(28, 100, 216),
        smooth_joint=(214, 218, 226),
        sharp_joint=(214, 40, 57),
        surface_line=(0, 0, 0),
        series=((201, 57, 43), (190, 112, 0), (20, 132, 88), (28, 100, 216), (128, 62, 178)),
        undefined=(146, 149, 155),
        comparison=(190, 24, 120),
        section=(0, 126, 152),
        cell=(255, 255, 255),
        edge=(208, 211, 217),
        hover=(150, 156, 166),
        idle_ink=(112, 118, 127),
        accent_cell=(225, 236, 255),
        pending=(202, 138, 4),
        pending_cell=(255, 243, 205),
        warn=(176, 104, 0),
        bad=(198, 40, 40),
        bad_cell=(255, 230, 228),
        window=(243, 244, 246),
        button=(250, 251, 252),
        tool_tip=(255, 255, 255),
        light=(255, 255, 255),
        midlight=(233, 235, 238),
        mid=(210, 213, 218),
        dark=(168, 173, 182),
        shadow=(138, 143, 152),
        faded_ink=(163, 168, 176),
        placeholder_ink=(108, 114, 123),
        selected_ink=(255, 255, 255),
    ),
    ThemeName.DARK: Theme(
        name=ThemeName.DARK,
        background=(32, 35, 40),
        pane=(38, 41, 47),
        grid=(60, 64, 72),
        axis=(128, 134, 144),
        ink=(232, 234, 238),
        quiet_ink=(166, 172, 181),
        accent=(92, 157, 255),
        point=(206, 212, 222),
        selected=(255, 148, 56),
        rim=(24, 26, 30),
        net=(190, 196, 206),
        row_curve=(245, 246, 248),
        column_curve=(92, 157, 255),
        smooth_joint=(214, 219, 228),
        sharp_joint=(255, 92, 105),
        surface_line=(0, 0, 0),
        series=((255, 122, 108), (238, 176, 66), (74, 200, 142), (92, 157, 255), (190, 142, 245)),
        undefined=(146, 149, 155),
        comparison=(255, 120, 200),
        section=(84, 214, 232),
        cell=(30, 32, 36),
        edge=(74, 78, 86),
        hover=(120, 126, 136),
        idle_ink=(148, 154, 163),
        accent_cell=(36, 56, 88),
        pending=(245, 196, 66),
        pending_cell=(66, 54, 20),
        warn=(240, 180, 80),
        bad=(255, 122, 115),
        bad_cell=(78, 34, 34),
        window=(38, 41, 47),
        button=(53, 57, 65),
        tool_tip=(53, 57, 65),
        light=(74, 79, 89),
        midlight=(60, 64, 72),
        mid=(58, 62, 70),
        dark=(23, 25, 28),
        shadow=(16, 17, 20),
        faded_ink=(107, 113, 123),
        placeholder_ink=(152, 160, 170),
        selected_ink=(16, 20, 28),
    ),
}


def theme_of(name: ThemeName) -> Theme:
    """Return the colours that go by a name."""
    return _THEMES[ThemeName(name)]
