"""Brackets and what else encloses: groups, bars, braces with a label, matrices."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rigidtop.read.derivatives import operation
from rigidtop.read.grammar import Grammar
from rigidtop.read.scripts import taken
from rigidtop.read.shapes import head_of, parted
from rigidtop.read.tex import UnreadError
from rigidtop.read.tokens import Token, written
from rigidtop.read.vocabulary import MATRICES
from rigidtop.tree.nodes import (
    Absolute,
    Average,
    Braced,
    Bracketed,
    Matrix,
    Node,
    Number,
    Omitted,
    Tuple,
)


def group(grammar: Grammar) -> Node:
    token = grammar.take()
    if not token.group:
        return grammar.factor([]) if grammar.starts() else Omitted()
    return grammar.node_of(token.group)


def bracket(grammar: Grammar) -> Node:
    start, token = grammar.at, grammar.take()
    end = grammar.partners.get(start)
    if end is None:
        raise UnreadError(f"a {token.text} without its end", token.position)
    inside = grammar.items[start + 1 : end]
    grammar.at = end + 1
    if not inside:
        raise UnreadError("brackets with nothing in them", token.position)
    matrix = inside[0].kind == "environment" and len(inside) == 1
    head = head_of(inside)
    if head and not head.of and grammar.is_sign("_"):
        grammar.take()
        return operation(grammar, head, written(grammar.argument()))
    node = grammar.node_of(inside)
    if token.text == "|":
        return Absolute(node)
    if token.text == "⟨":
        return Average(node)
    if token.text == ".":
        return taken(grammar, node)
    if matrix and isinstance(node, Matrix):
        return replace(node, bracket=token.text)
    if isinstance(node, Tuple):
        pair = len(node.entries) == 2 and token.text in "{["  # {q, p}
        return replace(node, bracket=token.text) if pair else node
    return Bracketed(node, token.text)


def bar(grammar: Grammar) -> Node:
    position = grammar.take().position
    grammar.bars += 1
    node = grammar.expression()
    grammar.bars -= 1
    if grammar.peek().kind != "bar":
        raise UnreadError("a bar without the one that closes it", position)
    grammar.take()
    return Absolute(node)


def braced(grammar: Grammar) -> Node:
    grammar.take()
    of = grammar.node_of(grammar.argument())
    if not grammar.is_sign("_^"):
        return of
    grammar.take()
    group = grammar.argument()
    if group and group[0].kind == "relation":
        group = group[1:]
    if any(each.kind == "words" for each in group):
        return Braced(of, words=written(group))
    try:
        return Braced(of, grammar.node_of(group))
    except UnreadError:
        return Braced(of, words=written(group))


def matrix(grammar: Grammar) -> Node:
    token = grammar.take()
    if token.text not in MATRICES:
        raise UnreadError("cases within a formula", token.position)
    rows = [
        tuple(_cell(grammar, cell) for cell in parted(row, "align"))
        for row in parted(token.group, "break")
        if row
    ]
    if not rows:
        raise UnreadError("a matrix with nothing in it", token.position)
    return Matrix(_filled(rows), MATRICES[token.text] or "(")


def _cell(grammar: Grammar, items: Sequence[Token]) -> Node | None:
    shown = [each for each in items if each.kind != "quad"]
    while shown and shown[-1].kind in ("comma", "stop"):
        shown.pop()
    return grammar.node_of(shown) if shown else None


def _filled(rows: Sequence[Sequence[Node | None]]) -> tuple[tuple[Node, ...], ...]:
    """Rows with zeros where a square matrix that has its diagonal is left blank."""
    width = len(rows[0])
    square = width > 1 and all(len(row) in (width, k + 1) for k, row in enumerate(rows))
    square = square and len(rows) == width
    if not square or any(row[k] is None for k, row in enumerate(rows)):
        return tuple(tuple(Omitted() if x is None else x for x in row) for row in rows)
    longer = [(*row, *[None] * (width - len(row))) for row in rows]
    return tuple(tuple(Number("0") if x is None else x for x in row) for row in longer)
