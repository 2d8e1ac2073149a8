"""The shape of the house: what may import what, how large a thing may be, what a command loads."""

import ast
import subprocess
import sys

import pytest

from qovr_core.cli import COMMANDS
from qovr_core.files.formats import FORMATS
from support.structure import IMPORTS, PATHS, circle, classes, imports_between_rooms, upward_imports

CORE = [name for name in PATHS if name.split(".")[0] == "qovr_core"]
WINDOW_LIBRARIES = {"PySide6", "pyqtgraph", "OpenGL"}

DOORS = {"OpenGL": [], "pyqtgraph": ["qovr_app.laboratory.pg"]}
"""What imports each library of the window that has no types: Qt itself gives the functions of OpenGL."""

LONGEST_MODULE = 250
LONGEST_CLASS = 220
MOST_METHODS = 20

FLOORS = {
    "qovr_core": (
        "arrays cameras errors later layer number_texts registry resources version",
        "checks colours net_edits net_moves streams",
        "geometry",
        "fields formulations joints knot_input net_input",
        "document",
        "edits presets",
        "shapes symmetry",
        "construction",
        "structure",
        "evaluation",
        "files laboratory report",
        "reproduce",
        "figures",
        "commands",
        "cli",
        "__main__",
    ),
    "qovr_app": (
        "starting",
        "state work",
        "store style",
        "widgets",
        "zones view3d laboratory dialogs",
        "window",
        "main",
        "__main__",
    ),
    "qovr_app.view3d": (
        "scene failures",
        "interaction gl painter figure viewport",
        "gl_viewport painter_viewport",
        "viewports images words",
        "view",
    ),
}
"""The parts of each house from the ground up: each imports only from the floors below, and not from its neighbours."""

SLOW = {
    "concurrent.futures",
    "csv",
    "email",
    "fractions",
    "http",
    "random",
    "ssl",
    "tempfile",
    "uuid",
    "zipfile",
}
"""Parts of Python that take milliseconds to import, and that nobody needs who is told of a surface."""

HEADLESS = {
    "compare": ["paper:fig5", "--json"],
    "desktop": ["--install"],
    "export": ["paper:fig5", "--samples", "5", *(f"out{suffix}" for suffix in FORMATS)],
    "figures": [".", "--only", "fig5a", "--formats", "png,svg,pdf", "--dpi", "40"],
    "info": ["paper:fig5"],
    "presets": [],
    "reproduce": ["in.xlsx"],
    "verify": ["paper:fig5", "--counterexamples", "."],
}
"""How every headless command is called here."""


def text_of(module):
    return PATHS[module].read_text(encoding="utf-8")


def test_the_core_knows_no_window():
    forbidden = WINDOW_LIBRARIES | {"qovr_app"}
    assert [module for module in CORE if {name.split(".")[0] for name in IMPORTS[module]} & forbidden] == []


def test_no_module_imports_itself_on_a_way_round():
    assert circle({module: others & PATHS.keys() for module, others in IMPORTS.items()}) == []


def test_no_folder_imports_itself_on_a_way_round():
    assert circle(imports_between_rooms()) == []


@pytest.mark.parametrize("house", FLOORS)
def test_imports_point_down(house):
    assert upward_imports(house, FLOORS[house]) == []


def test_modules_are_short():
    lengths = {module: len(text_of(module).splitlines()) for module in PATHS}
    assert {module: length for module, length in lengths.items() if length > LONGEST_MODULE} == {}


def test_classes_are_short_and_have_few_methods():
    sizes = {
        name: (node.end_lineno - node.lineno + 1, sum(isinstance(part, ast.FunctionDef) for part in node.body))
        for name, node in classes().items()
    }
    assert {name: size for name, size in sizes.items() if size[0] > LONGEST_CLASS or size[1] > MOST_METHODS} == {}


