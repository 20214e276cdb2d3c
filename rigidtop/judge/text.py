"""A whole text, judged statement by statement."""

from __future__ import annotations

import re
import time
from collections import Counter
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache
from math import inf
from typing import Final

from rigidtop.judge.ahead import explained_first
from rigidtop.judge.context import START, TIME, Context, Habits
from rigidtop.judge.judge import Judge
from rigidtop.judge.laws import ENERGIES, HAMILTONIANS, LAGRANGIANS, conjugates
from rigidtop.judge.meaning import is_component
from rigidtop.judge.outcome import DEFINITION, UNDECIDED, UNREAD, Outcome
from rigidtop.judge.question import Patience
from rigidtop.judge.sides import letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.starts import COORDINATES, at_rest, with_energy
from rigidtop.read.cues import Cue, ends_moment
from rigidtop.read.declared import declared
from rigidtop.read.macros import Macro, Macros, customary, defined
from rigidtop.read.passages import Passage, passages
from rigidtop.read.statements import statements
from rigidtop.read.walk import places
from rigidtop.terminal.limit import TooLong, within
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread

A_STATEMENT = 10.0
"""No statement is judged for longer than this (s, of the processor's time)."""

LATE = "the time for the file was over"


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
class Step:
    """What became of something asked, None where it says nothing, and what is known behind it.

    For so many `seconds` slips may still be looked for.
    """

    asked: Asked
    row: Row | None
    context: Context
    scope: tuple[int, ...] | None
    seconds: float


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
    return rows_of(made), made[-1].context if made else Context(read.habits)


def rows_of(made: Iterable[Step]) -> tuple[Row, ...]:
    """What became of each statement, in the order of the text."""
    rows = (step.row for step in made if step.row is not None)
    return tuple(sorted(rows, key=lambda row: row.number))


def reading(source: str, macros: Macros | None = None, until: float = inf) -> Reading:
    """What a text asks."""
    read, place = read_text(source, macros, until)
    cases = cases_of(read)
    habits = habits_of([each for _, each in read if isinstance(each, Statement)])
    moments = instants(read, habits.moving)
    asked = (
        Asked(
            place(passage.start + each.position)[0],
            *(each, passage, number, moment, passage.start in cases),
        )
        for number, ((passage, each), moment) in enumerate(zip(read, moments, strict=True))
    )
    return Reading(tuple(explained_first(asked)), habits, declared_letters(source))


def steps(read: Reading, until: float = inf, made: Sequence[Step] = ()) -> Iterator[Step]:
    """Each statement of a text judged, behind those that have been: they are not judged again."""
    last = made[-1] if made else None
    context, scope = Context(read.habits), None
    judge = Judge()
    if last is not None:
        context, scope = last.context, last.scope
        judge = Judge(patience=Patience(last.seconds))
    for asked in read.asked[len(made) :]:
        row, context = _step(asked, read, judge, context, scope, until)
        if row is not None and isinstance(asked.statement, Statement):
            scope = asked.passage.scope
        yield Step(asked, row, context, scope, judge.patience.seconds)


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
    if not each.relations:
        if Cue.DIVISOR in passage.cues:
            return None, replace(context, not_zero=(*context.not_zero, *each.sides))
        if Cue.CONSTANT not in passage.cues:
            return None, context
        each = Statement((n.Rate(each.sides[0]), n.Number("0")), ("=",), each.position)
    context = context.within(passage.scope, passage.sentence)
    if Cue.REST in passage.cues:
        context = at_rest(context, asked.number, passage.scope)
    if Cue.CONSERVED in passage.cues:
        context = with_energy(context, asked.number, passage.scope)
    each, time_of_it = at_one_time(each, read.habits.moving)
    if time_of_it is not None:
        moment = instant_at(time_of_it)
        context = replace(context, instants={**context.instants, moment: time_of_it})
    at = situation(passage, asked.number, moment, passage.scope != scope, read.names)
    at = replace(at, case=asked.is_case)
    if at.instant and is_time(each):
        context = replace(context, instants={**context.instants, at.instant: each.sides[1]})
        return row(Outcome(DEFINITION, "a moment")), context
    outcome, context = in_time(judge, each, at, context, until)
    return row(outcome, at), context


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


