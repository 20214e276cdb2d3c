"""Expressions, and matrices of them: their sums and products, and how two of them are compared."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any

import sympy
from sympy import Expr, Float, ImmutableMatrix, Integer, MatrixBase, S, Symbol
from sympy.core.function import AppliedUndef

from rigidtop.judge.jets import TIME, operations, symbols

Value = Any
"""An expression, or a matrix of expressions."""


class UnclearError(Exception):
    """Why a formula has no meaning that could be judged."""


def plain(expressions: Sequence[Expr]) -> list[Expr]:
    """Unknown functions and their slopes as numbers of their own, alike in all expressions."""
    return [_plain(sympy.sympify(x)) for x in expressions]


@lru_cache(maxsize=100_000)
def _plain(expression: Expr) -> Expr:
    """The same; each part of an expression is looked at once."""
    if isinstance(expression, (AppliedUndef, sympy.Derivative, sympy.Subs)):
        return Symbol(f"f({sympy.srepr(expression)})", real=True)
    parts = [_plain(x) for x in expression.args]
    same = all(x is y for x, y in zip(parts, expression.args, strict=True))
    return expression if same else expression.func(*parts)


def pairs(left: Value, right: Value) -> list[tuple[Expr, Expr]]:
    """Both sides, entry by entry.  Raises UnclearError where they are not of one kind."""
    if isinstance(left, MatrixBase) or isinstance(right, MatrixBase):
        if right == 0 and isinstance(left, MatrixBase):
            right = sympy.zeros(*left.shape)
        if left == 0 and isinstance(right, MatrixBase):
            left = sympy.zeros(*right.shape)
        left, right = unit_times(left, right), unit_times(right, left)
        if not (isinstance(left, MatrixBase) and isinstance(right, MatrixBase)):
            raise UnclearError("one side is a number, the other is none")
        if left.shape != right.shape and left.shape == right.shape[::-1]:
            right = right.T
        left, right = in_one_space([left, right])
        if left.shape != right.shape:
            raise UnclearError("the sides have different shapes")
        return list(zip(left, right, strict=True))
    return [(left, right)]


def unit_times(value: Value, other: Value) -> Value:
    """A number as that multiple of the unit matrix that the other side is; 1 × 1 is a number."""
    if isinstance(value, MatrixBase) or not isinstance(other, MatrixBase):
        return value
    rows, columns = other.shape
    return value * sympy.eye(rows) if rows == columns else value


def length(value: Value) -> Expr:
    if isinstance(value, MatrixBase):
        return sympy.sqrt(dotted(value, value))
    return sympy.Abs(value)


def size(value: Value) -> int:
    entries = list(value) if isinstance(value, MatrixBase) else [value]
    return sum(map(operations, entries))


def added(values: Sequence[Value]) -> Value:
    matrices = [x for x in values if isinstance(x, MatrixBase)]
    if not matrices:
        return sympy.Add(*values)
    if any(not isinstance(x, MatrixBase) and x != 0 for x in values):
        raise UnclearError("a sum of a vector and a number")
    matrices = in_one_space(matrices)
    if len({x.shape for x in matrices}) > 1:
        raise UnclearError("a sum of different shapes")
    return ImmutableMatrix(*matrices[0].shape, [sympy.Add(*x) for x in zip(*matrices, strict=True)])


def in_one_space(vectors: Sequence[MatrixBase]) -> list[MatrixBase]:
    """Vectors of a plane as vectors in space, if others are; all as they are otherwise."""
    if {x.shape for x in vectors} != {(2, 1), (3, 1)}:
        return [*vectors]
    return [ImmutableMatrix([*x, *[0] * (3 - x.rows)]) for x in vectors]


def matrix_product(left: MatrixBase, right: MatrixBase) -> Value:
    if left.shape[1] != right.shape[0]:
        raise UnclearError("a product of vectors, or of matrices that do not fit")
    rows, columns = left.tolist(), right.T.tolist()
    entries = [_summed(row, column) for row in rows for column in columns]
    return entries[0] if len(entries) == 1 else ImmutableMatrix(len(rows), len(columns), entries)


def dotted(left: MatrixBase, right: MatrixBase) -> Expr:
    """The scalar product of two vectors of one shape."""
    return _summed([*left], [*right])


def crossed(left: MatrixBase, right: MatrixBase) -> MatrixBase:
    """The vector product of two columns of three components."""
    (a, b, c), (x, y, z) = left, right
    products = (b, z, c, y), (c, x, a, z), (a, y, b, x)
    return ImmutableMatrix([_product(p, q) - _product(r, s) for p, q, r, s in products])


def scaled(value: Value, factor: Expr) -> Value:
    """A number, or each entry of a matrix, times a number."""
    if isinstance(value, MatrixBase):
        return ImmutableMatrix(*value.shape, [_product(x, factor) for x in value])
    return _product(value, factor)


def multiplied(values: Sequence[Value]) -> Value:
    made: Value = Integer(1)
    for value in values:
        if not isinstance(value, MatrixBase):
            made = scaled(made, value)
        elif isinstance(made, MatrixBase):
            made = matrix_product(made, value)
        else:
            made = scaled(value, made)
    return made


def _summed(row: Sequence[Expr], column: Sequence[Expr]) -> Expr:
    """The sum of the products of entries."""
    return sympy.Add(*(_product(x, y) for x, y in zip(row, column, strict=True)))


def _product(one: Expr, other: Expr) -> Expr:
    """The same as `one * other`.

    SymPy finds out about all parts of what is multiplied by zero whether it is finite, which takes
    longer than everything else about vectors.
    """
    if one is S.Zero and not _is_infinite(other):
        return one
    if other is S.Zero and not _is_infinite(one):
        return other
    return one * other


@lru_cache(maxsize=50_000)
def _is_infinite(expression: Expr) -> bool:
    """Whether an infinite number, or none, is written in it."""
    return expression in _INFINITE or any(map(_is_infinite, expression.args))


_INFINITE = frozenset({S.Infinity, S.NegativeInfinity, S.ComplexInfinity, S.NaN})


LARGEST = 4_000
"""No expression has more operations."""


@lru_cache(maxsize=20_000)
def is_identity(expression: Expr) -> bool:
    """Whether an expression with the time in it is zero as it is written."""
    if TIME not in symbols(expression) or expression.atoms(AppliedUndef):
        return False
    if operations(expression) >= LARGEST:
        return False
    return all(_vanishes(expression, k) for k in range(3))


def _vanishes(expression: Expr, trial: int) -> bool:
    """Whether it is zero, to many digits, where its letters have some values."""
    names = sorted(symbols(expression), key=str)
    values = {x: sympy.Rational(37 + 10 * trial + 7 * k, 61) for k, x in enumerate(names)}
    number = expression.xreplace(values).evalf(_DIGITS, maxn=2 * _DIGITS)
    nothing = _ROUNDING if expression.has(Float) else 10.0 ** (8 - _DIGITS)
    return bool(number.is_number and abs(number) < nothing)


_DIGITS = 25
_ROUNDING = 1e-11
"""What is left of an identity between numbers of floating point, as those of a quadrature are."""
