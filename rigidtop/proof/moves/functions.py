"""A function of both sides: a sine, a cosine, a logarithm."""

from __future__ import annotations

from collections.abc import Callable

import sympy
from sympy import MatrixBase
from sympy.core.function import FunctionClass

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
from rigidtop.proof.values import Vector


def function(of: FunctionClass) -> Callable[[Move, Algebra], Performed]:
    """The move that takes a function of both sides; for a logarithm they have to be positive."""

    def taken(move: Move, algebra: Algebra) -> Performed:
        known = the_one(move)
        pairs = equal_pairs(known, algebra)
        sides = [side for pair in pairs for side in pair.sides]
        if any(isinstance(x, (Vector, MatrixBase)) or is_operator(x) for x in sides):
            raise RefusedError("a function of what is no scalar")
        made = tuple(Pair(of(p.left), of(p.right)) for p in pairs)
        return Performed(made, known.scope, _defined(pairs) if of == sympy.log else ())

    return taken


def _defined(pairs: list[Pair]) -> tuple[Condition, ...]:
    """That what a logarithm is taken of is positive, where this is not known."""
    for pair in pairs:
        if any(side.is_nonpositive for side in pair.sides):
            raise RefusedError("the logarithm of what is not positive")
    rights = [pair.right for pair in pairs if not bounds.positive(*flat_with(pair.right, ()))]
    return tuple(Condition(right, ">") for right in rights)
