"""Put together and take apart: sums, products, squares, components, one side with the other."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from functools import partial

from sympy import Abs, Expr, Integer, MatrixBase, Pow, Rational, Symbol

from rigidtop.proof import bounds
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Equation, SumOver, VolumeIntegral, as_printed
from rigidtop.proof.moves.conditions import divided_by, flat_with
from rigidtop.proof.moves.move import (
    Condition,
    Known,
    Move,
    Order,
    Pair,
    Performed,
    RefusedError,
    Scope,
    the_factor,
    the_one,
)
from rigidtop.proof.moves.orders import NEGLECTED, OF_NO_ORDER, nothing_hidden
from rigidtop.proof.moves.pairs import (
    all_pairs,
    equal_pairs,
    mapped,
    pairs_of,
    said_pairs,
    scalars,
)
from rigidtop.proof.moves.signs import without_bars
from rigidtop.proof.values import Value, Vector, flattened, vanishes


def put(move: Move, algebra: Algebra) -> Performed:
    """Put … into …: the equation as it is; what is put in follows."""
    known = the_one(move)
    return Performed(tuple(all_pairs(known, algebra)), known.scope, order=known.order)


def component(move: Move, algebra: Algebra) -> Performed:
    """Along one axis, or along several: the scalar product with each."""
    pairs: list[Pair] = []
    known = the_one(move)
    for axis in move.by:
        pairs += mapped(move, algebra, partial(algebra.dot, algebra.value(axis))).pairs
    return Performed(tuple(pairs), known.scope, order=known.order)


def dot(move: Move, algebra: Algebra) -> Performed:
    return _product(move, algebra, algebra.dot)


def cross(move: Move, algebra: Algebra) -> Performed:
    return _product(move, algebra, algebra.cross)


def _product(move: Move, algebra: Algebra, times: Callable[[Value, Value], Value]) -> Performed:
    if len(move.of) == 2:
        first, second = (equal_pairs(k, algebra) for k in move.of)
        pairs = [
            Pair(times(p.left, q.left), times(p.right, q.right)) for p in first for q in second
        ]
        return Performed(tuple(pairs), max(k.scope for k in move.of))
    vector = algebra.value(the_factor(move))
    return mapped(
        move, algebra, lambda v: times(vector, v) if move.power == 0 else times(v, vector)
    )


def adding(sign: int) -> Callable[[Move, Algebra], Performed]:
    def combine(move: Move, algebra: Algebra) -> Performed:
        """Add … to …, subtract … from …; `by` are the factors that each is taken with.

        One thing alone is a term that both sides get, if it is not what an equation says it is.
        """
        values = [algebra.value(f) for f in move.by]
        terms, factors = (values, []) if len(values) == 1 else ([], values)
        factors = factors or [Integer(1)] * len(move.of)
        if len(move.of) != 2 and not (terms and len(move.of) == 1):
            raise RefusedError("{} takes two equations", move.verb)
        *named, second = (
            [_times(f, p, algebra, move) for p in _compared(k, algebra)]
            for k, f in zip(move.of, factors, strict=True)
        )
        first = [*(pair for pairs in named for pair in pairs), *(Pair(x, x) for x in terms)]
        minus = Integer(sign)
        pairs = [
            Pair(
                algebra.total([c.left, algebra.times(minus, a.left)]),
                algebra.total([c.right, algebra.times(minus, a.right)]),
                _of_sum(_TURNED.get(a.relation, "=") if sign < 0 else a.relation, c.relation),
            )
            for a in first
            for c in second
        ]
        order = _of_both([_shifted(k.order, f) for k, f in zip(move.of, factors, strict=True)])
        return Performed(tuple(pairs), max(k.scope for k in move.of), order=order)

    return combine


def _of_both(orders: Sequence[Order | None]) -> Order | None:
    """The order of the error of a sum, from those of the two that are added: the larger error."""
    known = [order for order in orders if order is not None]
    if any(order.small == NEGLECTED for order in known):
        raise RefusedError(OF_NO_ORDER)
    if len({(order.small, order.together) for order in known}) > 1:
        raise RefusedError("two small quantities at once: expand in one after the other")
    return min(known, key=lambda order: order.power, default=None)


_TURNED = {"<": ">", ">": "<", "≤": "≥", "≥": "≤"}


def _compared(known: Known, algebra: Algebra) -> list[Pair]:
    """The pairs of sides of which one is larger, or else, as `said_pairs`, of equal sides."""
    unequal = any(equation.relation in _TURNED for equation in known.equations)
    pairs = all_pairs(known, algebra) if unequal else said_pairs(known, algebra)
    return [p for p in pairs if p.relation in _TURNED] if unequal else pairs


def _times(factor: Value, pair: Pair, algebra: Algebra, move: Move) -> Pair:
    """Both sides with a factor, of which the sign has to be known where one side is larger."""
    relation = pair.relation
    if relation in _TURNED:
        known = (*move.where, *move.bounds)
        if bounds.positive(*flat_with(-factor, known)):
            relation = _TURNED[relation]
        elif not bounds.positive(*flat_with(factor, known)):
            raise RefusedError("{} has no known sign: an inequality may turn round", factor)
    left, right = algebra.times(factor, pair.left), algebra.times(factor, pair.right)
    return Pair(left, right, relation)


def _of_sum(one: str, other: str) -> str:
    """The relation between sums of sides; strict if that of one of the two is."""
    if "≈" in (one, other):
        if {one, other} <= {"=", "≈"}:
            return "≈"
        raise RefusedError("{} and {}: nothing follows for the sum", one, other)
    ways = {"less" if relation in "<≤" else "more" for relation in (one, other) if relation != "="}
    if len(ways) > 1:
        raise RefusedError("{} and {}: nothing follows for the sum", one, other)
    return max((one, other), key="=≤≥<>".index)


def sum_over(move: Move, algebra: Algebra) -> Performed:
    """Over all parts of a body, for each of which the equation holds."""
    [index] = move.by
    return mapped(
        move, algebra, lambda v: v if v == 0 else algebra.summed(SumOver(index, Integer(1)), v)
    )


def multiply(move: Move, algebra: Algebra) -> Performed:
    if len(move.of) == 2:  # by an equation: side by side
        return _product(move, algebra, algebra.times)
    factor = algebra.value(the_factor(move))
    known = the_one(move)
    if any(p.relation in _TURNED for p in all_pairs(known, algebra)):
        pairs = [_times(factor, p, algebra, move) for p in all_pairs(known, algebra)]
        return Performed(tuple(pairs), known.scope)
    right = move.power == 1
    made = mapped(
        move, algebra, lambda v: algebra.times(v, factor) if right else algebra.times(factor, v)
    )
    if known.order is not None:
        small = known.order.together or (known.order.small,)
        nothing_hidden(flattened(factor)[0], known, small, algebra.letters)
    return replace(made, order=_shifted(known.order, factor))


def divide(move: Move, algebra: Algebra) -> Performed:
    factor = algebra.value(the_factor(move))
    if isinstance(factor, (Vector, MatrixBase)) or not factor.is_commutative:
        raise RefusedError("a division by what is no scalar")
    if vanishes(factor):
        raise RefusedError("a division by 0")
    made = multiply(replace(move, by=(1 / factor,)), algebra)
    return replace(made, conditions=divided_by(factor, move.settings))


def _shifted(order: Order | None, factor: Expr) -> Order | None:
    """The order of an error that is multiplied by a factor."""
    if order is None:
        return None
    lowest = min((order.lowest(x) for x in scalars(factor)), default=0)
    return replace(order, power=order.power + lowest)


def rewrite(move: Move, algebra: Algebra) -> Performed:
    """As it is, or several together."""
    if len(move.of) > 1 and any(known.order is not None for known in move.of):
        raise RefusedError("what is approximate is rewritten by itself")
    pairs = tuple(pair for known in move.of for pair in all_pairs(known, algebra))
    if move.where:
        pairs = tuple(_without_bars(pair, move.where) for pair in pairs)
    scope = max((known.scope for known in move.of), default=Scope.IDENTITY)
    return Performed(pairs, scope, order=the_one(move).order if len(move.of) == 1 else None)


def _without_bars(pair: Pair, conditions: Sequence[Condition]) -> Pair:
    """A pair of which conditions say whether |x| is x or −x."""

    def bare(side: Value) -> Value:
        return without_bars(side, conditions) if isinstance(side, Expr) and side.has(Abs) else side

    return replace(pair, left=bare(pair.left), right=bare(pair.right))


def exchange(move: Move, algebra: Algebra) -> Performed:
    """Two indices change places: what holds for any two parts, holds for them the other way."""
    known = the_one(move)
    one, two = move.by
    letters = algebra.letters
    there = {**letters.exchanged, **{new: old for old, new in letters.exchanged.items()}}

    def turned(tree: Expr) -> Expr:
        if isinstance(tree, (SumOver, VolumeIntegral)):
            index, body = tree.args
            return tree.func({one: two, two: one}.get(index, index), turned(body))
        if isinstance(tree, Symbol):
            if letters.indexed.get(tree, frozenset()) & {one, two}:
                if tree not in there:
                    raise RefusedError("{} with the other index has no letter", tree)
                return there[tree]
            return tree
        if not tree.args:
            return tree
        with as_printed():
            return tree.func(*map(turned, tree.args))

    pairs = [
        pair
        for e in known.equations
        for pair in pairs_of(
            Equation(*map(turned, e.sides), relation=e.relation), algebra, chain=True
        )
    ]
    return Performed(tuple(pairs), known.scope, order=known.order)


def square(move: Move, algebra: Algebra) -> Performed:
    def squared(value: Value) -> Value:
        return algebra.dot(value, value) if isinstance(value, Vector) else value**2

    known = the_one(move)
    if any(p.relation in _TURNED for p in all_pairs(known, algebra)):
        pairs = [_squared(p, (*move.where, *move.bounds)) for p in all_pairs(known, algebra)]
        return Performed(tuple(pairs), known.scope)
    order = known.order
    if order is not None:  # (a + O)² has the error a O
        sides = [v for p in all_pairs(known, algebra) for v in p.sides]
        lowest = min((order.lowest(x) for side in sides for x in scalars(side)), default=0)
        order = replace(order, power=order.power + min(0, lowest))
    made = replace(mapped(move, algebra, squared), order=order)
    return replace(made, conditions=_of_roots(all_pairs(known, algebra)))


def _squared(pair: Pair, known: Sequence[Condition]) -> Pair:
    """Both sides of an inequality squared, where the smaller one is known not to be negative.

    Where the larger one is known not to be positive the inequality turns round.
    """
    small, large = pair.sides if pair.relation in "<≤" else pair.sides[::-1]
    relation = pair.relation
    if bounds.nonnegative(*flat_with(-large, known, weak=True)):
        relation = _TURNED[relation]
    elif not bounds.nonnegative(*flat_with(small, known, weak=True)):
        raise RefusedError("{} may be negative: its square says nothing", small)
    return Pair(pair.left**2, pair.right**2, relation)


def _of_roots(pairs: Sequence[Pair]) -> tuple[Condition, ...]:
    """That what equals a root, or a size, is not negative: a square does not tell."""
    conditions = []
    for pair in pairs if len(pairs) == 1 else ():
        for side, other in (pair.sides, pair.sides[::-1]):
            is_root = isinstance(side, Pow) and side.exp == Rational(1, 2)
            scalar = isinstance(other, Expr) and other.is_commutative
            if (is_root or isinstance(side, Abs)) and scalar and not other.is_nonnegative:
                conditions.append(Condition(other, "≥"))
    return tuple(conditions)
