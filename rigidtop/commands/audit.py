"""``rigidtop audit``: notes as they are, each formula with a verdict."""

from __future__ import annotations

import argparse
import re
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from rigidtop.commands.claims import FAILED
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.commands.findings import AuditFinding
    from rigidtop.commands.notes import Notes
    from rigidtop.mark.numbered import Copy
    from rigidtop.read.macros import Macros
    from rigidtop.report.annotated import VerdictSpan

ABOUT = "audit notes in Markdown, LaTeX or a notebook: anyone's, in any letters"

EPILOG = """\
In notes of the collection each numbered equation is judged by the claim of its number.
All other formulas, and anyone's notes in letters of their own, are held against
themselves: a line follows from the lines above it, or contradicts them; what nothing
above speaks of is new, taken as it stands, and not called right.
What is wrong comes first, with the line as it has to be and what it contradicts; what is
open is told by its reason, with the first places; `--json` has each formula.
The exit code is 1 if something is false, else 0: what is open or could not be read is no
failure, with a number or without (nor is a convention at odds with a definition).
Numbers of the collection that the file leaves out between its first and its last are
told as absent.

examples:
  rigidtop audit notes.md
  rigidtop audit notes.md -o annotated.html
  rigidtop audit my_course/ my_notes.tex      # against your own collection"""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add the options of the command to its parser."""
    parser.add_argument(
        "file",
        nargs="+",
        metavar="FILE",
        help="notes, Markdown with $…$, LaTeX with its \\input files, or a notebook; before them "
        "a folder, if they are to be judged by the collection there",
    )
    parser.add_argument(
        "-o", "--output", metavar="HTML", help="write the notes with verdicts as a page"
    )
    parser.add_argument(
        "--format",
        choices=("github", "sarif", "junit"),
        help="print what is found as a code host, an editor or a test runner reads it",
    )
    parser.add_argument(
        "--skip-empty",
        action="store_true",
        help="leave a file without formulas out even if it is the only one, as --format does",
    )


def run(options: argparse.Namespace) -> int:
    """Audit the file and print what was found; 0 if nothing is wrong."""
    from rigidtop.collection import opened

    folders = [name for name in options.file if Path(name).is_dir()]
    files = [Path(name) for name in options.file if name not in folders]
    if not files:
        raise RigidtopError(f"{folders[0]} is a collection, no notes: these stand behind it")
    if len(folders) > 1:
        raise RigidtopError(f"one collection at a time: {' and '.join(folders)} are two")
    if len(files) > 1 and (options.json or options.output):
        asked = "--json" if options.json else "--output"
        raise RigidtopError(f"one file at a time with {asked}: {len(files)} names are too many")
    with opened([f"{folder}/" for folder in folders]) as (collection, _):
        return _run(files, collection, options)


def _run(paths: Sequence[Path], collection: Collection, options: argparse.Namespace) -> int:
    from rigidtop.commands.formats import FORMATS

    output = Path(options.output) if options.output else None
    skipping = len(paths) > 1 or options.format or options.skip_empty
    wanted = options.json or output is not None or not skipping
    audits = [*_audits(paths, output, collection, wanted=wanted)]
    if output is not None:
        from rigidtop.terminal.files import write_whole

        write_whole(output, _page(audits[0]).encode())
    if options.json:
        print_json([each.record for each in audits[0].findings])
    elif options.format:
        print(FORMATS[options.format](audits))
    else:
        for k, notes in enumerate(audits):
            if len(paths) > 1:
                print(f"{notes.source.path}\n" if k == 0 else f"\n{notes.source.path}\n")
            tell(notes.findings)
        if output is not None:
            print(output)
    return FAILED if any(notes.is_wrong for notes in audits) else 0


def _audits(
    paths: Sequence[Path], output: Path | None, collection: Collection, *, wanted: bool
) -> Iterator[Notes]:
    """The notes of each file; unless formulas are `wanted`, a file without any is left out."""
    from rigidtop.commands.notes import NoFormulasError, audited
    from rigidtop.read.project import sources

    for path in paths:
        files = sources(path)
        for each in files:
            if output is not None and _is_same(output, each.path):
                which = (
                    "the file that is audited" if each is files[0] else "a file that it takes in"
                )
                raise RigidtopError(f"{output} is {which}: write the page elsewhere")
        try:
            yield audited(files, collection)
        except NoFormulasError:
            if wanted:
                raise


def _page(notes: Notes) -> str:
    """The notes with verdicts beside their formulas, as HTML."""
    from rigidtop.commands.annotation import others
    from rigidtop.commands.findings import summary
    from rigidtop.report.annotated import write

    source, findings, macros = notes.source.text, notes.findings, notes.macros
    marks = [*_of_claims(source, notes.copies, macros), *_wrong(source, findings, macros)]
    beside = [f"{x.title}: {x.verdict}: {_why(x)}" for x in findings if _is_beside(x)]
    formulas = others(source, marks, macros)
    return write(notes.source.path.name, source, formulas, marks, summary(findings), beside)


def _is_same(one: Path, other: Path) -> bool:
    """Whether two names, or a link, are one file."""
    return one.resolve() == other.resolve() or (one.exists() and one.samefile(other))


# --- The terminal --------------------------------------------------------------------------------

MOST_OPEN = 6
"""So many places are named of what is open alike; `--json` has all."""

MOST_AGAINST = 3
"""So many lines are quoted of those that something wrong contradicts, the last ones."""


def tell(findings: Sequence[AuditFinding]) -> None:
    """What is wrong, what is known of the other formulas, what is open and why, the counts."""
    from rigidtop.commands.check import VERDICT_COLORS
    from rigidtop.commands.findings import Of, label, summary
    from rigidtop.terminal.table import paragraph, table, wants_color

    colors = None
    if wants_color(sys.stdout):
        colors = {**VERDICT_COLORS, "unread": "red", "unknown": "yellow"}
    for each in findings:
        if each.is_wrong:
            print(f"{_quoted(each)}\n")
    of_claims = any(each.of is Of.CLAIM for each in findings)  # then the rest is only counted
    others = [
        each
        for each in findings
        if (each.display or each.is_open)
        and not each.is_wrong
        and not (of_claims and each.of is Of.FILE)
    ]
    rows = [
        (str(each.place).removeprefix("line "), label(each.name), each.verdict, each.words)
        for each in others
        if not each.is_open
    ]
    if rows:
        print(table(rows, ("line", "equation", "verdict", "note"), colors=colors, right=(0,)))
        print()
    alike: dict[tuple[str, str], list[str]] = {}
    for each in others:
        if each.is_open:
            places = alike.setdefault((each.verdict, each.note), [])
            places.append(label(each.name) or str(each.place).removeprefix("line "))
    reasons = sorted(alike.items(), key=lambda x: -len(x[1]))
    open_rows = [(str(len(at)), verdict, note, _few(at)) for (verdict, note), at in reasons]
    if open_rows:
        heads = ("", "verdict", "why", "where")
        print(table(open_rows, heads, colors=colors, right=(0,)))
        print()
    print(paragraph(summary(findings)))


def _quoted(each: AuditFinding) -> str:
    """What is wrong in lines: as it is written, as it has to be, what it contradicts."""
    from rigidtop.terminal.table import paragraph
    from rigidtop.terminal.visible import visible

    against = [f"{place}: {formula}" for place, formula in each.against[-MOST_AGAINST:]]
    more = len(each.against) - len(against)
    parts = [
        ("written", each.written),
        ("right", each.right),
        *(("against" if not k else "", quote) for k, quote in enumerate(against)),
        ("", f"and {more} more above" if more else ""),
    ]
    lines = [paragraph(visible(f"{each.title} is wrong: {each.note}"), "", "  ")]
    lines += [paragraph(visible(text), f"  {head:<9}", " " * 11) for head, text in parts if text]
    return "\n".join(lines)


def _few(names: Sequence[str], most: int = MOST_OPEN) -> str:
    """The first ones, and how many more there are."""
    names = list(dict.fromkeys(names))
    more = len(names) - most
    return ", ".join(names) if more < 2 else f"{', '.join(names[:most])} and {more} more"


# --- The annotated page --------------------------------------------------------------------------


def _of_claims(source: str, audited: Sequence[Copy], macros: Macros) -> Iterator[VerdictSpan]:
    """The numbered equations of the collection."""
    from rigidtop.commands.annotation import framed
    from rigidtop.report.annotated import VerdictSpan

    for each in audited:
        formulas = each.group.formulas
        frames = tuple(framed(formula, macros) for formula in formulas)
        end = formulas[-1].end
        behind = re.compile(rf"\s*\(\s*{re.escape(each.number)}\s*\)").match(source, end)
        yield VerdictSpan(
            start=frames[0].start,
            end=behind.end() if behind else end,
            number=each.number,
            line=each.lines[0].row.line,
            verdict=each.verdict,
            passed=each.passed,
            note=f"{each.note}; right: {each.right}" if each.right else each.note,
            formulas=frames,
        )


def _wrong(source: str, findings: Sequence[AuditFinding], macros: Macros) -> Iterator[VerdictSpan]:
    """The formulas of the file itself of which something is wrong."""
    from rigidtop.commands.annotation import framed
    from rigidtop.read.document import formulas
    from rigidtop.report.annotated import VerdictSpan

    for formula in formulas(source):
        wrong = [x for x in findings if x.is_wrong and x.formula == formula.start]
        if wrong:
            first = wrong[0]
            drawn = framed(formula, macros)
            yield VerdictSpan(
                start=drawn.start,
                end=formula.end,
                number=first.name,
                line=first.place.line if first.place is not None else 0,
                verdict=first.verdict,
                passed=False,
                note="; ".join(map(_why, wrong)),
                formulas=(drawn,),
            )


def _why(each: AuditFinding) -> str:
    return f"{each.note}; right: {each.right}" if each.right else each.note


def _is_beside(each: AuditFinding) -> bool:
    """Whether it is told on top of the page, since it is no formula of its text."""
    from rigidtop.commands.findings import Of

    return each.of is Of.PLACE or (each.of is Of.FILE and each.is_wrong and each.formula < 0)
