"""Units of what is printed: both sides of an equation, and all terms of a sum, are in the same.

The unit of a letter comes with the `Letters` of the subject, as people write it: "kg m²", "J s",
"rad/s", "1/s²".  Angles are pure numbers, and so are unit vectors, whose unit is "".  A letter
without a unit may be in anything; 0 and "const" fit all.

>>> from rigidtop.theory.symbols import M, R, V, g
>>> letters = Letters(units={V: "J", M: "kg", g: "m/s²", R: "m"})
>>> check(Equation(V, M * g * R), letters)
>>> check(Equation(V, M * g), letters)
Traceback (most recent call last):
...
rigidtop.proof.units.UnitsError: the units disagree: V is in J, M*g is in kg m/s²
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from dataclasses import replace
from fractions import Fraction
from functools import cache

import sympy
from sympy import Add, Expr, MatrixBase, Mul, Pow, Symbol

from rigidtop.proof.equation import (
    Cross,
    Dot,
    Equation,
    Group,
    IntegralOver,
    Matrices,
    Partial,
    Rate,
    Slope,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    value,
)
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import RefusedError
from rigidtop.proof.values import Applied

Dimension = tuple[Fraction, ...]
"""The exponents of kg, m, s, A and K."""

_BASES = ("kg", "m", "s", "A", "K")
NUMBER: Dimension = (Fraction(0),) * len(_BASES)
_EXPONENTS = {
    **{base: tuple(int(base == other) for other in _BASES) for base in _BASES},
    "N": (1, 1, -2, 0, 0),
    "J": (1, 2, -2, 0, 0),
    "W": (1, 2, -3, 0, 0),
    "Pa": (1, -1, -2, 0, 0),
    "Hz": (0, 0, -1, 0, 0),
    "C": (0, 0, 1, 1, 0),
    "V": (1, 2, -3, -1, 0),
    "Ω": (1, 2, -3, -2, 0),
    "F": (-1, -2, 4, 2, 0),
    "T": (1, 0, -2, -1, 0),
    "Wb": (1, 2, -2, -1, 0),
    "H": (1, 2, -2, -2, 0),
    "rad": (0, 0, 0, 0, 0),
    "1": (0, 0, 0, 0, 0),
}
"""SI (BIPM, The International System of Units, 9th edition, tables 2 and 4)."""
_RAISED = str.maketrans("⁻⁰¹²³⁴⁵⁶⁷⁸⁹", "-0123456789")
_LOWERED = {digit: raised for raised, digit in _RAISED.items()}
_UNIT = re.compile(r"([^/()]+)(?:/(?:\(([^/()]+)\)|([^/()\s·]+)))?")
_FACTOR = re.compile(r"([A-Za-zΩ]+|1)(?:\^(-?\d+)|(⁻?[⁰¹²³⁴-⁹]+))?")


class UnitsError(RefusedError):
    """Terms that are in different units, or a function of what is no pure number."""


@cache
def parsed(unit: str) -> Dimension | None:
    """The exponents of a unit; None where it is none, or not known.

    >>> parsed("1/(J s)") == (-1, -2, 1, 0, 0), parsed("V/m") == parsed("N/C"), parsed("ell")
    (True, True, None)
    """
    found = _UNIT.fullmatch(unit.strip())
    if found is None:
        return None
    over, below = _product(found[1]), _product(found[2] or found[3] or "1")
    return None if below is None else _times(over, _power(below, Fraction(-1)))


def is_energy(unit: str) -> bool:
    """Whether it is a unit of energy, which no coordinate has.

    >>> is_energy("kg m²/s²"), is_energy("J s")
    (True, False)
    """
    return parsed(unit) == parsed("J")


def known() -> str:
    """The units that can be written, in words."""
    return ", ".join(unit for unit in _EXPONENTS if unit != "1")


def _product(text: str) -> Dimension | None:
    made: Dimension | None = NUMBER
    for piece in re.split(r"[\s·]+", text.strip()):
        found = _FACTOR.fullmatch(piece)
        if found is None or found[1] not in _EXPONENTS:
            return None
        raised = found[2] or (found[3] or "1").translate(_RAISED)
        base = tuple(map(Fraction, _EXPONENTS[found[1]]))
        made = _times(made, _power(base, Fraction(raised)))
    return made


def _times(*factors: Dimension | None) -> Dimension | None:
    known = [factor for factor in factors if factor is not None]
    if len(known) < len(factors):
        return None
    return tuple(sum(column, Fraction(0)) for column in zip(*known, strict=True))


def _power(base: Dimension, exponent: Fraction) -> Dimension:
    return tuple(exponent * each for each in base)


def named(dimension: Dimension, letters: Letters) -> str:
    """A unit as the letters have it, else in kg, m and s."""
    theirs = [unit for unit in letters.units.values() if parsed(unit) == dimension]
    return min(theirs, key=len, default=_spelled(dimension))


def _spelled(dimension: Dimension) -> str:
    over = [_raised(b, n) for b, n in zip(_BASES, dimension, strict=True) if n > 0]
    below = [_raised(b, -n) for b, n in zip(_BASES, dimension, strict=True) if n < 0]
    under = " ".join(below) if len(below) < 2 else f"({' '.join(below)})"
    return "/".join(part for part in (" ".join(over) or "1", under) if part)


def _raised(base: str, exponent: Fraction) -> str:
    if exponent.denominator > 1:
        return f"{base}^{exponent}"
    return base if exponent == 1 else base + str(exponent).translate(_LOWERED)


def check(equation: Equation, letters: Letters) -> None:
    """Raises UnitsError where sides, terms or arguments disagree.

    A matrix that is written out is compared entry by entry.
    """
    sides = [value(side, {}) if isinstance(side, Matrices) else side for side in equation.sides]
    shapes = {side.shape for side in sides if isinstance(side, MatrixBase)}
    if len(shapes) != 1:
        _common(sides, letters)
        return
    [shape] = shapes
    for k in range(shape[0] * shape[1]):
        entries = [side[k] if isinstance(side, MatrixBase) else side for side in sides]
        _common(entries, letters)


def defining(letters: Letters, equation: Equation) -> Letters:
    """The letters, with a unit for the one that an equation defines, if it has none."""
    letter, *means = equation.sides
    if letters.units.get(letter) or _of_letter(letter, letters) == NUMBER:
        return letters
    try:
        found = _common(means, letters)
    except UnitsError:
        found = None
    if found is None:
        return letters
    return replace(letters, units={**letters.units, letter: _spelled(found)})


def dimension(tree: Expr, letters: Letters) -> Dimension | None:
    """What a printed tree is in; None for what fits all, or is not known.

    Raises UnitsError where something in it disagrees.
    """
    match tree:
        case Symbol():
            return _of_letter(tree, letters)
        case MatrixBase():
            found = {dimension(entry, letters) for entry in tree} - {None}
            return found.pop() if len(found) == 1 else None
        case Add() | Underbrace() | sympy.Max() | sympy.Min():
            return _common(tree.args, letters)
        case Group() | Transposed() | sympy.Abs():
            return dimension(tree.args[0], letters)
        case Rate():
            return _times(dimension(tree.args[0], letters), parsed("1/s"))
        case SumOver():
            return dimension(tree.args[1], letters)
        case VolumeIntegral():
            return _times(parsed("m³"), dimension(tree.args[1], letters))
        case IntegralOver():
            variable, low, high, body = tree.args
            return _times(_common((variable, low, high), letters), dimension(body, letters))
        case Mul() | Dot() | Cross() | Applied() | sympy.MatMul():
            return _times(*[dimension(factor, letters) for factor in tree.args])
        case Partial() | Slope():
            of, by = (dimension(part, letters) for part in tree.args)
            return None if by is None else _times(of, _power(by, Fraction(-1)))
        case Pow():
            return _raised_to(tree.base, tree.exp, letters)
        case sympy.atan2():
            _common(tree.args, letters)
            return NUMBER
        case sympy.Function():
            for argument in tree.args:
                _pure(argument, f"{tree.func.__name__} takes a pure number", letters)
            return NUMBER
    return NUMBER if getattr(tree, "is_number", False) and tree != 0 else None


def _of_letter(letter: Symbol, letters: Letters) -> Dimension | None:
    unit = letters.units.get(letter)
    if letter in letters.unit_vectors or (unit == "" and letter in letters.vectors):
        return NUMBER
    return parsed(unit or "")


def _raised_to(base: Expr, exponent: Expr, letters: Letters) -> Dimension | None:
    _pure(exponent, "an exponent is a pure number", letters)
    found, number = dimension(base, letters), value(exponent, {})
    if found is None or found == NUMBER:
        return found
    return _power(found, Fraction(int(number.p), int(number.q))) if number.is_Rational else None


def _pure(tree: Expr, needed: str, letters: Letters) -> None:
    found = dimension(tree, letters)
    if found not in (None, NUMBER):
        raise UnitsError(f"the units disagree: {needed}, {{}} is {{}}", tree, _said(found, letters))


def _common(sides: Iterable[Expr], letters: Letters) -> Dimension | None:
    """The dimension of all terms, None where none is known.  Raises UnitsError where two differ."""
    known: tuple[Expr, Dimension] | None = None
    for term in (term for side in sides for term in _terms(side)):
        found = dimension(term, letters)
        if known is None:
            known = None if found is None else (term, found)
        elif found not in (None, known[1]):
            first, second = _said(known[1], letters), _said(found, letters)
            message = "the units disagree: {} is {}, {} is {}"
            raise UnitsError(message, known[0], first, term, second)
    return None if known is None else known[1]


def _terms(tree: Expr) -> Iterator[Expr]:
    """The terms of a sum, in brackets or not, without their signs."""
    if isinstance(tree, (Add, Group)):
        for part in tree.args:
            yield from _terms(part)
    elif isinstance(tree, Mul) and tree.args[0] == -1:
        rest = tree.args[1:]
        yield from _terms(rest[0] if len(rest) == 1 else Mul(*rest, evaluate=False))
    else:
        yield tree


def _said(dimension: Dimension, letters: Letters) -> str:
    return "a pure number" if dimension == NUMBER else f"in {named(dimension, letters)}"
