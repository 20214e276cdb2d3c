"""What the numbers cost, beside what a user would otherwise take."""

from rigidtop.bench.motions import measure
from rigidtop.bench.rows import figure, markdown, records, table

__all__ = ["figure", "markdown", "measure", "records", "table"]
