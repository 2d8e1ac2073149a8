"""The one place where errors raised while painting go: a log record that tests turn into failures."""

from __future__ import annotations

import logging

LOGGER = logging.getLogger("qovr_app.view3d")


def report(error: BaseException, failure: str) -> str:
    """Log an error with its traceback and return one line for the user.

    Parameters
    ----------
    failure : what did not go well, as "OpenGL failed while drawing"
    """
    LOGGER.error(failure, exc_info=error)
    text = " ".join(str(error).split()) or type(error).__name__
    return f"{failure}: {text}"
