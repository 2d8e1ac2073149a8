"""The command ``qovr``."""

from __future__ import annotations

import sys

from qovr_core.cli import main as run_headless


def main() -> None:
    """Run the command line and leave with its exit code."""
    sys.exit(run_headless())
