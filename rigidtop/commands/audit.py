"""``rigidtop audit``: the numbered equations of notes as they are, each with a verdict."""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands.claims import FAILED
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.mark.alike import Alike
    from rigidtop.mark.audit import Audited
    from rigidtop.mark.rows import Row
    from rigidtop.notation import Notation
    from rigidtop.read.document import Formula
    from rigidtop.read.project import Source
    from rigidtop.report.annotated import Formula as Shown
    from rigidtop.report.annotated import Mark

ABOUT = "audit notes in Markdown, LaTeX or a notebook: anyone's, in any letters"

EPILOG = """\
In notes of the collection each numbered equation is judged by the claim of its number.
All other formulas, and anyone's notes in letters of their own, are held against
themselves: a line follows from the lines above it and from Lagrange's equations of the
file's own L, or contradicts them, with numbers; what nothing above speaks of is a
premise, taken as it stands, and not called right.
The exit code is 1 if a formula is false, or if one that has a number is undecided or
unread, else 0 (a convention at odds with a definition is a finding, not a failure).
Numbers of the collection that the file leaves out between its first and its last are
told as absent.

examples:
  rigidtop audit notes.md
  rigidtop audit notes.md -o annotated.html
  rigidtop audit my_course/ my_notes.tex      # against your own collection"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.add_argument(
        "file",
        nargs="+",
        metavar="FILE",
        help="the notes, Markdown with $…$, LaTeX with its \\input files, or a notebook; before it "
        "a folder, if they are to be judged by the collection there",
    )
    parser.add_argument(
        "-o", "--output", metavar="HTML", help="write the notes with verdicts as a page"
    )


def run(options: argparse.Namespace) -> int:
    """Audit the file and print what was found; 0 if nothing is wrong."""
    from rigidtop.collection import built_in, opened

    *folders, name = options.file
    if len(folders) > 1:
        raise RigidtopError(f"one file at a time: {len(options.file)} names are too many")
    if not folders:
        return _run(Path(name), built_in(), options)
    with opened([f"{folders[0]}/"]) as (collection, _):
        return _run(Path(name), collection, options)


def _run(path: Path, collection: Collection, options: argparse.Namespace) -> int:
    from rigidtop.mark.audit import ABSENT, UNREAD, audit, missing
    from rigidtop.mark.rows import rows
    from rigidtop.notation import OWN
    from rigidtop.read.document import SECONDS
    from rigidtop.read.project import habits, sources

    until = time.process_time() + SECONDS
    found = sources(path)
    source = found[0].text
    output = Path(options.output) if options.output else None
    if output is not None and output.resolve() == path.resolve():
        raise RigidtopError(f"{output} is the file that is audited: write the page elsewhere")
    audited = _of_collection(
        audit(source, collection.pages, collection.notation, letters=collection.letters)
    )
    judged = {formula.opens for each in audited for formula in each.group.formulas}
    known = habits(found, OWN, until)
    others = [
        (each, row)
        for each in found
        if each.is_text
        for row in rows(each.text, known, max(until - time.process_time(), 1.0))
        if each is not found[0] or row.opens not in judged
    ]
    unread = _unread(source)
    if not audited and not unread and not others:
        raise RigidtopError(f"{path}: no formulas between dollars or the like that say something")
    absent = [claim.name for claim in missing(audited, collection.pages)]
    told = summary(audited, unread, absent, [row for _, row in others])
    form = _forms(collection, until + SECONDS)
    if output is not None:
        from rigidtop.report.annotated import write
        from rigidtop.terminal.files import write_whole

        page = write(
            path.name,
            source,
            *shown(source, audited, collection.notation),
            told,
            [f"line {line}: unread: {reason}" for line, reason in unread],
        )
        write_whole(output, page.encode())
    if options.json:
        print_json(
            [
                *(record(each) for each in audited),
                *(_bare_record("", line, UNREAD, reason, False) for line, reason in unread),
                *(own_record(row, each, form(row), len(found) > 1) for each, row in others),
                *(_bare_record(name, None, ABSENT, "not in the file", True) for name in absent),
            ]
        )
    else:
        _print(audited, unread, others, form, told)
        if output is not None:
            print(output)
    right = all(each.passed for each in audited) and not any(amiss(row) for _, row in others)
    return 0 if right and not unread else FAILED


def _of_collection(audited: tuple[Audited, ...]) -> tuple[Audited, ...]:
    """What claims speak of: the numbers that they have; none in a file in other letters."""
    known = tuple(each for each in audited if each.judgement is not None)
    foreign = any("no symbol" in placed.ruling.problem for each in known for placed in each.placed)
    return known if any(each.passed for each in known) or not foreign else ()


def amiss(row: Row) -> bool:
    """Whether a formula is refuted, or bears a number and nothing can be said of it."""
    from rigidtop.mark.notes import UNREAD
    from rigidtop.proof.verdict import Verdict

    open_ends = (Verdict.UNDECIDED.value, UNREAD)
    return row.held.verdict == Verdict.FALSE.value or (
        bool(row.number) and row.held.verdict in open_ends
    )


Form = Callable[["Row"], "Alike | None"]
"""Tells the equation of the collection whose form a row has in other letters, if any."""


def _forms(collection: Collection, until: float) -> Form:
    """What compares rows with the collection's numbered equations, up to a time."""
    from rigidtop.mark.alike import alike

    lines = collection.lecture.lines.values()
    claims = [(e.tag, e) for line in lines for e in line.equations if e.tag]

    def form(row: Row) -> Alike | None:
        equation = row.held.line.equation
        late = time.process_time() > until
        return None if equation is None or late else alike(equation, claims)

    return form


