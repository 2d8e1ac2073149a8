"""``python -m qovr_app``: the same as ``qovr``."""

from qovr_app.main import main

if __name__ == "__main__":
    main()
