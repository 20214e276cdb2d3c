"""A marking as plain values, for JSON."""

from __future__ import annotations

from rigidtop.mark.answer import Marking


def record(found: Marking) -> dict[str, object]:
    """A marking as plain values.

    >>> record(Marking((), True, "3.57"))["summary"]
    'there is no line to mark'
    """
    return {
        "lines": [
            {
                "line": line.line,
                "read": line.said,
                "verdict": line.mark.value,
                "note": line.note,
                "slips": [{"kind": slip.kind, "words": slip.words} for slip in line.slips],
            }
            for line in found.lines
        ],
        "points": found.points[0],
        "of": found.points[1],
        "arrives": found.arrives,
        "lost": list(found.lost),
        "passed": found.passed,
        "summary": found.summary,
    }
