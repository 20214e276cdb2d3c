"""What a text may leave unsaid: contexts in which a line may be meant where it does not follow.

If it follows in one of them, that was meant. A slip there is told where little else can be.
"""

from __future__ import annotations

from collections.abc import Collection, Iterator
from dataclasses import dataclass, replace

from rigidtop.judge import neighbours, places, states
from rigidtop.judge.context import SETTING, START, Constraint, Context, LetterDefinition
from rigidtop.judge.habits import bare
from rigidtop.judge.laws import LAGRANGIANS, drags
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.sides import is_acceleration, letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.starts import (
    with_acceleration,
    with_coordinates,
    with_energy,
    with_force,
)
from rigidtop.judge.vocabulary import Meant, Memory
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node, letters
from rigidtop.tree.statement import Statement


@dataclass(frozen=True, eq=False)
class Supposition:
    """A context in which a statement may be meant, with what the words would say then.

    It `lasts` where what is supposed is known from there on, and `tells` where a slip is one;
    `words` say what is supposed, where that has to be said.
    """

    statement: Statement
    situation: Situation
    context: Context
    lasts: bool = False
    tells: bool = False
    words: str = ""


def suppositions(
    statement: Statement, at: Situation, context: Context, memory: Memory, is_open: bool
) -> Iterator[Supposition]:
    """What may be meant with a statement that does not follow; it may be wrong unless `is_open`."""
    for each in _possible(statement, at, context, memory, is_open):
        same = each.context is context and each.statement is statement
        if not same or each.situation.instant != at.instant:
            yield each


def _possible(
    statement: Statement, at: Situation, context: Context, memory: Memory, is_open: bool
) -> Iterator[Supposition]:
    """The same, with the context as it is where there is nothing to suppose."""
    if not at.inline:
        general = context.without_cases(letters_in(statement) - {statement.sides[0]})
        yield Supposition(statement, at, general, lasts=True)
    turned = _with_rates_for_primes(statement)
    yield Supposition(turned, at, context, words="with a prime for the rate")
    along = _along_the_motion(statement, context)
    yield Supposition(along, at, context, words="along the motion" if along != statement else "")
    if passed := _where_it_passes(statement, context):
        for each in dict.fromkeys((statement, along)):
            yield Supposition(each, replace(at, instant=passed), context)
    stated = states.stated(statement, at, context)
    yield Supposition(statement, at, stated or context, tells=True)
    nearly = _to_first_order(at, context)
    yield Supposition(statement, at, nearly or context, tells=True)
    alike = places.alike(at, context)
    yield Supposition(statement, at, alike or context, lasts=True, tells=True)
    equal = _both_equal(at, context)
    yield Supposition(statement, at, equal or context, lasts=True)
    numbered = _with_indices(statement, at, context)
    yield Supposition(statement, at, numbered or context)
    weighed = _with_gravity(statement, at, context)
    yield Supposition(statement, at, weighed or context, words="with g = 9.81 m/s²")
    by_axes = Cue.COMPONENTS in at.cues and not at.cues & {Cue.ELSEWHERE, Cue.OTHER}
    columns = with_coordinates(statement, at, context) if by_axes else None
    yield Supposition(statement, at, columns or context, lasts=True, tells=True)
    begun = places.begun(statement, at, context)
    if begun is not None:
        yield Supposition(statement, at, with_energy(begun, at.number, at.scope), lasts=True)
    if _accelerates(statement):
        lawless = not any(x in context.definitions for x in LAGRANGIANS)
        damped = any(drags(context, memory))
        if is_open and lawless and not (at.inline or at.instant or damped):
            conserved = with_energy(context, at.number, at.scope)
            yield Supposition(statement, at, conserved, lasts=True, tells=at.derived)
        beside = neighbours.beside(statement, at, context, memory)
        yield Supposition(statement, at.hearing(Cue.SMALL), beside or context)
        moved = with_acceleration(context, at.number)
        yield Supposition(statement, at, moved or context, lasts=True, tells=True)
        thrown = _without_potential(at, context)
        yield Supposition(statement, at, thrown or context, words="with no potential energy")
        forced = with_force(statement, context, at.number)
        yield Supposition(statement, at, forced or context, lasts=True, tells=True)
    meant_there = Cue.THERE in at.cues and not at.cues & {Cue.GENERAL, Cue.ELSEWHERE, Cue.OTHER}
    if meant_there and (not at.instant or not _is_placed(at.instant, context)):
        then = _at_the_latest_moment(statement, at, context)
        yield Supposition(statement, then or at, context, words="at that moment")
        timed = _at_the_latest_time(statement, context)
        always = replace(at, instant="") if timed is not None else at
        yield Supposition(timed or statement, always, context, words="at that time")
    resting = places.rests(statement, at, context) if at.balanced else None
    yield Supposition(statement, at, resting or context, words="where it can rest")
    for there in places.placed(statement, at, context):
        changed = places.with_rates(statement, context)
        yield Supposition(changed, at, there, tells=True)


def _with_rates_for_primes(statement: Statement) -> Statement:
    """The statement in which u′ is the rate of u, whatever that is a function of."""

    def turned(node: Node) -> Node:
        match node:
            case n.Primed(Letter(bold=False) as letter, order):  # of a vector it is a frame
                return n.TimeDerivative(letter, order, True)
        return node

    sides = tuple(n.mapped(side, turned) for side in statement.sides)
    return statement if sides == statement.sides else replace(statement, sides=sides)


