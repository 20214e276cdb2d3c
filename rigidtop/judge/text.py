"""A whole text, judged statement by statement."""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import groupby
from math import inf

from rigidtop.judge.ahead import explained_first
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.context import (
    SETTING,
    START,
    Constraint,
    Context,
    Habits,
    LimitingCase,
    has_unit,
)
from rigidtop.judge.habits import habits_of
from rigidtop.judge.judge import Judge
from rigidtop.judge.letters import CLOCK, is_mass
from rigidtop.judge.moments import at_one_time, instant_at, instants, is_time, time_of
from rigidtop.judge.names import is_vector
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED, UNDECIDED, UNREAD, Outcome
from rigidtop.judge.question import Patience
from rigidtop.judge.reading import LATE, Read, read_text
from rigidtop.judge.sides import letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.starts import at_rest, turning, with_energy, with_velocities
from rigidtop.judge.states import kept
from rigidtop.read.declared import declared
from rigidtop.read.macros import Macros
from rigidtop.read.passages import Passage
from rigidtop.read.phrases import Cue
from rigidtop.read.statements import statements
from rigidtop.terminal.limit import TooLong, within
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement, Unread

A_STATEMENT = 10.0
"""No statement is judged for longer than this (s, of the processor's time)."""


@dataclass(frozen=True)
class Row:
    """A statement of a text with the line in which it begins, and what became of it.

    `number` is the one by which other outcomes rest on it; `situation` is what the words around it
    say, None where it was not read.
    """

    line: int
    statement: Statement | Unread
    outcome: Outcome
    passage: Passage
    number: int
    situation: Situation | None = None

    @property
    def display(self) -> bool:
        return self.passage.display

    @property
    def position(self) -> int:
        """Where it begins in the text."""
        return self.passage.start + self.statement.position


@dataclass(frozen=True)
class Asked:
    """A statement where it stands, with what the text says of it: what the judge is asked."""

    line: int
    statement: Statement | Unread
    passage: Passage
    number: int
    moment: str
    is_case: bool


@dataclass(frozen=True)
class Reading:
    """All that a text asks, how it uses its letters, and which ones its words introduce.

    What says what a letter stands for is asked before what has the letter.
    """

    asked: tuple[Asked, ...]
    habits: Habits
    names: frozenset[Letter]


@dataclass(frozen=True)
class Knowledge:
    """What is known at a place, and the scope of the statement in front of it.

    For so many `seconds` slips may still be looked for.
    """

    context: Context
    scope: tuple[int, ...] | None
    seconds: float


@dataclass(frozen=True)
class TextStep:
    """What became of something asked, None where it says nothing, and what is known behind it."""

    asked: Asked
    row: Row | None
    behind: Knowledge


def judged(source: str, macros: Macros | None = None, until: float = inf) -> tuple[Row, ...]:
    """Every statement of a text, in order.

    `macros` are those of other files.  After a time of `time.process_time` the rest is undecided,
    and says so.
    """
    return folded(source, macros, until)[0]


def folded(
    source: str, macros: Macros | None = None, until: float = inf
) -> tuple[tuple[Row, ...], Context]:
    """The same, with what is known behind the last statement."""
    read = reading(source, macros, until)
    made = [*steps(read, until)]
    return rows_of(made), (made[-1].behind if made else start(read)).context


def rows_of(made: Iterable[TextStep]) -> tuple[Row, ...]:
    """What became of each statement, in the order of the text."""
    rows = (step.row for step in made if step.row is not None)
    return tuple(sorted(rows, key=lambda row: row.number))


def reading(source: str, macros: Macros | None = None, until: float = inf) -> Reading:
    """All that a text asks, in the order in which it is judged."""
    read, place = read_text(source, macros, until)
    cases = cases_of(read)
    stated = [each for _, each in read if isinstance(each, Statement)]
    habits = habits_of(stated)
    weighed = any(is_mass(x) for each in stated for x in letters_in(each))
    habits = replace(
        habits,
        massless=not weighed and _MASS.search(source) is None,
        weightless=_WEIGHT.search(source) is None,
        extended=_EXTENDED.search(source) is not None,
        units=_unit_vectors(read),
        driven=_driven(read),
        moving=habits.moving - _constant(read, stated),
    )
    moments = instants(read, habits.moving)
    asked = (
        Asked(
            place(passage.start + each.position)[0],
            *(each, passage, number, moment, passage.start in cases),
        )
        for number, ((passage, each), moment) in enumerate(zip(read, moments, strict=True))
    )
    return Reading(tuple(explained_first(asked)), habits, declared_letters(source))


