"""``qovr`` as a user runs it: other processes, exit codes, one-line errors, nothing left behind."""

import json
import os
import pty
import re
import select
import shutil
import signal
import subprocess
import termios
import time
import zipfile
from pathlib import Path

import numpy as np
import openpyxl
import pytest

from qovr_core import FORMULATIONS, Formulation, configure
from qovr_core.files import FORMATS, read_document, write_document
from qovr_core.files.qovr_document import document_to_json
from qovr_core.presets import preset, presets
from qovr_core.shapes import SHAPES
from support.command import PUBLISHED, QOVR, environment, qovr, refused
from support.documents import random_document

LARGE = [suffix for suffix in FORMATS if suffix not in (".qovr", ".step", ".iges", ".3dm")]
"""Formats that hold points by the thousand."""

DOCUMENT = json.loads(document_to_json(random_document(1)))


def left(folder):
    return sorted(entry.name for entry in folder.iterdir())


# --- what it does -----------------------------------------------------------------------------------------------------


def test_export_writes_every_format_at_once(tmp_path):
    run = qovr("export", "paper:fig6b", "a.xlsx", "a.csv", "a.npz", "a.qovr", "--samples", "9x4", cwd=tmp_path)
    assert (run.code, run.out, run.err) == (0, "", "")
    assert left(tmp_path) == ["a.csv", "a.inputs.json", "a.npz", "a.qovr", "a.xlsx"]
    document = read_document(tmp_path / "a.qovr")
    assert document.samples == (9, 4)
    assert np.array_equal(np.load(tmp_path / "a.npz")["raw"], configure(document).raw)


def test_every_format_in_one_call(tmp_path):
    names = [f"a{suffix}" for suffix in FORMATS]
    run = qovr("export", "paper:fig6b", *names, "--samples", "9x4", "--layer", "raw", cwd=tmp_path)
    assert (run.code, run.out, run.err) == (0, "", "")
    assert left(tmp_path) == sorted([*names, "a.inputs.json"])
    for name in ("a.npz", "a.mat", "a.3dm", "a.xlsx"):
        assert qovr("export", name, "b.qovr", cwd=tmp_path).code == 0
        assert read_document(tmp_path / "b.qovr") == read_document(tmp_path / "a.qovr")


def test_tolerance_and_layer_choose_the_mesh(tmp_path):
    def triangles(*options):
        assert qovr("export", "paper:fig6b", "a.stl", *options, cwd=tmp_path).code == 0
        content = (tmp_path / "a.stl").read_bytes()
        return content[:80].decode(), int.from_bytes(content[80:84], "little")

    assert triangles() == ("QOVR Studio 0.1.0, formulation published, transformed surface".ljust(80), 20_000)
    coarse = triangles("--tolerance", "0.1")[1]
    assert coarse < triangles("--tolerance", "0.01")[1]
    assert "raw surface" in triangles("--layer", "raw")[0]


def test_export_options(tmp_path):
    write_document(random_document(5), tmp_path / "in.qovr")
    call = ("export", "in.qovr", "out.qovr", "out.npz", "--formulation", "double-sum", "--samples", "12")
    assert qovr(*call, cwd=tmp_path).code == 0
    out = read_document(tmp_path / "out.qovr")
    assert out.formulation is Formulation.DOUBLE_SUM
    assert out.samples == (12, 12)
    assert out.row_knots == random_document(5).row_knots


def test_a_workbook_is_a_source_and_reproduces_itself(tmp_path):
    for formulation in FORMULATIONS.values():
        assert qovr("export", "paper:fig6c", "a.xlsx", "--formulation", formulation, cwd=tmp_path).code == 0
        run = qovr("reproduce", "a.xlsx", "--json", cwd=tmp_path)
        assert run.code == 0
        (result,) = json.loads(run.out)["workbooks"]
        assert result["met_by"] == [str(formulation)]
        assert result["samples"] == [101, 101]
        assert set(result["differences"]) == set(FORMULATIONS)
        assert set(result["differences"]["published"]) == {"raw", "box", "matrix", "transformed"}
        info = json.loads(qovr("info", "a.xlsx", "--json", cwd=tmp_path).out)
        assert info["formulation"] == formulation.name


