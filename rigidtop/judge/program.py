"""Expressions of SymPy evaluated at many points at once, with slopes and the size of their terms.

Each part is worked out once, whichever expressions it occurs in.  No text is compiled or run.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Any

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr, Symbol

Array = NDArray[Any]

Part = tuple[Array, NDArray[np.float64], Array | None]
"""The value of a part at each point, the size of its terms, and its slopes; None for no slope."""

_FUNCTIONS: dict[type, tuple[Callable[[Array], Array], Callable[[Array, Array], Array]]] = {
    sympy.sin: (np.sin, lambda x, y: np.cos(x)),
    sympy.cos: (np.cos, lambda x, y: -np.sin(x)),
    sympy.tan: (np.tan, lambda x, y: 1 + y * y),
    sympy.cot: (lambda x: 1 / np.tan(x), lambda x, y: -1 - y * y),
    sympy.sec: (lambda x: 1 / np.cos(x), lambda x, y: y * np.tan(x)),
    sympy.csc: (lambda x: 1 / np.sin(x), lambda x, y: -y / np.tan(x)),
    sympy.exp: (np.exp, lambda x, y: y),
    sympy.log: (np.log, lambda x, y: 1 / x),
    sympy.sinh: (np.sinh, lambda x, y: np.cosh(x)),
    sympy.cosh: (np.cosh, lambda x, y: np.sinh(x)),
    sympy.tanh: (np.tanh, lambda x, y: 1 - y * y),
    sympy.coth: (lambda x: 1 / np.tanh(x), lambda x, y: 1 - y * y),
    sympy.asin: (np.arcsin, lambda x, y: 1 / np.sqrt(1 - x * x)),
    sympy.acos: (np.arccos, lambda x, y: -1 / np.sqrt(1 - x * x)),
    sympy.atan: (np.arctan, lambda x, y: 1 / (1 + x * x)),
    sympy.asinh: (np.arcsinh, lambda x, y: 1 / np.sqrt(1 + x * x)),
    sympy.acosh: (np.arccosh, lambda x, y: 1 / np.sqrt(x * x - 1)),
    sympy.atanh: (np.arctanh, lambda x, y: 1 / (1 - x * x)),
    sympy.Abs: (lambda x: np.abs(x) + 0j, lambda x, y: np.sign(x.real) + 0j),
    sympy.sign: (lambda x: np.sign(x.real) + 0j, lambda x, y: np.zeros_like(x)),
    sympy.re: (lambda x: x.real + 0j, lambda x, y: np.ones_like(x)),
    sympy.im: (lambda x: x.imag + 0j, lambda x, y: np.zeros_like(x)),
    sympy.conjugate: (np.conj, lambda x, y: np.ones_like(x)),
}
"""Functions with their slopes, which are given the place and the value there."""


class UnknownFunctionError(Exception):
    """There are no numbers for a function."""


@dataclass(frozen=True)
class Values:
    """Values of expressions (one a row) at points (one a column), slopes and sizes of terms.

    `slopes` has the letters in between: (expressions, letters, points).
    """

    values: Array
    sizes: NDArray[np.float64]
    slopes: Array


@dataclass
class Program:
    """What evaluates expressions in some letters at `points`: (letters, points)."""

    letters: Sequence[Symbol]
    points: Array
    with_slopes: bool = False
    _known: dict[Expr, Part] = field(default_factory=dict)

    def __post_init__(self) -> None:
        count, points = self.points.shape
        self._at = {x: k for k, x in enumerate(self.letters)}
        self._zero = np.zeros((count if self.with_slopes else 0, points), complex)
        self._sizes = np.abs(self.points)

    def values(self, expressions: Sequence[Expr]) -> Values:
        """Raises UnknownFunctionError."""
        with np.errstate(all="ignore"):
            return self._in_rows([self._of(sympy.sympify(each)) for each in expressions])

    def followed(self, steps: Steps) -> Values:
        """The same of expressions that are evaluated again and again; nothing is looked up."""
        parts: list[Part] = []
        with np.errstate(all="ignore"):
            for node, places in steps.steps:
                parts.append(self._worked_out(node, [parts[k] for k in places]))
        return self._in_rows([parts[k] for k in steps.ends])

    def _in_rows(self, rows: Sequence[Part]) -> Values:
        shape = (len(rows), self.points.shape[1])
        slopes = [self._zero if row[2] is None else row[2] for row in rows]
        return Values(
            np.array([row[0] for row in rows], complex).reshape(shape),
            np.array([row[1] for row in rows], float).reshape(shape),
            np.array(slopes, complex).reshape(len(rows), *self._zero.shape),
        )

    def _of(self, node: Expr) -> Part:
        part = self._known.get(node)
        if part is None:
            below = [self._of(arg) for arg in node.args]
            part = self._known[node] = self._worked_out(node, below)
        return part

    def _worked_out(self, node: Expr, below: Sequence[Part]) -> Part:
        """The part that a node is; `below` are those of its arguments."""
        points = self.points.shape[1]
        if node.is_Symbol:
            k = self._at[node]
            slope = None
            if self.with_slopes:
                slope = self._zero.copy()
                slope[k] = 1
            return self.points[k], self._sizes[k], slope
        if not node.args:
            value = np.full(points, _number(node))
            return value, np.abs(value), None
        if node.is_Add:
            value, size, slope = below[0]
            for other, larger, steeper in below[1:]:
                value, size, slope = value + other, size + larger, _sum(slope, steeper)
            return value, size, slope
        if node.is_Mul:
            value, size, slope = below[0]
            for other, larger, steeper in below[1:]:
                slope = _sum(_times(slope, other), _times(steeper, value))
                value, size = value * other, size * larger
            return value, size, slope
        if node.is_Pow:
            return self._square(below[0]) if node.exp is _TWO else self._power(*below)
        known = _FUNCTIONS.get(node.func)
        if known is None or len(below) != 1:
            raise UnknownFunctionError(f"{node.func} has no numbers")
        function, derivative = known
        at, inner, slope = below[0]
        value = function(at)
        steep = derivative(at, value)
        return value, np.abs(value) + np.abs(steep) * inner * 1e-3, _times(slope, steep)

    def _square(self, base: Part) -> Part:
        x, size, slope = base
        return x * x, size * size, _times(slope, 2 * x)

    def _power(self, base: Part, exponent: Part) -> Part:
        x, size, slope = base
        n, _, steep = exponent
        value = x**n
        grown = None if slope is None else slope * (n * x ** (n - 1))
        if steep is not None and steep.any():
            grown = _sum(grown, steep * (value * np.log(x)))
        # The size of a power is that of a product; that of a root or a reciprocal is its own.
        whole = np.all(n.imag == 0) and np.all(n.real >= 1)
        return value, np.where(whole, size**n.real, np.abs(value)), grown


class Steps:
    """The parts of expressions in the order in which they are worked out, each one once.

    Each of the `steps` has the places of its arguments; `ends` are those of the expressions.
    """

    def __init__(self, expressions: Sequence[Expr]) -> None:
        self.steps: list[tuple[Expr, tuple[int, ...]]] = []
        self._places: dict[Expr, int] = {}
        self.ends = [self._place(sympy.sympify(each)) for each in expressions]

    def _place(self, node: Expr) -> int:
        place = self._places.get(node)
        if place is None:
            places = tuple(self._place(arg) for arg in node.args)
            place = self._places[node] = len(self.steps)
            self.steps.append((node, places))
        return place


_TWO = sympy.Integer(2)


@lru_cache(maxsize=20_000)
def _number(node: Expr) -> complex:
    return complex(node)


def _sum(one: Array | None, other: Array | None) -> Array | None:
    if one is None:
        return other
    return one if other is None else one + other


def _times(slope: Array | None, factor: Array) -> Array | None:
    return None if slope is None else slope * factor
