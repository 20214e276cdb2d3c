"""Normal forms of trigonometric polynomials and their ratios, without `simplify`."""

from __future__ import annotations

from functools import lru_cache
from typing import Any, TypeVar

import sympy
from sympy import Add, Expr, MatrixBase, Mul, cos, sin

ExprOrMatrix = TypeVar("ExprOrMatrix", Expr, MatrixBase)

CACHED = 1000
"""Forms that are kept, as SymPy keeps its own: a lecture asks for most of them more than once."""

_HINTS = {"log": False, "basic": False, "power_exp": False}
"""What `expand` would look for in every part of an expression, and is in no polynomial."""

factored = lru_cache(maxsize=CACHED)(sympy.factor)
"""`sympy.factor`, of which SymPy keeps nothing."""


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
    gone, kept = (sin, cos) if keep == "cos" else (cos, sin)
    expanded = expression.expand(**_HINTS)
    while True:
        terms = [_lower(term, gone, kept) for term in Add.make_args(expanded)]
        if all(new is None for new in terms):
            return expanded
        old = Add.make_args(expanded)
        lowered = (term if new is None else new for term, new in zip(old, terms, strict=True))
        expanded = Add(*lowered).expand(**_HINTS)


def _lower(term: Expr, gone: Any, kept: Any) -> Expr | None:
    """The term with every gone(x)ⁿ, n ≥ 2, rewritten; None where there is none."""
    factors, changed = [], False
    for factor in Mul.make_args(term):
        base, power = factor.as_base_exp()
        if isinstance(base, gone) and power.is_Integer and power >= 2:
            pairs, single = divmod(int(power), 2)
            factors += [(1 - kept(*base.args) ** 2) ** pairs, base**single]
            changed = True
        else:
            factors.append(factor)
    return Mul(*factors) if changed else None


@lru_cache(maxsize=CACHED)
def reduce_ratio(expression: Expr) -> Expr:
    """A ratio of trigonometric polynomials in lowest terms, sin² wherever 1 − cos² is a factor.

    >>> from sympy.abc import x
    >>> reduce_ratio((1 - cos(x)**2)*cos(x)/sin(x)**3)
    cos(x)/sin(x)
    """
    numerator, denominator = sympy.fraction(sympy.together(expression))
    powers = _factors(numerator)
    for base, power in _factors(denominator).items():
        powers[base] = powers.get(base, 0) - power
    return Mul(*(base**power for base, power in powers.items()))


def _factors(polynomial: Expr) -> dict[Expr, int]:
    """Bases and powers, each base with one choice of sign, (cos x − 1)(cos x + 1) as −sin² x."""
    powers: dict[Expr, int] = {}
    for factor in Mul.make_args(factored(reduce_trig(polynomial))):
        base, power = factor.as_base_exp()
        if isinstance(base, Add) and base.could_extract_minus_sign() and power.is_Integer:
            base = -base
            powers[sympy.S.NegativeOne] = powers.get(sympy.S.NegativeOne, 0) + power
        powers[base] = powers.get(base, 0) + power
    for base in list(powers):
        upper = base + 2
        if isinstance(base + 1, cos) and upper in powers:
            sine = sin(*(base + 1).args)
            paired = min(powers[base], powers[upper])
            for key, change in ((base, -paired), (upper, -paired), (sine, 2 * paired)):
                powers[key] = powers.get(key, 0) + change
            powers[sympy.S.NegativeOne] = powers.get(sympy.S.NegativeOne, 0) + paired
    return powers