def test_reproduce_meets_every_published_workbook():
    workbooks = sorted(PUBLISHED.glob("*.xlsx"))
    if not workbooks:
        pytest.skip("the published workbooks are not on this machine")
    run = qovr("reproduce", *workbooks)
    assert run.code == 0
    assert run.out.count("meets the workbook") == len(workbooks)


def test_reproduce_says_no_to_a_workbook_that_no_formulation_meets(tmp_path):
    qovr("export", "paper:fig5", "a.xlsx", "--samples", "11", cwd=tmp_path)
    book = openpyxl.load_workbook(tmp_path / "a.xlsx")
    book.worksheets[0]["N60"].value += 1e-6
    book.save(tmp_path / "b.xlsx")
    run = qovr("reproduce", "b.xlsx", cwd=tmp_path)
    assert run.code == 1
    assert "none meets it" in run.out
    assert qovr("reproduce", "a.xlsx", "b.xlsx", cwd=tmp_path).code == 1
    assert json.loads(qovr("reproduce", "b.xlsx", "--json", cwd=tmp_path).out)["reproduced"] is False


def test_presets_are_listed():
    run = qovr("presets")
    assert run.code == 0
    names = [*(f"paper:{name}" for name in presets()), *(f"shape:{name}" for name in SHAPES)]
    assert [line.split()[0] for line in run.out.splitlines()] == names


def test_info_in_words_and_in_json(tmp_path):
    run = qovr("info", "paper:fig5")
    assert run.code == 0
    assert "degree           4 in u, 4 in v" in run.out
    facts = json.loads(qovr("info", "paper:fig5", "--json").out)
    assert facts["raw_box"] == pytest.approx(np.array([[10, 30], [20, 60], [0.88, 1.2]]))
    assert facts["matrix"] == pytest.approx(np.array(configure(preset("fig5").document).matrix))
    assert facts["folding"] == []
    assert facts["without_effect"] == [f"row_knots[{i}]" for i in range(4)]
    content = json.loads(document_to_json(preset("fig5").document))
    content["row_knots"][2] = {"r": 0.5, "s": 0.2, "u": 0.2, "t": 0.5}
    content["column_knots"][3] = {"r": 0.5, "s": 0.2, "v": 0.5, "t": 0.5}  # s(v) turns round, the curve does not
    content["formulation"] = "interpolating"
    (tmp_path / "fold.qovr").write_text(json.dumps(content))
    run = qovr("info", "fold.qovr", cwd=tmp_path)
    assert "folding back     row_knots[2] (u from 0.650435 to 0.90706)\n" in run.out
    assert "degree           4 in u, 6 in v" in run.out
    (curve,) = json.loads(qovr("info", "fold.qovr", "--json", cwd=tmp_path).out)["folding"]
    assert curve == {"curve": "row_knots[2]", "backward": [pytest.approx([0.650434559, 0.907059523])]}


def test_help_and_version():
    run = qovr("--help")
    assert run.code == 0
    for name in ("export", "figures", "reproduce", "presets", "info"):
        assert name in run.out
        assert qovr(name, "--help").code == 0
    assert qovr("--version").out.startswith("QOVR Studio ")


def test_a_reader_that_leaves_early_is_no_error():
    command = f"'{QOVR}' info paper:fig5 | head -n 1; exit ${{PIPESTATUS[0]}}"
    done = subprocess.run(["bash", "-c", command], env=environment(), capture_output=True, text=True, check=False)
    assert done.returncode == 0
    assert done.stderr == ""


def test_an_answer_that_cannot_be_written_is_one_line():
    done = subprocess.run(
        f"'{QOVR}' info paper:fig5 > /dev/full",
        shell=True,
        env=environment(),
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2
    assert done.stderr == "qovr: the answer cannot be written: No space left on device\n"


def on_a_terminal(*arguments, cwd):
    """Run the command on a pseudo-terminal and return its exit code and what stood there."""
    pid, terminal = pty.fork()
    if pid == 0:
        termios.tcsetwinsize(0, (24, 100))
        os.chdir(cwd)
        os.execve(QOVR, [str(QOVR), *arguments], environment(TERM="xterm"))
    shown = b""
    while select.select([terminal], [], [], 60)[0]:
        try:
            part = os.read(terminal, 4096)
        except OSError:  # the other end is closed
            break
        if not part:
            break
        shown += part
    os.close(terminal)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1]), shown.decode()


