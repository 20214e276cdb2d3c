"""What has to do with a question of all that holds, with its rates."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping, Sequence
from functools import lru_cache

import sympy
from sympy import Expr, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.judge.context import (
    FIELD,
    Constraint,
    Context,
)
from rigidtop.judge.jets import (
    TIME,
    Jet,
    jet_of,
    jets,
    operations,
    rate,
    symbol,
    symbols,
)
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.residual import Residual
from rigidtop.judge.values import LARGEST, is_identity, plain
from rigidtop.tree.nodes import Letter, letters

INSTANTS_OF_TIME = 4
"""What holds for all times and has the time in it is asked at so many."""


def base_of(x: Symbol) -> object:
    """The letter of a number, whatever its order; numbers of another instant are others."""
    jet = jet_of(x)
    return x if jet is None else (jet.letter, jet.place, jet.instant)


@lru_cache(maxsize=20_000)
def bases_of(expression: Expr) -> frozenset[object]:
    """The letters of an expression, and the unknown functions in it, but for the time."""
    functions = {x.func for x in functions_in(expression)}
    return frozenset({base_of(x) for x in symbols(expression)} - {TIME} | functions)


@lru_cache(maxsize=20_000)
def functions_in(expression: Expr) -> frozenset[Expr]:
    """The unknown functions in an expression, each at its places."""
    return frozenset(expression.atoms(AppliedUndef))


def related(asked: Iterable[Expr], pool: Sequence[Residual]) -> list[Residual]:
    """What has a letter of what is asked, or of what has one."""
    need = {x for e in asked for x in bases_of(e)}
    chosen: list[Residual] = []
    left = [(each, bases_of(each.expression)) for each in pool]
    grown = True
    while grown:
        apart = []
        for each, own in left:
            if own & need:
                chosen.append(each)
                need |= own
            else:
                apart.append((each, own))
        grown = len(apart) < len(left)
        left = apart
    return chosen


def surrounding(
    asked: Iterable[Expr], context: Context, pool: Sequence[Residual], deep: bool = False
) -> tuple[list[Expr], frozenset[int], list[Residual]]:
    """The equations, with their rates, that have to do with what is asked; what they rest on.

    Where it is `deep`, rates are taken of all that moves, as if each letter's were asked: of two
    equations together a letter may go out of which no rate is asked.
    """
    wanted = list(asked)
    chosen = related(wanted, pool)
    equations: list[Expr] = []
    orders = _orders([*wanted, *(each.expression for each in chosen)])
    if deep:
        most = max(orders.values(), default=0)
        orders = {x: most if _moves(x, context) else order for x, order in orders.items()}
    for each in chosen:
        equations += _prolonged(each, orders, context)
    rests_on = frozenset().union(*(each.rests_on for each in chosen))
    return plain(equations), rests_on, chosen


def _moves(base: object, context: Context) -> bool:
    return isinstance(base, tuple) and base[0] in context.habits.moving


def _prolonged(residual: Residual, orders: dict[object, int], context: Context) -> list[Expr]:
    """An equation with its rates, as far as rates of its letters are asked."""
    made = [residual.expression]
    if residual.instant:
        return made
    if is_identity(residual.expression):
        return []  # what is put into it solves it
    if residual.kind == FIELD and residual.constraint is not None:
        return _everywhere(residual.expression, residual.constraint, context)
    moving = context.habits.moving
    here = residual.expression
    if (
        TIME in symbols(here)
        and not functions_in(here)
        and all(not j.order and j.letter not in moving for j in jets(here).values())
    ):
        # Nothing in it moves but the time: it holds at every time.
        return made + [
            here.xreplace({TIME: sympy.Rational(k, 7)}) for k in range(1, INSTANTS_OF_TIME)
        ]
    for _ in range(3):
        if _rises_beyond(here, orders, moving):
            break
        here = rate(here, moving)
        if here == 0 or _is_beyond(here, orders) or operations(here) > LARGEST:
            break
        made.append(here)
    return made


def _is_beyond(expression: Expr, orders: dict[object, int]) -> bool:
    """Whether a rate in it is of a higher order than any that is asked."""
    return any(n > orders.get(x, 0) for x, n in _orders([expression]).items())


def _rises_beyond(expression: Expr, orders: dict[object, int], moving: frozenset[Letter]) -> bool:
    """Whether it is seen that its rate would be beyond, before that is worked out.

    The rate of a letter that stands in one place alone can't be cancelled by anything.
    """
    return any(
        jet.order + 1 > orders.get((jet.letter, jet.place, jet.instant), 0)
        for x, jet in jets(expression).items()
        if not jet.instant
        and (jet.order or jet.letter in moving)
        and x in standing_once(expression)
    )


@lru_cache(maxsize=20_000)
def standing_once(expression: Expr) -> frozenset[Symbol]:
    """The letters that stand in one place of an expression and in no other."""
    return frozenset(x for x, count in _counts(expression).items() if count == 1)


@lru_cache(maxsize=20_000)
def _counts(node: Expr) -> Mapping[Symbol, int]:
    """In how many places each letter stands."""
    if node.is_Symbol:
        return {node: 1}
    made: Counter[Symbol] = Counter()
    for part in node.args:
        made.update(_counts(part))
    return made


def _everywhere(expression: Expr, constraint: Constraint, context: Context) -> list[Expr]:
    """What holds at every place, at a few of them, where it is known what the function is."""
    if functions_in(expression):
        return [expression]
    functions = context.habits.functions
    names = letters(constraint.left) | letters(constraint.right)
    places = {x for name in names if name in functions for x in functions[name]}
    numbers = (TIME if x == CLOCK else symbol(Jet(x)) for x in places)  # type: ignore[arg-type]
    inner = sorted(numbers, key=str)
    return [
        expression.xreplace({x: sympy.Rational(k + j, 7) for j, x in enumerate(inner, 2)})
        for k in range(INSTANTS_OF_TIME)
    ]


def _orders(expressions: Iterable[Expr]) -> dict[object, int]:
    made: dict[object, int] = {}
    for expression in expressions:
        for jet in jets(expression).values():
            key = jet.letter, jet.place, jet.instant
            made[key] = max(made.get(key, 0), jet.order)
    return made


def highest(equations: Sequence[Expr]) -> list[Symbol]:
    """The highest rate of each letter that has one."""
    orders = _orders(equations)
    found = {x: jet for e in equations for x, jet in jets(e).items()}
    return sorted(
        (
            x
            for x, jet in found.items()
            if jet.order and orders[jet.letter, jet.place, jet.instant] == jet.order
        ),
        key=str,
    )
