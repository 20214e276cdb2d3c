"""Numbers at points: where a counterexample is looked for, and what two expressions are there."""

from __future__ import annotations

import math
import random
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from functools import lru_cache
from typing import Any

import sympy
from sympy import Expr, Integer, Matrix, Rational, Symbol, cos, pi, sin

from rigidtop.theory.symbols import t

Point = Mapping[Symbol, Expr]

TOLERANCE = 1e-9
"""Below this, relative to the values compared, a difference in double precision counts as zero."""

KEPT = 10_000
"""Numbers that are kept as floats: they are few, and come again and again."""

_ANGLES = tuple(pi * Rational(*pair) for pair in ((1, 3), (1, 6), (1, 4), (1, 2), (2, 3), (1, 1)))
_POSITIVE = tuple(Rational(n, d) for n, d in ((1, 1), (2, 1), (3, 1), (1, 2), (5, 1), (1, 3)))
_REAL = tuple(Rational(n, d) for n, d in ((1, 1), (2, 1), (-1, 1), (3, 1), (1, 2), (-2, 1), (1, 5)))


def anything(_: Point) -> bool:
    """Nothing is known of what has the numbers of a point: it may have any."""
    return True


def holds(relation: str, gap: float, size: float = 1.0) -> bool:
    """Whether a difference is as a relation to 0 says, beside `size`, that of what is compared.

    >>> holds("=", 1e-7, 1e3), holds(">", 1e-12), holds("≥", -1e-12), holds("≠", 1.0)
    (True, False, True, True)
    """
    rounding = TOLERANCE * size
    if relation in ("=", "≡"):
        return abs(gap) < rounding
    if relation == "≠":
        return abs(gap) >= rounding
    if relation in (">", "≥"):
        return gap > (rounding if relation == ">" else -rounding)
    if relation in ("<", "≤"):
        return gap < (-rounding if relation == "<" else rounding)
    raise ValueError(f"numbers can't judge the relation {relation!r}")


def apart(left: float, right: float) -> bool:
    """Whether two numbers differ by more than rounding; what is infinite or none tells nothing.

    >>> apart(0.1 + 0.2, 0.3), apart(1, 2), apart(1, math.inf)
    (False, True, False)
    """
    size = 1 + abs(left) + abs(right)
    return math.isfinite(size) and holds("≠", left - right, size)


def points(
    symbols: Sequence[Symbol],
    angles: set[Symbol],
    tries: int = 600,
    exists: Callable[[Point], bool] = anything,
) -> Iterator[Point]:
    """Points with short numbers, the shortest first: where a counterexample is looked for.

    What has the numbers of a point, such as a body with these moments, `exists`.
    """
    rng = random.Random(1)
    for attempt in range(tries):
        # The choice widens slowly, so that what is found first can be read aloud.
        width = 2 + attempt // 60
        turns = (*_ANGLES[:width], Integer(0), *(-a for a in _ANGLES[: width - 2]))
        positive, real = _POSITIVE[:width], (*_REAL[:width], Integer(0))
        pools = [turns if x in angles else positive if x.is_positive else real for x in symbols]
        for _ in range(_REDRAWS):
            point = {x: rng.choice(pool) for x, pool in zip(symbols, pools, strict=True)}
            if exists(point):
                yield point
                break


_REDRAWS = 200
"""So often a point is drawn again when nothing has its numbers."""


ROUNDING = 1e-15
"""Less than this is zero in double precision, for values of the size of those drawn."""


@lru_cache(maxsize=KEPT)
def somewhere(atom: Expr, attempt: int) -> float:
    """A number between ½ and 1½ that is hardly another atom's: of no special kind."""
    return 0.5 + zlib.crc32(f"{attempt} {atom}".encode()) % 9973 / 9973


def values(expressions: Sequence[Expr], attempt: int) -> list[float]:
    """The expressions where each symbol is `somewhere`."""
    free = set().union(*(e.free_symbols for e in expressions))
    at = {x: somewhere(x, attempt) for x in free}
    return [_number(e, at) for e in expressions]


def magnitude(expression: Expr, attempt: int) -> float:
    """The size of the largest numbers that cancel in an expression where `values` are taken.

    Less than its rounding can't be told from zero there.

    >>> x = sympy.Symbol("x")
    >>> magnitude((10**9 + x) ** 2 - 10**18, 0) > 1e18
    True
    """
    at = {x: somewhere(x, attempt) for x in expression.free_symbols}
    try:
        return _magnitude(expression, at)
    except (ZeroDivisionError, OverflowError, ValueError):
        return math.inf


def _magnitude(node: Expr, at: Mapping[Symbol, float]) -> float:
    if isinstance(node, sympy.Add):
        return math.fsum(_magnitude(term, at) for term in node.args)
    if isinstance(node, sympy.Mul):
        return math.prod(_magnitude(factor, at) for factor in node.args)
    if isinstance(node, sympy.Pow) and node.exp.is_number and node.exp > 0:
        return float(_magnitude(node.base, at) ** float(node.exp))
    return abs(_float(node, at))