def test_long_work_shows_a_bar_on_a_terminal_and_says_first_how_long(tmp_path):
    code, shown = on_a_terminal("export", "paper:fig5", "a.xlsx", "--samples", "320", cwd=tmp_path)
    assert code == 0
    assert "102,400 points will take about" in shown
    assert re.search(r"a\.xlsx: +[0-9]+% \|.*left", shown)


# --- what it refuses --------------------------------------------------------------------------------------------------


def changed(**changes):
    return {**DOCUMENT, **changes}


def knots_with(zone, index, **values):
    curves = [dict(entry) for entry in DOCUMENT[zone]]
    curves[index].update(values)
    return changed(**{zone: curves})


def net_with(value):
    net = json.loads(json.dumps(DOCUMENT["control_points"]))
    net[3][1][2] = value
    return changed(control_points=net)


def without(key):
    return {name: value for name, value in DOCUMENT.items() if name != key}


BAD_DOCUMENTS = {
    "an unknown key": (changed(colour="red"), "colour is no key of a document"),
    "an unknown knot": (
        knots_with("row_knots", 2, v=0.5),
        "row_knots[2].v is no key of a document; expected only r, s, u, t",
    ),
    "a missing key": (without("samples"), "samples is missing"),
    "a missing knot": (changed(row_knots=[{"r": 0.5}] * 5), "row_knots[0].s is missing"),
    "four rows": (
        changed(control_points=DOCUMENT["control_points"][:4]),
        "control_points is a list of 4 entries; expected",
    ),
    "a plane net": (changed(control_points=[[[1, 2]] * 5] * 5), "control_points[0][0] is a list of 2 entries"),
    "a net of text": (changed(control_points="net"), "control_points is 'net'"),
    "knots as lists": (changed(row_knots=[[0.5] * 4] * 5), "row_knots[0] is a list of 4 entries; expected an object"),
    "a knot of 1": (
        knots_with("column_knots", 4, v=1),
        "column_knots[4].v is 1; expected a number strictly between 0 and 1",
    ),
    "a knot of 0": (knots_with("row_knots", 0, t=0.0), "row_knots[0].t is 0.0; expected"),
    "a knot of text": (knots_with("row_knots", 0, r="0.5"), "row_knots[0].r is '0.5'"),
    "no number": (net_with(float("nan")), "control_points[3][1][2] is nan; expected a finite number"),
    "infinity": (net_with(float("-inf")), "control_points[3][1][2] is -inf"),
    "an absurd number": (
        net_with(1.5e12),
        "control_points[3][1][2] is 1500000000000.0; expected a finite number of magnitude",
    ),
    "a huge whole number": (net_with(10**400), "control_points[3][1][2] is 1000"),
    "a truth": (net_with(True), "control_points[3][1][2] is True"),
    "nothing": (net_with(None), "control_points[3][1][2] is empty"),
    "one sample": (changed(samples=[1, 101]), "samples[0] is 1; expected a whole number from 2 to 4096"),
    "many samples": (changed(samples=[101, 4097]), "samples[1] is 4097"),
    "half a sample": (changed(samples=[101, 10.5]), "samples[1] is 10.5"),
    "a formulation": (changed(formulation="tensor"), "formulation is 'tensor'; expected one of published"),
    "a newer version": (changed(version=3), "version is 3; expected 1 or 2; a newer program wrote this file"),
    "a version of text": (changed(version="1"), "version is '1'; expected 1"),
    "another format": (changed(format="else"), "format is 'else'; expected 'qovr-document'"),
    "a list": ([1, 2], "the file is a list of 2 entries; expected an object"),
}


@pytest.mark.parametrize("name", BAD_DOCUMENTS)
def test_bad_documents(name, tmp_path):
    content, message = BAD_DOCUMENTS[name]
    (tmp_path / "bad.qovr").write_text(json.dumps(content))
    error = refused(qovr("export", "bad.qovr", "out.npz", cwd=tmp_path))
    assert error.startswith("qovr: bad.qovr: ")
    assert message in error
    assert left(tmp_path) == ["bad.qovr"]


