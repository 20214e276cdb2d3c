"""Expressions of SymPy evaluated at many points at once, with slopes and the size of their terms.

Each part is worked out once, whichever expressions it occurs in.  No text is compiled or run.
A `Program` remembers the parts that it has worked out at its points; `Steps` go from points to
points, with slopes, and take parts of the same kind together.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache, reduce
from itertools import chain, groupby
from typing import Any, NamedTuple

import numpy as np
import sympy
from numpy.typing import NDArray
from sympy import Expr, Symbol

Array = NDArray[Any]

Numbers = tuple[Array, NDArray[np.float64]]
"""Values, and the sizes of their terms."""

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


class Kernel(NamedTuple):
    """How a part comes from its arguments.

    `numbers` takes those of the arguments; `slopes` takes their values and the value of the part,
    and gives the slope by each of them, or None where all are 1.
    """

    numbers: Callable[..., Numbers]
    slopes: Callable[..., Sequence[Array]] | None


def _power(base: Numbers, exponent: Numbers) -> Numbers:
    (x, size), (n, _) = base, exponent
    value = x**n
    # The size of a power is that of a product; that of a root or a reciprocal is its own.
    whole = (n.imag == 0) & (n.real >= 1)
    return value, np.where(whole, size**n.real, np.abs(value))


_SUM = Kernel(lambda x, y: (x[0] + y[0], x[1] + y[1]), None)
_PRODUCT = Kernel(lambda x, y: (x[0] * y[0], x[1] * y[1]), lambda x, y, _: (y, x))
_SQUARE = Kernel(lambda x: (x[0] * x[0], x[1] * x[1]), lambda x, _: (2 * x,))
_POWER = Kernel(_power, lambda x, n, _: (n * x ** (n - 1), np.zeros_like(x)))
_EXPONENTIAL = Kernel(_power, lambda x, n, value: (n * x ** (n - 1), value * np.log(x)))


@lru_cache(maxsize=100)
def _of_function(name: type) -> Kernel:
    if name not in _FUNCTIONS:
        raise UnknownFunctionError(f"{name} has no numbers")
    function, derivative = _FUNCTIONS[name]

    def numbers(argument: Numbers) -> Numbers:
        at, size = argument
        value = function(at)
        return value, np.abs(value) + np.abs(derivative(at, value)) * size * 1e-3

    return Kernel(numbers, lambda at, value: (derivative(at, value),))


def _kernel(node: Expr) -> Kernel:
    """That of a node; sums and products are made of two parts at a time."""
    if node.is_Add:
        return _SUM
    if node.is_Mul:
        return _PRODUCT
    if node.is_Pow:
        if node.exp is _TWO:
            return _SQUARE
        return _EXPONENTIAL if node.exp.free_symbols else _POWER
    if len(node.args) != 1:
        raise UnknownFunctionError(f"{node.func} has no numbers")
    return _of_function(node.func)


_TWO = sympy.Integer(2)


def _arguments(node: Expr) -> tuple[Expr, ...]:
    """The parts that a node comes from."""
    arguments: tuple[Expr, ...] = node.args
    return arguments[:1] if _kernel(node) is _SQUARE else arguments


@lru_cache(maxsize=20_000)
def _number(node: Expr) -> complex:
    return complex(node)


@dataclass(frozen=True)
class Values:
    """Values of expressions (one a row) at points (one a column), and the sizes of their terms."""

    values: Array
    sizes: NDArray[np.float64]


@dataclass(frozen=True)
class Sloped(Values):
    """The same with the slopes by the letters: (expressions, letters, points)."""

    slopes: Array


@dataclass
class Program:
    """What evaluates expressions in some letters at `points`: (letters, points)."""

    letters: Sequence[Symbol]
    points: Array
    _known: dict[Expr, Numbers] = field(default_factory=dict)

    def __post_init__(self) -> None:
        sizes = np.abs(self.points)
        for letter, *numbers in zip(self.letters, self.points, sizes, strict=True):
            self._known[letter] = numbers[0], numbers[1]

    def values(self, expressions: Sequence[Expr]) -> Values:
        """The values of expressions at all points.  Raises UnknownFunctionError."""
        with np.errstate(all="ignore"):
            rows = [self._of(sympy.sympify(each)) for each in expressions]
        shape = (len(rows), self.points.shape[1])
        return Values(
            np.array([value for value, _ in rows], complex).reshape(shape),
            np.array([size for _, size in rows], float).reshape(shape),
        )

    def _of(self, node: Expr) -> Numbers:
        part = self._known.get(node)
        if part is None:
            part = self._known[node] = self._worked_out(node)
        return part

    def _worked_out(self, node: Expr) -> Numbers:
        if not node.args:
            value = np.full(self.points.shape[1], _number(node))
            return value, np.abs(value)
        below = [self._of(each) for each in _arguments(node)]
        kernel = _kernel(node).numbers
        return reduce(kernel, below) if node.is_Add or node.is_Mul else kernel(*below)


class _Parts:
    """What expressions are made of, in the order in which it is worked out, each part once."""

    def __init__(self, letters: Sequence[Symbol]) -> None:
        self.levels = [0] * len(letters)
        self.kernels: list[Kernel | None] = [None] * len(letters)
        self.arguments: list[tuple[int, ...]] = [()] * len(letters)
        self.numbers: list[complex] = []
        self._places: dict[Any, int] = {x: k for k, x in enumerate(letters)}

    def place(self, node: Expr) -> int:
        """The number of the part that a node is."""
        place = self._places.get(node)
        if place is not None:
            return place
        if not node.args:
            self.numbers.append(_number(node))
            place = self._new(0, None, ())
        else:
            kernel, places = _kernel(node), [self.place(each) for each in _arguments(node)]
            joined = self._in_pairs if node.is_Add or node.is_Mul else self._joined
            place = joined(kernel, tuple(places))
        self._places[node] = place
        return place

    def _in_pairs(self, kernel: Kernel, places: tuple[int, ...]) -> int:
        """A sum or a product of parts, by two of them at a time, so that the way to it is short."""
        while len(places) > 1:
            pairs = (places[k : k + 2] for k in range(0, len(places), 2))
            places = tuple(self._joined(kernel, x) if len(x) == 2 else x[0] for x in pairs)
        return places[0]

    def _joined(self, kernel: Kernel, places: tuple[int, ...]) -> int:
        place = self._places.get((kernel, places))
        if place is None:
            place = self._new(1 + max(self.levels[k] for k in places), kernel, places)
            self._places[kernel, places] = place
        return place

    def _new(self, level: int, kernel: Kernel | None, places: tuple[int, ...]) -> int:
        self.levels.append(level)
        self.kernels.append(kernel)
        self.arguments.append(places)
        return len(self.levels) - 1


@dataclass(frozen=True)
class _Batch:
    """Parts of one kind that need nothing of one another, with the rows of their arguments.

    `sloped` are those that have slopes, once for each letter in them; `of` are the rows that these
    slopes come from, a column an argument, where 0 has none.
    """

    kernel: Kernel
    rows: NDArray[np.intp]
    sloped: NDArray[np.intp]
    of: NDArray[np.intp]


class Steps:
    """What evaluates expressions in some letters with their slopes, at any points.

    Raises UnknownFunctionError.
    """

    def __init__(self, expressions: Sequence[Expr], letters: Sequence[Symbol]) -> None:
        parts = _Parts(letters)
        ends = [parts.place(sympy.sympify(each)) for each in expressions]
        count = len(letters)
        kinds = {kernel: k for k, kernel in enumerate(dict.fromkeys(parts.kernels))}
        keys = [*zip(parts.levels, map(kinds.__getitem__, parts.kernels), strict=True)]
        order = sorted(range(len(keys)), key=keys.__getitem__)
        row = {k: place for place, k in enumerate(order)}
        # The letters in each part, with the rows of its slopes by them; the first row has none.
        slopes: dict[int, dict[int, int]] = {k: {k: k + 1} for k in range(count)}
        last = count
        self._batches: list[_Batch] = []
        for (level, _), group in groupby(order, key=keys.__getitem__):
            batch, sloped, of = [*group], [], []
            for k, part in enumerate(batch if level else ()):
                below = [slopes.get(x, {}) for x in parts.arguments[part]]
                slopes[part] = own = {}
                for letter in sorted({*chain.from_iterable(below)}):
                    own[letter] = last = last + 1
                    sloped.append(k)
                    of.append([x.get(letter, 0) for x in below])
            kernel = parts.kernels[batch[0]]
            if kernel is not None:
                rows = np.array([[row[x] for x in parts.arguments[k]] for k in batch], int)
                columns = np.array(of, int).reshape(-1, rows.shape[1])
                self._batches.append(_Batch(kernel, rows.T, np.array(sloped, int), columns.T))
        self._count, self._rows, self._slopes = count, len(order), last + 1
        self._constants = np.array(parts.numbers, complex)
        self._ends = np.array([row[k] for k in ends], int)
        by = [(k, *x) for k, end in enumerate(ends) for x in slopes.get(end, {}).items()]
        self._by = np.array(by, int).reshape(-1, 3).T

    def at(self, points: Array) -> Sloped:
        """What they are at points: (letters, points)."""
        first, count = self._count + len(self._constants), points.shape[1]
        values = np.empty((self._rows, count), complex)
        values[: self._count] = points
        values[self._count : first] = self._constants[:, None]
        sizes = np.abs(values)
        slopes = np.empty((self._slopes, count), complex)
        slopes[0], slopes[1 : self._count + 1] = 0, 1
        row, sloped = first, self._count + 1
        with np.errstate(all="ignore"):
            for batch in self._batches:
                below = [(values[k], sizes[k]) for k in batch.rows]
                here = slice(row, row + len(batch.rows[0]))
                values[here], sizes[here] = batch.kernel.numbers(*below)
                parts = [slopes[k] for k in batch.of]
                if batch.kernel.slopes is not None:
                    factors = batch.kernel.slopes(*(value for value, _ in below), values[here])
                    parts = [x * y[batch.sloped] for x, y in zip(parts, factors, strict=True)]
                slopes[sloped : sloped + len(batch.sloped)] = sum(parts)
                row, sloped = here.stop, sloped + len(batch.sloped)
        by_letter = np.zeros((len(self._ends), self._count, count), complex)
        by_letter[self._by[0], self._by[1]] = slopes[self._by[2]]
        return Sloped(values[self._ends], sizes[self._ends], by_letter)
