"""Does an expression vanish, differ from zero, or exceed it?  And where does it not?

Every answer but "unknown" is a proof: normal forms of rational expressions in symbols, sines,
cosines and square roots decide zero; factors of known sign decide the rest; a point with numbers
refutes.  Forty digits at random points are evidence, and are called so.
"""

from __future__ import annotations

import math
import random
import zlib
from collections.abc import Callable, Iterator, Mapping, Sequence
from enum import StrEnum
from functools import lru_cache
from itertools import combinations
from typing import Any

import sympy
from sympy import Expr, Integer, Matrix, Rational, Symbol, cos, pi, sin
from sympy.core.relational import Relational

from rigidtop.theory.polynomial import Polynomial
from rigidtop.theory.symbols import t
from rigidtop.theory.trig import reduce_ratio


class Verdict(StrEnum):
    """From what needs nothing to what can't be let pass; a claim gets the last of its checks'."""

    DEFINITION = "definition"
    PROVED = "proved"
    SAMPLED = "sampled"
    ASSUMING = "assuming"
    CONVENTION = "convention"
    FALSE = "false"
    UNDECIDED = "undecided"


Point = Mapping[Symbol, Expr]
Floats = list[float]

TOLERANCE = 1e-9
"""Below this, relative to the values compared, a difference in double precision counts as zero."""

KEPT = 10_000
"""Numbers that are kept as floats: they are few, and come again and again."""

_ANGLES = tuple(pi * Rational(*pair) for pair in ((1, 3), (1, 6), (1, 4), (1, 2), (2, 3), (1, 1)))
_POSITIVE = tuple(Rational(n, d) for n, d in ((1, 1), (2, 1), (3, 1), (1, 2), (5, 1), (1, 3)))
_REAL = tuple(Rational(n, d) for n, d in ((1, 1), (2, 1), (-1, 1), (3, 1), (1, 2), (-2, 1), (1, 5)))


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
    if sympy.count_ops(expression) < MOST_SHOWN and vanishes(expression):
        return Verdict.PROVED
    return Verdict.SAMPLED if digits_vanish([expression]) else None


def in_digits(
    gaps: Sequence[tuple[str, Expr]], places: int = 2, bounds: Sequence[Expr] = ()
) -> bool | None:
    """Whether scalars are as relations to 0 where `bounds` are positive: False is for certain.

    Asked at some points in double precision; None where there is none at which all is real, as of
    √x + √−x.
    """
    found = None
    for attempt in range(8 * places):  # a root may be real at few points only
        if bounds and not all(bound > 0 for bound in values(bounds, attempt)):
            continue
        rows = [values(sympy.Add.make_args(gap), attempt) for _, gap in gaps]
        if not all(math.isfinite(sum(row)) for row in rows):
            continue
        for (relation, _), row in zip(gaps, rows, strict=True):
            if not holds(relation, sum(row), 1 + sum(map(abs, row))):
                return False
        found, places = True, places - 1
        if not places:
            break
    return found


def eliminated(
    wanted: Expr, given: Sequence[Expr], unknowns: Sequence[Symbol]
) -> tuple[Expr, Matrix] | None:
    """What vanishes where `wanted` does because `given` do, all linear in unknowns.

    None where they are not, where what is given says nothing of the unknowns, where numbers show
    that it does not vanish, or where it is too large to be written.  As many unknowns are
    eliminated as there are equations; the others stand in what is left.  With it the matrix of
    slopes, of `given` and in the last row of `wanted`, whose minor was multiplied by.

    >>> a, b, x = sympy.symbols("a b x")
    >>> eliminated(a + b - 3*x, [a - x, b - 2*x], [a, b])[0], eliminated(a, [b - x], [a, b])
    (0, None)
    >>> eliminated(a + b - 4*x, [a - x, b - 2*x], [a, b])
    """
    everything = [*given, wanted]
    slopes = sympy.Matrix([[e.diff(x) for x in unknowns] for e in everything])
    used = [k for k in range(len(unknowns)) if any(slopes[:-1, k])]
    if slopes.has(*unknowns) or not any(slopes[-1, k] for k in used):
        return None
    for chosen in combinations(used, len(given)):
        matrix = slopes[:, list(chosen)]
        none = dict.fromkeys((unknowns[k] for k in chosen), Integer(0))
        whole = matrix.row_join(sympy.Matrix([e.subs(none) for e in everything]))
        gaps = [gap for gap in (_gap(whole, attempt) for attempt in range(4)) if gap is not None]
        if not all(holds("=", gap) for gap in gaps):
            return None
        if gaps and len(given) * sympy.count_ops(whole) > MOST_SHOWN:
            return None
        if gaps or evidence(matrix[:-1, :].det(method="berkowitz")) is None:
            return whole.det(method="berkowitz"), matrix
    return None


