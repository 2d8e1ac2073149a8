"""The one place where errors raised while painting go: a log record that tests turn into failures."""

from __future__ import annotations

import logging

LOGGER = logging.getLogger("qovr_app.view3d")

_LONGEST = 160
"""Characters of an error's own text in the line for the user; the log has all of it."""


def report(error: BaseException, failure: str) -> str:
    """Log an error with its traceback and return one line for the user.

    Parameters
    ----------
    failure : what did not go well, as "OpenGL failed while drawing"
    """
    LOGGER.error(failure, exc_info=error)
    text = " ".join(str(error).split())[:_LONGEST] or type(error).__name__
    return f"{failure}: {text}"


def report_fault(error: BaseException) -> str:
    """Log an error of the program itself and return the line that says it as that."""
    return report(error, "An error of this program kept the view from being drawn; the next change tries again")
