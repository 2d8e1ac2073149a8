"""Paths where no file can be read or written, whatever the reason: one line that begins with the path."""

import errno
import os
import socket
import stat

import pytest

from qovr_core import FileError
from qovr_core.errors import LONGEST_TEXT, QovrError, one_line
from qovr_core.files import FORMATS, atomic, read_source, readable_suffixes, write_document
from qovr_core.files.atomic import check_target, made_folder, replacing
from qovr_core.files.qovr_document import read_document
from qovr_core.files.workbook_read import read_published_numbers
from support.documents import random_document

DOCUMENT = random_document(1)


def refusal(function, path):
    with pytest.raises(FileError) as caught:
        function(path)
    text = str(caught.value)
    assert text.isprintable()
    assert len(text) <= LONGEST_TEXT
    return text


def write(path):
    with replacing(path) as (draft,):
        draft.write_text("new")


def entry(folder, kind, suffix=".qovr"):
    """Make something that is no file."""
    path = folder / f"a{suffix}"
    if kind == "folder":
        path.mkdir()
    elif kind == "pipe":
        os.mkfifo(path)
    elif kind == "socket":
        with socket.socket(socket.AF_UNIX) as end:
            end.bind(str(path))
    elif kind == "device":
        try:
            os.mknod(path, 0o020666, os.makedev(1, 3))
        except PermissionError:
            pytest.skip("only root makes devices")
    elif kind == "link to a pipe":
        os.mkfifo(folder / "pipe")
        path.symlink_to(folder / "pipe")
    elif kind == "link to itself":
        path.symlink_to(path)
    return path


KINDS = ["folder", "pipe", "socket", "device", "link to a pipe", "link to itself"]


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="such entries are of POSIX")
@pytest.mark.parametrize("kind", KINDS)
def test_what_is_no_file_is_refused_without_being_opened(kind, tmp_path, monkeypatch):
    path = entry(tmp_path, kind)
    before = sorted(name.name for name in tmp_path.iterdir())

    def never(*_, **__):
        raise AssertionError("was opened")

    monkeypatch.setattr("io.open", never)
    monkeypatch.setattr(os, "open", never)
    for function in (check_target, write, read_document, read_published_numbers, lambda p: read_source(str(p))):
        if (function, kind) not in ((check_target, "link to itself"), (write, "link to itself")):
            assert refusal(function, path).startswith(f"{path}: ")
    assert sorted(name.name for name in tmp_path.iterdir()) == before


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="pipes are of POSIX")
@pytest.mark.parametrize("suffix", readable_suffixes())
def test_no_reader_waits_for_a_pipe(suffix, tmp_path):
    assert "is a device or a pipe; expected a file" in refusal(
        lambda p: read_source(str(p)), entry(tmp_path, "pipe", suffix)
    )


PLACES = {
    "a name that is too long": "x" * 300 + "{}",
    "a path that is too long": "d/" * 3000 + "a{}",
    "a file as a folder": "file/a{}",
    "no folder": "gone/a{}",
    "a NUL": "a\0b{}",
    "a link to nowhere": "dangling/a{}",
}


@pytest.mark.parametrize("name", PLACES)
@pytest.mark.parametrize("suffix", FORMATS)
def test_places_where_no_file_can_be(name, suffix, tmp_path):
    (tmp_path / "file").write_text("a file")
    (tmp_path / "dangling").symlink_to(tmp_path / "gone")
    path = tmp_path / PLACES[name].format(suffix)
    for function in (check_target, write):
        assert "cannot be written: " in refusal(function, path)
    if FORMATS[suffix].reader is not None:
        assert "cannot be read: " in refusal(lambda p: read_source(str(p)), path)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["dangling", "file"]


@pytest.mark.parametrize("name", ["x" * 300, "file", "file/inner", "a\0b"])
def test_folders_that_cannot_be_made(name, tmp_path):
    (tmp_path / "file").write_text("a file")
    assert refusal(made_folder, tmp_path / name)


