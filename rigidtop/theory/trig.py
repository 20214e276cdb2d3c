"""Normal forms of trigonometric polynomials and their ratios, without `simplify`."""

from __future__ import annotations

from functools import lru_cache
from typing import TypeVar

import sympy
from sympy import Add, Expr, MatrixBase, Mul, cos, sin

from rigidtop.theory.polynomial import CACHED, Polynomial

ExprOrMatrix = TypeVar("ExprOrMatrix", Expr, MatrixBase)


def reduce_trig(expression: ExprOrMatrix, keep: str = "cos") -> ExprOrMatrix:
    """Expand a polynomial in sines and cosines and eliminate sin² by sin² = 1 − cos².

    The result is unique, so two polynomials that agree for all angles get the same form.  With
    ``keep="sin"`` it is cos² that goes.  Works entry by entry on a matrix.

    >>> from sympy.abc import x, y
    >>> reduce_trig(y*sin(x)**2 + y*cos(x)**2)
    y
    """
    if isinstance(expression, MatrixBase):
        return expression.applyfunc(lambda entry: reduce_trig(entry, keep))
    return _reduced(expression, keep)


@lru_cache(maxsize=CACHED)
def _reduced(expression: Expr, keep: str) -> Expr:
    return Polynomial(expression, keep).expression()


@lru_cache(maxsize=CACHED)
def reduce_ratio(expression: Expr) -> Expr:
    """A ratio of trigonometric polynomials in lowest terms, sin² wherever 1 − cos² is a factor.

    >>> from sympy.abc import x
    >>> reduce_ratio((1 - cos(x)**2)*cos(x)/sin(x)**3)
    cos(x)/sin(x)
    """
    powers: dict[Expr, int] = {}
    for base, power in Polynomial(expression).factors():
        if isinstance(base, Add) and base.could_extract_minus_sign():
            base = -base
            powers[sympy.S.NegativeOne] = powers.get(sympy.S.NegativeOne, 0) + power
        powers[base] = powers.get(base, 0) + power
    for base in list(powers):
        upper = base + 2
        if isinstance(base + 1, cos) and powers[base] * powers.get(upper, 0) > 0:
            sine = sin(*(base + 1).args)
            paired = min(powers[base], powers[upper], key=abs)
            for key, change in ((base, -paired), (upper, -paired), (sine, 2 * paired)):
                powers[key] = powers.get(key, 0) + change
            powers[sympy.S.NegativeOne] = powers.get(sympy.S.NegativeOne, 0) + paired
    return Mul(*(base**power for base, power in powers.items()))