_EXTENDED = re.compile(
    r"\b(?:rods?|cylinders?|dis[ck]s?|hoops?|wheels?|plates?|ladders?|roll(?:s|ing)?"
    r"|moments? of inertia|St[aä]be?|Scheiben?|Zylinder|rollt)\b",
    re.I,
)


def _unit_vectors(read: Read) -> frozenset[Letter]:
    """The vectors of which a sentence speaks that calls them unit vectors."""
    named = set()
    for _, sentence in groupby(read, key=lambda each: each[0].sentence):
        said = [(passage, x) for passage, x in sentence if isinstance(x, Statement)]
        words = " ".join(f"{passage.before} {passage.behind}" for passage, _ in said)
        if _UNITS.search(words) and not _NOT.search(words):
            named |= {x.sides[0] for _, x in said if len(x.sides) == 1}
        named |= {
            x.sides[0]
            for passage, x in said
            if _A_UNIT.match(passage.behind) or _THE_UNIT.search(passage.before)
        }
    return frozenset(x for x in named if isinstance(x, Letter) and is_vector(x))


_UNITS = re.compile(
    r"\b(?:both|two|as|be|are) unit vectors\b|\b(?:beide )?Einheitsvektoren\b", re.I
)
_A_UNIT = re.compile(r",? ?(?:is |be |as )?an? unit vector\b|,? ?(?:ist )?ein Einheitsvektor", re.I)
_THE_UNIT = re.compile(r"\bunit vector ?\Z|\bEinheitsvektor ?\Z|\bvecteur unitaire ?\Z", re.I)
_NOT = re.compile(r"\b(?:not?|neither|length|nicht|kein)\b", re.I)


def _constant(read: Read, stated: Iterable[Statement]) -> frozenset[Letter]:
    """The letters that words call constant and that have no rate anywhere."""
    named = {
        each.sides[0]
        for passage, each in read
        if isinstance(each, Statement) and not each.relations and Cue.CONSTANT in passage.cues
    }
    rates = {
        n.ungrouped(node.of)
        for each in stated
        for side in each.sides
        for node in n.walked(side)
        if isinstance(node, n.TimeDerivative)
    }
    return frozenset(x for x in named - rates if isinstance(x, Letter))


def _driven(read: Read) -> frozenset[Letter]:
    """The letters whose motion is given by the words: "X(t) is prescribed"."""
    said = [
        n.ungrouped(each.sides[0])
        for passage, each in read
        if isinstance(each, Statement) and len(each.sides) == 1
        if _GIVEN.match(passage.behind) or _GIVE.search(passage.before)
    ]
    functions = (x.function for x in said if isinstance(x, n.Call) and x.places == (CLOCK,))
    return frozenset(x for x in functions if isinstance(x, Letter))


_GIVEN = re.compile(
    r",? ?(?:is|are|as|ist|est)? ?(?:an? |eine? |une? )?"
    r"(?:given|prescribed|imposed|known|(?:vor)?gegeben|vorgeschrieben|bekannt|donnée?|imposée?)",
    re.I,
)
_GIVE = re.compile(
    r"\b(?:given|prescribed?|imposed?|known|gegeben\w*|vorgeschrieben\w*|donnée?|imposée?)"
    r"(?: [\w-]+){0,3} ?\Z",
    re.I,
)


def steps(read: Reading, until: float = inf) -> Iterator[TextStep]:
    """Each statement of a text judged."""
    judge, known = Judge(), start(read)
    for asked in read.asked:
        made = step(asked, read, judge, known, until)
        yield made
        known = made.behind


def start(read: Reading) -> Knowledge:
    """What is known in front of the first statement."""
    return Knowledge(Context(read.habits), None, Patience().seconds)


def step(
    asked: Asked, read: Reading, judge: Judge, known: Knowledge, until: float = inf
) -> TextStep:
    """A statement judged where so much is known."""
    judge = replace(judge, patience=Patience(known.seconds))
    row, context = _step(asked, read, judge, known.context, known.scope, until)
    speaks = row is not None and isinstance(asked.statement, Statement)
    scope = asked.passage.scope if speaks else known.scope
    return TextStep(asked, row, Knowledge(context, scope, judge.patience.seconds))


