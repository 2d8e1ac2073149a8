"""The dialogs over joints and nets: what they ask, and what is seen of it meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from PySide6.QtWidgets import QWidget

from qovr_app.state import net_intents
from qovr_app.state.gestures import next_gesture
from qovr_app.state.intents import GestureBegun, GestureCancelled, GestureEnded, Intent
from qovr_app.state.looking_intents import MessageOutdated, MessageShown
from qovr_app.store import Store
from qovr_app.window.shell import Answers
from qovr_app.zones.net_facts import joint_line
from qovr_core.edits import knots_of

if TYPE_CHECKING:
    from qovr_app.dialogs.net_dialogs import NetDialog


class NetShell:
    """Shows in the view what is asked for while it is asked; Cancel puts all back."""

    def __init__(self, store: Store, window: QWidget) -> None:
        self._store, self._window = store, window
        self.answers: Answers = {
            net_intents.JointAsked: self._ask_joint,
            net_intents.ResamplingAsked: self._ask_resampling,
        }

    def _ask_joint(self, asked: net_intents.JointAsked) -> None:
        from qovr_app.dialogs.net_dialogs import CreaseDialog, NetDialog

        direction, joint = asked.direction, asked.joint
        after = (joint + 1) % knots_of(self._store.state.document, direction).windows
        where = f"between the windows {joint} and {after} along {direction.parameter}"
        question = f"The joint {where}, on {joint_line(direction, joint)} of the points,"
        if asked.what is net_intents.Asked.SMOOTH:
            plain = NetDialog("smooth", "Make Smooth", f"{question} becomes smooth.", self._window)
            self._preview(plain, lambda gesture: net_intents.JointSmoothed(direction, joint, gesture))
            return
        dialog = CreaseDialog(f"{question} becomes a crease.", self._window)
        self._preview(dialog, lambda gesture: net_intents.JointCreased(direction, joint, dialog.strength, gesture))

    def _ask_resampling(self, _asked: net_intents.ResamplingAsked) -> None:
        from qovr_app.dialogs.net_dialogs import ResampleDialog

        dialog = ResampleDialog(self._store.state.document.windows, self._window)
        self._preview(dialog, lambda gesture: net_intents.NetResampled(dialog.windows, dialog.is_even, gesture))

    def _preview(self, dialog: NetDialog, intent: Callable[[int], Intent]) -> None:
        """Show what a dialog asks for as one gesture, and how far the surface moves."""
        store, gesture = self._store, next_gesture()

        def show() -> None:
            error = store.dispatch(intent(gesture))
            said = store.state.message
            dialog.say(f"{error}." if error or said is None else said.text, is_refusal=error is not None)

        def end() -> None:
            said = store.state.message
            store.dispatch(GestureEnded(gesture))
            if said is not None:
                store.dispatch(MessageShown(said.text))

        def put_back() -> None:
            store.dispatch(GestureCancelled(gesture))
            store.dispatch(MessageOutdated())

        store.dispatch(GestureBegun(gesture))
        show()
        dialog.changed.connect(show)
        dialog.accepted.connect(end)
        dialog.rejected.connect(put_back)
        dialog.finished.connect(dialog.deleteLater)
        dialog.open()
