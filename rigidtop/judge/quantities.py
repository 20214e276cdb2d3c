"""Letters that name what is known already: a an acceleration, T a kinetic energy, x_max a maximum.

What a text says of such a letter follows where it is what letters of that name stand for. Where it
is not the letter is something else, and named so.
"""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

from sympy import Expr, Integer, MatrixBase

from rigidtop.judge import energies, extremes
from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.context import SETTING, START, Constraint, Context, LetterDefinition
from rigidtop.judge.faults import slip
from rigidtop.judge.jets import TIME, jet_of, time_at
from rigidtop.judge.laws import LAGRANGIANS, coordinates
from rigidtop.judge.letters import (
    ANGLES,
    CLOCK,
    COORDINATES,
    MOMENTA,
    PERIODS,
    PLACES,
    SPEED,
    SPEEDS,
    TIMES,
    TURNING,
    VELOCITIES,
    is_mass,
)
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED, Outcome
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.quantity import Quantity
from rigidtop.judge.question import Judgement, Question, alone
from rigidtop.judge.sides import ZERO, named, own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant
from rigidtop.judge.worlds import symbols_of
from rigidtop.judge.written import written
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words

_SQUARE = n.Number("2")
_KINETIC, _POTENTIAL = Letter("T"), Letter("V")
_LATE = "at last"
_EXTREMES = ("max", "min", "top", "1", "2")


def with_meaning(question: Question, judgement: Judgement) -> Judgement:
    """What becomes of a new letter that names something known: it follows."""
    outcome, context = judgement
    left = question.left
    letter = left.base if isinstance(left, n.Power) else named(left)[0]
    named_already = question.context.definitions.keys() | (question.moving - {SPEED})
    worked_out = letter in LAGRANGIANS and outcome.verdict == DEFINITION
    new = isinstance(letter, Letter) and (worked_out or letter not in named_already)
    if outcome.verdict not in (DEFINITION, PREMISE) or question.inner or not new:
        return judgement
    if question.at.inline and not question.at.derived and not question.at.instant:
        return judgement  # what words name in passing
    assert isinstance(letter, Letter)
    elsewhere = Cue.ELSEWHERE in question.at.cues
    for each in () if elsewhere else _quantities(question, letter):
        with suppress(UnclearError, UnknownFunctionError):
            asked = _asked(question, letter, each)
            if asked.worlds.count and asked.left != asked.right and asked.holds():
                rests_on = asked.rests_on - {question.at.number}
                known = _lasting(question, letter, context)
                return Outcome(SAMPLED, f"it is {each.words}", rests_on), known
    wrong = _wrong(question, letter)
    return judgement if wrong is None else wrong


def _lasting(question: Question, letter: Letter, context: Context) -> Context:
    """What is known of a letter that is constant, also where it is said of one moment."""
    constant = question.left == letter and letter not in question.moving
    if not constant or letter in context.definitions or question.moves(*question.gaps):
        return context
    definition = LetterDefinition(question.right, question.at.number, question.at.scope)
    return context.defining(letter, definition)


def _asked(question: Question, letter: Letter, quantity: Quantity) -> Question:
    """Whether what is said of a letter is so of a quantity."""
    context = quantity.context or question.context
    if quantity.instant:
        at = replace(question.at, instant=quantity.instant)
        question = replace(question, at=at, premises=replace(question.premises, instant=at.instant))
    power = isinstance(question.left, n.Power)
    left = n.replaced(question.left, letter, quantity.node) if power else quantity.node
    return replace(question.within(context), left=left, asked=None)


def _quantities(question: Question, letter: Letter) -> Iterator[Quantity]:
    """What a letter usually names, by its base."""
    if not letter.sub:
        yield from _entries(question.context, letter)
    if letter.bold:
        yield from _vectors(question.context, letter)
    if letter.bold or letter.base == "Δ":
        return
    if letter.base == "a":
        yield from _accelerations(question)
    if letter.base in VELOCITIES | {"c"}:
        yield from _speeds(question, letter)
    if letter.base in "tτ" or (letter.base == "T" and letter.sub.isdigit()):
        yield from _zeros(question)
    if letter.base in PERIODS:
        yield from _turns(question)
    if letter.base in _TURNS:
        yield from _rates(question)
    if letter == _KINETIC:
        yield from energies.kinetic(question)
    if letter in LAGRANGIANS and not question.context.habits.extended:
        yield from energies.lagrangian(question)
    if letter in (_POTENTIAL, Letter("U")):
        yield from energies.weight(question)
    if letter.base in "UVW":
        yield from energies.effective(question)
    yield from _at_a_time(question.context, letter)
    yield from _when(question, letter)
    if letter.base in PLACES and not letter.sub:
        yield from _ways(question)
    if letter.base in MOMENTA and not letter.sub:
        yield from _momenta(question)
    entry = _entry(question, letter)
    if entry is not None:
        yield Quantity(_ENTRY, Meant(entry))
    yield from _in_a_case(question.context, letter)
    yield from _of_another(question, letter)
    if letter.sub in _EXTREMES:
        yield from extremes.quantities(question, letter)


