"""The directions that have a name, for the editor's view and the paper's figures."""

from __future__ import annotations

NAMED_VIEWS = {
    "paper": (-54.0, 64.0),
    "top": (-90.0, 90.0),
    "bottom": (-90.0, -90.0),
    "front": (-90.0, 0.0),
    "rear": (90.0, 0.0),
    "left": (180.0, 0.0),
    "right": (0.0, 0.0),
    "isometric": (-45.0, 35.26438968),
}
"""Azimuth, from the x axis, and elevation in degrees, by name. The paper's is MATLAB's view(36, 64), which counts
azimuth from -y: 36 - 90. The isometric one sees three axes at equal angles."""
