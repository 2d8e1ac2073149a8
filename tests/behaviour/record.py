"""Records everything that can be observed of the program, and compares two recordings.

    python record.py record FOLDER [--program ROOT] [--only actions,views,...] [--like NAME]
    python record.py compare OLD NEW

It reaches the program by its promised names alone - the command line, ``create_window``, object names,
``window.view`` - and otherwise asks Qt, so that it runs unchanged on every state of the program. ROOT is the repository
whose program is meant, whatever else is installed in the interpreter that runs this; without it, the one in which this
file stands.

Texts and digests are recorded as JSON, what is seen as PNG. What legitimately changes from one run to the next is held
still (the clock of matplotlib, its random names, the caret, folders) or left out (dates, identifiers, version numbers).
"""

from __future__ import annotations

import argparse
import difflib
import fcntl
import functools
import hashlib
import json
import math
import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
import tomllib
import zipfile
from collections import Counter, defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from concurrent.futures import ThreadPoolExecutor
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from importlib import metadata
from pathlib import Path
from typing import Any, TypeVar

import numpy as np
from PIL import Image
from PySide6.QtCore import QEvent, QObject, QPoint, QSettings, Qt, QTimer, qInstallMessageHandler
from PySide6.QtGui import QAccessible, QAction, QCursor, QGuiApplication, QImage, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import (
    QAbstractButton,
    QAbstractItemView,
    QAbstractSlider,
    QAbstractSpinBox,
    QApplication,
    QComboBox,
    QDialog,
    QFileDialog,
    QLabel,
    QLineEdit,
    QMainWindow,
    QMenu,
    QMessageBox,
    QPlainTextEdit,
    QProgressBar,
    QSplitter,
    QTabBar,
    QTableWidget,
    QTextEdit,
    QToolBar,
    QToolButton,
    QTreeWidget,
    QWidget,
)

Facts = dict[str, Any]
"""What is known of something, ready for JSON; what is empty is left out."""

_T = TypeVar("_T", bound=QObject)

_WORKERS = 2
_COMMAND_SECONDS = 300
_WINDOW_SECONDS = 1500
_SCREEN = "2600x1600x24"
_OUTSIDE = QPoint(2590, 1590)
"""Where the mouse is out of every window's way."""

_REST_MILLISECONDS = 200
"""Longer than the view takes from its last change to its finer grid."""

_SCREENSHOT_SIZE = "1280x720"
_FIRST_SIZE = (1440, 900)

# ---------------------------------------------------------------------------------------------------------------------
# The program, and where it runs


@dataclass(frozen=True)
class Bench:
    """Where one recording is made.

    Parameters
    ----------
    work : an empty folder, the same in every recording
    out : where the recording goes
    like : only what has this in its name is recorded
    """

    work: Path
    out: Path
    like: str = ""

    @property
    def packages(self) -> Path:
        """The folder from which the program is imported."""
        return self.work / "packages"

    def takes(self, name: str) -> bool:
        """Return whether something of this name is to be recorded."""
        return self.like in name


@contextmanager
def workplace() -> Iterator[Path]:
    """Yield an empty folder that has the same path in every recording: messages and pictures show paths."""
    folder = Path(tempfile.gettempdir()) / "qovr-recording"
    with folder.with_suffix(".lock").open("w") as lock:
        try:
            fcntl.flock(lock, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say("waiting for another recording to end")
            fcntl.flock(lock, fcntl.LOCK_EX)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir()
        try:
            yield folder
        finally:
            shutil.rmtree(folder, ignore_errors=True)


def link_packages(program: Path, bench: Bench) -> None:
    """Make the program of a repository the one that is imported, under the names its project file gives."""
    file = program / "pyproject.toml"
    if not file.is_file():
        raise SystemExit(f"{program} holds no program; expected --program with the folder of a pyproject.toml")
    project = tomllib.loads(file.read_text(encoding="utf-8"))
    bench.packages.mkdir()
    for name, folder in project["tool"]["setuptools"]["package-dir"].items():
        (bench.packages / name).symlink_to((program / folder).resolve())


_NOT_INHERITED = ("QT", "QOVR", "XDG_", "PYTHON", "MPL", "LC_", "DBUS_", "DISPLAY", "WAYLAND_")


def environment(bench: Bench, **changes: str) -> dict[str, str]:
    """Return an environment that is the same everywhere, with a home of its own."""
    home = bench.work / "home"
    home.mkdir(exist_ok=True)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(_NOT_INHERITED)}
    fixed = {
        "PYTHONPATH": str(bench.packages),
        "PYTHONHASHSEED": "0",
        "HOME": str(home),
        "XDG_CONFIG_HOME": str(home / "config"),
        "XDG_DATA_HOME": str(home / "data"),
        "MPLCONFIGDIR": str(_matplotlib_settings(bench)),
        "SOURCE_DATE_EPOCH": "1700000000",
        "OPENBLAS_NUM_THREADS": "1",
        "LIBGL_ALWAYS_SOFTWARE": "1",
        "TZ": "UTC",
        "LANG": "C.UTF-8",
        "COLUMNS": "100",
        "NO_COLOR": "1",
    }
    return {**kept, **fixed, **changes}


def _matplotlib_settings(bench: Bench) -> Path:
    """Return a folder of settings with which SVG files do not get random names."""
    folder = bench.work / "matplotlib"
    if not folder.exists():
        folder.mkdir()
        (folder / "matplotlibrc").write_text("svg.hashsalt: qovr\n", encoding="utf-8")
    return folder


_LAUNCH = "import sys; sys.argv[0] = 'qovr'; from qovr_app.main import main; main()"


def run_program(bench: Bench, arguments: Iterable[str], folder: Path, **changes: str) -> Facts:
    """Run the command ``qovr`` and return its exit code and what it prints."""
    command = [sys.executable, "-P", "-c", _LAUNCH, *arguments]
    try:
        done = subprocess.run(
            command,
            cwd=folder,
            env=environment(bench, **changes),
            stdin=subprocess.DEVNULL,
            capture_output=True,
            text=True,
            errors="backslashreplace",
            timeout=_COMMAND_SECONDS,
            check=False,
        )
    except subprocess.TimeoutExpired:
        return {"code": "it did not end in time"}
    lines = {"stdout": done.stdout, "stderr": done.stderr}
    return {"code": done.returncode} | {name: _plain(text, bench).splitlines() for name, text in lines.items() if text}


def _plain(text: str, bench: Bench) -> str:
    """Return a text without what differs from place to place, or from version to version."""
    return _unversioned(text).replace(str(bench.work), "WORK")


@contextmanager
def virtual_screen() -> Iterator[dict[str, str]]:
    """Yield the environment variable that names a new screen of fixed size."""
    read, write = os.pipe()
    command = [
        "Xvfb",
        "-displayfd",
        str(write),
        "-screen",
        "0",
        _SCREEN,
        "-dpi",
        "96",
        "-nolisten",
        "tcp",
        "-terminate",
    ]
    server = subprocess.Popen(command, pass_fds=(write,), stderr=subprocess.DEVNULL)
    os.close(write)
    try:
        with os.fdopen(read) as answer:
            number = answer.readline().strip()
        if not number:
            raise SystemExit("Xvfb did not start")
        yield {"DISPLAY": f":{number}"}
    finally:
        server.terminate()
        server.wait()


def save_json(path: Path, content: object) -> None:
    """Write facts so that people can read them."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(json.dumps(content, indent=1, sort_keys=True, ensure_ascii=False) + "\n", encoding="utf-8")


def say(text: str) -> None:
    """Print a line at once."""
    sys.stdout.write(f"{text}\n")
    sys.stdout.flush()


# ---------------------------------------------------------------------------------------------------------------------
# Files as digests, without what legitimately changes

_VERSION = re.compile(rb"(QOVR Studio )\d[\w.+-]*\w")
_TIMES = (
    re.compile(rb"\d{4}-\d\d-\d\d[T ]\d\d:\d\d:\d\d(\.\d+)?(Z|[+-]\d\d:?\d\d)?"),
    re.compile(rb"(?<=15H)\d{8}\.\d{6}"),
    re.compile(rb"D:\d{14}([+-]\d\d'\d\d'|Z)?"),
)
_IDENTIFIERS = (
    re.compile(rb"[0-9a-f]{8}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{4}-[0-9a-f]{12}", re.IGNORECASE),
    re.compile(rb"(?<=/ID \[).*?(?=\])", re.DOTALL),
)


def _without_version(content: bytes) -> bytes:
    return _VERSION.sub(rb"\1VERSION", content)


def _unversioned(text: str) -> str:
    return _without_version(text.encode()).decode()


def _normalised(content: bytes) -> bytes:
    content = _without_version(content)
    for pattern in _TIMES:
        content = pattern.sub(b"TIME", content)
    for pattern in _IDENTIFIERS:
        content = pattern.sub(b"ID", content)
    return content


def _sha(content: bytes) -> str:
    return hashlib.sha256(content).hexdigest()


def _array_digest(array: np.ndarray) -> str:
    """Return an array's kind, shape and digest; a text as itself."""
    if array.dtype.kind in "US":
        return _unversioned("|".join(map(str, array.ravel())))
    return f"{array.dtype} {array.shape} {_sha(np.ascontiguousarray(array).tobytes())}"


def _npz(path: Path) -> Facts:
    with np.load(path) as arrays:
        return {name: _array_digest(arrays[name]) for name in arrays.files}


def _mat(path: Path) -> Facts:
    from scipy.io import loadmat, whosmat

    arrays = loadmat(path)
    facts: Facts = {name: _array_digest(np.asarray(arrays[name])) for name, _, _ in whosmat(path)}
    return facts | {"order": [name for name, _, _ in whosmat(path)], "after the head": _sha(path.read_bytes()[128:])}


def _archive(path: Path) -> Facts:
    with zipfile.ZipFile(path) as archive:
        return {name: _sha(_normalised(archive.read(name))) for name in archive.namelist()}


def _iges(path: Path) -> str:
    """Return a digest in which the global section is one line, as a time may lie across two."""
    lines = path.read_text(encoding="ascii").splitlines()
    is_global = [line[72:73] == "G" for line in lines]
    joined = "".join(line[:72] for line, is_one in zip(lines, is_global, strict=True) if is_one)
    rest = "\n".join(line for line, is_one in zip(lines, is_global, strict=True) if not is_one)
    return _sha(_normalised(f"{joined}\n{rest}".encode()))


