"""Data of QOVR Studio, installed as ``qovr_resources`` and found the same way from a checkout and a wheel."""
