"""Points at which expressions have values, to many digits: numbers that have no relation there.

>>> x, y = sympy.symbols("x y")
>>> {letter: round(number, 3) for letter, number in next(points([x, y])).items()}
{x: 0.817, y: 1.106}
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from functools import cache
from typing import Any

import mpmath
import sympy
from sympy import Expr

DIGITS = mpmath.MPContext()
DIGITS.prec = 240
"""Arithmetic of the values."""

TRIED = 60
"""Points at which numbers are looked for, where square roots and logarithms may have none."""


class NotRealError(ValueError):
    """An expression has no real value at a point."""


def decimal(number: Any) -> Expr:
    """A number of that arithmetic as one of SymPy."""
    return sympy.Float(number, 70)


def number_of(expression: Expr) -> Any:
    """The number that an expression is.  Raises NotRealError where it is no real one."""
    value = sympy.N(expression, 70)
    if not value.is_Float and not value.is_Rational:
        raise NotRealError(str(expression))
    return DIGITS.convert(value)


@cache
def generic(k: int) -> Expr:
    """A number from a half to three halves, without a relation to those for other k."""
    root = DIGITS.sqrt(sympy.prime(k + 5))
    return sympy.Float(root - DIGITS.floor(root) + DIGITS.mpf(0.5), 60)


def points(letters: Sequence[Expr]) -> Iterator[dict[Expr, Expr]]:
    """Numbers without a relation between them, first all from a half to three halves."""
    first = {x: generic(k) for k, x in enumerate(letters)}
    yield first
    rng = random.Random(1)
    for _ in range(TRIED):
        yield {
            x: value * (1 if x.is_positive or rng.random() < 0.5 else -1) * 4 ** rng.randint(-4, 4)
            for x, value in first.items()
        }
