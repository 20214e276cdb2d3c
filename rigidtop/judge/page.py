"""Lines of pages judged in worlds: whether each is true wherever all that it rests on is true.

A line rests on laws and definitions, and on what is set on the way to it.  Nothing else is known in
its worlds, so a line that fails in all of them is false, whatever move has arrived at it.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from itertools import accumulate

import numpy as np
from sympy import Expr, I, Symbol

from rigidtop.judge import worlds as w
from rigidtop.judge.alphabet import Alphabet, alphabet, letters_of
from rigidtop.judge.context import Context, Habits
from rigidtop.judge.ground import (
    ENTRY,
    EQUALS,
    SLACK,
    Ground,
    LinePremises,
    ValueCache,
    equations,
    habits,
    has_sign,
    names_and_slopes,
)
from rigidtop.judge.jets import Jet, jet_of, jets, symbol, symbols
from rigidtop.judge.outcome import (
    DEFINITION,
    FALSE,
    PREMISE,
    SAMPLED,
    UNDECIDED,
    UNREAD,
    Outcome,
)
from rigidtop.judge.particles import particles
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.residual import Residual
from rigidtop.judge.spans import NoValueError, Span, is_contradictory, span
from rigidtop.judge.surroundings import related, surrounding
from rigidtop.judge.values import UnclearError, pairs, plain
from rigidtop.judge.written import written
from rigidtop.proof.derivation import Judged, Line
from rigidtop.proof.lecture import Lecture
from rigidtop.read.statements import statements
from rigidtop.terminal.limit import TooLong, within
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.statement import Statement

MOST_EQUATIONS = 12
"""Of more equations no worlds are looked for."""

MOST_LETTERS = 4
"""Of an equation with more letters no bounds are asked."""

MOST_NUMBERS = 8
"""So many numbers of a world are told."""

ENOUGH = 2
"""So many worlds are looked for."""

CLOSE = 1e-9
"""Bounds that are missed by less are not missed."""

SECONDS = 2.0
"""No line is judged for longer (s, of the processor's time)."""


def outcome(lecture: Lecture, judged: Judged) -> Outcome:
    """What becomes of a line in worlds, unless that takes too long."""
    pages = _pages(lecture)
    if judged.line.id not in pages.outcomes:
        pages.outcomes[judged.line.id] = _in_time(pages, judged)
    return pages.outcomes[judged.line.id]


def _in_time(pages: Pages, judged: Judged) -> Outcome:
    try:
        with within(SECONDS):
            return pages.outcome(judged)
    except TooLong:
        return Outcome(UNDECIDED, f"judging it takes longer than {SECONDS:g} s")
    except Exception as error:  # an opinion that breaks is none
        return Outcome(UNDECIDED, f"rigidtop itself fails here ({type(error).__name__}: {error})")


def refuted(lecture: Lecture, judged: Judged) -> str:
    """Why a line is false where all that it rests on is true; nothing where it is not."""
    opinion = outcome(lecture, judged)
    return opinion.why if opinion.verdict == FALSE else ""


def remember(lecture: Lecture, outcomes: Mapping[str, Outcome]) -> None:
    """Take what was found of lines elsewhere, by their ids."""
    _pages(lecture).outcomes.update(outcomes)


@dataclass
class Pages:
    """What judges the lines of a lecture, each in the worlds of what it rests on."""

    lecture: Lecture
    outcomes: dict[str, Outcome] = field(default_factory=dict)
    """Of lines that were judged already, by their ids."""

    @cached_property
    def read(self) -> dict[str, tuple[Statement, ...] | str]:
        """What each line states, or why it can't be read."""
        functions = letters_of(self.lecture.letters.functions)
        differentials = Letter("d") not in letters_of(self.lecture.letters.units)
        return {
            shown.line.id: _read(shown.latex, functions, differentials)
            for text in self.lecture.texts
            for shown in text.shown
            if shown.line is not None
        }

    @cached_property
    def _written(self) -> frozenset[Letter]:
        return names_and_slopes(x for read in self.read.values() for x in _statements(read))

    @cached_property
    def _desks(self) -> dict[str, tuple[Alphabet, Habits, ValueCache]]:
        """What the letters of a file are, and what has been worked out in them, by its name."""
        return {}

    def _desk(self, id: str) -> tuple[Alphabet, Habits, ValueCache]:
        file = self.lecture.lines[id].file
        if file not in self._desks:
            letters = alphabet(self.lecture.letters_at(id))
            own = habits(self._written, letters)
            alike = (values for _, other, values in self._desks.values() if other == own)
            self._desks[file] = letters, own, next(alike, ValueCache())
        return self._desks[file]

    def outcome(self, judged: Judged) -> Outcome:
        """What becomes of a line where what it cites holds, else where all holds it rests on."""
        id = judged.line.id
        if _is_root(judged.line):
            return Outcome(PREMISE if judged.line.move is None else DEFINITION)
        read = self.read[id]
        if isinstance(read, str):
            return Outcome(UNREAD, read)
        if not judged.follows:
            return Outcome(UNDECIDED, "its move does not arrive, so its conditions are not known")
        if judged.known.order is not None:
            return Outcome(UNDECIDED, "it holds approximately")
        cited = self.lecture.cites(id)
        near = self._asked(judged, read, cited, whole=False)
        if near.verdict != FALSE:
            return near
        above = [x for x in self.lecture.above(id) if x in cited or self._stands(x)]
        return self._asked(judged, read, above, whole=True)

    def _stands(self, id: str) -> bool:
        return _is_root(self.lecture.lines[id])

    def _asked(
        self, judged: Judged, stated: tuple[Statement, ...], rests_on: Sequence[str], whole: bool
    ) -> Outcome:
        order = sorted(rests_on, key=lambda x: not self._stands(x))
        premises = LinePremises(
            tuple(x for id in order for x in _statements(self.read[id])),
            sum(len(_statements(self.read[x])) for x in order if self._stands(x)),
            any(isinstance(self.read[x], str) for x in rests_on),
            judged.known.conditions,
            judged.known.scope,
        )
        ground = Ground(premises, *self._desk(judged.line.id), stated, whole)
        try:
            return LineQuestion(ground).outcome()
        except (UnclearError, UnknownFunctionError) as why:
            return Outcome(UNDECIDED, str(why))


@lru_cache(maxsize=8)
def _pages(lecture: Lecture) -> Pages:
    return Pages(lecture)


def _is_root(line: Line) -> bool:
    """Whether a line stands by itself: a law, a definition."""
    return line.move is None or line.move.verb == "call"


def _read(
    text: str, functions: frozenset[Letter], differentials: bool
) -> tuple[Statement, ...] | str:
    read = statements(text, functions=functions, differentials=differentials)
    wrong = [x.reason for x in read if not isinstance(x, Statement)]
    return wrong[0] if wrong else tuple(x for x in read if isinstance(x, Statement))


def _statements(read: tuple[Statement, ...] | str) -> tuple[Statement, ...]:
    return () if isinstance(read, str) else read


Sides = list[tuple[Expr, Expr]]


@dataclass(frozen=True, eq=False)
class LineQuestion:
    """Whether a line holds in the worlds of its ground."""

    ground: Ground

    def outcome(self) -> Outcome:
        """The outcome in the frame in which columns are right; in the last one if in none."""
        ground, last = self.ground, Outcome(UNDECIDED)
        if any(n.letters(x) & ground.letters.double for e in ground.stated for x in e.sides):
            return Outcome(UNDECIDED, "a letter with two indices")
        for basis in ground.bases():
            context = replace(ground.context, basis=basis)
            pool, complete = ground.residuals(context)
            links = [link for each in ground.stated for link in equations(each)]
            last = _joint([self._link(context, pool, complete, *link) for link in links])
            if last.verdict == SAMPLED:
                break
        return last

    def _link(
        self,
        context: Context,
        pool: Sequence[Residual],
        complete: bool,
        relation: str,
        left: Node,
        right: Node,
    ) -> Outcome:
        if relation not in EQUALS:
            return Outcome(UNDECIDED, f"{relation} is not judged")
        sides = self._sides(context, left, right)
        flat = [x for pair in sides for x in pair]
        if against := self._against(plain([each.expression for each in pool]), sides):
            return Outcome(FALSE, against)
        if all(a == b for a, b in sides) or w.found((), w.symbols_of(flat)).holds(sides):
            return Outcome(SAMPLED)
        most = MOST_EQUATIONS if self.ground.whole else 2 * MOST_EQUATIONS
        if len(related(flat, pool)) > most:
            return Outcome(UNDECIDED, "it rests on too much")
        gaps, _, _ = surrounding(flat, context, pool)
        if len(gaps) > most:
            return Outcome(UNDECIDED, "it rests on too much")
        letters = w.symbols_of([*gaps, *flat])
        apart = plain([*self.ground.apart(context)])
        worlds = self._real(w.found(gaps, letters, self.ground.vanishing, apart, ENOUGH))
        holds = worlds.holds(sides)
        if holds:
            return Outcome(SAMPLED)
        if holds is None:
            if not worlds.count and is_contradictory(gaps):
                return Outcome(FALSE, "what it rests on can't hold together")
            return Outcome(UNDECIDED, worlds.why_unknown(sides))
        if not _fails_everywhere(worlds, sides):
            return Outcome(UNDECIDED, "it holds in some worlds, and not in others")
        if not complete:
            return Outcome(UNDECIDED, "not all that it rests on is read")
        new = sorted(map(in_words, self.ground.news))
        if new and self.ground.whole:
            return Outcome(UNDECIDED, f"nothing that it rests on says what {new[0]} is")
        if self.ground.whole and any(j.instant for x in flat for j in jets(x).values()):
            return Outcome(UNDECIDED, "nothing that it rests on says how it started")
        return Outcome(FALSE, witness(worlds, sides))

    def _sides(self, context: Context, left: Node, right: Node) -> Sides:
        """Both sides, entry by entry, for both signs of ± and for any two particles."""
        ground = self.ground
        left, right = (ground.plain(x, context.definitions) for x in (left, right))
        both: Sides = []
        for sign in (1, -1) if has_sign(left, right) else (1,):
            for bound in particles(context.habits.indices, left, right, most=2):
                both += pairs(*(ground.values.of(x, context, sign, bound) for x in (left, right)))
        sides = iter(plain([x for pair in both for x in pair]))
        return list(zip(sides, sides, strict=True))

    def _against(self, gaps: Sequence[Expr], both: Sides) -> str:
        """Why no numbers can be what is said, where bounds show it."""
        every = [*gaps, *(x for pair in both for x in pair)]
        if any(map(_is_complex, every)):
            return ""
        zero = {symbol(Jet(x)) for x in self.ground.vanishing}
        letters = frozenset().union(*map(symbols, every))
        positive = frozenset(x for x in letters - zero if self._is_positive(x))
        known = dict(number for e in gaps if (number := _number_said(e)) is not None)

        def bounds(expression: Expr) -> Span:
            own = symbols(expression)
            numbers = frozenset((x, known[x]) for x in own & known.keys())
            return _bounds(expression, own & positive, numbers)

        for each in (e for e in gaps if len(symbols(e)) <= MOST_LETTERS):
            try:
                low, high = bounds(each)
            except NoValueError:
                return f"what it rests on has no real value: {_words(each)} = 0"
            if low > CLOSE or high < -CLOSE:
                return f"what it rests on holds for no numbers: {_words(each)} = 0"
        for left, right in both:
            try:
                (low, high), (least, most) = bounds(left), bounds(right)
            except NoValueError:
                return "it has no real value"
            if low > most + CLOSE or high < least - CLOSE:
                return f"no numbers make it true: {_words(left)} is not {_words(right)}"
        return ""

    def _is_positive(self, x: Symbol) -> bool:
        jet = jet_of(x)
        return jet is not None and not jet.order and jet.letter in self.ground.letters.positive

    def _real(self, worlds: w.Worlds) -> w.Worlds:
        """Worlds with real numbers, in which what is positive is so."""
        above = [self._is_positive(x) for x in worlds.letters]
        real = np.abs(worlds.points.imag).max(axis=0, initial=0) < 1e-9
        right = real & (worlds.points.real[above] >= -1e-12).all(axis=0)
        return replace(worlds, points=worlds.points[:, right])


@lru_cache(maxsize=20_000)
def _is_complex(value: Expr) -> bool:
    return bool(value.has(I))


@lru_cache(maxsize=20_000)
def _bounds(
    expression: Expr, positive: frozenset[Symbol], known: frozenset[tuple[Symbol, float]]
) -> Span:
    """The same as `span`; what one line rests on, many others do."""
    return span(expression, positive, dict(known))


@lru_cache(maxsize=20_000)
def _number_said(gap: Expr) -> tuple[Symbol, float] | None:
    """The letter to which an equation gives a number, and that number."""
    if len(symbols(gap)) != 1:
        return None
    [x] = symbols(gap)
    slope = gap.diff(x)
    return (x, float(-gap.subs(x, 0) / slope)) if slope.is_number and slope != 0 else None


def _words(value: Expr) -> str:
    return in_words(written(value))


def witness(worlds: w.Worlds, sides: Sides) -> str:
    """The numbers of a world in which both sides differ, and what they are there."""
    one = replace(worlds, points=worlds.points[:, :1])
    left, right = next(pair for pair in sides if one.holds([pair]) is False)
    values = one.program.values([left, right]).values[:, 0]
    asked = symbols(left) | symbols(right)
    numbers: dict[Jet, list[str]] = {}
    for x, value in zip(one.letters, one.points[:, 0], strict=True):
        if x in asked and (jet := jet_of(x)) is not None and _is_written(jet.letter):
            numbers.setdefault(replace(jet, place=()), []).append(_number(value))
    told = [
        f"{_words(symbol(jet))} = {each[0] if len(each) == 1 else '(' + ', '.join(each) + ')'}"
        for jet, each in numbers.items()
    ]
    counts = accumulate(len(each) for each in numbers.values())
    few = [text for text, count in zip(told, counts, strict=True) if count <= MOST_NUMBERS]
    where = f", for instance where {', '.join(few)}" if few else ""
    return f"it does not hold: its sides are {_number(values[0])} and {_number(values[1])}{where}"


def _number(value: complex) -> str:
    return f"{0 if abs(value) < CLOSE else value.real:.3g}"


def _is_written(letter: Letter) -> bool:
    """Whether a page writes a letter, and not the judge alone."""
    return letter.base != "∂" and not letter.mark.endswith((SLACK, ENTRY))


def _fails_everywhere(worlds: w.Worlds, sides: Sides) -> bool:
    """Whether in no world both sides agree."""
    single = [replace(worlds, points=worlds.points[:, [k]]) for k in range(worlds.count)]
    return all(each.holds(sides) is False for each in single)


def _joint(outcomes: Sequence[Outcome]) -> Outcome:
    """The worst of the outcomes of a line's links."""
    for verdict in (FALSE, UNDECIDED):
        for each in outcomes:
            if each.verdict == verdict:
                return each
    return outcomes[0] if outcomes else Outcome(UNDECIDED, "it states nothing")
