"""``rigidtop bench`` from the repository: the table on the screen, and with a plot into a folder.

Run ``python tests/benchmarks/motions.py [FOLDER]``; FOLDER (default: out) gets ``bench.txt``,
``bench.json`` and ``bench.png``.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from rigidtop import bench


def main(folder: Path) -> None:
    rows = bench.measure()
    table = bench.table(rows)
    print(table)
    folder.mkdir(parents=True, exist_ok=True)
    (folder / "bench.txt").write_text(table + "\n", "utf-8")
    (folder / "bench.json").write_text(json.dumps(bench.records(rows), indent=2) + "\n", "utf-8")
    bench.figure(rows).savefig(folder / "bench.png", dpi=150)


if __name__ == "__main__":
    main(Path(sys.argv[1] if len(sys.argv) > 1 else "out"))
