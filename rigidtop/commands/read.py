"""``rigidtop read``: the equations of a file as they are understood, or why one is not."""

from __future__ import annotations

import argparse
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from rigidtop.commands.output import print_json

if TYPE_CHECKING:
    from rigidtop.notation import Notation
    from rigidtop.read.labels import Counted
    from rigidtop.read.macros import Macros
    from rigidtop.read.project import TextFile
    from rigidtop.read.walk import Formula
    from rigidtop.tree.statement import Statement

SECONDS = 60.0
"""A file is not read for longer than this (of the processor's time)."""

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


@dataclass(frozen=True)
class FileEquation:
    """An equation of a file, or what could not be read, and where it stands.

    `statement` is there where its letters are the file's own.
    """

    source: TextFile
    position: int
    number: str = ""
    equation: str | None = None
    condition: str = ""
    problem: str = ""
    label: str = ""
    statement: Statement | None = None


def run(options: argparse.Namespace) -> int:
    """Print each equation as text with its line, or the reason why it is unread; 0 in any case."""
    from rigidtop.notation import named
    from rigidtop.read.project import macros_of, numbers, sources

    until = time.process_time() + SECONDS
    files = sources(options.file)
    notation = None if options.notation == "own" else named(options.notation)
    macros, counts = macros_of(files), numbers(files)
    equations = [
        each
        for source in files
        if source.is_text
        for each in sorted(
            _equations(source, files, notation, macros, counts[source.path], until),
            key=lambda each: each.position,
        )
    ]
    records = _records(equations, files)
    if options.json:
        print_json(records)
    else:
        _print(records)
    return 0


# --- Reading -------------------------------------------------------------------------------------


def _equations(
    source: TextFile,
    files: tuple[TextFile, ...],
    notation: Notation | None,
    macros: Macros,
    rows: Sequence[Counted],
    until: float,
) -> Iterator[FileEquation]:
    """What a file states, and what of it was not taken; `rows` are those that bear a number.

    What comes behind a time of `time.process_time` is unread.
    """
    from dataclasses import replace

    from rigidtop.read.document import bare, formulas, numbered, problems
    from rigidtop.read.labels import row_of
    from rigidtop.read.project import left_out

    text = source.text
    groups = numbered(text)
    beside = {x.start: group.number for group in groups for x in group.formulas}
    lost = [x for group in groups for x in group.formulas if x.problem]
    positions: set[int] = set()
    for formula in (*formulas(text), *lost):
        number = beside.get(formula.start, "")
        if time.process_time() > until:
            yield FileEquation(
                source, formula.start, number, problem="the time for the file was over"
            )
            continue
        read = (
            _in_own_letters(source, formula, macros)
            if notation is None
            else _in_letters_of(source, formula, notation, macros)
        )
        for each in read:
            # A symbol in a sentence is no equation.
            if not (number or formula.display or "=" in formula.text or each.equation):
                continue
            row = row_of(rows, each.position)
            own = number or each.number or (row.number if row is not None else "")
            positions.add(each.position)
            yield replace(each, number=own, label=row.label if row is not None else "")
    for problem in (*problems(text), *bare(text)):
        if problem.position not in positions:
            yield FileEquation(source, problem.position, problem=problem.reason)
    for at, reason in left_out(source, files):
        yield FileEquation(source, at, problem=reason)


def _in_own_letters(source: TextFile, formula: Formula, macros: Macros) -> Iterator[FileEquation]:
    """What a formula states where every letter is one of the file's own."""
    from rigidtop.read.statements import statements
    from rigidtop.tree.plain import plain
    from rigidtop.tree.statement import Unread

    if formula.problem:
        yield FileEquation(source, formula.start, problem=formula.problem)
        return
    for each in statements(formula.text, macros):
        at = formula.start + each.position
        if isinstance(each, Unread):
            yield FileEquation(source, at, each.tag, problem=each.reason)
        elif each.relations or formula.display:
            condition = each.condition or ", ".join(map(plain, each.conditions))
            yield FileEquation(source, at, each.tag, plain(each), condition, statement=each)


def _in_letters_of(
    source: TextFile, formula: Formula, notation: Notation, macros: Macros
) -> Iterator[FileEquation]:
    """What a formula states in the letters of a table."""
    from rigidtop.read.equations import equations
    from rigidtop.typeset.text import text

    if formula.problem:
        yield FileEquation(source, formula.start, problem=formula.problem)
        return
    for line in equations(formula.text, notation, macros):
        equation = text(line.equation, "typed") if line.equation is not None else None
        at = formula.start + line.position
        yield FileEquation(source, at, line.tag, equation, problem=line.problem)


# --- Telling -------------------------------------------------------------------------------------


def _records(equations: Sequence[FileEquation], files: Sequence[TextFile]) -> list[dict[str, Any]]:
    """One object an equation, as ``--json`` has them."""
    from functools import cache

    from rigidtop.read.declared import declared
    from rigidtop.read.roles import roles, words
    from rigidtop.read.walk import places

    place = cache(lambda text: places(text))
    names = words(each for source in files if source.is_text for each in declared(source.text))
    kinds = roles([each.statement for each in equations if each.statement is not None], names)
    records = []
    for each in equations:
        row, column = place(each.source.text)(min(each.position, len(each.source.text)))
        own = roles([each.statement]) if each.statement is not None else {}
        record: dict[str, Any] = {
            "line": row,
            "column": column,
            "number": each.number,
            "label": each.label or None,
            "equation": each.equation,
            "condition": each.condition or None,
            "problem": each.problem or None,
            "letters": {letter: kinds[letter] for letter in own},
        }
        if len(files) > 1:
            record["file"] = each.source.path.name
        if each.source.cells:
            record["cell"], record["line"] = each.source.place(row)
        records.append(record)
    return records


def _print(records: list[dict[str, Any]]) -> None:
    """The same as a table, and what the letters are."""
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
