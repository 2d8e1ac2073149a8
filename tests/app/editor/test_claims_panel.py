"""The panel of claims: current for the document, in nobody's way, and a door to the counterexamples."""

import re

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QLabel, QMenu, QTextBrowser

from qovr_app.laboratory.claims_cells import BLOCKS, IS_OLD
from qovr_app.laboratory.claims_panel import ClaimsPanel
from qovr_app.laboratory.claims_table import ClaimsTable, marked_verdict
from qovr_app.state.intents import PointsMoved
from qovr_app.work.quiet import QUIET_MILLISECONDS
from qovr_app.work.worker import Worker
from qovr_core import FORMULATIONS, Formulation
from qovr_core.laboratory.claims import CLAIMS
from qovr_core.laboratory.verify import Ground, verify
from support.verdicts import HERE


@pytest.fixture
def found(monkeypatch):
    """The findings that the worker has told, each of which its process has just decided."""
    told = []
    run = Worker.run

    def counted(worker, function, *values, on_progress=None, **options):
        def count(finding):
            told.append(finding)
            on_progress(finding)

        return run(worker, function, *values, on_progress=count if function is verify else on_progress, **options)

    monkeypatch.setattr(Worker, "run", counted)
    return told


@pytest.fixture
def lab(editor, found):
    editor.trigger("laboratory_claims")
    return editor


def panel(lab):
    return lab.find("laboratory.claims", ClaimsPanel)


def table(lab):
    return lab.find("laboratory.claims.table", ClaimsTable)


def state(lab):
    return lab.find("laboratory.claims.state", QLabel).text()


def select(lab, claim, formulation):
    row = list(CLAIMS).index(claim)
    table(lab).setCurrentCell(row, 1 + list(FORMULATIONS.values()).index(formulation))
    lab.settle()


def shown(lab):
    """Return what every cell says, by claim and formulation."""
    return {
        (claim.name, formulation): table(lab).item(row, column).data(Qt.ItemDataRole.AccessibleTextRole)
        for row, claim in enumerate(CLAIMS.values())
        for column, formulation in enumerate(FORMULATIONS.values(), start=1)
    }


def edit(lab, value):
    """Move a point, as a drag in the view does it."""
    z = lab.document.control_points[2, 2, 2]
    lab.window.store.dispatch(PointsMoved(((2, 2),), ((0.0, 0.0, value - z),)))


def turns_until_shown(lab):
    """Count the turns of the event loop from now until the window has the document's surface."""
    for turn in range(1, 20):
        QApplication.processEvents()
        if lab.window.store.shown.evaluation.document == lab.document:
            return turn
    raise AssertionError("the edit is not shown")


