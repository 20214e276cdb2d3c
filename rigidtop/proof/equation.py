"""Equations as they are printed, and what they say.

A printed equation keeps the order, the brackets and the underbraces of the page, which SymPy
would rearrange.  It is typed inside `as_printed` and stays a tree of unevaluated nodes; `value`
says what it means once each symbol is given a meaning.

>>> from sympy.abc import a, b
>>> with as_printed():
...     law = Equation(a, b + b - a)
>>> law.sides[1].args
(b + b, -a)
>>> value(law.sides[1], {a: 5, b: 3})
1
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from contextlib import AbstractContextManager
from dataclasses import dataclass
from functools import cached_property
from operator import add, mul
from typing import Any, TypeAlias

import sympy
from sympy import Add, Expr, MatrixBase, Mul, Symbol


def as_printed() -> AbstractContextManager[None]:
    """Inside this context SymPy keeps expressions as they are typed."""
    made: AbstractContextManager[None] = sympy.evaluate(False)
    return made


class NoMeaningError(ValueError):
    """An expression that says nothing with the meanings given."""


class Printed(Expr):
    """A node that exists for the page.  `value` replaces it by what it means."""

    is_commutative = True


class Group(Printed):
    """Brackets that the page has although the order of operations does not need them."""


class Underbrace(Printed):
    """``Underbrace(body, label)``: the body, with "≡ label" beneath it."""


class Cross(Printed):
    """``Cross(a, b)``: the vector product a × b."""


class Dot(Printed):
    """``Dot(a, b)``: the scalar product a · b."""


class Transposed(Printed):
    """``Transposed(O)``: Oᵀ."""


class Matrices(Printed):
    """``Matrices(A, B)``: the product of matrices that are written out."""


class Rate(Printed):
    """``Rate(L, frame)``: (∂L/∂t) as seen from the frame; without a frame d/dt of a product."""


class Partial(Printed):
    """``Partial(f, x)``: ∂f/∂x, of a letter f; one thing, into which nothing is put."""


class Slope(Printed):
    """``Slope(u, φ)``: du/dφ along the motion, u̇/φ̇."""


class SumOver(Printed):
    """``SumOver(k, body)``: Σₖ body.  The meaning of k is a sequence of mappings, one a term."""


class VolumeIntegral(Printed):
    """``VolumeIntegral(d3r, body)``: ∫ d³r body.  The meaning of d3r does the integration."""


class IntegralOver(Printed):
    """``IntegralOver(x, a, b, body)``: the integral of body over x from a to b."""


SPACE, BODY = Symbol("space"), Symbol("body")
"""The frames in which a `Rate` is seen."""

Side: TypeAlias = Expr | MatrixBase
"""A SymPy expression or a Matrix of them."""


@dataclass(frozen=True)
class Equation:
    """``Equation(a, b, c, tag="3.49")`` is printed a = b = c with its number behind it.

    `relation` stands between all sides: ``"="``, ``"≡"``, ``"≠"``, ``">"``, ``"<"`` or ``"≈"``;
    where an equation is only printed it may be one for each pair, such as ``"≈ ="``.
    """

    sides: tuple[Side, ...]
    relation: str = "="
    tag: str = ""

    def __init__(self, *sides: Side, relation: str = "=", tag: str = "") -> None:
        if len(sides) < 2:
            raise ValueError("an equation has at least two sides")
        object.__setattr__(self, "sides", tuple(sympy.sympify(side) for side in sides))
        object.__setattr__(self, "relation", relation)
        object.__setattr__(self, "tag", tag)

    @cached_property
    def symbols(self) -> frozenset[Symbol]:
        """The free symbols of all sides."""
        return frozenset().union(*(side.free_symbols for side in self.sides))


Meaning = Mapping[Expr, Side]


def value(node: Side, meaning: Meaning) -> Expr | MatrixBase:
    """What a printed tree says, with every symbol replaced by its meaning.

    `meaning` maps symbols to expressions, to 3×1 matrices (vectors) or to square matrices; the
    index of a sum to a sequence of mappings; the measure of an integral to a function of the
    integrand.  A symbol without a meaning stands for itself.
    """
    if isinstance(node, sympy.MatrixBase):
        return sympy.Matrix(*node.shape, [value(entry, meaning) for entry in node])
    if node in meaning:
        return meaning[node]
    if isinstance(node, Printed):
        return _printed_value(node, meaning)
    if not node.args:
        return node
    parts = [value(argument, meaning) for argument in node.args]
    if isinstance(node, (Add, Mul)) and any(isinstance(x, sympy.MatrixBase) for x in parts):
        return _fold(parts, add if isinstance(node, Add) else mul)
    return node.func(*parts)


def _printed_value(node: Printed, meaning: Meaning) -> Expr | MatrixBase:
    if isinstance(node, (Group, Underbrace)):
        return value(node.args[0], meaning)
    if isinstance(node, SumOver):
        index, body = node.args
        return _fold([value(body, {**meaning, **term}) for term in meaning[index]], add)
    if isinstance(node, VolumeIntegral):
        measure, body = node.args
        return meaning[measure](value(body, meaning))
    if isinstance(node, Rate):
        raise NoMeaningError(f"{node} has no meaning here: give it one")
    operands = [value(argument, meaning) for argument in node.args]
    if isinstance(node, Cross):
        return operands[0].cross(operands[1])
    if isinstance(node, Dot):
        return operands[0].dot(operands[1])
    if isinstance(node, Transposed):
        return operands[0].T
    if isinstance(node, Matrices):
        return _fold(operands, mul)
    raise TypeError(f"no meaning for {type(node).__name__}")


def _fold(parts: list[Expr | MatrixBase], join: Callable[[Any, Any], Any]) -> Expr | MatrixBase:
    total = parts[0]
    for part in parts[1:]:
        total = join(total, part)
    return total


def symbols_of(equation: Equation) -> frozenset[Symbol]:
    """The free symbols of all sides."""
    return equation.symbols