BAD_TEXTS = {
    "deeply nested": (b"[" * 100_000, "is nested too deeply"),
    "binary rubbish": (bytes(range(256)) * 40, "is no UTF-8"),
    "cut off": (document_to_json(random_document(1)).encode()[:700], "is no JSON"),
    "empty": (b"", "line 1, column 1 is no JSON"),
    "an endless number": (b'{"format": ' + b"9" * 10_000 + b"}", "bad.qovr: "),
    "twice the same key": (b'{"format": "qovr-document", "format": "qovr-document"}', "format is given twice"),
    "huge": (b" " * 41_000_000, "is larger than 40000 kB"),
}


@pytest.mark.parametrize("name", BAD_TEXTS)
def test_bad_texts(name, tmp_path):
    content, message = BAD_TEXTS[name]
    (tmp_path / "bad.qovr").write_bytes(content)
    assert message in refused(qovr("info", "bad.qovr", cwd=tmp_path))
    assert left(tmp_path) == ["bad.qovr"]


def workbook(folder, change):
    qovr("export", "paper:fig5", "good.xlsx", "--samples", "5", cwd=folder)
    book = openpyxl.load_workbook(folder / "good.xlsx")
    change(book)
    book.save(folder / "bad.xlsx")


def put(cell, value):
    def change(book):
        book.worksheets[0][cell].value = value

    return change


BAD_CELLS = {
    "text for a number": (put("G7", "abc"), "QOVR surface!G7 is 'abc'; expected a finite number"),
    "an empty number": (put("E29", None), "QOVR surface!E29 is empty"),
    "a knot out of range": (put("AH6", 1.5), "QOVR surface!AH6 is 1.5; expected a number strictly between 0 and 1"),
    "a knot of text": (put("AO7", "0,5"), "QOVR surface!AO7 is '0,5'"),
    "points in another order": (put("D6", 4), "QOVR surface!D6 is 4.0; expected the index 1"),
}


@pytest.mark.parametrize("name", BAD_CELLS)
@pytest.mark.parametrize("command", [("info",), ("reproduce",)])
def test_bad_cells(name, command, tmp_path):
    change, message = BAD_CELLS[name]
    workbook(tmp_path, change)
    assert message in refused(qovr(*command, "bad.xlsx", cwd=tmp_path))


def test_a_workbook_with_text_among_its_points_has_its_inputs_read_and_is_not_compared(tmp_path):
    workbook(tmp_path, put("O9", "many"))
    assert qovr("info", "bad.xlsx", cwd=tmp_path).code == 0
    assert "QOVR surface!O9 is 'many'" in refused(qovr("reproduce", "bad.xlsx", cwd=tmp_path))


def test_a_workbook_without_points_cannot_be_compared(tmp_path):
    workbook(tmp_path, lambda book: book.worksheets[0].delete_rows(30, 99) or put("N5", None)(book))
    assert "QOVR surface!N5 is empty; expected the raw coordinates" in refused(
        qovr("reproduce", "bad.xlsx", cwd=tmp_path)
    )


def test_a_workbook_without_the_sheet(tmp_path):
    openpyxl.Workbook().save(tmp_path / "empty.xlsx")
    assert "Sheet!C5 is empty; expected the index 0" in refused(qovr("info", "empty.xlsx", cwd=tmp_path))
    qovr("export", "paper:fig5", "good.xlsx", cwd=tmp_path)
    with zipfile.ZipFile(tmp_path / "good.xlsx") as good, zipfile.ZipFile(tmp_path / "bad.xlsx", "w") as bad:
        for name in good.namelist():
            if "sheet1" not in name:
                bad.writestr(name, good.read(name))
    refused(qovr("info", "bad.xlsx", cwd=tmp_path))


