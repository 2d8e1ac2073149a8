"""A window driven as a user drives it: by object names and real events, and never with the user's own settings."""

import pytest

from support.editor import Editor


@pytest.fixture(autouse=True)
def _one_sample_a_pixel(monkeypatch):
    """Draw the view with no smooth edges, at half the time of a frame: how it looks is for the tests of view3d."""
    from qovr_app.view3d.gl import buffer

    monkeypatch.setattr(buffer, "_SAMPLES", 0)


@pytest.fixture(autouse=True, scope="module")
def _keys_follow_each_other():
    """Have keys pressed one after the other be one movement of the hand, however long a loaded machine takes."""
    from qovr_app.widgets import bursts

    with pytest.MonkeyPatch.context() as monkeypatch:
        monkeypatch.setattr(bursts, "_PAUSE_MILLISECONDS", 60_000)
        yield


@pytest.fixture
def home(tmp_path, monkeypatch):
    """A folder of the test's own for settings, recovery files and everything that is written."""
    return make_home(tmp_path, monkeypatch)


def make_home(folder, monkeypatch):
    """Have settings, recovery files and everything that is written go into a folder."""
    monkeypatch.setenv("XDG_CONFIG_HOME", str(folder / "config"))
    monkeypatch.setenv("XDG_DATA_HOME", str(folder / "data"))
    from PySide6.QtCore import QSettings

    for kind in (QSettings.Format.NativeFormat, QSettings.Format.IniFormat):
        QSettings.setPath(kind, QSettings.Scope.UserScope, str(folder / "config"))
    (folder / "work").mkdir()
    monkeypatch.chdir(folder / "work")
    return folder / "work"


@pytest.fixture
def make_editor(app, home):
    """A function that opens an editor's window; all are closed at the end, those too that the program has opened."""
    from qovr_app.main import create_window, open_windows

    editors, before = [], open_windows().all

    def make(source=None, size=(1440, 900)):
        editor = Editor(create_window(source), size)
        editors.append(editor)
        return editor

    yield make
    for editor in editors:
        editor.discard()
    for window in set(open_windows().all) - set(before):
        window.leave()


@pytest.fixture
def editor(make_editor):
    """The editor as it opens."""
    return make_editor()


@pytest.fixture(scope="module")
def one_window(app, tmp_path_factory):
    """An editor's window for all tests of a module that only edit, which is much quicker than one for each."""
    from qovr_app.main import create_window

    with pytest.MonkeyPatch.context() as monkeypatch:
        make_home(tmp_path_factory.mktemp("shared"), monkeypatch)
        editor = Editor(create_window(None), (1440, 900))
        yield editor
        editor.discard()


@pytest.fixture
def share_editor(one_window):
    """A function that shows a source in the window of the module, as if it had just been opened."""

    def share(source=None, size=(1440, 900)):
        one_window.begin_again(source, size)
        return one_window

    return share


@pytest.fixture
def shared_editor(share_editor):
    """The window of the module with the paper's own example in it."""
    return share_editor()
