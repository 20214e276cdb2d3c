"""Equations of a file that bear numbers of a collection, judged by what stands there under these.

An equation as the collection prints it has the verdict of the claim of that number.  Any other is
judged in the worlds in which the claim's equations hold: it is wrong if it contradicts them, and as
good if it says as much.
"""

from __future__ import annotations

import re
import time
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from itertools import pairwise
from math import inf

from sympy import Expr, ImmutableMatrix

from rigidtop.judge.context import LAW, Constraint, Context, LetterDefinition
from rigidtop.judge.habits import habits_of
from rigidtop.judge.jets import Jet, symbol
from rigidtop.judge.judge import Judge
from rigidtop.judge.outcome import (
    ASSUMING,
    FALSE,
    PROVED,
    SAMPLED,
    UNDECIDED,
    UNREAD,
    Outcome,
)
from rigidtop.judge.outcome import DEFINITION as DEFINED
from rigidtop.judge.situation import Situation
from rigidtop.judge.text import Row, in_time
from rigidtop.judge.vocabulary import Meant
from rigidtop.mark.arrival import comes_to, is_trivial
from rigidtop.mark.facts import GIVEN
from rigidtop.mark.held import contexts
from rigidtop.mark.task import ALWAYS, Subject, letters, stated
from rigidtop.proof.equation import Equation
from rigidtop.proof.letters import Letters
from rigidtop.proof.page import Claim, Definition, Page
from rigidtop.proof.verdict import Judgement, judge
from rigidtop.read.document import Numbered, lines, numbered
from rigidtop.read.macros import PACKAGES, Macros
from rigidtop.read.statements import statements
from rigidtop.report.records import note
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement
from rigidtop.typeset.latex import latex

SECONDS = 120.0
"""A file is not judged for longer than this (of the processor's time)."""

MOST_LINES = 50
"""Under one number no more lines are judged."""

UNKNOWN, ABSENT = "unknown", "absent"
"""What is said in place of a verdict: a number of no claim, no equation."""

_SHOWN = (PROVED, SAMPLED, ASSUMING, DEFINED)


@dataclass(frozen=True)
class NumberedLine:
    """A statement under a number of a file, and what became of it.

    It is `as_good` if the collection prints it so, right or wrong (`as_printed`), or if it says as
    much; where it is not, `right` is what the collection has.
    """

    row: Row
    outcome: Outcome
    as_good: bool
    as_printed: bool = False
    right: Statement | None = None


@dataclass(frozen=True)
class Copy:
    """What a file has under a number, with the claim of that number; None if there is none.

    `absent` are statements of the claim to which nothing in the file comes.
    """

    group: Numbered
    lines: tuple[NumberedLine, ...]
    judgement: Judgement | None
    absent: tuple[Statement, ...] = ()

    @property
    def number(self) -> str:
        return self.group.number

    @property
    def verdict(self) -> str:
        """What is refuted comes before what is unread, and that before what is open."""
        verdicts = [line.outcome.verdict for line in self.lines]
        for bad in (FALSE, UNREAD):
            if bad in verdicts:
                return bad
        if self.judgement is None:
            return UNKNOWN
        if any(line.as_printed for line in self.lines) and all(x.as_good for x in self.lines):
            return self.judgement.verdict.value
        return max(verdicts, key=[*_SHOWN, *{*verdicts} - {*_SHOWN}].index)

    @property
    def passed(self) -> bool:
        """Whether every line was read and is as right as the collection knows it."""
        sound = self.judgement is not None and self.judgement.passed
        return sound and all(line.as_good for line in self.lines)

    @property
    def note(self) -> str:
        """What is wrong and where, or what is assumed; what is not there."""
        first = self.lines[0].row.line
        parts = []
        for line in self.lines:
            if line.outcome.verdict == UNREAD or not (line.as_good or self.judgement is None):
                where = f"line {line.row.line}: " if line.row.line != first else ""
                parts.append(f"{where}{line.outcome.why}")
        if self.judgement is None:
            parts.append("the collection has no claim of this number")
        elif note(self.judgement) and (not parts or not self.judgement.passed):
            parts.append(note(self.judgement))
        if self.absent:
            parts.append(f"not among the file's lines: {', '.join(map(plain, self.absent))}")
        return "; ".join(parts)

    @property
    def right(self) -> str:
        """What the collection has in place of what is not as good."""
        right = (line.right for line in self.lines if line.right is not None)
        return ", ".join(map(plain, dict.fromkeys(right)))


