"""What only the shell can do for the view: the paper's look, the picture under the net, stored views."""

from __future__ import annotations

from dataclasses import dataclass

from qovr_app.state.intents import Request


@dataclass(frozen=True)
class PaperLookAsked(Request):
    """Show the surface as the paper's figures do, from their camera."""


@dataclass(frozen=True)
class UnderlayAsked(Request):
    """Ask for a picture to lie under the net."""


@dataclass(frozen=True)
class UnderlayPlaceAsked(Request):
    """Ask where the picture under the net lies, and how clearly it is seen."""


@dataclass(frozen=True)
class ViewStoreAsked(Request):
    """Ask for a name and store where the view looks from."""


@dataclass(frozen=True)
class SavedViewAsked(Request):
    """Look from a stored view."""

    name: str


@dataclass(frozen=True)
class SavedViewDropped(Request):
    """Forget a stored view."""

    name: str
