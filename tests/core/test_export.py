"""Exporting as one call, what it asks an evaluation for, and a format from outside."""

import subprocess
import sys

import numpy as np
import pytest

from qovr_core import Evaluation, FileError, Layer, SourceError
from qovr_core.cli import main
from qovr_core.files import FORMATS, ExportOptions, Format, export, read_source, readable_suffixes, source_suffixes
from qovr_core.files.conventions import CsvDialect
from qovr_core.presets import preset
from support.documents import random_document

DOCUMENT = random_document(1, low=0.3, high=0.7)
MOST_MORE = 1.1
"""How much more memory 4096 samples may take than 101 where no sample is written."""


class Watched(Evaluation):
    """Tells which samples it was asked for."""

    def __init__(self, document):
        super().__init__(document)
        self.asked = set()

    def samples(self, layer):
        self.asked.add(layer)
        return super().samples(layer)

    @property
    def raw(self):
        self.asked.add(Layer.RAW)
        return super().raw

    @property
    def transformed(self):
        self.asked.add(Layer.TRANSFORMED)
        return super().transformed


@pytest.mark.parametrize("layer", list(Layer))
@pytest.mark.parametrize("suffix", FORMATS)
def test_a_format_asks_for_the_samples_that_it_writes(suffix, layer, tmp_path):
    evaluation = Watched(DOCUMENT)
    FORMATS[suffix].write(evaluation, tmp_path / f"a{suffix}", lambda _part: None, ExportOptions(layer))
    expected = {layer} if FORMATS[suffix].is_mesh else set(Layer)
    if suffix in (".qovr", ".step", ".iges", ".3dm"):
        expected = set()
    assert evaluation.asked == expected


def test_a_mesh_within_a_tolerance_needs_no_samples(tmp_path):
    evaluation = Watched(DOCUMENT)
    FORMATS[".obj"].write(evaluation, tmp_path / "a.obj", lambda _part: None, ExportOptions(tolerance=0.1))
    assert evaluation.asked == set()


def peak(samples, folder):
    """Return the most memory that exporting what holds no samples takes, in the system's unit.

    A small process in between starts the export: a child's peak counts what its parent held when it was started.
    """
    pytest.importorskip("resource", reason="the system does not tell a process's peak of memory")
    outs = [str(folder / name) for name in ("x.qovr", "y.step")]
    export = f"from qovr_core.cli import main; main(['export', 'paper:fig5', *{outs!r}, '--samples', '{samples}'])"
    between = (
        "import resource, subprocess, sys\n"
        "subprocess.run([sys.executable, '-c', sys.argv[1]], check=True)\n"
        "print(resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss)"
    )
    done = subprocess.run([sys.executable, "-c", between, export], check=True, capture_output=True, text=True)
    if not int(done.stdout):
        pytest.skip("the system does not tell a process's peak of memory")
    assert all((folder / name).exists() for name in outs)
    return int(done.stdout)


def test_what_holds_no_samples_takes_no_memory_for_them(tmp_path):
    few, many = (peak(samples, tmp_path) for samples in (101, 4096))
    assert many <= MOST_MORE * few


def write_points(evaluation, path, progress, options):
    np.savetxt(path, evaluation.samples(options.chosen_layer(evaluation.document)).reshape(-1, 3))
    progress(1.0)


def test_a_format_from_outside_is_everywhere(tmp_path, capsys):
    points = Format(".xyz", "Points", "points", "the rest", write_points, holds_one_layer=True)
    with FORMATS.register(points):
        with pytest.raises(ValueError, match=r"there is a format '\.xyz' already"):
            FORMATS.register(points)
        assert main(["export", "paper:fig5", str(tmp_path / "a.xyz"), "--samples", "3", "--layer", "raw"]) == 0
        assert main(["export", "--help"]) == 0
        assert ".xyz get (default" in " ".join(capsys.readouterr().out.split())
        export(preset("fig8").document, tmp_path / "b.xyz")
    assert len(np.loadtxt(tmp_path / "a.xyz")) == 9
    assert len(np.loadtxt(tmp_path / "b.xyz")) == 101**2
    with pytest.raises(SourceError, match=r"has the suffix '\.xyz'"):
        export(DOCUMENT, tmp_path / "c.xyz")


def test_what_carries_a_document_can_be_read(tmp_path):
    assert readable_suffixes() == (".qovr", ".xlsx", ".npz", ".mat", ".3dm")
    for suffix in readable_suffixes():
        export(DOCUMENT, tmp_path / f"a{suffix}")
        assert read_source(str(tmp_path / f"a{suffix}")) == DOCUMENT


def test_what_a_format_cannot_hold_is_refused_before_any_work(tmp_path):
    told = []
    with pytest.raises(FileError, match="expected at most 1,048,572"):
        export(random_document(1, samples=(1100, 1000)), tmp_path / "a.xlsx", progress=told.append)
    assert told == []
    assert list(tmp_path.iterdir()) == []


def test_other_names_of_formats_are_known(tmp_path, capsys):
    outs = [tmp_path / name for name in ("a.stp", "a.step", "a.igs", "a.iges", "A.STP")]
    assert main(["export", "paper:fig5", *map(str, outs)]) == 0
    stp, step, igs, iges, _ = (out.read_text() for out in outs)
    assert stp.partition("DATA;")[2] == step.partition("DATA;")[2]
    assert igs.partition("128 ")[2] == iges.partition("128 ")[2]
    with pytest.raises(SourceError, match=r"a\.xlsm: '\.xlsm' is only read, not written; expected \.xlsx"):
        export(DOCUMENT, tmp_path / "a.xlsm")
    export(DOCUMENT, tmp_path / "a.xlsx")
    (tmp_path / "a.xlsx").rename(tmp_path / "b.xlsm")
    assert read_source(str(tmp_path / "b.xlsm")) == DOCUMENT
    assert source_suffixes() == (*readable_suffixes(), ".xlsm")
    for name in ("a.stp", "a.igs"):
        with pytest.raises(SourceError, match="is no source"):
            read_source(str(tmp_path / name))


@pytest.mark.parametrize(("option", "value"), [("--up", "y"), ("--csv-dialect", "semicolon"), ("--tolerance", "0.1")])
def test_a_choice_that_no_file_heeds_is_refused(option, value, tmp_path, capsys):
    assert main(["export", "paper:fig5", str(tmp_path / "a.step"), option, value]) == 2
    assert f"{option} is for a" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


def test_a_csv_of_either_dialect_holds_the_same_numbers(tmp_path):
    for dialect in CsvDialect:
        export(DOCUMENT, tmp_path / f"{dialect}.csv", ExportOptions(csv_dialect=dialect))
    comma, semicolon = ((tmp_path / f"{dialect}.csv").read_text() for dialect in CsvDialect)
    head, *lines = semicolon.splitlines()
    assert "," not in head
    assert "." not in "".join(lines)
    assert semicolon.replace(",", ".").replace(";", ",") == comma
    assert main(["export", "paper:fig5", str(tmp_path / "a.csv"), "--csv-dialect", "semicolon"]) == 0
    assert (tmp_path / "a.csv").read_text().startswith("i;j;u;v;")