@dataclass(frozen=True)
class _Entry:
    """What stands in a collection under a number: a claim with its verdict.

    `printed` has the statements with theirs; `sound` are those of them that hold, or the corrected
    ones; `known` is what holds where these do.  Of letters that are set equal `alike` has one for
    each other.
    """

    judgement: Judgement
    printed: dict[Statement, str]
    sound: tuple[Statement, ...]
    known: Context
    alike: Mapping[Letter, Letter]


@dataclass(frozen=True, eq=False)
class Numbers:
    """What a collection has under its numbers; each is judged once, when a file has it."""

    pages: Sequence[Page]
    subject: Subject
    letters: Letters
    entries: dict[str, _Entry | None] = field(default_factory=dict)

    def entry(self, number: str) -> _Entry | None:
        """The entry of a number; None where there is none."""
        if number not in self.entries:
            claims = ((x, page) for page in self.pages for x in page.claims if x.name == number)
            entries = (_entry(x, page, self.subject, self.letters) for x, page in claims)
            self.entries[number] = next(entries, None)
        return self.entries[number]


def copies(
    rows: Sequence[Row],
    source: str,
    numbers: Numbers,
    macros: Macros = PACKAGES,
    until: float = inf,
) -> tuple[Copy, ...]:
    """What a text has under each of its numbers, in order; `rows` are its statements.

    What is not compared until a time of `time.process_time` is left out.
    """
    subject, at = numbers.subject, {row.position: row for row in rows}
    found = []
    for group in numbered(source):
        read = [
            (_unread(at[line.position], line.problem), _statements(line.equation))
            for line in lines(group, subject.notation, macros)
            if line.position in at
        ]
        if read and time.process_time() < until:
            found.append(_copy(group, read, numbers.entry(group.number), subject, until))
    return tuple(found)


def _unread(row: Row, problem: str) -> Row:
    return replace(row, outcome=Outcome(UNREAD, problem)) if problem else row


def in_its_letters(found: Sequence[Copy], subject: Subject) -> tuple[Copy, ...]:
    """Those whose numbers the collection has; none of a file in other letters that has them too."""
    known = tuple(each for each in found if each.judgement is not None)
    if not known or any(each.passed for each in known):
        return known
    pages = subject.lecture
    own = {x for id in pages.lines for said in stated(id, pages) for x in letters(said)} | ALWAYS
    said = (line.row.statement for each in known for line in each.lines)
    foreign = any(isinstance(x, Statement) and not letters(x) <= own for x in said)
    return () if foreign else known


def missing(found: Sequence[Copy], pages: Iterable[Page]) -> tuple[Claim, ...]:
    """The collection's claims between the first and the last that the file has, not in it."""
    claims = [c for page in pages for c in page.claims if re.fullmatch(r"\d+\.\d+[a-z]?", c.name)]
    there = {each.number for each in found}
    places = [i for i, claim in enumerate(claims) if claim.name in there]
    if not places:
        return ()
    return tuple(c for c in claims[places[0] : places[-1]] if c.name not in there)


# --- What the collection has ---------------------------------------------------------------------


def _entry(claim: Claim, page: Page, subject: Subject, known: Letters) -> _Entry:
    """A claim judged, with what is printed of it and the worlds in which that holds."""
    pages = subject.lecture
    judgement = judge(claim, page.section, pages, known)
    findings = [x for x in judgement.findings() if x.check.printed]
    printed = {s: x.verdict.value for x in findings for s in _statements(x.check.claimed)}
    for item in judgement.items:
        if isinstance(item, Definition):
            printed |= dict.fromkeys(_statements(item.equation), DEFINED)
    sound = [s for s, verdict in printed.items() if verdict in _SHOWN]
    sound += [s for x in judgement.corrections() for s in _statements(x.check.claimed)]
    ids = pages.names.get(claim.name, ())
    if not printed:
        equations = [each for id in ids for each in pages.lines[id].equations]
        sound = [s for each in equations if each.tag in ("", claim.name) for s in _statements(each)]
        printed = dict.fromkeys(sound, judgement.verdict.value)
    settings = [
        condition.expression
        for id in ids
        for condition in pages.judged(id).known.conditions
        if condition.relation == "="
    ]
    constant = [x for x in dict.fromkeys(settings) if x.free_symbols <= known.numbers]
    alike = dict(pair for x in constant for pair in _alike(x))
    printed = {_in_letters(each, alike): verdict for each, verdict in printed.items()}
    sound = [*dict.fromkeys(_in_letters(each, alike) for each in sound)]
    special = [each for x in settings for each in _statements(Equation(x, 0))]
    matrices = [x for operator in known.operators for x in _letters_of(operator)]
    worlds = _worlds([*special, *sound], matrices)
    return _Entry(judgement, printed, tuple(sound), worlds, alike)


