"""The nodes of a graph of expressions: sums, products, powers, calls and leaves."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from sympy import Expr

Number = Any
"""An integer or a fraction of Python, which are quick, or a decimal number of SymPy."""

Value = tuple[Number, int]
"""A number times a node."""


class Sum(NamedTuple):
    """Numbers times nodes, added."""

    terms: tuple[Value, ...]


class Product(NamedTuple):
    """Nodes multiplied, and those by which that is divided."""

    above: tuple[int, ...]
    below: tuple[int, ...]


class Power(NamedTuple):
    """A value to the power of a number that is positive and not 1."""

    base: Value
    exponent: Number


class Call(NamedTuple):
    """A function of SymPy, and values that it is of."""

    function: Any
    arguments: tuple[Value, ...]


class Leaf(NamedTuple):
    """A letter, or what is differentiated and printed by SymPy as it stands."""

    expression: Expr


Node = Sum | Product | Power | Call | Leaf

ZERO: Value = (0, 0)
ONE: Value = (1, 0)
MINUS: Value = (-1, 0)
HALF: Value = (Fraction(1, 2), 0)


def parts(node: Node) -> list[int]:
    """The nodes of which a node is made."""
    if isinstance(node, Sum):
        return [k for _, k in node.terms]
    if isinstance(node, Product):
        return [*node.above, *node.below]
    if isinstance(node, Power):
        return [node.base[1]]
    if isinstance(node, Call):
        return [k for _, k in node.arguments]
    return []