def _gap(whole: Matrix, attempt: int) -> float | None:
    """By how much the last row is no sum of multiples of the others, beside its terms' size.

    None where numbers do not tell: the others depend on one another there, or are not real.
    """
    numbers = Matrix(*whole.shape, values([*whole], attempt))
    minor, last = numbers[:-1, :-1], numbers[:-1, -1]
    if not all(map(math.isfinite, numbers)) or not abs(minor.det()) > TOLERANCE:
        return None
    factors = minor.T.LUsolve(numbers[-1, :-1].T)
    terms = [numbers[-1, -1], *(-x * y for x, y in zip(factors, last, strict=True))]
    return float(sum(terms) / (1 + sum(map(abs, terms))))


def divided_by(slopes: Matrix) -> list[Expr]:
    """The factors by which the last row is divided where it is a sum of multiples of the others.

    >>> r, x = sympy.symbols("r x")
    >>> divided_by(Matrix([[r**2, 0], [0, x], [r, x]])), divided_by(Matrix([[r], [r**2]]))
    ([r], [])
    """
    factors = slopes[:-1, :].T.LUsolve(slopes[-1, :].T)
    below = [sympy.fraction(reduce_ratio(factor))[1] for factor in factors]
    return list(dict.fromkeys(x for each in below for x in _factors(each) if x.free_symbols))


def nonzero(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if every factor is known to differ from zero, by its symbols or a condition.

    >>> x, m = sympy.Symbol("x", real=True), sympy.Symbol("m", positive=True)
    >>> nonzero(m*sin(x)**2), nonzero(m*sin(x)**2, [sympy.Ne(sin(x), 0)])
    (False, True)
    """
    known = [condition.lhs - condition.rhs for condition in conditions if _strict(condition)]
    known_factors = [f for k in known for f in _factors(reduce_ratio(k))]
    return all(
        factor.is_nonzero or any(vanishes(factor**2 - k**2) for k in known_factors)
        for factor in _factors(reduce_ratio(expression))
    )


def positive(expression: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if the sign of every factor is known and their product is positive.

    >>> a, b = sympy.symbols("a b", real=True)
    >>> positive((a - b)**3, [sympy.Gt(a, b)]), positive(a - b)
    (True, False)
    """
    ratio = reduce_ratio(expression)
    if ratio.is_positive or _sign(ratio, conditions) == 1:
        return True
    # A condition may bound a product that stands in the ratio as a whole.
    return any(_sign(reduce_ratio(ratio / fact), conditions) == 1 for fact in _facts(conditions))


def _facts(conditions: Sequence[Relational]) -> list[Expr]:
    """What the conditions say to be positive; a ≥ b together with a ≠ b is a > b."""
    strict = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Gt, sympy.Lt))]
    weak = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Ge, sympy.Le))]
    unequal = [c.lhs - c.rhs for c in conditions if isinstance(c, sympy.Ne)]
    return strict + [w for w in weak if any(sympy.expand(w**2 - u**2) == 0 for u in unequal)]


def _sign(ratio: Expr, conditions: Sequence[Relational]) -> int:
    """1 or −1 where the sign of a product is known, else 0."""
    sign = 1
    for factor in sympy.Mul.make_args(ratio):
        base, power = factor.as_base_exp()
        if power.is_even:
            known = 1 if nonzero(base, conditions) else 0
        else:
            known = _base_sign(base, conditions)
        if known == 0:
            return 0
        sign *= known
    return sign


