"""Notes audited, answers marked, slips named."""
