"""How close a written formula holds together: where brackets have to stand."""

from __future__ import annotations

from typing import Final

from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Node

SUM, TERM, DOT, CROSS, PRODUCT, FACTOR, ATOM = range(7)

_BINDING: Final[dict[type[Node], int]] = {
    n.Sum: SUM,
    n.Negative: SUM,
    n.PlusMinus: SUM,
    n.Total: TERM,
    n.Limit: TERM,
    n.DotProduct: DOT,
    n.CrossProduct: CROSS,
    n.Product: PRODUCT,
    n.Quotient: PRODUCT,
    **dict.fromkeys((n.Integral, n.Nabla, n.Apply, n.TimeDerivative, n.Derivative), FACTOR),
    **dict.fromkeys((n.Differential, n.Power, n.TransposedMatrix, n.Component, n.At), FACTOR),
}


def binding(node: Node) -> int:
    """How close a node holds together; what is not in the table does by itself."""
    return ATOM if is_dotted(node) else _BINDING.get(type(node), ATOM)


def is_dotted(node: Node) -> bool:
    """Whether a rate is written with dots above a letter or brackets."""
    return isinstance(node, n.TimeDerivative) and node.dotted and node.order <= 4 and not node.frame
