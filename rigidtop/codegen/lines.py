"""A program in lines: values, each in terms of those before it, and how a graph becomes one."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from heapq import heapify, heappop, heappush
from itertools import combinations, count
from typing import Any

import sympy
from sympy import Expr, Symbol

from rigidtop.codegen.graph import OWN, Graph
from rigidtop.codegen.nodes import (
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

MOST_TERMS = 64
"""Terms of a sum on one line: Python's own compiler fails at sums of thousands."""


@dataclass(frozen=True)
class StraightLine:
    """Values that are computed one after the other, and the results in terms of them."""

    shared: tuple[tuple[Symbol, Expr], ...]
    results: tuple[Expr, ...]

    @cached_property
    def operations(self) -> int:
        """Sums, products, powers, signs and calls."""
        return int(sympy.count_ops([*(value for _, value in self.shared), *self.results]))

    def written_out(self, at: Mapping[Expr, Expr] | None = None) -> tuple[Expr, ...]:
        """The results with everything put in, and values for letters where they are given."""
        values: dict[Expr, Expr] = dict(at or {})

        def put(value: Expr) -> Expr:
            # A place put into an unknown function's slope leaves the slope at that place.
            return value.subs(values) if at and value.has(*OWN) else value.xreplace(values)

        for name, value in self.shared:
            values[name] = put(value)
        return tuple(map(put, self.results))


def straight_line(graph: Graph, values: Sequence[Value], names: Iterator[Symbol]) -> StraightLine:
    """The values as a program: what is used twice has a line; `names` are free letters."""
    nodes = {k: graph.nodes[k] for k in graph.below(values)}
    _with_numbers(nodes, values)
    for kind in (SumNode, ProductNode):
        _pair(nodes, kind)
    order = _in_order(nodes, [k for _, k in values])
    uses: dict[int, int] = {}
    for k in (*(k for _, k in values), *(j for i in order for j in parts(nodes[i]))):
        uses[k] = uses.get(k, 0) + 1
    written = _Written(_turned(nodes, values))
    lines = []
    for k in order:
        expression = written.node(k, nodes[k])
        if uses[k] > 1 and not expression.is_Atom:
            name = next(names)
            lines.append((name, expression))
            expression = name
        written.known[k] = expression
    return StraightLine(tuple(lines), tuple(map(written.value, values)))


def _in_order(nodes: Mapping[int, Node], wanted: Sequence[int]) -> list[int]:
    """The nodes that are wanted and all their parts, each behind its parts."""
    ordered: dict[int, None] = {}
    left = list(reversed(wanted))
    while left:
        k = left[-1]
        missing = [j for j in parts(nodes[k]) if j not in ordered]
        left += reversed(missing)
        if not missing:
            ordered[left.pop()] = None
    return list(ordered)


def _with_numbers(nodes: dict[int, Node], values: Sequence[Value]) -> None:
    """Numbers before the terms of sums become factors, which several may have in common."""
    uses = Counter(j for node in nodes.values() for j in parts(node))
    uses.update(k for _, k in values)  # one that is wanted itself stays as it is
    own: dict[Any, int] = {}
    free = count(max(nodes) + 1)

    def put(key: Any, node: Node) -> int:
        if key not in own:
            own[key] = next(free)
            nodes[own[key]] = node
        return own[key]

    def term(c: Number, j: int) -> Value:
        size, node = abs(c), nodes[j]
        if size == 1 or j == 0:
            return c, j
        number = put(size, Leaf(sympy.sympify(size)))
        if isinstance(node, ProductNode) and uses[j] == 1:
            nodes[j] = ProductNode((number, *node.above), node.below)
            return (1 if c > 0 else -1), j
        return (1 if c > 0 else -1), put((size, j), ProductNode((number, j), ()))

    for k, node in list(nodes.items()):
        if isinstance(node, SumNode):
            nodes[k] = SumNode(tuple(term(c, j) for c, j in node.terms))


def _pair(nodes: dict[int, Node], kind: type[SumNode] | type[ProductNode]) -> None:
    """Two terms, or two factors, that several nodes have become a node of their own."""
    free = count(max(nodes) + 1)
    items: dict[int, set[Any]] = {
        k: set(node[0])
        for k, node in nodes.items()
        if isinstance(node, kind) and len(node[0]) <= MOST_TERMS
    }
    having: dict[tuple[Any, Any], set[int]] = {}
    for k, own in items.items():
        for pair in combinations(sorted(own), 2):
            having.setdefault(pair, set()).add(k)
    queue = [(-len(group), pair) for pair, group in having.items() if len(group) > 1]
    heapify(queue)
    while queue:
        rank, pair = heappop(queue)
        group = sorted(k for k in having[pair] if items[k].issuperset(pair))
        if len(group) < -rank:  # others have taken some of it
            if len(group) > 1:
                heappush(queue, (-len(group), pair))
            continue
        whole = next((k for k in group if len(items[k]) == 2 and not any(nodes[k][1:])), None)
        place = next(free) if whole is None else whole
        single = place if kind is ProductNode else (1, place)
        nodes[place] = ProductNode(pair, ()) if kind is ProductNode else SumNode(pair)
        fresh = set()
        for k in group:
            if k != place:
                items[k].difference_update(pair)
                for other in items[k]:
                    couple = tuple(sorted((other, single)))
                    having.setdefault(couple, set()).add(k)
                    fresh.add(couple)
                items[k].add(single)
        for couple in sorted(fresh):
            if len(having[couple]) > 1:
                heappush(queue, (-len(having[couple]), couple))
    for k, own in items.items():
        nodes[k] = _of(tuple(sorted(own)), nodes[k])


