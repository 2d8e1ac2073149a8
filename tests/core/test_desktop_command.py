"""``qovr desktop``: what stands in the user's folders, by the desktop's own tools where they are installed."""

import configparser
import os
import shutil
import subprocess
import xml.etree.ElementTree as ET

import pytest

from support.command import QOVR, environment, refused
from support.command import qovr as command


@pytest.fixture
def data(tmp_path):
    return tmp_path / "data"


def desktop(data, *arguments, program=QOVR):
    call = [str(program), "desktop", *arguments]
    variables = environment(XDG_DATA_HOME=str(data))
    done = subprocess.run(call, env=variables, capture_output=True, text=True, check=False, timeout=100)
    assert done.stderr == ""
    assert done.returncode == 0
    return done.stdout


def everything(folder):
    return sorted(path.relative_to(folder) for path in folder.rglob("*"))


def entry_of(data):
    parser = configparser.RawConfigParser(delimiters="=")
    parser.optionxform = str
    parser.read(data / "applications" / "qovr-studio.desktop", encoding="utf-8")
    return dict(parser["Desktop Entry"])


def words_of(line):
    """Return the words of an Exec line, by the specification: values are unescaped first, then quotes are."""
    text, words, word, is_quoted = line.replace("\\\\", "\\"), [], "", False
    letters = iter(text)
    for letter in letters:
        if letter == '"':
            is_quoted = not is_quoted
        elif letter == "\\" and is_quoted:
            word += next(letters)
        elif letter == " " and not is_quoted:
            words, word = [*words, word], ""
        else:
            word += letter
    return [word.replace("%%", "%") for word in [*words, word]]


def test_entry_type_and_icons_are_installed_for_the_user_alone(data):
    said = desktop(data, "--install")
    entry = entry_of(data)
    assert words_of(entry["Exec"]) == [str(QOVR), "%F"]
    assert entry["TryExec"] == str(QOVR)
    assert entry["MimeType"] == "application/x-qovr;"
    kind = ET.parse(data / "mime" / "packages" / "qovr-studio.xml")
    space = "{http://www.freedesktop.org/standards/shared-mime-info}"
    assert kind.find(f"{space}mime-type").get("type") == "application/x-qovr"
    assert kind.find(f"{space}mime-type/{space}glob").get("pattern") == "*.qovr"
    for place, name in (("apps", entry["Icon"]), ("mimetypes", "application-x-qovr")):
        icon = data / "icons" / "hicolor" / "scalable" / place / f"{name}.svg"
        assert ET.parse(icon).getroot().tag == "{http://www.w3.org/2000/svg}svg"
        assert f"installed {icon}\n" in said


def test_again_is_no_harm_and_removing_leaves_nothing(data):
    desktop(data, "--install")
    before = everything(data)
    desktop(data, "--install")
    assert everything(data) == before
    assert desktop(data, "--remove").count("removed ") == 4
    assert everything(data) == []
    assert desktop(data, "--remove") == "nothing was installed\n"


def test_what_others_have_there_stays(data):
    others = {
        data / "applications" / "other.desktop": "[Desktop Entry]\nType=Application\nName=Other\nExec=true\n",
        data / "mime" / "packages" / "other.xml": (
            '<mime-info xmlns="http://www.freedesktop.org/standards/shared-mime-info">'
            '<mime-type type="application/x-other"><glob pattern="*.other"/></mime-type></mime-info>'
        ),
        data / "icons" / "hicolor" / "scalable" / "apps" / "other.svg": "<svg/>",
    }
    for path, text in others.items():
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text)
    desktop(data, "--install")
    desktop(data, "--remove")
    assert {path: path.read_text() for path in others} == others
    assert not [path for path in everything(data) if "qovr" in path.name]


def test_a_path_with_signs_that_mean_something_is_quoted(data, tmp_path):
    folder = tmp_path / 'my $tools\\ `100%` "new" ä'
    folder.mkdir()
    program = folder / "qovr"
    shutil.copy(QOVR, program)
    desktop(data, "--install", program=program)
    assert words_of(entry_of(data)["Exec"]) == [str(program), "%F"]
    if shutil.which("desktop-file-validate"):
        validated = subprocess.run(
            ["desktop-file-validate", data / "applications" / "qovr-studio.desktop"],
            capture_output=True,
            text=True,
            check=False,
        )
        assert (validated.returncode, validated.stdout, validated.stderr) == (0, "", "")


@pytest.mark.skipif(
    not (shutil.which("xdg-mime") and shutil.which("update-desktop-database")), reason="the desktop's tools are missing"
)
def test_the_desktop_knows_the_type_and_what_opens_it(data, tmp_path):
    desktop(data, "--install")
    file = tmp_path / "a.qovr"
    file.write_text("{}")
    variables = {**os.environ, "XDG_DATA_HOME": str(data), "XDG_CONFIG_HOME": str(tmp_path)}
    for query, answer in (
        (("filetype", file), "application/x-qovr"),
        (("default", "application/x-qovr"), "qovr-studio.desktop"),
    ):
        asked = subprocess.run(["xdg-mime", "query", *query], env=variables, capture_output=True, text=True, check=True)
        assert asked.stdout.strip() == answer


@pytest.mark.parametrize("call", [(), ("--install", "--remove"), ("--instal",)])
def test_refusals(call):
    refused(command("desktop", *call))
