"""What the paper's figures show, asked of the drawing itself and of the files."""

import re
import subprocess
import sys
import xml.etree.ElementTree as ET
from dataclasses import replace

import numpy as np
import pytest
from PIL import Image

from qovr_core import SourceError, configure, curve_network
from qovr_core.edits import Direction
from qovr_core.figures import draw_figure, draw_network, find_figures
from qovr_core.figures.curve_axes import SERIES
from qovr_core.figures.curves import Sheet, draw_curve, draw_knots, draw_parabolas, draw_sensitivity
from qovr_core.laboratory.one_curve import SAMPLES, OneCurve, curve_of
from qovr_core.laboratory.planes import View, plane_of
from qovr_core.presets import curve_case, figure_cases, network_case
from support.command import environment, qovr
from support.documents import random_document


def drawn(name):
    case = figure_cases()[name]
    surface = configure(case.preset.document)
    return draw_figure(surface, layer=case.layer, camera=case.camera), surface, case


@pytest.mark.parametrize("name", figure_cases())
def test_every_figure_shows_what_the_paper_describes(name):
    figure, surface, case = drawn(name)
    axes, bar = figure.axes
    facets = next(part for part in axes.collections if type(part).__name__ == "Poly3DCollection")
    points = surface.raw if case.layer == "raw" else surface.transformed
    heights = points[..., 2]
    means = (heights[:-1, :-1] + heights[1:, :-1] + heights[:-1, 1:] + heights[1:, 1:]) / 4
    assert np.sort(np.asarray(facets.get_array())) == pytest.approx(np.sort(means.ravel()))
    assert facets.get_cmap().name == "jet"
    assert facets.get_linewidth()[0] > 0
    assert (axes.azim, axes.elev) == ((-54.0, 64.0) if case.camera == "paper" else (-90.0, 90.0))
    assert axes.get_xlabel() == "X-Axis"
    assert axes.get_ylabel() == "Y-Axis"
    assert axes.get_zlabel() == ("" if case.camera == "top" else "Z-Axis")
    assert bar.get_ylabel() == "Z-Axis Value"
    assert {text.get_text().strip() for text in axes.texts} == {f"P{i},{j}" for i in range(5) for j in range(5)}
    discs = next(part for part in axes.collections if type(part).__name__ == "Path3DCollection")
    shown = np.stack([np.asarray(axis, dtype=float) for axis in discs._offsets3d], axis=-1)
    assert shown == pytest.approx(surface.document.control_points.reshape(-1, 3))
    red, green, blue, _ = discs.get_facecolor()[0]
    assert blue > 0.9
    assert max(red, green) < 0.5


def test_the_raw_figure_shows_the_raw_surface_beside_the_net():
    figure, surface, _ = drawn("fig5a")
    assert figure.axes[0].get_xlim()[1] > 29
    assert surface.raw_box[0, 1] == pytest.approx(30)


def test_the_command_draws_all_kinds_of_files(tmp_path):
    run = qovr("figures", tmp_path / "made/here", "--only", "fig1,fig6b", "--dpi", "120")
    assert (run.code, run.out, run.err) == (0, "", "")
    folder = tmp_path / "made/here"
    names = [f"{name}.{kind}" for name in ("fig1a", "fig1b", "fig1c", "fig6b") for kind in ("pdf", "png", "svg")]
    assert sorted(entry.name for entry in folder.iterdir()) == names
    with Image.open(folder / "fig6b.png") as image:
        assert image.size == (768, 624)
        assert image.info["dpi"] == pytest.approx((120, 120), abs=0.1)
        colours = len(image.convert("RGB").getcolors(1_000_000))
    assert colours > 1000
    assert ET.parse(folder / "fig6b.svg").getroot().tag.endswith("svg")
    pdf = (folder / "fig6b.pdf").read_bytes()
    assert pdf.startswith(b"%PDF")
    assert re.search(rb"%%EOF\s*$", pdf)


def lines_of(axes):
    """Return the lines of a drawing by their labels, each (n, 2) and with its colour."""
    lines = {}
    for line in axes.lines:
        lines.setdefault(line.get_label(), []).append((line.get_xydata(), line.get_color()))
    return lines


