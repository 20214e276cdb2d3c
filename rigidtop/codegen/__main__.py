"""``python -m rigidtop.codegen`` rewrites `rigidtop/motion/equations.py` from the theory.

With ``--check`` nothing is written: the exit code is 1 if the module is not what the theory gives.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from rigidtop.codegen import shipped
from rigidtop.terminal.files import rewrite


def main(words: Sequence[str]) -> int:
    """Run the command; returns the exit code."""
    return rewrite(
        "python -m rigidtop.codegen", __doc__, shipped.PATH, shipped.module_text(), words
    )


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