# --- Reading -------------------------------------------------------------------------------------

Read = list[tuple[Passage, Statement | Unread]]
_Macros = frozenset[tuple[str, Macro]]

_SHAPES: Final = {"ϕ": "φ", "ϑ": "θ", "ϵ": "ε"}
"""Letters that are written in two ways."""


def read_text(
    source: str, macros: Macros | None = None, until: float = inf, plain: bool = False
) -> tuple[Read, Callable[[int], tuple[int, int]]]:
    """The statements of a text with their passages, and what tells the line of a position.

    With `plain` mathematics outside of dollars is read too.
    """
    around = passages(source, plain)
    known = defined(source, {**customary(source), **(macros or {})})
    return statements_of(around, known, until), places(source)


def statements_of(text: Sequence[Passage], macros: Macros, until: float = inf) -> Read:
    """What each formula states, read with the functions of the whole text."""
    if any(_POINT.search(passage.text) for passage in text):
        text = [replace(x, text=_THOUSANDS.sub(_closed_up, x.text)) for x in text]
    own = frozenset(macros.items())
    once = [each for passage in text for each in _read(passage, own, until)]
    known, lettered = functions_of(once), _has_length(once)
    read = [
        (passage, each) for passage in text for each in _read(passage, own, until, known, lettered)
    ]
    table = str.maketrans(_shapes(each for _, each in read))
    return [(passage, _folded(each, table)) for passage, each in read] if table else read


_POINT = re.compile(r"\d\.\d")
_THOUSANDS = re.compile(r"(?<![\d.])\d{1,3}(?:\{,\}\d{3})+(?!\d)")
"""A comma between thousands, where a point stands before decimals."""


def _closed_up(match: re.Match[str]) -> str:
    """A number without commas, and as long as before."""
    return match[0].replace("{,}", "").ljust(len(match[0]))


def _read(
    passage: Passage,
    macros: _Macros,
    until: float,
    functions: frozenset[Letter] = frozenset(),
    lettered: bool = False,
) -> Sequence[Statement | Unread]:
    if time.process_time() > until:
        return (Unread(0, LATE),)
    return _statements(_whole(passage), macros, functions, lettered)


@lru_cache(maxsize=5_000)
def _statements(
    text: str, macros: _Macros, functions: frozenset[Letter], lettered: bool
) -> Sequence[Statement | Unread]:
    """What a formula states; of a text that is read again, only what is new is gone through."""
    return statements(text, dict(macros), functions, lettered)


def _whole(passage: Passage) -> str:
    """The text of a formula; the word "const" behind its last sign is its last side."""
    if not passage.display and "\\" not in passage.text:
        return re.sub(r"_([A-Za-z]{2,})", r"_{\1}", passage.text)
    if re.search(r"(=|≡|≈|\\equiv|\\approx)\s*$", passage.text) and re.match(
        r"\W*[ck]onst", passage.behind
    ):
        return passage.text + r"\mathrm{const}"
    return passage.text


def _shapes(read: Iterable[Statement | Unread]) -> dict[str, str]:
    """Which shapes of letters stand for which others: those of which a text has but one."""
    bases = {
        letter.base
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
        for letter in n.letters(side)
    }
    return {one: other for one, other in _SHAPES.items() if not {one, other} <= bases}


