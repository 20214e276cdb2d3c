"""``rigidtop audit``: the numbered equations of notes as they are, each with a verdict."""

from __future__ import annotations

import argparse
import re
import sys
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from enum import Enum
from pathlib import Path
from typing import TYPE_CHECKING, Any

from rigidtop.commands.claims import FAILED
from rigidtop.commands.output import print_json
from rigidtop.errors import RigidtopError

if TYPE_CHECKING:
    from rigidtop.collection import Collection
    from rigidtop.mark.alike import Alike
    from rigidtop.mark.audited import Audited
    from rigidtop.mark.rows import Row
    from rigidtop.notation import Notation
    from rigidtop.proof.equation import Equation
    from rigidtop.read.macros import Macros
    from rigidtop.read.project import Source
    from rigidtop.read.walk import Formula
    from rigidtop.report.annotated import Formula as Shown
    from rigidtop.report.annotated import Mark
    from rigidtop.typeset.layout import Order

ABOUT = "audit notes in Markdown, LaTeX or a notebook: anyone's, in any letters"

EPILOG = """\
In notes of the collection each numbered equation is judged by the claim of its number.
All other formulas, and anyone's notes in letters of their own, are held against
themselves: a line follows from the lines above it and from Lagrange's equations of the
file's own L, or contradicts them, with numbers; what nothing above speaks of is a
premise, taken as it stands, and not called right.
What is open is told by its reason, with the first places; `--json` has each formula.
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
    from rigidtop.mark.audit import SECONDS, audit
    from rigidtop.mark.audited import missing
    from rigidtop.mark.rows import rows
    from rigidtop.notation import OWN
    from rigidtop.read.document import problems
    from rigidtop.read.project import habits, left_out, sources
    from rigidtop.read.walk import places

    until = time.process_time() + SECONDS

    def left() -> float:
        return max(until - time.process_time(), 0.0)

    found = sources(path)
    source = found[0].text
    output = Path(options.output) if options.output else None
    for each in found:
        if output is not None and _is_same(output, each.path):
            which = "the file that is audited" if each is found[0] else "a file that it takes in"
            raise RigidtopError(f"{output} is {which}: write the page elsewhere")
    pages, notation = collection.pages, collection.notation
    # What the built-in lecture prints has checks of its own.
    lecture = collection.lecture if collection.folder is not None else None
    audited = _of_collection(
        audit(source, pages, notation, None, left(), collection.letters, lecture)
    )
    judged = {formula.opens for each in audited for formula in each.group.formulas}
    known, place, form = habits(found, OWN, until), places(source), _forms(collection, until)
    told = [
        *map(_of_claim, audited),
        *(_of_place(place(p.position)[0], p.reason) for p in problems(source) if not p.skipped),
        *(
            _of_place(places(each.text)(at)[0], reason, each, len(found) > 1)
            for each in found
            for at, reason in left_out(each, found)
        ),
        *(
            _of_file(row, each, len(found) > 1, form(row))
            for each in found
            if each.is_text
            for row in rows(each.text, known, left())
            if each is not found[0] or row.opens not in judged
        ),
    ]
    if not told:
        raise RigidtopError(f"{path}: no formulas between dollars or the like that say something")
    told += [_absent(claim.name) for claim in missing(audited, pages)]
    if output is not None:
        from rigidtop.report.annotated import write
        from rigidtop.terminal.files import write_whole

        unread = [f"{each.place}: unread: {each.note}" for each in told if each.of is Of.PLACE]
        whole = *shown(source, audited, notation, known.macros), summary(told), unread
        write_whole(output, write(path.name, source, *whole).encode())
    if options.json:
        print_json([each.record for each in told])
    else:
        _print(told)
        if output is not None:
            print(output)
    return FAILED if any(each.amiss for each in told) else 0


def _is_same(one: Path, other: Path) -> bool:
    """Whether two names, or a link, are one file."""
    return one.resolve() == other.resolve() or (one.exists() and one.samefile(other))


def _of_collection(audited: tuple[Audited, ...]) -> tuple[Audited, ...]:
    """What claims speak of: the numbers that they have; none in a file in other letters."""
    known = tuple(each for each in audited if each.judgement is not None)
    foreign = any("no symbol" in placed.ruling.problem for each in known for placed in each.placed)
    return known if any(each.passed for each in known) or not foreign else ()


# --- What is told --------------------------------------------------------------------------------


class Of(Enum):
    """What something is told of."""

    CLAIM = "a numbered equation of the collection"
    PLACE = "a place where mathematics is not read"
    FILE = "a formula that is held against the file itself"
    ABSENT = "a number of the collection that is not there"


@dataclass(frozen=True)
class Told:
    """What is said of one thing, in the table, in the summary and by `--json`.

    `passed` is None for what was not judged; `display` says that the table has it in any case.
    """

    of: Of
    name: str
    line: int | None
    verdict: str
    note: str
    passed: bool | None
    amiss: bool = False
    display: bool = True
    more: Mapping[str, Any] = field(default_factory=dict)

    @property
    def place(self) -> str:
        return _label(self.name) or f"line {self.line}"

    @property
    def is_open(self) -> bool:
        """Whether nothing is said against it, only nothing for it."""
        return self.of in (Of.FILE, Of.PLACE) and self.verdict in _OPEN

    @property
    def record(self) -> dict[str, Any]:
        said = {key: getattr(self, key) for key in ("name", "line", "verdict", "passed", "note")}
        return {"reference": "", "assumptions": [], "equations": [], **said, **self.more}

    @property
    def words(self) -> str:
        """The note, with what the line rests on and the form that it has."""
        rests, claim = self.more.get("from", ()), self.more.get("claim", "")
        lines = f"line{'s' * (len(rests) > 1)} {', '.join(map(str, rests))}"
        form = f"; the form of ({claim}): {self.more['letters']}" if claim else ""
        return f"{self.note}{f' (from {lines})' * bool(rests)}{form}"


def _of_claim(each: Audited) -> Told:
    from rigidtop.report.records import record

    equations = [
        _equation((x.line, x.column), x.equation, "printed", x.verdict, x.ruling.problem)
        for x in each.placed
    ]
    more: dict[str, Any] = {"equations": equations}
    if each.judgement is not None:
        judged = record(each.judgement)
        more |= {key: judged[key] for key in ("reference", "assumptions")}
    passed = each.passed
    said = each.number, each.line, each.verdict, each.note, passed, not passed
    return Told(Of.CLAIM, *said, more=more)


def _equation(
    at: tuple[int, int], equation: Equation | None, order: Order, verdict: str, problem: str
) -> dict[str, Any]:
    from rigidtop.typeset.text import text

    read = text(equation, order) if equation is not None else None
    said = {"line": at[0], "column": at[1], "read": read}
    return {**said, "verdict": verdict, "problem": problem}


def _of_place(line: int, reason: str, inside: Source | None = None, several: bool = False) -> Told:
    """A place that is not read; a file that TeX may have elsewhere is told, and not amiss."""
    from rigidtop.mark.audited import UNREAD

    more = {"file": inside.path.name} if inside is not None and several else {}
    return Told(Of.PLACE, "", line, UNREAD, reason, False, amiss=inside is None, more=more)


def _absent(name: str) -> Told:
    from rigidtop.mark.audited import ABSENT

    return Told(Of.ABSENT, name, None, ABSENT, "not in the file", True, display=False)


def _of_file(row: Row, source: Source, several: bool, form: Alike | None) -> Told:
    """A formula, which is amiss if it is refuted, or bears a number and nothing can be said."""
    from rigidtop.read.labels import counted, row_of

    held, line = row.held, row.held.line
    named = row_of(counted(source.text), line.position)
    at, verdict = (row.line, row.column), held.verdict
    more: dict[str, Any] = {
        "label": named.label if named is not None else "",
        "claim": form.name if form is not None else "",
        "letters": form.words if form is not None else "",
        "from": list(row.lines),
        "equations": [_equation(at, line.equation, "typed", verdict, line.problem)],
    }
    if several:
        more["file"] = source.path.name
    if source.cells:
        more["cell"], more["line"] = source.place(row.line)
    numbered, false = bool(row.number), verdict == "false"
    return Told(
        Of.FILE,
        *(row.number, row.line, verdict, held.note, held.passed if numbered or false else None),
        amiss=false or (numbered and verdict in _OPEN),
        display=row.display or numbered or held.passed is False,
        more=more,
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


def _print(told: Sequence[Told]) -> None:
    from rigidtop.commands.check import VERDICT_COLORS
    from rigidtop.terminal.table import paragraph, table, wants_color

    colors = None
    if wants_color(sys.stdout):
        colors = {**VERDICT_COLORS, "unread": "red", "unknown": "yellow"}
    of_claims = any(each.of is Of.CLAIM for each in told)  # then of the rest what is wrong
    told_of = [
        each
        for each in sorted(
            told, key=lambda x: (x.of is Of.FILE, 0 if x.of is Of.FILE else x.line or 0)
        )
        if each.display and (each.of is not Of.FILE or not of_claims or each.verdict == "false")
    ]
    rows = [
        (str(each.line), _label(each.name), each.verdict, each.words)
        for each in told_of
        if not each.is_open
    ]
    print(table(rows, ("line", "equation", "verdict", "note"), colors=colors, right=(0,)))
    alike: dict[tuple[str, str], list[str]] = {}
    for each in told_of:
        if each.is_open:
            why = re.sub(r"\bwhat .+ is$", "what its letters are", each.note)
            alike.setdefault((each.verdict, why), []).append(_label(each.name) or str(each.line))
    reasons = sorted(alike.items(), key=lambda x: -len(x[1]))
    open_rows = [(str(len(at)), verdict, note, _few(at)) for (verdict, note), at in reasons]
    print()
    if open_rows:
        heads = ("", "verdict", "why", "where")
        print(table(open_rows, heads, colors=colors, right=(0,)))
        print()
    print(paragraph(summary(told)))


MOST_WRONG, MOST_OPEN = 40, 6
"""So many are named of what is wrong, and of what is open alike; `--json` has all."""


def _few(names: Sequence[str], most: int = MOST_OPEN) -> str:
    """The first ones, and how many more there are."""
    names = list(dict.fromkeys(names))
    more = len(names) - most
    return ", ".join(names) if more < 2 else f"{', '.join(names[:most])} and {more} more"


def _label(name: str, longest: int = 24) -> str:
    """(3.54), and of the name of a label as much as leaves the notes beside it their room."""
    return f"({name if len(name) <= longest else name[: longest - 1] + '…'})" if name else ""


def summary(told: Sequence[Told]) -> str:
    """Counts of the verdicts, what is wrong, what became of the formulas that are held against the
    file itself, and which numbers the file does not have."""
    of = {kind: [each for each in told if each.of is kind] for kind in Of}
    claims, others = of[Of.CLAIM], of[Of.FILE]
    parts = []
    if claims or not others:
        names = ("proved", "sampled", "assuming", "convention", "false", "definition", "undecided")
        parts = [_counted(claims, "numbered equation", {x: {x} for x in (*names, "unread")})]
    if others:
        what = f"{'other ' * bool(claims)}formula"
        parts.append(_counted(others, what, {**_FOLLOWS, **{x: {x} for x in _OPEN}}))
    wrong = _few([each.place for each in told if each.amiss and not each.is_open], MOST_WRONG)
    left = _few([each.place for each in told if each.amiss and each.is_open])
    absent = ", ".join(each.place for each in of[Of.ABSENT])
    parts.append(f"AMISS: {wrong}" if wrong else "nothing is found wrong")
    others_said = {"to be looked at": left, "not in the file": absent}
    return "; ".join(
        [*parts, *(f"{said}: {which}" for said, which in others_said.items() if which)]
    )


_FOLLOWS = {
    "follow": {"proved", "sampled", "assuming"},
    "false": {"false"},
    "taken as they stand": {"premise"},
}
_OPEN = ("undecided", "unread")


def _counted(told: Sequence[Told], what: str, words: Mapping[str, set[str]]) -> str:
    """How many there are of each verdict: 3 formulas: 2 follow, 1 undecided."""
    counts = [(sum(each.verdict in of for each in told), said) for said, of in words.items()]
    shown = ", ".join(f"{count} {said}" for count, said in counts if count)
    return f"{len(told)} {what}{'s' * (len(told) != 1)}{': ' * bool(shown)}{shown}"


# --- The annotated page --------------------------------------------------------------------------

_LOST = re.compile(r"\((?:t|r|\\mathbf\{\s*r\s*\})\)|\d\s*\\times")
"""What an equation does not keep: that ω depends on t, that 3 × 3 is a shape."""
_OPENING = re.compile(r"(?:\$\$|\$|\\\(|\\\[|\\begin\{\w+\*?\})$")


def shown(
    source: str, audited: Sequence[Audited], notation: Notation, macros: Macros
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
                formulas=tuple(_whole(each, macros)),
            )
        )
    taken = {formula.start for each in audited for formula in each.group.formulas}
    others = [
        _shown(source, each, notation, macros, until)
        for each in formulas(source)
        if each.start not in taken
    ]
    return others, marks


def _whole(each: Audited, macros: Macros) -> list[Shown]:
    """A group as one formula with all its equations; as its sources where one is unread."""
    from rigidtop.report.annotated import Formula
    from rigidtop.report.transcript import transcript

    equations = tuple(placed.equation for placed in each.placed if placed.equation is not None)
    if len(equations) == len(each.placed):
        return [Formula(0, 0, "", equations, display=True)]
    return [
        Formula(0, 0, x.text, display=True, signs=transcript(x.text, macros, display=True))
        for x in each.group.formulas
    ]


def _opening(source: str, formula: Formula) -> int:
    """Where the dollars, or the like, before a formula begin."""
    first = max(0, formula.start - 24)
    opening = _OPENING.search(source[first : formula.start])
    return first + opening.start() if opening else formula.start


def _shown(
    source: str, formula: Formula, notation: Notation, macros: Macros, until: float
) -> Shown:
    """A formula of the text, typeset if it is read, in time, and nothing of it is lost."""
    from rigidtop.read.formula import read
    from rigidtop.report.annotated import Formula as Shown
    from rigidtop.report.transcript import transcript

    text = formula.text.strip()
    late = time.process_time() > until
    trees: tuple[Any, ...] = () if late else tuple(line.equation for line in read(text, notation))
    if not late and (None in trees or not trees):
        # A quantity, without a relation, is what could be equal to 0.
        lines = read(f"0 = {text}", notation) if not re.search(r"[=<>]", text) else ()
        trees = tuple(line.equation and line.equation.sides[1] for line in lines)
    if None in trees or _LOST.search(text):
        trees = ()
    signs = "" if trees else transcript(text, macros, formula.display)
    return Shown(_opening(source, formula), formula.end, text, trees, formula.display, signs)
