"""``python -m rigidtop`` is the command ``rigidtop``."""

import sys

from rigidtop.cli import main

if __name__ == "__main__":
    sys.exit(main())
