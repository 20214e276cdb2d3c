"""``rigidtop read``: the equations of a file as they are understood, or why one is not."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

from rigidtop.commands.output import print_json
from rigidtop.textfile import text_of

if TYPE_CHECKING:
    from rigidtop.read.formula import Line

ABOUT = "read the equations of notes in Markdown or LaTeX, and say which are not understood"


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument("file", metavar="FILE", help="the notes, Markdown with $…$ or LaTeX")


def run(options: argparse.Namespace) -> int:
    """Print each equation as text with its line, or the reason why it is unread; 0 in any case."""
    source = text_of(options.file)
    from rigidtop.present.table import table
    from rigidtop.read.document import bare, each_numbered, places, problems
    from rigidtop.read.formula import Line

    groups = list(each_numbered(source))
    inside = {formula.start for group, _ in groups for formula in group.formulas}
    found = [(group.number, line) for group, lines in groups for line in lines]
    found += _besides(source, inside)
    told = {line.position for _, line in found if line.problem}
    found += [
        ("", Line(problem.position, None, problem.reason))
        for problem in (*problems(source), *bare(source))
        if problem.position not in told
    ]
    records = [_record(source, *row) for row in sorted(found, key=lambda row: row[1].position)]
    place = places(source)
    for record in records:
        record["line"], record["column"] = place(record.pop("position"))
    if options.json:
        print_json(records)
        return 0
    rows = [
        [
            f"{record['line']}:{record['column']}",
            f"({record['number']})" if record["number"] else "",
            record["equation"] or f"unread: {record['problem']}",
        ]
        for record in records
    ]
    print(table(rows, ("line", "number", "equation")) or "no equation found")
    return 0


def _besides(source: str, inside: set[int]) -> list[tuple[str, Line]]:
    """The equations that bear no number; a symbol in a sentence is none."""
    from rigidtop.read.document import each

    return [
        ("", line)
        for formula, lines in each(source)
        if formula.start not in inside
        for line in lines
        if line.equation is not None or formula.display or "=" in formula.text
    ]


def _record(source: str, number: str, line: Line) -> dict[str, Any]:
    from rigidtop.present.text import text

    return {
        "position": min(line.position, len(source)),
        "number": number or line.tag,
        "equation": text(line.equation) if line.equation is not None else None,
        "problem": line.problem or None,
    }