def _base_sign(base: Expr, conditions: Sequence[Relational]) -> int:
    if base.is_positive:
        return 1
    if base.is_negative:
        return -1
    for fact in _facts(conditions):
        quotient = reduce_ratio(base / fact)
        if quotient.is_number:
            return 1 if quotient > 0 else -1
        if quotient.is_positive:
            return 1
    if isinstance(base, sympy.Add):
        for sign in (1, -1):
            terms = [sign * term for term in _grouped(base)]
            if all(_at_least_zero(t, conditions) for t in terms) and any(
                t.is_positive or _sign(reduce_ratio(t), conditions) == 1 for t in terms
            ):
                return sign
    return 0


def _grouped(total: Expr) -> list[Expr]:
    """The terms of a sum, those with a common square of a symbol taken together."""
    factors = {f for term in total.args for f in term.args}
    squares = {f for f in factors if f.is_Pow and f.exp == 2 and not f.base.is_positive}
    for square in sorted(squares, key=str):
        grouped = sympy.collect(total, [square, *sorted(squares - {square}, key=str)])
        if isinstance(grouped, sympy.Add):
            return list(grouped.args)
    return list(total.args)


def _at_least_zero(term: Expr, conditions: Sequence[Relational]) -> bool:
    factored = reduce_ratio(term)
    bases = [f.as_base_exp() for f in sympy.Mul.make_args(factored)]
    odd = sympy.Mul(*(b**p for b, p in bases if not p.is_even))
    if odd.is_nonnegative or _sign(odd, conditions) == 1:
        return True
    weak = [c.gts - c.lts for c in conditions if isinstance(c, (sympy.Ge, sympy.Le))]
    return any(reduce_ratio(odd / fact).is_positive for fact in weak)


def _strict(condition: Relational) -> bool:
    return isinstance(condition, (sympy.Ne, sympy.Gt, sympy.Lt))


def _factors(ratio: Expr) -> list[Expr]:
    """What a ratio in lowest terms has above, of a sum what no number divides."""
    numerator, _ = sympy.fraction(ratio)
    bases = [f.as_base_exp()[0] for f in sympy.Mul.make_args(numerator)]
    return [base.primitive()[1] if base.is_Add else base for base in bases]


def lost(wanted: Expr, given: Expr, conditions: Sequence[Relational] = ()) -> list[Expr]:
    """What may vanish of that by which given = 0 is divided to make wanted = 0.

    Where it is no multiple, this is given itself.

    >>> x, y = sympy.symbols("x y", real=True)
    >>> lost(y - 1, x*(y - 1)), lost(x*(y - 1), y - 1)
    ([x], [])
    """
    if vanishes(wanted):
        return []
    factor = reduce_ratio(given / wanted)
    return [x for x in _factors(factor) if not nonzero(x, conditions)]


def follows(residual: Expr, given: Expr, conditions: Sequence[Relational] = ()) -> bool:
    """True only if given = 0 implies residual = 0: their ratio is a factor known to be nonzero.

    >>> x, y = sympy.symbols("x y", real=True)
    >>> follows(y - 1, x*(y - 1)), follows(y - 1, x*(y - 1), [sympy.Ne(x, 0)])
    (False, True)
    """
    return not lost(residual, given, conditions)


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
        number = at(point)
        if any(math.isnan(number(term)) for row in rows for term in row):
            continue  # digits of what is not real cost SymPy minutes
        for x, part in parts:
            point[x] = part.evalf(digits + 30, subs=point)
        values = iter([term.evalf(digits + 10, subs=point) for term in terms])
        numbers = [[next(values) for _ in row] for row in rows]
        if not all(v.is_number and v.is_finite and v.is_real for row in numbers for v in row):
            continue
        if any(abs(sympy.Add(*row)) > limit * (1 + sympy.Add(*map(abs, row))) for row in numbers):
            return False
        found += 1
        if found == points:
            return True
    return False


def _anywhere(x: Symbol, rng: random.Random) -> Expr:
    """A rational number, of either sign if the symbol allows, from a hundredth to a thousand."""
    size = Rational(rng.randint(1, 997), rng.choice((1, 31, 499, 997)))
    return size if x.is_positive or rng.random() < 0.5 else -size


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


def values(expressions: Sequence[Expr], attempt: int) -> Floats:
    """The expressions where each symbol is `somewhere`."""
    free = set().union(*(e.free_symbols for e in expressions))
    at = {x: somewhere(x, attempt) for x in free}
    return [_number(e, at) for e in expressions]


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
