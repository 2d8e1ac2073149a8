"""A window driven as a user drives it: by object names and real events, and never with the user's own settings."""

import pytest

from support.editor import Editor


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A folder of the test's own for settings, recovery files and everything that is written."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path / "config"))
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    from PySide6.QtCore import QSettings

    for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
        QSettings.setPath(kind, QSettings.Scope.UserScope, str(tmp_path / "config"))
    (tmp_path / "work").mkdir()
    monkeypatch.chdir(tmp_path / "work")
    return tmp_path / "work"


@pytest.fixture
def make_editor(app, home):
    """A function that opens an editor's window; all are closed at the end."""
    from qovr_app.main import create_window

    editors = []

    def make(source=None, size=(1440, 900)):
        editor = Editor(create_window(source), size)
        editors.append(editor)
        return editor

    yield make
    for editor in editors:
        editor.discard()


@pytest.fixture
def editor(make_editor):
    """The editor as it opens."""
    return make_editor()
