"""Distances between what stands beside or below one another."""

from __future__ import annotations

SPACE = 4
"""The grid of which every distance in the panels is a multiple, in logical pixels."""
