"""The program as it is installed: its wheel in an environment of its own, called from another folder."""

import json
import os
import shutil
import subprocess
import sys
import sysconfig
import tomllib
import venv
import zipfile
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from qovr_core.files.formats import FORMATS
from support.structure import PATHS, ROOT

SOURCES = ("qovr_core", "qovr_app", "resources", "pyproject.toml", "README.md", "LICENSE")


@dataclass
class Installed:
    """An environment that holds the locked dependencies, and the project from its wheel alone."""

    wheel: Path
    folder: Path
    commands: Path
    work: Path

    def run(self, command, *arguments):
        """Run one of the environment's commands in the folder ``work`` and return what it prints."""
        environment = {name: value for name, value in os.environ.items() if name != "PYTHONPATH"}
        environment["XDG_CONFIG_HOME"] = str(self.folder / "config")
        call = [self.commands / command, *map(str, arguments)]
        done = subprocess.run(
            call, cwd=self.work, env=environment, capture_output=True, text=True, timeout=300, check=False
        )
        assert (done.returncode, done.stderr) == (0, "")
        return done.stdout


@pytest.fixture(scope="module")
def installed(tmp_path_factory):
    """The wheel of this checkout, built and installed with no network."""
    folder = tmp_path_factory.mktemp("installed")
    pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    wheel = ["wheel", "--no-deps", "--no-index", "--no-build-isolation", "--wheel-dir", folder]
    subprocess.run([*pip, *wheel, copy_of_the_sources(folder / "sources")], check=True, capture_output=True)
    (built,) = folder.glob("*.whl")

    builder = venv.EnvBuilder(with_pip=False)
    context = builder.ensure_directories(folder / "environment")
    builder.create(folder / "environment")
    subprocess.run([*pip, "--python", context.env_exe, "install", "--no-deps", "--no-index", built], check=True)
    result = Installed(built, folder, Path(context.bin_path), folder / "work")
    result.work.mkdir()
    own = result.run(Path(context.env_exe).name, "-c", "import sysconfig; print(sysconfig.get_path('purelib'))").strip()
    # A line in a .pth file is a place to look for modules, and no more: an editable install there comes to nothing.
    locked = {sysconfig.get_path("purelib"), sysconfig.get_path("platlib")}
    Path(own, "locked.pth").write_text("\n".join(locked), encoding="utf-8")
    return result


def copy_of_the_sources(folder):
    """Copy what a wheel is made from, so that building leaves nothing in the checkout."""
    folder.mkdir()
    for name in SOURCES:
        if (ROOT / name).is_dir():
            shutil.copytree(ROOT / name, folder / name, ignore=shutil.ignore_patterns("__pycache__"))
        else:
            shutil.copy(ROOT / name, folder)
    return folder


def test_the_wheel_holds_every_module_the_resources_types_and_licence(installed):
    with zipfile.ZipFile(installed.wheel) as archive:
        held = set(archive.namelist())
        (metadata,) = (archive.read(name).decode() for name in held if name.endswith(".dist-info/METADATA"))
    resources = [path for path in (ROOT / "resources").rglob("*") if path.is_file() and "__pycache__" not in path.parts]
    assert {f"qovr_resources/{path.relative_to(ROOT / 'resources').as_posix()}" for path in resources} <= held
    assert {path.relative_to(ROOT).as_posix() for path in PATHS.values()} <= held
    assert {"qovr_core/py.typed", "qovr_app/py.typed"} <= held
    assert any(name.endswith(".dist-info/licenses/LICENSE") for name in held)
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert f"Keywords: {','.join(project['keywords'])}" in metadata
    assert all(f"Classifier: {line}" in metadata for line in project["classifiers"])


def test_every_module_is_imported_from_the_installed_copy(installed):
    code = (
        f"from importlib import import_module\nfiles = [import_module(name).__file__ for name in {list(PATHS)!r}]\n"
        "import json, qovr_resources; print(json.dumps([*files, qovr_resources.__file__]))"
    )
    files = json.loads(installed.run("python", "-c", code))
    assert [file for file in files if not Path(file).is_relative_to(installed.folder / "environment")] == []


def test_every_format_and_a_figure_are_written_and_read_back(installed):
    outs = [f"out{suffix}" for suffix in FORMATS]
    installed.run("qovr", "export", "paper:fig6b", *outs, "--samples", "9")
    assert all((installed.work / out).stat().st_size > 100 for out in outs)
    assert "published" in installed.run("qovr", "reproduce", "out.xlsx")
    assert installed.run("qovr", "info", "out.3dm") == installed.run("qovr", "info", "out.qovr")
    installed.run("qovr", "figures", "figures", "--only", "fig6b", "--dpi", "40", "--formats", "png,pdf")
    assert sorted(path.suffix for path in (installed.work / "figures").iterdir()) == [".pdf", ".png"]


def test_the_window_opens_with_its_surface(installed, display):
    installed.run("qovr", "screenshot", "window.png", "paper:fig8", "--size", "1280x720")
    with Image.open(installed.work / "window.png") as image:
        pixels = np.asarray(image.convert("RGB")).astype(int)
    assert pixels.shape == (720, 1280, 3)
    assert (np.ptp(pixels, axis=-1) > 60).mean() > 0.05  # no shade of grey: the surface