def _along_the_motion(statement: Statement, context: Context) -> Statement:
    """The statement with the ratio of rates Ġ/θ̇ for the slope dG/dθ by what moves."""
    moving = context.habits.moving

    def ratio(node: Node) -> Node:
        match node:
            case n.Derivative(Letter() as of, (Letter() as by,), False) if by in moving:
                return n.Quotient(n.TimeDerivative(of, 1, True), n.TimeDerivative(by, 1, True))
        return node

    sides = tuple(n.mapped(side, ratio) for side in statement.sides)
    return statement if sides == statement.sides else replace(statement, sides=sides)


def _where_it_passes(statement: Statement, context: Context) -> str:
    """The instant at which a slope is taken: dG/dθ in a line with θ₀; nothing if there is none."""
    nodes = [x for side in statement.sides for x in n.walked(side)]
    by = {x for node in nodes if isinstance(node, n.Derivative) for x in node.by}
    there = (c for c in context.constraints if c.instant and c.left in by and c.right in nodes)
    return next((c.instant for c in there), "")


def _at_the_latest_moment(
    statement: Statement, at: Situation, context: Context
) -> Situation | None:
    """Where something that moves is said to be at the moment of which the text spoke last."""
    moments = [c.instant for c in context.constraints if c.instant not in ("", START)]
    left, *_, right = statement.sides
    names = {bare(left)} if letters(right) & context.habits.moving else letters(left)
    if not moments or not names & context.habits.moving:
        return None
    return replace(at, instant=moments[-1])


def _is_placed(instant: str, context: Context) -> bool:
    """Whether it is known when an instant is, or what is so then."""
    return instant in context.instants or any(c.instant == instant for c in context.constraints)


def _at_the_latest_time(statement: Statement, context: Context) -> Statement | None:
    """What is said of something that moves as what it is at the time t₁ that was found last."""
    times = {x: d.number for x, d in context.definitions.items() if x.base == CLOCK.base and x.sub}
    side, *others = statement.sides
    if not times or side not in context.habits.moving & context.definitions.keys():
        return None
    place = n.At(side, CLOCK, max(times, key=times.__getitem__))
    return replace(statement, sides=(place, *others))


def _accelerates(statement: Statement) -> bool:
    """Whether a second rate stands in it."""
    nodes = (x for side in statement.sides for x in n.walked(side))
    return any(map(is_acceleration, nodes))


def _without_potential(at: Situation, context: Context) -> Context | None:
    """What is known where the Lagrangian is the kinetic energy alone; None if there is another."""
    energies = {Letter(x) for x in "VUEH"} | {*LAGRANGIANS}
    kinetic = next((x for x in map(Letter, "TK") if x in context.definitions), None)
    known = context.letters | context.definitions.keys()
    if not context.habits.weightless or kinetic is None or energies & known:
        return None
    return context.defining(LAGRANGIANS[0], LetterDefinition(kinetic, at.number, at.scope))


def _to_first_order(at: Situation, context: Context) -> Context | None:
    """What is known without exact laws of what is constant only as long as others are small."""
    stays = {
        c.left
        for c in context.constraints
        if c.left in context.habits.moving and not c.instant and isinstance(c.right, Letter)
        if c.right not in context.habits.moving
    }
    if not (at.small and stays):
        return None
    kept = tuple(c for c in context.constraints if not _has_rate_of(c, stays))
    return replace(context, constraints=kept) if len(kept) < len(context.constraints) else None


def _has_rate_of(constraint: Constraint, names: Collection[Node]) -> bool:
    nodes = (x for side in (constraint.left, constraint.right) for x in n.walked(side))
    return any(isinstance(x, n.TimeDerivative) and x.of in names for x in nodes)


def _both_equal(at: Situation, context: Context) -> Context | None:
    """What is known where the last two letters that stand for something are equal, by the words."""
    named = {x: d for x, d in context.definitions.items() if not isinstance(d.node, Letter)}
    if Cue.BOTH_EQUAL not in at.cues or len(named) < 2:
        return None
    one, other = sorted(named, key=lambda x: named[x].number)[-2:]
    return context.holding(Constraint(one, other, at.number, SETTING, at.scope))


def _with_indices(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known where new letters with an index are what those without it are, of that index.

    v₂/v₁ is r₂²/r₁² after v = r² g/η; None if there are none.
    """
    there = context.letters | letters_in(statement)
    found = {c.left: c.right for c in context.followed if not c.instant}
    made = context
    new = sorted((x for x in letters_in(statement) - context.letters if x.sub), key=str)
    bases = [replace(x, sub="") for x in new]
    for name, base in zip(new, bases, strict=True):
        if bases.count(base) < 2:
            continue  # one of them alone may be another body's
        known = context.definitions.get(base)
        value = known.node if known is not None else found.get(base)
        if value is None or isinstance(value, Meant):
            continue
        own = {x: replace(x, sub=name.sub) for x in letters(value) if not x.sub}
        own = {x: other for x, other in own.items() if other in there}
        node = value
        for letter, other in own.items():
            node = n.replaced(node, letter, other)
        if own:
            made = made.defining(name, LetterDefinition(node, at.number, at.scope))
    return made if made is not context else None


_WEIGHT = Letter("g")


def _with_gravity(statement: Statement, at: Situation, context: Context) -> Context | None:
    """What is known with the usual g, where a number is said that g of no value stands behind."""
    free = _WEIGHT in context.letters and _WEIGHT not in context.definitions
    left, right = statement.sides[0], statement.sides[-1]
    number = not letters(right) and any(isinstance(x, n.Number) for x in n.walked(right))
    if not free or not number or left == _WEIGHT or letters(left) & context.habits.moving:
        return None
    value: Node = n.Number("9.81")
    if any(isinstance(x, n.Unit) for x in n.walked(right)):
        second = n.Power(n.Unit("s"), n.Number("2"))
        value = n.Product((value, n.Quotient(n.Unit("m"), second)))
    return context.defining(_WEIGHT, LetterDefinition(value, at.number, at.scope))