def texts_of(axes):
    return {text.get_text().split("\n")[0] for text in axes.texts}


def test_figure_1a_shows_three_parabolas_and_what_of_them_is_blended():
    curve = OneCurve(*curve_case())
    (axes,) = draw_parabolas(curve).axes
    lines = lines_of(axes)
    assert texts_of(axes) == {"$P_0$", "$P_1$", "$P_2$", "$P_3$", "$P_4$", "$Q_0(r)$", "$Q_1(s)$", "$Q_2(t)$"}
    for p in range(3):
        whole, colour = lines["parabola"][p]
        part, colour_of_part = lines["blended segment"][p]
        knot = curve.internal_knots[p]
        assert colour == colour_of_part == SERIES[p + 1]
        assert whole[[0, -1]] == pytest.approx(curve.points[[p, p + 2], :2])
        assert part[[0, -1]] == pytest.approx(curve.points[[(1, 2), (1, 3), (2, 3)][p], :2])
        assert curve.parabola(p, [knot])[0, :2] == pytest.approx(curve.points[p + 1, :2])
    discs = axes.collections[-1].get_offsets()
    assert np.asarray(discs) == pytest.approx(curve.points[:, :2])


def test_figure_1b_shows_the_curve_through_its_knots_and_the_auxiliary_segments():
    curve = OneCurve(*curve_case())
    figure = draw_knots(curve)
    (axes,) = figure.axes
    lines = lines_of(axes)
    ((drawn, _),) = lines["$C(u)$"]
    assert drawn == pytest.approx(curve.at(SAMPLES)[:, :2])
    ends = [line[[0, -1]] for line, _ in lines["auxiliary segment"]]
    assert ends[0][0] == pytest.approx(curve.points[2, :2])
    assert ends[2][-1] == pytest.approx(curve.points[2, :2])
    named = [text.get_text() for text in axes.texts if "ip" in text.get_text()]
    assert len(named) == 3
    for text, knot in zip(named, curve.internal_knots, strict=True):
        assert f"{knot:g}$" in text
    assert names_touch_nothing(figure, axes)


def names_touch_nothing(figure, axes):
    """Whether the names lie inside the drawing and none covers another."""
    figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in axes.texts]
    inside = all(axes.bbox.x0 <= box.x0 and box.x1 <= axes.bbox.x1 and axes.bbox.y0 <= box.y0 for box in boxes)
    return inside and not any(a.overlaps(b) for k, a in enumerate(boxes) for b in boxes[:k])


def test_figure_1c_shows_the_curve_for_several_values_of_each_knot():
    curve = OneCurve(*curve_case())
    drawings = draw_sensitivity(curve).axes
    assert [axes.get_title() for axes in drawings] == ["$r_{ip}$", "$s_{ip}$", "$u_{ip}$", "$t_{ip}$"]
    for axes, name in zip(drawings, "rsut", strict=True):
        lines = lines_of(axes)
        for value in (0.3, 0.4, 0.5, 0.6, 0.7):
            changed = replace(curve, knots=replace(curve.knots, **{name: value}))
            ((drawn, _),) = lines[f"{value:g}"]
            assert drawn == pytest.approx(changed.at(SAMPLES)[:, :2])


def test_figure_2_shows_the_network_over_its_net():
    document = network_case().document
    (axes,) = draw_network(document).axes
    net = document.control_points
    lines = [np.array(line.get_data_3d()).T for line in axes.lines]
    assert len(lines) == 20
    network = curve_network(document)
    for line, curve in zip(lines[10:], [*network.rows[:, 0], *network.columns[:, 0]], strict=True):
        assert line[[0, -1]] == pytest.approx(curve[[0, -1]])
    names = {text.get_text().strip() for text in axes.texts}
    assert names == (
        {f"P{i},{j}" for i in range(5) for j in range(5)}
        | {f"$C_{i}(u)$" for i in range(5)}
        | {f"$K_{j}(v)$" for j in range(5)}
    )
    assert lines[0] == pytest.approx(net[0])


