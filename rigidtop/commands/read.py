"""``rigidtop read``: the equations of a file as they are understood, or why one is not."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING, Any

from rigidtop.commands.output import print_json

if TYPE_CHECKING:
    from rigidtop.notation import Notation
    from rigidtop.read.formula import Line
    from rigidtop.read.habits import Habits
    from rigidtop.read.labels import Counted
    from rigidtop.read.project import Source

ABOUT = "read the equations of anyone's notes, and say which are not understood"


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "file", metavar="FILE", help="Markdown with $…$, LaTeX with its \\input files, a notebook"
    )
    parser.add_argument(
        "--notation",
        default="own",
        metavar="NAME|FILE",
        help="what the letters are: notes, goldstein, … or a table in TOML; without it every "
        "letter is one of the file's own",
    )


def run(options: argparse.Namespace) -> int:
    """Print each equation as text with its line, or the reason why it is unread; 0 in any case."""
    from rigidtop.notation import OWN, named
    from rigidtop.read.document import SECONDS
    from rigidtop.read.project import habits, numbers, sources

    until = time.process_time() + SECONDS
    found = sources(options.file)
    notation = OWN if options.notation == "own" else named(options.notation)
    known = habits(found, notation, until)
    counts = numbers(found)
    rows = [
        (source, *row)
        for source in found
        if source.is_text
        for row in _lines(source, found, notation, known, until, counts[source.path])
    ]
    records = _records(rows, known, len(found) > 1)
    if options.json:
        print_json(records)
    else:
        _print(records)
    return 0


def _lines(
    source: Source,
    sources: tuple[Source, ...],
    notation: Notation,
    habits: Habits,
    until: float,
    rows: Sequence[Counted],
) -> Iterator[tuple[int, int, str, str, Line]]:
    """Line and column, number, label and equation, of what a file has, and of what was not taken.

    `rows` are those that bear a number.
    """
    from rigidtop.read.document import bare, each, grouped, problems
    from rigidtop.read.formula import Line
    from rigidtop.read.labels import row_of
    from rigidtop.read.project import left_out
    from rigidtop.read.walk import places

    text = source.text
    found = [
        (group.number, line)  # a symbol in a sentence is no equation
        for group, lines in each(grouped(text), notation, until - time.process_time(), habits)
        for line in lines
        if line.equation is not None
        or group.number
        or any(formula.display or "=" in formula.text for formula in group.formulas)
    ]
    told = {line.position for _, line in found if line.problem}
    found += [
        ("", Line(problem.position, None, problem.reason))
        for problem in (*problems(text), *bare(text))
        if problem.position not in told
    ]
    found += [("", Line(at, None, reason)) for at, reason in left_out(source, sources)]
    place = places(text)
    for number, line in sorted(found, key=lambda row: row[1].position):
        row = row_of(rows, line.position)
        number = number or line.tag or (row.number if row is not None else "")
        label = row.label if row is not None else ""
        yield (*place(min(line.position, len(text))), number, label, line)


def _records(
    rows: list[tuple[Source, int, int, str, str, Line]], habits: Habits, several: bool
) -> list[dict[str, object]]:
    from rigidtop.read.look import products
    from rigidtop.typeset.letters import is_letter, roles
    from rigidtop.typeset.text import letter, text

    known = roles(
        [line.equation for *_, line in rows if line.equation is not None],
        {glyph: spoken.role for glyph, spoken in habits.said.items()},
    )
    for glyph, spoken in habits.said.items():  # what the file itself says of its letters
        if letter(glyph) in known:
            known[letter(glyph)] += f"; line {spoken.line}: {spoken.words}"
    for _, row, *_, line in rows:
        first = line.equation.sides[0] if line.equation is not None else None
        if line.equation is not None and line.equation.relation == "≡" and is_letter(first):
            known[letter(first.quantity.glyph)] += f"; defined in line {row}"
    made = []
    for source, row, column, number, label, line in rows:
        own = roles([line.equation]) if line.equation is not None else {}
        written = source.text[line.position : line.position + 200].split("$")[0]
        multiplied = {
            run: "a product: each a letter of this file"
            for run in products(written, habits.letters)
            if line.equation is not None
        }
        record = {
            "line": row,
            "column": column,
            "number": number,
            "label": label or None,
            "equation": text(line.equation, "typed") if line.equation is not None else None,
            "condition": line.condition or None,
            "problem": line.problem or None,
            "letters": {letter: known[letter] for letter in own} | multiplied,
        }
        if several:
            record["file"] = source.path.name
        if source.cells:
            record["cell"], record["line"] = source.place(row)
        made.append(record)
    return made


def _print(records: list[dict[str, Any]]) -> None:
    from rigidtop.terminal.table import table

    rows = [
        [
            "".join(f"{record[key]}:" for key in ("file", "cell") if key in record)
            + f"{record['line']}:{record['column']}",
            f"({record['number']})" if record["number"] else "",
            (record["equation"] or f"unread: {record['problem']}")
            + (f"   [{record['condition']}]" if record["condition"] else ""),
        ]
        for record in records
    ]
    print(table(rows, ("line", "number", "equation")) or "no equation found")
    letters = {letter: role for record in records for letter, role in record["letters"].items()}
    if letters:
        print("\nletters that no table has")
        print(table([[letter, letters[letter]] for letter in sorted(letters)]))
