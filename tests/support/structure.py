"""What imports what in the program's own files, and how large they are, from the files themselves."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]

PATHS = {
    ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__"): path
    for top in ("qovr_core", "qovr_app")
    for path in sorted((ROOT / top).rglob("*.py"))
}
"""Every module of the program by its name."""

TREES = {name: ast.parse(path.read_text(encoding="utf-8")) for name, path in PATHS.items()}


def imported_names(node: ast.AST) -> Iterator[str]:
    """Yield the modules that a piece of code imports, at the top or inside a function, but not for its types alone."""
    if isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test):
        return
    if isinstance(node, ast.Import):
        yield from (alias.name for alias in node.names)
    elif isinstance(node, ast.ImportFrom):
        assert node.level == 0, "imports are absolute"
        for alias in node.names:
            inner = f"{node.module}.{alias.name}"
            yield inner if inner in PATHS else str(node.module)
    for child in ast.iter_child_nodes(node):
        yield from imported_names(child)


IMPORTS = {name: frozenset(imported_names(tree)) - {name} for name, tree in TREES.items()}
"""What every module imports: its own modules by their full names, others by theirs."""


def circle(graph: Mapping[str, Iterable[str]]) -> list[str]:
    """Return one circle of a graph, its first node again at the end; empty where there is none."""
    done: set[str] = set()
    path: list[str] = []

    def walk(node: str) -> list[str]:
        if node in path:
            return [*path[path.index(node) :], node]
        if node in done:
            return []
        done.add(node)
        path.append(node)
        for other in sorted(graph.get(node, ())):
            if found := walk(other):
                return found
        path.pop()
        return []

    for start in sorted(graph):
        if found := walk(start):
            return found
    return []


def room(module: str) -> str:
    """Return the folder of a module, in dots."""
    return module if PATHS[module].name == "__init__.py" else module.rpartition(".")[0]


def imports_between_rooms() -> dict[str, set[str]]:
    """Return which folder imports from which; a folder and one inside it are one."""
    graph: dict[str, set[str]] = {}
    for module, others in IMPORTS.items():
        for other in others & PATHS.keys():
            here, there = room(module), room(other)
            if not f"{here}.".startswith(f"{there}.") and not f"{there}.".startswith(f"{here}."):
                graph.setdefault(here, set()).add(there)
    return graph


def part(module: str, house: str) -> str:
    """Return which folder or module directly in ``house`` a module belongs to; empty for what is not in the house."""
    return module.removeprefix(f"{house}.").partition(".")[0] if module.startswith(f"{house}.") else ""


def upward_imports(house: str, floors: tuple[str, ...]) -> list[str]:
    """Return the imports from one part of a house to another that is on the same floor, or on a higher one.

    Parameters
    ----------
    house : a package
    floors : the names of its parts, the lowest floor first; a part that stands on none is found to import upward
    """
    floor = {name: height for height, names in enumerate(floors) for name in names.split()}
    return [
        f"{module} -> {other}"
        for module, others in IMPORTS.items()
        for other in sorted(others & PATHS.keys())
        for here, there in [(part(module, house), part(other, house))]
        if here and there and here != there
        if not floor.get(there, len(floors)) < floor.get(here, -1)
    ]


def classes() -> dict[str, ast.ClassDef]:
    """Return every class by its full name."""
    return {
        f"{module}.{node.name}": node
        for module, tree in TREES.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.ClassDef)
    }