def _rhino(path: Path) -> Facts:
    """Return what a Rhino model holds; its file has random identifiers and checksums over them."""
    import rhino3dm

    model = rhino3dm.File3dm.Read(str(path))
    objects = {}
    for entry in model.Objects:
        geometry = entry.Geometry.Encode()["data"]
        strings = [list(map(_unversioned, pair)) for pair in entry.Attributes.GetUserStrings()]
        objects[entry.Attributes.Name] = [entry.Attributes.LayerIndex, strings, _sha(geometry.encode())]
    return {
        "units": str(model.Settings.ModelUnitSystem),
        "tolerance": model.Settings.ModelAbsoluteTolerance,
        "program": _unversioned(model.ApplicationName),
        "layers": [[layer.Name, list(layer.Color)] for layer in model.Layers],
        "objects": objects,
        "strings": [list(map(_unversioned, model.Strings[k])) for k in range(len(model.Strings))],
    }


_READERS: dict[str, Callable[[Path], Any]] = {
    ".npz": _npz,
    ".mat": _mat,
    ".xlsx": _archive,
    ".iges": _iges,
    ".3dm": _rhino,
}


def digest(path: Path) -> Any:
    """Return what a file holds in short, so that equal digests mean files nobody can tell apart."""
    try:
        reader = _READERS.get(path.suffix.lower())
        return reader(path) if reader else _sha(_normalised(path.read_bytes()))
    except Exception as error:  # a damaged file is a finding like any other
        return f"cannot be read: {type(error).__name__}: {error}"


def digests(folder: Path) -> Facts:
    """Return the digests of all files below a folder but for those that it was given."""
    files = (path for path in sorted(folder.rglob("*")) if path.is_file() and path.relative_to(folder).parts[0] != "in")
    return {str(path.relative_to(folder)): digest(path) for path in files}


# ---------------------------------------------------------------------------------------------------------------------
# The command line

_FORMULATIONS = ("published", "double-sum", "interpolating")
_OF_BOTH_LAYERS = ("xlsx", "csv", "npz", "mat", "qovr")
_CAD = ("step", "iges", "3dm")
_MESHES = ("obj", "stl", "ply", "glb")
_FORMATS = (*_OF_BOTH_LAYERS, *_CAD, *_MESHES)
_DIFFERENT = ("fig5", "fig6b", "fig6c", "fig6d", "fig8")
"""Presets of which no two are the same document."""


def preset_names(bench: Bench) -> list[str]:
    """Return the names of the presets, as the program lists them."""
    lines = run_program(bench, ["presets"], bench.work).get("stdout", [])
    return [line.split()[0].removeprefix("paper:") for line in lines if line.startswith("paper:")]


def make_inputs(bench: Bench) -> None:
    """Make the files that the commands read, once for all parts: documents good and bad, and exports of some."""
    folder = bench.work / "in"
    folder.mkdir()
    documents = {"odd": _odd_document(), "flat": _flat_document(), "point": _point_document()}
    for name in _DIFFERENT:
        run_program(bench, ["export", f"paper:{name}", f"{name}.qovr"], folder)
        documents[name] = json.loads((folder / f"{name}.qovr").read_text(encoding="utf-8"))
    for name, document in documents.items():
        for formulation in _FORMULATIONS:
            save_json(folder / f"{name}-{formulation}.qovr", {**document, "formulation": formulation})
    for name, text in _bad_documents(documents["fig5"]).items():
        (folder / name).write_text(text, encoding="utf-8")
    for source in ("odd-published", "odd-double-sum", "odd-interpolating", "fig6d-published"):
        outs = [f"{source}.{suffix}" for suffix in ("xlsx", "npz", "mat", "3dm")]
        run_program(bench, ["export", f"{source}.qovr", *outs, "--samples", "13x9"], folder)
    _falsify(folder / "odd-published.xlsx", folder / "false.xlsx")


def _document(point: Callable[[int, int], list[float]], knot: Callable[[int, int, int], float]) -> Facts:
    """Return a document from functions of the place."""
    return {
        "format": "qovr-document",
        "version": 1,
        "formulation": "published",
        "samples": [17, 12],
        "control_points": [[point(i, j) for j in range(5)] for i in range(5)],
        "row_knots": [{name: knot(0, k, n) for n, name in enumerate("rsut")} for k in range(5)],
        "column_knots": [{name: knot(1, k, n) for n, name in enumerate("rsvt")} for k in range(5)],
    }


def _odd_document() -> Facts:
    """Return a document without any symmetry, each of whose knots is another number."""

    def point(i: int, j: int) -> list[float]:
        x, y = j + 0.23 * math.sin(3 * i + j), i + 0.21 * math.cos(2 * j - i)
        return [round(x, 3), round(y, 3), round(0.6 * math.sin(1.3 * i) * math.cos(0.9 * j) + 0.07 * (i * j % 3), 3)]

    return _document(point, lambda side, k, n: round(0.3 + 0.37 * math.sin(5 * side + 3 * k + 7 * n) ** 2, 3))


def _flat_document() -> Facts:
    return _document(lambda i, j: [float(j), float(i), 1.0], lambda *_place: 0.5)


def _point_document() -> Facts:
    return _document(lambda _i, _j: [1.0, 2.0, 3.0], lambda *_place: 0.5)


def _bad_documents(good: Facts) -> dict[str, str]:
    """Return files that are no documents, each wrong in one way."""

    def changed(**entries: object) -> str:
        return json.dumps({**good, **entries})

    knots, net = good["row_knots"], good["control_points"]
    return {
        "empty.qovr": "",
        "list.qovr": "[]",
        "torn.qovr": json.dumps(good)[:200],
        "format.qovr": changed(format="something"),
        "newer.qovr": changed(version=99),
        "version.qovr": changed(version="one"),
        "key.qovr": changed(colour="red"),
        "formulation.qovr": changed(formulation="best"),
        "knot.qovr": changed(row_knots=[{**knots[0], "s": 1.0}, *knots[1:]]),
        "knot-text.qovr": changed(row_knots=[{**knots[0], "s": "half"}, *knots[1:]]),
        "knot-name.qovr": changed(row_knots=[{**knots[0], "v": 0.5}, *knots[1:]]),
        "few-knots.qovr": changed(row_knots=knots[1:]),
        "rows.qovr": changed(control_points=net[1:]),
        "place.qovr": changed(control_points=[*net[:3], [*net[3][:1], [1, 2, None], *net[3][2:]], net[4]]),
        "infinite.qovr": changed(control_points=[*net[:4], [[1e400, 0, 0], *net[4][1:]]]),
        "huge.qovr": changed(control_points=[*net[:4], [[1e13, 0, 0], *net[4][1:]]]),
        "samples.qovr": changed(samples=[1, 5]),
        "many-samples.qovr": changed(samples=[5, 5000]),
        "no-samples.qovr": json.dumps({key: value for key, value in good.items() if key != "samples"}),
        "text.xlsx": "no workbook",
        "text.npz": "no arrays",
        "text.mat": "no arrays",
        "text.3dm": "no model",
    }


def _falsify(source: Path, target: Path) -> None:
    """Write a workbook again with other numbers in its last row, which no formulation meets."""
    import openpyxl

    book = openpyxl.load_workbook(source)
    sheet = book.worksheets[0]
    for cell in sheet[sheet.max_row]:
        if isinstance(cell.value, float):
            cell.value += 0.25
    book.save(target)


def run_commands(bench: Bench, part: str, calls: Sequence[Sequence[str]], **changes: str) -> None:
    """Record what calls of the command do: exit code, what they print, what they write."""
    wanted = [call for call in calls if bench.takes(" ".join(call))]

    def run(number: int) -> Facts:
        folder = bench.work / part / str(number)
        folder.mkdir(parents=True)
        (folder / "in").symlink_to(bench.work / "in")
        facts = run_program(bench, wanted[number], folder, **changes)
        for picture in folder.rglob("*.png"):
            target = bench.out / part / picture.relative_to(folder)
            target.parent.mkdir(parents=True, exist_ok=True)
            picture.rename(target)
        if files := digests(folder):
            facts["files"] = files
        shutil.rmtree(folder)
        return facts

    with ThreadPoolExecutor(_WORKERS) as pool:
        found = list(pool.map(run, range(len(wanted))))
    names = [" ".join(["qovr", *call]) for call in wanted]
    save_json(bench.out / f"{part}.json", dict(zip(names, found, strict=True)))


def record_cli(bench: Bench) -> None:
    """Record all commands that print, and the refusals."""
    run_commands(bench, "cli", [*_helps(), *_answers(preset_names(bench)), *_refusals()])


def _helps() -> list[list[str]]:
    commands = ("export", "figures", "reproduce", "verify", "compare", "presets", "info", "screenshot", "edit")
    return [["--help"], ["--version"], *([command, "--help"] for command in commands)]


def _answers(presets: list[str]) -> list[list[str]]:
    papers = [f"paper:{name}" for name in presets]
    others = [f"in/{name}-{form}.qovr" for name in (*_DIFFERENT, "odd", "flat") for form in _FORMULATIONS]
    again = [f"in/odd-interpolating.{suffix}" for suffix in ("xlsx", "npz", "mat", "3dm")]
    books = [f"in/odd-{form}.xlsx" for form in _FORMULATIONS]
    calls = [["presets"]]
    calls += [["info", source, *form] for source in (*papers, *others, *again) for form in ((), ("--json",))]
    calls += [["verify", source, "--json"] for source in (*papers, "in/odd-published.qovr")]
    calls += [["verify", source, *form] for source in ("paper:fig5", "paper:fig8") for form in ((), ("--markdown",))]
    calls += [["verify", "in/odd-published.qovr", "--counterexamples", "found"]]
    calls += [["compare", source] for source in papers]
    calls += [["compare", f"in/{name}-{form}.qovr", "--json"] for name in ("fig6d", "odd") for form in _FORMULATIONS]
    calls += [["compare", "paper:fig8", "--point", "1,3", "--weight", "25", *form] for form in ((), ("--json",))]
    calls += [["reproduce", book, *form] for book in (*books, "in/false.xlsx") for form in ((), ("--json",))]
    return [*calls, ["reproduce", *books], ["reproduce", *books, "in/false.xlsx", "--json"]]


