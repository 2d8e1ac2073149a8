"""Commands from their call to their end, the interpreter's start included."""

import subprocess

from support.command import QOVR, environment


def test_verify(measure):
    measure("verify command", command("verify", "paper:fig5"), rounds=2)


def test_compare(measure):
    measure("compare command", command("compare", "paper:fig5"), rounds=2)


def command(*arguments):
    """Return a call that runs a command."""
    return lambda: subprocess.run([QOVR, *arguments], check=True, stdout=subprocess.DEVNULL, env=environment())
