"""What holds in a context as expressions that vanish: constraints, Lagrange's equations, rates."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

from sympy import Expr, Integer, MatrixBase, Symbol

from rigidtop.judge import worlds
from rigidtop.judge.brackets import conjugates
from rigidtop.judge.context import (
    FORCED,
    LAW,
    LINEAR,
    PREMISE,
    RULE,
    START,
    Constraint,
    Context,
)
from rigidtop.judge.jets import (
    TIME,
    Jet,
    at_instant,
    jets,
    rate,
    symbol,
    time_at,
)
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.names import is_vector
from rigidtop.judge.particles import particles
from rigidtop.judge.residual import Residual
from rigidtop.judge.surroundings import surrounding
from rigidtop.judge.values import LARGEST, UnclearError, pairs, plain
from rigidtop.judge.vocabulary import Memory
from rigidtop.tree.nodes import (
    Derivative,
    Letter,
    Negative,
    Number,
    TimeDerivative,
    letters,
    mapped,
    walked,
)

MULTIPLIERS = frozenset({"λ", "μ", "Λ"})
"""Letters that are multipliers where a Lagrangian is linear in them."""

LAGRANGIANS = (Letter("L"), Letter("ℒ"), Letter("𝓛"))
_KINETIC = (Letter("T"), Letter("K"), Letter("E", "c"), Letter("E", "k"), Letter("E", "kin"))
_POTENTIAL = (Letter("V"), Letter("U"), Letter("E", "p"), Letter("E", "pot"))
ENERGIES = frozenset({*_KINETIC, *_POTENTIAL})
"""Letters of kinetic and potential energies."""


def residuals(context: Context, memory: Memory, instant: str = "") -> list[Residual]:
    """Everything that vanishes in a context, Lagrange's equations among it; at an instant too."""
    rules = [each for c in context.constraints for each in _for_each(c, context, memory)]
    made = [each for c in rules for each in _of(c, context, memory)]
    made += [] if context.lawless else lagrange(context, memory, made)
    return then(_linear(made), context, memory, instant)


def _for_each(constraint: Constraint, context: Context, memory: Memory) -> Iterable[Constraint]:
    """A rule for any coordinate q as what it says of each one that the Lagrangian has."""
    if constraint.kind != RULE:
        return [constraint]
    spoken = letters(constraint.left) | letters(constraint.right)
    names = {x for x in spoken if is_any(x)}
    try:
        L, _, _ = lagrangian(context, memory)
    except UnclearError:
        return []

    def of(letter: Letter) -> Constraint:
        sides = (
            mapped(side, lambda node: letter if node in names else node)
            for side in (constraint.left, constraint.right)
        )
        left, right = sides
        return replace(constraint, left=left, right=right, kind=FORCED)

    return [of(jet.letter) for jet in coordinates(L)]


def is_any(letter: Letter) -> bool:
    """Whether it stands for any coordinate by its name: q, q_i."""
    return letter.base == "q" and letter.sub in {"", *"ijklsαν"} and not letter.bold


def then(
    pool: list[Residual], context: Context, memory: Memory, instant: str = ""
) -> list[Residual]:
    """What holds, with what it says of other instants: laws hold there, and what is conserved is
    what it is now."""
    instants = {each.instant for each in pool} | {instant}
    made = list(pool)
    for name in sorted(instants - {""}):
        always = [each for each in pool if not each.instant]
        for each in [*always, *conserved(context, memory, always)]:
            here = each.expression
            there = moved(here, name, context, memory)
            gap = here - there if each.kind == _KEPT else there
            if gap != 0 and gap != here:
                made.append(Residual(gap, each.rests_on, each.kind, None, name))
            if name != START and _ties_places(each, context.habits.moving):
                change = moved(rate(here, context.habits.moving), name, context, memory)
                if change != 0:  # what ties places ties their rates
                    made.append(Residual(change, each.rests_on, each.kind, None, name))
    return made


