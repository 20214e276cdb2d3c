"""``rigidtop audit``: the numbered equations of notes as they are, each with a verdict."""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands.claims import FAILED
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError
from rigidtop.textfile import text_of

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.mark.audit import Audited
    from rigidtop.notation import Notation
    from rigidtop.present.annotated import Formula as Shown
    from rigidtop.present.annotated import Mark
    from rigidtop.read.document import Formula

ABOUT = "audit the numbered equations of notes in Markdown or LaTeX"


def add_options(parser: argparse.ArgumentParser) -> None:
    """What can be asked."""
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.epilog = (
        "Each numbered equation of the file is read and judged by the claim of that number.\n"
        "The exit code is 0 if every one was read and is as right as `rigidtop check` finds the\n"
        "lecture's own (a convention at odds with a definition is a finding, not a failure), and\n"
        "1 if one is false, undecided, unread, or has a number that no claim has.  Numbers of the\n"
        "collection that the file leaves out between its first and its last are told as absent.\n"
        "Formulas without a number are not judged, only counted.\n\n"
        "examples:\n"
        "  rigidtop audit notes.md\n"
        "  rigidtop audit notes.md -o annotated.html\n"
        "  rigidtop audit my_course/ my_notes.tex      # against your own collection"
    )
    parser.add_argument(
        "file",
        nargs="+",
        metavar="FILE",
        help="the notes, Markdown with $…$ or LaTeX; before it a folder, if they are to be judged "
        "by the collection there",
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
    source = text_of(path)
    output = Path(options.output) if options.output else None
    if output is not None and output.resolve() == path.resolve():
        raise RigidtopError(f"{output} is the file that is audited: write the page elsewhere")
    from rigidtop.mark.audit import ABSENT, UNJUDGED, UNREAD, audit, missing, unjudged
    from rigidtop.read.document import places

    audited = audit(source, collection.pages, collection.notation, letters=collection.letters)
    unread = _unread(source)
    if not audited and not unread:
        raise RigidtopError(
            f"{path}: no numbered equations; a number is \\tag{{3.57}}, or (3.57) behind a formula"
        )
    absent = [claim.name for claim in missing(audited, collection.pages)]
    place = places(source)
    others = [place(position)[0] for position in unjudged(source, audited)]
    told = summary(audited, unread, absent, len(others))
    if output is not None:
        from rigidtop.present.annotated import write
        from rigidtop.present.files import write_whole

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
                *(_bare_record("", line, UNJUDGED, "without a number", None) for line in others),
                *(_bare_record(name, None, ABSENT, "not in the file", True) for name in absent),
            ]
        )
    else:
        _print(audited, unread, told)
        if output is not None:
            print(output)
    return 0 if not unread and all(each.passed for each in audited) else FAILED


def _unread(source: str) -> list[tuple[int, str]]:
    """Line and reason of what may be mathematics and was not taken as a formula."""
    from rigidtop.read.document import places, problems

    place = places(source)
    return [
        (place(problem.position)[0], problem.reason)
        for problem in problems(source)
        if not problem.skipped
    ]


def _print(audited: Sequence[Audited], unread: Sequence[tuple[int, str]], told: str) -> None:
    from rigidtop.commands.check import VERDICT_COLORS
    from rigidtop.present.table import table, wants_color

    colors = None
    if wants_color(sys.stdout):
        colors = {**VERDICT_COLORS, "unread": "red", "unknown": "yellow"}
    found = [(each.line, f"({each.number})", each.verdict, each.note) for each in audited]
    found += [(line, "", "unread", reason) for line, reason in unread]
    rows = [[str(line), *others] for line, *others in sorted(found, key=lambda row: row[0])]
    print(table(rows, ("line", "equation", "verdict", "note"), colors=colors, right=(0,)))
    print()
    print(told)


def summary(
    audited: Sequence[Audited],
    unread: Sequence[tuple[int, str]] = (),
    absent: Sequence[str] = (),
    others: int = 0,
) -> str:
    """Counts of the verdicts, what is wrong, how many formulas `others` are not judged for want of
    a number, and which numbers the file does not have."""
    from rigidtop.mark.audit import UNKNOWN, UNREAD
    from rigidtop.proof.verdict import Verdict

    names = [*(verdict.value for verdict in Verdict), UNREAD, UNKNOWN]
    counts = [(name, sum(each.verdict == name for each in audited)) for name in names]
    told = ", ".join(f"{count} {name}" for name, count in counts if count)
    amiss = [f"({each.number})" for each in audited if not each.passed]
    amiss += [f"line {line}" for line, _ in unread]
    last = []
    if amiss:
        last.append(f"AMISS: {', '.join(amiss)}")
    if others:
        formulas = f"{others} formulas without a number were" if others > 1 else _ONE_OTHER
        last.append(f"{formulas} not judged")
    if not last:
        last.append("nothing is wrong that the collection gets right")
    left_out = f"; not in the file: {', '.join(f'({name})' for name in absent)}" if absent else ""
    what = f"{len(audited)} numbered equation{'s' * (len(audited) != 1)}"
    return f"{what}{': ' * bool(told)}{told}; {'; '.join(last)}{left_out}"


_ONE_OTHER = "1 formula without a number was"


def _bare_record(
    name: str, line: int | None, verdict: str, note: str, passed: bool | None
) -> dict[str, Any]:
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


def record(each: Audited) -> dict[str, Any]:
    """What `--json` says of an equation: what `rigidtop check` does, and its places."""
    from rigidtop.present.records import record as of_judgement
    from rigidtop.present.text import text

    made: dict[str, Any] = {"name": each.number, "reference": "", "assumptions": []}
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
    from rigidtop.present.annotated import Mark
    from rigidtop.read.document import SECONDS, formulas

    until = time.monotonic() + SECONDS
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
    from rigidtop.present.annotated import Formula

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
    from rigidtop.present.annotated import Formula as Shown
    from rigidtop.read.formula import read

    text = formula.text.strip()
    late = time.monotonic() > until
    trees: tuple[Any, ...] = () if late else tuple(line.equation for line in read(text, notation))
    if not late and (None in trees or not trees):
        # A quantity, without a relation, is what could be equal to 0.
        lines = read(f"0 = {text}", notation) if not re.search(r"[=<>]", text) else ()
        trees = tuple(line.equation and line.equation.sides[1] for line in lines)
    if None in trees or _LOST.search(text):
        trees = ()
    return Shown(_opening(source, formula), formula.end, text, trees, formula.display)