def own_record(row: Row, source: Source, form: Alike | None, several: bool) -> dict[str, Any]:
    """What `--json` says of a formula that is held against the file itself."""
    from rigidtop.read.labels import counted, row_of
    from rigidtop.typeset.text import text

    equation = row.held.line.equation
    passed = row.held.passed if row.number or row.held.verdict == "false" else None
    made = _bare_record(row.number, row.line, row.held.verdict, row.held.note, passed)
    named = row_of(counted(source.text), row.held.line.position)
    made["label"] = named.label if named is not None else ""
    made["claim"] = form.name if form is not None else ""
    made["letters"] = form.words if form is not None else ""
    made["from"] = list(row.lines)
    made["equations"] = [
        {
            "line": row.line,
            "column": row.column,
            "read": text(equation, "typed") if equation is not None else None,
            "verdict": row.held.verdict,
            "problem": row.held.line.problem,
        }
    ]
    if several:
        made["file"] = source.path.name
    if source.cells:
        made["cell"], made["line"] = source.place(row.line)
    return made


def _unread(source: str) -> list[tuple[int, str]]:
    """Line and reason of what may be mathematics and was not taken as a formula."""
    from rigidtop.read.document import places, problems

    place = places(source)
    return [
        (place(problem.position)[0], problem.reason)
        for problem in problems(source)
        if not problem.skipped
    ]


def _print(
    audited: Sequence[Audited],
    unread: Sequence[tuple[int, str]],
    others: Sequence[tuple[Source, Row]],
    form: Form,
    told: str,
) -> None:
    from rigidtop.commands.check import VERDICT_COLORS
    from rigidtop.terminal.table import table, wants_color

    colors = None
    if wants_color(sys.stdout):
        colors = {**VERDICT_COLORS, "unread": "red", "unknown": "yellow"}
    found: list[tuple[int, str, str, str]] = [
        (each.line, f"({each.number})", each.verdict, each.note) for each in audited
    ]
    found += [(line, "", "unread", reason) for line, reason in unread]
    found.sort(key=lambda row: row[0])
    of_own = [
        (
            row.line,
            f"({row.number})" if row.number else "",
            row.held.verdict,
            _own_note(row, form(row)),
        )
        for _, row in others
        if row.display or row.number or row.held.passed is False
    ]
    if audited:  # of the collection: only what is wrong is told of the rest
        of_own = [row for row in of_own if row[2] == "false"]
    cells = [[str(line), *more] for line, *more in [*found, *of_own]]
    print(table(cells, ("line", "equation", "verdict", "note"), colors=colors, right=(0,)))
    print()
    print(told)


def _own_note(row: Row, form: Alike | None) -> str:
    lines, note = ", ".join(map(str, row.lines)), row.held.note
    if lines:
        note = f"{note} (from line{'s' * (len(row.lines) > 1)} {lines})"
    return note if form is None else f"{note}; the form of ({form.name}): {form.words}"


def summary(
    audited: Sequence[Audited],
    unread: Sequence[tuple[int, str]] = (),
    absent: Sequence[str] = (),
    others: Sequence[Row] = (),
) -> str:
    """Counts of the verdicts, what is wrong, what became of the formulas that are held against the
    file itself, and which numbers the file does not have."""
    from rigidtop.mark.audit import UNREAD
    from rigidtop.proof.verdict import Verdict

    names = [*(verdict.value for verdict in Verdict), UNREAD]
    counts = [(name, sum(each.verdict == name for each in audited)) for name in names]
    told = ", ".join(f"{count} {name}" for name, count in counts if count)
    wrong = [f"({each.number})" for each in audited if not each.passed]
    wrong += [f"line {line}" for line, _ in unread]
    wrong += [
        f"({row.number})" if row.number else f"line {row.line}" for row in others if amiss(row)
    ]
    what = f"{len(audited)} numbered equation{'s' * (len(audited) != 1)}"
    parts = [f"{what}{': ' * bool(told)}{told}"] if audited or not others else []
    if others:
        parts.append(_counted(others, "other " * bool(audited)))
    last = f"AMISS: {', '.join(wrong)}" if wrong else "nothing is found wrong"
    left_out = f"; not in the file: {', '.join(f'({name})' for name in absent)}" if absent else ""
    return f"{'; '.join([*parts, last])}{left_out}"


