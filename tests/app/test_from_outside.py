"""A formulation, a field, a format and a panel that the program does not know: one record each, and all else follows.

They are registered by a module of somebody else's, in a process of its own that uses the program as it is installed.
"""

import json
import os
import subprocess
import sys

import numpy as np
import pytest

PLUGIN = '''
"""What somebody adds to the program."""

import numpy as np
from PySide6.QtWidgets import QLabel, QVBoxLayout

from qovr_app.laboratory.panel import LaboratoryPanel
from qovr_app.laboratory.panels import PANELS, PanelRecord
from qovr_core import Formulation, Layer
from qovr_core.fields import FIELDS, Field
from qovr_core.files.atomic import replacing
from qovr_core.files.format import Format
from qovr_core.files.formats import FORMATS
from qovr_core.formulations import FORMULATIONS
from qovr_core.geometry.weights import weight_coefficients


def mean_product(net, row_knots, column_knots):
    """The tensor product of the mean knots' weights; its slope is not told."""
    along_u = weight_coefficients(row_knots.mean(axis=-2))
    along_v = weight_coefficients(column_knots.mean(axis=-2))
    return np.einsum("...aj,...bi,...ijd->...abd", along_u, along_v, net)


def write_points(evaluation, path, progress, options):
    with replacing(path) as (draft,):
        np.savetxt(draft, options.chosen_samples(evaluation).reshape(-1, 3))
    progress(1.0)


class Lengths(LaboratoryPanel):
    def __init__(self, store, worker):
        super().__init__(store, worker)
        self.label = QLabel(self)
        self.label.setObjectName("lengths.text")
        QVBoxLayout(self).addWidget(self.label)

    def show_state(self, before, after):
        if after.differs(before, "evaluation"):
            self.label.setText(f"{after.document.net_size:.6f}")


FORMULATIONS.register(
    Formulation("mean-product", "The tensor product with the mean knots.", mean_product, resting_layer=Layer.RAW)
)
FIELDS.register(
    Field("depth", "Depth below 0", "d", "&Depth", "Colours say how deep the surface lies",
          lambda surface, u, v, _: -surface.points(u, v)[..., 2])
)
FORMATS.register(
    Format(suffix=".pts", name="Points", keeps="the points", loses="all else", writer=write_points,
           holds_one_layer=True)
)
PANELS.register(PanelRecord("lengths", "Len&gths", "How long the net is", Lengths))
'''

COMMANDS = """
import plugin
from qovr_core import cli

for call in (
    ["export", "paper:fig6d", "a.pts", "a.step", "a.npz", "a.qovr", "--formulation", "mean-product"],
    ["info", "a.qovr", "--json"],
    ["verify", "a.qovr", "--markdown"],
    ["reproduce", "--help"],
    ["export", "--help"],
):
    try:
        assert cli.main(call) == 0, call
    except SystemExit as ended:
        assert ended.code == 0, call
"""

WINDOW = """
import sys, time
from pathlib import Path
import plugin
from PySide6.QtCore import Qt
from PySide6.QtGui import QAction
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QComboBox, QLabel, QLineEdit, QTreeWidget
from qovr_app.main import create_window
from qovr_app.window.application import make_application

application = make_application(["outside"])
window = create_window("paper:fig6d")
window.resize(1280, 800)
window.show()
window.activateWindow()
QTest.qWaitForWindowActive(window)

def settle(happened=lambda: True, seconds=60):
    end = time.monotonic() + seconds
    while True:
        QTest.qWait(20)
        if happened():
            return
        assert time.monotonic() < end, "it did not happen in time"

def find(name, kind):
    (found,) = window.findChildren(kind, name)
    return found

settle()
box = find("surface.formulation", QComboBox)
assert [box.itemText(k) for k in range(box.count())][-1] == "mean-product"
box.setCurrentText("mean-product")
settle()
assert str(window.store.state.evaluation.document.formulation) == "mean-product"
assert find("layer_raw", QAction).isChecked()

find("colour_by_depth", QAction).trigger()
settle()
assert window.view.picture().colouring.title == "Depth below 0"
find("row_knots.C_1.s", QLineEdit).setFocus()
find("colour_by_sensitivity", QAction).trigger()
settle()
assert max(window.view.picture().colouring.limits) > 0

find("laboratory_lengths", QAction).trigger()
settle(lambda: find("lengths.text", QLabel).text())
assert float(find("lengths.text", QLabel).text()) > 0

find("surface.export", QAbstractButton).click()
settle(lambda: window.findChildren(QTreeWidget, "export.format"))
formats = find("export.format", QTreeWidget)
assert ".pts" in [formats.topLevelItem(k).text(1) for k in range(formats.topLevelItemCount())]
path = find("export.path", QLineEdit)
path.selectAll()
QTest.keyClicks(path, str(Path("dialog.pts").resolve()))
QTest.mouseClick(find("export.start", QAbstractButton), Qt.MouseButton.LeftButton)
settle(lambda: Path("dialog.pts").is_file())
settle(lambda: not window.findChildren(QTreeWidget, "export.format"))
window.store.dispatch(__import__("qovr_app.state.intents", fromlist=["Saved"]).Saved(
    Path("x.qovr"), "x.qovr", window.store.state.history.serial))
window.close()
"""

