"""Zeros confirmed by an arithmetic that knows nothing of normal forms: a second pair of eyes.

What `rigidtop.proof.decide` finds to be zero is a number at any point.  First of a prime field, in
which numbers are exact: letters have any values, sines and cosines are those of points of the
circle, put together by the formulas of sums, roots are those that are squares themselves, so that
√(ab) = √a√b.  What is a rational function of letters, sines and cosines vanishes there at random
points or not at all.  Where it has roots whose branch the field does not know, or other functions,
400 bits at random real points decide.

Nothing here may be taken from what it is to confirm: only the trees are SymPy's.
"""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from fractions import Fraction
from functools import wraps
from math import lcm
from typing import Any, TypeVar

import mpmath
import sympy
from sympy import Expr

# --- What is found to be zero --------------------------------------------------------------------

_HEARD: ContextVar[list[Expr] | None] = ContextVar("_HEARD", default=None)
_Found = TypeVar("_Found")


@contextmanager
def zeros() -> Iterator[list[Expr]]:
    """All that is found to be zero while this lasts, in the order in which it is."""
    heard: list[Expr] = []
    token = _HEARD.set(heard)
    try:
        yield heard
    finally:
        _HEARD.reset(token)


def heard(decide: Callable[[Expr], _Found]) -> Callable[[Expr], _Found]:
    """What decides whether an expression vanishes, heard by `zeros` where it says yes.

    What it asks in turn is not.
    """

    @wraps(decide)
    def deciding(expression: Expr) -> _Found:
        listening = _HEARD.get()
        if listening is None:
            return decide(expression)
        token = _HEARD.set(None)
        try:
            found = decide(expression)
        finally:
            _HEARD.reset(token)
        if found and expression != 0:
            listening.append(expression)
        return found

    return deciding


# --- Whether it is -------------------------------------------------------------------------------


def confirmed(zero: Expr) -> bool | None:
    """Whether an expression vanishes; None where neither arithmetic can be asked.

    >>> from sympy.abc import x
    >>> from sympy import Rational, cos, sin, sqrt
    >>> wrong = sin(x) ** 2 + cos(x) ** 2 - 1 + Rational(1, 10**50)
    >>> confirmed(sin(2 * x) - 2 * sin(x) * cos(x)), confirmed(wrong), confirmed(sqrt(x**2) - x)
    (True, False, False)
    """
    rng = random.Random(7)
    found = _in_field(zero, rng)
    return _in_digits(zero, rng) if found is None else found


class _NoValueError(Exception):
    """An expression has no value in an arithmetic, whatever the point."""


class _RedrawError(Exception):
    """An expression has no value at a point; it may have one at another."""


PRIME = 2**127 - 564129
"""−1 is no square modulo it, so that one root of each square is a square; 2, 3, 5 … 31 are."""

_POINTS, _TRIES = 6, 600


def _in_field(zero: Expr, rng: random.Random) -> bool | None:
    """Whether it vanishes modulo the prime; None where that says nothing."""
    try:
        parts = _angle_parts(zero)
        found = 0
        for _ in range(_TRIES):
            at = _Field(parts, rng)
            try:
                value = at(zero)
            except _RedrawError:
                continue
            if not _is_null(value):
                return None if at.doubtful else False
            found += 1
            if found == _POINTS * (3 if at.doubtful else 1):
                return True
    except _NoValueError:
        pass
    return None


Residue = Any
"""A number modulo the prime; a matrix of them where letters do not commute."""

_SIZE = 4
"""Matrices of so many rows satisfy no identity of a lower degree than 8 that not all do."""


def _is_null(value: Residue) -> bool:
    return not any(map(any, value)) if isinstance(value, list) else not value


def _sum(a: Residue, b: Residue) -> Residue:
    if not isinstance(a, list) and not isinstance(b, list):
        return (a + b) % PRIME
    rows = zip(*_both(a, b), strict=True)
    return [[(x + y) % PRIME for x, y in zip(*each, strict=True)] for each in rows]


def _product(a: Residue, b: Residue) -> Residue:
    if not isinstance(a, list) and not isinstance(b, list):
        return a * b % PRIME
    a, b = _both(a, b)
    columns = [*zip(*b, strict=True)]
    return [[sum(map(int.__mul__, row, column)) % PRIME for column in columns] for row in a]


def _both(*values: Residue) -> list[Residue]:
    return [
        x
        if isinstance(x, list)
        else [[x if i == k else 0 for k in range(_SIZE)] for i in range(_SIZE)]
        for x in values
    ]


