"""The shape of the house: what may load what, how long a module may be, and that an installed copy is whole."""

import ast
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
CORE = sorted((ROOT / "qovr_core").rglob("*.py"))
MODULES = CORE + sorted((ROOT / "qovr_app").rglob("*.py"))
WINDOW_LIBRARIES = {"PySide6", "pyqtgraph", "OpenGL"}
LONGEST_MODULE = 350


def imported(path):
    for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
        if isinstance(node, ast.Import):
            yield from (alias.name.split(".")[0] for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.module:
            yield node.module.split(".")[0]


@pytest.mark.parametrize("path", CORE, ids=lambda path: path.name)
def test_the_core_knows_no_window(path):
    assert not set(imported(path)) & (WINDOW_LIBRARIES | {"qovr_app"})


@pytest.mark.parametrize("path", MODULES, ids=lambda path: path.name)
def test_modules_are_short(path):
    assert len(path.read_text(encoding="utf-8").splitlines()) <= LONGEST_MODULE


def loaded_by(code):
    """Return the top-level modules that are no part of Python itself, after running code in a fresh interpreter."""
    probe = f"{code}\nimport sys; print(*{{name.split('.')[0] for name in sys.modules}})"
    done = subprocess.run([sys.executable, "-c", probe], capture_output=True, text=True, check=True)
    before = subprocess.run(
        [sys.executable, "-c", "import sys; print(*{name.split('.')[0] for name in sys.modules})"],
        capture_output=True,
        text=True,
        check=True,
    )
    loaded = set(done.stdout.split()) - set(before.stdout.split()) - set(sys.stdlib_module_names)
    return {name for name in loaded if "cython" not in name}  # what NumPy's own extensions register


def test_importing_the_core_loads_numpy_alone():
    assert loaded_by("import qovr_core") == {"qovr_core", "numpy"}


def test_a_document_is_evaluated_with_numpy_alone():
    code = "import numpy, qovr_core; qovr_core.configure(qovr_core.Document(numpy.random.random((5, 5, 3))))"
    assert loaded_by(code) == {"qovr_core", "numpy"}


@pytest.mark.parametrize("command", [["presets"], ["info", "paper:fig5"], ["info", "--help"]])
def test_the_command_loads_nothing_heavy_before_it_is_needed(command):
    code = (
        "import sys, contextlib, io\nfrom qovr_app.main import main\n"
        f"sys.argv = ['qovr', *{command!r}]\n"
        "with contextlib.redirect_stdout(io.StringIO()), contextlib.suppress(SystemExit): main()"
    )
    assert loaded_by(code) <= {"qovr_core", "qovr_app", "qovr_resources", "numpy"}


def test_every_command_but_screenshot_runs_without_qt(tmp_path):
    code = (
        "import sys\nfrom qovr_core.cli import main\n"
        f"assert main(['export', 'paper:fig5', r'{tmp_path / 'a.xlsx'}', r'{tmp_path / 'a.npz'}']) == 0\n"
        f"assert main(['figures', r'{tmp_path}', '--only', 'fig5a', '--formats', 'png', '--dpi', '40']) == 0\n"
        f"sys.stdout = None or open(r'{tmp_path / 'log'}', 'w')\n"
        f"assert main(['reproduce', r'{tmp_path / 'a.xlsx'}']) == 0\n"
        "sys.stdout = sys.__stdout__"
    )
    assert not loaded_by(code) & WINDOW_LIBRARIES


def test_a_wheel_brings_every_module_and_the_resources(tmp_path):
    build = [sys.executable, "-m", "pip", "wheel", "--quiet", "--no-deps", "--no-build-isolation", "--wheel-dir"]
    subprocess.run([*build, str(tmp_path), str(copy_of_the_sources(tmp_path))], check=True, capture_output=True)
    (wheel,) = tmp_path.glob("*.whl")
    installed = tmp_path / "installed"
    with zipfile.ZipFile(wheel) as archive:
        archive.extractall(installed)
    resources = {path.relative_to(ROOT / "resources") for path in (ROOT / "resources").rglob("*") if path.is_file()}
    resources = {path for path in resources if path.suffix != ".pyc"}
    assert resources <= {
        path.relative_to(installed / "qovr_resources") for path in (installed / "qovr_resources").rglob("*")
    }
    names = [".".join(path.relative_to(ROOT).with_suffix("").parts) for path in MODULES]
    code = (
        f"import sys; sys.path.insert(0, r'{installed}')\n"
        f"from importlib import import_module\nfor name in {names!r}: import_module(name)\n"
        "import qovr_core, qovr_app\nfrom qovr_core.presets import presets\n"
        f"assert qovr_core.__file__.startswith(r'{installed}')\n"
        "assert len(presets()) == 10\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, cwd=tmp_path)


def copy_of_the_sources(folder):
    """Return a copy of what a wheel is made from, so that building leaves nothing in the checkout."""
    import shutil

    target = folder / "sources"
    target.mkdir()
    for name in ("qovr_core", "qovr_app", "resources"):
        shutil.copytree(ROOT / name, target / name, ignore=shutil.ignore_patterns("__pycache__"))
    for name in ("pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, target)
    return target