def _of(items: tuple[Any, ...], like: Node) -> Node:
    """A sum, or a product with the denominators of another, of items."""
    return ProductNode(items, like.below) if isinstance(like, ProductNode) else SumNode(items)


def _turned(nodes: Mapping[int, Node], values: Sequence[Value]) -> frozenset[int]:
    """The sums that are written with the other sign, which spares a result one."""
    turned = set()
    for c, k in values:
        node = nodes[k]
        while isinstance(node, ProductNode):
            inner = (j for j in node.above if isinstance(nodes[j], (SumNode, ProductNode)))
            k = next(inner, node.above[0] if node.above else node.below[0])
            node = nodes[k]
        if c < 0 and isinstance(node, SumNode) and any(c < 0 for c, _ in node.terms):
            turned.add(k)
    return frozenset(turned)


@dataclass(frozen=True)
class _Written:
    """Nodes as expressions of SymPy, with those before them by name; some with the other sign."""

    turned: frozenset[int]
    known: dict[int, Expr] = field(default_factory=dict)
    signs: dict[int, int] = field(default_factory=dict)

    def value(self, value: Value) -> Expr:
        """A number times a node, not multiplied out."""
        c, k = value
        return _multiple(c * self.signs[k], self.known[k])

    def node(self, k: int, node: Node) -> Expr:
        """A node by its parts; its sign besides."""
        self.signs[k] = 1
        if isinstance(node, SumNode):
            signs = {c * self.signs[j] > 0 for c, j in node.terms}
            if k in self.turned or signs == {False}:
                self.signs[k] = -1
            terms = [(c * self.signs[k], j) for c, j in node.terms]
            terms.sort(key=lambda term: term[0] * self.signs[term[1]] < 0)  # no sign in front
            return _as_it_stands(sympy.Add, map(self.value, terms))
        if isinstance(node, ProductNode):
            for j in (*node.above, *node.below):
                self.signs[k] *= self.signs[j]
            below = [1 / self.known[j] for j in node.below]
            return _as_it_stands(sympy.Mul, [*(self.known[j] for j in node.above), *below])
        if isinstance(node, PowerNode):
            return self.value(node.base) ** sympy.sympify(node.exponent)
        if isinstance(node, CallNode):
            return node.function(*map(self.value, node.arguments))
        return node.expression


def _multiple(c: Number, x: Expr) -> Expr:
    """A number times an expression, not multiplied out."""
    if c == 1:
        return x
    if c == -1 and x.is_Add:
        return -x
    return _as_it_stands(sympy.Mul, (sympy.sympify(c), x))


def _as_it_stands(kind: Any, parts: Iterable[Expr]) -> Expr:
    """A sum or a product of parts that the graph has made different: SymPy sorts none of them."""
    numbers: list[Expr] = []
    rest: list[Expr] = []
    for part in parts:
        for x in part.args if isinstance(part, kind) else (part,):
            (numbers if x.is_Number else rest).append(x)
    number = kind(*numbers)
    return kind._from_args(rest if number == kind.identity else [number, *rest])


def in_pieces(
    lines: Sequence[tuple[Symbol, Expr]], results: Sequence[Expr], names: Iterator[Symbol]
) -> tuple[list[tuple[Symbol, Expr]], list[Expr]]:
    """The same with sums and products of very many terms in several lines; `names` are free.

    >>> a = sympy.symbols("a:200")
    >>> lines, [total] = in_pieces([], [sympy.Add(*a)], sympy.numbered_symbols("x"))
    >>> len(lines), total
    (4, x0 + x1 + x2 + x3)
    """
    assignments: list[tuple[Symbol, Expr]] = []

    def is_long(value: Expr) -> bool:
        return len(value.args) > MOST_TERMS and (value.is_Add or value.is_Mul)

    def split(value: Expr) -> Expr:
        args = value.args
        while len(args) > MOST_TERMS:
            groups = [args[k : k + MOST_TERMS] for k in range(0, len(args), MOST_TERMS)]
            pieces = [(next(names), value.func(*group)) for group in groups]
            assignments.extend(pieces)
            args = tuple(name for name, _ in pieces)
        return value.func(*args)

    def broken(value: Expr) -> Expr:
        if any(map(is_long, sympy.preorder_traversal(value))):
            return value.replace(is_long, split)
        return value

    for name, value in lines:
        assignments.append((name, broken(value)))
    return assignments, list(map(broken, results))
