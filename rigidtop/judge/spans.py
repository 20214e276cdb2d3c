"""Between which numbers an expression lies, whatever its letters are: for what can't be true.

>>> from sympy import Symbol, sin
>>> x = Symbol("x", real=True)
>>> span(2 + sin(x))
(1.0, 3.0)
>>> span(sin(x) - x**2)
(-inf, 1.0)
"""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from functools import lru_cache
from math import inf

import sympy
from sympy import Dummy, Expr, Symbol

Span = tuple[float, float]

_TURNING = (sympy.sin, sympy.cos)
_INVERSE = (sympy.asin, sympy.acos)
ANY: Span = (-inf, inf)

_CLOSE = 1e-9
"""A bound that is missed by less is not missed."""


class NoValueError(Exception):
    """An expression that is no real number, whatever its letters are."""


def span(
    expression: Expr,
    positive: Collection[Symbol] = (),
    known: Mapping[Symbol, float] | None = None,
) -> Span:
    """Bounds of an expression in real letters; raises NoValueError where it has no real value.

    Letters may be `positive`, or `known` as numbers.
    """

    def of(node: Expr) -> Span:
        if node.is_Symbol:
            if known and node in known:
                return known[node], known[node]
            return (0.0, inf) if node in positive else ANY
        if not node.args:
            return _number(node)
        below = [of(x) for x in node.args]
        if node.is_Add:
            return sum(x[0] for x in below), sum(x[1] for x in below)
        if node.is_Mul:
            return _product(below)
        if node.is_Pow:
            return _power(below[0], node.exp)
        return _function(node, below[0]) if len(below) == 1 else ANY

    return of(expression)


@lru_cache(maxsize=10_000)
def _number(node: Expr) -> Span:
    value = complex(node)
    if value.imag or value != value:
        return ANY
    return value.real, value.real


def _product(factors: list[Span]) -> Span:
    low, high = 1.0, 1.0
    for factor in factors:
        ends = [_times(x, y) for x in (low, high) for y in factor]
        low, high = min(ends), max(ends)
    return low, high


def _times(x: float, y: float) -> float:
    return 0.0 if x == 0 or y == 0 else x * y


def _power(base: Span, exponent: Expr) -> Span:
    low, high = base
    if not exponent.is_Rational:
        if high < -_CLOSE and not exponent.is_integer:
            raise NoValueError  # of what is negative only whole powers are real
        return (0.0, inf) if low >= 0 else ANY
    if exponent.q % 2 == 0 and high < -_CLOSE:
        raise NoValueError
    if exponent.is_integer and exponent.is_even:
        least = 0.0 if low <= 0 <= high else min(low * low, high * high)
        most = max(low * low, high * high)
        k = float(exponent) / 2
        return (_raised(least, k), _raised(most, k)) if k > 0 else (0.0, inf)
    if exponent > 0 and exponent.is_integer:
        return _raised(low, int(exponent)), _raised(high, int(exponent))
    if exponent > 0 and exponent.q % 2 == 0:
        return _raised(max(low, 0.0), float(exponent)), _raised(max(high, 0.0), float(exponent))
    return (0.0, inf) if low >= 0 else ANY


def _raised(x: float, power: float) -> float:
    try:
        return float(x**power)
    except OverflowError:
        return inf


def _function(node: Expr, at: Span) -> Span:
    low, high = at
    if isinstance(node, _TURNING):
        if low == high:
            value = float(node.func(low))
            return value, value
        return -1.0, 1.0
    if isinstance(node, _INVERSE) and (low > 1 + _CLOSE or high < -1 - _CLOSE):
        raise NoValueError
    if isinstance(node, sympy.log) and high < -_CLOSE:
        raise NoValueError
    if isinstance(node, (sympy.Abs, sympy.exp, sympy.cosh)):
        return 0.0, inf
    return ANY


def is_contradictory(equations: Sequence[Expr]) -> bool:
    """Whether a few polynomial equations, in angles too, have no common solution at all.

    >>> from sympy.abc import x, y
    >>> is_contradictory([x - y, x * y, x**2 - 1]), is_contradictory([x - y, x * y])
    (True, False)
    """
    turned = {x for e in equations for x in e.atoms(*_TURNING)}
    put = {x: Dummy() for x in turned}
    circles = [
        put.get(sympy.sin(x), sympy.sin(x)) ** 2 + put.get(sympy.cos(x), sympy.cos(x)) ** 2 - 1
        for x in {x.args[0] for x in turned}
        if {sympy.sin(x), sympy.cos(x)} <= turned
    ]
    flat = [e.xreplace(put) for e in (*equations, *circles)]
    letters = sorted(set().union(*(e.free_symbols for e in flat)), key=str)
    if not flat or len(flat) > _MOST or len(letters) > _MOST:
        return False
    if not all(e.is_polynomial(*letters) and e.count_ops() < 40 for e in flat):
        return False
    basis = sympy.groebner(flat, *letters, order="grevlex")
    return list(basis.exprs) == [1]


_MOST = 6
"""Of more equations, or letters, it is not asked whether they have a solution."""
