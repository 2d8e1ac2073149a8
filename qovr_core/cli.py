"""The command line of ``qovr``; nothing here loads Qt."""

from __future__ import annotations

import argparse
import logging
import sys
from collections.abc import Callable, Mapping, Sequence
from typing import Any, NoReturn

from qovr_core.commands.common import DONE, SOURCE_HELP, WRONG
from qovr_core.errors import QovrError, reason_of
from qovr_core.files.atomic import LOGGER
from qovr_core.later import later
from qovr_core.streams import Interrupted, forsake, interruptible, mend_streams, say
from qovr_core.version import VERSION

SIGNALLED = 128
"""Exit codes after a signal are this and its number: 130 after Ctrl-C, 143 after SIGTERM."""

Command = Callable[[argparse.Namespace], int]

AddCommand = Callable[[Any], None]
"""Called with the place of a parser for its commands, it adds one."""

COMMANDS: Mapping[str, AddCommand] = {
    name: later(f"qovr_core.commands.{name}", "add_command")
    for name in ("export", "figures", "reproduce", "verify", "compare", "presets", "info", "desktop")
}
"""The headless commands by name, in the order in which the help lists them."""


class _Parser(argparse.ArgumentParser):
    """A parser whose errors are one line, and whose options are written out."""

    def __init__(self, *arguments: Any, **options: Any) -> None:
        super().__init__(*arguments, **{"allow_abbrev": False, **options})

    def error(self, message: str) -> NoReturn:
        raise QovrError(f"{message} (see '{self.prog} --help')")

    def _print_message(self, message: str, file: Any = None) -> None:
        print(message, end="", file=file)  # argparse would keep silent where that fails


def main(argv: Sequence[str] | None = None) -> int:
    """Run one headless command and return its exit code."""
    return run(COMMANDS, sys.argv[1:] if argv is None else argv)


def run(commands: Mapping[str, AddCommand], argv: Sequence[str]) -> int:
    """Run one of some commands and return its exit code; what only the others need is not imported.

    0 done, 1 the answer is no, 2 the call or its input is wrong, 130 and 143 after Ctrl-C and SIGTERM; errors are one
    line on stderr.
    """
    mend_streams()
    notices = _Notices(logging.WARNING)
    LOGGER.addHandler(notices)
    try:
        with interruptible() as raise_interrupt:
            return _exit_code(commands, argv, raise_interrupt)
    except Interrupted as interrupt:
        say("interrupted; no unfinished file is left")
        return SIGNALLED + interrupt.number
    finally:
        LOGGER.removeHandler(notices)


def _parser_of(commands: Mapping[str, AddCommand]) -> argparse.ArgumentParser:
    parser = _Parser(prog="qovr", description="Quartic Overhauser (QOVR) surfaces.", epilog=SOURCE_HELP)
    parser.add_argument("--version", action="version", version=f"QOVR Studio {VERSION}")
    place = parser.add_subparsers(title="commands", metavar="COMMAND", required=True)
    for add_command in commands.values():
        add_command(place)
    return parser


def _exit_code(commands: Mapping[str, AddCommand], argv: Sequence[str], raise_interrupt: Callable[[], None]) -> int:
    """Run a command; whatever ends it is said in one line."""
    try:
        code = _answer(commands, argv, raise_interrupt)
        sys.stdout.flush()
    except BrokenPipeError:
        forsake(sys.stdout)  # the reader has gone, as in "qovr info ... | head": no error
        return DONE
    except QovrError as error:
        say(str(error))
    except MemoryError:
        say("there is not enough memory for this; ask for fewer samples")
    except OSError as error:
        forsake(sys.stdout)
        what = "the answer cannot be written" if error.filename is None else f"{error.filename}: cannot be used"
        say(f"{what}: {reason_of(error)}")
    except Exception as error:
        import traceback

        place = traceback.extract_tb(error.__traceback__)[-1]
        say(f"an error of the program: {type(error).__name__}: {reason_of(error)} ({place.name}, line {place.lineno})")
    else:
        return code
    return WRONG


def _answer(commands: Mapping[str, AddCommand], argv: Sequence[str], raise_interrupt: Callable[[], None]) -> int:
    called = {name: commands[name] for name in argv[:1] if name in commands}
    try:
        arguments = _parser_of(called or commands).parse_args(argv)
        command: Command = arguments.command
        return command(arguments)
    except SystemExit as end:  # after --help and --version
        return int(end.code or DONE)
    except Exception:
        raise_interrupt()
        raise


class _Notices(logging.Handler):
    """Says on stderr what a user ought to know although all went well."""

    def emit(self, record: logging.LogRecord) -> None:
        say(record.getMessage())