def _counted(others: Sequence[Row], which: str) -> str:
    """What became of the formulas that are held against the file itself."""
    verdicts = [row.held.verdict for row in others]
    said = [
        (sum(verdicts.count(v) for v in ("proved", "sampled", "assuming")), "follow"),
        (verdicts.count("false"), "false"),
        (verdicts.count("premise"), "taken as they stand"),
        (verdicts.count("undecided"), "undecided"),
        (verdicts.count("unread"), "unread"),
    ]
    counts = ", ".join(f"{count} {words}" for count, words in said if count)
    return f"{len(others)} {which}formula{'s' * (len(others) != 1)}: {counts}"


def _bare_record(
    name: str, line: int | None, verdict: str, note: str, passed: bool | None
) -> dict[str, object]:
    """What `--json` says where there is no numbered equation; `passed` null: not judged."""
    return {
        "name": name,
        "reference": "",
        "assumptions": [],
        "line": line,
        "verdict": verdict,
        "passed": passed,
        "note": note,
        "equations": [],
    }


def record(each: Audited) -> dict[str, object]:
    """What `--json` says of an equation: what `rigidtop check` does, and its places."""
    from rigidtop.report.records import record as of_judgement
    from rigidtop.typeset.text import text

    made: dict[str, object] = {"name": each.number, "reference": "", "assumptions": []}
    if each.judgement is not None:
        judged = of_judgement(each.judgement)
        made |= {key: judged[key] for key in ("reference", "assumptions")}
    return {
        **made,
        "line": each.line,
        "verdict": each.verdict,
        "passed": each.passed,
        "note": each.note,
        "equations": [
            {
                "line": placed.line,
                "column": placed.column,
                "read": text(placed.equation, "printed") if placed.equation is not None else None,
                "verdict": placed.verdict,
                "problem": placed.ruling.problem,
            }
            for placed in each.placed
        ],
    }


# --- The annotated page --------------------------------------------------------------------------

_LOST = re.compile(r"\((?:t|r|\\mathbf\{\s*r\s*\})\)|\d\s*\\times")
"""What an equation does not keep: that ω depends on t, that 3 × 3 is a shape."""
_OPENING = re.compile(r"(?:\$\$|\$|\\\(|\\\[|\\begin\{\w+\*?\})$")


def shown(
    source: str, audited: Sequence[Audited], notation: Notation
) -> tuple[list[Shown], list[Mark]]:
    """The formulas of the text and the marks beside those with a number."""
    from rigidtop.read.document import SECONDS, formulas
    from rigidtop.report.annotated import Mark

    until = time.process_time() + SECONDS
    marks = []
    for each in audited:
        found = each.group.formulas
        end = found[-1].end
        behind = re.compile(rf"\s*\(\s*{re.escape(each.number)}\s*\)").match(source, end)
        marks.append(
            Mark(
                start=_opening(source, found[0]),
                end=behind.end() if behind else end,
                number=each.number,
                line=each.line,
                verdict=each.verdict,
                passed=each.passed,
                note=each.note,
                formulas=tuple(_whole(source, each)),
            )
        )
    taken = {formula.start for each in audited for formula in each.group.formulas}
    others = [
        _shown(source, each, notation, until)
        for each in formulas(source)
        if each.start not in taken
    ]
    return others, marks


def _whole(source: str, each: Audited) -> list[Shown]:
    """A group as one formula with all its equations; as its sources where one is unread."""
    from rigidtop.report.annotated import Formula

    equations = tuple(placed.equation for placed in each.placed if placed.equation is not None)
    if len(equations) == len(each.placed):
        return [Formula(0, 0, "", equations, display=True)]
    return [Formula(0, 0, formula.text, display=True) for formula in each.group.formulas]


def _opening(source: str, formula: Formula) -> int:
    """Where the dollars, or the like, before a formula begin."""
    first = max(0, formula.start - 24)
    opening = _OPENING.search(source[first : formula.start])
    return first + opening.start() if opening else formula.start


def _shown(source: str, formula: Formula, notation: Notation, until: float) -> Shown:
    """A formula of the text, typeset if it is read, in time, and nothing of it is lost."""
    from rigidtop.read.formula import read
    from rigidtop.report.annotated import Formula as Shown

    text = formula.text.strip()
    late = time.process_time() > until
    trees: tuple[Any, ...] = () if late else tuple(line.equation for line in read(text, notation))
    if not late and (None in trees or not trees):
        # A quantity, without a relation, is what could be equal to 0.
        lines = read(f"0 = {text}", notation) if not re.search(r"[=<>]", text) else ()
        trees = tuple(line.equation and line.equation.sides[1] for line in lines)
    if None in trees or _LOST.search(text):
        trees = ()
    return Shown(_opening(source, formula), formula.end, text, trees, formula.display)
