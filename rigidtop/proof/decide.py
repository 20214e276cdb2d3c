"""Does an expression vanish, by itself or because others do?

Every "yes" is a proof: normal forms of rational expressions in symbols, sines, cosines and square
roots.  A point with numbers refutes (`rigidtop.proof.floats`).  Forty digits at random points are
evidence, and are called so.
"""

from __future__ import annotations

import math
import random
from collections.abc import Sequence
from enum import StrEnum

import sympy
from sympy import Expr, Matrix, Rational, Symbol, cos, sin

from rigidtop.proof import floats
from rigidtop.proof.confirmation import heard
from rigidtop.theory.polynomial import Polynomial


class Verdict(StrEnum):
    """From what needs nothing to what can't be let pass; a claim gets the last of its checks'."""

    DEFINITION = "definition"
    PROVED = "proved"
    SAMPLED = "sampled"
    ASSUMING = "assuming"
    CONVENTION = "convention"
    FALSE = "false"
    UNDECIDED = "undecided"


@heard
def vanishes(expression: Expr) -> bool:
    """True only if the expression is identically zero, shown by its normal form.

    >>> from sympy.abc import x, y
    >>> vanishes(sin(x)**2/(1 - cos(x)) - 1 - cos(x)), vanishes(x - y)
    (True, False)
    """
    if expression == 0:
        return True
    if expression.has(sympy.log):
        expression = sympy.expand_log(expression)
    if any(not f.args[0].is_Symbol for f in expression.atoms(sin, cos)) or expression.has(
        sympy.tan
    ):
        expression = sympy.expand_trig(expression.rewrite(sympy.tan, sin))
    return Polynomial(expression).is_zero()


MOST_SHOWN = 4000
"""Beyond so many operations nothing is shown by normal forms: numbers only."""


@heard
def evidence(expression: Expr) -> Verdict | None:
    """PROVED or SAMPLED where an expression vanishes whatever its symbols are; None where not.

    >>> from sympy.abc import x
    >>> evidence(sin(x)**2 + cos(x)**2 - 1).value, evidence(sin(x) - x)
    ('proved', None)
    """
    if expression == 0:
        return Verdict.PROVED
    if in_digits([("=", expression)]) is False:
        return None
    if sympy.count_ops(expression) < MOST_SHOWN:
        if vanishes(expression):
            return Verdict.PROVED
        if _has_normal_form(expression):
            return None
    return Verdict.SAMPLED if digits_vanish([expression]) else None


def _has_normal_form(expression: Expr) -> bool:
    """Whether "no" is certain too: of ratios in symbols, their sines and cosines it is.

    >>> from sympy.abc import x
    >>> _has_normal_form(sin(x) ** 2 / x), _has_normal_form(sympy.sqrt(x)), evidence(sin(x) - x)
    (True, False, None)
    """
    if isinstance(expression, (sin, cos)):
        return bool(expression.args[0].is_Symbol)
    if isinstance(expression, sympy.Pow):
        return expression.exp.is_Integer is True and _has_normal_form(expression.base)
    if isinstance(expression, (sympy.Add, sympy.Mul)):
        return all(map(_has_normal_form, expression.args))
    return bool(expression.is_Symbol or expression.is_Rational)


def in_digits(
    gaps: Sequence[tuple[str, Expr]], places: int = 2, bounds: Sequence[Expr] = ()
) -> bool | None:
    """Whether scalars are as relations to 0 where `bounds` are positive: False is for certain.

    Asked at some points in double precision, in which what is lost by cancelling is no difference;
    None where there is none at which all is real, as of √x + √−x.
    """
    found = None
    for attempt in range(8 * places):  # a root may be real at few points only
        if bounds and not all(bound > 0 for bound in floats.values(bounds, attempt)):
            continue
        rows = [floats.values(sympy.Add.make_args(gap), attempt) for _, gap in gaps]
        if not all(math.isfinite(sum(row)) for row in rows):
            continue
        for (relation, gap), row in zip(gaps, rows, strict=True):
            if not floats.holds(relation, sum(row), 1 + sum(map(abs, row))) and (
                relation != "=" or not floats.holds("=", sum(row), floats.magnitude(gap, attempt))
            ):
                return False
        found, places = True, places - 1
        if not places:
            break
    return found


def _gap(whole: Matrix, attempt: int) -> float | None:
    """By how much the last row is no sum of multiples of the others, beside its terms' size.

    None where numbers do not tell: the others depend on one another there, or are not real.
    """
    numbers = Matrix(*whole.shape, floats.values([*whole], attempt))
    minor, last = numbers[:-1, :-1], numbers[:-1, -1]
    if not all(map(math.isfinite, numbers)) or not abs(minor.det()) > floats.TOLERANCE:
        return None
    factors = minor.T.LUsolve(numbers[-1, :-1].T)
    terms = [numbers[-1, -1], *(-x * y for x, y in zip(factors, last, strict=True))]
    return float(sum(terms) / (1 + sum(map(abs, terms))))


POINTS, POINTS_OF_BRANCHES = 5, 60
"""How many points are evidence; more where a root may have either sign: √((a − b)²) is a − b at
half of them."""


def branches(expression: Expr) -> bool:
    """Whether an expression may be another function where its symbols have other numbers."""
    if expression.has(sympy.Abs, sympy.sign, sympy.Max, sympy.Min, sympy.log, sympy.atan2):
        return True
    return any(p.base.free_symbols and not p.exp.is_Integer for p in expression.atoms(sympy.Pow))


def digits_vanish(expressions: Sequence[Expr], digits: int = 40) -> bool:
    """True if every expression is zero to `digits` digits at random rational points."""
    points = POINTS_OF_BRANCHES if any(map(branches, expressions)) else POINTS
    rng = random.Random(7)
    symbols = sorted(set().union(*(e.free_symbols for e in expressions)), key=str)
    found = 0
    rows = [sympy.Add.make_args(e) for e in expressions]
    # SymPy looks for the digits of what stands in a term twice more than twice as long.
    parts, terms = sympy.cse([term for row in rows for term in row], order="none")
    limit = Rational(10) ** -digits
    for attempt in range(20 * points):
        if not found and attempt == 100:
            return False  # it is hardly ever real
        point: dict[Expr, Expr] = {x: _anywhere(x, rng) for x in symbols}
        number = floats.at(point)
        if any(math.isnan(number(term)) for row in rows for term in row):
            continue  # digits of what is not real cost SymPy minutes
        for x, part in parts:
            point[x] = part.evalf(digits + 30, subs=point)
        values = iter([term.evalf(digits + 10, subs=point) for term in terms])
        numbers = [[next(values) for _ in row] for row in rows]
        if not all(v.is_number and v.is_finite and v.is_real for row in numbers for v in row):
            continue
        if any(abs(sympy.Add(*row)) > limit * sympy.Add(*map(abs, row)) for row in numbers):
            return False
        found += 1
        if found == points:
            return True
    return False


def _anywhere(x: Symbol, rng: random.Random) -> Expr:
    """A rational number, of either sign if the symbol allows, from a hundredth to a thousand."""
    size = Rational(rng.randint(1, 997), rng.choice((1, 31, 499, 997)))
    return size if x.is_positive or rng.random() < 0.5 else -size
