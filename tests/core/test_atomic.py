"""The one way in which files are written: whole or not at all, and as they were but for what is in them."""

import errno
import os
import stat
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from qovr_core import FileError
from qovr_core.cli import main
from qovr_core.files import atomic, read_document, write_document
from qovr_core.files.atomic import replacing
from qovr_core.files.drafts import remove_drafts, scratch_folder
from support.documents import random_document

POSIX = pytest.mark.skipif(os.name != "posix", reason="modes, owners and folders that can be synced are of POSIX")
SOMEBODY = 12345
"""A user and a group that nobody on this machine is likely to be."""


def write(path, text):
    with replacing(path) as (draft,):
        draft.write_text(text)


def mode_of(path):
    return stat.S_IMODE(path.stat().st_mode)


def names(folder):
    return sorted(entry.name for entry in folder.iterdir())


@POSIX
def test_a_file_keeps_its_mode_and_its_link(tmp_path):
    path, link = tmp_path / "a.qovr", tmp_path / "link.qovr"
    write_document(random_document(1), path)
    path.chmod(0o640)
    link.symlink_to(path)
    write_document(random_document(2), link)
    assert link.is_symlink()
    assert read_document(path) == random_document(2)
    assert mode_of(path) == 0o640


def test_a_link_into_another_folder_is_followed_and_its_draft_is_made_there(tmp_path):
    (tmp_path / "far").mkdir()
    link = tmp_path / "link"
    link.symlink_to(Path("far") / "there")  # nothing is there yet
    with replacing(link) as (draft,):
        assert draft.parent == (tmp_path / "far").resolve()
        draft.write_text("new")
    assert link.is_symlink()
    assert (tmp_path / "far" / "there").read_text() == "new"
    assert names(tmp_path) == ["far", "link"]
    assert names(tmp_path / "far") == ["there"]


def test_a_link_into_a_folder_that_is_none_is_refused(tmp_path):
    (tmp_path / "link").symlink_to(tmp_path / "gone" / "there")
    with pytest.raises(FileError, match="does not exist"):
        write(tmp_path / "link", "new")


@POSIX
@pytest.mark.parametrize(("mask", "mode"), [(0o027, 0o640), (0o002, 0o664), (0o077, 0o600)])
def test_a_new_file_has_the_mode_that_the_system_gives(tmp_path, mask, mode):
    before = os.umask(mask)
    try:
        write(tmp_path / "a", "new")
    finally:
        os.umask(before)
    assert mode_of(tmp_path / "a") == mode


@POSIX
def test_the_group_is_kept(tmp_path):
    path = tmp_path / "a"
    path.write_text("old")
    others = [SOMEBODY] if os.geteuid() == 0 else [group for group in os.getgroups() if group != path.stat().st_gid]
    if not others:
        pytest.skip("this user is a member of one group only")
    os.chown(path, -1, others[0])
    path.chmod(0o660)
    write(path, "new")
    assert path.stat().st_gid == others[0]
    assert mode_of(path) == 0o660


@pytest.fixture
def somebody_s(tmp_path):
    """A file of somebody else that this user may write."""
    if os.name != "posix" or os.geteuid() != 0:
        pytest.skip("only root can give a file away")
    path = tmp_path / "a.qovr"
    write_document(random_document(1), path)
    os.chown(path, SOMEBODY, SOMEBODY)
    path.chmod(0o664)
    return path


@pytest.fixture
def no_giving_away(monkeypatch):
    def refuse(*_):
        raise PermissionError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "chown", refuse)


def test_the_owner_is_kept_where_it_may_be_set(somebody_s, caplog):
    write(somebody_s, "new")
    assert somebody_s.stat().st_uid == SOMEBODY
    assert caplog.text == ""


def test_a_user_who_becomes_the_owner_is_told(somebody_s, no_giving_away, capsys):
    assert main(["export", "paper:fig5", str(somebody_s)]) == 0
    assert somebody_s.stat().st_uid == os.geteuid()
    said = capsys.readouterr().err
    assert said.startswith(f"qovr: {somebody_s}: belongs to you now")
    assert said.count("\n") == 1


def test_another_group_gets_no_more_than_all_had(somebody_s, no_giving_away):
    somebody_s.chmod(0o660)
    write(somebody_s, "new")
    assert mode_of(somebody_s) == 0o600


@POSIX
def test_a_share_that_refuses_modes_and_syncing_of_folders_is_no_error(tmp_path, monkeypatch):
    sync = os.fsync

    def refuse_mode(*_, **__):
        raise PermissionError(errno.EPERM, "Operation not permitted")

    def refuse_folders(descriptor):
        if stat.S_ISDIR(os.fstat(descriptor).st_mode):
            raise OSError(errno.EINVAL, "Invalid argument")
        sync(descriptor)

    path = tmp_path / "a"
    path.write_text("old")
    monkeypatch.setattr(os, "chmod", refuse_mode)
    monkeypatch.setattr(os, "fsync", refuse_folders)
    write(path, "new")
    assert path.read_text() == "new"
    assert names(tmp_path) == ["a"]


@pytest.fixture
def open_folder():
    """A folder that every user can enter; those of pytest are for its own user alone."""
    with TemporaryDirectory() as name:
        Path(name).chmod(0o755)
        yield Path(name)


