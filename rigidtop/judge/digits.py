"""Numbers that may hide what else is written, and places with enough digits to see it.

Worlds are found with 16 digits, of which s = x and s = x + 10⁻⁴⁵ are the same.  Where such a number
is written, the place of a world is followed to as many digits as that takes.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from math import ceil, log10
from typing import Any

import mpmath
import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Add, Expr, Float, Integer, Mul, Pow, Rational, Symbol, exp, fraction, log

from rigidtop.judge.program import Array, Steps, UnknownFunctionError

_FAR, _SIMPLE = 3.5, 1000
"""So many powers of ten away from 1 a number may hide what else is written, or be hidden by it, as
the cosine of 10⁻⁴ is by 1; so may a fraction of which neither part has fewer digits, and which is
no decimal number by a simple one."""

_FIGURES, _LONG = 3, 17
"""With so many figures a decimal number may be a rounded one, with more than so many it is not."""

_SUM = re.compile("0{6}|9{6}")
"""What stands between the figures of 1 + 10⁻⁹, or in 1 − 10⁻⁹, and hardly in a rounded number."""

_DIGITS, _MOST_DIGITS, _SPARE = 60, 1000, 12
"""With so many digits sides are compared; with more, but not with more than so many, where smaller
or larger numbers are written; of which so many are left to rounding."""

_LESS_THAN_ONE = 1 - 1e-6
"""A rounded decimal number is off by no more than this share of one in its last digit."""

_NO_VALUE = (UnknownFunctionError, ArithmeticError, ValueError)

_DEPENDENT = 1e-8
"""An equation whose slopes are those of others but for this share says what they say."""


@lru_cache(maxsize=20_000)
def has_extremes(expression: Expr) -> bool:
    """Whether a number in it is so small, or so large, that it may hide what else is written.

    So does one with more digits than anybody writes down, as 1 + 10⁻⁴⁵ has.
    """
    below = any(map(has_extremes, expression.args))
    return below or any(_own_extent(x) > 0 for x in _numbers_of(expression))


def needed(expressions: Sequence[Expr]) -> int:
    """How many digits tell expressions apart: a multiple, as places are found for each number."""
    return _DIGITS * (1 + ceil(sum(map(_extent, expressions)) / _DIGITS))


@lru_cache(maxsize=20_000)
def _extent(expression: Expr) -> int:
    """How many digits its small, large and long numbers have, all together."""
    parts = {*sympy.preorder_traversal(expression)}
    return sum(_own_extent(x) for part in parts for x in _numbers_of(part))


def _numbers_of(part: Expr) -> Iterator[Expr]:
    """A part if it is a number; of a product the numbers in it as one: π¹⁰e¹⁰."""
    if isinstance(part, (Rational, Pow, exp)) and _is_written(part) and part != 0:
        yield part
    if isinstance(part, Mul):
        factors = [x for x in part.args if _is_written(x)]
        if len(factors) > 1:
            yield Mul(*factors)


def _is_written(part: Expr) -> bool:
    """Whether it is a real number that may be written: no floating-point one out of an integral."""
    return bool(part.is_number and part.is_real and not part.has(Float))


@lru_cache(maxsize=2_000)
def _own_extent(number: Expr) -> int:
    """The same of one number; 0 if it hides nothing."""
    less, more = sorted(map(_decades, fraction(number)))
    hides = more - less > _FAR or (number.is_Rational and less > _FAR and _is_exact(number))
    return ceil(more) if hides else 0


def _decades(number: Expr) -> float:
    """The logarithm of its size, to the base 10."""
    if isinstance(number, Integer):
        return abs(int(number)).bit_length() * log10(2)
    return abs(float(log(abs(number), 10).evalf(3)))


def _is_exact(number: Rational) -> bool:
    """Whether nobody writes it as a rounded number, as one beside a far smaller one: 1 + 10⁻⁹."""
    figures, _ = _decimal(number)
    return not figures or len(figures) > _LONG or bool(_SUM.search(figures))


def _last_place(number: Rational) -> Rational | None:
    """One more in the last place of a number that may be a rounded one; None of other numbers."""
    figures, place = _decimal(number)
    return None if len(figures) < _FIGURES or _is_exact(number) else place


@lru_cache(maxsize=2_000)
def _decimal(number: Rational) -> tuple[str, Rational]:
    """The figures of a decimal number, perhaps by a simple one, and what one in the last is.

    No figures of other numbers, and of one with more than anybody writes.
    """
    twos, fives = (sympy.multiplicity(x, number.q) for x in (2, 5))
    shift = max(twos, fives)
    simple = number.q // (2**twos * 5**fives)
    mantissa = abs(number.p) * 2 ** (shift - twos) * 5 ** (shift - fives)
    if simple > _SIMPLE or mantissa.bit_length() > 1_000:
        return "", Integer(0)
    digits = str(mantissa)
    figures = digits.rstrip("0")
    return figures, Rational(10) ** (len(digits) - len(figures) - shift) / simple


@dataclass(frozen=True, eq=False)
class Place:
    """Numbers of letters with many digits; they are `exact` where no equation gave them."""

    numbers: Mapping[Symbol, Any]
    digits: int
    exact: bool = False
    _known: dict[Expr, tuple[Any, Any]] = field(default_factory=dict)

    def agree(self, left: Expr, right: Expr) -> bool | None:
        """Whether two sides do, but for decimals that are rounded in them; None if it is not seen.

        They may have no value there, or one with too few digits.
        """
        gap = left - right
        try:
            value, size = self._of(gap)
            if self._is_nothing(value, size):
                return True if self._is_seen(size, left, right) else None
            rounding = self._rounding(gap, value)
            if abs(value) >= rounding:
                return False
            terms = Add.make_args(gap.expand())
            return None if any(abs(self._of(x)[0]) < rounding for x in terms) else True
        except _NO_VALUE:
            return None

    def hold(self, equations: Sequence[Expr], slopes: Sequence[float]) -> bool:
        """Whether equations do, each beside its terms, or as far as it changes with its letters."""
        try:
            gaps = ((*self.value(x), slope) for x, slope in zip(equations, slopes, strict=True))
            return all(self._is_nothing(gap, size + slope) for gap, size, slope in gaps)
        except _NO_VALUE:
            return False

    def _is_nothing(self, value: Any, size: Any) -> bool:
        return bool(abs(value) <= size * self._context.mpf(10) ** (_SPARE - self.digits))

    def _is_seen(self, size: Any, *sides: Expr) -> bool:
        """Whether terms are not so large, as where zero divides them, that all is rounded away."""
        largest = max(1, *(abs(self._of(x)[0]) for x in sides))
        return bool(size <= largest * self._context.mpf(10) ** (self.digits // 2))

    def value(self, expression: Expr) -> tuple[Any, Any]:
        """The number of an expression, and the size of its terms; raises UnknownFunctionError."""
        part = self._known.get(expression)
        if part is None:
            part = self._known[expression] = self._worked_out(expression)
        return part

    def with_digits(self, digits: int) -> Place:
        """The same place with fewer digits; what is smaller than the last of them is zero."""
        context = _context(digits)
        last = context.mpf(10) ** -digits
        numbers = {x: context.convert(v) if abs(v) > last else 0 for x, v in self.numbers.items()}
        return Place(numbers, digits, self.exact)

    @property
    def _context(self) -> Any:
        return _context(self.digits)

    @cached_property
    def _rational(self) -> dict[Symbol, Rational]:
        return {x: Rational(float(number)) for x, number in self.numbers.items()}

    def _of(self, expression: Expr) -> tuple[Any, Any]:
        """The same; of an exact fraction no digit is rounded away."""
        if self.exact:
            number = expression.xreplace(self._rational)
            if number.is_Rational:
                return number, Integer(0)
        if self.digits > _MOST_DIGITS:
            raise UnknownFunctionError("it takes too many digits")
        return self.value(expression)

    def _rounding(self, gap: Expr, value: Any) -> Any:
        """By how much a difference changes with the last digits of rounded decimals."""
        lasts = ((x, _last_place(x)) for x in gap.atoms(Rational))
        others = (gap.xreplace({x: x + last}) for x, last in lasts if last is not None)
        return sum(abs(self._of(x)[0] - value) for x in others) * _LESS_THAN_ONE

    def _worked_out(self, node: Expr) -> tuple[Any, Any]:
        context = self._context
        if not node.args:
            value = self.numbers[node] if node in self.numbers else self._number(node)
            return value, abs(value)
        below = [self.value(x) for x in node.args]
        if node.is_Add:
            return context.fsum(x for x, _ in below), context.fsum(size for _, size in below)
        if node.is_Mul:
            return context.fprod(x for x, _ in below), context.fprod(size for _, size in below)
        if node.is_Pow:
            (base, size), (power, _) = below
            value = context.power(base, int(node.exp) if node.exp.is_Integer else power)
            if node.exp.is_Integer and node.exp > 0:
                return value, context.power(size, int(node.exp))
            return value, abs(value) * (size / abs(base) if base else 1)
        return self._of_function(node, *below)

    def _of_function(self, node: Expr, *below: tuple[Any, Any]) -> tuple[Any, Any]:
        name = _NAMES.get(node.func, node.func.__name__)
        function = getattr(self._context, name, None)
        if function is None or len(below) != 1 or not isinstance(node, sympy.Function):
            raise UnknownFunctionError(f"{node.func} has no numbers")
        [(at, size)] = below
        value = function(self._context.re(at) if node.func is sympy.sign else at)
        return value, abs(value) * (1 + size) + size

    def _number(self, node: Expr) -> Any:
        context = self._context
        if node.is_Rational:
            return context.mpf(int(node.p)) / int(node.q)
        if node is sympy.I:
            return context.mpc(0, 1)
        if not node.is_NumberSymbol:  # numbers of floating point have too few digits
            raise UnknownFunctionError(f"{node} has no digits")
        return context.convert(node.evalf(self.digits + 5))


_NAMES = {sympy.Abs: "fabs", sympy.conjugate: "conj"}


@lru_cache(maxsize=50)
def _context(digits: int) -> Any:
    context = mpmath.MPContext()
    context.dps = digits
    return context


def places(
    letters: Sequence[Symbol], points: Array, digits: int, exact: bool = False
) -> list[Place]:
    """The places that points are, with as many digits."""
    context = _context(digits)
    real = bool(np.abs(points.imag).max(initial=0) < 1e-9)
    columns = points.real.T.tolist() if real else points.T.tolist()
    return [
        Place({x: context.convert(v) for x, v in zip(letters, column, strict=True)}, digits, exact)
        for column in columns
    ]


def refined(
    equations: Sequence[Expr], letters: Sequence[Symbol], points: Array, digits: int
) -> Iterator[Place | None]:
    """The places nearby at which equations hold in so many digits; None where none is found.

    All letters stay what they are but as many as there are independent equations.
    """
    if digits > _MOST_DIGITS:
        yield from [None] * points.shape[1]
        return
    try:
        steps = Steps(equations, letters)
        for k, start in enumerate(places(letters, points, digits + _SPARE)):
            place = _refined(equations, start, steps.at(points[:, [k]]).slopes[:, :, 0])
            yield None if place is None else place.with_digits(digits)
    except UnknownFunctionError:
        yield from [None] * points.shape[1]


def _refined(equations: Sequence[Expr], place: Place, slopes: Array) -> Place | None:
    """Newton's method with the slopes of the start, which are right to as many digits as it is."""
    scales = np.abs(slopes).max(axis=1, initial=0)
    if not np.isfinite(scales).all():
        return None
    slopes = slopes / np.where(scales > 0, scales, 1)[:, None]
    rows, columns = _independent(slopes)
    inverse = np.linalg.inv(slopes[np.ix_(rows, columns)])
    inverse = (inverse if inverse.imag.any() else inverse.real).astype(object)
    moving = [[*place.numbers][k] for k in columns]
    own, sizes = [equations[k] for k in rows], scales[rows].tolist()
    for _ in range(place.digits // 4):
        if place.hold(own, sizes):
            break
        try:
            gaps = [place.value(x)[0] / size for x, size in zip(own, sizes, strict=True)]
        except _NO_VALUE:
            return None
        moves = zip(moving, inverse @ np.array(gaps, object), strict=True)
        there = {x: place.numbers[x] - by for x, by in moves}
        place = Place({**place.numbers, **there}, place.digits)
    return place if place.hold(equations, scales.tolist()) else None


def _independent(slopes: Array) -> tuple[list[int], list[int]]:
    """The equations that say something new, and as many letters by which they are solved."""
    left: NDArray[Any] = slopes.copy()
    rows: list[int] = []
    columns: list[int] = []
    while left.size:
        row, column = np.unravel_index(np.abs(left).argmax(), left.shape)
        if not abs(left[row, column]) > _DEPENDENT:
            break
        rows.append(int(row))
        columns.append(int(column))
        left = left - np.outer(left[:, column], left[row]) / left[row, column]
        left[row], left[:, column] = 0, 0
    return rows, columns
