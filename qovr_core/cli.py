"""The command line of ``qovr``; nothing here loads Qt."""

from __future__ import annotations

import argparse
import logging
import os
import signal
import sys
from collections.abc import Callable, Sequence
from typing import Any, NoReturn

from qovr_core.commands import compare, export, figures, info, presets, reproduce, verify
from qovr_core.commands.common import DONE, SOURCE_HELP, WRONG
from qovr_core.errors import QovrError
from qovr_core.files.atomic import LOGGER
from qovr_core.version import VERSION

_INTERRUPTED = 130

_COMMANDS = (export, figures, reproduce, verify, compare, presets, info)
"""In the order in which the help lists them."""

Command = Callable[[argparse.Namespace], int]


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line."""

    def error(self, message: str) -> NoReturn:
        raise QovrError(f"{message} (see '{self.prog} --help')")


def main(argv: Sequence[str] | None = None) -> int:
    """Run one headless command and return its exit code."""
    return run(build_parser()[0], argv)


def run(parser: argparse.ArgumentParser, argv: Sequence[str] | None) -> int:
    """Run one of a parser's commands and return its exit code.

    0 done, 1 the answer is no, 2 the call or its input is wrong; errors are one line on stderr.
    """
    _make_streams_robust()
    signal.signal(signal.SIGTERM, _interrupt)
    notices = _Notices(logging.WARNING)
    LOGGER.addHandler(notices)
    try:
        arguments = parser.parse_args(argv)
        command: Command = arguments.command
        code = command(arguments)
        sys.stdout.flush()
        return code
    except QovrError as error:
        return _complain(str(error))
    except MemoryError:
        return _complain("there is not enough memory for this; ask for fewer samples")
    except KeyboardInterrupt:
        _complain("interrupted; no unfinished file is left")
        return _INTERRUPTED
    except BrokenPipeError:
        # The reader has gone, as in "qovr info ... | head": not an error, and nothing may be flushed any more.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return DONE
    except OSError as error:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return _complain(f"the answer cannot be written: {error.strerror}")
    finally:
        LOGGER.removeHandler(notices)


def build_parser() -> tuple[argparse.ArgumentParser, Any]:
    """Return the parser of all headless commands, and the place where others add theirs."""
    parser = _Parser(prog="qovr", description="Quartic Overhauser (QOVR) surfaces.", epilog=SOURCE_HELP)
    parser.add_argument("--version", action="version", version=f"QOVR Studio {VERSION}")
    commands = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for command in _COMMANDS:
        command.add_command(commands)
    return parser, commands


def _interrupt(_signal: int, _frame: object) -> NoReturn:
    raise KeyboardInterrupt


def _make_streams_robust() -> None:
    """Let a file name that is no valid text be printed rather than raise."""
    for stream in (sys.stdout, sys.stderr):
        if hasattr(stream, "reconfigure"):
            stream.reconfigure(errors="backslashreplace")


class _Notices(logging.Handler):
    """Says on stderr what a user ought to know although all went well."""

    def emit(self, record: logging.LogRecord) -> None:
        _say(record.getMessage())


def _complain(text: str) -> int:
    _say(text)
    return WRONG


def _say(text: str) -> None:
    line = "".join(character if character.isprintable() else "?" for character in text)
    print(f"qovr: {line}", file=sys.stderr)
