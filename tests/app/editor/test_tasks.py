"""What users come to do, done by real events and counted: as many clicks and keys as `.github/TASKS.md` says."""

import re
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QDialogButtonBox, QFileDialog, QToolButton

from gestures.gesture import GestureHand
from qovr_core.presets import preset
from support.editor import wait_until
from support.hand import CONTROL, LEFT

TABLE = Path(__file__).parents[3] / ".github" / "TASKS.md"


class Worker(GestureHand):
    """A hand that also uses menus, fields and dialogs, and counts what it presses."""

    def click_on(self, widget, at=None):
        self.presses += 1
        QTest.mouseClick(widget, LEFT, pos=widget.rect().center() if at is None else at)
        self.editor.settle()

    def choose(self, *titles):
        """Click through menus from the menu bar by what stands there."""
        menu = self.editor.window.menuBar()
        for title in titles:
            (action,) = (each for each in menu.actions() if each.text().replace("&", "") == title)
            self.click_on(menu, menu.actionGeometry(action).center())
            menu = action.menu()
            if menu is not None:
                wait_until(menu.isVisible)


def counted(task):
    """Return how many clicks and keys the table says that a task takes now."""
    (row,) = (line for line in TABLE.read_text(encoding="utf-8").splitlines() if line.startswith(f"| {task} |"))
    return int(re.match(r"\d+", row.split("|")[3].strip())[0])


@pytest.fixture
def worker(editor):
    editor.window.activateWindow()
    wait_until(editor.window.isActiveWindow)
    made = Worker(editor)
    yield made
    while (popup := QApplication.activePopupWidget()) is not None:
        popup.close()


def test_raise_the_bump_by_exactly_a_tenth(worker):
    before = worker.net
    worker.click(worker.place(2, 2))
    worker.press(worker.arrow(2))
    worker.move_by(0, -12)
    worker.type("0.1")
    worker.release()
    moved = (worker.net - before).round(12)
    assert np.argwhere(moved).tolist() == [[2, 2, 2]]
    assert moved[2, 2, 2] == 0.1
    assert worker.presses == counted("Raise the bump by exactly 0.1")


def test_make_it_symmetric(worker):
    worker.drag(worker.place(0, 1), 0, -40)
    worker.presses = 0
    worker.choose("Points", "Make symmetric", "Across columns, from the first side")
    z = worker.net[..., 2]
    np.testing.assert_array_equal(z, z[:, ::-1])
    assert z[0, 1] > 0.4
    assert worker.presses == counted("Make it symmetric")


def test_set_all_t_to_0_6_and_compare(worker):
    worker.tap(Qt.Key.Key_R, CONTROL)
    worker.click_on(worker.editor.field("row_knots.C_4.t"))
    worker.type("0.6")
    worker.tap(Qt.Key.Key_Return)
    assert {knots.t for knots in worker.editor.document.row_knots.in_window(0)} == {0.6}
    assert worker.state.reference is not None
    (button,) = (each for each in worker.editor.window.findChildren(QToolButton) if each.text() == "Colour by")
    action = worker.editor.action("colour_by_distance")
    assert action in button.menu().actions()
    button.menu().popup(button.mapToGlobal(button.rect().bottomLeft()))
    worker.presses += 1
    worker.click_on(button.menu(), button.menu().actionGeometry(action).center())
    assert worker.state.display.colour_by == "distance"
    assert worker.presses == counted("Set all t_ip to 0.6 and compare")


def test_open_25_points_from_a_sheet(worker):
    points = np.random.default_rng(0).random((25, 3)).round(3)
    sheet = "\n".join("\t".join(map(repr, row)) for row in points.tolist())
    QGuiApplication.clipboard().setText(sheet)
    worker.viewport.setFocus()
    worker.tap(Qt.Key.Key_V, CONTROL)
    np.testing.assert_array_equal(worker.net.reshape(25, 3), points)
    assert worker.steps == [worker.state.history.undo_text]
    assert worker.presses == counted("Open my 25 points from a sheet")
    worker.tap(Qt.Key.Key_Z, CONTROL)
    assert worker.editor.document == preset("fig5").document


def test_a_figure_for_a_column_of_85_mm(worker, home, monkeypatch):
    path = home / "column.pdf"

    def typed(*_arguments):
        worker.presses += len("column.pdf") + 1  # in the system's own dialog, and Enter
        return str(path), ""

    monkeypatch.setattr(QFileDialog, "getSaveFileName", typed)
    worker.click_on(worker.editor.find("surface.figure"))
    dialog = worker.editor.dialog("figure")
    dialog.activateWindow()
    wait_until(lambda: QApplication.focusWidget() is dialog.findChild(QComboBox, "figure.size"))
    worker.type("o")
    worker.click_on(dialog.findChild(QDialogButtonBox).button(QDialogButtonBox.StandardButton.Save))
    wait_until(lambda: "Wrote" in worker.editor.message(), 60)
    (width,) = set(re.findall(rb"/MediaBox\s*\[\s*0 0 ([\d.]+)", path.read_bytes()))
    assert float(width) * 25.4 / 72 == pytest.approx(85, abs=0.2)
    assert worker.presses == counted("A figure for a column of 85 mm")
