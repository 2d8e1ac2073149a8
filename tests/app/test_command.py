"""``qovr screenshot`` and ``qovr [SOURCE]`` as other processes."""

import os
import shutil
import subprocess
import sys

import numpy as np
import pytest
from PIL import Image

from support.command import QOVR, qovr, refused


@pytest.fixture
def on_display(app, tmp_path):
    """Run the command where there is a display, with settings of its own."""

    def run(*arguments, **variables):
        environment = {**os.environ, "XDG_CONFIG_HOME": str(tmp_path / "config"), **variables}
        call = [QOVR, *map(str, arguments)]
        return subprocess.run(
            call, env=environment, capture_output=True, text=True, check=False, timeout=120, cwd=tmp_path
        )

    return run


def pixels(path):
    with Image.open(path) as image:
        return np.asarray(image.convert("RGB")).astype(int)


def share_of_colours(image):
    """Return the share of pixels that are no shade of grey: the surface."""
    return float((np.ptp(image, axis=-1) > 60).mean())


def test_a_screenshot_shows_the_window_with_its_surface(on_display, tmp_path):
    run = on_display("screenshot", "a.png", "paper:fig8", "--size", "1300x760")
    assert (run.returncode, run.stdout, run.stderr) == (0, "", "")
    image = pixels(tmp_path / "a.png")
    assert image.shape == (760, 1300, 3)
    assert share_of_colours(image) > 0.05
    assert np.median(image) > 200


def test_a_dark_screenshot_from_above_at_scale_2(on_display, tmp_path):
    call = ("screenshot", "a.png", "--size", "1280x720", "--scale", "2", "--theme", "dark", "--camera", "top")
    assert on_display(*call).returncode == 0
    image = pixels(tmp_path / "a.png")
    assert image.shape == (1440, 2560, 3)
    assert np.median(image) < 80
    assert share_of_colours(image) > 0.05


def test_two_documents_make_two_pictures(on_display, tmp_path):
    for name in ("fig5", "fig8"):
        assert on_display("screenshot", f"{name}.png", f"paper:{name}", "--size", "1280x720").returncode == 0
    difference = np.abs(pixels(tmp_path / "fig5.png") - pixels(tmp_path / "fig8.png")).max(axis=-1)
    assert (difference > 60).mean() > 0.02


def test_without_opengl_the_screenshot_still_shows_the_surface(on_display, tmp_path):
    assert on_display("screenshot", "a.png", "--size", "1280x720", QT_QPA_PLATFORM="offscreen").returncode == 0
    assert share_of_colours(pixels(tmp_path / "a.png")) > 0.05


@pytest.mark.parametrize(
    ("call", "message"),
    [
        (("screenshot", "a.jpg"), "a.jpg: a screenshot is a PNG"),
        (("screenshot", "a.png", "--size", "10"), "'10' is no size; expected WIDTHxHEIGHT"),
        (("screenshot", "a.png", "--size", "400x300"), "400 x 300 is too small for the window; expected at least"),
        (("screenshot", "a.png", "--scale", "9"), "'9' is no scale factor; expected a number from 1 to 4"),
        (("screenshot", "a.png", "paper:fig9"), "there is no preset 'fig9'"),
        (("screenshot", "no/such/a.png"), "the folder no/such does not exist"),
        (("exprot",), "exprot: is no source"),
    ],
)
def test_refusals(on_display, tmp_path, call, message):
    run = on_display(*call)
    assert run.returncode == 2
    assert run.stderr.startswith("qovr: ")
    assert run.stderr.count("\n") == 1
    assert message in run.stderr
    assert [entry.name for entry in tmp_path.iterdir() if entry.suffix != ""] == []


@pytest.mark.skipif(sys.platform != "linux", reason="other systems always have a display")
@pytest.mark.parametrize("call", [(), ("paper:fig5",), ("screenshot", "a.png")])
def test_without_a_display_the_window_is_refused_in_words(call, tmp_path):
    assert "there is no display" in refused(qovr(*call, cwd=tmp_path))