def _in_a_case(context: Context, letter: Letter) -> Iterator[Quantity]:
    """What the letter without its index is in a case of that index: v₁ is v where r = r₁."""
    bare = replace(letter, sub="")
    cases = (c for c in context.constraints if c.kind == SETTING and not c.instant)
    others = {x for c in cases for x in c.letters}
    others |= {x for x, d in context.definitions.items() if _is_value(x, d.node)}
    there = any(x.sub == letter.sub and x != letter for x in others)
    if letter.sub and there and bare in context.letters:
        yield Quantity(f"{in_words(bare)} there", bare)


_INERTIAS = frozenset("JIΘ")
"""Moments of inertia, which add up where a body is laid on another."""


def _of_another(question: Question, letter: Letter) -> Iterator[Quantity]:
    """What the letter without its index is with others of that index in place, or added.

    T₁ = 2π √((J + J₁)/D) after T = 2π √(J/D).
    """
    context = question.context
    known = {c.left: c.right for c in context.followed if not c.instant}
    known |= {x: d.node for x, d in context.definitions.items()}
    others = [replace(letter, sub=""), replace(letter, sub="0")]
    bare = next((x for x in others if x in known and x != letter), letter)
    own = {x: replace(x, sub="") for x in own_letters(question.right) if x.sub == letter.sub}
    if not letter.sub or bare == letter or not own.keys() - {letter}:
        return
    sums = all(is_mass(x) or x.base in _INERTIAS for x in own if x != letter)
    for added in (False, True) if sums else (False,):
        node = known[bare]
        for other, plain in own.items():
            node = n.replaced(node, plain, n.Bracketed(n.Sum((plain, other))) if added else other)
        if node != known[bare]:
            yield Quantity(f"what {in_words(bare)} is of the other", node)


def _momenta(question: Question) -> Iterator[Quantity]:
    """The momentum of each coordinate of a Lagrangian that the text defines."""
    function = next((x for x in LAGRANGIANS if x in question.context.definitions), None)
    if function is None:
        return
    with suppress(UnclearError):
        for jet in coordinates(question.meaning().scalar(function)):
            words = f"the momentum of {in_words(jet.letter)}"
            yield Quantity(words, n.Derivative(function, (n.TimeDerivative(jet.letter, 1, True),)))


_ENTRY = "an entry of the matrix"


def _entry(question: Question, letter: Letter) -> Expr | None:
    """The entry of a matrix of which the letter has the row and the column as its index: K₁₂."""
    axes = next((x for x in ("123", "xyz") if letter.sub and {*letter.sub} <= {*x}), "")
    if not axes or len(letter.sub) != 2:
        return None
    row, column = map(axes.index, letter.sub)
    for name in (Letter(letter.base), Letter(letter.base, bold=True)):
        if name in question.context.definitions:
            matrix = question.meaning().value(name)
            if isinstance(matrix, MatrixBase) and max(row, column) < min(matrix.shape):
                return matrix[row, column]
    return None


def _is_value(letter: Letter, node: Node) -> bool:
    """Whether a letter stands for the one without its index: r₁ for r."""
    bare = replace(letter, sub="")
    same = isinstance(node, Meant) and node.value == alone(bare)
    return bool(letter.sub) and (node == bare or same)


def _vectors(context: Context, letter: Letter) -> Iterator[Quantity]:
    """The velocity and the acceleration of the place **r**."""
    place = Letter("r", bold=True)
    if place in context.definitions and not letter.sub:
        for base, order in (("v", 1), ("a", 2)):
            if letter.base == base:
                yield Quantity("the rate of **r**", n.TimeDerivative(place, order, True))


# --- Velocities and accelerations ----------------------------------------------------------------


def _accelerations(question: Question) -> Iterator[Quantity]:
    context = question.context
    for x in sorted(question.moving, key=str):
        if x.base in (COORDINATES - ANGLES) | {SPEED.base} and not x.bold:
            yield Quantity(f"the acceleration of {in_words(x)}", _change_of(x))
    # v² = 2 a s, where nothing is said of rates.
    places = [x for x in map(Letter, sorted(PLACES)) if x in context.letters]
    if SPEED in context.letters and not question.moving and len(places) == 1:
        [place] = places
        way = Constraint(n.TimeDerivative(place, 1, True), SPEED, question.at.number, SUPPOSED)
        driven = n.letters(context.definitions[SPEED].node) if SPEED in context.definitions else ()
        turning = {x for x in driven if x.base in TURNING}
        moving = context.habits.moving | {place, SPEED, *turning}
        known = replace(context, habits=replace(context.habits, moving=moving)).holding(way)
        yield Quantity("the acceleration", n.TimeDerivative(SPEED, 1, True), known)


