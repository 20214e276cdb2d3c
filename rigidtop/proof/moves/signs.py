"""Signs, and the square root, which has one."""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Expr, Integer, MatrixBase

from rigidtop.proof import decide
from rigidtop.proof.algebra import Algebra, Vector, flattened
from rigidtop.proof.moves.conditions import flat_with
from rigidtop.proof.moves.move import (
    Condition,
    Move,
    Pair,
    Performed,
    RefusedError,
    is_equation,
    name_of,
    the_one,
)
from rigidtop.proof.moves.pairs import all_pairs, is_operator


def root(move: Move, algebra: Algebra) -> Performed:
    """The square root of both sides; the sign has to be given."""
    known = the_one(move)
    pairs = []
    conditions: list[Condition] = []
    for pair in all_pairs(known, algebra):
        if isinstance(pair.left, Vector) or is_operator(pair.left) or not is_equation(pair):
            raise RefusedError("the root of what is no scalar")
        flat, nodes = flattened(pair.left)  # what stands for itself is real
        left = sympy.sqrt(sympy.factor(flat)).xreplace(nodes)
        bases = [abs_.args[0] for abs_ in left.atoms(sympy.Abs)]
        for base in bases:
            if not _sign_known(base, move.where):
                raise RefusedError(
                    "the root is ±: say for which sign of {}, such as “for … > 0”", base
                )
        left = left.replace(sympy.Abs, lambda x: x)
        pairs.append(Pair(left, sympy.sqrt(pair.right)))
        conditions.append(Condition(pair.right, "≥"))
    return Performed(tuple(pairs), known.scope, tuple(conditions))


def _sign_known(base: Expr, conditions: Sequence[Condition]) -> bool:
    return decide.positive(*flat_with(base, [c for c in conditions if c.relation == ">"]))


def sign(move: Move, algebra: Algebra) -> Performed:
    """The sign of a right side, under the conditions that are given, each of which is needed."""
    known = the_one(move)
    if known.order is not None:
        raise RefusedError("{} is approximate: its sign is not known", name_of(known))
    pairs = []
    for pair in all_pairs(known, algebra):
        if isinstance(pair.right, (Vector, MatrixBase)) or not is_equation(pair):
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
        if decide.positive(sign * flat, relations):
            return relation
    return "≠" if decide.nonzero(flat, relations) else None
