"""The nodes of a graph of expressions: sums, products, powers, calls and leaves."""

from __future__ import annotations

from fractions import Fraction
from typing import Any, NamedTuple

from sympy import Expr

Number = Any
"""An integer or a fraction of Python, which are quick, or a decimal number of SymPy."""

Value = tuple[Number, int]
"""A number times a node."""


class SumNode(NamedTuple):
    """A sum of nodes, each times a number."""

    terms: tuple[Value, ...]


class ProductNode(NamedTuple):
    """Nodes multiplied, and those by which that is divided."""

    above: tuple[int, ...]
    below: tuple[int, ...]


class PowerNode(NamedTuple):
    """A value to the power of a number that is positive and not 1."""

    base: Value
    exponent: Number


class CallNode(NamedTuple):
    """A function of SymPy with its arguments."""

    function: Any
    arguments: tuple[Value, ...]


class Leaf(NamedTuple):
    """A letter, or what is differentiated and printed by SymPy as it stands."""

    expression: Expr


Node = SumNode | ProductNode | PowerNode | CallNode | Leaf

ZERO: Value = (0, 0)
ONE: Value = (1, 0)
MINUS: Value = (-1, 0)
HALF: Value = (Fraction(1, 2), 0)


def parts(node: Node) -> list[int]:
    """The nodes of which a node is made."""
    if isinstance(node, SumNode):
        return [k for _, k in node.terms]
    if isinstance(node, ProductNode):
        return [*node.above, *node.below]
    if isinstance(node, PowerNode):
        return [node.base[1]]
    if isinstance(node, CallNode):
        return [k for _, k in node.arguments]
    return []
