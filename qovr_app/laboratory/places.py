"""Where the laboratory can be wanted, in words."""

from __future__ import annotations

from qovr_app.state.display import LaboratoryPlace

PLACES = {
    LaboratoryPlace.AUTO: "Where there is &room",
    LaboratoryPlace.RIGHT: "At the r&ight",
    LaboratoryPlace.BELOW: "&Below the view",
    LaboratoryPlace.FLOATING: "In a &window of its own",
}
"""What menus say, with the mark of the access key."""
