"""Functions that the tests' jobs run: found by their names in another process as well."""

import ctypes
import logging
import os
import sys
import time
from pathlib import Path

import numpy as np

from qovr_core import DocumentError, Formulation, QovrError
from qovr_core.files.atomic import replacing


def add(a, b, report):
    return a + b


def count_to(n, report):
    for k in range(n):
        report(k, k * k)
    return n


def report_until_cancelled(report):
    while True:
        report("again")
        time.sleep(0.005)


def write_until_cancelled(path, report):
    with replacing(path) as (draft,):
        draft.write_text("half")
        while True:
            report(str(draft))
            time.sleep(0.005)


def write_and_sleep(path, report):
    """Write half a file, and then never report."""
    with replacing(path) as (draft,):
        draft.write_text("half")
        report(str(draft))
        time.sleep(600)


def compute_for_ever(report):
    """One call of native code that nobody can interrupt."""
    report(os.getpid())
    np.linalg.svd(np.random.default_rng(1).random((20_000, 20_000), dtype=np.float32))


def fail_with(kind, report):
    errors = {
        "document": DocumentError("samples", "1", "2 to 4096"),
        "strange": StrangeError("a", "b"),
        "memory": MemoryError(),
        "bug": ZeroDivisionError("division by nothing"),
        "exit": SystemExit(3),
    }
    raise errors[kind]


class StrangeError(QovrError):
    """An error that does not survive being pickled."""

    def __init__(self, one, two):
        super().__init__(f"{one} and {two}")


def return_what_cannot_travel(report):
    return lambda: 0


def report_what_cannot_travel(report):
    report(lambda: 0)


class Unreadable:
    """What goes into a pipe, and does not come out of it."""

    def __reduce__(self):
        return _refuse_to_be, ()


def _refuse_to_be():
    raise ArithmeticError("it cannot be put together again")


def return_what_cannot_be_read(report):
    return Unreadable()


def print_a_lot(report):
    print("nothing that belongs into an answer")
    os.write(1, b"nor this\n")
    sys.stdout.flush()
    return "answered"


def crash(report):
    ctypes.string_at(0)


def modules(report):
    return sorted(sys.modules)


def environment(report):
    from qovr_core.geometry import grid

    pid = os.getpid()
    nice = os.nice(0) if hasattr(os, "nice") else None
    return {"pid": pid, "nice": nice, "grid": grid._threads(), "path": sys.path, "folder": str(Path.cwd())}


def evaluated(document, report):
    from qovr_core import configure

    return np.asarray(configure(document).raw)


def notice(text, report):
    logging.getLogger("qovr_core.files").warning("%s", text)


def size_of(values, report):
    return len(values)


def names_of(module, table, report):
    from importlib import import_module

    return list(getattr(import_module(module), table))


def heights_upside_down(surface, u, v, beside):
    return -np.asarray(surface.points(u, v))[..., 2]


def values_of(document, field, report):
    from qovr_core import configure

    axis = np.linspace(0, 1, 5)
    return field.values(configure(document).transformed_patch, axis, axis, None)


def doubled(net, row_knots, column_knots):
    return 2 * Formulation.INTERPOLATING.build(net, row_knots, column_knots)


def write_formulation(evaluation, path, progress, options):
    with replacing(path) as (draft,):
        draft.write_text(f"{evaluation.document.formulation} {os.getpid()}")
    progress(1.0)