def _ties_places(residual: Residual, moving: frozenset[Letter]) -> bool:
    """Whether it ties the places of several letters that move, and so their rates."""
    found = jets(residual.expression).values()
    letters = {jet.letter for jet in found if jet.letter in moving}
    stated = residual.kind in (PREMISE, LAW)
    return stated and len(letters) > 1 and not any(jet.order for jet in found)


_KEPT = "kept"


def conserved(context: Context, memory: Memory, pool: Sequence[Residual]) -> list[Residual]:
    """The quantities with a name that do not change, as what they are."""
    made = []
    for value, used in _quantities(context, memory):
        change = rate(value, context.habits.moving)
        if change == 0 or value.has(TIME):
            continue
        key = value, tuple(each.expression for each in pool)
        if key not in memory.conserved:
            equations, _, _ = surrounding([change], context, pool)
            found = worlds.found(equations, worlds.symbols_of([*equations, *plain([change])]))
            memory.conserved[key] = bool(found.holds([(plain([change])[0], Integer(0))]))
        if memory.conserved[key]:
            made.append(Residual(value, used, _KEPT))
    return made


def _quantities(context: Context, memory: Memory) -> Iterator[tuple[Expr, frozenset[int]]]:
    """What letters stand for, and the energy of a Lagrangian, with what says so."""
    for letter, definition in context.definitions.items():
        if definition.index or is_vector(letter):
            continue
        meaning = Meaning(context, memory)
        with suppress(UnclearError):
            yield meaning.scalar(letter), frozenset(meaning.used)
    with suppress(UnclearError):
        L, rests_on, _ = lagrangian(context, memory)
        rates = [symbol(replace(jet, order=1)) for jet in coordinates(L)]
        yield sum((x * L.diff(x) for x in rates), -L), rests_on


def _linear(made: list[Residual]) -> list[Residual]:
    """With linear equations in place of the laws, where there is one for each that moves."""
    approximate = [each for each in made if each.kind == LINEAR]
    exact = [each for each in made if each.kind != LINEAR]
    moved_by = {jet.letter for each in approximate for jet in _accelerations(each)}
    replaced = [
        each
        for each in exact
        if each.kind in (LAW, FORCED, PREMISE)
        and {jet.letter for jet in _accelerations(each)} & moved_by
    ]
    if any({jet.letter for jet in _accelerations(each)} - moved_by for each in replaced):
        return exact
    return approximate + [each for each in exact if each not in replaced]


def _accelerations(residual: Residual) -> list[Jet]:
    return [jet for jet in jets(residual.expression).values() if jet.order > 1]


def _of(constraint: Constraint, context: Context, memory: Memory) -> list[Residual]:
    meaning = Meaning(context, memory)
    left, right = constraint.left, constraint.right
    both = []
    try:
        for bound in particles(context.habits.indices, left, right):
            inner = meaning.with_(bound=bound)
            both += pairs(inner.value(left), inner.value(right))
    except UnclearError:
        return []
    rests_on = frozenset(meaning.used | {constraint.number})
    made = []
    for left, right in both:
        gap = left - right
        if constraint.instant:
            gap = moved(gap, constraint.instant, context, memory)
        if gap != 0:
            made.append(Residual(gap, rests_on, constraint.kind, constraint, constraint.instant))
    return made


def moved(expression: Expr, instant: str, context: Context, memory: Memory) -> Expr:
    """What an expression is at an instant of the context."""
    place = context.instants.get(instant, Number("0") if instant == START else None)
    time: Expr = time_at(instant)
    if place is not None:
        time = Meaning(context, memory).scalar(place)
    return at_instant(expression, instant, context.habits.moving, time)


# --- Lagrange's equations ------------------------------------------------------------------------


