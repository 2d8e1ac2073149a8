"""What a frame of a drag allocates: little, and nothing that grows with the document's samples."""

import tracemalloc

import pytest
from PySide6.QtWidgets import QApplication

from qovr_app.state.display import LayerChoice, Style
from qovr_core.edits import set_point, set_samples
from support.view import change

SLACK = 64 * 1024
"""Bytes: what the sampled box looks up depends on where its extremes lie."""

LIMITS = {Style.FACETS: 1_400_000, Style.SMOOTH: 540_000}
"""Bytes that a frame takes at most: most are points of 201 x 201 facets for their colours, and what hides marks."""


def allocated(view, document):
    """Return the largest memory, in bytes, that an edit with its frame takes on top of what is held before it."""
    found = []
    for k in range(6):
        tracemalloc.start()
        change(view, document=set_point(document, 2, 2, (2.0, 2.0, 0.5 + 0.01 * k)), dragging=True)
        view.viewports[0].image()
        QApplication.processEvents()
        found.append(tracemalloc.get_traced_memory()[1])
        tracemalloc.stop()
    return min(found[2:])


@pytest.mark.parametrize("style", LIMITS)
def test_a_drag_takes_no_more_memory_where_there_are_more_samples(make_view, document, style):
    few, many = (set_samples(document, (count, count)) for count in (201, 4096))
    view = make_view(few, layer=LayerChoice.TRANSFORMED, style=style).view
    at_few, at_many = allocated(view, few), allocated(view, many)
    assert abs(at_many - at_few) < SLACK
    assert max(at_few, at_many) < LIMITS[style]
