"""Tests of the window fail on what would otherwise pass in silence."""

from __future__ import annotations

import logging
import sys
from collections.abc import Iterator

import pytest


@pytest.fixture
def logged_errors() -> list[logging.LogRecord]:
    """The errors that the program has logged: those raised while painting or in a worker."""
    return []


@pytest.fixture
def silenced(logged_errors: list[logging.LogRecord]) -> list[logging.LogRecord]:
    """The errors that were logged, for tests that provoke them: there they are no failures."""
    return logged_errors


@pytest.fixture(autouse=True)
def _nothing_is_swallowed(
    qt_messages: list[str], logged_errors: list[logging.LogRecord], request: pytest.FixtureRequest
) -> Iterator[None]:
    """Fail a test on Qt warnings, on errors that are logged, and on exceptions in slots."""
    logger = logging.getLogger("qovr_app")
    raised: list[str] = []
    handler = logging.Handler(logging.ERROR)
    handler.emit = logged_errors.append
    hook, sys.excepthook = sys.excepthook, lambda kind, error, _: raised.append(f"{kind.__name__}: {error}")
    logger.addHandler(handler)
    qt_messages.clear()
    yield
    if "app" in request.fixturenames:
        request.getfixturevalue("app").processEvents()
    sys.excepthook = hook
    logger.removeHandler(handler)
    assert raised == []
    if "silenced" not in request.fixturenames:
        formatter = logging.Formatter()
        assert [formatter.format(record) for record in logged_errors] == []
        assert qt_messages == []
