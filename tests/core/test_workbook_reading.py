"""Workbooks of other programs, large ones, and those that want to be larger than they are."""

import subprocess
import sys
import zipfile

import openpyxl
import pytest
import xlsxwriter

from qovr_core import FORMULATIONS, FileError, Formulation, configure
from qovr_core.files import format_for, published_layout, read_source
from qovr_core.files.progress import silent
from qovr_core.files.workbook_read import read_published_numbers
from support.documents import random_document
from support.zips import pack, parts_of, with_parts

DOCUMENT = random_document(3, samples=(9, 4))


@pytest.fixture
def whole(tmp_path):
    return written(tmp_path / "whole.xlsx", DOCUMENT)


def written(path, document):
    format_for(path).write(configure(document), path, silent)
    return path


def changed(path, change):
    book = openpyxl.load_workbook(path)
    change(book)
    book.save(path)
    return path


def refusal(path, read=lambda path: read_source(str(path))):
    with pytest.raises(FileError) as caught:
        read(path)
    text = str(caught.value)
    assert text.startswith(f"{path}: ")
    assert text.isprintable()
    assert len(text) <= 300
    return text


# --- what other programs write ----------------------------------------------------------------------------------------


@pytest.mark.parametrize("place", [0, 1, 2])
def test_the_sheet_with_the_layout_is_found_wherever_it_stands(whole, place):
    changed(whole, lambda book: book.create_sheet("Notes", place).append(["hello", 1, 2]))
    changed(whole, lambda book: book.move_sheet("Document", -2))
    assert read_source(str(whole)) == DOCUMENT
    assert read_published_numbers(whole).raw == pytest.approx(configure(DOCUMENT).raw, rel=1e-14)


@pytest.mark.parametrize("samples", [(9, 4), (4, 9), (2, 18), (36, 2), (6, 6), (41, 31)])
@pytest.mark.parametrize("formulation", FORMULATIONS.values(), ids=str)
def test_without_its_own_sheet_the_points_tell_the_samples(tmp_path, samples, formulation):
    path = written(tmp_path / "a.xlsx", random_document(3, formulation, samples))
    document = read_source(str(changed(path, lambda book: book.remove(book["Document"]))))
    assert document.samples == samples
    assert document.formulation is Formulation.PUBLISHED


def test_more_points_than_are_looked_at_tell_their_samples_too(tmp_path):
    path = written(tmp_path / "a.xlsx", random_document(3, samples=(70, 71)))
    parts = parts_of(path)
    pack(path, {name: text.replace(b'name="Document"', b'name="Other"') for name, text in parts.items()})
    assert read_source(str(path)).samples == (70, 71)


def test_blank_cells_that_are_written_are_empty(whole):
    """As pandas writes a whole rectangle."""

    def fill(book):
        sheet = book.worksheets[0]
        for row in sheet.iter_rows(1, 60, 1, 50):
            for cell in row:
                if cell.value is None:
                    cell.value = ""

    changed(whole, fill)
    assert b'r="A1" t="inlineStr"' in parts_of(whole)["xl/worksheets/sheet1.xml"]
    assert read_source(str(whole)) == DOCUMENT


def test_texts_that_cells_share_are_read(tmp_path, whole):
    """As Excel writes all texts."""
    book, source = xlsxwriter.Workbook(tmp_path / "b.xlsx"), openpyxl.load_workbook(whole)
    for sheet in source:
        copy = book.add_worksheet(sheet.title)
        for row in sheet.iter_rows():
            for cell in row:
                copy.write(cell.row - 1, cell.column - 1, cell.value)
    book.close()
    assert "xl/sharedStrings.xml" in parts_of(tmp_path / "b.xlsx")
    assert read_source(str(tmp_path / "b.xlsx")) == DOCUMENT


def test_numbers_of_formulas_count(whole):
    def sheet(content):
        return content.replace(b'<c r="E5"><v>', b'<c r="E5"><f>1+1</f><v>').replace(
            b'<c r="N40"><v>', b'<c r="N40"><f/><v>'
        )

    assert read_source(str(with_parts(whole, whole, sheet1=sheet))) == DOCUMENT