def around(asked: Asked, context: Context) -> Context:
    """What is left of what is known where something is asked that says more than a name."""
    passage = asked.passage
    if not isinstance(asked.statement, Statement):
        return context
    if Cue.GENERAL in passage.cues:
        context = context.generally()
    is_constant = Cue.CONSTANT in passage.cues and Cue.DIVISOR not in passage.cues
    if asked.statement.relations or is_constant:
        context = context.within(passage.scope, passage.sentence)
    return context


def _step(
    asked: Asked,
    read: Reading,
    judge: Judge,
    context: Context,
    scope: tuple[int, ...] | None,
    until: float,
) -> tuple[Row | None, Context]:
    """What becomes of a statement that stands behind one of a scope, and what is known then."""
    each, passage, moment = asked.statement, asked.passage, asked.moment

    def row(outcome: Outcome, at: Situation | None = None) -> Row:
        return Row(asked.line, each, outcome, passage, asked.number, at)

    if isinstance(each, Unread):
        return row(Outcome(UNREAD, each.reason)), context
    context = around(asked, context)
    if not each.relations:
        if Cue.DIVISOR in passage.cues:
            return None, replace(context, not_zero=(*context.not_zero, *each.sides))
        if Cue.CONSTANT not in passage.cues:
            if each.sides[0] in read.habits.units:
                square = n.DotProduct(each.sides[0], each.sides[0])
                one = Constraint(square, n.Number("1"), asked.number, SUPPOSED)
                return None, context.holding(one)
            context = _on_circle(each.sides[0], passage, asked.number, context)
            return None, _tending(each.sides[0], passage, context)
        [said] = each.sides
        still = isinstance(said, Letter) and not is_vector(said) and said not in read.habits.moving
        if still and said not in context.definitions:
            return row(Outcome(PREMISE, "a constant")), context  # as it is without a rate anywhere
        each = Statement((n.TimeDerivative(said), n.Number("0")), ("=",), each.position)
    if Cue.CONSTRAINT in passage.cues:
        return row(Outcome(PREMISE, "a constraint")), context
    if Cue.REST in passage.cues:
        placed = _ORIGIN.search(passage.before) is not None
        context = at_rest(context, asked.number, passage.scope, placed)
    if Cue.CONSERVED in passage.cues:
        context = with_energy(context, asked.number, passage.scope)
    for cue in (Cue.KEPT, Cue.MOMENTUM_KEPT):
        if cue in passage.cues:
            context = kept(context, asked.number, passage.scope, cue == Cue.MOMENTUM_KEPT)
    each, time_of_it = at_one_time(each, read.habits.moving)
    if time_of_it is not None:
        moment = instant_at(time_of_it)
        context = replace(context, instants={**context.instants, moment: time_of_it})
    context = with_velocities(each, context, asked.number)
    if Cue.TURNING in passage.cues and moment:
        context = turning(each, context, asked.number, moment)
    at = situation(passage, asked.number, moment, passage.scope != scope, read.names)
    at = replace(at, case=asked.is_case)
    if has_unit(each.sides[-1]) and not read.habits.moving:
        at = replace(at, instant="")  # where nothing has a rate numbers do not change in time
    if at.instant and is_time(each):
        outcome = Outcome(UNDECIDED)
        if at.instant != START and at.instant not in context.instants:
            outcome, _ = in_time(judge, each, at, context, until)
            if outcome.passed is None and _is_then(judge, each, at, context, until):
                outcome = replace(outcome, verdict=SAMPLED, why="it is so then")
        context = replace(context, instants={**context.instants, at.instant: time_of(each)})
        return row(outcome if outcome.passed else Outcome(DEFINITION, "a moment")), context
    outcome, context = in_time(judge, each, at, context, until)
    if Cue.CONSERVED in passage.cues and outcome.verdict == DEFINITION:
        context = with_energy(context, asked.number, passage.scope)
    if Cue.CONSTANT in passage.cues and outcome.verdict == DEFINITION:
        context = kept(context, asked.number, passage.scope, False)
    return row(outcome, at), context