def _refusals() -> list[list[str]]:
    """Return calls that are wrong, and calls that need the display that there is not."""
    sources = [*_bad_documents(_flat_document()), "missing.qovr", "", "in/fig5.qovr/x.qovr"]
    lines = """
        exprot paper:fig5 a.csv|info|info paper:fig9|info paper:|info in|info missing.txt|info paper:fig5 --jsn|info a b
        export|export paper:fig5|export paper:fig5 a.bmp|export paper:fig5 a|export paper:fig5 no/such/a.csv
        export paper:fig9 a.csv|export paper:fig5 a.csv b.bmp|export paper:fig5 a.csv --samples 1
        export paper:fig5 a.csv --samples 5000|export paper:fig5 a.csv --samples axb
        export paper:fig5 a.csv --samples 5x|export paper:fig5 a.csv --formulation best
        export paper:fig5 a.csv --form published|export paper:fig5 a.step --layer both
        export paper:fig5 a.obj --tolerance 0|export paper:fig5 a.obj --tolerance x
        export paper:fig5 a.csv --tolerance 0.1|export paper:fig5 a.xlsx --samples 2000|export paper:fig5 in
        export in/point-published.qovr a.step|export in/point-published.qovr a.iges|export in/point-published.qovr a.3dm
        export in/point-published.qovr a.obj a.stl|export in/flat-published.qovr a.obj a.step a.csv
        figures|figures out --only fig9|figures out --formats bmp|figures out --dpi 5|figures in/fig5.qovr
        verify|verify paper:fig5 --json --markdown|verify paper:fig5 --counterexamples in/fig5.qovr
        compare paper:fig5 --point 9,9|compare paper:fig5 --point 2|compare paper:fig5 --weight 0
        compare paper:fig5 --weight x|compare in/point-published.qovr|verify in/point-published.qovr
        info in/point-published.qovr|reproduce|reproduce in/fig5.qovr|reproduce missing.xlsx|reproduce in/text.xlsx
        screenshot|screenshot a.jpg|screenshot a.png --size 10|screenshot a.png --scale 9|screenshot a.png --theme blue
        screenshot a.png --camera left|screenshot a.png|edit a b|-x|paper:fig5|missing.qovr|presets more
    """
    calls = [call.split() for line in lines.strip().splitlines() for call in line.split("|")]
    return [*calls, [], *(["info", source if "/" in source or not source else f"in/{source}"] for source in sources)]


def record_exports(bench: Bench) -> None:
    """Record every format of every preset, and all options."""
    calls = [["export", f"paper:{name}", *_outs(_FORMATS)] for name in preset_names(bench)]
    for name in ("fig5", "fig6d"):
        for formulation in _FORMULATIONS:
            call = ["export", f"paper:{name}", "--formulation", formulation]
            calls.append([*call, *_outs(_FORMATS)])
            calls += [[*call, *_outs((*_CAD, *_MESHES)), "--layer", layer] for layer in ("raw", "transformed")]
    for formulation in _FORMULATIONS:
        call = ["export", f"in/odd-{formulation}.qovr"]
        calls += [[*call, *_outs(_FORMATS)], [*call, *_outs(_FORMATS), "--samples", "21x13"]]
        calls += [[*call, *_outs(_MESHES), "--tolerance", distance] for distance in ("0.1", "0.001")]
    calls.append(["export", "paper:fig6c", *_outs(_FORMATS), "--samples", "21x13"])
    calls.append(["export", "paper:fig6c", *_outs(_MESHES), "--tolerance", "0.0005", "--layer", "raw"])
    calls += [["export", f"in/odd-double-sum.{suffix}", "a.qovr", "a.csv"] for suffix in ("xlsx", "npz", "mat", "3dm")]
    run_commands(bench, "exports", calls)


def _outs(suffixes: Iterable[str]) -> list[str]:
    return [f"a.{suffix}" for suffix in suffixes]


def record_figures(bench: Bench) -> None:
    """Record the paper's figures: the pictures whole, of SVG and PDF the digests."""
    calls = [["figures", "all", "--formats", "png", "--dpi", "60"]]
    calls += [["figures", "lines", "--formats", "svg,pdf", "--only", f"fig{k}"] for k in (6, 7, 8, 5, 2, 1)]
    calls.append(["figures", "one", "--only", "fig6b,fig1a", "--only", "fig8b", "--formats", "png", "--dpi", "30"])
    run_commands(bench, "figures", calls)


def record_screenshots(bench: Bench) -> None:
    """Record the window as the command pictures it: all presets, light and dark, and every option."""
    size = ["--size", _SCREENSHOT_SIZE]
    calls: dict[str, tuple[list[str], dict[str, str]]] = {}
    for name in preset_names(bench):
        for theme in ("light", "dark"):
            calls[f"{name}-{theme}"] = [f"paper:{name}", *size, "--theme", theme], {}
    calls["default"] = [], {}
    calls["top"] = ["paper:fig8", *size, "--camera", "top"], {}
    calls["scale-2"] = ["paper:fig6c", *size, "--scale", "2"], {}
    calls["large"] = ["paper:fig6c", "--size", "1920x1200", "--theme", "dark"], {}
    for formulation in _FORMULATIONS:
        calls[f"odd-{formulation}"] = [f"in/odd-{formulation}.qovr", *size], {}
    calls["flat"] = ["in/flat-published.qovr", *size], {}
    for theme in ("light", "dark"):
        calls[f"painter-{theme}"] = ["paper:fig8", *size, "--theme", theme], {"QOVR_NO_OPENGL": "1"}
    for name, size_text in (("small", "400x300"), ("absurd", "9000x9000")):
        calls[name] = ["paper:fig5", "--size", size_text], {}
    calls["no-preset"] = ["paper:fig9"], {}
    wanted = {name: call for name, call in calls.items() if bench.takes(name)}
    folder = bench.work / "screenshots"
    folder.mkdir()
    (folder / "in").symlink_to(bench.work / "in")

    def run(name: str) -> Facts:
        arguments, changes = wanted[name]
        with virtual_screen() as screen:
            return run_program(bench, ["screenshot", f"{name}.png", *arguments], folder, **screen, **changes)

    with ThreadPoolExecutor(_WORKERS) as pool:
        found = dict(zip(wanted, pool.map(run, wanted), strict=True))
    for picture in folder.glob("*.png"):
        target = bench.out / "screenshots" / picture.name
        target.parent.mkdir(exist_ok=True)
        shutil.move(picture, target)
    save_json(bench.out / "screenshots.json", found)


# ---------------------------------------------------------------------------------------------------------------------
# What Qt knows of a window


def _filled(**facts: object) -> Facts:
    """Return the facts that say something; where a thing is as usual it says nothing."""
    return {name: fact for name, fact in facts.items() if fact not in ("", None, False, [], {}, ())}


def _kind(thing: QObject) -> str:
    """Return the nearest class of Qt itself: what the program calls its own is its own affair."""
    return next(kind.__name__ for kind in type(thing).__mro__ if kind.__module__.startswith("PySide6"))


def _own_name(thing: QObject) -> str:
    """Return the name the program gave; Qt names parts of its widgets, too."""
    return "" if thing.objectName().startswith("qt_") else thing.objectName()


def _geometry(widget: QWidget) -> str:
    at = widget.mapTo(widget.window(), QPoint(0, 0))
    return f"{at.x()} {at.y()} {widget.width()} {widget.height()}"


def action_facts(action: QAction) -> Facts:
    """Return everything a user can see or hear of an action, and what it does not do now."""
    group = action.actionGroup()
    return _filled(
        text=action.text(),
        icon_text=action.iconText(),
        shortcuts=[sequence.toString() for sequence in action.shortcuts()],
        shortcut_context=action.shortcutContext().name,
        tool_tip=action.toolTip(),
        status_tip=action.statusTip(),
        whats_this=action.whatsThis(),
        checkable=action.isCheckable(),
        checked=action.isChecked(),
        disabled=not action.isEnabled(),
        hidden=not action.isVisible(),
        role=action.menuRole().name,
        excludes=[] if group is None else [other.objectName() for other in group.actions()],
    )


def menu_facts(actions: Iterable[QAction]) -> list[Any]:
    """Return a menu's entries from top to bottom; separators that collapse are none."""
    entries: list[Any] = []
    for action in actions:
        if action.isSeparator():
            if entries and entries[-1] != "----":
                entries.append("----")
        elif action.menu() is not None:
            menu = action.menu()
            title = f"{menu.title()} ({menu.objectName()}){'' if action.isEnabled() else ' disabled'}"
            entries.append({title: menu_facts(menu.actions())})
        else:
            text = f"{action.text()}{'' if action.isEnabled() else ' (disabled)'}"
            entries.append(action.objectName() or text or "a widget")
    return entries[:-1] if entries and entries[-1] == "----" else entries


def bar_facts(bar: QToolBar) -> Facts:
    """Return what stands in a tool bar."""
    buttons = [button for button in bar.findChildren(QToolButton) if button.menu() is not None and button.text()]
    return _filled(
        title=bar.windowTitle(),
        entries=menu_facts(bar.actions()),
        menus={button.text(): menu_facts(button.menu().actions()) for button in buttons},
    )


def _text_of(widget: QWidget) -> str:
    """Return what a widget says, where it says one thing."""
    if isinstance(widget, QLineEdit | QAbstractButton | QLabel | QAbstractSpinBox):
        return widget.text()
    if isinstance(widget, QTextEdit | QPlainTextEdit):
        return widget.toPlainText()
    return widget.currentText() if isinstance(widget, QComboBox) else ""


def _line_content(line: QLineEdit) -> Facts:
    return _filled(selected=line.selectedText(), placeholder=line.placeholderText(), fixed=line.isReadOnly())


def _button_content(button: QAbstractButton) -> Facts:
    shortcut = button.shortcut().toString()
    return _filled(checkable=button.isCheckable(), checked=button.isChecked(), shortcut=shortcut)


