"""Commands from their call to their end, the interpreter's start included."""

import subprocess
import sys

import pytest

from support.command import QOVR, environment


def test_verify(measure):
    measure("verify command", command("verify", "paper:fig5"), rounds=2)


def test_compare(measure):
    measure("compare command", command("compare", "paper:fig5"), rounds=2)


def test_info(measure):
    numpy = [sys.executable, "-c", "import numpy"]
    measure("info", command("info", "paper:fig5"), lambda: subprocess.run(numpy, check=True), rounds=5)


@pytest.mark.parametrize("suffix", [".step", ".qovr"])
def test_export(measure, tmp_path, suffix):
    export = command("export", "paper:fig5", str(tmp_path / f"out{suffix}"))
    measure(f"export {suffix}", export, command("info", "paper:fig5"), rounds=5)


def command(*arguments):
    """Return a call that runs a command."""
    return lambda: subprocess.run([QOVR, *arguments], check=True, stdout=subprocess.DEVNULL, env=environment())
