"""Integrals as sums over places: between two ends, and as far as infinity."""

from __future__ import annotations

import math
import random

import numpy as np
import sympy
from sympy import Expr, Symbol

from rigidtop.judge.values import UnclearError

Rule = list[tuple[Expr, Expr]]
"""Places with their weights."""

NODES = 32
"""Places at which the integrand of an integral between two ends is taken."""

_STEP, _FARTHEST = 1 / 16, 3.25
"""Steps of the rule for an infinite end, which grow as exp(sinh t) does, and how far t goes."""

_AGREED = 1e-4
"""With half of the places a value may differ by this share where an integral converges.

Each halving of the steps doubles the digits that are right.
"""


def integral(integrand: Expr, x: Symbol, lower: Expr, upper: Expr) -> Expr:
    """The value of an integral; ends may be infinite.

    Raises UnclearError for one that is not seen to converge.
    """
    if -sympy.oo in (lower, upper) and upper != sympy.oo:  # ∫ from −∞ to b is turned round
        turned = integrand.xreplace({x: -x})
        return integral(turned, x, -upper, -lower) if lower == -sympy.oo else _unclear()
    if lower == sympy.oo:
        return -integral(integrand, x, upper, lower)
    if upper != sympy.oo:
        return _summed(integrand, x, _between(lower, upper))
    if lower == -sympy.oo:
        integrand, lower = integrand + integrand.xreplace({x: -x}), sympy.Integer(0)
    rule = _from(lower)
    value = _summed(integrand, x, rule)
    if not _converges(value, 2 * _summed(integrand, x, rule[::2])):
        _unclear()
    # A number is compared with all its digits.
    return value if value.free_symbols else sympy.Integral(integrand, (x, lower, upper)).evalf(25)


def _unclear() -> Expr:
    raise UnclearError("an integral that is not seen to converge")


def _summed(integrand: Expr, x: Symbol, rule: Rule) -> Expr:
    try:
        return sympy.Add(*(weight * integrand.xreplace({x: place}) for place, weight in rule))
    except OverflowError:
        return _unclear()


def _nodes() -> list[tuple[float, float]]:
    """Places x = −cos s between −1 and 1 with their weights, Gauss and Legendre's in s.

    So a root that vanishes at an end is as smooth as anything else.
    """
    places, weights = np.polynomial.legendre.leggauss(NODES)
    s = (places + 1) * np.pi / 2
    return [*zip((-np.cos(s)).tolist(), (weights * np.sin(s) * np.pi / 2).tolist(), strict=True)]


_NODES = _nodes()


def _between(lower: Expr, upper: Expr) -> Rule:
    middle, half = (lower + upper) / 2, (upper - lower) / 2
    return [(middle + half * place, half * weight) for place, weight in _NODES]


def _steps() -> list[float]:
    count = round(_FARTHEST / _STEP)
    return [k * _STEP for k in range(-count, count + 1)]


def _from(lower: Expr) -> Rule:
    """As far as infinity, by x = a + exp(π/2 sinh t): it may fall off as a power, too."""
    far = [(math.exp(math.pi / 2 * math.sinh(t)), math.pi / 2 * math.cosh(t)) for t in _steps()]
    return [(lower + place, sympy.Float(_STEP * place * slope)) for place, slope in far]


def _converges(value: Expr, with_half: Expr) -> bool:
    """Whether it is the same with half of the places, where its letters are of the size of 1."""
    letters = sorted(value.free_symbols | with_half.free_symbols, key=str)
    draw = random.Random(0)
    for _ in range(2):
        put = {letter: sympy.Float(draw.uniform(0.6, 1.7)) for letter in letters}
        try:
            one, other = (complex(x.xreplace(put)) for x in (value, with_half))
            if not abs(one - other) <= _AGREED * abs(one):
                return False
        except (OverflowError, TypeError):  # too large, or no number
            return False
    return True