def _ways(question: Question) -> Iterator[Quantity]:
    """How far something has come with a speed that is given in time, from zero at first."""
    yield from _stopping(question)
    context = question.context
    speeds = [c.right for c in context.followed if c.left == SPEED and not c.instant]
    speeds += [SPEED] if SPEED in context.definitions else []
    placed = any(c.instant == START and c.left == question.left for c in context.constraints)
    if not speeds or question.at.instant or placed:
        return
    speed, way = (question.meaning().value(x) for x in (speeds[-1], question.right))
    if isinstance(speed, MatrixBase) or isinstance(way, MatrixBase) or not speed.has(TIME):
        return
    goes = question.of([(way.diff(TIME), speed), (way.subs(TIME, 0), Integer(0))])
    if way.has(TIME) and not question.moves(way) and goes.worlds.count and goes.holds():
        yield Quantity("the way at that speed", Meant(way))


def _stopping(question: Question) -> Iterator[Quantity]:
    """How far something comes with a speed that stands in the right side before it stops."""
    speeds = [x for x in own_letters(question.right) if x.base in VELOCITIES and not x.bold]
    if Cue.STOPPING not in question.at.cues or len(speeds) != 1:
        return
    for x in sorted(question.moving, key=str):
        if x.base in PLACES and not x.bold:
            twice = n.Product((_SQUARE, n.Absolute(n.TimeDerivative(x, 2, True))))
            way = n.Quotient(n.Power(speeds[0], _SQUARE), twice)
            yield Quantity(f"the way until {in_words(x)} stops", way)


def _change_of(x: Letter) -> Node:
    """The acceleration of a place, or the rate of a speed."""
    return n.TimeDerivative(x, 1 if x.base in SPEEDS else 2, True)


def _speeds(question: Question, letter: Letter) -> Iterator[Quantity]:
    context, at = question.context, question.at
    for x in sorted(question.moving, key=str):
        if x.base in SPEEDS and not x.bold and x != letter:
            still = Constraint(
                n.TimeDerivative(x, 1, True), ZERO, at.number, SETTING, at.scope, _LATE
            )
            known = context.forgetting(x).holding(still)
            words = f"the speed that {in_words(x)} reaches"
            yield Quantity(words, n.Absolute(x), known, instant=_LATE)
    for x in sorted(question.moving, key=str):
        if x.base in PLACES and not x.bold:
            yield Quantity(f"the rate of {in_words(x)}", n.TimeDerivative(x, 1, True))
    components = [x for x in map(Letter, "xyz") if x in context.definitions]
    if len(components) > 1 and any(question.meaning().value(x).has(TIME) for x in components):
        squares = tuple(n.Power(n.TimeDerivative(x, 1, True), _SQUARE) for x in components)
        yield Quantity("the speed", n.Root(n.Sum(squares)))
    speed = _speed(question)
    if speed is None:
        return
    yield Quantity("the speed", speed)
    for x in sorted(question.moving, key=str):  # at the lowest point
        if at.instant and x.base in COORDINATES:
            middle = Constraint(x, ZERO, at.number, SETTING, at.scope, at.instant)
            yield Quantity(
                f"the speed where {in_words(x)} vanishes", speed, context.holding(middle)
            )


def _speed(question: Question) -> Node | None:
    """The speed of the one body of which the kinetic energy is known."""
    kinetic = energies.kinetic_part(question)
    if kinetic is None:
        return None
    masses = [
        x for x in symbols_of([kinetic]) if (jet := jet_of(x)) is not None and is_mass(jet.letter)
    ]
    if len(masses) != 1 or kinetic.diff(masses[0]).has(masses[0]):
        return None
    return n.Root(Meant(2 * kinetic / masses[0]))


_TURNS = TURNING | {"n"}
"""Letters of how fast something turns, and of how often."""


def _rates(question: Question) -> Iterator[Quantity]:
    """The rates of the angles that move."""
    for x in sorted(question.moving, key=str):
        if x.base in ANGLES and not x.bold:
            yield Quantity(f"the rate of {in_words(x)}", n.TimeDerivative(x, 1, True))


def _turns(question: Question) -> Iterator[Quantity]:
    """How long a turn takes at a rate that is known."""
    turn = n.Product((n.Number("2"), Letter("π")))
    for x in sorted(question.context.letters, key=str):
        if x.base in _TURNS and not x.bold:
            yield Quantity("the time of a turn", n.Quotient(turn, x))
    for each in _rates(question):
        yield Quantity("the time of a turn", n.Quotient(turn, n.Absolute(each.node)))