@pytest.mark.parametrize("s", [0.5, 0.9])
@pytest.mark.parametrize("view", View)
def test_one_curve_of_a_document_is_drawn_with_its_weights(s, view):
    document = random_document(4, low=0.3, high=0.7)
    knots = replace(document.column_knots[2, 0], s=s, u=0.5)
    curve = replace(curve_of(document, Direction.COLUMNS, 2), knots=knots)
    figure = draw_curve(curve, Sheet(view, (6.3, 4.7)))
    curve_axes, blends, weights, places = figure.axes
    plane = plane_of(curve.points, view)
    ((drawn, _),) = lines_of(curve_axes)["$K(v)$"]
    assert drawn == pytest.approx(plane.drawn(curve.at(SAMPLES)))
    assert ("folds back" in lines_of(curve_axes)) == (s == 0.9)
    for axes, values in ((blends, curve.blends), (weights, curve.weights), (places, curve.transformed)):
        shown = np.array([line.get_ydata() for line in axes.lines if len(line.get_ydata()) == len(SAMPLES)])
        is_seen = np.isfinite(shown.T)  # r and t run out of the drawing
        assert shown.T[is_seen] == pytest.approx(values(SAMPLES)[is_seen])
        assert is_seen.mean() > 0.9
    if view in (View.BEST, View.YZ):  # the others show this column from its edge, where all lies on one line
        assert names_touch_nothing(figure, curve_axes)


def test_figures_are_found_by_name_and_by_number():
    assert find_figures([]) == ["fig1a", "fig1b", "fig1c", "fig2", *figure_cases()]
    assert find_figures(["fig8b", "fig6"]) == ["fig6a", "fig6b", "fig6c", "fig6d", "fig8b"]
    assert find_figures(["fig2", "fig1"]) == ["fig1a", "fig1b", "fig1c", "fig2"]
    with pytest.raises(SourceError, match="there is no figure 'fig'"):
        find_figures(["fig"])


def figures_in(folder, **changes):
    """Return all files of two figures, drawn in a folder where settings may lie."""
    folder.mkdir(exist_ok=True)
    code = "import sys; from qovr_core.cli import main; sys.exit(main(sys.argv[1:]))"
    call = [sys.executable, "-c", code, "figures", "out", "--only", "fig2", "--formats", "svg,pdf"]
    done = subprocess.run(call, cwd=folder, env=environment(**changes), capture_output=True, text=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (0, "", "")
    return {path.name: path.read_bytes() for path in (folder / "out").iterdir()}


USERS_SETTINGS = """
font.family: serif
font.size: 30
axes.facecolor: pink
lines.linewidth: 9
savefig.bbox: tight
pdf.fonttype: 3
svg.fonttype: path
axes.formatter.use_locale: True
text.usetex: True
no.such.setting: 1
"""


def test_figures_are_the_same_whatever_a_users_settings_say(tmp_path):
    (tmp_path / "settings").mkdir()
    (tmp_path / "settings/matplotlibrc").write_text(USERS_SETTINGS)
    plain = figures_in(tmp_path / "plain")
    assert figures_in(tmp_path / "settings", LC_ALL="C.UTF-8") == plain
    for name, content in plain.items():
        if name.endswith(".pdf"):
            assert b"/CIDFontType2" in content
            assert b"/Type3" not in content
            assert b"/DCTDecode" not in content
            assert b"/Title (QOVR surfaces, Figure" in content
        elif name.endswith(".svg"):
            texts = [element for element in ET.fromstring(content).iter() if element.tag.endswith("}text")]
            said = {"".join(element.itertext()).strip() for element in texts}
            expected = {f"P{i},{j}" for i in range(5) for j in range(5)} | {"X-Axis"} if name == "fig2.svg" else set()
            assert expected <= said
            assert len(said) > 10
            assert b"<title>QOVR surfaces, Figure" in content


def test_figures_need_no_display_and_no_qt(tmp_path):
    code = (
        "import sys; from qovr_core.cli import main; "
        f"assert main(['figures', {str(tmp_path)!r}, '--only', 'fig7a', '--formats', 'png', '--dpi', '50']) == 0; "
        "assert not [name for name in sys.modules if name.startswith(('PySide6', 'matplotlib.pyplot'))]"
    )
    subprocess.run([sys.executable, "-W", "error", "-c", code], env=environment(), check=True)
