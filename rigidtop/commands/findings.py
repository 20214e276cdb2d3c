"""What an audit says of each thing in a file, as records, as words and as counts."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from enum import Enum
from functools import cache, lru_cache
from typing import TYPE_CHECKING, Any

from rigidtop.judge.outcome import DEFINITION, FALSE, PREMISE, UNDECIDED, UNREAD

if TYPE_CHECKING:
    from rigidtop.judge.outcome import Outcome
    from rigidtop.judge.text import Row
    from rigidtop.mark.numbered import Copy
    from rigidtop.proof.page import Claim
    from rigidtop.read.project import TextFile, Whole
    from rigidtop.tree.statement import Statement, Unread


class Of(Enum):
    """The kind of thing that a finding is about."""

    CLAIM = "a numbered equation of the collection"
    PLACE = "a place where mathematics is not read"
    FILE = "a formula that is held against the file itself"
    ABSENT = "a number of the collection that is not there"


@dataclass(frozen=True)
class FilePlace:
    """A line, in a file where there are several, or in a cell of a notebook."""

    line: int
    file: str = ""
    cell: int = 0

    def __str__(self) -> str:
        inside = f"cell {self.cell}, " if self.cell else ""
        return f"{self.file}{', ' * bool(self.file)}{inside}line {self.line}"

    @property
    def short(self) -> int | str:
        """The place as the record has it: 3, ch.tex:3, or 2:3 in the second cell."""
        inside = self.file or (str(self.cell) if self.cell else "")
        return f"{inside}:{self.line}" if inside else self.line

    @property
    def record(self) -> dict[str, Any]:
        more = {"file": self.file, "cell": self.cell}
        return {"line": self.line, **{key: value for key, value in more.items() if value}}


@dataclass(frozen=True)
class AuditFinding:
    """What is said of one thing.

    `passed` is None where it neither follows nor is wrong; `display` says that a table has it in
    any case.  `written` is the formula as it was read, `right` as it has to be, `against` are
    formulas that it rests on or contradicts, each with its place.  `formula` is where the formula
    begins in the file that was named; -1 for what is not there.  `rows` are the statements of which
    it is said, as they were judged.
    """

    of: Of
    name: str
    place: FilePlace | None
    verdict: str
    note: str
    passed: bool | None
    display: bool = True
    written: str = ""
    right: str = ""
    against: tuple[tuple[FilePlace, str], ...] = ()
    formula: int = -1
    rows: tuple[Row, ...] = ()
    more: Mapping[str, Any] = field(default_factory=dict)

    @property
    def is_wrong(self) -> bool:
        return self.passed is False

    @property
    def is_open(self) -> bool:
        """Whether nothing is said against it, only nothing for it."""
        return self.of in (Of.FILE, Of.PLACE) and self.verdict in (UNDECIDED, UNREAD)

    @property
    def title(self) -> str:
        """Where it stands and its number: line 3 (7)."""
        return " ".join(filter(None, [str(self.place or ""), label(self.name)]))

    @property
    def record(self) -> dict[str, Any]:
        place = self.place.record if self.place is not None else {"line": None}
        record = {key: getattr(self, key) for key in ("name", "verdict", "passed", "note")}
        lines = list(dict.fromkeys(place.short for place, _ in self.against))
        of_claim: dict[str, Any] = {"reference": "", "assumptions": [], "equations": []}
        return {**of_claim, **record, **place, "from": lines, **self.more}

    @property
    def words(self) -> str:
        """The note, with the places from which the formula follows."""
        places = dict.fromkeys(str(place) for place, _ in self.against) if self.passed else ()
        rests = f"from {', '.join(places)}" if places else ""
        if len(places) > 1 and all(place.startswith("line ") for place in places):
            rests = f"from lines {', '.join(place.removeprefix('line ') for place in places)}"
        return f"{self.note} ({rests})" if self.note and rests else self.note or rests


def label(name: str, longest: int = 24) -> str:
    """(3.54), and of the name of a label as much as leaves the notes beside it their room."""
    return f"({name if len(name) <= longest else name[: longest - 1] + '…'})" if name else ""


# --- What is found -------------------------------------------------------------------------------


def of_claim(each: Copy, place: Placing) -> AuditFinding:
    """What becomes of a numbered equation of the collection."""
    from rigidtop.report.records import record

    more: dict[str, Any] = {
        "slip": "; ".join(filter(None, (line.outcome.slip for line in each.lines))),
        "right": each.right,
        "equations": [_equation(x.row, x.outcome, place) for x in each.lines],
    }
    if each.judgement is not None:
        judged = record(each.judgement)
        more |= {key: judged[key] for key in ("reference", "assumptions")}
    wrong = [_in_words(x.row.statement) or "" for x in each.lines if not x.as_good]
    return AuditFinding(
        Of.CLAIM,
        each.number,
        place(each.lines[0].row.position)[0],
        each.verdict,
        each.note,
        each.passed or (False if each.verdict == FALSE else None),
        written=", ".join(filter(None, wrong)),
        right=each.right,
        rows=tuple(replace(x.row, outcome=x.outcome) for x in each.lines),
        more=more,
    )


def _equation(row: Row, outcome: Outcome, place: Placing) -> dict[str, Any]:
    """The record of a statement; what was read is None where it was not."""
    at, column = place(row.position)
    problem = outcome.why if outcome.verdict in (UNDECIDED, UNREAD) else ""
    record = {"read": _in_words(row.statement), "verdict": outcome.verdict, "problem": problem}
    return {"line": at.line, "column": column, **record}


def of_place(line: int, reason: str, file: str = "") -> AuditFinding:
    """The finding about a place where mathematics is not read."""
    return AuditFinding(Of.PLACE, "", FilePlace(line, file), UNREAD, reason, None)


def absent(claim: Claim) -> AuditFinding:
    return AuditFinding(
        Of.ABSENT, claim.name, None, "absent", "not in the file", None, display=False
    )


Placing = Callable[[int], tuple[FilePlace, int]]
"""What tells the line and the column of a position in the files that belong together."""


def placing(whole: Whole, top: TextFile) -> Placing:
    from rigidtop.read.walk import places

    line_of = cache(lambda source: places(source.text))
    several = any(part.source is not top for part in whole.parts)

    def place(position: int) -> tuple[FilePlace, int]:
        source, start = whole.origin(position)
        line, column = line_of(source)(start)
        if source.cells:
            cell, line = source.place(line)
            return FilePlace(line, cell=cell), column
        return FilePlace(line, source.path.name if several else ""), column

    return place


def of_rows(
    rows: Sequence[Row], above: Sequence[Row], whole: Whole, top: TextFile
) -> Iterator[AuditFinding]:
    """What becomes of some statements of the files that belong together, in order.

    `above` are all of them.
    """
    place, named = placing(whole, top), {row.number: row for row in above}
    names = _names(rows, whole.text)
    for row in rows:
        outcome = row.outcome
        source, start = whole.origin(row.passage.start)
        others = [named[number] for number in sorted(outcome.rests_on) if number in named]
        yield AuditFinding(
            Of.FILE,
            names[row.number],
            place(row.position)[0],
            *(outcome.verdict, outcome.why, outcome.passed),
            display=row.display or bool(names[row.number]) or outcome.passed is False,
            written=_in_words(row.statement) or "",
            right=_right(outcome.right),
            against=tuple((place(x.position)[0], _in_words(x.statement) or "") for x in others),
            formula=start if source is top else -1,
            rows=(row,),
            more={
                "label": names[row.number],
                "slip": outcome.slip,
                "right": _right(outcome.right),
                "equations": [_equation(row, outcome, place)],
            },
        )


@lru_cache(maxsize=5_000)
def _in_words(statement: Statement | Unread) -> str | None:
    from rigidtop.tree.plain import plain
    from rigidtop.tree.statement import Unread

    return None if isinstance(statement, Unread) else plain(statement)


def _right(tex: str) -> str:
    """A formula in LaTeX as plain text; as it is where it can't be read."""
    from rigidtop.read.statements import statements

    read = [_in_words(each) for each in statements(tex)] if tex else []
    return ", ".join(filter(None, read)) if None not in read else tex


