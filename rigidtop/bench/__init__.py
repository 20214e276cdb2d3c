"""What the numbers cost, beside what a user would otherwise take."""

from rigidtop.bench.motions import measure
from rigidtop.bench.rows import markdown, records, table

__all__ = ["markdown", "measure", "records", "table"]
