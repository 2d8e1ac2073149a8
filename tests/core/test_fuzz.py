"""Damaged files of every kind that is read, at random by a seed: ``make fuzz`` does so for hours."""

import json
import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

import pytest

from qovr_core.files import readable_suffixes
from support import fuzzing

SECONDS = float(os.environ.get("QOVR_FUZZ_SECONDS", "4"))
SEED = int(os.environ.get("QOVR_FUZZ_SEED", "1"))


@pytest.mark.skipif(sys.platform != "linux", reason="memory is limited as Linux does")
def test_every_damaged_file_is_a_document_or_one_short_line(tmp_path):
    environment = {**os.environ, "PYTHONPATH": os.pathsep.join([str(Path(fuzzing.__file__).parents[1]), *sys.path])}
    call = [sys.executable, "-W", "error", fuzzing.__file__, str(tmp_path), str(SECONDS), str(SEED)]
    done = subprocess.run(call, capture_output=True, text=True, check=False, env=environment)
    if done.returncode != 0:
        kept = Path(f"build/fuzz-{SEED}-{time.time():.0f}")
        shutil.copytree(tmp_path, kept)
        pytest.fail(f"the last file in {kept} ended the reader ({done.returncode}): {done.stderr[-3000:]}")
    assert done.stderr == ""
    counts = json.loads(done.stdout)
    print(counts)
    assert set(counts) == set(readable_suffixes())
    assert min(counts.values()) > 0