@POSIX
@pytest.mark.parametrize("mode", [0o555, 0o444])
def test_a_folder_that_is_read_only_is_named_and_the_old_file_stays(open_folder, mode):
    """In a process of its own, that gives up being root: root may write anywhere."""
    folder = open_folder / "folder"
    folder.mkdir()
    (folder / "a").write_text("old")
    (folder / "a").chmod(0o666)
    folder.chmod(mode)
    code = (
        "import os, sys, pathlib\n"
        "from qovr_core.files.atomic import replacing\n"
        "target = pathlib.Path(sys.argv[1])\n"
        f"if os.geteuid() == 0: os.setuid({SOMEBODY})\n"
        "with replacing(target) as (draft,): draft.write_text('new')\n"
    )
    done = subprocess.run([sys.executable, "-c", code, str(folder / "a")], capture_output=True, text=True, check=False)
    folder.chmod(0o755)
    assert f"FileError: {folder / 'a'}: cannot be written: Permission denied" in done.stderr
    assert (folder / "a").read_text() == "old"
    assert names(folder) == ["a"]


def test_a_file_that_is_write_protected_is_not_replaced(tmp_path, monkeypatch):
    (tmp_path / "a").write_text("old")
    monkeypatch.setattr(os, "access", lambda *_: False)  # root may write anything
    with pytest.raises(FileError, match="write-protected"):
        write(tmp_path / "a", "new")
    assert (tmp_path / "a").read_text() == "old"


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="there are no pipes with names here")
def test_a_pipe_is_not_replaced(tmp_path):
    pipe = tmp_path / "a.csv"
    os.mkfifo(pipe)
    with pytest.raises(FileError, match="a device or a pipe; expected a file"), replacing(pipe):
        pass
    assert pipe.is_fifo()
    assert list(tmp_path.iterdir()) == [pipe]


def test_of_two_files_none_appears_where_one_fails(tmp_path):
    first, second = tmp_path / "a", tmp_path / "b"
    first.write_text("old")

    def write_one_and_fail():
        with replacing(first, second) as (draft, _):
            draft.write_text("new")
            raise OSError(errno.ENOSPC, "No space left on device")

    with pytest.raises(FileError, match="a: cannot be written: No space left on device"):
        write_one_and_fail()
    assert first.read_text() == "old"
    assert names(tmp_path) == ["a"]


def test_no_writer_sweeps_away_what_another_has_just_begun(tmp_path):
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda k: write(tmp_path / "a", str(k)), range(600)))
    assert [entry.name for entry in tmp_path.iterdir()] == ["a"]


def test_of_many_writers_at_once_one_wins_whole(tmp_path):
    texts = [str(k) * 100_000 for k in range(8)]
    with ThreadPoolExecutor(8) as pool:
        list(pool.map(lambda text: write(tmp_path / "a", text), texts * 5))
    assert (tmp_path / "a").read_text() in texts
    assert names(tmp_path) == ["a"]


def test_drafts_are_hidden_and_carry_the_number_of_their_process(tmp_path):
    with replacing(tmp_path / "a") as (draft,), scratch_folder(draft) as scratch:
        for path in (draft, scratch):
            assert path.parent == tmp_path.resolve()
            assert path.name.startswith(f".qovr-{os.getpid()}-")
            assert path.name.endswith(".part")
    assert names(tmp_path) == ["a"]


def test_drafts_of_one_process_are_removed_and_no_others(tmp_path):
    kept = [".qovr-12345-aa.part", ".qovr-123-aa.txt", "a", "qovr-123-aa.part"]
    for name in [*kept, ".qovr-123-aa.part"]:
        (tmp_path / name).write_text("half")
    (tmp_path / ".qovr-123-bb.part").mkdir()
    (tmp_path / ".qovr-123-bb.part" / "rows").write_text("half")
    remove_drafts(tmp_path / "a", 123)
    assert names(tmp_path) == sorted(kept)
    remove_drafts(tmp_path / "gone" / "a", 123)  # nothing to do is no error


def test_what_a_killed_process_left_goes_with_a_later_write_to_its_folder(tmp_path):
    two_days_ago = time.time() - 2 * 24 * 3600
    for name in (".qovr-0123456789ab.part", ".qovr-123-0123456789ab.part"):
        (tmp_path / name).write_text("half")
    (tmp_path / ".qovr-scratch.part").mkdir()
    (tmp_path / ".qovr-scratch.part" / "rows").write_text("half")
    (tmp_path / ".qovr-fresh.part").write_text("another process is writing this")
    for name in (".qovr-notes", "mine.part"):
        (tmp_path / name).write_text("not ours")
    for entry in tmp_path.iterdir():
        if "fresh" not in entry.name:
            os.utime(entry, (two_days_ago, two_days_ago))
    write(tmp_path / "a", "new")
    assert names(tmp_path) == sorted(["a", ".qovr-fresh.part", ".qovr-notes", "mine.part"])


def test_nothing_else_in_the_program_makes_its_own_drafts():
    """Everything that writes goes through the one writer; nobody else renames, syncs or asks for the mask."""
    own = {"os.fsync", "umask", "mkstemp", ".replace(place)"}
    root = Path(atomic.__file__).parents[2]
    modules = [path for package in ("qovr_core", "qovr_app") for path in (root / package).rglob("*.py")]
    found = {path.name for path in modules if any(word in path.read_text(encoding="utf-8") for word in own)}
    assert found == {"atomic.py"}