def test_other_ways_to_write_the_same_xml(whole):
    """A prefix, other quotes, no references, spaces between the tags, another encoding."""
    content = parts_of(whole)["xl/worksheets/sheet1.xml"].decode()
    tags = ("worksheet", "sheetData", "row", "c", "v", "is", "t")
    for tag in tags:
        content = (
            content.replace(f"<{tag} ", f"<x:{tag} ")
            .replace(f"<{tag}>", f"<x:{tag}>")
            .replace(f"</{tag}>", f"</x:{tag}>")
        )
    content = content.replace("xmlns=", "xmlns:x=").replace('"', "'").replace("</x:row>", "\n</x:row >")
    content = content.replace("UTF-8", "UTF-16").replace("<x:row", "\n<x:row")
    with_parts(whole, whole, sheet1=lambda _: content.encode("utf-16"))
    assert read_source(str(whole)) == DOCUMENT
    assert read_published_numbers(whole).raw == pytest.approx(configure(DOCUMENT).raw, rel=1e-14)


@pytest.mark.parametrize(
    ("cell", "value", "message"),
    [
        ("G17", "=1/0", "G17 is empty; expected a finite number"),
        ("G17", "#DIV/0!", "G17 is #DIV/0!; expected a finite number"),
        ("AI6", "#N/A", "AI6 is #N/A; expected a number strictly between"),
        ("G17", "12,5", "G17 is '12,5'; expected a finite number"),
        ("G17", True, "G17 is True; expected"),
        ("G17", 1e13, "G17 is 10000000000000.0; expected"),
        ("D7", 9, "D7 is 9.0; expected the index 2"),
        ("G17", "x" * 30_000, "G17 is 'xxxx"),
        ("G17", "a\nb\u202ec", r"G17 is 'a\nb\u202ec'; expected"),
    ],
)
def test_what_stands_in_a_cell_is_called_that(whole, cell, value, message):
    changed(whole, lambda book: book.worksheets[0].__setitem__(cell, value))
    assert f"QOVR surface!{message}" in refusal(whole)


@pytest.mark.parametrize("cell", ["N6", "AD40", "P5"])
def test_a_point_that_is_none_is_named(whole, cell):
    for value, found in ((None, "empty"), ("#REF!", "#REF!"), ("x", "'x'"), (2e12, "2000000000000.0")):
        changed(whole, lambda book, value=value: book.worksheets[0][cell].__setattr__("value", value))
        assert f"QOVR surface!{cell} is {found}; expected a finite number" in refusal(whole, read_published_numbers)


def test_the_name_of_a_sheet_stays_one_line(whole):
    def rename(content):
        return content.replace(b'name="QOVR surface"', b'name="' + b"a&#10;b" * 200 + b'"')

    with_parts(whole, whole, workbook=rename)
    changed_cell = with_parts(whole, whole, sheet1=lambda content: content.replace(b'<c r="E5">', b'<c r="E5" t="e">'))
    assert r"a\nba\nb" in refusal(changed_cell)


# --- what is bounded --------------------------------------------------------------------------------------------------

LIMITED = """
import resource, sys, time
from pathlib import Path
import numpy, qovr_core.files.workbook_read as workbooks, qovr_core.files.sources as sources
from qovr_core import FileError
used = int(Path('/proc/self/statm').read_text().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (used + int(sys.argv[2]) * 10**6,) * 2)
began = time.process_time()
try:
    print(sources.read_source(sys.argv[1]).samples)
except FileError as error:
    print(error)
print(time.process_time() - began)
"""


def read_limited(path, megabytes):
    """Return what reading says, and its seconds, in a process that gets no more memory than that."""
    call = [sys.executable, "-c", LIMITED, str(path), str(megabytes)]
    done = subprocess.run(call, capture_output=True, text=True, check=False, timeout=120)
    assert done.stderr == ""
    said, seconds = done.stdout.splitlines()
    return said, float(seconds)


on_linux = pytest.mark.skipif(sys.platform != "linux", reason="memory is limited as Linux does")


@on_linux
@pytest.mark.parametrize("cell", ["XFD1048576", "N1048576", "XFD1"])
def test_a_cell_far_away_takes_no_room(whole, cell, tmp_path):
    book = xlsxwriter.Workbook(tmp_path / "b.xlsx")
    sheet = book.add_worksheet("S")
    sheet.write("A1", 1)
    sheet.write(cell, 1)
    book.close()
    assert "S!C5 is empty; expected the index 0" in read_limited(tmp_path / "b.xlsx", 100)[0]
    changed(whole, lambda book: book.worksheets[0].__setitem__(cell, 1))
    assert read_source(str(whole)) == DOCUMENT