def lagrangian(context: Context, memory: Memory) -> tuple[Expr, frozenset[int], Letter | None]:
    """The Lagrangian of a context with what it rests on: L, else T − V; raises UnclearError."""
    for letter in LAGRANGIANS:
        if letter in context.definitions:
            meaning = Meaning(context, memory)
            value = meaning.value(letter)
            if not isinstance(value, MatrixBase) and _is_lagrangian(value):
                return value, frozenset(meaning.used), letter
    kinetic = next((x for x in _KINETIC if x in context.definitions), None)
    potential = next((x for x in _POTENTIAL if x in context.definitions), None)
    if kinetic and potential and not any(x in context.letters for x in LAGRANGIANS):
        meaning = Meaning(context, memory)
        value = meaning.scalar(kinetic) - meaning.scalar(potential)
        if _is_lagrangian(value):
            return value, frozenset(meaning.used), None
    raise UnclearError("there is no Lagrangian")


def coordinates(L: Expr) -> list[Jet]:
    """The letters whose rates an expression has."""
    return sorted(
        {replace(jet, order=0) for jet in jets(L).values() if jet.order == 1 and not jet.instant},
        key=lambda jet: str(symbol(jet)),
    )


def _is_lagrangian(L: Expr) -> bool:
    """Whether accelerations come of it: it has rates, more than linearly, and none higher."""
    if any(jet.order > 1 for jet in jets(L).values()):
        return False
    for x, jet in jets(L).items():
        if jet.order == 0 and jet.letter in ENERGIES and L.diff(x) in (1, -1):
            return False
    speeds = [symbol(replace(q, order=1)) for q in coordinates(L)]
    return any(L.diff(v).diff(w) != 0 for v in speeds for w in speeds)


def lagrange(
    context: Context, memory: Memory, given: Sequence[Residual], L: Expr | None = None
) -> list[Residual]:
    """Lagrange's equations of the first kind, with a multiplier for each tie of coordinates."""
    rests_on: frozenset[int] = frozenset()
    against: list[Drag] = []
    try:
        if L is None:
            L, rests_on, written = lagrangian(context, memory)
            # Beside energies alone a force that is defined is one that acts.
            against = [*drags(context, memory)] if written is None else []
    except UnclearError:
        return []
    L, tied = _in_rates(L, given, context.habits.moving)
    rests_on |= tied
    q = [x for x in coordinates(L) if x.letter not in context.habits.driven]
    own = [x for x, jet in jets(L).items() if _is_multiplier(L, x, jet)]
    ties = [] if own else [each for each in given if _is_tie(each, q)]
    made = [Residual(L.diff(x), rests_on, LAW) for x in own]
    for jet in q:
        place, speed = symbol(jet), symbol(replace(jet, order=1))
        gap = rate(L.diff(speed), context.habits.moving | {jet.letter}) - L.diff(place)
        used = rests_on
        for k, tie in enumerate(ties):
            slope = _slope(tie.expression, place, speed)
            if slope != 0:
                gap -= Symbol(f"multiplier {k}", real=True) * slope
                used |= tie.rests_on
        for drag in (x for x in against if x.along == jet):
            gap -= drag.force
            used |= drag.rests_on
        forced = any(_has_force(gap, each) for each in given if each.kind == FORCED)
        if gap != 0 and gap.count_ops() <= LARGEST and not forced:
            made.append(Residual(gap, used, LAW))
    return made


@dataclass(frozen=True)
class Drag:
    """A force along a coordinate that vanishes with its rate."""

    along: Jet
    force: Expr
    rests_on: frozenset[int]


def drags(context: Context, memory: Memory) -> Iterator[Drag]:
    """The forces that a text defines by one velocity, as F_v = −c ẋ."""
    for letter, definition in context.definitions.items():
        if letter.base not in "Ff" or letter.bold:
            continue
        meaning = Meaning(context, memory)
        try:
            force = meaning.scalar(letter)
        except UnclearError:
            continue
        rates = [(x, jet) for x, jet in jets(force).items() if jet.order]
        match rates:
            case [(speed, jet)] if jet.order == 1 and force.subs(speed, 0) == 0:
                used = frozenset(meaning.used | {definition.number})
                yield Drag(replace(jet, order=0), force, used)


