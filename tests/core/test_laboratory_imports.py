"""What the laboratory loads, and when."""

import subprocess
import sys

HEAVY = {"scipy", "contourpy", "matplotlib"}

IMPORT_ALL = """
import importlib, pkgutil, sys
import qovr_core.laboratory as laboratory
for module in pkgutil.iter_modules(laboratory.__path__):
    importlib.import_module(f"qovr_core.laboratory.{module.name}")
print(*{name.split(".")[0] for name in sys.modules})
"""


def test_no_module_of_the_laboratory_loads_heavy_libraries_before_they_are_used():
    loaded = subprocess.run(
        [sys.executable, "-c", IMPORT_ALL], capture_output=True, text=True, check=True
    ).stdout.split()
    assert "qovr_core" in loaded
    assert not HEAVY & set(loaded)
