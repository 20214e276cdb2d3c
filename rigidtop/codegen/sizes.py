"""How large the terms of a value are, of which rounding is a small part."""

from __future__ import annotations

from collections.abc import Iterable

import sympy

from rigidtop.codegen.graph import Graph
from rigidtop.codegen.nodes import ONE, PowerNode, ProductNode, SumNode, Value


def with_sizes(graph: Graph, values: Iterable[Value]) -> list[Value]:
    """Each value, and behind it the sum of the magnitudes of its terms, as it stands.

    >>> from rigidtop.codegen.lines import straight_line
    >>> from rigidtop.codegen.points import points
    >>> x, y = sympy.symbols("x y")
    >>> graph = Graph(next(points([x, y])))
    >>> value = graph.expression((x - y)**2 * sympy.cos(x - y))
    >>> straight_line(graph, with_sizes(graph, [value]), sympy.numbered_symbols("t")).results
    (t0**2*t1, (Abs(x) + Abs(y))**2*Abs(t1))
    """
    values = list(values)
    sizes: dict[int, Value] = {}
    for k in graph.below(values):
        sizes[k] = _size(graph, k, sizes)
    return [x for c, k in values for x in ((c, k), graph.product([(abs(c), 0), sizes[k]]))]


def _size(graph: Graph, k: int, sizes: dict[int, Value]) -> Value:
    """The size of a node, with those of its parts."""
    node = graph.nodes[k]
    if isinstance(node, SumNode):
        return graph.total((abs(c) * sizes[j][0], sizes[j][1]) for c, j in node.terms)
    if isinstance(node, ProductNode):
        below = [_magnitude(graph, j) for j in node.below]
        return graph.product([sizes[j] for j in node.above], below)
    if isinstance(node, PowerNode) and isinstance(node.exponent, int):
        c, j = sizes[node.base[1]]
        return graph.power((abs(node.base[0]) * c, j), node.exponent)
    return _magnitude(graph, k)


def _magnitude(graph: Graph, k: int) -> Value:
    return ONE if k == 0 else graph.call(sympy.Abs, [(1, k)])
