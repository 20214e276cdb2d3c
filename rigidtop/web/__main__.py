"""``python -m rigidtop.web`` rewrites the page's `equations.js` from the theory.

With ``--check`` nothing is written: the exit code is 1 if the module is not what the theory gives.
"""

from __future__ import annotations

import sys
from collections.abc import Sequence

from rigidtop.terminal.files import rewrite
from rigidtop.web.equations import PATH, module_text


def main(words: Sequence[str]) -> int:
    """Run the command; returns the exit code."""
    return rewrite("python -m rigidtop.web", __doc__, PATH, module_text(), words)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