@pytest.mark.skipif(sys.platform != "linux", reason="other systems always have a display")
@pytest.mark.parametrize("call", [("paper:fig5",), ("screenshot", "a.png")])
@pytest.mark.parametrize(
    ("variables", "message"),
    [
        ({"DISPLAY": ":9999"}, "':9999' (DISPLAY) does not answer"),
        ({"DISPLAY": "no such:place"}, "'no such:place' (DISPLAY) does not answer"),
        ({"QT_QPA_PLATFORM": "nonsense"}, "QT_QPA_PLATFORM is 'nonsense'; expected one of eglfs, "),
        ({"QT_QPA_PLATFORM": "xcb", "DISPLAY": ""}, "'' (DISPLAY) does not answer"),
        ({"WAYLAND_DISPLAY": "nothing", "DISPLAY": ""}, "wayland"),
    ],
)
def test_where_no_window_can_be_had_one_line_says_so(on_display, tmp_path, call, variables, message):
    run = on_display(*call, **variables)
    assert run.returncode == 2, run.stderr
    assert run.stderr.startswith("qovr: no window can be opened: ")
    assert run.stderr.count("\n") == 1
    assert len(run.stderr) <= 300
    assert message.lower() in run.stderr.lower()


@pytest.mark.skipif(shutil.which("Xvfb") is None, reason="there is no Xvfb")
def test_a_display_without_glx_shows_the_surface_through_egl(on_display, tmp_path):
    read, write = os.pipe()
    command = ["Xvfb", "-displayfd", str(write), "-screen", "0", "1440x900x24", "-nolisten", "tcp", "-extension", "GLX"]
    with subprocess.Popen(command, pass_fds=(write,), stderr=subprocess.DEVNULL) as server:
        os.close(write)
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        run = on_display("screenshot", "a.png", "paper:fig8", "--size", "1280x720", DISPLAY=f":{number}")
        server.terminate()
    assert (run.returncode, run.stderr) == (0, "")
    assert share_of_colours(pixels(tmp_path / "a.png")) > 0.02


def test_softpipe_draws_the_surface(on_display, tmp_path):
    run = on_display("screenshot", "a.png", "paper:fig8", "--size", "1280x720", GALLIUM_DRIVER="softpipe")
    assert (run.returncode, run.stderr) == (0, "")
    assert share_of_colours(pixels(tmp_path / "a.png")) > 0.02


def test_methods_that_return_nothing_keep_their_references(app):
    """PySide6 6.12.0 loses a reference to None at every such call on CPython 3.11, until the process aborts."""
    from PySide6.QtCore import QObject, Signal
    from PySide6.QtWidgets import QLabel

    class Emitter(QObject):
        emitted = Signal(int)

    label, emitter = QLabel(), Emitter()
    before = sys.getrefcount(None), sys.getrefcount(True)
    for k in range(2000):
        label.setText("text")
        emitter.emitted.emit(k)
    after = sys.getrefcount(None), sys.getrefcount(True)
    assert abs(after[0] - before[0]) < 100
    assert abs(after[1] - before[1]) < 100


def test_the_start_of_a_window_reads_no_source_and_imports_nothing_for_what_is_not_shown(display, tmp_path):
    """PySide6 would, that of every module which is imported after it; what is read is kept in the cache of lines."""
    code = (
        "import gc, linecache, sys\nfrom qovr_app.main import main\n"
        f"sys.argv = ['qovr', 'screenshot', {str(tmp_path / 'window.png')!r}]\n"
        "try: main()\nexcept SystemExit as end: assert not end.code\n"
        "late = 'qovr_app.dialogs.ex qovr_app.dialogs.net qovr_app.view3d.figure matplotlib pyqtgraph scipy'\n"
        "assert not [name for name in sys.modules if name.startswith(tuple(late.split()))]\n"
        "assert not [name for name in linecache.cache if 'qovr' in name or 'numpy' in name]\nassert gc.isenabled()"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
