"""Figures: size, ground, proportions, vectors, and files that are whole or not there."""

import re
import zlib

import numpy as np
import pytest
from PySide6.QtGui import QImage
from PySide6.QtTest import QTest

from qovr_app.state.display import LayerChoice
from qovr_app.state.figure_options import FigureOptions
from qovr_core import FileError
from support.view import choose


@pytest.fixture(params=["opengl", "painter"])
def view(request, make_view, document):
    if request.param == "painter":
        request.getfixturevalue("no_opengl")
    return make_view(document, layer=LayerChoice.RAW, size=(600, 480)).view


def test_png_has_the_size_and_the_resolution(view, tmp_path):
    view.save_figure(tmp_path / "a.png", FigureOptions(80, 60, 300))
    image = QImage(str(tmp_path / "a.png"))
    assert (image.width(), image.height()) == (945, 709)
    assert image.dotsPerMeterX() == pytest.approx(300 / 0.0254, rel=0.01)
    view.save_figure(tmp_path / "b.png", FigureOptions(640, 333, None))
    image = QImage(str(tmp_path / "b.png"))
    assert (image.width(), image.height()) == (640, 333)


def test_a_figure_is_the_picture_enlarged(view, tmp_path):
    """Twice the pixels: the same picture, its lines and letters twice as large."""
    width, height = view.width(), view.height()
    view.save_figure(tmp_path / "one.png", FigureOptions(width, height, None))
    view.save_figure(tmp_path / "two.png", FigureOptions(2 * width, 2 * height, None))
    one = QImage(str(tmp_path / "one.png")).convertToFormat(QImage.Format.Format_RGB32)
    two = QImage(str(tmp_path / "two.png")).convertToFormat(QImage.Format.Format_RGB32)
    small = two.scaled(one.size(), mode=view_mode())
    difference = [
        np.abs(np.subtract(small.pixelColor(x, y).getRgb(), one.pixelColor(x, y).getRgb())).max()
        for x in range(0, width, 7)
        for y in range(0, height, 7)
    ]
    assert np.mean(np.array(difference) > 70) < 0.02


def view_mode():
    from PySide6.QtCore import Qt

    return Qt.TransformationMode.SmoothTransformation


def test_a_large_figure_has_no_seams(view, tmp_path):
    """Beyond one tile the surface goes on where it left off."""
    choose(
        view,
        parameter_lines=False,
        control_net=False,
        control_points=False,
        labels=False,
        axes=False,
    )
    view.set_camera("top", animated=False)
    view.save_figure(tmp_path / "a.png", FigureOptions(2600, 2100, None))
    image = QImage(str(tmp_path / "a.png"))
    steps = [
        np.abs(np.subtract(image.pixelColor(x, y).getRgb(), image.pixelColor(x + 1, y + 1).getRgb())).max()
        for x, y in zip(range(2030, 2070), range(1000, 1040), strict=True)
    ]
    assert max(steps) < 60


def test_a_transparent_png_has_no_ground(view, tmp_path):
    view.save_figure(tmp_path / "a.png", FigureOptions(300, 240, None, transparent=True))
    image = QImage(str(tmp_path / "a.png"))
    assert image.pixelColor(1, 1).alpha() == 0
    assert image.pixelColor(130, 120).alpha() > 240


def test_svg_holds_the_surface_as_image_and_the_rest_as_vectors(view, tmp_path):
    view.save_figure(tmp_path / "a.svg", FigureOptions(160, 120, 150))
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert len(re.findall(r"<image", text)) == 2  # the surface and the colour bar's gradient
    assert text.count("<path") > 20
    assert text.count("<text") > 40
    size = re.search(r'width="([\d.]+)mm" height="([\d.]+)mm"', text).groups()
    assert [float(side) for side in size] == pytest.approx([160, 120], abs=0.01)


