"""What is typed and not set, as the document that it would make."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress

from qovr_app.state.typed_numbers import typed_number
from qovr_core import Document, DocumentError, edits
from qovr_core.edits import Place


def with_typed(draft: Document, texts: Mapping[Place, str]) -> Document:
    """Return a draft with every number that is typed over it.

    A text that says no number, or none that its place may hold, is no work that could be kept: it is left out.
    """
    for place, text in texts.items():
        value = typed_number(text)
        if isinstance(value, float):
            with suppress(DocumentError):
                draft = edits.set_values(draft, {place: value})
    return draft
