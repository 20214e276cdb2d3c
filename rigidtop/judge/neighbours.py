"""Small motions beside a steady one: θ = θ₀ + ε with the same momenta as that of θ₀."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from sympy import Expr

from rigidtop.judge.context import SETTING, Constraint, Context
from rigidtop.judge.jets import Jet, jets, rate, symbol
from rigidtop.judge.laws import coordinates, lagrangian
from rigidtop.judge.sides import ZERO, letters_in
from rigidtop.judge.situation import Situation
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant, Memory
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement

STEADY = "steady"
"""The index of the rates of the steady motion."""


def beside(statement: Statement, at: Situation, context: Context, memory: Memory) -> Context | None:
    """What is known of a small motion beside a steady one; None if none is spoken of.

    At θ₀ the steady motion obeys the law of θ, and the momenta of what does not occur but by its
    rate, as φ, are those of the steady motion.
    """
    small = next(_deviations(statement, context), None)
    if small is None:
        return None
    try:
        L, _, _ = lagrangian(context, memory)
    except UnclearError:
        return None
    others = [q for q in coordinates(L) if q.letter != small]
    if any(L.has(symbol(q)) for q in others):
        return None
    speeds = {q: symbol(replace(q, order=1)) for q in others}
    steady: dict[Expr, Expr] = {
        speed: symbol(Jet(replace(q.letter, sub=q.letter.sub + STEADY)))
        for q, speed in speeds.items()
    }
    x, way = symbol(Jet(small)), symbol(Jet(small, 1))
    moving = context.habits.moving
    law = rate(L.diff(way), moving) - L.diff(x)
    rest = {y: 0 for y, jet in jets(law).items() if jet.letter == small or jet.order > 1}
    gaps = [law.subs(rest).subs(steady)]
    for speed in speeds.values():
        momentum = L.diff(speed)
        still = {y: 0 for y, jet in jets(momentum).items() if jet.letter == small}
        gaps.append(momentum - momentum.subs(still).subs(steady))
    for gap in gaps:
        constraint = Constraint(Meant(gap), ZERO, at.number, SETTING, at.scope)
        context = context.holding(constraint)
    return context


def _deviations(statement: Statement, context: Context) -> Iterator[Letter]:
    """The letters that move in a statement, and by which a coordinate differs from a constant."""
    moving = context.habits.moving
    for letter, definition in context.definitions.items():
        match definition.node:
            case n.Sum(terms) if letter in moving and all(isinstance(x, Letter) for x in terms):
                own = {*terms} & moving
                if len(own) == 1 and own <= letters_in(statement):
                    yield from own  # type: ignore[misc]
