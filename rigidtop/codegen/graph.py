"""Expressions as one graph in which equal parts are one node: nothing is ever multiplied out.

A node is a sum, a product, a power, a call or a leaf of those before it.  Each has its value at one
point, to many digits, with letters that have no relation there.  What is made of analytic functions
and has the same value as another node is the same function: sin² + cos² is 1 without any rule.

>>> from rigidtop.codegen.nodes import ONE
>>> x, y = sympy.symbols("x y")
>>> graph = Graph(next(points([x, y])))
>>> value = graph.expression((x + y) ** 2 * (sympy.sin(x) ** 2 + sympy.cos(x) ** 2))
>>> slope = graph.derivative(value, Direction({x: ONE}))
>>> from rigidtop.codegen.lines import straight_line
>>> straight_line(graph, [value, slope], sympy.numbered_symbols("x"))
StraightLine(shared=((x0, x + y),), results=(x0**2, 2*x0))
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from fractions import Fraction
from functools import lru_cache
from typing import Any, TypeVar

import mpmath
import sympy
from sympy import Derivative, Dummy, Expr, Subs
from sympy.core.function import AppliedUndef

from rigidtop.codegen.nodes import (
    ZERO,
    CallNode,
    Leaf,
    Node,
    Number,
    PowerNode,
    ProductNode,
    SumNode,
    Value,
    parts,
)
from rigidtop.codegen.points import DIGITS, NotRealError, decimal, generic, number_of, points
from rigidtop.errors import RigidtopError

Made = TypeVar("Made")


SAME = 160
"""Bits in which two values have to agree."""

ANALYTIC = (sympy.sin, sympy.cos, sympy.tan, sympy.exp, sympy.sinh, sympy.cosh, sympy.tanh)
"""Functions that are known everywhere once they are known somewhere."""

OWN = (AppliedUndef, Derivative, Subs)
"""Functions that nobody knows, which are letters too, and so are their slopes."""

SPARE = 1000
"""Letters that have numbers before those that come up in derivatives."""

CANDIDATES = 32
"""Sums, and products, with a term in common that are tried as a part of another."""


@dataclass(frozen=True)
class Direction:
    """Rates of letters, and what is known of the rates of nodes."""

    rates: Mapping[Expr, Value]
    known: dict[int, Value] = field(default_factory=dict)


class Graph:
    """Nodes, each once; `point` has a number for each letter."""

    def __init__(self, point: Mapping[Expr, Expr]) -> None:
        self.point = point
        self.nodes: list[Node] = []
        self.numbers: list[Any] = []
        self._analytic: list[bool] = []
        self._places: dict[Node, Value] = {}
        self._equals: dict[Any, Value] = {}
        self._items: dict[int, frozenset[Any]] = {}
        self._having: dict[Any, list[int]] = {}
        self._expressions: dict[Expr, Value] = {}
        self._node(Leaf(sympy.S.One), DIGITS.one, True)

    # --- arithmetic -------------------------------------------------------------------------------

    def number(self, value: Value) -> Any:
        """The number of a value at the point at which the graph is compared."""
        c, k = value
        return self.numbers[k] if c == 1 else DIGITS.convert(c) * self.numbers[k]

    def total(self, values: Iterable[Value]) -> Value:
        """The sum of values, in one node at most."""
        collected: dict[int, Number] = {}
        for c, k in self._flat(values):
            collected[k] = collected.get(k, 0) + c
        terms = sorted((k, c) for k, c in collected.items() if c != 0)
        if not terms:
            return ZERO
        k, scale = terms[0]
        if len(terms) == 1:
            return scale, k
        if all(abs(c) == abs(scale) for _, c in terms):
            items = [(1 if c == scale else -1, k) for k, c in terms]
        else:
            scale = _sign(scale)
            items = [(c * scale, k) for k, c in terms]
        numbers = [self.number(item) for item in items]
        number = sum(numbers)
        analytic = all(self._analytic[k] for _, k in items)
        if analytic and abs(number) < DIGITS.ldexp(max(map(abs, numbers)), -SAME):
            return ZERO
        grouped = self._grouped(SumNode, items, lambda k: (1, k))
        return self._times(scale, self._node(SumNode(grouped), number, analytic, frozenset(items)))

    def _flat(self, values: Iterable[Value]) -> Iterator[Value]:
        for c, k in values:
            if c == 1 and self._items[k] and isinstance(self.nodes[k], SumNode):
                yield from self._items[k]
            elif c != 0:
                yield c, k

    def difference(self, value: Value, other: Value) -> Value:
        """The first value minus the second."""
        return self.total([value, self._times(-1, other)])

    def product(self, values: Iterable[Value], below: Iterable[Value] = ()) -> Value:
        """The product of some, divided by the product of others."""
        scale: Number = 1
        powers: dict[Value, Number] = {}
        for group, sign in ((values, 1), (below, -1)):
            for c, k in group:
                scale *= c if sign > 0 else _reciprocal(c)
                for base, exponent in self._factors(k):
                    powers[base] = powers.get(base, 0) + sign * exponent
        if scale == 0:
            return ZERO
        over = sorted(self._power(base, e) for base, e in powers.items() if e > 0)
        under = sorted(self._power(base, -e) for base, e in powers.items() if e < 0)
        if not under and len(over) < 2:
            return scale, (over or [0])[0]
        number = DIGITS.one
        for k in over:
            number *= self.numbers[k]
        for k in under:
            number /= self.numbers[k]
        items = frozenset(over) if not under else frozenset()
        analytic = all(self._analytic[k] for k in (*over, *under))
        node = ProductNode(
            *(self._grouped(ProductNode, group, lambda k: k) for group in (over, under))
        )
        return self._times(scale, self._node(node, number, analytic, items))

    def whole(self, value: Value) -> Value:
        """The value with its number in it, so that it is not multiplied each time; its sign apart.

        What is found again and again is this then, and not what it is the multiple of.
        """
        c, k = value
        if abs(c) == 1 or k == 0 or c == 0:
            return value
        size = abs(c)
        node = SumNode(((size, k),))
        whole = self._node(node, self.number((size, k)), self._analytic[k])
        return self._times(_sign(c), whole)

    def power(self, base: Value, exponent: Number) -> Value:
        """base**exponent, for a number as exponent."""
        if isinstance(exponent, int):
            c = base[0] if exponent > 0 else _reciprocal(base[0])
            scale = c ** abs(exponent)
            powers = [(b, e * exponent) for b, e in self._factors(base[1])]
            up, down = (
                [(b, e) for b, e in powers if bool(e > 0) is over] for over in (True, False)
            )
            return self._times(
                scale,
                self.product(
                    [(1, self._power(b, e)) for b, e in up],
                    [(1, self._power(b, -e)) for b, e in down],
                ),
            )
        if exponent < 0:
            return self.product([], [(1, self._power(base, -exponent))])
        return 1, self._power(base, exponent)

    def call(self, function: Any, arguments: Sequence[Value]) -> Value:
        """A function of some arguments; what is odd or even in a sign is left to SymPy."""
        numbers = [self.number(x) for x in arguments]
        analytic = function in ANALYTIC and all(self._analytic[k] for _, k in arguments)
        if function in ANALYTIC:
            number = getattr(DIGITS, function.__name__)(*numbers)
        else:
            number = number_of(function(*map(decimal, numbers)))
        return self._node(CallNode(function, tuple(arguments)), number, analytic)

    def _factors(self, k: int) -> Iterator[tuple[Value, Number]]:
        node = self.nodes[k]
        if isinstance(node, PowerNode):
            yield node.base, node.exponent
        elif isinstance(node, ProductNode) and not (node.above and node.below):
            for sign, group in ((1, node.above), (-1, node.below)):
                for each in group:
                    yield from ((base, sign * e) for base, e in self._factors(each))
        elif k != 0:
            yield (1, k), 1

    def _power(self, base: Value, exponent: Number) -> int:
        if exponent == 1 and base[0] == 1:
            return base[1]
        number = DIGITS.power(self.number(base), DIGITS.convert(exponent))
        if not isinstance(number, DIGITS.mpf):
            raise NotRealError(f"a power with the exponent {exponent}")
        analytic = isinstance(exponent, int) and self._analytic[base[1]]
        return self._node(PowerNode(base, exponent), number, analytic, signed=False)[1]

    def _times(self, scale: Number, value: Value) -> Value:
        return (scale * value[0], value[1]) if scale != 0 else ZERO

    def _grouped(self, kind: type, items: Sequence[Any], single: Callable[[int], Any]) -> Any:
        """The items, with sums or products that are known in the place of their own items."""
        rest, parts = frozenset(items), []
        while len(rest) > 1:
            counts: dict[int, int] = {}
            for item in rest:
                for k in self._having.get((kind, item), ()):
                    counts[k] = counts.get(k, 0) + 1
            fitting = [k for k, n in counts.items() if n == len(self._items[k])]
            if not fitting:
                break
            best = max(fitting, key=lambda k: (len(self._items[k]), -k))
            parts.append(single(best))
            rest -= self._items[best]
        return tuple(sorted([*rest, *parts]))

    def _node(
        self,
        node: Node,
        number: Any,
        analytic: bool,
        items: frozenset[Any] = frozenset(),
        signed: bool = True,
    ) -> Value:
        """The place of a node, or of what is equal to it."""
        place = self._places.get(node)
        if place is not None:
            return place
        size = mpmath.libmp.mpf_abs(number._mpf_, SAME, "n") if analytic else None
        sign = -1 if analytic and number < 0 else 1
        if analytic and size in self._equals and (signed or self._equals[size][0] == sign):
            c, k = self._equals[size]
            value = (sign * c, k)
        else:
            value = (1, len(self.nodes))
            self.nodes.append(node)
            self.numbers.append(number)
            self._analytic.append(analytic)
            if analytic:
                self._equals.setdefault(size, (sign, value[1]))
            self._items[value[1]] = items
            for item in items:
                having = self._having.setdefault((type(node), item), [])
                if len(having) < CANDIDATES:
                    having.append(value[1])
        self._places[node] = value
        return value

    # --- from SymPy, and derivatives --------------------------------------------------------------

    def expression(self, expression: Expr) -> Value:
        """A SymPy expression, each part of it walked once."""
        value = self._expressions.get(expression)
        if value is None:
            value = self._expressions[expression] = self._walked(expression)
        return value

    def _walked(self, expression: Expr) -> Value:
        if expression.is_Rational or expression.is_Float:
            return (_quick(expression), 0) if expression != 0 else ZERO
        if expression.is_Add:
            return self.total(map(self.expression, expression.args))
        if expression.is_Mul:
            return self.product(map(self.expression, expression.args))
        if expression.is_Pow and (expression.exp.is_Rational or expression.exp.is_Float):
            return self.power(self.expression(expression.base), _quick(expression.exp))
        if _is_called(expression):
            return self.call(expression.func, [self.expression(x) for x in expression.args])
        number = self.point.get(expression)
        if number is None and isinstance(expression, OWN):
            number = generic(SPARE + len(self.nodes))
        value = number_of(expression.xreplace(self.point) if number is None else number)
        return self._node(Leaf(expression), value, number is not None or expression.is_number)

    def derivative(self, value: Value, along: Direction) -> Value:
        """The rate of a value where letters have the rates of a direction."""
        for k in self.below([value], along.known):
            along.known[k] = self._rate(k, along)
        return self._times(value[0], along.known[value[1]])

    def _rate(self, k: int, along: Direction) -> Value:
        node, rate_of = self.nodes[k], along.known
        if isinstance(node, SumNode):
            return self.total(self._times(c, rate_of[j]) for c, j in node.terms)
        if isinstance(node, ProductNode):
            return self.total(self._of_product(k, node, rate_of))
        if isinstance(node, PowerNode):
            rate = self._times(node.base[0], rate_of[node.base[1]])
            if rate == ZERO:
                return ZERO
            slope = self.power(node.base, node.exponent - 1)
            return self._times(node.exponent, self.product([slope, rate]))
        if isinstance(node, CallNode):
            rates = [self._times(c, rate_of[j]) for c, j in node.arguments]
            return self.total(
                self.product([self._slope(node, i), rate])
                for i, rate in enumerate(rates)
                if rate != ZERO
            )
        if node.expression in along.rates:
            return along.rates[node.expression]
        if node.expression.is_Symbol or node.expression.is_number:
            return ZERO
        moved = node.expression.free_symbols & along.rates.keys()
        return self.total(
            self.product([self.expression(node.expression.diff(x)), along.rates[x]])
            for x in sorted(moved, key=str)
        )

    def _of_product(self, k: int, node: ProductNode, rates: Mapping[int, Value]) -> Iterator[Value]:
        for i, j in enumerate(node.above):
            if rates[j] != ZERO:
                others = [(1, x) for x in (*node.above[:i], *node.above[i + 1 :])]
                yield self.product([*others, rates[j]], [(1, x) for x in node.below])
        for j in node.below:
            if rates[j] != ZERO:
                share = self.product([(1, k), rates[j]], [(1, j)])
                yield self._times(-1, share)

    def _slope(self, node: CallNode, i: int) -> Value:
        """The derivative of a called function by its argument i: ∂f/∂xᵢ."""
        slopes = _slopes(node.function, len(node.arguments))
        assert slopes is not None  # or else it would be a leaf
        letters, derivatives = slopes
        return self._put(derivatives[i], dict(zip(letters, node.arguments, strict=True)))

    def _put(self, expression: Expr, own: Mapping[Expr, Value]) -> Value:
        """An expression in letters that stand for values."""
        if expression in own:
            return own[expression]
        if expression.is_Rational or expression.is_Float:
            return self.expression(expression)
        parts = [self._put(x, own) for x in expression.args]
        if expression.is_Add:
            return self.total(parts)
        if expression.is_Mul:
            return self.product(parts)
        if expression.is_Pow and expression.exp.is_Rational:
            return self.power(parts[0], _quick(expression.exp))
        return self.call(expression.func, parts)

    # --- out --------------------------------------------------------------------------------------

    def below(self, values: Iterable[Value], done: Mapping[int, Any] | None = None) -> list[int]:
        """The nodes of which values are made, each behind its own; without what is done."""
        reached, left = set(), [k for _, k in values]
        done = done or {}
        while left:
            k = left.pop()
            if k not in reached and k not in done:
                reached.add(k)
                left += parts(self.nodes[k])
        return sorted(reached)


def _quick(number: Expr) -> Number:
    """A number of SymPy as one of Python, which loses nothing."""
    if number.is_Integer:
        return int(number)
    exact = sympy.Rational(number)
    if number.is_Float and sympy.Rational(float(number)) == exact:
        return float(number)
    return Fraction(exact.p, exact.q)


def _sign(number: Number) -> int:
    return 1 if number > 0 else -1


def _reciprocal(number: Number) -> Number:
    if isinstance(number, int):
        return number if abs(number) == 1 else Fraction(1, number)
    return 1 / number


def _is_called(expression: Expr) -> bool:
    """Whether an expression is a function of values, whose slopes are such too."""
    if isinstance(expression, (*OWN, sympy.Piecewise, sympy.Max, sympy.Min)) or not expression.args:
        return False
    is_function = expression.is_Pow or expression.is_Function
    return bool(is_function and _slopes(expression.func, len(expression.args)))


@lru_cache(maxsize=256)
def _slopes(function: Any, count: int) -> tuple[tuple[Dummy, ...], tuple[Expr, ...]] | None:
    """The slopes of a function, with letters for its arguments; nothing if SymPy has none."""
    letters = tuple(Dummy(real=True) for _ in range(count))
    derivatives = tuple(function(*letters).diff(x) for x in letters)
    return None if any(x.has(*OWN) for x in derivatives) else (letters, derivatives)


def somewhere(expressions: Iterable[Expr], build: Callable[[Graph], Made]) -> Made:
    """What is built on a graph whose letters have numbers at which all of it is real.

    Raises RigidtopError where there are none.
    """
    expressions = list(expressions)
    letters = set().union(*(e.free_symbols for e in expressions))
    letters |= set().union(*(e.atoms(*OWN) for e in expressions))
    for point in points(sorted(letters, key=str)):
        with suppress(NotRealError, ZeroDivisionError):
            return build(Graph(point))
    raise RigidtopError(
        "no masses and forces in real numbers come of L, at none of the points that were tried"
    )