def _folded(each: Statement | Unread, table: dict[int, str]) -> Statement | Unread:
    """A statement with other shapes of its letters, in its indices too."""
    if isinstance(each, Unread):
        return each

    def change(node: Node) -> Node:
        if not isinstance(node, Letter):
            return node
        return replace(node, base=node.base.translate(table), sub=node.sub.translate(table))

    return replace(
        each,
        sides=tuple(n.mapped(side, change) for side in each.sides),
        conditions=tuple(_folded(x, table) for x in each.conditions),  # type: ignore[misc]
    )


# --- What stands around a statement --------------------------------------------------------------


def situation(
    passage: Passage, number: int, instant: str, opens: bool, names: frozenset[Letter]
) -> Situation:
    """What the words around a statement say of it."""
    cues = passage.cues
    return Situation(
        number,
        passage.scope,
        instant,
        passage.sentence,
        supposed=bool(cues & {Cue.CASE, Cue.CONDITION}),
        derived=Cue.DERIVED in cues,
        defined=Cue.DEFINED in cues,
        small=Cue.SMALL in cues or Cue.APPROXIMATED in cues,
        large=Cue.LARGE in cues,
        asked=Cue.ASKED in cues,
        origin=Cue.ORIGIN in cues,
        anew=Cue.ANEW in cues,
        oscillates=Cue.OSCILLATION in cues,
        begins=Cue.REST in cues,
        balanced=Cue.EQUILIBRIUM in cues,
        circular=Cue.CIRCLE in cues,
        vanishes=Cue.VANISHING in cues,
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


_STARTS = re.compile(
    r"\b(start|begin|initial|at first|released|let go|dropped|anfang|zu beginn|losgelassen"
    r"|début|lâché)",
    re.I,
)


def instants(read: Read, moving: frozenset[Letter] = frozenset()) -> list[str]:
    """The instant of which each statement speaks; "" for all times."""
    made: list[str] = []
    seen: set[Letter] = {Letter("t"), *moving}
    sentence, now, resting = -1, "", -1
    for passage, each in read:
        resting = passage.sentence if Cue.REST in passage.cues else resting
        begun = passage.display and resting == passage.sentence
        over = passage.sentence == sentence and ends_moment(passage.before)
        if passage.sentence != sentence:
            sentence, now = passage.sentence, ""
        if Cue.GENERAL in passage.cues or begun or over:
            now = ""
        elif Cue.MOMENT in passage.cues:
            said = _STARTS.search(f"{passage.before} § {passage.behind}")
            now = START if said else now or f"s{sentence}"
        if isinstance(each, Statement) and is_time(each) and now:
            value = each.sides[1]
            zero = isinstance(value, n.Number) and value.value == 0
            now = START if zero else now
        starts = isinstance(each, Statement) and _is_start(each)
        now = START if starts and now else now
        named = not passage.display and _introduces(each, seen)
        made.append(START if starts else "" if named else now)
        seen |= letters_in(each) if isinstance(each, Statement) else set()
    return made


def _introduces(each: Statement | Unread, seen: Collection[Letter]) -> bool:
    """Whether it says what a letter is of which nothing has been said: "at the height h = 2 m"."""
    if not isinstance(each, Statement) or each.relations != ("=",):
        return False
    return isinstance(each.sides[0], Letter) and each.sides[0] not in seen


def is_time(statement: Statement) -> bool:
    """Whether a statement says which moment is meant."""
    return statement.sides[0] == Letter("t") and statement.relations == ("=",)


def instant_at(time_of_it: Node) -> str:
    """The name of the instant at a time."""
    return START if time_of_it == n.Number("0") else f"t = {plain(time_of_it)}"


def at_one_time(statement: Statement, moving: frozenset[Letter]) -> tuple[Statement, Node | None]:
    """A statement such as x(0) = a as one of x, with the time at which it is said of it."""
    calls = {
        node
        for side in statement.sides
        for node in n.walked(side)
        if isinstance(node, n.Call) and _bare(node.function) in moving
    }
    times = {node.places for node in calls}
    inside = Counter(x for node in calls for x in n.walked(node) if x in moving)
    everywhere = {x for side in statement.sides for x in n.letters(side)} & moving
    if len(times) != 1 or everywhere - {*inside}:
        return statement, None
    [places] = times
    if len(places) != 1 or not isinstance(places[0], n.Number):
        return statement, None

    def now(node: Node) -> Node:
        return node.function if isinstance(node, n.Call) and node in calls else node

    sides = tuple(n.mapped(side, now) for side in statement.sides)
    return replace(statement, sides=sides), places[0]


def _is_start(statement: Statement) -> bool:
    """Whether a letter is given its own value with a 0 below: θ = θ₀."""
    if statement.relations != ("=",):
        return False
    left, right = statement.sides
    return isinstance(left, Letter) and not left.sub and right == replace(left, sub="0")


# --- Habits --------------------------------------------------------------------------------------


def functions_of(read: Iterable[Statement | Unread]) -> frozenset[Letter]:
    """The letters that are written with a place behind them: U(r), V(x)."""
    return frozenset(
        node.function
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
        for node in n.walked(side)
        if isinstance(node, n.Call) and isinstance(node.function, Letter)
    )


def _has_length(read: Iterable[Statement | Unread]) -> bool:
    """Whether a text uses d as a letter."""
    return any(
        Letter("d") in n.letters(side)
        for each in read
        if isinstance(each, Statement)
        for side in each.sides
    )


def _velocities(read: Sequence[Statement]) -> set[Letter]:
    """Letters that a product ties to a rate, as ω in R ω = ẋ, and of which an energy has a square.

    Θ̇ = Ω alone is as often a constant rate.
    """
    tied: set[Letter] = set()
    squared: set[Letter] = set()
    for each in read:
        for one, other in zip(each.sides, each.sides[1:], strict=False):
            for side, rates in ((one, other), (other, one)):
                if isinstance(side, n.Product) and any(
                    isinstance(x, n.Rate) and x.order == 1 for x in n.walked(rates)
                ):
                    tied |= {x for x in side.factors if isinstance(x, Letter)}
        if each.sides[0] in ENERGIES | {*LAGRANGIANS}:
            squared |= {
                x.base
                for side in each.sides[1:]
                for x in n.walked(side)
                if isinstance(x, n.Power) and x.exponent == n.Number("2")
                if isinstance(x.base, Letter) and x.base.base in "ωv"
            }
    return tied & squared


def _conjugate(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The momenta, and the coordinates, of a Hamiltonian of which the other one moves."""
    names = [
        frozenset().union(*map(n.letters, each.sides[1:]))
        for each in read
        if each.sides[0] in HAMILTONIANS
    ]
    pairs = {pair for each in names for pair in conjugates(each)}
    return {x for pair in pairs for x in pair if {*pair} & {*moving}}


def _parameters(read: Sequence[Statement], moving: Collection[Letter]) -> set[Letter]:
    """The letters that move what is said to be a function of them: u in s = 4a sin(u/2)."""
    given = ((x.sides[0], x.sides[1]) for x in read if x.relations[:1] == ("=",))
    parameters = set()
    for name, value in given:
        letters = n.letters(value)
        if name in moving and not letters & {*moving, TIME} and not isinstance(value, Letter):
            places = [x for x in letters if x.base in COORDINATES and not x.sub]
            parameters |= {*places} if len(places) == 1 else set()
    return parameters


_PLACE = Letter("x")


def _curves(read: Sequence[Statement], primed: Collection[Letter]) -> set[Letter]:
    """The letters with a prime that are given by a place x, as y is in y = c cosh(x/c)."""
    if _PLACE in primed:
        return set()  # a prime means other axes
    return {
        y
        for each in read
        for y in each.sides[:1]
        if isinstance(y, Letter) and y in primed and _PLACE in n.letters(each.sides[-1])
    }


def habits_of(read: Sequence[Statement]) -> Habits:
    """How a text uses its letters."""
    nodes = [node for each in read for side in each.sides for node in n.walked(side)]
    calls = [x for x in nodes if isinstance(x, n.Call)]
    running = running_of(read)
    timed = {x.function for x in calls if x.places == (running,)}
    timed |= {x.of for x in nodes if isinstance(x, n.Derivative) and x.by == (running,)}
    moving = {x for x in timed if isinstance(x, Letter)} | {
        of
        for x in nodes
        if isinstance(x, n.Rate) and not _is_function(x.of)
        for of in [_bare(x.of)]
        if isinstance(of, Letter)
    }
    moving |= _velocities(read)
    moving |= _conjugate(read, moving)
    moving |= _parameters(read, moving)
    functions: dict[Letter, tuple[Node, ...]] = {}
    for call in calls:
        function = call.function.of if isinstance(call.function, n.Primed) else call.function
        if not isinstance(function, Letter) or function in moving:
            continue
        if call.places != (running,) and all(isinstance(x, Letter) for x in call.places):
            functions.setdefault(function, call.places)
    primed = {x.of for x in nodes if isinstance(x, n.Primed) and isinstance(x.of, Letter)}
    functions |= dict.fromkeys(_curves(read, primed - {*functions} - moving), (_PLACE,))
    twice = any(isinstance(x, n.Primed) and x.order > 1 and x.of not in functions for x in nodes)
    dotted = any(isinstance(x, n.Rate) and x.dotted for x in nodes)
    primes_are_rates = twice and not dotted
    if primes_are_rates:
        moving |= primed - {*functions}
    indices = {x.base for node in nodes if isinstance(node, n.Total) for x in node.index}
    bold = {x for x in nodes if isinstance(x, Letter) and x.bold}
    vectors = {x for x in bold if not x.sub}
    moving |= {x for x in vectors if any(is_component(each, x) for each in moving)}
    entries = {
        (each.sides[0], x) for each in read for side in each.sides[1:] for x in n.letters(side)
    }
    lengths = {
        x
        for x in (replace(each, bold=False) for each in bold if each.sub in {"", *indices})
        if x not in moving and (replace(x, bold=True), x) not in entries and x.base not in "xyzt"
    }
    own = {
        side
        for each in read
        for side in each.sides[:1]
        if side in (Letter("i"), Letter("e"), Letter("π"))
    }
    return Habits(
        frozenset(moving),
        functions,
        frozenset(indices),
        frozenset(own),
        primes_are_rates,
        frozenset(lengths),
        frozenset(vectors),
        running,
    )


def running_of(read: Sequence[Statement]) -> Letter:
    """The letter with which everything moves: φ, if dS/dφ = μS is the first that is said of S.

    It is the time where that stands anywhere, or a rate.
    """
    before: frozenset[Letter] = frozenset()
    running = set()
    for each in read:
        nodes = [node for side in each.sides for node in n.walked(side)]
        if TIME in nodes or any(isinstance(x, n.Rate) for x in nodes):
            return TIME
        slopes = [x for x in nodes if isinstance(x, n.Derivative) and not x.partial]
        running |= {x.by for x in slopes if _is_unknown(x.of, before) and nodes.count(x.of) > 1}
        before |= frozenset().union(*map(n.letters, each.sides))
    [by] = running if len(running) == 1 else [(TIME,)]
    return by[0] if len(by) == 1 and isinstance(by[0], Letter) else TIME


def _is_unknown(node: Node, before: Collection[Letter]) -> bool:
    """Whether it is a letter that occurs for the first time."""
    return isinstance(node, Letter) and node not in before


def _is_function(node: Node) -> bool:
    """Whether it is written as a function of something else than the time, as F(q)."""
    return isinstance(node, n.Call) and Letter("t") not in node.places


def _bare(node: Node) -> Node:
    while isinstance(node, (n.Rate, n.Group)):
        node = node.of
    return node.function if isinstance(node, n.Call) else node
