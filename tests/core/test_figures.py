"""What the paper's figures show, asked of the drawing itself and of the files."""

import re
import subprocess
import xml.etree.ElementTree as ET

import numpy as np
import pytest
from PIL import Image

from qovr_core import SourceError, configure
from qovr_core.figures import draw_figure, find_figures
from qovr_core.presets import figure_cases
from support.command import qovr


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
    run = qovr("figures", tmp_path / "made/here", "--only", "fig6b,fig8", "--dpi", "120")
    assert (run.code, run.out, run.err) == (0, "", "")
    folder = tmp_path / "made/here"
    names = [f"{name}.{kind}" for name in ("fig6b", "fig8a", "fig8b") for kind in ("pdf", "png", "svg")]
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


def test_figures_are_found_by_name_and_by_number():
    assert [case.name for case in find_figures([])] == list(figure_cases())
    assert [case.name for case in find_figures(["fig8b", "fig6"])] == ["fig6a", "fig6b", "fig6c", "fig6d", "fig8b"]
    with pytest.raises(SourceError, match="there is no figure 'fig'"):
        find_figures(["fig"])


def test_figures_need_no_display_and_no_qt(tmp_path):
    code = (
        "import sys; from qovr_core.cli import main; "
        f"assert main(['figures', {str(tmp_path)!r}, '--only', 'fig7a', '--formats', 'png', '--dpi', '50']) == 0; "
        "assert not [name for name in sys.modules if name.startswith(('PySide6', 'matplotlib.pyplot'))]"
    )
    import sys

    from support.command import environment

    subprocess.run([sys.executable, "-W", "error", "-c", code], env=environment(), check=True)
