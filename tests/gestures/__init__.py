"""What a hand can do in the window: one record for each gesture, with what has to be so after it.

``tests/app/editor/test_gestures.py`` does them all in one window; with ``QOVR_PICTURES=FOLDER`` each leaves its picture
there, taken in the middle of the gesture.
"""

from . import buttons, drags, fields, keys, presses, several
from .gesture import Gesture

GESTURES: tuple[Gesture, ...] = tuple(
    gesture for module in (presses, drags, buttons, keys, several, fields) for gesture in module.TABLE.gestures
)
