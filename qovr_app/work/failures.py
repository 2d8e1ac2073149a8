"""How a job ends when it does not end well."""

from __future__ import annotations

import logging
import pickle
from collections.abc import Callable
from typing import Any

from qovr_core import QovrError
from qovr_core.errors import reason_of

LOGGER = logging.getLogger("qovr_app.work")


class CancelledJobError(BaseException):
    """Raised by ``report`` to end a job that was cancelled; no ``except Exception`` on the way can swallow it."""


class WorkError(QovrError):
    """A job ended for a reason that is not its own: no memory, an error of the program, a process that was killed."""


def failure_of(function: Callable[..., Any], error: BaseException) -> QovrError:
    """Return what to tell of an error that ended a job; what nobody expected is logged with its traceback."""
    if isinstance(error, QovrError):
        return error if _goes_through_a_pipe(error) else WorkError(str(error))
    if isinstance(error, OSError):
        place = f"{error.filename}: " if error.filename else ""
        return WorkError(f"{place}{reason_of(error)}")
    if isinstance(error, MemoryError):
        return WorkError("There is not enough memory for so many points; choose fewer samples")
    name = getattr(function, "__qualname__", repr(function))
    LOGGER.error("error in %s", name, exc_info=error)
    text = " ".join(str(error).split())
    return WorkError(f"An error of the program ended the work: {type(error).__name__}{text and ': '}{text}")


def _goes_through_a_pipe(error: QovrError) -> bool:
    try:
        return type(pickle.loads(pickle.dumps(error))) is type(error)
    except Exception:  # whatever a foreign error's own way of being pickled raises
        return False