@pytest.mark.parametrize("library", DOORS)
def test_a_library_without_types_has_one_door_at_most(library):
    importing = [module for module in PATHS if library in {name.split(".")[0] for name in IMPORTS[module]}]
    assert importing == DOORS[library]


def test_types_are_ignored_nowhere():
    assert [module for module in PATHS if "type: ignore" in text_of(module)] == []


def modules_of(code, folder):
    """Return the names of all modules there are after running code in a fresh interpreter."""
    names = f"{code}\nimport sys; print(*sys.modules, file=sys.__stderr__)"
    done = subprocess.run([sys.executable, "-c", names], capture_output=True, text=True, check=True, cwd=folder)
    return set(done.stderr.split())


def loaded_by(code, folder):
    """Return the top-level modules that are no part of Python itself, after running code in a fresh interpreter."""
    done, before = ({name.split(".")[0] for name in modules_of(text, folder)} for text in (code, ""))
    return {name for name in done - before - set(sys.stdlib_module_names) if "cython" not in name}  # NumPy's own


def call_of(arguments):
    """Return code that calls ``qovr``, which has to succeed."""
    return (
        "import sys\nfrom qovr_app.main import main\n"
        f"sys.argv = ['qovr', *{arguments!r}]\n"
        "try: code = main()\nexcept SystemExit as end: code = end.code\n"
        "assert not code, code"
    )


def loaded_by_command(arguments, folder):
    return loaded_by(call_of(arguments), folder)


def test_importing_the_core_loads_numpy_alone(tmp_path):
    assert loaded_by("import qovr_core", tmp_path) == {"qovr_core", "numpy"}


def test_a_document_is_evaluated_with_numpy_alone(tmp_path):
    code = (
        "import numpy, qovr_core\n"
        "surface = qovr_core.configure(qovr_core.Document(numpy.random.random((5, 5, 3))))\n"
        "surface.raw, surface.transformed, surface.matrix"
    )
    assert loaded_by(code, tmp_path) == {"qovr_core", "numpy"}


@pytest.mark.parametrize("command", [["presets"], ["info", "paper:fig5"], ["info", "--help"]])
def test_the_command_loads_nothing_heavy_before_it_is_needed(command, tmp_path):
    assert loaded_by_command(command, tmp_path) <= {"qovr_core", "qovr_app", "qovr_resources", "numpy"}


@pytest.mark.parametrize("suffix", ["", ".qovr", ".step", ".csv"])
def test_a_command_imports_no_other_command_and_no_other_format(suffix, tmp_path):
    arguments = ["export", "paper:fig5", f"out{suffix}"] if suffix else ["info", "paper:fig5"]
    loaded = modules_of(call_of(arguments), tmp_path) - modules_of("", tmp_path)
    commands = {f"qovr_core.commands.{name}" for name in COMMANDS} & loaded
    writers = {entry.suffix for entry in FORMATS.values() if entry.writer.__module__ in loaded}
    assert commands == {f"qovr_core.commands.{arguments[0]}"}
    assert writers - {".qovr"} == {suffix} - {"", ".qovr"}  # a document is what every other format can hold as text
    assert not {name for name in loaded if name.startswith(("qovr_core.laboratory", "qovr_app.w", "qovr_app.state"))}
    assert loaded & (set() if suffix else SLOW) == set()


@pytest.mark.parametrize("command", COMMANDS)
def test_every_headless_command_runs_without_qt(command, tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_DATA_HOME", str(tmp_path / "data"))
    if command == "reproduce":
        loaded_by_command(["export", "paper:fig5", "in.xlsx"], tmp_path)
    assert not loaded_by_command([command, *HEADLESS[command]], tmp_path) & WINDOW_LIBRARIES


def test_state_and_store_are_made_without_qt(tmp_path):
    modules = [module for module in PATHS if f"{module}.".startswith(("qovr_app.state.", "qovr_app.store."))]
    loaded = loaded_by("\n".join(f"import {module}" for module in modules), tmp_path)
    assert loaded == {"qovr_app", "qovr_core", "numpy"}