# --- Times, and values at them -------------------------------------------------------------------


def _zeros(question: Question) -> Iterator[Quantity]:
    """A time at which something that is given in time, or its rate, vanishes."""
    if isinstance(question.left, n.Power):
        return
    for each in reversed(question.context.constraints):
        if each.instant not in ("", START) and each.instant not in question.context.instants:
            words = f"when {in_words(each.left)} is {in_words(each.right)}"
            yield Quantity(words, Meant(time_at(each.instant)), instant=each.instant)
            break
    for x in sorted(question.context.definitions, key=str):
        if x.base not in COORDINATES | SPEEDS:
            continue
        with suppress(UnclearError, UnknownFunctionError):
            value = question.meaning().value(x)
            when = question.meaning().scalar(question.right)
            if isinstance(value, MatrixBase):
                continue
            ways = [(value, x), (value.diff(TIME), n.TimeDerivative(x, 1, True))]
            if question.at.cues & {Cue.LANDING, Cue.TURNING}:  # a speed vanishes where it turns
                lands = (x.base in SPEEDS) == (Cue.TURNING in question.at.cues)
                ways = ways[:1] if lands else ways[1:] if x.base not in SPEEDS else []
            for given, name in ways:
                there = question.of([(given.subs(TIME, when), Integer(0))])
                if given.has(TIME) and there.worlds.count and there.holds():
                    yield Quantity(f"when {in_words(name)} vanishes", Meant(when))


def _at_a_time(context: Context, letter: Letter) -> Iterator[Quantity]:
    """What is given in time at a moment t₁ that has the same index, or at the latest one."""
    same = replace(CLOCK, sub=letter.sub) if letter.sub else None
    latest = [x for x in context.instants.values() if x is not None and x != ZERO]
    for time in (same if same in context.definitions else None, *latest[-1:]):
        for x in sorted(context.definitions, key=str):
            own = x.base == letter.base or time is not same
            if time is not None and own and x != letter and x.base in COORDINATES | SPEEDS:
                yield Quantity(f"{in_words(x)} at that time", n.At(x, CLOCK, time))
            if time is not None and letter.base == SPEED.base and x.base in PLACES:
                way = n.Absolute(n.At(n.TimeDerivative(x, 1, True), CLOCK, time))
                yield Quantity(f"the rate of {in_words(x)} at that time", way)


def _when(question: Question, letter: Letter) -> Iterator[Quantity]:
    """What is given in time at a time that stands in the right side: v₁ = c − g τ."""
    bare = replace(letter, sub="")
    if letter.sub and bare in question.context.definitions:
        for time in sorted(own_letters(question.right), key=str):
            if time.base in TIMES and time not in question.context.definitions:
                words = f"{in_words(bare)} after {in_words(time)}"
                yield Quantity(words, n.At(bare, CLOCK, time))


# --- Matrices of what has names ------------------------------------------------------------------


def _entries(context: Context, letter: Letter) -> Iterator[Quantity]:
    """The matrix of what I_xx, I_xy, … stand for."""

    def entry(row: str, column: str) -> Letter | None:
        names = (Letter(letter.base, row + column), Letter(letter.base, column + row))
        return next((x for x in names if x in context.definitions), None)

    for axes in ("xyz", "123"):
        rows = [[entry(row, column) for column in axes] for row in axes]
        if all(row[k] is not None for k, row in enumerate(rows)):
            entries = tuple(tuple(x or ZERO for x in row) for row in rows)
            yield Quantity("the matrix of its entries", n.Matrix(entries))


def _wrong(question: Question, letter: Letter) -> Judgement | None:
    """The slip in a kinetic energy, where it is said where the body is, or in a matrix's entry."""
    if question.left != letter:
        return None
    entry = _entry(question, letter)
    known = [] if entry is None else [Quantity(_ENTRY, n.Bracketed(written(entry)))]
    if letter == _KINETIC and not _written_places(question):
        known += energies.kinetic(question)
    for each in known:
        asked = _asked(question, letter, each)
        with suppress(UnclearError, UnknownFunctionError):
            wrong = slip(asked)
            if wrong is not None and wrong.change.left == asked.left:
                line = f"{latex(letter)} = {latex(wrong.change.right)}"
                righted = LetterDefinition(each.node, question.at.number, question.at.scope)
                return replace(wrong.outcome, right=line), question.context.defining(
                    letter, righted
                )
    return None


def _written_places(question: Question) -> list[Letter]:
    """The places in which the right side itself is written."""
    return [x for x in own_letters(question.right) if x.base in "xyz"]
