"""Statements of any component: L̇ₖ = −(ω × L)ₖ says three things."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from rigidtop.judge.sides import letters_in
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement

_ANY, _EACH = frozenset("ijk"), "123"


def each_component(statement: Statement, known: Collection[Letter]) -> tuple[Statement, ...]:
    """What a statement says of the components 1, 2, 3; itself alone if it speaks of none.

    A letter with an index k is one of them if those with 1, 2 and 3 are `known`.
    """
    nodes = [x for side in statement.sides for x in n.walked(side)]
    if any(isinstance(x, n.Total) for x in nodes):
        return (statement,)  # its index counts
    names = {x for x in letters_in(statement) if x.sub in _ANY and not x.bold}
    taken = {x.index for x in nodes if isinstance(x, n.Component) and x.index in _ANY}
    indices = {x.sub for x in names} | taken
    are_known = all(replace(x, sub=each) in known for x in names for each in _EACH)
    if len(indices) != 1 or not (names or taken) or not are_known:
        return (statement,)
    [index] = indices
    return tuple(_with(statement, index, each) for each in _EACH)


def _with(statement: Statement, index: str, component: str) -> Statement:
    """A statement with a number in place of an index."""

    def change(node: Node) -> Node:
        if isinstance(node, Letter) and node.sub == index:
            return replace(node, sub=component)
        if isinstance(node, n.Component) and node.index == index:
            return replace(node, index=component)
        return node

    return replace(statement, sides=tuple(n.mapped(side, change) for side in statement.sides))
