"""The number by which a line and what a move makes may differ, and whether something vanishes."""

from __future__ import annotations

import math
from fractions import Fraction
from functools import lru_cache

import sympy
from sympy import Expr, Integer, Rational, Symbol

from rigidtop.proof import bounds, decide, floats, quadrature
from rigidtop.proof.equation import IntegralOver
from rigidtop.proof.moves import Move, Pair, flat_with
from rigidtop.proof.values import difference, flattened, vanishes


def factor_of(pair: Pair, made: Pair, move: Move) -> Expr | None:
    """The number c for which line = c × performed; None where there is none."""
    mine, theirs = difference(pair.left, pair.right), difference(made.left, made.right)
    if mine.keys() != theirs.keys():
        mine = {k: v for k, v in mine.items() if not is_zero(v, move)}
        theirs = {k: v for k, v in theirs.items() if not is_zero(v, move)}
        if mine.keys() != theirs.keys():
            return None
    factor = Integer(1)
    for key in mine:
        guess = _ratio(mine[key], theirs[key])
        if guess is not None:
            factor = guess
            break
    if all(is_zero(mine[key] - factor * theirs[key], move) for key in mine):
        return factor
    return None


def _ratio(mine: Expr, theirs: Expr) -> Expr | None:
    """A simple number that two expressions may differ by, guessed at two points.

    It is a ratio of whole numbers, or its square is; None where they differ by no number.
    """
    flat, _ = flattened(sympy.Tuple(mine, theirs))
    if not getattr(mine, "is_commutative", True):
        return Integer(1) if sympy.expand(mine - theirs) == 0 else Integer(-1)
    ratios: list[float] = []
    for attempt in range(4):
        a, b = floats.values(list(flat), attempt)
        if not (math.isfinite(a) and math.isfinite(b)) or abs(b) < floats.TOLERANCE:
            continue
        ratios.append(a / b)
        if floats.apart(ratios[0], ratios[-1]):
            return None
        if len(ratios) == 2:
            number, square = _simple(ratios[0]), _simple(ratios[0] ** 2)
            if number is None and square is not None:
                return sympy.sqrt(square) * (1 if ratios[0] > 0 else -1)
            return number
    return Integer(1)


LARGEST = 10_000
"""No larger denominator is guessed."""


def _simple(value: float) -> Rational | None:
    """The ratio of whole numbers that a number is."""
    guess = Fraction(value).limit_denominator(LARGEST)
    return Rational(guess) if guess and math.isclose(guess, value, rel_tol=1e-11) else None


@lru_cache(maxsize=1000)
def _positive(atom: Expr) -> Symbol:
    """A positive letter for an atom, the same each time: SymPy remembers what it found out."""
    return sympy.Dummy(getattr(atom, "name", "positive"), positive=True)


def is_zero(expression: Expr, move: Move) -> bool:
    """Whether an expression vanishes, letters of known sign being so."""
    if expression == 0:
        return True
    bounded = [c for c in (*move.where, *move.bounds) if c.relation == ">"]
    signs: dict[Expr, Expr] = {}
    for each in bounded:
        number, letter = each.expression.as_coeff_Mul()
        if isinstance(letter, Symbol):
            signs[letter] = sympy.sign(number) * _positive(letter)
    signed = expression.xreplace(signs) if signs else expression
    if vanishes(signed):
        return True
    if signed.atoms(IntegralOver):
        return quadrature.vanishes(signed)
    if not signed.is_commutative or not signed.has(sympy.Pow):
        return False
    # Of a positive cosine √(1/cos β) is 1/√(cos β), whatever else a cosine is.
    waves = {c.expression for c in bounded if isinstance(c.expression, sympy.Function)}
    if waves and vanishes(signed.xreplace({x.xreplace(signs): _positive(x) for x in waves})):
        return True
    flat, relations = flat_with(expression, bounded)
    flat, known = flat.xreplace(signs), [x.xreplace(signs) for x in relations]
    sides = [x.lhs for x in known if isinstance(x, sympy.Gt)]
    if decide.in_digits([("=", flat)], bounds=sides) is False:
        return False
    return bounds.vanishes_by_squares(flat, known)
