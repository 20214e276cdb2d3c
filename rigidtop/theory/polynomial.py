"""Trigonometric polynomials in the rings of SymPy, which add and multiply without sorting terms.

What is no sum, product, power or rational number (a symbol, a sine, a root) is a generator, and so
is 1 over a sum.  Where a power of one is something else, sin² x = 1 − cos² x or (√D)² = D, no
higher power is left.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, reduce
from math import prod
from operator import itemgetter

from sympy import QQ, ZZ, Expr, Integer, Mul, Pow, Rational, cos, nan, oo, sin, together, zoo
from sympy.polys.rings import PolyElement, PolyRing, xring

CACHED = 1000
"""Forms that are kept, as SymPy keeps its own: a lecture asks for most of them more than once."""

_NUMBERLESS = {zoo, nan, oo, -oo}

_HINTS = {"log": False, "basic": False, "power_exp": False}
"""What `expand` would look for in every part of an expression, and is in no polynomial."""


class Polynomial:
    """An expression, multiplied out; with ``keep="sin"`` it is cos² that goes.

    >>> from sympy.abc import x, y
    >>> Polynomial(y*sin(x)**2 + y*cos(x)**2).expression()
    y
    """

    def __init__(self, expression: Expr, keep: str = "cos") -> None:
        self._gone, self._kept = (sin, cos) if keep == "cos" else (cos, sin)
        self._domain = ZZ
        # Each generator, with the power of it that is something else.
        self._relations: dict[Expr, tuple[int, Expr] | None] = {}
        if not expression.is_commutative:
            expression = expression.expand(**_HINTS)
        self._find(expression)
        self._names = [*self._relations] or [Integer(1)]
        self._at = {x: k for k, x in enumerate(self._relations)}
        self._ring = _ring(len(self._names), self._domain is ZZ)
        self._terms = self._lowered(self._value(expression))

    def expression(self) -> Expr:
        """The polynomial as an expression of SymPy."""
        return self._expression(self._terms)

    def is_zero(self) -> bool:
        """Whether it vanishes wherever it is defined, which it is somewhere.

        >>> from sympy.abc import x
        >>> Polynomial(sin(x)**2/(1 - cos(x)) - 1 - cos(x)).is_zero()
        True
        """
        zero = [power for element, power in self._ratio() if self._expression(element) == 0]
        return bool(zero) and min(zero) > 0

    def factors(self) -> list[tuple[Expr, int]]:
        """The factors with their powers, a number among them.

        >>> from sympy.abc import x, y
        >>> Polynomial(1/x - x/y**2).factors()
        [(x, -1), (y, -2), (-1, 1), (x - y, 1), (x + y, 1)]
        """
        factored = []
        for element, power in filter(itemgetter(1), self._ratio()):
            number, factors = _factored(element)
            factored.append((self._ring.domain.to_sympy(number), power))
            factored += [(self._expression(factor), power * n) for factor, n in factors]
        return [(base, power) for base, power in factored if base != 1]

    def _expression(self, element: PolyElement) -> Expr:
        return element.as_expr(*self._names)

    def _ratio(self) -> list[tuple[PolyElement, int]]:
        """Polynomials with their powers: negative in a denominator, 0 if it is no longer there."""
        over = {x: self._lowered(self._value(1 / x)) for x in self._at if x.is_Pow and x.exp == -1}
        if not all(over.values()) or not _NUMBERLESS.isdisjoint(self._at):
            return [(self._ring.zero, -1)]
        todo, done = [(self._terms, 1), *((below, 0) for below in over.values())], []
        while todo:
            terms, power = todo.pop()
            for x, k in self._at.items():
                exponents = [powers[k] for powers in terms] or [0]
                if x in over and any(exponents):
                    below, most = over[x], max(exponents)

                    def times(n: int, by: PolyElement = below, most: int = most) -> PolyElement:
                        return by ** (most - n)

                    todo += [(self._with(terms, k, times), power), (below, -most * power)]
                    break
                if min(exponents) < 0:
                    terms = terms * self._power(x, -min(exponents))
                    done.append((self._power(x, 1), min(exponents) * power))
            else:
                done.append((self._lowered(terms), power))
        return done

    def _find(self, node: Expr) -> None:
        """The generators of a part of the expression, and of what their powers are."""
        if parts := _parts(node):
            for part in parts:
                self._find(part)
        elif node.is_Rational:
            self._domain = self._domain if node.q == 1 else QQ
        elif node not in self._relations:
            factors = _factors(node)
            if factors == ((node, 1),):
                self._relations[node] = relation = self._relation(node)
                if relation is not None:
                    self._find(relation[1])
                elif node.is_Pow and node.exp == -1:
                    self._find(1 / node)
            else:
                for base, _ in factors:
                    self._find(base)

    def _relation(self, generator: Expr) -> tuple[int, Expr] | None:
        if isinstance(generator, self._gone):
            return 2, 1 - self._kept(*generator.args) ** 2
        if generator.is_Pow and generator.exp.is_Rational and generator.exp > 0:
            return generator.exp.q, generator.base
        return None

    def _value(self, node: Expr) -> PolyElement:
        """A part of the expression in the ring."""
        if node.is_Add:
            return sum(map(self._value, node.args), self._ring.zero)
        if parts := _parts(node):
            return prod(map(self._value, parts), start=self._ring.one)
        if node.is_Rational:
            return self._ring.ground_new(self._ring.domain.from_sympy(node))
        return prod((self._power(x, n) for x, n in _factors(node)), start=self._ring.one)

    def _power(self, base: Expr, exponent: int) -> PolyElement:
        if base not in self._at:
            return self._value(base) ** exponent
        powers = [0] * len(self._names)
        powers[self._at[base]] = exponent
        return self._ring.from_dict({tuple(powers): 1})

    def _lowered(self, terms: PolyElement) -> PolyElement:
        """The terms reduced by the relations, as long as one of them lowers a power."""
        rules = [(x, *relation) for x, relation in self._relations.items() if relation]
        while high := [r for r in rules if any(powers[self._at[r[0]]] >= r[1] for powers in terms)]:
            for x, least, other in high:
                by = self._value(other)

                def lower(n: int, x: Expr = x, q: int = least, by: PolyElement = by) -> PolyElement:
                    return self._power(x, n % q) * by ** (n // q) if n >= q else self._power(x, n)

                terms = self._with(terms, self._at[x], lower)
        return terms

    def _with(
        self, terms: PolyElement, k: int, instead: Callable[[int], PolyElement]
    ) -> PolyElement:
        """The sum with something else instead of each power of a generator."""
        sums = (part * instead(n) for n, part in _coefficients(terms, k).items())
        return sum(sums, self._ring.zero)


def _factored(element: PolyElement) -> tuple[object, list[tuple[PolyElement, int]]]:
    """The number in it, and its irreducible factors with their powers.

    `PolyElement.factor_list` looks for the factors at a point that it draws, and with an unlucky
    one a polynomial in 16 generators takes it hours.  Here it is asked last: nearly all of ours
    have a generator in its first power alone, and what has no factor without it is irreducible.
    """
    if element.is_ground:
        return element.LC, []
    number, element = element.primitive()
    if element.LC < 0:
        number, element = -number, -element
    for k, degree in sorted(enumerate(element.degrees()), key=itemgetter(1)):
        common = (
            reduce(PolyElement.gcd, _coefficients(element, k).values())
            if degree > 0
            else element.ring.one
        )
        if not common.is_ground:
            outer, rest = _factored(common), _factored(element.exquo(common))
            powers: dict[PolyElement, int] = {}
            for factor, power in (*outer[1], *rest[1]):
                powers[factor] = powers.get(factor, 0) + power
            return number * outer[0] * rest[0], list(powers.items())
        if degree == 1:
            return number, [(element, 1)]
    inner, factors = element.factor_list()
    return number * inner, factors


def _coefficients(element: PolyElement, k: int) -> dict[int, PolyElement]:
    """What stands with each power of a generator."""
    parts: dict[int, dict[tuple[int, ...], object]] = {}
    for powers, number in element.items():
        parts.setdefault(powers[k], {})[(*powers[:k], 0, *powers[k + 1 :])] = number
    return {n: element.ring.from_dict(part) for n, part in parts.items()}


@lru_cache(maxsize=CACHED)
def _ring(count: int, whole: bool) -> PolyRing:
    """The ring with so many generators, over the integers or over the rational numbers."""
    ring: PolyRing = xring([f"x{k}" for k in range(count)], ZZ if whole else QQ)[0]
    return ring


def _parts(node: Expr) -> tuple[Expr, ...]:
    """Terms, or factors, of which those that do not commute are one."""
    if node.is_Add or (node.is_Mul and node.is_commutative):
        return tuple(node.args)
    commuting, others = node.args_cnc() if node.is_Mul else ([], [])
    return (*commuting, Mul(*others)) if commuting else ()


@lru_cache(maxsize=10 * CACHED)
def _factors(node: Expr) -> tuple[tuple[Expr, int], ...]:
    """A power, or what is no number, sum or product, as factors with whole exponents.

    >>> from sympy.abc import x, y
    >>> _factors((x + y) ** Rational(-3, 2))
    ((1/(x + y), 1), (sqrt(x + y), -1))
    """
    if node.is_Symbol:
        return ((node, 1),)
    if not (node.is_Pow and node.exp.is_Rational):
        return ((node.expand(**_HINTS), 1),)
    sign = 1 if node.exp > 0 else -1
    whole, part = divmod(abs(node.exp.p), node.exp.q)
    base = node.base if sign > 0 else node.base.expand(**_HINTS)
    factors = [_powered(base, sign * whole)] if whole else []
    return (*factors, _powered(_root(node.base, node.exp.q), sign * part)) if part else (*factors,)


def _powered(base: Expr, exponent: int) -> tuple[Expr, int]:
    """A power as that of what a ring takes to it: a generator if the exponent is negative."""
    if exponent > 0:
        return base, exponent
    if base.is_Add:
        return 1 / base, -exponent
    numbers = base.is_Mul or base.is_Rational
    alone = not numbers and _factors(base) == ((base, 1),)
    return (base, exponent) if alone else (base**exponent, 1)


def _root(base: Expr, degree: int) -> Expr:
    """A root of a ratio as a ratio of roots, where that is so whatever its symbols are."""
    root = Pow(base, Rational(1, degree))
    if base.is_Add and any(power.exp.is_negative for power in base.atoms(Pow)):
        parted = Pow(together(base), Rational(1, degree))
        root = root if parted.is_Pow else parted
    return root.expand(**_HINTS)
