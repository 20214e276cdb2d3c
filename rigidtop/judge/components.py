"""Statements of any component, L̇ₖ = −(ω × L)ₖ says three things, and columns along some axes."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import replace

from sympy import MatrixBase

from rigidtop.judge.context import Context
from rigidtop.judge.sides import letters_in
from rigidtop.judge.vocabulary import Meant
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


def each_entry(statement: Statement, known: Collection[Letter]) -> tuple[Statement, ...]:
    """What a statement says of new letters that stand below each other; else itself alone."""
    columns = [*map(_entries, statement.sides)]
    names = columns[0]
    new = all(isinstance(x, Letter) and x not in known for x in names) and len({*names}) > 1
    if not new or {len(column) for column in columns} != {len(names)}:
        return (statement,)
    return tuple(replace(statement, sides=sides) for sides in zip(*columns, strict=True))


def _entries(node: Node) -> tuple[Node, ...]:
    """The entries of a column, or of a tuple; none of what is neither."""
    match n.ungrouped(node):
        case n.Tuple(entries):
            return entries
        case n.Matrix(rows) if all(len(row) == 1 for row in rows):
            return tuple(row[0] for row in rows)
    return ()


def _with(statement: Statement, index: str, component: str) -> Statement:
    """A statement with a number in place of an index."""

    def change(node: Node) -> Node:
        if isinstance(node, Letter) and node.sub == index:
            return replace(node, sub=component)
        if isinstance(node, n.Component) and node.index == index:
            return replace(node, index=component)
        return node

    return replace(statement, sides=tuple(n.mapped(side, change) for side in statement.sides))


def along(basis: MatrixBase, after: Context, before: Context) -> Context:
    """What is known, where columns in what is new are components along the axes of a basis."""
    axes = [Meant(basis[:, k]) for k in range(3)]

    def resolved(node: Node) -> Node:
        match node:
            case n.Tuple((_, _, _) as entries):
                pass
            case n.Matrix(((first,), (second,), (third,)), bracket) if bracket != "|":
                entries = (first, second, third)
            case _:
                return node
        parts = zip(entries, axes, strict=True)
        return n.Bracketed(n.Sum(tuple(n.Product((n.Bracketed(x), axis)) for x, axis in parts)))

    def column(node: Node) -> Node:
        # (x, y, z)ᵀ is a column as it is.
        return (
            node.of
            if isinstance(node, n.TransposedMatrix) and isinstance(node.of, n.Tuple)
            else node
        )

    def there(node: Node) -> Node:
        return n.mapped(n.mapped(node, column), resolved)

    old = {id(c) for c in before.constraints}
    constraints = tuple(
        c if id(c) in old else replace(c, left=there(c.left), right=there(c.right))
        for c in after.constraints
    )
    definitions = {
        x: d if before.definitions.get(x) is d else replace(d, node=there(d.node))
        for x, d in after.definitions.items()
    }
    return replace(after, basis=None, constraints=constraints, definitions=definitions)