@pytest.mark.parametrize("kept", [0, 10, 3000, 20_000])
def test_a_truncated_workbook(kept, tmp_path):
    qovr("export", "paper:fig5", "good.xlsx", "--samples", "40", cwd=tmp_path)
    whole = (tmp_path / "good.xlsx").read_bytes()
    assert len(whole) > kept
    (tmp_path / "bad.xlsx").write_bytes(whole[:kept])
    assert "bad.xlsx: is no whole Excel workbook" in refused(qovr("reproduce", "bad.xlsx", cwd=tmp_path))


def test_rubbish_inside_a_workbook(tmp_path):
    qovr("export", "paper:fig5", "good.xlsx", "--samples", "5", cwd=tmp_path)
    rng = np.random.default_rng(0)
    with zipfile.ZipFile(tmp_path / "good.xlsx") as good:
        parts = {name: good.read(name) for name in good.namelist()}
    for damaged in parts:
        with zipfile.ZipFile(tmp_path / "bad.xlsx", "w") as bad:
            for name, content in parts.items():
                bad.writestr(name, rng.bytes(500) if name == damaged else content)
        run = qovr("info", "bad.xlsx", cwd=tmp_path)
        assert run.code in (0, 2)  # parts such as the theme are nobody's business
        if run.code == 2:
            refused(run)


BAD_CALLS = [
    (["export", "paper:fig9", "a.npz"], "there is no preset 'fig9'; expected one of fig5, fig6a"),
    (["export", "missing.qovr", "a.npz"], "missing.qovr: cannot be read: No such file or directory"),
    (["export", "missing.xlsx", "a.npz"], "missing.xlsx: cannot be read: No such file or directory"),
    (["export", ".", "a.npz"], ".: is no source"),
    (["export", "paper:fig5", "a.doc"], "a.doc: has the suffix '.doc'; expected one of .xlsx"),
    (["export", "paper:fig5", "a"], "a: has no suffix"),
    (["export", "paper:fig5", "no/such/a.npz"], "the folder no/such does not exist"),
    (["export", "paper:fig5", "good.npz", "no/such/a.npz"], "the folder no/such does not exist"),
    (["export", "paper:fig5"], "the following arguments are required: OUT"),
    (
        ["export", "paper:fig5", "a.npz", "--samples", "1"],
        "samples along u is 1; expected a whole number from 2 to 4096",
    ),
    (["export", "paper:fig5", "a.npz", "--samples", "11x5000"], "samples along v is 5000"),
    (["export", "paper:fig5", "a.npz", "--samples", "many"], "'many' is no sample count; expected N or NxM"),
    (["export", "paper:fig5", "a.npz", "--formulation", "tensor"], "invalid choice: 'tensor'"),
    (["export", "paper:fig5", "a.npz", "--layer", "both"], "invalid choice: 'both'"),
    (["export", "paper:fig5", "a.xlsx", "--samples", "2000"], "4,000,000 points; expected at most 1,048,572"),
    (
        ["export", "paper:fig5", "a.npz", "a.step", "--tolerance", "0.1"],
        "expected an OUT that ends in .obj, .stl, .ply",
    ),
    (["export", "paper:fig5", "a.stl", "--tolerance", "0"], "'0' is no tolerance; expected a positive distance"),
    (["export", "paper:fig5", "a.stl", "--tolerance", "nan"], "'nan' is no tolerance"),
    (["export", "paper:fig5", "a.stl", "--tolerance", "fine"], "'fine' is no tolerance"),
    (
        ["export", "paper:fig5", "a.ply", "--tolerance", "1e-12"],
        "a.ply: a tolerance of 1e-12 needs more than 4096 x 4096",
    ),
    (["export", "paper:fig5", "a.stl", "--tolerance", "1e-12"], "a.stl: a tolerance of 1e-12 is lost in 32-bit"),
    (["figures", "out", "--only", "fig9"], "there is no figure 'fig9'; expected one of fig1a, fig1b"),
    (["figures", "out", "--formats", "gif"], "there is no figure format 'gif'; expected any of png, svg, pdf"),
    (["figures", "out", "--dpi", "9"], "'9' is no resolution"),
    (["reproduce", "missing.xlsx"], "missing.xlsx: cannot be read: No such file or directory"),
    (["info"], "the following arguments are required: SOURCE"),
    (["info", "--jso", "paper:fig5", "--nonsense"], "--nonsense"),
]