def angle_symbols(expressions: Sequence[Expr]) -> set[Symbol]:
    """The symbols that stand inside a sine or a cosine, but for factors of the time."""
    inside = {f.args[0].xreplace({t: Integer(0)}) for e in expressions for f in e.atoms(sin, cos)}
    return set().union(*(argument.free_symbols for argument in inside)) if inside else set()


Number = Callable[[Expr], float]
"""What gives an expression's number at a point: infinite where divided by zero, NaN if not real."""


def at(point: Point, hidden: Mapping[Symbol, Expr] = {}) -> Number:
    """The numbers at a point; `hidden` are symbols that are themselves expressions in its own."""
    known = _Values({x: _plain(v) for x, v in point.items()}, hidden)
    return lambda expression: _number(expression, known)


def places(
    expressions: Sequence[Expr],
    *,
    hidden: Mapping[Symbol, Expr] = {},
    given: Sequence[Expr] = (),
    unknowns: Sequence[Symbol] = (),
    angles: set[Symbol] | None = None,
    drawn: Mapping[Symbol, Symbol] = {},
    tries: int = 600,
    exists: Callable[[Point], bool] = anything,
) -> Iterator[tuple[dict[Symbol, Expr], Number]]:
    """The points at which numbers are looked for, short ones first, and the numbers there.

    Those of `unknowns` are not drawn: at them `given`, which are linear in them, vanish.  A symbol
    is `drawn` as another one is: of its sign.
    """
    symbols = set().union(*(e.free_symbols for e in (*expressions, *given, *hidden.values())))
    wanted = [x for x in unknowns if x in symbols]
    none = dict.fromkeys(wanted, Integer(0))
    rest = [e.xreplace(none) for e in given]
    slopes = [[e.diff(x) for x in wanted] for e in given]
    angles = angle_symbols([*expressions, *hidden.values()]) if angles is None else angles
    names = {drawn.get(x, x): x for x in sorted(symbols - {*hidden, *wanted}, key=str)}
    for found in points([*names], angles, tries, exists):
        point = {names[x]: value for x, value in found.items()}
        if wanted:
            number = at(point)
            matrix = Matrix([[number(slope) for slope in row] for row in slopes])
            known = Matrix([-number(e) for e in rest])
            finite = all(x.is_finite for x in (*matrix, *known))
            if not (finite and matrix.is_square and abs(matrix.det()) > TOLERANCE):
                continue
            point |= dict(zip(wanted, matrix.LUsolve(known), strict=True))
        yield point, at(point, hidden)


class _Values(dict[Symbol, float]):
    """The numbers of symbols; what is `hidden` is evaluated when it is asked for."""

    def __init__(self, known: Mapping[Symbol, float], hidden: Mapping[Symbol, Expr]) -> None:
        super().__init__(known)
        self.hidden = hidden

    def __missing__(self, x: Symbol) -> float:
        value = _number(self.hidden[x], self)
        return self.setdefault(x, value if math.isfinite(value) else math.nan)


def _number(expression: Expr, at: Mapping[Symbol, float]) -> float:
    """The value of an expression: infinite where divided by zero, NaN if not real."""
    try:
        return _float(expression, at)
    except ZeroDivisionError:
        return math.inf
    except (OverflowError, ValueError):
        return math.nan


def _power(base: float, exponent: float) -> float:
    if base < 0 and not exponent.is_integer():
        raise ValueError("not real")
    # A sine or cosine that is zero in exact numbers is 1e-16 here.
    if abs(base) < ROUNDING and exponent < 0:
        raise ZeroDivisionError
    return float(base**exponent)


_FUNCTIONS: Mapping[Any, Callable[..., float]] = {
    sympy.Pow: _power,
    sin: math.sin,
    cos: math.cos,
    sympy.tan: math.tan,
    sympy.Abs: abs,
    sympy.log: math.log,
}
"""Functions of floats."""


def _float(node: Expr, at: Mapping[Symbol, float]) -> float:
    """A walk over the tree: for a few points cheaper by far than compiling it.

    Raises ZeroDivisionError, and ValueError where a value is not real.
    """
    if isinstance(node, Symbol):
        return at[node]
    if isinstance(node, sympy.Add):
        return math.fsum(_float(term, at) for term in node.args)
    if isinstance(node, sympy.Mul):
        return math.prod(_float(factor, at) for factor in node.args)
    function = _FUNCTIONS.get(node.func)
    if function is not None:
        return function(*(_float(argument, at) for argument in node.args))
    if node.args:
        node = node.func(*(sympy.Float(_float(argument, at)) for argument in node.args))
    if not node.is_real:
        raise ValueError("not real")
    return _plain(node)


@lru_cache(maxsize=KEPT)
def _plain(number: Expr) -> float:
    """As a float, which costs SymPy an evaluation."""
    return float(number)
