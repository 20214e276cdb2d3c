"""What is known not to vanish, and what a division asks for."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import sympy
from sympy import Expr, Mul

from rigidtop.proof import decide
from rigidtop.proof.algebra import flattened
from rigidtop.proof.moves.move import Condition
from rigidtop.theory.trig import reduce_ratio


def divided_by(factor: Expr, conditions: Sequence[Condition]) -> tuple[Condition, ...]:
    """The conditions that a division brings: each factor that may vanish does not."""
    if nonzero(factor, conditions):
        return ()
    flat, nodes = flattened(factor)
    bases = [f.as_base_exp()[0] for f in Mul.make_args(reduce_ratio(flat))]
    made = [b.xreplace(nodes) for b in bases if not b.is_number]
    return tuple(Condition(b, "≠", lost=True) for b in made if not nonzero(b, conditions))


def nonzero(factor: Expr, conditions: Sequence[Condition]) -> bool:
    """Whether an expression is known not to vanish."""
    flat, relations = flat_with(factor, conditions)
    return decide.nonzero(flat, relations) or any(
        decide.positive(sign * flat, relations) for sign in (1, -1)
    )


_STRICT = {"≠": sympy.Ne, ">": sympy.Gt}


def flat_with(value: Expr, conditions: Sequence[Condition]) -> tuple[Expr, list[Any]]:
    """A value and strict relations, what is no letter being the same in all of them."""
    strict = [c for c in conditions if c.relation in _STRICT]
    [flat, *known] = flattened(sympy.Tuple(value, *(c.expression for c in strict)))[0]
    return flat, [_STRICT[c.relation](x, 0) for c, x in zip(strict, known, strict=True)]