def _letters_of(symbol: Expr) -> Iterator[Letter]:
    """The letter by which a symbol is written."""
    for said in _statements(Equation(symbol, 0)):
        if isinstance(said.sides[0], Letter):
            yield said.sides[0]


def _alike(vanishing: Expr) -> Iterator[tuple[Letter, Letter]]:
    """The two letters of a difference, that with the smaller name second."""
    first, *others = sorted(vanishing.free_symbols, key=str)
    for other in others:
        if vanishing in (first - other, other - first):
            yield from zip(_letters_of(other), _letters_of(first), strict=True)


def _in_letters(each: Statement, alike: Mapping[Letter, Letter]) -> Statement:
    def change(node: n.Node) -> n.Node:
        return alike.get(node, node) if isinstance(node, Letter) else node

    return replace(each, sides=tuple(n.mapped(side, change) for side in each.sides))


def _statements(equation: Equation | None) -> tuple[Statement, ...]:
    """An equation as statements in the letters of the collection; nothing for none."""
    read = statements(latex(equation)) if equation is not None else ()
    return tuple(replace(x, position=0, tag="") for x in read if isinstance(x, Statement))


def _worlds(premises: Sequence[Statement], matrices: Iterable[Letter]) -> Context:
    """What holds where some statements do, of numbers, vectors and the letters of matrices."""
    spoken = frozenset().union(*map(letters, premises))
    known, judge = Context(habits_of(premises)), Judge()
    for letter in spoken & {*matrices}:
        entries = [symbol(Jet(letter, 0, (k,))) for k in range(9)]
        known = known.defining(
            letter, LetterDefinition(Meant(ImmutableMatrix(3, 3, entries)), GIVEN)
        )
    for k, each in enumerate(dict.fromkeys(premises)):
        outcome, after = in_time(judge, each, Situation(GIVEN - 1 - k), known)
        if outcome.verdict == UNDECIDED:
            for left, right in pairwise(each.sides):
                known = known.holding(Constraint(left, right, GIVEN - 1 - k, LAW))
        else:
            known = after
    return replace(known, given=known.letters)


# --- What the file has ---------------------------------------------------------------------------


def _copy(
    group: Numbered,
    rows: Sequence[tuple[Row, tuple[Statement, ...]]],
    entry: _Entry | None,
    subject: Subject,
    until: float,
) -> Copy:
    """What a file has under one number, compared with the entry of that number.

    `rows` come with what each says in the letters of the collection, where it is read there.
    """
    if entry is None:
        return Copy(group, tuple(NumberedLine(row, row.outcome, False) for row, _ in rows), None)
    comparison = _Comparison(entry, subject, until)
    rows = [(row, tuple(_in_letters(each, entry.alike) for each in own)) for row, own in rows]
    said = [each for _, own in rows for each in own]
    others = [each for each in said if not _is_among(each, entry.printed)]
    reached = [
        goal for goal in entry.sound if _is_among(goal, said) or comparison.comes_to(goal, others)
    ]
    found = []
    for row, own in rows[:MOST_LINES]:
        outcomes = [comparison.line(row, each, bool(reached)) for each in own]
        bad = [line for line in outcomes if not line.as_good]
        found += [*bad, *outcomes][:1] or [NumberedLine(row, row.outcome, False)]
    found += [NumberedLine(row, _TOO_MANY, False) for row, _ in rows[MOST_LINES:]]
    told = [*reached, *said, *(line.right for line in found if line.right is not None)]
    absent = [goal for goal in entry.printed if not _is_among(goal, told)]
    whole = all(line.outcome.verdict != UNREAD for line in found)
    return Copy(group, tuple(found), entry.judgement, tuple(absent) if whole else ())