def _list_content(box: QComboBox) -> Facts:
    tips = [box.itemData(k, Qt.ItemDataRole.ToolTipRole) or "" for k in range(box.count())]
    return {"items": [f"{box.itemText(k)}: {tip}" for k, tip in enumerate(tips)]}


def _range_content(widget: QAbstractSlider | QProgressBar) -> Facts:
    return {"value": widget.value(), "least": widget.minimum(), "most": widget.maximum()}


def _tabs_content(bar: QTabBar) -> Facts:
    return {
        "tabs": [f"{bar.tabText(k)}: {bar.tabToolTip(k)}" for k in range(bar.count())],
        "current": bar.currentIndex(),
    }


def _splitter_content(splitter: QSplitter) -> Facts:
    return {"sizes": splitter.sizes()} if splitter.isVisible() else {}


_CELL_ROLES = {
    "text": Qt.ItemDataRole.DisplayRole,
    "tip": Qt.ItemDataRole.ToolTipRole,
    "spoken": Qt.ItemDataRole.AccessibleTextRole,
    "described": Qt.ItemDataRole.AccessibleDescriptionRole,
}


def _table_content(view: QAbstractItemView) -> Facts:
    """Return what all cells of a table say, and its heads."""
    model = view.model()
    if model is None:
        return {}
    rows, columns = model.rowCount(), model.columnCount()
    sides = {"rows": (rows, Qt.Orientation.Vertical), "columns": (columns, Qt.Orientation.Horizontal)}
    heads = {side: [str(model.headerData(k, line)) for k in range(count)] for side, (count, line) in sides.items()}
    cells = {}
    for name, role in _CELL_ROLES.items():
        lines = [[str(model.index(r, c).data(role) or "") for c in range(columns)] for r in range(rows)]
        cells[name] = [" | ".join(line) for line in lines] if any(any(line) for line in lines) else []
    return _filled(heads=heads, current=[view.currentIndex().row(), view.currentIndex().column()], **cells)


_CONTENTS: dict[type[QWidget], Callable[[Any], Facts]] = {
    QLineEdit: _line_content,
    QAbstractButton: _button_content,
    QComboBox: _list_content,
    QAbstractSlider: _range_content,
    QProgressBar: _range_content,
    QTabBar: _tabs_content,
    QSplitter: _splitter_content,
    QAbstractItemView: _table_content,
}
"""What widgets hold besides a text, by their kind."""


def _content(widget: QWidget) -> Facts:
    return next((content(widget) for kind, content in _CONTENTS.items() if isinstance(widget, kind)), {})


def _accessible(widget: QWidget) -> Facts:
    """Return what is spoken of a widget."""
    found = QAccessible.queryAccessibleInterface(widget)
    if found is None:
        return {}
    kinds = {"spoken": "Name", "spoken_description": "Description", "spoken_value": "Value"}
    texts = {name: found.text(getattr(QAccessible.Text, kind)) for name, kind in kinds.items()}
    return _filled(role=found.role().name, **texts)


def widget_facts(widget: QWidget) -> Facts:
    """Return what a user sees, hears and can do with a widget."""
    facts = _filled(
        kind=_kind(widget),
        text=_text_of(widget),
        tool_tip=widget.toolTip(),
        status_tip=widget.statusTip(),
        accessible_name=widget.accessibleName(),
        accessible_description=widget.accessibleDescription(),
        hidden=not widget.isVisible(),
        disabled=not widget.isEnabled(),
        geometry=_geometry(widget) if widget.isVisible() else "",
        takes_focus=widget.focusPolicy().name,
    )
    return facts | _content(widget) | _accessible(widget)


def _place(widget: QWidget) -> str:
    """Return the name of a widget, or where it stands if it has none."""
    if _own_name(widget):
        return widget.objectName()
    parent = widget.parentWidget()
    while parent is not None and not _own_name(parent):
        parent = parent.parentWidget()
    inside = parent.objectName() if parent is not None else "the screen"
    return f"{_kind(widget)} '{_text_of(widget)}' in {inside}"


def _unnamed(widgets: Iterable[QWidget]) -> dict[str, list[str]]:
    """Return the visible widgets without a name that say something, by where they stand, from top to bottom."""
    found: dict[str, list[tuple[int, int, str]]] = defaultdict(list)
    for widget in widgets:
        texts = [_text_of(widget), widget.accessibleName(), widget.toolTip()]
        if not widget.isVisible() or not any(texts):
            continue
        at = widget.mapTo(widget.window(), QPoint(0, 0))
        state = "" if widget.isEnabled() else " disabled"
        line = f"{_place(widget)}, spoken '{texts[1]}', tip '{texts[2]}', at {_geometry(widget)}{state}"
        found[_place(widget).rpartition(" in ")[2]].append((at.y(), at.x(), line))
    return {place: [line for _, _, line in sorted(lines)] for place, lines in found.items()}


def _tab_order(window: QWidget) -> list[str]:
    """Return where the keyboard goes with Tab."""
    order, widget = [], window.nextInFocusChain()
    while widget is not None and widget is not window:
        takes_tab = bool(widget.focusPolicy() & Qt.FocusPolicy.TabFocus)
        if takes_tab and widget.isVisible() and widget.isEnabled() and widget.window() is window:
            order.append(_place(widget))
        widget = widget.nextInFocusChain()
    return order


def window_facts(window: QWidget) -> Facts:
    """Return everything that Qt knows of a window or dialog and what is in it."""
    inside = [widget for widget in window.findChildren(QWidget) if widget.window() is window]
    named = [widget for widget in inside if _own_name(widget)]
    count = Counter(widget.objectName() for widget in named)
    focus = window.focusWidget()
    least = window.minimumSizeHint()
    return _filled(
        name=window.objectName(),
        title=window.windowTitle(),
        changed=window.isWindowModified(),
        size=[window.width(), window.height()],
        least_size=[least.width(), least.height()],
        modality=window.windowModality().name,
        takes_drops=window.acceptDrops(),
        focus="" if focus is None else _place(focus),
        widgets={widget.objectName(): widget_facts(widget) for widget in named},
        names_given_twice=sorted(name for name, times in count.items() if times > 1),
        unnamed=_unnamed(widget for widget in inside if not _own_name(widget)),
        tab_order=_tab_order(window),
    )


def main_window_facts(window: QMainWindow) -> Facts:
    """Return everything that Qt knows of the main window and its open dialogs."""
    actions = [action for action in window.findChildren(QAction) if action.objectName()]
    viewports = window.view.viewports
    return window_facts(window) | _filled(
        actions={action.objectName(): action_facts(action) for action in actions},
        menus=menu_facts(window.menuBar().actions()),
        bars={bar.objectName(): bar_facts(bar) for bar in window.findChildren(QToolBar)},
        status=window.statusBar().currentMessage(),
        viewports=[widget_facts(viewport) for viewport in viewports],
        cursors=[viewport.cursor().shape().name for viewport in viewports],
        dialogs={dialog.windowTitle(): window_facts(dialog) for dialog in open_dialogs(window)},
    )


def open_dialogs(window: QMainWindow) -> list[QDialog]:
    """Return the dialogs that are seen, by their titles."""
    return sorted((box for box in window.findChildren(QDialog) if box.isVisible()), key=QDialog.windowTitle)


# ---------------------------------------------------------------------------------------------------------------------
# The window as a user meets it


class Answers:
    """Stands in for the user where the system asks: which file, and what to do with unsaved changes."""

    def __init__(self) -> None:
        self.files: list[str] = []
        self.button = QMessageBox.StandardButton.Discard
        self.asked: list[str] = []
        for name in ("getOpenFileName", "getSaveFileName"):
            setattr(QFileDialog, name, staticmethod(functools.partial(self._give_file, name)))
        QMessageBox.question = staticmethod(self._answer)

    def _give_file(self, kind: str, _parent: QWidget, *question: object) -> tuple[str, str]:
        self.asked.append(" | ".join(map(str, (kind, *question))))
        return (self.files.pop(0) if self.files else ""), ""

    def _answer(self, _parent: QWidget, *question: object) -> QMessageBox.StandardButton:
        self.asked.append(" | ".join(map(str, ("question", *question))))
        return self.button


def _helpers_sleep() -> bool:
    """Return whether no process that the program has started is at work, or waits for its turn to be."""
    for entry in Path("/proc").glob("[0-9]*/stat"):
        with suppress(OSError):
            state, parent = entry.read_text(encoding="ascii", errors="replace").rpartition(")")[2].split()[:2]
            if int(parent) == os.getpid() and state in "RD":
                return False
    return True


def _spiral(radius: int, step: int) -> list[QPoint]:
    """Return the places of a square grid about the origin, from the middle outward."""
    line = range(-radius, radius + 1, step)
    return sorted((QPoint(x, y) for y in line for x in line), key=lambda at: max(abs(at.x()), abs(at.y())))


class _MouseWatcher(QObject):
    """Knows where a widget was last told that the mouse is: the screen tells it later than the mouse is moved."""

    def __init__(self, widget: QWidget) -> None:
        super().__init__()
        self.last: QPoint | None = None
        widget.installEventFilter(self)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QMouseEvent) and event.type() is QEvent.Type.MouseMove:
            self.last = event.position().toPoint()
        return False