def test_pdf_has_the_size_in_points(view, tmp_path):
    view.save_figure(tmp_path / "a.pdf", FigureOptions(160, 120, 150))
    data = (tmp_path / "a.pdf").read_bytes()
    assert data.startswith(b"%PDF")
    box = re.search(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", data)
    assert [float(value) for value in box.groups()] == pytest.approx([453.5, 340.2], abs=1)


def test_vectors_keep_text_as_text_and_carry_a_title(view, tmp_path):
    view.save_figure(tmp_path / "a.svg", FigureOptions(160, 120, 150))
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    assert "<title>QOVR surface</title>" in text
    said = "".join(re.findall(r"<text[^>]*>([^<]*)</text>", text))
    assert "0,0" in said
    assert "X-Axis" in said
    view.save_figure(tmp_path / "a.pdf", FigureOptions(160, 120, 150))
    data = (tmp_path / "a.pdf").read_bytes()
    assert b"/CIDFontType2" in data
    assert b"/DCTDecode" not in data
    assert b"/Type3" not in data
    assert "QOVR surface".encode("utf-16-be") in data or b"(QOVR surface)" in data


def test_a_pdf_draws_only_hidden_discs_dim(view, tmp_path):
    """A PDF of Qt's takes what follows for translucent too where an opacity changes alone."""
    choose(view, layer=LayerChoice.TRANSFORMED)  # which lies in its net and hides some of it
    view.save_figure(tmp_path / "a.pdf", FigureOptions(160, 120, 100))
    data = (tmp_path / "a.pdf").read_bytes()
    page = max((unpacked(part) for part in data.split(b"stream\n")[1::2]), key=lambda text: text.count(b" gs\n"))
    opacity, discs = b"", []
    for state, fill in re.findall(rb"/(\w+) gs|\n(B\*?)\n", page):
        opacity = state or opacity
        discs += [opacity] if fill else []
    assert set(discs) == {b"GSa"}  # filled and rimmed at once, which translucent ones are not
    assert len(discs) >= 15


def unpacked(stream):
    try:
        return zlib.decompressobj().decompress(stream)
    except zlib.error:
        return b""


def test_a_figure_is_the_same_whatever_the_day(view, tmp_path, monkeypatch):
    for suffix in ("png", "svg", "pdf"):
        for name in "ab":
            view.save_figure(tmp_path / f"{name}.{suffix}", FigureOptions(80, 60, 100))
            QTest.qWait(1100 if name == "a" and suffix == "pdf" else 0)
        assert (tmp_path / f"a.{suffix}").read_bytes() == (tmp_path / f"b.{suffix}").read_bytes()
    data = (tmp_path / "a.pdf").read_bytes()
    assert b"Date" not in data
    place = int(re.search(rb"startxref\s+(\d+)", data)[1])
    assert data[place : place + 4] == b"xref"
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "1700000000")
    view.save_figure(tmp_path / "c.pdf", FigureOptions(80, 60, 100))
    data = (tmp_path / "c.pdf").read_bytes()
    assert b"D:20231114221320Z" in data
    assert b"2023-11-14T22:13:20Z" in data


def test_each_of_two_viewports_is_clipped_by_an_element_of_its_own(make_view, document, tmp_path):
    view = make_view(document, layer=LayerChoice.BOTH, size=(900, 400)).view
    view.save_figure(tmp_path / "a.svg", FigureOptions(180, 80, 100))
    text = (tmp_path / "a.svg").read_text(encoding="utf-8")
    clips = dict(re.findall(r'<clipPath id="([^"]+)">\s*<path[^>]* d="([^"]+)"', text))
    spans = sorted({tuple(sorted({float(x) for x in re.findall(r"[ML](-?[\d.]+),", path)})) for path in clips.values()})
    assert [tuple(round(x, -1) for x in span) for span in spans] == [(0, 9000), (9000, 18000)]
    assert set(re.findall(r'clip-path="url\(#([^)]+)\)"', text)) == set(clips)


def test_two_layers_make_one_figure(make_view, document, tmp_path):
    view = make_view(document, layer=LayerChoice.BOTH, size=(900, 400)).view
    view.save_figure(tmp_path / "a.png", FigureOptions(900, 400, None))
    image = QImage(str(tmp_path / "a.png"))
    for left in (0, 450):
        hues = {image.pixelColor(left + x, 200).hue() // 30 for x in range(80, 330, 3)}
        assert len(hues) > 3


@pytest.mark.parametrize(
    ("name", "options"),
    [
        ("a.bmp", FigureOptions()),
        ("no/such/folder/a.png", FigureOptions(100, 100, None)),
        ("a.png", FigureOptions(3000, 10, 300)),
    ],
)
def test_what_cannot_be_written_leaves_nothing(view, tmp_path, name, options):
    with pytest.raises(FileError, match=re.escape(name)):
        view.save_figure(tmp_path / name, options)
    assert list(tmp_path.iterdir()) == []


def test_an_older_figure_is_replaced_whole(view, tmp_path):
    target = tmp_path / "a.png"
    target.write_bytes(b"older")
    view.save_figure(target, FigureOptions(200, 150, None))
    assert target.read_bytes().startswith(b"\x89PNG")
    assert [path.name for path in tmp_path.iterdir()] == ["a.png"]


def test_a_driver_that_fails_on_a_figure_leaves_it_to_the_painter(make_view, document, tmp_path, monkeypatch, silenced):
    from qovr_app.view3d.gl import figure as gl_figure
    from qovr_app.view3d.gl.calls import DriverError

    def fail(*args, **kwargs):
        raise DriverError("no framebuffer")

    owner = make_view(document, layer=LayerChoice.RAW)
    monkeypatch.setattr(gl_figure, "sampled_buffer", fail)
    owner.view.save_figure(tmp_path / "a.png", FigureOptions(400, 300, None))
    image = QImage(str(tmp_path / "a.png"))
    assert len({image.pixelColor(x, 150).hue() // 30 for x in range(80, 280, 3)}) > 3
    QTest.qWait(100)
    assert len(owner.reasons) == 1
    assert not owner.view.uses_opengl