@pytest.mark.parametrize(
    ("call", "message"), BAD_CALLS, ids=lambda part: " ".join(part) if isinstance(part, list) else ""
)
def test_bad_calls(call, message, tmp_path):
    assert message in refused(qovr(*call, cwd=tmp_path))
    assert left(tmp_path) == []


def test_a_name_with_a_line_break_stays_one_line(tmp_path):
    refused(qovr("info", "two\nlines.qovr", cwd=tmp_path))
    refused(qovr("info", os.fsdecode(b"\xff\xfe.qovr"), cwd=tmp_path))


def test_a_surface_that_overflows(tmp_path):
    (tmp_path / "a.qovr").write_text(json.dumps(knots_with("row_knots", 1, s=1e-320)))
    assert "row_knots[1].s = 1e-320" in refused(qovr("export", "a.qovr", "a.npz", cwd=tmp_path))
    assert left(tmp_path) == ["a.qovr"]


def test_a_target_that_is_a_folder(tmp_path):
    (tmp_path / "a.npz").mkdir()
    assert "it is a folder" in refused(qovr("export", "paper:fig5", "a.npz", cwd=tmp_path))


@pytest.mark.skipif(os.name != "posix" or os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written(tmp_path):
    tmp_path.chmod(0o500)
    try:
        assert "Permission denied" in refused(qovr("export", "paper:fig5", "a.npz", cwd=tmp_path))
    finally:
        tmp_path.chmod(0o700)
    assert left(tmp_path) == []


@pytest.mark.skipif(not Path("/proc/self").is_dir(), reason="needs a folder that nobody may write")
@pytest.mark.parametrize("name", [f"a{suffix}" for suffix in FORMATS])
def test_a_folder_that_nobody_may_write(name):
    assert "cannot be written: " in refused(qovr("export", "paper:fig5", f"/proc/self/{name}"))


# --- what it survives -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("name", [f"a{suffix}" for suffix in LARGE])
def test_a_write_that_fails_leaves_the_old_file(name, tmp_path):
    (tmp_path / name).write_text("precious")
    run = qovr("export", "paper:fig5", name, cwd=tmp_path, largest_file=20_000)
    assert f"{name}: cannot be written: " in refused(run)
    assert left(tmp_path) == [name]
    assert (tmp_path / name).read_text() == "precious"


@pytest.fixture
def tiny_disk(tmp_path):
    disk = tmp_path / "disk"
    disk.mkdir()
    mount = ["mount", "-t", "tmpfs", "-o", "size=200k", "tmpfs", str(disk)]
    if not shutil.which("mount") or subprocess.run(mount, capture_output=True, check=False).returncode != 0:
        pytest.skip("no small disk can be mounted here")
    yield disk
    subprocess.run(["umount", str(disk)], check=True)


@pytest.mark.parametrize("name", [*(f"a{suffix}" for suffix in LARGE), "figures"])
def test_a_disk_that_fills_up(name, tiny_disk):
    call = (
        ("figures", ".", "--only", "fig5b", "--formats", "svg") if name == "figures" else ("export", "paper:fig5", name)
    )
    assert "No space left on device" in refused(qovr(*call, cwd=tiny_disk))
    assert left(tiny_disk) == []


def deliver_interrupts():
    """A shell that starts tests in the background has its children ignore Ctrl-C; a user's does not."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


@pytest.mark.parametrize("kind", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("name", ["a.xlsx", "a.csv", "a.obj"])
def test_an_interrupted_export_leaves_nothing(name, kind, tmp_path):
    call = [QOVR, "export", "paper:fig5", name, "--samples", "1000"]
    running = subprocess.Popen(
        call,
        preexec_fn=deliver_interrupts,
        cwd=tmp_path,
        env=environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
    )
    deadline = time.monotonic() + 60
    while not left(tmp_path) and time.monotonic() < deadline:
        time.sleep(0.01)
    time.sleep(0.5)
    assert left(tmp_path), "the export never began"
    running.send_signal(kind)
    out, err = running.communicate(timeout=60)
    assert running.returncode == 128 + kind
    assert out == ""
    assert err == "qovr: interrupted; no unfinished file is left\n"
    assert left(tmp_path) == []
