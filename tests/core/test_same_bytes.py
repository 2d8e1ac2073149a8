"""The same document gives the same bytes, whatever the day, the hash seed and the locale of the process."""

import subprocess
import sys

import pytest

from qovr_core.cli import main
from qovr_core.files import FORMATS, read_source
from support.command import environment

WRITE = """
import sys, time
from pathlib import Path
shift = float(sys.argv[1])
now, local = time.time, time.localtime
time.time = lambda: now() + shift
time.localtime = lambda seconds=None: local(time.time() if seconds is None else seconds)
from qovr_core.cli import main
folder = Path(sys.argv[2])
outs = [str(folder / f"a{suffix}") for suffix in sys.argv[3].split(",")]
assert main(["export", "paper:fig6b", *outs, "--samples", "9x5"]) == 0
assert main(["figures", str(folder), "--only", "fig2", "--dpi", "50"]) == 0
"""
FIGURES = [f"{name}.{kind}" for name in ("fig2",) for kind in ("png", "svg", "pdf")]
PROCESSES = (
    {"PYTHONHASHSEED": "1", "TZ": "UTC", "LC_ALL": "C"},
    {"PYTHONHASHSEED": "2", "TZ": "Asia/Kathmandu", "LC_ALL": "de_DE.UTF-8"},
)


def written(folder, shift, **changes):
    folder.mkdir()
    command = [sys.executable, "-c", WRITE, str(shift), str(folder), ",".join(FORMATS)]
    subprocess.run(command, env=environment(**changes), check=True)
    return {path.name: path.read_bytes() for path in folder.iterdir()}


@pytest.fixture(scope="module")
def twice(tmp_path_factory):
    folder = tmp_path_factory.mktemp("twice")
    return [written(folder / str(k), 1e7 * k, **changes) for k, changes in enumerate(PROCESSES)]


def test_every_format_and_figure_is_written_twice_alike(twice):
    first, second = twice
    assert set(first) == set(second) == {*(f"a{suffix}" for suffix in FORMATS), "a.inputs.json", *FIGURES}
    assert [name for name in first if first[name] != second[name]] == []


def test_a_time_that_is_given_is_told(tmp_path):
    rhino3dm = pytest.importorskip("rhino3dm")
    openpyxl = pytest.importorskip("openpyxl")
    files = written(tmp_path / "a", 0, SOURCE_DATE_EPOCH="1700000000")
    model = rhino3dm.File3dm.Read(str(tmp_path / "a/a.3dm"))
    assert str(model.Created) == str(model.LastEdited) == "2023-11-14 22:13:20"
    assert str(openpyxl.load_workbook(tmp_path / "a/a.xlsx").properties.created) == "2023-11-14 22:13:20"
    for name, text in {
        "a.step": b"'2023-11-14T22:13:20'",
        "a.iges": b"15H20231114.221320",
        "a.mat": b"created on 2023-11-14T22:13:20",
        "fig2.pdf": b"D:20231114221320Z",
        "fig2.svg": b"2023-11-14T22:13:20",
    }.items():
        assert text in files[name], name
    for suffix in (".3dm", ".mat", ".xlsx", ".npz"):
        assert read_source(str(tmp_path / f"a/a{suffix}")).samples == (9, 5)


@pytest.mark.parametrize("text", ["yesterday", "1e9", "9" * 30])
def test_a_time_that_is_none_is_refused(text, tmp_path, monkeypatch, capsys):
    monkeypatch.setenv("SOURCE_DATE_EPOCH", text)
    assert main(["export", "paper:fig5", str(tmp_path / "a.step")]) == 2
    assert capsys.readouterr().err.startswith("qovr: SOURCE_DATE_EPOCH is '")
    assert list(tmp_path.iterdir()) == []
