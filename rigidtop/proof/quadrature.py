"""Integrals without a primitive, by numbers: whether an expression with some in it vanishes.

Letters are drawn, and each integral is taken twice, in other pieces.  Where the two differ it does
not exist: on the way its integrand has a pole, or changes its sign, or is not real.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

import mpmath
import sympy
from sympy import Dummy, Expr, Symbol

from rigidtop.proof import floats
from rigidtop.proof.equation import IntegralOver

WORLDS, TRIES, DIGITS = 3, 12, 30
"""So many draws of all letters decide, of so many; numbers have so many digits."""

AGREED = mpmath.mpf(10) ** -12
"""Two numbers that differ by less, beside their size, are the same: at a root an integrand is
known less well than its letters."""


def vanishes(expression: Expr) -> bool:
    """Whether a sum of integrals and others is zero wherever its letters are drawn.

    >>> x, a = sympy.symbols("x a", positive=True)
    >>> quarter = IntegralOver(x, sympy.Integer(0), a, 1 / sympy.sqrt(a**2 - x**2))
    >>> vanishes(quarter - sympy.pi / 2), vanishes(quarter - sympy.pi)
    (True, False)
    >>> vanishes(IntegralOver(x, -a, a, x**-2) + 2 / a)
    False
    """
    integrals = sorted(expression.atoms(IntegralOver), key=str)
    bound = {each.args[0] for each in integrals}
    named = {each: Dummy() for each in integrals}
    outside = expression.xreplace(named)
    free = outside.free_symbols.union(*(each.free_symbols for each in integrals)) - bound
    letters = sorted(free - {*named.values()}, key=str)
    worlds = 0
    for attempt in range(TRIES):
        point = {x: _drawn(x, attempt) for x in letters}
        values = {name: _integral(each, point) for each, name in named.items()}
        if None in values.values():
            continue
        terms = [sympy.N(t.xreplace(point | values), DIGITS) for t in sympy.Add.make_args(outside)]
        if not all(t.is_real for t in terms):
            continue
        if not abs(sum(terms)) <= AGREED * sum(map(abs, terms)):
            return False
        worlds += 1
        if worlds == WORLDS:
            return True
    return False


def is_passed(integral: Expr) -> bool:
    """Whether an integrand is positive on the way somewhere, from the lower end to the higher.

    >>> x, a = sympy.symbols("x a", positive=True)
    >>> [is_passed(IntegralOver(x, low, 2 * a, x)) for low in (a, -a, 3 * a)]
    [True, False, False]
    """
    x, low, high, body = integral.args
    letters = sorted(integral.free_symbols - {x}, key=str)
    known = False
    for attempt in range(TRIES):
        point = {y: _drawn(y, attempt) for y in letters}
        with mpmath.workdps(DIGITS):
            way = _way(x, low, high, body, point)
        if way is None:
            continue
        known = True
        ends, _, heights = way
        if min((ends[1] - ends[0]) * height for height in heights) >= 0:
            return True
    return not known


def _drawn(letter: Symbol, attempt: int) -> Expr:
    near = sympy.Rational(floats.somewhere(letter, attempt))
    return near if letter.is_positive or attempt % 2 == 0 else -near


def _integral(node: Expr, point: dict[Symbol, Expr]) -> Expr | None:
    """The value of an integral where letters have numbers; None where it does not exist."""
    x, low, high, body = node.args
    with mpmath.workdps(2 * DIGITS):  # near a root at an end half of them cancel
        way = _way(x, low, high, body, point)
        if way is None:
            return None
        ends, integrand, heights = way
        inside = _inside(ends)
        if min(heights) < 0 < max(heights):
            return None
        try:
            whole = mpmath.quad(integrand, ends)
            parted = mpmath.quad(integrand, [ends[0], inside[12], inside[29], ends[1]])
        except (ZeroDivisionError, TypeError, ValueError):
            return None
        if not isinstance(whole, mpmath.mpf) or not abs(whole - parted) <= AGREED * abs(whole):
            return None
        return sympy.Float(whole, DIGITS)


def _inside(ends: Sequence[Any]) -> list[Any]:
    """Points between two ends, none of which is a simple fraction of the way."""
    return [ends[0] + (ends[1] - ends[0]) * mpmath.mpf(k) / 38 for k in range(1, 38)]


def _way(
    x: Symbol, low: Expr, high: Expr, body: Expr, point: Mapping[Symbol, Expr]
) -> tuple[list[Any], Callable[[Any], Any], list[Any]] | None:
    """The ends of an integral, its integrand, and its values on the way; None if not real."""
    ends = [mpmath.mpf(str(end.xreplace(point).evalf(2 * DIGITS))) for end in (low, high)]
    held = {y: value for y, value in point.items() if y != x}
    integrand = sympy.lambdify(x, body.xreplace(held), "mpmath")
    try:
        heights = [mpmath.mpmathify(integrand(at)) for at in _inside(ends)]
    except (ZeroDivisionError, TypeError, ValueError):
        return None
    if not all(isinstance(height, mpmath.mpf) for height in heights):
        return None
    return ends, integrand, heights
