"""How far an edit travels: the project's files that run between a typed knot and the graphics buffers."""

import sys
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest

import qovr_app
import qovr_core

PACKAGES = {str(Path(package.__file__).parent): package.__name__ for package in (qovr_app, qovr_core)}
START = ("qovr_app/zones/zone.py", "_on_value_edited")
"""Where the field's signal arrives."""

TURNS = [
    ("qovr_core/formulations.py", "_published"),
    ("qovr_app/view3d/gl_viewport.py", "set_picture"),
    ("qovr_app/view3d/scene/mesh.py", "surface_vertices"),
]
"""The main way leads to these: the patch is built, the picture is handed over, its vertices are made for the buffer."""

LAST = ("qovr_app/view3d/gl/surface_buffers.py", "_load_vertices")
"""Others ask for vertices too, as what hides marks does."""

MOST_ON_THE_MAIN_WAY = 15


class Way:
    """Watches which of the project's files are entered, until vertices are made for the graphics buffers."""

    def __init__(self):
        self.entered, self.main_way = {}, {}
        self.has_begun = self.is_over = False

    def __call__(self, frame, event, _argument):
        place = self._place(frame)
        if event != "call" or place is None or self.is_over:
            return
        self.has_begun = self.has_begun or place == START
        if self.has_begun:
            self.entered[place[0]] = None
            is_turn = place in TURNS and (place != TURNS[-1] or self._place(frame.f_back) == LAST)
            if is_turn:
                self.main_way |= dict.fromkeys(reversed(self._callers(frame)))
            self.is_over = is_turn and place == TURNS[-1]

    def _callers(self, frame):
        files = []
        while frame is not None:
            place = self._place(frame)
            if place is not None:
                files.append(place[0])
            if place == START:
                break
            frame = frame.f_back
        return files

    @staticmethod
    def _place(frame):
        """Return file and function of a frame of the project's own."""
        for folder, name in PACKAGES.items():
            if frame.f_code.co_filename.startswith(folder):
                return name + frame.f_code.co_filename[len(folder) :].replace("\\", "/"), frame.f_code.co_name
        return None


def test_the_way_of_a_typed_knot_is_short(make_editor, spin):
    editor = make_editor()
    view = editor.window.view
    if not view.uses_opengl:
        pytest.skip("there is no OpenGL, so nothing goes into its buffers")
    spin(lambda: not view.picture().moving)
    field = editor.field("row_knots.C_4.s")
    field.setFocus()
    field.selectAll()
    QTest.keyClicks(field, "0.62")
    editor.settle()
    way = Way()
    sys.setprofile(way)
    try:
        QTest.keyClick(field, Qt.Key.Key_Return)
        editor.settle()
    finally:
        sys.setprofile(None)
    assert way.is_over
    print(f"\non the main way {len(way.main_way)} files:", *way.main_way, sep="\n  ")
    print(f"in all {len(way.entered)} files:", *way.entered, sep="\n  ")
    assert len(way.main_way) <= MOST_ON_THE_MAIN_WAY