@pytest.mark.parametrize("function", ["fsync", "chmod", "chown"])
def test_a_share_that_refuses_what_is_not_needed(function, tmp_path, monkeypatch):
    path = tmp_path / "a.qovr"
    write_document(DOCUMENT, path)
    real = getattr(os, function)

    def refuse(target, *arguments, **options):
        if function == "fsync" and not stat.S_ISDIR(os.fstat(target).st_mode):
            return real(target)
        raise OSError(errno.ENOTSUP, "Operation not supported")

    monkeypatch.setattr(os, function, refuse)
    write_document(random_document(2), path)
    assert read_document(path) == random_document(2)


@pytest.mark.parametrize("number", [errno.EIO, errno.EROFS, errno.ESTALE, errno.ETXTBSY, errno.EBUSY, errno.EDQUOT])
def test_whatever_the_system_says_is_said(number, tmp_path, monkeypatch):
    """A file that another process has locked or runs, a share that went away, a quota."""
    path = tmp_path / "a.qovr"
    write_document(DOCUMENT, path)

    def refuse(*_, **__):
        raise OSError(number, os.strerror(number))

    monkeypatch.setattr(os, "replace", refuse)
    assert refusal(lambda p: write_document(random_document(2), p), path).endswith(os.strerror(number))
    assert read_document(path) == DOCUMENT
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.qovr"]


@pytest.mark.parametrize(
    ("name", "reason"),
    [
        ("CON.qovr", "keeps the name CON.qovr for a device"),
        ("nul", "keeps the name nul"),
        ("Com1.step.qovr", "keeps the name Com1"),
        ("aux/a.qovr", "keeps the name aux"),
        ("LPT¹.qovr", "keeps the name"),
        ("a.qovr.", "ends in a dot or a space"),
        ("a.qovr ", "ends in a dot or a space"),
        ("a:b.qovr", "no name with any of"),
        ("a?.qovr", "no name with any of"),
        ("a\tb.qovr", "no name with any of"),
    ],
)
def test_names_that_windows_keeps(name, reason, tmp_path, monkeypatch):
    (tmp_path / "aux").mkdir()
    check_target(tmp_path / name)  # any name will do elsewhere
    monkeypatch.setattr(atomic, "IS_WINDOWS", True)
    assert reason in refusal(check_target, tmp_path / name)
    for fine in ("console.qovr", "com10.qovr", "nullity.qovr", "a b.qovr", ".qovr"):
        check_target(tmp_path / fine)


@pytest.mark.parametrize("text", ["a\nb", "\0", "\ud800", "\u202e", "\x1b[31m", "x" * 10**6, "\n" * 5000])
def test_any_text_is_one_short_line(text):
    for line in (str(QovrError(text)), one_line(text)):
        assert line.isprintable()
        assert line.isascii()
        assert len(line) <= LONGEST_TEXT
    assert str(QovrError("plain ö text")) == "plain ö text"


KEYS = ["x\ny", "\0", "\ud800", "k" * 100_000, "", "\u202etxt", "ключ"]


@pytest.mark.parametrize("key", KEYS, ids=ascii)
@pytest.mark.parametrize("place", ["", "row_knots"])
def test_foreign_keys_are_escaped_and_shortened(key, place, tmp_path):
    import json

    from qovr_core.files.qovr_document import document_to_json

    content = json.loads(document_to_json(DOCUMENT))
    (content if not place else content[place][2])[key] = 1
    path = tmp_path / "a.qovr"
    path.write_text(json.dumps(content))
    text = refusal(read_document, path)
    assert "is no key of a document; expected only" in text
    assert f"{place}[2]." in text or not place


@pytest.mark.parametrize(
    "content",
    [
        b"[" * 900_000,
        b'{"a":' * 150_000,
        b'{"format": "qovr-document", "version": ' + b"9" * 900_000 + b"}",
        b'{"format": "qovr-document", "version": 1.' + b"9" * 900_000 + b"}",
        b'{"format": -' + b"9" * 900_000 + b"}",
        b"{" + b",".join(b'"k%d":1' % k for k in range(70_000)) + b',"k69999":2}',
    ],
    ids=lambda content: content[:20].decode(),
)
def test_json_that_would_take_for_ever(content, tmp_path):
    (tmp_path / "a.qovr").write_bytes(content)
    assert refusal(read_document, tmp_path / "a.qovr")
