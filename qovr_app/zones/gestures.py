"""Drags of fields, sliders and headings, as intents."""

from __future__ import annotations

from typing import Protocol

from PySide6.QtCore import SignalInstance

from qovr_app.state.intents import GestureBegun, GestureCancelled, GestureEnded
from qovr_app.store import Dispatch


class Dragged(Protocol):
    """What is dragged, and says when; each signal has the gesture number."""

    gesture_begun: SignalInstance
    gesture_ended: SignalInstance
    gesture_cancelled: SignalInstance


def dispatch_gestures(dragged: Dragged, dispatch: Dispatch) -> None:
    """Let one drag be one step, and what is put back be as if it had never been."""
    dragged.gesture_begun.connect(lambda gesture: dispatch(GestureBegun(gesture)))
    dragged.gesture_ended.connect(lambda gesture: dispatch(GestureEnded(gesture)))
    dragged.gesture_cancelled.connect(lambda gesture: dispatch(GestureCancelled(gesture)))
