"""Facts to first order: one component hardly changes, and all others that move are small."""

from __future__ import annotations

from dataclasses import replace

import sympy
from sympy import Expr, Integer, Symbol

from rigidtop.judge.context import LAW, Constraint, Context
from rigidtop.judge.jets import Jet, jets, symbol
from rigidtop.judge.outcome import Outcome
from rigidtop.judge.sides import NEARLY, ZERO
from rigidtop.judge.vocabulary import Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement

TO_FIRST_ORDER = "to first order"


def linearised(each: Statement, small: bool, number: int, context: Context) -> Context | None:
    """What is known behind ω₁ ≈ const, ω₁ ≈ w or ω̇₁ ≈ 0: the law for ω₁ is ω̇₁ = 0.

    None if it says something else, or if what is left out is not of second order in the others.
    `small`: words say that something is, so that "=" means "≈".
    """
    left, right = each.sides[0], each.sides[-1]
    nearly = bool({*each.relations} & {*NEARLY}) or small
    match left, right:
        case Letter() as letter, (n.Constant() | Letter()):
            pass
        case n.TimeDerivative(Letter() as letter, 1), _ if right == ZERO:
            pass
        case _:
            return None
    if not nearly or letter not in context.habits.moving or right in context.given:
        return None
    rate = symbol(Jet(letter, 1))
    laws = [c for c in context.constraints if c.kind == LAW and _value(c.left) == rate]
    if len(laws) != 1 or not _is_of_second_order(_value(laws[0].right), letter, context):
        return None
    still = Constraint(Meant(rate), Meant(Integer(0)), number, LAW)
    kept = (c for c in context.constraints if c is not laws[0])
    return replace(context, constraints=(*kept, still))


def remembering(each: Statement, outcome: Outcome, number: int, context: Context) -> Context:
    """What is known with an equation for one component, if it follows: exp(κ t) is put into it."""
    left, *_, right = each.sides
    equal = {*each.relations} <= {"=", *NEARLY}
    if not (outcome.passed and equal and isinstance(left, n.TimeDerivative)):
        return context
    if left.order < 2:
        return context
    return context.holding(Constraint(left, right, number, LAW))


def _value(node: n.Node) -> Expr | None:
    return sympy.sympify(node.value) if isinstance(node, Meant) else None


def _is_of_second_order(value: Expr | None, letter: Letter, context: Context) -> bool:
    """Whether it vanishes with its slope where all else that moves is small."""
    assert value is not None
    size = Symbol("size")
    moving = [
        x
        for x, jet in jets(value).items()
        if jet.letter in context.habits.moving and jet.letter != letter
    ]
    scaled = value.xreplace({x: size * x for x in moving})
    return bool(moving) and all(
        sympy.expand(scaled.diff(size, order).subs(size, 0)) == 0 for order in (0, 1)
    )
