"""How long the tests take."""

import subprocess
import time
from pathlib import Path

import pytest

from support.command import environment


@pytest.mark.long
def test_make_test(record):
    start = time.perf_counter()
    root = Path(__file__).parents[2]
    subprocess.run(["make", "test"], cwd=root, env=environment(), check=True, stdout=subprocess.DEVNULL)
    record("make test", [(time.perf_counter() - start) / 60])