class Editor:
    """A main window with settings of its own, driven by names and real events.

    Parameters
    ----------
    folder : empty; settings, recovery files and what is written go there
    given : files that can be opened
    """

    def __init__(self, folder: Path, given: Path, size: tuple[int, int], source: str | None) -> None:
        self.home, self.data = folder / "home", folder / "home" / "data"
        self.home.mkdir(parents=True)
        self.given = given
        self.answers = Answers()
        self.complaints: list[str] = []
        self.notes: Facts = {}
        self.pictures: dict[str, QImage] = {}
        self._held: QPoint | None = None
        self._listen()
        self._use_home()
        self.open_window(size, source)

    def _listen(self) -> None:
        sys.excepthook = lambda kind, error, _trace: self.complaints.append(f"{kind.__name__}: {error}")
        qInstallMessageHandler(lambda kind, _context, text: self.complaints.append(f"{kind.name}: {text}"))

    def _use_home(self) -> None:
        os.environ["HOME"], os.environ["XDG_DATA_HOME"] = str(self.home), str(self.data)
        os.environ["XDG_CONFIG_HOME"] = str(self.home / "config")
        for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
            QSettings.setPath(kind, QSettings.Scope.UserScope, str(self.home / "config"))
        os.chdir(self.home)
        QGuiApplication.clipboard().clear()

    def open_window(self, size: tuple[int, int] = _FIRST_SIZE, source: str | None = None) -> None:
        """Open a main window and give it the keyboard."""
        from qovr_app.main import create_window

        self.window: Any = create_window(source and source.replace("in/", f"{self.given}/"))
        QCursor.setPos(_OUTSIDE)
        self.window.move(0, 0)
        self.window.resize(*size)
        self.window.show()
        self.window.activateWindow()
        QTest.qWaitForWindowActive(self.window, 10_000)
        self.settle()
        self.window.view.image()  # the view would come by itself, yet nobody knows when
        self.rest()

    def close(self) -> None:
        """Close the window with all dialogs, and let it go."""
        if self._held:
            QTest.mouseRelease(self.viewport, Qt.MouseButton.LeftButton, pos=self._held)
        for dialog in open_dialogs(self.window):
            dialog.reject()
        self.window.close()
        self.window.deleteLater()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
        QApplication.processEvents()

    # Waiting

    def wait_until(self, happened: Callable[[], object], seconds: float = 90.0) -> None:
        """Let the event loop run until something is true."""
        end = time.monotonic() + seconds
        while not happened():
            if time.monotonic() > end:
                raise TimeoutError("it did not happen in time")
            QTest.qWait(5)

    def rest(self) -> QImage:
        """Wait until nothing is being worked on and the picture has not changed for a while; return it.

        The while is longer than the view takes from its last change to its finer grid.
        """
        last, was_idle = QImage(), False
        for _ in range(300):
            QTest.qWait(_REST_MILLISECONDS)
            picture, is_idle = self.window.grab().toImage(), _helpers_sleep()
            if picture == last and is_idle and was_idle:
                return picture
            last, was_idle = picture, is_idle
        raise TimeoutError("the window does not come to rest")

    # Finding and doing

    def find(self, name: str, kind: type[_T] = QWidget) -> _T:
        """Return the one thing of a name."""
        found = self.window.findChildren(kind, name)
        if len(found) != 1:
            raise LookupError(f"there are {len(found)} of {name}; expected one")
        return found[0]

    def trigger(self, *names: str) -> None:
        """Trigger actions, one after the other."""
        for name in names:
            self.find(name, QAction).trigger()
            self.settle()

    def settle(self) -> None:
        """Let what is due happen."""
        for _ in range(3):
            QApplication.processEvents()
        QApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)

    def focus(self, name: str) -> None:
        """Bring the keyboard to a widget."""
        self.find(name).setFocus()
        self.settle()

    def click(self, name: str) -> None:
        """Click a button."""
        QTest.mouseClick(self.find(name, QAbstractButton), Qt.MouseButton.LeftButton)
        self.settle()

    def type_into(self, name: str, text: str, end: Qt.Key | None = Qt.Key.Key_Tab) -> None:
        """Type over a field's text, and leave it unless told otherwise."""
        line = self.find(name, QLineEdit)
        line.setFocus()
        line.selectAll()
        QTest.keyClicks(line, text)
        if end is not None:
            QTest.keyClick(line, end)
        self.settle()

    def choose(self, name: str, text: str) -> None:
        """Choose an entry of a drop-down list."""
        self.find(name, QComboBox).setCurrentText(text)
        self.settle()

    def press(self, key: Qt.Key, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
        """Press a key where the keyboard is."""
        QTest.keyClick(QApplication.focusWidget() or self.window, key, modifiers)
        self.settle()

    def message(self) -> str:
        """Return the message line's text."""
        return self.find("message", QLabel).text()

    # The view

    @property
    def viewport(self) -> QWidget:
        """The first viewport."""
        return self.window.view.viewports[0]

    def hover(self, at: QPoint) -> None:
        """Move the mouse to a place in the view, and wait until the view knows."""
        if QCursor.pos() != self.viewport.mapToGlobal(at):
            watcher = _MouseWatcher(self.viewport)
            QTest.mouseMove(self.viewport, at)
            self.wait_until(lambda: watcher.last == at)
            self.viewport.removeEventFilter(watcher)

    def point_in_view(self) -> QPoint:
        """Return where a control point near the middle of the viewport is, as the mouse finds it."""
        middle = self.viewport.rect().center()
        for spot in _spiral(300, step=5):
            self.hover(middle + spot)
            if self.viewport.cursor().shape() is Qt.CursorShape.PointingHandCursor:
                return middle + spot
        raise LookupError("there is no control point in the view")

    def drag(self, start: QPoint, end: QPoint, button: Qt.MouseButton = Qt.MouseButton.LeftButton) -> None:
        """Drag in the view, and hold the button."""
        self._held = end
        QTest.mousePress(self.viewport, button, pos=start)
        for part in range(1, 6):
            QTest.mouseMove(self.viewport, start + (end - start) * part / 5)
            self.settle()

    def release(self, at: QPoint, button: Qt.MouseButton = Qt.MouseButton.LeftButton) -> None:
        """Let go in the view."""
        self._held = None
        QTest.mouseRelease(self.viewport, button, pos=at)
        self.hover(at)  # while a button was held the screen's own mouse has stayed where it was
        self.settle()

    # What there is to record

    def record(self, bench: Bench, target: Path) -> None:
        """Write the facts of the window as it is now, and its pictures."""
        self.window.view.image()  # brings the finer grid at once
        picture = self.rest()
        facts = main_window_facts(self.window) | _filled(
            asked=self.answers.asked,
            complaints=self.complaints,
            clipboard=QGuiApplication.clipboard().text().splitlines(),
            files=self._written(),
            notes=self.notes,
        )
        save_json(target.with_suffix(".json"), json.loads(_plain(json.dumps(facts), bench)))
        picture.save(str(target.with_suffix(".png")))
        pictures = {f"dialog{k}": box.grab().toImage() for k, box in enumerate(open_dialogs(self.window))}
        for name, part in {**pictures, **self.pictures}.items():
            part.save(str(target.with_name(f"{target.name}-{name}.png")))

    def _written(self) -> Facts:
        """Return the digests of the files that the user had written."""
        aside = ("data/", "config/")
        return {name: fact for name, fact in digests(self.home).items() if not name.startswith(aside)}


# ---------------------------------------------------------------------------------------------------------------------
# The states in which the window is recorded


@dataclass(frozen=True)
class State:
    """What is done to a window before it is recorded; ``is_dark`` states are recorded in both themes."""

    prepare: Callable[[Editor], None]
    size: tuple[int, int]
    source: str | None
    is_dark: bool


STATES: dict[str, State] = {}


def state(
    *, size: tuple[int, int] = _FIRST_SIZE, source: str | None = None, dark: bool = False
) -> Callable[[Callable[[Editor], None]], Callable[[Editor], None]]:
    """Enter a function among the states, under its own name."""

    def enter(prepare: Callable[[Editor], None]) -> Callable[[Editor], None]:
        STATES[prepare.__name__] = State(prepare, size, source, dark)
        return prepare

    return enter


@state(dark=True)
def opened(editor: Editor) -> None:
    for menu in (menu for menu in editor.window.findChildren(QMenu) if menu.objectName()):
        menu.adjustSize()
        editor.pictures[f"menu-{menu.objectName().removeprefix('menu.').replace('/', '-')}"] = menu.grab().toImage()


@state(size=(1280, 720), dark=True)
def small(_editor: Editor) -> None:
    pass


@state(size=(1920, 1200), source="paper:fig8")
def large(_editor: Editor) -> None:
    pass


@state()
def least(editor: Editor) -> None:
    editor.window.resize(editor.window.minimumSizeHint())


@state(source="in/odd-double-sum.qovr")
def odd_document(_editor: Editor) -> None:
    pass


@state(source="in/flat-interpolating.qovr")
def flat_document(_editor: Editor) -> None:
    pass


@state(source="in/odd-published.xlsx")
def workbook(_editor: Editor) -> None:
    pass


# Editing


@state()
def typed_knot(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.r", "0.4")


@state()
def undone(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.type_into("control_points.P_2_2.z", "0,75")
    editor.trigger("undo")


@state()
def redone(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.type_into("control_points.P_2_2.z", "0.75")
    editor.trigger("undo", "undo", "redo")


@state()
def typing(editor: Editor) -> None:
    editor.type_into("column_knots.K_1.v", "0.61", end=None)


@state()
def stepped(editor: Editor) -> None:
    editor.focus("control_points.P_1_3.z")
    for key in (Qt.Key.Key_Up, Qt.Key.Key_Up, Qt.Key.Key_PageDown):
        editor.press(key)


@state()
def slider_moved(editor: Editor) -> None:
    editor.focus("column_knots.K_2.s")
    editor.focus("column_knots.slider")
    for _ in range(4):
        editor.press(Qt.Key.Key_Right)


@state()
def curves_not_linked(editor: Editor) -> None:
    editor.trigger("link_curves")
    editor.type_into("column_knots.K_2.r", "0.35")
    editor.focus("column_knots.K_2.r")


@state()
def directions_linked(editor: Editor) -> None:
    editor.trigger("link_directions")
    editor.type_into("column_knots.K_3.v", "0.55")
    editor.focus("column_knots.K_3.v")


@state(dark=True)
def refused_knot(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.s", "2")


@state()
def refused_coordinate(editor: Editor) -> None:
    editor.type_into("control_points.P_0_4.y", "heavy")
    editor.focus("control_points.P_0_4.y")


@state()
def refused_samples(editor: Editor) -> None:
    editor.type_into("surface.samples_u", "1")


@state()
def refusal_outdated(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.s", "2")
    editor.type_into("row_knots.C_4.s", "0.6")


@state(dark=True)
def folding_knots(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.s", "0.93")
    editor.type_into("column_knots.K_0.v", "0.08")
    editor.focus("row_knots.C_4.s")


@state()
def overflowing(editor: Editor) -> None:
    editor.trigger("link_directions")
    editor.type_into("column_knots.K_0.r", "1e-200")


@state()
def samples_changed(editor: Editor) -> None:
    editor.type_into("surface.samples_u", "31")
    editor.type_into("surface.samples_v", "15")


@state()
def interpolating(editor: Editor) -> None:
    editor.choose("surface.formulation", "interpolating")


@state(source="paper:fig6c")
def double_sum(editor: Editor) -> None:
    editor.choose("surface.formulation", "double-sum")


# Live and staged


@state()
def pending(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.type_into("control_points.P_2_2.z", "0.8")


@state()
def pending_dropped(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.type_into("control_points.P_2_2.z", "0.8")
    editor.click("row_knots.get")


@state(dark=True)
def stale(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.type_into("control_points.P_2_2.z", "0.8")
    editor.click("row_knots.set")


@state()
def set_refused(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("column_knots.K_1.r", "7", end=None)
    editor.click("column_knots.set")


@state()
def configured(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.click("row_knots.set")
    editor.click("surface.configure")


@state()
def live_again(editor: Editor) -> None:
    editor.trigger("live")
    editor.type_into("control_points.P_2_2.z", "0.8")
    editor.trigger("live")


@state()
def stale_laboratory(editor: Editor) -> None:
    editor.trigger("live", "laboratory_influence")
    editor.focus("control_points.P_3_2.z")
    editor.choose("surface.formulation", "interpolating")


# The view


@state()
def point_focused(editor: Editor) -> None:
    editor.focus("control_points.P_2_2.z")


@state()
def point_hovered(editor: Editor) -> None:
    editor.window.view.set_camera("top", animated=False)
    editor.point_in_view()


@state()
def point_clicked(editor: Editor) -> None:
    editor.window.view.set_camera("top", animated=False)
    QTest.mouseClick(editor.viewport, Qt.MouseButton.LeftButton, pos=editor.point_in_view())


@state()
def point_dragging(editor: Editor) -> None:
    start = editor.point_in_view()
    editor.drag(start, start + QPoint(10, -40))


@state()
def point_dragged(editor: Editor) -> None:
    start = editor.point_in_view()
    editor.drag(start, start + QPoint(10, -40))
    editor.release(start + QPoint(10, -40))


@state()
def point_dragged_along_z(editor: Editor) -> None:
    start = editor.point_in_view()
    QTest.mousePress(editor.viewport, Qt.MouseButton.LeftButton, pos=start)
    QTest.keyPress(editor.viewport, Qt.Key.Key_Z)
    for up in range(5, 40, 5):
        QTest.mouseMove(editor.viewport, start - QPoint(up // 2, up))
        editor.settle()
    editor.release(start - QPoint(17, 35))
    QTest.keyRelease(editor.viewport, Qt.Key.Key_Z)


@state()
def drag_taken_back(editor: Editor) -> None:
    start = editor.point_in_view()
    editor.drag(start, start + QPoint(10, -40))
    QTest.keyClick(editor.viewport, Qt.Key.Key_Escape)
    editor.release(start + QPoint(10, -40))


@state()
def turned_by_mouse(editor: Editor) -> None:
    corner = QPoint(20, 20)
    editor.drag(corner, corner + QPoint(90, 40))
    editor.release(corner + QPoint(90, 40))
    editor.drag(corner, corner + QPoint(15, 30), Qt.MouseButton.RightButton)
    editor.release(corner + QPoint(15, 30), Qt.MouseButton.RightButton)


@state()
def turned_by_keys(editor: Editor) -> None:
    editor.trigger("go_view")
    for key in (Qt.Key.Key_Left, Qt.Key.Key_Left, Qt.Key.Key_Up, Qt.Key.Key_Plus):
        editor.press(key)


@state()
def point_chosen_by_keys(editor: Editor) -> None:
    editor.trigger("go_view")
    for key in (Qt.Key.Key_Tab, Qt.Key.Key_Tab, Qt.Key.Key_Up, Qt.Key.Key_Right):
        editor.press(key)


@state()
def turned_to_top(editor: Editor) -> None:
    editor.trigger("camera_top")
    QTest.qWait(500)


@state()
def layer_raw(editor: Editor) -> None:
    editor.trigger("layer_raw")


@state(dark=True)
def layer_both(editor: Editor) -> None:
    editor.trigger("layer_both")


@state()
def zones_hidden(editor: Editor) -> None:
    editor.trigger("show_panels")


@state(dark=True)
def pinned_distance(editor: Editor) -> None:
    editor.trigger("pin_reference", "colour_by_distance")
    editor.type_into("control_points.P_3_2.z", "0.9")


@state()
def distance_from_nothing(editor: Editor) -> None:
    editor.trigger("colour_by_distance", "unpin_reference")


@state()
def sensitivity(editor: Editor) -> None:
    editor.focus("column_knots.K_1.s")
    editor.trigger("colour_by_sensitivity")


@state(dark=True)
def probed(editor: Editor) -> None:
    editor.trigger("probe")
    editor.hover(editor.viewport.rect().center())
    editor.settle()
    editor.trigger("copy_probe")


@state()
def probe_refused(editor: Editor) -> None:
    editor.trigger("copy_probe")


# The laboratory


@state(dark=True)
def laboratory_curve(editor: Editor) -> None:
    editor.trigger("laboratory_curve")


@state(source="in/odd-interpolating.qovr")
def curve_of_a_knot(editor: Editor) -> None:
    editor.trigger("laboratory_curve")
    editor.focus("column_knots.K_3.t")
    editor.find("laboratory.curve.equal_scales", QAbstractButton).click()


@state(size=(1280, 720))
def laboratory_in_small(editor: Editor) -> None:
    editor.trigger("laboratory_curve")


@state()
def laboratory_influence(editor: Editor) -> None:
    editor.trigger("laboratory_influence")


@state(dark=True)
def influence_of_a_point(editor: Editor) -> None:
    editor.trigger("laboratory_influence")
    editor.focus("control_points.P_2_2.z")
    editor.wait_until(editor.find("laboratory.influence.copy").isEnabled)
    editor.click("laboratory.influence.copy")


@state(source="in/odd-interpolating.qovr")
def influence_of_a_knot(editor: Editor) -> None:
    editor.trigger("laboratory_influence")
    editor.focus("row_knots.C_1.s")
    editor.find("laboratory.influence.log", QAbstractButton).click()


@state()
def influence_refused(editor: Editor) -> None:
    editor.trigger("laboratory_influence")
    editor.focus("row_knots.C_4.s")
    editor.type_into("laboratory.influence.amount", "0.5")


@state()
def influence_of_nothing(editor: Editor) -> None:
    editor.trigger("laboratory_influence")
    editor.focus("row_knots.C_2.s")


def _measured(editor: Editor) -> None:
    editor.trigger("laboratory_comparison")
    QTest.qWait(600)
    editor.wait_until(editor.find("laboratory.comparison.copy").isEnabled)


@state(dark=True)
def laboratory_comparison(editor: Editor) -> None:
    _measured(editor)
    editor.click("laboratory.comparison.copy")


@state(source="in/odd-interpolating.qovr")
def comparison_beside(editor: Editor) -> None:
    _measured(editor)
    editor.choose("laboratory.comparison.surface", "Catmull-Rom")
    editor.choose("laboratory.comparison.placement", "beside QOVR")
    editor.find("laboratory.comparison.distance_map", QAbstractButton).click()


@state()
def comparison_with_weight(editor: Editor) -> None:
    _measured(editor)
    editor.choose("laboratory.comparison.surface", "NURBS")
    editor.type_into("laboratory.comparison.weight", "25")
    QTest.qWait(600)
    editor.wait_until(editor.find("laboratory.comparison.copy").isEnabled)


@state()
def comparison_refused(editor: Editor) -> None:
    _measured(editor)
    editor.type_into("laboratory.comparison.weight", "-3")


def _decided(editor: Editor) -> None:
    editor.trigger("laboratory_claims")
    QTest.qWait(600)
    editor.wait_until(lambda: not editor.find("laboratory.claims.progress").isVisible())


@state(dark=True)
def laboratory_claims(editor: Editor) -> None:
    _decided(editor)


@state()
def claim_chosen(editor: Editor) -> None:
    _decided(editor)
    editor.find("laboratory.claims.table", QTableWidget).setCurrentCell(6, 2)


@state()
def counterexample_opened(editor: Editor) -> None:
    _decided(editor)
    editor.find("laboratory.claims.table", QTableWidget).setCurrentCell(0, 1)
    editor.click("laboratory.claims.counterexample")
    QTest.qWait(600)
    editor.wait_until(lambda: not editor.find("laboratory.claims.progress").isVisible())
    editor.wait_until(lambda: not editor.message())  # it goes by itself, before all is decided or after


@state()
def laboratory_closed(editor: Editor) -> None:
    editor.trigger("laboratory_influence", "laboratory_curve")
    editor.click("laboratory.close")


# Clipboard


@state()
def zone_copied(editor: Editor) -> None:
    editor.focus("column_knots.K_0.t")
    editor.trigger("copy_zone")


@state()
def plane_copied(editor: Editor) -> None:
    editor.focus("control_points.P_2_2.z")
    editor.trigger("copy_plane")


@state()
def block_pasted(editor: Editor) -> None:
    editor.focus("control_points.P_0_0.z")
    QGuiApplication.clipboard().setText("\n".join("\t".join(f"0.{i}{j}" for j in range(5)) for i in range(5)))
    editor.trigger("paste_zone")


@state()
def paste_refused(editor: Editor) -> None:
    editor.focus("row_knots.C_0.r")
    QGuiApplication.clipboard().setText("1\t2\n3\t4")
    editor.trigger("paste_zone")


@state()
def matrix_copied(editor: Editor) -> None:
    editor.focus("surface.matrix")
    editor.press(Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)


# Files


@state()
def preset_opened(editor: Editor) -> None:
    editor.trigger("preset_fig8")


@state()
def opening_taken_back(editor: Editor) -> None:
    editor.type_into("row_knots.C_4.r", "0.3")
    editor.answers.button = QMessageBox.StandardButton.Cancel
    editor.trigger("preset_fig8")
    editor.answers.button = QMessageBox.StandardButton.Discard


@state()
def file_opened(editor: Editor) -> None:
    editor.answers.files = [str(editor.given / "odd-interpolating.qovr")]
    editor.trigger("open")
    recent = editor.find("menu.recent", QMenu)
    recent.aboutToShow.emit()
    editor.settle()


@state()
def file_refused(editor: Editor) -> None:
    editor.answers.files = [str(editor.given / "place.qovr")]
    editor.trigger("open")


@state()
def file_saved(editor: Editor) -> None:
    editor.type_into("control_points.P_2_2.z", "0.75")
    editor.answers.files = [str(editor.home / "mine")]
    editor.trigger("save_as")
    editor.type_into("row_knots.C_4.r", "0.4")
    editor.trigger("save")


@state()
def saving_failed(editor: Editor) -> None:
    editor.type_into("control_points.P_2_2.z", "0.75")
    editor.answers.files = [str(editor.home / "no" / "such.qovr")]
    editor.trigger("save")


def _export_dialog(editor: Editor, suffix: str) -> QDialog:
    """Open the dialog of Export Data and choose a format."""
    editor.click("surface.export")
    editor.wait_until(lambda: editor.window.findChild(QDialog, "export") is not None)
    formats = editor.find("export.format", QTreeWidget)
    rows = {formats.topLevelItem(k).text(1): formats.topLevelItem(k) for k in range(formats.topLevelItemCount())}
    formats.setCurrentItem(rows[suffix])
    editor.settle()
    return editor.find("export", QDialog)


@state(dark=True)
def export_asked(editor: Editor) -> None:
    _export_dialog(editor, ".xlsx")


@state()
def export_of_mesh_refused(editor: Editor) -> None:
    _export_dialog(editor, ".ply")
    editor.type_into("export.tolerance", "-1", end=None)


@state()
def export_of_each_format(editor: Editor) -> None:
    editor.type_into("surface.samples_u", "11")
    for suffix in (f".{name}" for name in _FORMATS):
        dialog = _export_dialog(editor, suffix)
        editor.notes[suffix] = window_facts(dialog)
        editor.type_into("export.path", str(editor.home / f"out{suffix}"), end=None)
        editor.click("export.start")
        editor.wait_until(lambda: editor.window.findChild(QDialog, "export") is None)
        editor.rest()
        editor.notes[f"message of {suffix}"] = editor.message()


@state()
def export_failed(editor: Editor) -> None:
    _export_dialog(editor, ".csv")
    editor.type_into("export.path", str(editor.home / "no" / "such.csv"), end=None)
    editor.click("export.start")
    editor.wait_until(lambda: "exist" in editor.find("export.note", QLabel).text())


def _press_save(editor: Editor, path: Path) -> None:
    """Press Save in the dialog of a figure, and give it a file."""
    editor.answers.files = [str(path)]
    (dialog,) = open_dialogs(editor.window)
    (save,) = (button for button in dialog.findChildren(QAbstractButton) if button.text().replace("&", "") == "Save")
    QTest.mouseClick(save, Qt.MouseButton.LeftButton)
    editor.wait_until(lambda: not open_dialogs(editor.window))
    editor.rest()
    editor.notes[path.name] = editor.message()


@state(dark=True)
def figure_asked(editor: Editor) -> None:
    editor.click("surface.figure")


@state()
def figure_saved(editor: Editor) -> None:
    for name in ("seen.png", "seen.svg", "seen.pdf", "seen.bmp"):
        editor.click("surface.figure")
        editor.find("figure.dpi", QAbstractSpinBox).setValue(60)  # type: ignore[attr-defined]
        _press_save(editor, editor.home / name)


@state()
def drawings_saved(editor: Editor) -> None:
    editor.trigger("laboratory_curve")
    drawings = editor.find("laboratory.curve.drawing", QComboBox)
    for k in range(drawings.count()):
        drawings.setCurrentIndex(k)
        for suffix in ("svg", "pdf"):
            editor.click("laboratory.curve.figure")
            _press_save(editor, editor.home / f"drawing{k}.{suffix}")


@state(dark=True)
def help_shown(editor: Editor) -> None:
    editor.trigger("help")


@state(dark=True)
def range_asked(editor: Editor) -> None:
    """The dialog may keep the caller waiting, so it is looked at from a timer."""

    def look() -> None:
        for dialog in open_dialogs(editor.window):
            editor.notes["range"] = window_facts(dialog)
            editor.pictures["range"] = dialog.grab().toImage()
            editor.type_into("colour_range.low", "7", end=None)
            editor.notes["refused range"] = window_facts(dialog)
            editor.type_into("colour_range.low", "0.44", end=None)
            dialog.accept()

    QTimer.singleShot(500, editor.window, look)
    editor.trigger("colour_range_fixed")
    editor.wait_until(lambda: "range" in editor.notes)


# From one start to the next


def _kept_documents(editor: Editor) -> list[Path]:
    return list(editor.data.rglob("*.unsaved*"))


@state(dark=True)
def recovery_offered(editor: Editor) -> None:
    """What a crash leaves is put back after the window has ended well, with a fixed name and time."""
    editor.type_into("control_points.P_2_2.z", "0.9")
    editor.wait_until(lambda: _kept_documents(editor))
    (kept,) = _kept_documents(editor)
    content, left = kept.read_bytes(), kept.with_name("0123456789abcdef" + "".join(kept.suffixes))
    editor.close()
    left.write_bytes(content)
    os.utime(left, (1_700_000_000, 1_700_000_000))
    editor.open_window()


@state()
def recovery_taken(editor: Editor) -> None:
    recovery_offered(editor)
    editor.click("recovery.restore")


@state()
def recovery_discarded(editor: Editor) -> None:
    recovery_offered(editor)
    editor.click("recovery.discard")
    editor.notes["left"] = [path.name for path in _kept_documents(editor)]


@state()
def settings_remembered(editor: Editor) -> None:
    """The next window looks as the last one did, and the settings are kept under the same names."""
    editor.window.resize(1500, 950)
    editor.trigger("style_wireframe", "show_labels", "colour_by_mean", "projection_perspective", "laboratory_claims")
    editor.trigger("colour_range_robust", "show_panels", "show_panels", "live")
    editor.answers.files = [str(editor.given / "odd-interpolating.qovr")]
    editor.trigger("open")
    editor.close()
    QSettings().sync()
    QTest.qWait(300)
    files = sorted((editor.home / "config").rglob("*.conf"))
    editor.notes["settings"] = {path.name: path.read_text(encoding="utf-8").splitlines() for path in files}
    editor.open_window()
    editor.find("menu.recent", QMenu).aboutToShow.emit()
    editor.settle()


@state()
def colours_changed_while_open(editor: Editor) -> None:
    """The system tells that its colours have changed; a window that was dark becomes light."""
    editor.trigger("laboratory_curve")
    QGuiApplication.styleHints().colorSchemeChanged.emit(Qt.ColorScheme.Light)


_LAST_IN_DARK = "colours_changed_while_open"


def _states_of(theme: str) -> list[str]:
    """Return the states recorded in a theme; the one that changes it comes last."""
    if theme == "light":
        return [name for name in STATES if name != _LAST_IN_DARK]
    return [*(name for name, entry in STATES.items() if entry.is_dark), _LAST_IN_DARK]


# ---------------------------------------------------------------------------------------------------------------------
# Processes with windows


def start_application(theme: str) -> QApplication:
    """Return the program's own application in a theme, as its command for screenshots makes it."""
    from qovr_app.main import main

    sys.argv = ["qovr", "screenshot", "start.png", "--size", _SCREENSHOT_SIZE, "--theme", theme]
    with suppress(SystemExit):
        main()
    application = QApplication.instance()
    if not isinstance(application, QApplication):
        raise SystemExit("the program's command for screenshots made no application")
    application.setQuitOnLastWindowClosed(False)
    application.setCursorFlashTime(0)
    return application


def show_states(bench: Bench, theme: str, turn: int) -> None:
    """Record states of a theme in this process: every second one, beginning with the first or the other."""
    application, parent = start_application(theme), os.getppid()
    names = [name for name in _states_of(theme) if bench.takes(name)]
    for name in names[turn::_WORKERS] if theme == "light" else names:
        if os.getppid() == parent:  # or nobody waits for it any more
            _show_state(bench, theme, name)
    application.shutdown()


def _show_state(bench: Bench, theme: str, name: str) -> None:
    entry, target = STATES[name], bench.out / "actions" / theme / name
    target.parent.mkdir(parents=True, exist_ok=True)
    editor = None
    try:
        editor = Editor(bench.work / "actions" / theme / name, bench.work / "in", entry.size, entry.source)
        entry.prepare(editor)
        editor.record(bench, target)
    except Exception as error:  # one state that cannot be reached must not hide the others
        complaints = editor.complaints if editor else []
        save_json(target.with_suffix(".json"), {"failed": f"{type(error).__name__}: {error}", "complaints": complaints})
        say(f"  {theme}/{name} failed: {type(error).__name__}: {error}")
    finally:
        if editor is not None:
            editor.close()


_CHOICES = ("style_", "colour_map_", "colour_range_robust", "scaling_", "projection_", "layer_", "camera_")
_BASE = ("style_facets", "colour_by_height", "colour_map_jet", "colour_range_auto", "scaling_each")
_BASE_VIEW = (*_BASE, "projection_parallel", "layer_transformed")


def show_views(bench: Bench, kind: str) -> None:
    """Record the view's own image in every style, by every colour, and with every part of it on and off."""
    application = start_application("light")
    editor = Editor(bench.work / "views" / kind, bench.work / "in", _FIRST_SIZE, "paper:fig8")
    editor.trigger("pin_reference")
    editor.type_into("control_points.P_3_1.z", "0.8")
    editor.focus("column_knots.K_2.v")
    names = [action.objectName() for action in editor.window.findChildren(QAction)]
    for name in names:
        if name.startswith(_CHOICES):
            _save_view(editor, bench, kind, [name])
        elif name.startswith("colour_by_"):
            for style in ("facets", "smooth"):
                _save_view(editor, bench, kind, [f"style_{style}", name])
        elif name.startswith("show_") and name != "show_panels":
            _save_view(editor, bench, kind, [name], undo=[name])
    editor.choose("surface.formulation", "interpolating")
    for choice in ("style_smooth", "colour_by_gaussian", "colour_by_distance"):
        _save_view(editor, bench, kind, [choice], base=_BASE, of="interpolating-")
    editor.close()
    application.shutdown()


def _save_view(
    editor: Editor,
    bench: Bench,
    kind: str,
    names: list[str],
    *,
    undo: Sequence[str] = (),
    base: Sequence[str] = _BASE_VIEW,
    of: str = "",
) -> None:
    target = bench.out / "views" / kind / f"{of}{'-'.join(names)}.png"
    if not bench.takes(target.stem):
        return
    editor.window.view.set_camera("paper", animated=False)
    editor.trigger(*base, *names)
    if any(name.startswith("camera_") for name in names):
        QTest.qWait(400)  # the camera turns
    QTest.qWait(30)
    editor.wait_until(_helpers_sleep)
    target.parent.mkdir(parents=True, exist_ok=True)
    editor.window.view.image().save(str(target))
    editor.trigger(*undo)


def record_actions(bench: Bench) -> None:
    """Record the window in all states, light and dark."""
    _run_windows(bench, [("actions", "light", "0"), ("actions", "light", "1"), ("actions", "dark", "0")])


def record_views(bench: Bench) -> None:
    """Record the view's images, by OpenGL and by the painter."""
    _run_windows(bench, [("views", "opengl", ""), ("views", "painter", "")])


def _run_windows(bench: Bench, calls: Sequence[tuple[str, str, str]]) -> None:
    """Run this file once for each call, each on a screen of its own, where nobody else takes the keyboard."""

    def run(call: tuple[str, str, str]) -> None:
        folder = bench.work / "-".join(call)
        folder.mkdir()
        arguments = ["window", *call, str(bench.work), str(bench.out), bench.like]
        changes = {"QOVR_NO_OPENGL": "1"} if call[1] == "painter" else {}
        command = [sys.executable, "-P", str(Path(__file__).resolve()), *arguments]
        with virtual_screen() as screen:
            window = subprocess.Popen(command, cwd=folder, env=environment(bench, **screen, **changes))
            try:
                code = window.wait(_WINDOW_SECONDS)
            except subprocess.TimeoutExpired:
                window.kill()
                code = window.wait()
        if code:
            say(f"  {' '.join(call)} ended early, with code {code}")

    with ThreadPoolExecutor(len(calls)) as pool:
        list(pool.map(run, calls))


# ---------------------------------------------------------------------------------------------------------------------
# Recording

PARTS: dict[str, Callable[[Bench], None]] = {
    "actions": record_actions,
    "views": record_views,
    "cli": record_cli,
    "exports": record_exports,
    "figures": record_figures,
    "screenshots": record_screenshots,
}


_LIBRARIES = ("PySide6-Essentials", "numpy", "scipy", "matplotlib", "pyqtgraph", "rhino3dm", "XlsxWriter")
"""Whose versions are recorded: another one explains what differs."""


def record(out: Path, program: Path, parts: Sequence[str], like: str) -> None:
    """Record parts of a program into a folder; the other parts that it holds stay."""
    out.mkdir(parents=True, exist_ok=True)
    with workplace() as work:
        bench = Bench(work, out.resolve(), like)
        link_packages(program, bench)
        _check_program(bench, program)
        make_inputs(bench)
        for part in parts:
            begin = time.monotonic()
            if not like:
                shutil.rmtree(out / part, ignore_errors=True)
            PARTS[part](bench)
            say(f"{part:<12}{time.monotonic() - begin:6.0f} s")
    versions = {name: metadata.version(name) for name in _LIBRARIES}
    save_json(out / "libraries.json", {"versions": {"Python": sys.version.split()[0], **versions}})


def _check_program(bench: Bench, program: Path) -> None:
    """Make sure that what is recorded is the program that is meant, and no other that is installed."""
    code = "import qovr_app, qovr_core, qovr_resources as r; print(qovr_app.__file__, qovr_core.__file__, r.__file__)"
    command = [sys.executable, "-P", "-c", code]
    done = subprocess.run(command, cwd=bench.work, env=environment(bench), capture_output=True, text=True, check=True)
    for file in done.stdout.split():
        if program.resolve() not in Path(file).resolve().parents:
            raise SystemExit(f"{file} is not of {program}")
    say(f"recording {program.resolve()}")


# ---------------------------------------------------------------------------------------------------------------------
# Comparing

Difference = tuple[str, str]
"""What differs, and how."""

_SHORT = 200
_MOST_LINES = 12


def differences(old: Any, new: Any, place: tuple[str, ...] = ()) -> Iterator[Difference]:
    """Yield every difference between two facts, as deep inside as it is."""
    if old == new:
        return
    if isinstance(old, dict) and isinstance(new, dict):
        for key in sorted(old.keys() | new.keys()):
            yield from differences(old.get(key), new.get(key), (*place, key))
    elif isinstance(old, list) and isinstance(new, list):
        yield from _list_differences(old, new, place)
    else:
        yield " / ".join(place), f"{_short(old)} -> {_short(new)}"


def _list_differences(old: list[Any], new: list[Any], place: tuple[str, ...]) -> Iterator[Difference]:
    keys = [[json.dumps(entry, sort_keys=True) for entry in entries] for entries in (old, new)]
    lines: list[str] = []
    for kind, a, b, c, d in difflib.SequenceMatcher(None, *keys, autojunk=False).get_opcodes():
        if kind == "replace" and b - a == d - c and not isinstance(old[a], str):
            for k in range(b - a):
                yield from differences(old[a + k], new[c + k], (*place, f"[{a + k}]"))
        elif kind != "equal":
            lines += [f"- {_short(entry)}" for entry in old[a:b]] + [f"+ {_short(entry)}" for entry in new[c:d]]
    if lines:
        more = [f"... and {len(lines) - _MOST_LINES} lines more"] if len(lines) > _MOST_LINES else []
        yield " / ".join(place), "\n      ".join(["", *lines[:_MOST_LINES], *more])


def _short(fact: Any) -> str:
    text = "nothing" if fact is None else json.dumps(fact, ensure_ascii=False)
    return text if len(text) <= _SHORT else f"{text[:_SHORT]}... ({len(text)} characters)"


def _picture_difference(old: Path, new: Path) -> str:
    """Return in how many pixels two pictures differ, and by how much; empty where they do not."""
    if old.read_bytes() == new.read_bytes():
        return ""
    with Image.open(old) as first, Image.open(new) as second:
        a, b = (np.asarray(image.convert("RGBA")).astype(int) for image in (first, second))
    if a.shape != b.shape:
        return f"{a.shape[1]} x {a.shape[0]} -> {b.shape[1]} x {b.shape[0]} pixels"
    far = np.abs(a - b).max(axis=-1)
    if not far.any():
        return ""
    rows, columns = np.nonzero(far)
    box = f"x {columns.min()}..{columns.max()}, y {rows.min()}..{rows.max()}"
    return f"{np.count_nonzero(far)} of {far.size} pixels differ, by {far.max()} at most, in {box}"


def _file_differences(old: Path, new: Path, name: str) -> Iterator[tuple[str, Difference]]:
    """Yield where something differs, and how; of commands each is a place of its own."""
    if name.endswith(".png"):
        if change := _picture_difference(old / name, new / name):
            yield "pictures", (name, change)
        return
    before, after = (json.loads((folder / name).read_text(encoding="utf-8")) for folder in (old, new))
    if "/" in name:
        yield from ((name.removesuffix(".json"), difference) for difference in differences(before, after))
        return
    for key in sorted(before.keys() | after.keys()):
        yield from ((key, difference) for difference in differences(before.get(key), after.get(key)))


def compare(old: Path, new: Path) -> int:
    """Print every difference between two recordings and return how many there are.

    What differs in the same way in several places is said once, with all of them.
    """
    names = [{str(path.relative_to(each)) for path in each.rglob("*") if path.is_file()} for each in (old, new)]
    changes: dict[Difference, list[str]] = defaultdict(list)
    for name in sorted(names[0] ^ names[1]):
        changes[name, "only in the old recording" if name in names[0] else "only in the new recording"].append("files")
    for name in sorted(names[0] & names[1]):
        for place, difference in _file_differences(old, new, name):
            changes[difference].append(place)
    grouped: dict[tuple[str, ...], list[Difference]] = defaultdict(list)
    for difference, places in changes.items():
        grouped[tuple(places)].append(difference)
    for places, group in grouped.items():
        say(f"\n{places[0]}" if len(places) == 1 else f"\n{len(places)} places: {', '.join(places)}")
        for what, how in group:
            say(f"  {what}: {how}")
    count = sum(map(len, changes.values()))
    say(f"\n{count or 'no'} differences in {len(names[0] | names[1])} files")
    return count


# ---------------------------------------------------------------------------------------------------------------------


def _parts(text: str) -> list[str]:
    parts = [part.strip() for part in text.split(",") if part.strip()]
    if wrong := [part for part in parts if part not in PARTS]:
        raise argparse.ArgumentTypeError(f"there is no part {', '.join(wrong)}; expected any of {', '.join(PARTS)}")
    return parts


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    recording = commands.add_parser("record", help="record a program")
    recording.add_argument("out", type=Path)
    recording.add_argument("--program", type=Path, default=Path(__file__).resolve().parents[2], metavar="ROOT")
    recording.add_argument("--only", type=_parts, default=list(PARTS), metavar="PARTS", help=", ".join(PARTS))
    recording.add_argument("--like", default="", help="only what has this in its name")
    comparing = commands.add_parser("compare", help="print every difference; exit 1 if there is one")
    comparing.add_argument("old", type=Path)
    comparing.add_argument("new", type=Path)
    return parser


def main() -> int:
    """Record, compare, or be one of the processes that have a window."""
    if sys.argv[1:2] == ["window"]:
        kind, which, turn, work, out, like = sys.argv[2:]
        bench = Bench(Path(work), Path(out), like)
        if kind == "actions":
            show_states(bench, which, int(turn))
        else:
            show_views(bench, which)
        return 0
    arguments = _parser().parse_args()
    if arguments.command == "compare":
        return 1 if compare(arguments.old, arguments.new) else 0
    record(arguments.out, arguments.program, arguments.only, arguments.like)
    return 0


if __name__ == "__main__":
    sys.exit(main())
