"""Times are measured by the benchmarks, never by a test; and where the reference is found."""

import sys
from pathlib import Path

from hypothesis import settings

# The same examples in every run: what lands has passed what is run again.
settings.register_profile("untimed", deadline=None, derandomize=True)
settings.load_profile("untimed")

# The modules of the reference are scripts too, so they import each other by their bare names.
sys.path.insert(0, str(Path(__file__).parent / "reference"))