def _names(rows: Sequence[Row], text: str) -> dict[int, str]:
    """The number that each row bears, or the name of its label."""
    from rigidtop.read.document import numbered
    from rigidtop.read.labels import LABEL, counted, row_of

    tags = {formula.start: x.number for x in numbered(text) for formula in x.formulas[-1:]}
    bearing = counted(text)
    last = {row.passage.start: row.number for row in rows}
    names = {}
    for row in rows:
        start, is_last = row.passage.start, last[row.passage.start] == row.number
        row_in_display = row_of(bearing, row.position)
        name = row.statement.tag or (tags.get(start, "") if is_last else "")
        if not name and row_in_display is not None:
            name = row_in_display.label
        if not name and is_last and row_in_display is None:
            written = LABEL.search(text, start, start + len(row.passage.text))
            name = written[1] if written else ""
        names[row.number] = name
    return names


# --- Counts --------------------------------------------------------------------------------------

_OF_CLAIMS = ("proved", "sampled", "assuming", "convention", "false", "definition", "undecided")


def summary(findings: Sequence[AuditFinding]) -> str:
    """How many formulas there are, with how many of them anything was compared, what is wrong."""
    of = {kind: [each for each in findings if each.of is kind] for kind in Of}
    parts = []
    if of[Of.CLAIM]:
        verdicts = [each.verdict for each in of[Of.CLAIM]]
        counts = [(verdicts.count(x), x) for x in (*_OF_CLAIMS, UNREAD, "unknown")]
        counted = ", ".join(f"{count} {verdict}" for count, verdict in counts if count)
        parts.append(f"{_counted(len(verdicts), 'numbered equation')}: {counted}")
    if of[Of.FILE]:
        other = "other formula" if of[Of.CLAIM] else "formula"
        parts.append(f"{_counted(len(of[Of.FILE]), other)}: {'; '.join(_parts(of[Of.FILE]))}")
    if of[Of.PLACE]:
        parts.append(f"{_counted(len(of[Of.PLACE]), 'other place')} could not be read")
    if of[Of.ABSENT]:
        names = ", ".join(label(each.name) for each in of[Of.ABSENT])
        parts.append(f"not in the file: {names}")
    return "; ".join(parts)


def _parts(findings: Sequence[AuditFinding]) -> Iterator[str]:
    compared = [each for each in findings if each.passed is not None]
    wrong = sum(each.is_wrong for each in compared)
    yield (
        f"{len(compared)} compared with what stands above, {wrong or 'none'} wrong"
        if compared
        else "none could be compared with what stands above"
    )
    new = sum(each.verdict in (PREMISE, DEFINITION) for each in findings)
    opened = sum(each.verdict == UNDECIDED for each in findings)
    unread = sum(each.verdict == UNREAD for each in findings)
    if new:
        yield f"{new} say{'s' * (new == 1)} something new"
    if opened:
        yield f"{opened} {'is' if opened == 1 else 'are'} open"
    if unread:
        yield f"{unread} could not be read"


def _counted(count: int, what: str) -> str:
    return f"{count} {what}{'s' * (count != 1)}"