def _inverse(value: int) -> int:
    if not value:
        raise _RedrawError
    return pow(value, -1, PRIME)


def _root(value: int) -> int:
    """The root of a square that is a square."""
    root = pow(value, (PRIME + 1) // 4, PRIME)
    if root * root % PRIME != value:
        raise _RedrawError
    return root


class _Field:
    """The numbers of trees at a random point of the prime field.

    It is `doubtful` where what does not vanish here may vanish all the same: by the branch of a
    root, or because two functions that are held to be independent are not.
    """

    def __init__(self, parts: dict[Expr, int], rng: random.Random) -> None:
        self._parts, self._rng = parts, rng
        self._known: dict[Expr, Residue] = {}
        self._circle: dict[Expr, tuple[int, int]] = {}
        self.doubtful = False

    def __call__(self, node: Expr) -> Residue:
        if node not in self._known:
            self._known[node] = self._value(node)
        return self._known[node]

    def _value(self, node: Expr) -> Residue:
        if node.is_Rational:
            return node.p * _inverse(node.q % PRIME) % PRIME
        if node.is_Symbol or node is sympy.pi:
            return self._drawn(node)
        if node.is_Add or node.is_Mul:
            join = _sum if node.is_Add else _product
            total = self(node.args[0])
            for part in node.args[1:]:
                total = join(total, self(part))
            return total
        if node.is_Pow:
            return self._power(*node.args)
        if isinstance(node, _OF_ANGLES):
            cosine, sine = self._angle(node.args[0])
            below = {sympy.tan: cosine, sympy.sec: cosine, sympy.cot: sine, sympy.csc: sine}
            above = {sympy.tan: sine, sympy.sin: sine, sympy.cot: cosine, sympy.cos: cosine}
            return above.get(node.func, 1) * _inverse(below.get(node.func, 1)) % PRIME
        if node.is_number or isinstance(node, _OF_DIGITS):
            raise _NoValueError
        self.doubtful = True
        return self._drawn(node)

    def _drawn(self, node: Expr) -> Residue:
        if node.is_commutative:
            return self._rng.randrange(1, PRIME)
        return [[self._rng.randrange(PRIME) for _ in range(_SIZE)] for _ in range(_SIZE)]

    def _power(self, base: Expr, exponent: Expr) -> Residue:
        if not exponent.is_Rational or exponent.q > 2:
            raise _NoValueError
        value = self(base)
        if isinstance(value, list):
            if exponent.q > 1 or exponent < 0:
                raise _NoValueError
            made: Residue = 1
            for _ in range(exponent.p):
                made = _product(made, value)
            return made
        if exponent.q == 2:
            self.doubtful = True
            value = _root(value)
        return pow(value if exponent > 0 else _inverse(value), abs(exponent.p), PRIME)

    def _angle(self, angle: Expr) -> tuple[int, int]:
        """The cosine and the sine of an angle, modulo the prime."""
        total = 1, 0
        for part, factor in _linear(angle):
            if part not in self._circle:
                t = self._rng.randrange(PRIME)
                over = _inverse((1 + t * t) % PRIME)
                self._circle[part] = (1 - t * t) * over % PRIME, 2 * t * over % PRIME
            self.doubtful |= not _is_monomial(part)
            cosine, sine = self._circle[part]
            times = int(factor * self._parts[part])
            total = _turned(total, _turns((cosine, sine if times > 0 else -sine), abs(times)))
        return total


def _turned(one: tuple[int, int], other: tuple[int, int]) -> tuple[int, int]:
    """Cosine and sine of the sum of two angles."""
    (a, b), (c, d) = one, other
    return (a * c - b * d) % PRIME, (a * d + b * c) % PRIME


def _turns(angle: tuple[int, int], times: int) -> tuple[int, int]:
    total = 1, 0
    while times:
        if times % 2:
            total = _turned(total, angle)
        angle, times = _turned(angle, angle), times // 2
    return total


_OF_ANGLES = (sympy.sin, sympy.cos, sympy.tan, sympy.cot, sympy.sec, sympy.csc)
_OF_DIGITS = (sympy.Abs, sympy.sign, sympy.exp, sympy.log, sympy.Max, sympy.Min, sympy.Piecewise)
"""Functions that are not independent of their argument, as far as a field knows."""


def _linear(angle: Expr) -> Iterator[tuple[Expr, Fraction]]:
    """The parts of an angle, each with its rational factor."""
    for term in angle.args if angle.is_Add else (angle,):
        factors = term.args if term.is_Mul else (term,)
        numbers = [x for x in factors if x.is_Rational]
        factor = Fraction(1)
        for x in numbers:
            factor *= Fraction(int(x.p), int(x.q))
        rest = [x for x in factors if not x.is_Rational]
        if factor:
            yield sympy.Mul(*rest), factor


def _is_monomial(part: Expr) -> bool:
    """Whether different ones are independent of one another: products of powers of letters."""
    factors = part.args if part.is_Mul else (part,)
    return all(
        x.is_Symbol or (x.is_Pow and x.base.is_Symbol and x.exp.is_Integer) or part == 1
        for x in factors
    )


def _angle_parts(zero: Expr) -> dict[Expr, int]:
    """The parts of all angles, with what each of their factors is a multiple of one over."""
    parts: dict[Expr, int] = {}
    for node in zero.atoms(*_OF_ANGLES):
        for part, factor in _linear(node.args[0]):
            if part.is_number and part != 1:
                raise _NoValueError  # of sin(x + π/3) a field knows nothing
            parts[part] = lcm(parts.get(part, 1), factor.denominator)
    return parts


# --- Digits --------------------------------------------------------------------------------------

BITS, _ZERO_BITS = 400, 300
"""Digits, and how many of them have to vanish beside the largest number on the way."""

_PLACES = 24
"""√((a − b)²) is a − b at half of all places."""


def _in_digits(zero: Expr, rng: random.Random) -> bool | None:
    """Whether it vanishes in many digits at random real points; None where it has no value."""
    context = mpmath.MPContext()
    context.prec = BITS
    found = 0
    try:
        for _ in range(_TRIES):
            at = _Digits(context, rng)
            try:
                value = at(zero)
            except (_RedrawError, ZeroDivisionError, ValueError, OverflowError):
                continue
            if abs(value) > context.ldexp(1 + at.largest, -_ZERO_BITS):
                return False
            found += 1
            if found == _PLACES:
                return True
    except (_NoValueError, mpmath.libmp.NoConvergence):
        pass
    return True if found >= _POINTS else None


class _Digits:
    """The real numbers of trees at a random point, and the `largest` of them."""

    def __init__(self, context: Any, rng: random.Random) -> None:
        self._context, self._rng = context, rng
        self._known: dict[Expr, Any] = {}
        self.largest = context.mpf(0)

    def __call__(self, node: Expr) -> Any:
        if node not in self._known:
            value = self._value(node)
            if not self._context.isfinite(value) or self._context.im(value):
                raise _RedrawError
            self._known[node] = value = self._context.re(value)
            self.largest = max(self.largest, abs(value))
        return self._known[node]

    def _value(self, node: Expr) -> Any:
        context = self._context
        if node.is_Rational:
            return context.mpf(int(node.p)) / int(node.q)
        if node.is_Symbol or not (node.args or node.is_number):
            return self._drawn(node)
        if node.is_Add:
            return context.fsum(map(self, node.args))
        if node.is_Mul:
            return context.fprod(map(self, node.args))
        if node.is_Pow:
            base, exponent = map(self, node.args)
            if base < 0 and not node.exp.is_Integer:
                raise _RedrawError
            return context.power(base, exponent)
        if isinstance(node, sympy.Piecewise):
            raise _NoValueError
        name = _NAMES.get(node.func, node.func.__name__)
        if node is sympy.pi or node is sympy.E:
            return +getattr(context, name)
        if node.func in _FUNCTIONS:
            return _FUNCTIONS[node.func](*map(self, node.args))
        if isinstance(node, sympy.Function) and hasattr(context, name):
            return getattr(context, name)(*map(self, node.args))
        if node.is_number or node.is_Atom or not node.is_commutative:
            raise _NoValueError
        return self._drawn(node)  # a node that stands for itself

    def _drawn(self, node: Expr) -> Any:
        if not node.is_commutative:
            raise _NoValueError
        if node.is_integer:
            return self._context.mpf(self._rng.randint(1, 9))
        size = self._context.mpf(self._rng.randint(1, 2**60)) / self._rng.randint(2**59, 2**60)
        if node.is_negative:
            return -size
        return size if node.is_positive or self._rng.random() < 0.6 else -size


_NAMES = {
    sympy.Abs: "fabs",
    sympy.elliptic_k: "ellipk",
    sympy.elliptic_f: "ellipf",
    sympy.elliptic_e: "ellipe",
    sympy.elliptic_pi: "ellippi",
    type(sympy.pi): "pi",
    type(sympy.E): "e",
}
_FUNCTIONS: dict[Any, Callable[..., Any]] = {sympy.Max: max, sympy.Min: min}