_TOO_MANY = Outcome(UNDECIDED, f"more than {MOST_LINES} lines under one number")
_OWN = (ASSUMING, DEFINED)
"""Verdicts that hold for a claim however it is written."""


@dataclass(frozen=True)
class _Comparison:
    """What is compared with an entry of the collection, until the time is over."""

    entry: _Entry
    subject: Subject
    until: float
    judge: Judge = field(default_factory=Judge)

    @cached_property
    def models(self) -> tuple[Context, ...]:
        """The models in which the claim's equations hold."""
        return tuple(
            known
            for known in contexts(self.subject)[0]
            if all(self._in(known, goal) for goal in self.entry.sound)
        )

    def _in(self, known: Context, said: Statement) -> bool | None:
        """Whether a statement holds in a model that knows its letters."""
        if not letters(said) - ALWAYS <= known.given:
            return None
        return self.outcome(said, known).passed

    def outcome(self, said: Statement, known: Context) -> Outcome:
        return in_time(self.judge, said, Situation(0, closed=True), known, self.until)[0]

    def comes_to(self, goal: Statement, said: Sequence[Statement]) -> bool:
        """Whether what a file says comes to a statement of the claim, in its letters or others."""
        own = frozenset().union(*map(letters, said)) <= self.entry.known.given | ALWAYS
        known = self.entry.known, *(() if own else self.models)
        return bool(said) and any(comes_to(goal, said, each) for each in known)

    def line(self, row: Row, said: Statement, is_reached: bool) -> NumberedLine:
        """What becomes of one statement, where one of the claim's is reached with it or not."""
        entry = self.entry
        for printed, verdict in entry.printed.items():
            if _is_same(said, printed):
                return NumberedLine(row, Outcome(verdict), True, True)
        outcome = self.compared(said)
        if outcome.passed and is_trivial(said, replace(entry.known.habits, moving=letters(said))):
            outcome = Outcome(UNDECIDED, "it says nothing")
        if outcome.passed and not is_reached:
            outcome = Outcome(UNDECIDED, "it says less than the equation of that number")
        if not outcome.passed:
            right = max(entry.sound, key=lambda goal: _likeness(goal, said), default=None)
            return NumberedLine(row, outcome, False, right=right)
        verdict = entry.judgement.verdict.value
        return NumberedLine(
            row, replace(outcome, verdict=verdict) if verdict in _OWN else outcome, True
        )

    def compared(self, said: Statement) -> Outcome:
        """Whether a statement holds where the claim's do, or in the models where these hold."""
        entry = self.entry
        outcome = self.outcome(said, entry.known)
        new = letters(said) - entry.known.given - ALWAYS
        if not new and (outcome.passed or outcome.slip):
            return outcome
        others = [(model, self._in(model, said)) for model in self.models]
        held = [holds for _, holds in others if holds is not None]
        if held and all(held):
            why = "it is true, and not what the claim of that number says"
            return outcome if outcome.passed else Outcome(UNDECIDED, why)
        if not new:
            return outcome
        for model, holds in others:
            if holds is False:
                return self.outcome(said, model)
        names = ", ".join(sorted(map(plain, new)))
        return Outcome(UNDECIDED, f"the claim does not say what {names} is")


def _is_among(one: Statement, others: Iterable[Statement]) -> bool:
    return any(_is_same(one, each) for each in others)


def _is_same(one: Statement, other: Statement) -> bool:
    """Whether two statements are written alike, but for brackets and for ≡."""
    relations = [["=" if x == "≡" else x for x in each.relations] for each in (one, other)]
    return relations[0] == relations[1] and _bare(one) == _bare(other)


def _bare(each: Statement) -> list[n.Node]:
    return [n.mapped(side, n.ungrouped) for side in each.sides]


def _likeness(one: Statement, other: Statement) -> float:
    """1 for a common left side, and the share of the letters that both have."""
    here, there = letters(one), letters(other)
    return (_bare(one)[0] == _bare(other)[0]) + len(here & there) / max(len(here | there), 1)