_MASS = re.compile(
    r"\b(?:mass\w*|weigh\w*|heavy|kg|kilograms?|grams?|charge\w*|rubs?|friction|Masse\w*|Gewicht\w*"
    r"|schwer\w*|Ladung\w*|Gramm|reibt|Reibung|lourde?s?|frottement)\b|\d\s*(?:g|kg)\b",
    re.I,
)
_WEIGHT = re.compile(
    r"weight|gravity|\bhang|\bfall|spring|pendul|slope|inclin|roof|Schwer|Gewicht|[Ff]eder|hängt"
    r"|fällt|Pendel|pesanteur|ressort",
    re.I,
)
"""Words for what has a mass, and for what has more than a kinetic energy."""
_ORIGIN = re.compile(r"\b(?:at|from|in|im|à) (?:the |l['’])?(?:origin|Ursprung|origine)\b", re.I)
"""Words that say where something begins."""
_RADIUS = re.compile(r"\b(?:circle of (?:the )?radius|Kreis vom Radius|cercle de rayon) ?\Z", re.I)
"""Words in front of the radius of a circle on which something goes."""
_GROWS = re.compile(r"\b(?:(small|klein\w*|petite?s?)|large|gro(?:ss|ß)\w*|grande?s?) ?\Z", re.I)
"""Words in front of a letter that is small, or large, where something is nearly true."""


def _on_circle(node: n.Node, passage: Passage, number: int, context: Context) -> Context:
    """What is known where words name the radius of the circle on which r stays."""
    radius = next((x for x in map(Letter, "rρ") if x in context.letters and x != node), None)
    if radius is None or _RADIUS.search(passage.before) is None or not isinstance(node, Letter):
        return context
    return context.holding(Constraint(radius, node, number, SETTING, passage.scope))


def _tending(node: n.Node, passage: Passage, context: Context) -> Context:
    """What is known where words call a letter small, or large, or much smaller than another."""
    if Cue.LITTLE in passage.cues and isinstance(node, Letter):
        return context.comparing(frozenset({node}), passage.sentence)
    words = _GROWS.search(passage.before)
    if words is None or not isinstance(node, Letter) or node in context.habits.moving:
        return context
    limit = LimitingCase(node, words[1] is None, passage.sentence)
    return replace(context, limits=(*context.limits, limit))


def _is_then(judge: Judge, each: Statement, at: Situation, context: Context, until: float) -> bool:
    """Whether what is so at an instant is so at the time that is said of it."""
    there = [c for c in context.constraints if c.instant == at.instant]
    others = tuple(c for c in context.constraints if c.instant != at.instant)
    instants = {**context.instants, at.instant: time_of(each)}
    known = replace(context, constraints=others, instants=instants)
    asked = (Statement((c.left, c.right), ("=",), each.position) for c in there)
    return bool(there) and all(
        in_time(judge, x, replace(at, cues=frozenset()), known, until)[0].passed for x in asked
    )


def in_time(
    judge: Judge,
    statement: Statement,
    at: Situation,
    context: Context,
    until: float = inf,
    seconds: float | None = None,
) -> tuple[Outcome, Context]:
    """What becomes of a statement, unless that takes too long or breaks."""
    seconds = A_STATEMENT if seconds is None else seconds
    if time.process_time() > until:
        return Outcome(UNDECIDED, LATE), context
    try:
        with within(seconds):
            return judge.judged(statement, at, context)
    except TooLong:
        why = f"judging it takes longer than {seconds:g} s"
    except Exception as error:  # what a stranger wrote may break one statement, not the others
        why = f"rigidtop itself fails here, please report it ({type(error).__name__}: {error})"
    return Outcome(UNDECIDED, why), context


# --- What stands around a statement --------------------------------------------------------------


def situation(
    passage: Passage, number: int, instant: str, opens: bool, names: frozenset[Letter]
) -> Situation:
    """What the words around a statement say of it."""
    return Situation(
        number,
        passage.scope,
        instant,
        passage.sentence,
        passage.cues,
        inline=not passage.display,
        opens=opens,
        declared=names,
    )


def cases_of(read: Read) -> frozenset[int]:
    """Where formulas begin of which several rows have conditions."""
    rows = Counter(
        passage.start
        for passage, each in read
        if isinstance(each, Statement) and (each.conditions or each.condition)
    )
    return frozenset(start for start, count in rows.items() if count > 1)


def declared_letters(source: str) -> frozenset[Letter]:
    """The letters that the words of a text introduce."""
    read = (x for each in declared(source) for x in statements(each.text))
    return frozenset(
        letter
        for each in read
        if isinstance(each, Statement)
        for letter in n.letters(each.sides[0])
    )
