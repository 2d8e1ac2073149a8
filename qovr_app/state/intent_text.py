"""The text form of intents, which reads back: a session of clicks can be written down, sent, and replayed.

One line of JSON an intent: ``{"is": "PointsMoved", "indices": [[2, 3]], ...}``. Whatever is inside is written the same
way: a dataclass by its name and fields, a choice by its kind and value, a mapping by its pairs.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path
from typing import Any

from qovr_app.state import (
    display,
    field_intents,
    intents,
    knot_intents,
    looking_intents,
    net_intents,
    point_intents,
    requests,
    tools,
    view_requests,
)
from qovr_app.state.intents import Intent
from qovr_core import Document, edits, net_edits, net_moves, symmetry
from qovr_core.errors import DocumentError
from qovr_core.files.qovr_document import document_from_json, document_to_json
from qovr_core.geometry import nodes

_KIND, _VALUE = "is", "value"

_INTENTS = intents, field_intents, knot_intents, looking_intents, net_intents, point_intents, requests
_MODULES = *_INTENTS, view_requests, display, tools, edits, nodes, net_edits, net_moves, symmetry

_KINDS: dict[str, Any] = {
    name: kind
    for module in _MODULES
    for name, kind in vars(module).items()
    if isinstance(kind, type) and (is_dataclass(kind) or issubclass(kind, Enum))
}
"""Everything that can stand in an intent, by its name."""


def intent_text(intent: Intent) -> str:
    """Return an intent as one line of text."""
    return json.dumps(_written(intent))


def intent_of(text: str) -> Intent:
    """Return the intent that a text stands for.

    Raises
    ------
    DocumentError : the text stands for none
    """
    try:
        intent = _read(json.loads(text))
    except (ValueError, KeyError, TypeError) as error:
        raise DocumentError("the intent", repr(text[:60]), "the text form of an intent") from error
    if not isinstance(intent, Intent):
        raise DocumentError("the intent", repr(text[:60]), "the text form of an intent")
    return intent


def _written(value: Any) -> Any:
    """Return a value as JSON holds it: the first of the ways that fits."""
    return next((write(value) for fits, write in _WRITERS if fits(value)), value)


_WRITERS: tuple[tuple[Callable[[Any], bool], Callable[[Any], Any]], ...] = (
    (
        lambda value: isinstance(value, Document),
        lambda value: {_KIND: "Document", _VALUE: json.loads(document_to_json(value))},
    ),
    (lambda value: isinstance(value, Path), lambda value: {_KIND: "Path", _VALUE: str(value)}),
    (lambda value: isinstance(value, Enum), lambda value: {_KIND: type(value).__name__, _VALUE: value.value}),
    (
        is_dataclass,
        lambda value: {
            _KIND: type(value).__name__,
            **{field.name: _written(getattr(value, field.name)) for field in fields(value)},
        },
    ),
    (
        lambda value: isinstance(value, Mapping),
        lambda value: {_KIND: "Mapping", _VALUE: [[_written(key), _written(entry)] for key, entry in value.items()]},
    ),
    (lambda value: isinstance(value, tuple), lambda value: [_written(entry) for entry in value]),
)
"""What is no plain JSON, and how it is written."""


def _read(value: Any) -> Any:
    if isinstance(value, list):
        return tuple(_read(entry) for entry in value)
    if not isinstance(value, dict):
        return value
    name = value[_KIND]
    if name in _READERS:
        return _READERS[name](value[_VALUE])
    kind = _KINDS[name]
    if issubclass(kind, Enum):
        return kind(value[_VALUE])
    return kind(**{key: _read(entry) for key, entry in value.items() if key != _KIND})


_READERS: dict[str, Callable[[Any], Any]] = {
    "Document": lambda value: document_from_json(json.dumps(value)),
    "Path": Path,
    "Mapping": lambda pairs: {_read(key): _read(entry) for key, entry in pairs},
}