def test_every_verdict_is_shown_with_its_mark_and_how_it_is_here(lab, spin):
    spin(lambda: panel(lab).is_current)
    cells = shown(lab)
    for finding in verify(lab.document):
        spoken = cells[finding.claim.name, finding.formulation]
        assert f": {finding.words}" in spoken
        assert f"here: {HERE[finding.verdict, finding.here.holds]}, " in spoken
        item = table(lab).item(
            list(CLAIMS).index(finding.claim.name), 1 + list(FORMULATIONS.values()).index(finding.formulation)
        )
        first, *between, last = (text for text, _style in item.data(BLOCKS))
        assert first == marked_verdict(finding)
        assert first.split(" ", 1)[1] == finding.words
        assert (finding.ground in between) == (finding.ground in (Ground.PROVED, Ground.DOCUMENT))
        assert last.startswith(f"here: {HERE[finding.verdict, finding.here.holds]}, ")
    assert state(lab) == "Every claim is decided"
    QTest.keyClick(table(lab), Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    head, *lines = (line.split("\t") for line in QApplication.clipboard().text().splitlines())
    assert head == ["claim", *map(str, FORMULATIONS)]
    assert len(lines) == len(CLAIMS)
    assert all(verdict.split()[0].rstrip(",;") in {"true", "false", "not"} for line in lines for verdict in line[1:])
    assert all(not line[0][0].islower() and ". (" in line[0] for line in lines)


def test_what_is_written_is_seen_whole_in_a_small_window(make_editor, spin):
    editor = make_editor(size=(1280, 720))
    editor.trigger("laboratory_claims")
    spin(lambda: panel(editor).is_current)
    claims = table(editor)
    assert claims.horizontalScrollBar().maximum() == 0
    for row in range(claims.rowCount()):
        for column in range(claims.columnCount()):
            cell = claims.visualItemRect(claims.item(row, column))
            height = 0
            for text, _style in claims.item(row, column).data(BLOCKS):
                metrics = claims.fontMetrics()  # that of the largest of the fonts, but for the bold words
                longest = max(map(metrics.horizontalAdvance, text.split()))
                assert longest < cell.width(), text
                height += metrics.height() * 0.8
            assert height <= cell.height()


def test_rows_sort_by_a_click_on_a_heading_and_come_back(lab, spin):
    spin(lambda: panel(lab).is_current)
    claims, column = table(lab), 1 + list(FORMULATIONS.values()).index(Formulation.INTERPOLATING)
    worth = {"false": 0, "true if": 1, "true": 2}

    def click():
        header = claims.horizontalHeader()
        x = header.sectionViewportPosition(column) + 30
        QTest.mouseClick(header.viewport(), Qt.MouseButton.LeftButton, pos=QPoint(x, header.height() // 2))
        lab.settle()
        rows = sorted(range(claims.rowCount()), key=lambda row: claims.visualItemRect(claims.item(row, 0)).top())
        return rows, [worth[str(claims.item(row, column).data(Qt.ItemDataRole.UserRole + 2).verdict)] for row in rows]

    rows, found = click()
    assert found == sorted(found)
    assert len(set(found)) > 1
    copied = [line.split("\t")[0] for line in copy(claims).splitlines()[1:]]
    assert copied[0].startswith(table(lab).item(rows[0], 0).data(BLOCKS)[0][0])
    _, found = click()
    assert found == sorted(found, reverse=True)
    rows, _ = click()
    assert rows == list(range(len(CLAIMS)))


def test_a_table_goes_to_latex(lab, spin):
    spin(lambda: panel(lab).is_current)
    QTest.keyClick(table(lab), Qt.Key.Key_L, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier)
    text = QApplication.clipboard().text()
    center = table(lab).viewport().rect().center()
    QApplication.sendEvent(
        table(lab).viewport(), QContextMenuEvent(QContextMenuEvent.Reason.Mouse, center, table(lab).mapToGlobal(center))
    )
    (menu,) = table(lab).findChildren(QMenu)
    QApplication.clipboard().clear()
    next(action for action in menu.actions() if "LaTeX" in action.text()).trigger()
    menu.close()
    assert QApplication.clipboard().text() == text
    begin, head, rule, *lines, end, _ = text.split("\n")
    assert (begin, rule, end) == (r"\begin{tabular}{llll}", r"\hline", r"\end{tabular}")
    assert head == "claim & " + " & ".join(map(str, FORMULATIONS)) + r" \\"
    assert len(lines) == len(CLAIMS)
    for line in lines:
        assert line.endswith(r" \\")
        cells = re.split(r"(?<!\\)&", line.removesuffix(r"\\"))
        assert len(cells) == 4
        bare = re.sub(r"\\[a-z]+\{\}|\\[&%$#_{}]|\$[^$]*\$", "", line.removesuffix(r"\\"))
        assert not set(bare) & set("&%$#_{}\\^~") - {"&"}
    assert any(r"$2 \times 10^{-16}$" in line for line in lines)


def copy(claims):
    QTest.keyClick(claims, Qt.Key.Key_C, Qt.KeyboardModifier.ControlModifier)
    return QApplication.clipboard().text()


def test_an_edit_during_the_search_stops_it_and_is_shown_as_soon_as_ever(lab, spin, found):
    spin(lambda: panel(lab).is_current)
    edit(lab, 0.71)
    undisturbed = turns_until_shown(lab)
    for value in (0.72, 0.73, 0.74):
        before = len(found)
        spin(lambda before=before: len(found) > before + 5)
        assert not panel(lab).is_current
        edit(lab, value)
        assert turns_until_shown(lab) <= undisturbed
        lab.settle()
        stopped = len(found)
        spin(QUIET_MILLISECONDS // 3)
        assert len(found) == stopped
        assert "grey" in state(lab)
    spin(lambda: panel(lab).is_current)
    findings = {(finding.claim.name, finding.formulation): finding for finding in verify(lab.document)}
    for key, spoken in shown(lab).items():
        assert f"here: {HERE[findings[key].verdict, findings[key].here.holds]}, " in spoken


def test_old_verdicts_look_old_until_new_ones_come(lab, spin):
    spin(lambda: panel(lab).is_current)
    edit(lab, 0.75)
    lab.settle()
    is_old = [table(lab).item(row, 1).data(IS_OLD) for row in range(len(CLAIMS))]
    assert all(is_old)
    spin(lambda: panel(lab).is_current)
    assert not any(table(lab).item(row, 1).data(IS_OLD) for row in range(len(CLAIMS)))


def test_another_formulation_or_sample_count_changes_no_verdict(lab, spin, found):
    spin(lambda: panel(lab).is_current)
    taken = len(found)
    lab.choose("surface.formulation", "interpolating")
    lab.type_into("surface.samples_u", "31")
    spin(2 * QUIET_MILLISECONDS)
    assert len(found) == taken
    assert panel(lab).is_current
    assert table(lab).horizontalHeaderItem(3).font().bold()
    assert not table(lab).horizontalHeaderItem(1).font().bold()


def test_a_hidden_panel_does_nothing_and_goes_on_when_it_is_shown(lab, spin, found):
    spin(lambda: len(found) > 5)
    lab.trigger("laboratory_claims")
    taken = len(found)
    spin(2 * QUIET_MILLISECONDS)
    assert len(found) == taken
    lab.trigger("laboratory_claims")
    spin(lambda: panel(lab).is_current)


def test_a_counterexample_opens_as_a_document_of_its_own(lab, spin):
    spin(lambda: panel(lab).is_current)
    select(lab, "unity", Formulation.PUBLISHED)
    assert "refute" not in lab.find("laboratory.claims.details", QTextBrowser).toPlainText()
    assert lab.find("laboratory.claims.counterexample", QAbstractButton).isHidden()
    select(lab, "inverse", Formulation.PUBLISHED)
    finding = table(lab).current_finding()
    assert finding.here.holds
    assert (
        "does not refute it, but another one does" in lab.find("laboratory.claims.details", QTextBrowser).toPlainText()
    )
    lab.click("laboratory.claims.counterexample")
    assert lab.document == finding.counterexample
    assert lab.window.windowTitle().startswith("Counterexample to inverse, published")
    spin(lambda: panel(lab).is_current)
    assert not table(lab).current_finding().here.holds
    assert "This document refutes it" in lab.find("laboratory.claims.details", QTextBrowser).toPlainText()


def test_everything_can_be_done_by_keyboard(lab, spin):
    spin(lambda: panel(lab).is_current)
    table(lab).setFocus()
    select(lab, "G1", Formulation.INTERPOLATING)
    lab.key(Qt.Key.Key_Return, widget=table(lab))
    assert "the claim is proved" in lab.message()
    lab.key(Qt.Key.Key_Down, widget=table(lab))
    finding = table(lab).current_finding()
    assert (finding.claim.name, finding.formulation) == ("C2", Formulation.INTERPOLATING)
    lab.key(Qt.Key.Key_Return, widget=table(lab))
    assert lab.document == finding.example
    assert lab.window.windowTitle().startswith("Example to C2, interpolating")


def test_a_claim_s_own_cell_stands_for_the_document_s_formulation(lab, spin):
    spin(lambda: panel(lab).is_current)
    table(lab).setCurrentCell(6, 0)
    assert table(lab).current_finding().formulation is Formulation.PUBLISHED
    text = lab.find("laboratory.claims.details", QTextBrowser).toPlainText()
    assert text.startswith("Neighbouring patches meet without a gap. C0, Lemma 1, (45).")
    assert "For published: ✗ false.\nBy counterexample." in text
    table(lab).setCurrentCell(6, 3)
    text = lab.find("laboratory.claims.details", QTextBrowser).toPlainText()
    assert "For interpolating: ✓ true.\nProved in exact arithmetic: both sides are the same curve" in text
    select(lab, "C2", Formulation.PUBLISHED)
    assert re.search(
        r"For published: ○ not refuted by \d+ trials\.\n(?!Proved)",
        lab.find("laboratory.claims.details", QTextBrowser).toPlainText(),
    )


def test_the_worst_joint_of_a_net_is_named_and_shown(make_editor, spin):
    editor = make_editor("shape:folded-saddle")
    editor.trigger("laboratory_claims")
    spin(lambda: panel(editor).is_current)
    assert state(editor) == "Every claim is decided: about neighbours at every joint, others on window (0, 0)"
    select(editor, "G1", Formulation.INTERPOLATING)
    place = table(editor).current_finding().here.place
    assert f"largest at the {place}" in editor.find("laboratory.claims.details", QTextBrowser).toPlainText()
    editor.click("laboratory.claims.place")
    shown = editor.window.store.state
    assert shown.window == place.window != (0, 0)
    assert shown.selection.points == {place.nearest_point}
    assert "window in focus" in state(editor)
    spin(lambda: panel(editor).is_current)
    assert state(editor).endswith("others on window ({}, {})".format(*place.window))
    select(editor, "unity", Formulation.INTERPOLATING)
    assert editor.find("laboratory.claims.place", QAbstractButton).isHidden()
