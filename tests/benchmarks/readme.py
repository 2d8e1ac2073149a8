"""Bring the newest results into the README: its table of speed, and the picture of how cost grows.

    cd tests && ../.venv/bin/python -m benchmarks.readme

after ``make bench`` and ``make bench-long``, whose results lie in ``build``.
"""

import json
import shutil
from pathlib import Path

from . import table

ROOT = Path(__file__).parents[2]
BEGIN, END = "<!-- speed -->\n", "<!-- end of speed -->"

KEYS = (
    "out/matmul 1001",
    "raw/copy 1001",
    "splipy 1001",
    "scipy 1001",
    "scipy grid 1001",
    "splipy net 2500",
    "box ridge 1001",
    "box ridge 4096",
    "frame",
    "edit/orbit 101",
    "bare mesh 1001",
    "stock mesh 1001",
    "pyvista mesh 1001",
    "stock 1001",
    "panels hidden wall",
    "panels open wall",
    "frames beside",
    "net first frame",
    "start",
    "info",
    "write .obj",
    "growth resident",
)
"""What a reader of the README wants to know; the others are printed by ``make bench``."""


def main():
    found = {each["key"]: table.Result(**each) for each in json.loads((ROOT / "build/benchmarks.json").read_text())}
    readme = ROOT / "README.md"
    before, rest = readme.read_text(encoding="utf-8").split(BEGIN)
    _, after = rest.split(END)
    lines = table.markdown([found[key] for key in KEYS if key in found])
    if (ROOT / "build/cost.png").exists():
        shutil.copy(ROOT / "build/cost.png", ROOT / ".github/cost.png")
        lines += ["", "![Four panels, both axes logarithmic, a slope beside each line](.github/cost.png)"]
    readme.write_text(before + BEGIN + "\n".join(lines) + "\n" + END + after, encoding="utf-8")
    print("not measured:", ", ".join(key for key in KEYS if key not in found) or "none")


if __name__ == "__main__":
    main()
