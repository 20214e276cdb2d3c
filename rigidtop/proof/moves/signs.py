"""Signs, and the square root, which has one."""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Expr, Integer, MatrixBase, Mul

from rigidtop.proof import bounds
from rigidtop.proof.algebra import Algebra
from rigidtop.proof.moves.conditions import flat_with
from rigidtop.proof.moves.move import (
    Condition,
    Move,
    Pair,
    Performed,
    RefusedError,
    the_one,
)
from rigidtop.proof.moves.pairs import equal_pairs, is_operator
from rigidtop.proof.values import Vector, flattened


def root(move: Move, algebra: Algebra) -> Performed:
    """The square root of both sides; the sign has to be given."""
    known = the_one(move)
    pairs = []
    conditions: list[Condition] = []
    for pair in equal_pairs(known, algebra):
        if isinstance(pair.left, Vector) or is_operator(pair.left):
            raise RefusedError("the root of what is no scalar")
        flat, nodes = flattened(pair.left)  # what stands for itself is real
        made = sympy.sqrt(sympy.factor(flat))
        if not made.is_real:  # what equals a square is not negative
            conditions.append(Condition(pair.right, "≥"))
        left = made.xreplace(nodes)
        for base in (abs_.args[0] for abs_ in left.atoms(sympy.Abs)):
            if not _known_sign(base, move.where):
                raise RefusedError(
                    "the root is ±: say for which sign of {}, such as “for … > 0”", base
                )
        left = left.replace(sympy.Abs, lambda x: _known_sign(x, move.where) * x)
        pairs.append(Pair(left, _root_of(pair.right, move.where)))
    return Performed(tuple(pairs), known.scope, tuple(conditions))


def _root_of(value: Expr, conditions: Sequence[Condition]) -> Expr:
    """√(ab) as √a√b where a condition says which sign a sum has that is a factor."""
    flat, nodes = flattened(value)
    together, apart = Integer(1), []
    for factor in Mul.make_args(sympy.factor(flat)):
        sign = _known_sign(factor.xreplace(nodes), conditions) if factor.is_Add else 0
        if sign:
            apart.append(sign * factor)
        together *= sign or factor
    return without_bars(
        Mul(sympy.sqrt(together), *map(sympy.sqrt, apart)).xreplace(nodes), conditions
    )


def without_bars(value: Expr, conditions: Sequence[Condition]) -> Expr:
    """A value with x or −x for |x|, where a condition says which it is."""
    return bounds.without_bars(value, lambda x: _known_sign(x, conditions))


def _known_sign(base: Expr, conditions: Sequence[Condition]) -> int:
    """1 or −1 where a condition says so, else 0."""
    strict = [c for c in conditions if c.relation == ">"]
    return bounds.sign(*flat_with(base, strict))


def sign(move: Move, algebra: Algebra) -> Performed:
    """The sign of a right side, under the conditions that are given, each of which is needed."""
    known = the_one(move)
    pairs = []
    for pair in equal_pairs(known, algebra):
        if isinstance(pair.right, (Vector, MatrixBase)):
            continue
        relation = _sign_of(pair.right, move.where)
        if relation is None:
            continue
        pairs.append(Pair(pair.left, Integer(0), relation))
    if not pairs:
        raise RefusedError("the sign is not known: say under which conditions")
    return Performed(tuple(pairs), known.scope)


def _sign_of(value: Expr, conditions: Sequence[Condition]) -> str | None:
    flat, relations = flat_with(value, conditions)
    for sign, relation in ((1, ">"), (-1, "<")):
        if bounds.positive(sign * flat, relations):
            return relation
    return "≠" if bounds.nonzero(flat, relations) else None
