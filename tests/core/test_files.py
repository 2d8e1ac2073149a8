"""Files read back, by this program and by others."""

import csv
import json
import re
from contextlib import closing

import numpy as np
import openpyxl
import pytest
from hypothesis import HealthCheck, given, settings
from openpyxl.utils import get_column_letter

from qovr_core import FileError, Formulation, SourceError, configure
from qovr_core.files import FORMATS, format_for, published_layout, read_source
from qovr_core.files.progress import silent
from qovr_core.files.qovr_document import document_from_json, document_to_json
from qovr_core.files.workbook_read import read_published_numbers, read_workbook
from qovr_core.presets import preset
from support.command import PUBLISHED
from support.documents import documents, random_document

WORKBOOKS = {
    "fig5": "QOVR_S_Ctrl_Pts_v0_all_intl_param_knots_05.xlsx",
    "fig6b": "QOVR_S_Ctrl_Pts_v0_all_intl_param_knots_03_05_05_07.xlsx",
    "fig8": "QOVR_S_Ctrl_Pts_v1_all_intl_param_knots_05.xlsx",
}


def published(name):
    path = PUBLISHED / WORKBOOKS[name]
    if not path.exists():
        pytest.skip("the published workbooks are not on this machine")
    return path


def export(surface, path):
    format_for(path).write(surface, path, silent)
    return path


@given(documents())
def test_a_document_reads_back_as_itself_to_the_last_bit(document):
    again = document_from_json(document_to_json(document))
    assert again == document
    assert again.control_points.tobytes() == document.control_points.tobytes()


@given(documents(samples=(3, 2)))
@settings(max_examples=10, suppress_health_check=[HealthCheck.function_scoped_fixture], deadline=None)
def test_a_workbook_reads_back(tmp_path, document):
    again = read_source(str(export(configure(document), tmp_path / "a.xlsx")))
    assert again.formulation == document.formulation
    assert again.samples == document.samples
    assert again.control_points == pytest.approx(document.control_points, rel=1e-15)
    assert again.row_knots.array == pytest.approx(document.row_knots.array, rel=1e-15)
    assert again.column_knots.array == pytest.approx(document.column_knots.array, rel=1e-15)


def cells(path):
    """Return what stands in the first sheet, by row and column, both counted from 1."""
    with closing(openpyxl.load_workbook(path, read_only=True)) as book:
        rows = book.worksheets[0].iter_rows(values_only=True)
        return {(i, j): value for i, row in enumerate(rows, 1) for j, value in enumerate(row, 1) if value is not None}


@pytest.mark.parametrize("name", WORKBOOKS)
def test_a_workbook_is_the_published_one_cell_for_cell(name, tmp_path):
    theirs = cells(published(name))
    ours = cells(export(configure(preset(name).document), tmp_path / "a.xlsx"))
    assert ours.keys() == theirs.keys()
    for place, value in theirs.items():
        if isinstance(value, str):
            assert ours[place] == value, place
        else:
            # The 5 decimals of AB:AD are those of numbers that agree within 1e-8, so a tie may fall either way.
            rounded = get_column_letter(place[1]) in ("AB", "AC", "AD")
            assert abs(ours[place] - value) <= (1.01e-5 if rounded else 1e-8), place


@pytest.mark.parametrize("name", WORKBOOKS)
def test_the_published_numbers_are_met(name):
    numbers = read_published_numbers(published(name))
    assert numbers.document == preset(name).document
    surface = configure(numbers.document)
    assert surface.raw == pytest.approx(numbers.raw, abs=1e-8)
    assert surface.raw_box == pytest.approx(numbers.raw_box, abs=1e-9)
    assert surface.control_box == pytest.approx(numbers.control_box, abs=1e-9)
    assert surface.matrix == pytest.approx(numbers.matrix, abs=1e-9)
    assert surface.transformed == pytest.approx(numbers.transformed, abs=5.1e-6)


def test_the_ranges_that_the_authors_scripts_read(tmp_path):
    document = random_document(11, formulation=preset("fig5").document.formulation, samples=(101, 101))
    surface = configure(document)
    sheet = openpyxl.load_workbook(export(surface, tmp_path / "a.xlsx")).worksheets[0]

    def numbers(cell_range):
        return np.array([[cell.value for cell in row] for row in sheet[cell_range]], dtype=float)

    assert numbers("E5:G29") == pytest.approx(document.control_points.reshape(-1, 3), rel=1e-15)
    assert numbers("N5:P10205") == pytest.approx(surface.raw.reshape(-1, 3), rel=1e-15)
    assert numbers("AB5:AD10205") == pytest.approx(surface.transformed.reshape(-1, 3), abs=5.1e-6)
    assert sheet["A1"].value is None
    assert sheet.max_row == 10205


def test_knot_tables_stand_as_the_net_lies_in_space(tmp_path):
    document = random_document(12)
    sheet = openpyxl.load_workbook(export(configure(document), tmp_path / "a.xlsx")).worksheets[0]
    assert [sheet[f"AF{row}"].value for row in range(5, 10)] == ["C_4", "C_3", "C_2", "C_1", "C_0"]
    assert [sheet[f"AL{row}"].value for row in range(5, 9)] == ["tip_K", "vip", "sip_K", "rip_K"]
    assert [sheet.cell(9, column).value for column in range(39, 44)] == ["K_0", "K_1", "K_2", "K_3", "K_4"]
    assert sheet["AG5"].value == pytest.approx(document.row_knots[4, 0].r)
    assert sheet["AJ9"].value == pytest.approx(document.row_knots[0, 0].t)
    assert sheet["AM5"].value == pytest.approx(document.column_knots[0, 0].t)
    assert sheet["AQ6"].value == pytest.approx(document.column_knots[4, 0].u)
    assert sheet["AO8"].value == pytest.approx(document.column_knots[2, 0].r)


