"""``python -m rigidtop.codegen`` rewrites `rigidtop/motion/equations.py` from the theory.

With ``--check`` nothing is written: the exit code is 1 if the module is not what the theory gives.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from rigidtop.codegen import shipped
from rigidtop.terminal.files import write_whole


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    parser = argparse.ArgumentParser("python -m rigidtop.codegen", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether it is current")
    options = parser.parse_args(arguments)
    path, text = shipped.PATH, shipped.module_text()
    current = path.exists() and path.read_text("utf-8") == text
    if options.check and not current:
        print(f"{path} is not what the theory gives: run python -m rigidtop.codegen")
        return 1
    if not current:
        write_whole(path, text.encode())
    print(f"{path} is current" if current else f"{path} rewritten")
    return 0


if __name__ == "__main__":
    sys.exit(main())
