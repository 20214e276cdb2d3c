"""Where the reference is found."""

import sys
from pathlib import Path

# The modules of the reference are scripts too, so they import each other by their bare names.
sys.path.insert(0, str(Path(__file__).parent / "reference"))
