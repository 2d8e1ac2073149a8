"""The shell: hands every request to the part of the window that answers it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any

from qovr_app.state.intents import Request

Answers = Mapping[type[Request], Callable[[Any], object]]
"""What a part of the window answers, by the kind of request."""


class Shell:
    """Answers requests with the answers of several parts."""

    def __init__(self, *parts: Answers) -> None:
        self._answers = {kind: answer for part in parts for kind, answer in part.items()}

    def perform(self, request: Request) -> None:
        """Answer a request."""
        self._answers[type(request)](request)
