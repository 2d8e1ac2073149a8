"""The headless commands on nets of many windows."""

import json
from dataclasses import replace

import pytest

from qovr_core.cli import main
from qovr_core.edits import extract_window, set_samples
from qovr_core.files import FORMATS, export, read_source, write_document
from qovr_core.laboratory.comparison import compare
from qovr_core.laboratory.comparison_report import comparison_facts, comparison_text
from support.nets import closed_net, random_net_document

NET = random_net_document(1, (2, 3), smooth=0.5, samples=(31, 25))


@pytest.fixture
def run(tmp_path, capsys, monkeypatch):
    """Return a function that calls the command beside NET and returns exit code, stdout and stderr."""
    write_document(NET, tmp_path / "net.qovr")
    monkeypatch.chdir(tmp_path)

    def call(*arguments):
        code = main(list(map(str, arguments)))
        return code, *capsys.readouterr()

    return call


def test_info_says_what_the_net_is(run):
    code, out, _ = run("info", "net.qovr")
    assert code == 0
    assert "windows          2 x 3, m along v and n along u\n" in out
    assert "joints           u: 1 smooth, 1 sharp; v: 1 smooth\n" in out
    assert "lengths          u: 1 to 4.80455; v: 0.628954 to 1\n" in out
    assert "closed along" not in out
    facts = json.loads(run("info", "net.qovr", "--json")[1])
    assert facts["windows"] == [2, 3]
    assert facts["joints"] == {"u": ["sharp", "smooth"], "v": ["smooth"]}
    assert [len(facts["lengths"][name]) for name in "uv"] == [3, 2]
    assert facts["folding_count"] == len(facts["folding"])
    assert all(each["curve"].count("[") == 2 for each in facts["folding"])


def test_info_says_under_which_formulation_windows_do_not_meet(run, tmp_path):
    write_document(replace(NET, formulation="published"), tmp_path / "apart.qovr")
    assert "m along v and n along u; under published they do not meet\n" in run("info", "apart.qovr")[1]


def test_info_of_a_closed_net(run, tmp_path):
    write_document(closed_net(1, (3, 2), ("v",)), tmp_path / "closed.qovr")
    assert "closed along     v\n" in run("info", "closed.qovr")[1]
    assert json.loads(run("info", "closed.qovr", "--json")[1])["closed"] == ["v"]


def test_info_names_a_few_of_many_curves_that_fold(run, tmp_path):
    document = random_net_document(3, (9, 9), smooth=0.0, margin=0.02)
    write_document(document, tmp_path / "wild.qovr")
    (line,) = (line for line in run("info", "wild.qovr")[1].splitlines() if line.startswith("folding back"))
    facts = json.loads(run("info", "wild.qovr", "--json")[1])
    assert line.endswith(f" and {facts['folding_count'] - 10} more")
    assert len(facts["folding"]) == facts["folding_count"] > 100


def test_a_published_net_names_the_curves_without_effect(run, tmp_path):
    write_document(random_net_document(1, (2, 3), formulation="published"), tmp_path / "a.qovr")
    facts = json.loads(run("info", "a.qovr", "--json")[1])
    assert facts["without_effect"] == [f"row_knots[{i}]" for i in (0, 1, 2, 3, 5)]


def test_a_window_is_compared_as_a_document_of_its_own(run):
    comparison = compare(extract_window(NET, (1, 2)))
    code, out, _ = run("compare", "net.qovr", "--window", "1,2")
    assert (code, out) == (0, f"window 1,2 of a net of 2 x 3 windows\n{comparison_text(comparison)}\n")
    facts = json.loads(run("compare", "net.qovr", "--window", "1,2", "--json")[1])
    assert facts == {"window": [1, 2], **json.loads(json.dumps(comparison_facts(comparison)))}
    assert run("compare", "net.qovr")[1].startswith("window 0,0 of a net of 2 x 3 windows\n")


def test_a_workbook_holds_one_window(run):
    code, out, err = run("export", "net.qovr", "a.xlsx")
    assert (code, out) == (2, "")
    assert err == (
        "qovr: a.xlsx: the published layout holds a net of 5 x 5 points, and this one has 2 x 3 windows; "
        "expected one of them, --window 0,0 to 1,2\n"
    )
    assert run("export", "net.qovr", "a.xlsx", "--window", "1,0")[0] == 0
    assert read_source("a.xlsx") == extract_window(NET, (1, 0))


@pytest.mark.parametrize("suffix", FORMATS)
def test_every_format_takes_a_window(suffix, run, tmp_path):
    assert run("export", "net.qovr", f"a{suffix}", "--window", "1,2")[0] == 0
    (tmp_path / "alone").mkdir()
    export(extract_window(NET, (1, 2)), tmp_path / "alone" / f"a{suffix}")
    assert (tmp_path / f"a{suffix}").read_bytes() == (tmp_path / "alone" / f"a{suffix}").read_bytes()


def test_samples_are_those_of_what_is_written(run):
    assert run("export", "net.qovr", "a.qovr", "--window", "0,1", "--samples", "7x5")[0] == 0
    assert read_source("a.qovr") == set_samples(extract_window(NET, (0, 1)), (7, 5))


@pytest.mark.parametrize(
    ("value", "text"),
    [
        ("2,0", "the window is 2,0; expected one of 0,0 to 1,2"),
        ("1", "'1' is no window; expected A,B, each counted from 0, as 1,0"),
        ("-1,0", "expected"),
    ],
)
@pytest.mark.parametrize("call", [("export", "net.qovr", "a.csv"), ("compare", "net.qovr")])
def test_a_window_that_is_not_there_is_refused(call, value, text, run):
    code, out, err = run(*call, f"--window={value}")
    assert (code, out) == (2, "")
    assert text in err
    assert err.count("\n") == 1