SLOPES = """
import json, plugin
from dataclasses import replace
import numpy as np
from qovr_core import Document, Evaluation, Layer
from qovr_core.edits import Direction, KnotPlace, set_values, value_at
from qovr_core.laboratory.sensitivity import knot_sensitivity

rng = np.random.default_rng(5)
y, x = np.mgrid[:5, :5]
document = Document(np.stack([x, y, rng.random((5, 5))], axis=-1), formulation="mean-product", samples=(21, 17))
u = np.linspace(0, 1, 9)
worst = 0.0
for direction in Direction:
    for name in "rsut":
        place, h = KnotPlace(direction, 2, name), 1e-5
        ends = [
            Evaluation(set_values(document, {place: value_at(document, place) + sign * h})).patch.points(u, u)
            for sign in (1, -1)
        ]
        found = knot_sensitivity(Evaluation(document), place, Layer.RAW).points(u, u)
        worst = max(worst, float(np.abs(found - (ends[0] - ends[1]) / (2 * h)).max()))
print(json.dumps(worst))
"""


@pytest.fixture
def outside(tmp_path):
    """A folder with somebody else's module, and a function that runs a script there."""
    (tmp_path / "plugin.py").write_text(PLUGIN, encoding="utf-8")
    home = {f"XDG_{kind}_HOME": str(tmp_path / kind.lower()) for kind in ("CONFIG", "DATA", "CACHE")}

    def run(script):
        paths = os.pathsep.join([str(tmp_path), *filter(None, [os.environ.get("PYTHONPATH")])])
        (tmp_path / "script.py").write_text(script, encoding="utf-8")
        done = subprocess.run(
            [sys.executable, "-W", "error", "script.py"],
            cwd=tmp_path,
            env={**os.environ, **home, "PYTHONPATH": paths},
            capture_output=True,
            text=True,
            check=False,
            timeout=240,
        )
        assert done.returncode == 0, done.stdout + done.stderr
        return done.stdout

    run.folder = tmp_path
    return run


def test_the_command_line_knows_them(outside):
    said = outside(COMMANDS)
    assert '"formulation": "mean-product"' in said
    (header,) = (line for line in said.splitlines() if line.startswith("| the paper says"))
    assert "`mean-product`" in header
    assert "{published,double-sum,interpolating,mean-product}" in said
    assert ".pts" in said
    points = np.loadtxt(outside.folder / "a.pts")
    with np.load(outside.folder / "a.npz") as arrays:
        assert points == pytest.approx(arrays["raw"].reshape(-1, 3), abs=1e-12)
        assert str(arrays["formulation"]) == "mean-product"
    assert json.loads((outside.folder / "a.qovr").read_text())["formulation"] == "mean-product"
    assert "B_SPLINE_SURFACE" in (outside.folder / "a.step").read_text()


def test_its_sensitivity_is_right_without_being_told(outside):
    assert json.loads(outside(SLOPES)) < 1e-8


def test_the_window_knows_them(outside, display):
    outside(WINDOW)
    assert np.loadtxt(outside.folder / "dialog.pts").shape == (101 * 101, 3)
