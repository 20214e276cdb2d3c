"""Small motions beside a steady one: θ = θ₀ + ε with the same momenta as that of θ₀."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace

from sympy import Expr, Integer

from rigidtop.judge.context import LAW, SETTING, START, Constraint, Context
from rigidtop.judge.jets import Jet, jets, rate, symbol
from rigidtop.judge.laws import coordinates, lagrangian
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.sides import ZERO, letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant, Memory
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement

STEADY = "steady"
"""The index of the rates of the steady motion, and the instant at which its place is passed."""


def beside(statement: Statement, at: Situation, context: Context, memory: Memory) -> Context | None:
    """What is known of a small motion beside a steady one; None if none is spoken of.

    At θ₀ the steady motion obeys the law of θ, and the momenta of what does not occur but by its
    rate, as φ, are those of the steady motion.
    """
    small = next(_deviations(statement, context), None)
    if small is None:
        return None
    steady = _Steady.of(small, context, memory)
    if steady is None:
        return None
    for gap in steady.gaps(None, {}, context.habits.moving):
        constraint = Constraint(Meant(gap), ZERO, at.number, SETTING, at.scope)
        context = context.holding(constraint)
    return context


def around(statement: Statement, number: int, context: Context, memory: Memory) -> Context:
    """What is known behind θ = θ₀ + ε of a coordinate that is given; else the context as it is.

    A letter that stands for the rate of another coordinate, as Ω = φ̇, is that of the steady motion
    from there on, and at one instant the motion passes θ₀.  If it is said which rates there are at
    the start, that is where it is let go.
    """
    found = _parted(statement, context)
    if found is None:
        return _varying(statement, context)
    place, centre, small = found
    if any(isinstance(c.left, n.TimeDerivative) for c in context.constraints if c.instant == START):
        return context.holding(Constraint(place, centre, number, LAW, (), START))  # let go there
    habits = replace(context.habits, moving=context.habits.moving | {small})
    names = _rates_with_names(context)
    kept = {x: d for x, d in context.definitions.items() if x not in names.values()}
    known = replace(context, habits=habits, definitions=kept)
    steady = _Steady.of(place, known, memory)
    if steady is None:
        return context
    known = replace(known, constraints=tuple(_passing(c, centre) for c in known.constraints))
    for gap in steady.gaps(centre, names, habits.moving):
        known = known.holding(Constraint(Meant(gap), ZERO, number, LAW))
    passed = {place: centre} | {n.TimeDerivative(q, 1, True): name for q, name in names.items()}
    for letter, value in passed.items():
        known = known.holding(Constraint(letter, value, number, LAW, (), STEADY))
    return known


def _passing(constraint: Constraint, centre: Letter) -> Constraint:
    """What is said of f(θ₀), said of f when the motion passes θ₀: its other letters change too."""

    def then(node: n.Node) -> n.Node:
        match node:
            case n.Call(Letter() as function, (place,)) if place == centre:
                return function
        return node

    left, right = n.mapped(constraint.left, then), n.mapped(constraint.right, then)
    if (left, right) == (constraint.left, constraint.right):
        return constraint
    return replace(constraint, left=left, right=right, instant=STEADY)


def is_steady(context: Context) -> bool:
    """Whether a motion beside a steady one is supposed."""
    return any(c.instant == STEADY for c in context.constraints)


def _varying(statement: Statement, context: Context) -> Context:
    """The context in which η moves if φ̇ = Ω + η is said, where Ω is that of a steady motion."""
    steady = {c.right for c in context.constraints if c.instant == STEADY}
    match statement.sides:
        case (n.TimeDerivative(Letter()), n.Sum((one, other))) if {one, other} & steady:
            small = other if one in steady else one
            if isinstance(small, Letter) and small not in context.given:
                moving = context.habits.moving | {small}
                return replace(context, habits=replace(context.habits, moving=moving))
    return context


def _parted(statement: Statement, context: Context) -> tuple[Letter, Letter, Letter] | None:
    """The coordinate, the constant and the small letter of θ = θ₀ + ε; None if it is none."""
    match statement.sides:
        case (Letter() as place, n.Sum((first, second))):
            centre, small = _untimed(first), _untimed(second)
        case _:
            return None
    if not isinstance(centre, Letter) or not isinstance(small, Letter):
        return None
    if replace(small, sub="") == place:
        centre, small = small, centre
    moves = place in context.habits.moving and place in context.given
    if moves and replace(centre, sub="") == place and not {centre, small} & context.given:
        return place, centre, small
    return None


def _untimed(node: n.Node) -> n.Node:
    """A letter without the time behind it: ε for ε(t)."""
    match node:
        case n.Call(Letter() as letter, (place,)) if place == CLOCK:
            return letter
    return node


def _rates_with_names(context: Context) -> dict[Letter, Letter]:
    """The letters that move with one that stands for their rate: φ with Ω."""
    return {
        definition.node.of: name
        for name, definition in context.definitions.items()
        if isinstance(definition.node, n.TimeDerivative) and isinstance(definition.node.of, Letter)
    }


@dataclass(frozen=True, eq=False)
class _Steady:
    """A motion in which one coordinate rests, and of the others only the rates occur."""

    L: Expr
    place: Letter
    others: tuple[Jet, ...]

    @classmethod
    def of(cls, place: Letter, context: Context, memory: Memory) -> _Steady | None:
        """None if there is no Lagrangian, or another coordinate than that one occurs in it."""
        try:
            L, _, _ = lagrangian(context, memory)
        except UnclearError:
            return None
        others = tuple(q for q in coordinates(L) if q.letter != place)
        return None if any(L.has(symbol(q)) for q in others) else cls(L, place, others)

    def gaps(
        self, centre: Letter | None, names: Mapping[Letter, Letter], moving: frozenset[Letter]
    ) -> list[Expr]:
        """What vanishes: the law of the coordinate at its centre, the changes of the momenta.

        Without a `centre` that is zero; `names` are those of the rates of the others, if they have.
        """
        middle = symbol(Jet(centre)) if centre is not None else Integer(0)
        speeds = [symbol(replace(q, order=1)) for q in self.others]
        still = [names.get(q.letter, _hidden(q.letter)) for q in self.others]
        rates = {speed: symbol(Jet(name)) for speed, name in zip(speeds, still, strict=True)}
        x, way = symbol(Jet(self.place)), symbol(Jet(self.place, 1))

        def at_rest(value: Expr) -> Expr:
            found = jets(value).items()
            rest = {y: 0 for y, jet in found if jet.order > 1}
            rest |= {y: 0 for y, jet in found if jet.letter == self.place and jet.order}
            put: Expr = value.subs(rest).subs(rates).subs(x, middle)
            return put

        momenta = [self.L.diff(speed) for speed in speeds]
        law = at_rest(rate(self.L.diff(way), moving) - self.L.diff(x))
        return [law, *(momentum - at_rest(momentum) for momentum in momenta)]


def _hidden(letter: Letter) -> Letter:
    """The rate of a coordinate in the steady motion, where nothing calls it anything."""
    return replace(letter, sub=letter.sub + STEADY)


def _deviations(statement: Statement, context: Context) -> Iterator[Letter]:
    """The letters that move in a statement, and by which a coordinate differs from a constant."""
    moving = context.habits.moving
    for letter, definition in context.definitions.items():
        match definition.node:
            case n.Sum(terms) if letter in moving and all(isinstance(x, Letter) for x in terms):
                own = {*terms} & moving
                if len(own) == 1 and own <= letters_in(statement):
                    yield from own  # type: ignore[misc]