def test_a_sheet_that_is_too_short_is_refused_before_any_work(tmp_path):
    assert published_layout.MOST_POINTS == 1_048_572
    target = format_for(tmp_path / "a.xlsx")
    target.check(random_document(1, samples=(1024, 1023)), tmp_path / "a.xlsx")
    with pytest.raises(FileError, match=r"1025 x 1024 samples are 1,049,600 points; expected at most 1,048,572"):
        target.check(random_document(1, samples=(1025, 1024)), tmp_path / "a.xlsx")


def test_csv_holds_every_point_exactly(tmp_path):
    surface = configure(random_document(13))
    path = export(surface, tmp_path / "net.csv")
    with path.open(newline="") as file:
        table = list(csv.DictReader(file))
    assert len(table) == 7 * 5
    for k, row in enumerate(table):
        i, j = divmod(k, 5)
        assert (int(row["i"]), int(row["j"])) == (i, j)
        assert (float(row["u"]), float(row["v"])) == (surface.u[i], surface.v[j])
        assert [float(row[f"raw_{axis}"]) for axis in "xyz"] == surface.raw[i, j].tolist()
        assert [float(row[f"transformed_{axis}"]) for axis in "xyz"] == surface.transformed[i, j].tolist()
    inputs = json.loads((tmp_path / "net.inputs.json").read_text())
    assert document_from_json(json.dumps(inputs["document"])) == surface.document
    assert inputs["matrix"] == surface.matrix.tolist()
    assert inputs["raw_box"] == surface.raw_box.tolist()
    assert inputs["control_box"] == surface.control_box.tolist()


def test_npz_holds_every_array_under_its_name(tmp_path):
    surface = configure(random_document(14))
    with np.load(export(surface, tmp_path / "a.npz"), allow_pickle=False) as arrays:
        shapes = {name: arrays[name].shape for name in arrays.files}
        assert shapes == {
            "control_points": (5, 5, 3),
            "row_knots": (5, 4),
            "column_knots": (5, 4),
            "u": (7,),
            "v": (5,),
            "raw": (7, 5, 3),
            "transformed": (7, 5, 3),
            "control_box": (3, 2),
            "raw_box": (3, 2),
            "matrix": (4, 4),
            "formulation": (),
            "program": (),
        }
        for name in ("u", "v", "raw", "transformed", "control_box", "raw_box", "matrix"):
            assert np.array_equal(arrays[name], getattr(surface, name))
        assert arrays["row_knots"][3].tolist() == list(surface.document.row_knots[3, 0])
        assert str(arrays["formulation"]) == "interpolating"


@pytest.mark.parametrize("suffix", FORMATS)
@pytest.mark.parametrize("when", [0.0, 0.6])
def test_a_cancelled_export_leaves_what_was_there(suffix, when, tmp_path):
    class Cancelled(Exception):
        pass

    def cancel(part):
        if part >= when:
            raise Cancelled

    path = tmp_path / f"a{suffix}"
    path.write_text("precious")
    with pytest.raises(Cancelled):
        FORMATS[suffix].write(configure(random_document(1)), path, cancel)
    if suffix != ".qovr":  # so small that it is whole before anyone can cancel
        assert path.read_text() == "precious"
    assert [entry.name for entry in tmp_path.iterdir()] == [path.name]


@pytest.mark.parametrize("suffix", FORMATS)
def test_progress_rises_to_the_end(suffix, tmp_path):
    parts = []
    FORMATS[suffix].write(configure(random_document(1, samples=(60, 60))), tmp_path / f"a{suffix}", parts.append)
    assert parts == sorted(parts)
    assert parts[-1] == 1.0


@pytest.mark.parametrize("name", ["a", "a.txt", "a.XLS"])
def test_unknown_suffixes(name, tmp_path):
    with pytest.raises(SourceError, match=re.escape(f"expected one of {', '.join(FORMATS)}")):
        format_for(tmp_path / name)
    with pytest.raises(SourceError, match="is no source"):
        read_source(str(tmp_path / name))


def test_suffixes_in_capitals(tmp_path):
    path = export(configure(random_document(1)), tmp_path / "A.XLSX")
    assert read_source(str(path)).samples == (7, 5)


def test_a_foreign_workbook_is_square_and_published(tmp_path):
    """As the published ones are: no record of formulation or samples."""
    path = export(configure(random_document(1, samples=(6, 6))), tmp_path / "a.xlsx")
    book = openpyxl.load_workbook(path)
    del book[published_layout.RECORD_SHEET]
    book.save(path)
    document = read_workbook(path)
    assert document.samples == (6, 6)
    assert document.formulation is Formulation.PUBLISHED


def test_the_points_of_a_foreign_workbook_tell_their_grid(tmp_path):
    path = export(configure(random_document(1)), tmp_path / "a.xlsx")
    book = openpyxl.load_workbook(path)
    del book[published_layout.RECORD_SHEET]
    book.save(path)
    assert read_workbook(path).samples == (7, 5)


def test_points_on_no_grid_of_the_surface(tmp_path):
    path = export(configure(random_document(1)), tmp_path / "a.xlsx")
    book = openpyxl.load_workbook(path)
    del book[published_layout.RECORD_SHEET]
    book.worksheets[0]["N6"].value += 0.1
    book.save(path)
    with pytest.raises(FileError, match="35 points long; expected a square number"):
        read_workbook(path)
