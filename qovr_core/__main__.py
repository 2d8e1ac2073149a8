"""``python -m qovr_core``: the commands that need no window."""

import sys

from qovr_core.cli import main

if __name__ == "__main__":
    sys.exit(main())