HAMILTONIANS = (Letter("H"), Letter("ℋ"), Letter("𝓗"))


def hamilton(context: Context) -> list[Constraint]:
    """Hamilton's equations for each momentum of a Hamiltonian: q̇ = ∂H/∂p and ṗ = −∂H/∂q.

    In other letters it may have another form, as ωP, that has been found equal to it.
    """
    function = next((x for x in HAMILTONIANS if x in context.definitions), None)
    if function is None or context.lawless:
        return []
    definition, moving = context.definitions[function], context.habits.moving
    made = []
    for form in (definition.node, *definition.also):
        if any(isinstance(x, TimeDerivative) for x in walked(form)):
            continue  # in velocities it is a number, and no Hamiltonian
        own = letters(form) & moving
        if form is definition.node:
            own -= context.definitions.keys()
        for q, p in conjugates(own | moving if form is not definition.node else own):
            if not own & {q, p}:
                continue
            both = (q, Derivative(form, (p,))), (p, Negative(Derivative(form, (q,))))
            made += [
                Constraint(
                    TimeDerivative(x, 1, True), is_, definition.number, LAW, definition.scope
                )
                for x, is_ in both
            ]
    return made


def _in_rates(
    L: Expr, given: Sequence[Residual], moving: frozenset[Letter]
) -> tuple[Expr, frozenset[int]]:
    """A Lagrangian with rates in place of the velocities that premises tie to them, as R ω = ẋ."""
    used: frozenset[int] = frozenset()
    q = {*coordinates(L)}
    for each in given:
        found = jets(each.expression).items()
        rates = [jet for _, jet in found if jet.order == 1]
        speeds = [
            x
            for x, jet in found
            if not jet.order and jet.letter in moving and jet not in q and L.has(x)
        ]
        if each.kind != PREMISE or each.instant or not rates or len(speeds) != 1:
            continue
        [speed] = speeds
        slope = each.expression.diff(speed)
        if slope.has(speed) or any(jet.order > 1 for _, jet in found):
            continue
        L = L.subs(speed, speed - each.expression / slope)
        used |= each.rests_on
    return L, used


def _has_force(gap: Expr, law: Residual) -> bool:
    """Whether a law is Lagrange's equation but for a force, which has no accelerations."""
    force = (gap - law.expression).expand()
    return not any(jet.order > 1 for jet in jets(force).values())


def _is_multiplier(L: Expr, x: Symbol, jet: Jet) -> bool:
    return (
        jet.order == 0
        and jet.letter.base in MULTIPLIERS
        and not jet.letter.sub.isdigit()
        and L.diff(x) != 0
        and L.diff(x, 2) == 0
        and not any(other.order for other in jets(L.diff(x)).values())
        and _ties(L.diff(x), coordinates(L))
    )


def _ties(gap: Expr, q: Sequence[Jet]) -> bool:
    """Whether an equation ties coordinates to each other, or one to a length."""
    found = [symbol(jet) for jet in q if gap.has(symbol(jet))]
    if len(found) > 1:
        return True
    return bool(found) and gap.is_polynomial(*found) and gap.subs(found[0], 0) != 0


def _is_tie(residual: Residual, q: Sequence[Jet]) -> bool:
    """Whether it ties coordinates to each other, as rolling does, and is no special motion."""
    if residual.kind != PREMISE or residual.instant:
        return False
    found = jets(residual.expression).values()
    tied = {replace(jet, order=0) for jet in found} & {*q}
    order = max((jet.order for jet in found), default=0)
    linear = order == 0 or all(
        residual.expression.diff(symbol(replace(jet, order=1)), 2) == 0 for jet in tied
    )
    return len(tied) > 1 and order <= 1 and linear


def _slope(tie: Expr, place: Symbol, speed: Symbol) -> Expr:
    has_rates = any(jet.order for jet in jets(tie).values())
    return tie.diff(speed if has_rates else place)