@on_linux
def test_a_large_workbook_is_read_in_little_memory(tmp_path, whole):
    """As many rows as a sheet has, but for the head all alike, so that it is soon made."""
    rows = b"".join(
        b'<row r="%d"><c r="M%d"><v>1</v></c><c r="N%d"><v>0.12345678901234</v></c><c r="O%d"><v>2.5</v></c>'
        b'<c r="P%d"><v>1E-05</v></c><c r="AA%d"><v>1</v></c><c r="AB%d"><v>0.5</v></c><c r="AC%d"><v>1</v></c>'
        b'<c r="AD%d"><v>2</v></c></row>' % ((row,) * 9)
        for row in range(41, 250_005)
    )
    path = tmp_path / "large.xlsx"
    with zipfile.ZipFile(path, "w", zipfile.ZIP_DEFLATED, compresslevel=1) as archive:
        for name, part in parts_of(whole).items():
            longer = part.replace(b"</sheetData>", rows + b"</sheetData>") if name.endswith("sheet1.xml") else part
            archive.writestr(name, longer.replace(b'name="Document"', b'name="Other"'))
    said, seconds = read_limited(path, 100)
    assert said == "(500, 500)"
    assert seconds < 5
    numbers = read_published_numbers(path)
    assert numbers.raw.shape == (500, 500, 3)
    assert numbers.raw[-1, -1].tolist() == [0.12345678901234, 2.5, 1e-5]


HUGE = 120_000_000

BOMBS = {
    "a tag": b'<c r="E5" x="' + b"x" * HUGE,
    "a tag with its own signs": b'<c r="E5" x="' + b">" * HUGE,
    "a comment": b"<!--" + b">" * HUGE,
    "a text": b'<c r="E5" t="inlineStr"><is><t>' + b"x" * HUGE,
    "spaces": b" " * HUGE,
    "tags inside one another": b"<a>" * (HUGE // 30),
    "an entity": b"",
}


@on_linux
@pytest.mark.parametrize(("part", "name"), [*(("sheet1", name) for name in BOMBS), ("workbook", "a tag")])
def test_what_unpacks_to_far_more_is_bounded(name, part, whole):
    def bomb(content):
        if name == "an entity":
            laughs = b"".join(b'<!ENTITY l%d "%s">' % (k + 1, b"&l%d;" % k * 10) for k in range(9))
            return b'<!DOCTYPE x [<!ENTITY l0 "ha">' + laughs + b"]><x>&l9;</x>"
        head, tag, rest = content.partition(b"<sheetData>" if part == "sheet1" else b"<sheets>")
        return head + tag + BOMBS[name] + rest

    said, seconds = read_limited(with_parts(whole, whole, **{part: bomb}), 100)
    assert said.startswith(f"{whole}: is no whole Excel workbook: ") or said == "(9, 4)"
    assert len(said) <= 300
    assert seconds < 10


def test_tags_of_ever_new_names_are_refused(whole):
    names = b"".join(b"<a%d/>" % k for k in range(200_000))
    with_parts(whole, whole, sheet1=lambda content: content.replace(b"<sheetData>", b"<sheetData>" + names))
    assert "names of tags" in refusal(whole)


def test_a_directory_that_claims_too_much_is_refused(whole):
    content = bytearray(whole.read_bytes())
    end = content.rindex(b"PK\5\6")
    content[end + 12 : end + 16] = (0x7FFFFFFF).to_bytes(4, "little")
    whole.write_bytes(content)
    assert "is no whole Excel workbook: " in refusal(whole)


def test_a_part_that_is_longer_than_it_says_is_refused(whole):
    content = bytearray(whole.read_bytes())
    for place in (k for k in range(len(content)) if content[k : k + 4] == b"PK\1\2"):
        content[place + 24 : place + 28] = (100).to_bytes(4, "little")
    whole.write_bytes(content)
    assert "is no whole Excel workbook: " in refusal(whole)


@pytest.mark.parametrize("method", [zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_other_packings_are_refused(whole, method):
    pack(whole, parts_of(whole), method)
    assert "packed in a way that is not read" in refusal(whole)


def test_an_encrypted_workbook_or_an_old_one_is_named(tmp_path):
    (tmp_path / "a.xlsx").write_bytes(b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1" + b"\0" * 2000)
    assert "behind a password" in refusal(tmp_path / "a.xlsx")


def test_rows_beyond_the_last_are_refused(whole):
    last = published_layout.LAST_ROW_OF_A_SHEET
    for row in (last + 1, 10**8, 10**15):
        text = b'<row r="%d"><c r="N%d"><v>1</v></c></row></sheetData>' % (row, row)
        with_parts(
            whole.with_name("b.xlsx"), whole, sheet1=lambda content, text=text: content.replace(b"</sheetData>", text)
        )
        assert "is no row" in refusal(whole.with_name("b.xlsx"))
