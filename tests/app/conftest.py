"""Tests of the window fail on what would otherwise pass in silence."""

from __future__ import annotations

import logging
import sys
from collections.abc import Iterator

import pytest


@pytest.fixture
def painting_errors() -> list[logging.LogRecord]:
    """The errors raised while painting."""
    return []


@pytest.fixture
def silenced(painting_errors: list[logging.LogRecord]) -> list[logging.LogRecord]:
    """The errors raised while painting, for tests that provoke them: there they are no failures."""
    return painting_errors


@pytest.fixture(autouse=True)
def _nothing_is_swallowed(
    qt_messages: list[str], painting_errors: list[logging.LogRecord], request: pytest.FixtureRequest
) -> Iterator[None]:
    """Fail a test on Qt warnings, on errors while painting, and on exceptions in slots."""
    from qovr_app.view3d.failures import LOGGER

    raised: list[str] = []
    handler = logging.Handler(logging.ERROR)
    handler.emit = painting_errors.append
    hook, sys.excepthook = sys.excepthook, lambda kind, error, _: raised.append(f"{kind.__name__}: {error}")
    LOGGER.addHandler(handler)
    qt_messages.clear()
    yield
    if "app" in request.fixturenames:
        request.getfixturevalue("app").processEvents()
    sys.excepthook = hook
    LOGGER.removeHandler(handler)
    assert raised == []
    if "silenced" not in request.fixturenames:
        formatter = logging.Formatter()
        assert [formatter.format(record) for record in painting_errors] == []
        assert qt_messages == []
