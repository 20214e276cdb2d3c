"""``python -m rigidtop.web`` rewrites the page's `equations.js` from the theory.

With ``--check`` nothing is written: the exit code is 1 if the module is not what the theory gives.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence

from rigidtop.terminal.files import write_whole
from rigidtop.web.equations import PATH, module_text


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command; returns the exit code."""
    parser = argparse.ArgumentParser("python -m rigidtop.web", description=__doc__)
    parser.add_argument("--check", action="store_true", help="only say whether it is current")
    options = parser.parse_args(arguments)
    text = module_text()
    current = PATH.exists() and PATH.read_text("utf-8") == text
    if options.check and not current:
        print(f"{PATH} is not what the theory gives: run python -m rigidtop.web")
        return 1
    if not current:
        write_whole(PATH, text.encode())
    print(f"{PATH} is current" if current else f"{PATH} rewritten")
    return 0


if __name__ == "__main__":
    sys.exit(main())
