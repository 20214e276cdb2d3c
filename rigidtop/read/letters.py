"""Letters: bare, with dots and marks, bold or in another script, or those that spell a name."""

from __future__ import annotations

from dataclasses import replace

from rigidtop.read.derivatives import differentiated, sloped
from rigidtop.read.dress import DOTS, MARKS, STYLES, styled
from rigidtop.read.functions import named
from rigidtop.read.grammar import Grammar
from rigidtop.read.tokens import written
from rigidtop.tree.nodes import (
    Average,
    Bracketed,
    Letter,
    Node,
    Number,
    Primed,
    Product,
    Remainder,
    TimeDerivative,
    mapped,
    ungrouped,
)


def letter(grammar: Grammar) -> Node:
    """A letter, or what begins with it: a function, a derivative, O(x), Δx."""
    token = grammar.peek()
    name = grammar.spelled()
    if name:
        grammar.at += len(name)
        return named(grammar, name)
    if token.text == "d" and (node := differentiated(grammar, "d")):
        return node
    grammar.take()
    if token.text == "O" and grammar.peek().kind == "open":
        return _order(grammar)
    behind = grammar.peek()
    if token.text == "Δ" and behind.kind == "letter" and not grammar.spelled():
        return Letter("Δ" + grammar.take().text)
    return Letter(token.text)


def _order(grammar: Grammar) -> Node:
    """An order of magnitude by its bracket: O(x²)."""
    return Remainder(ungrouped(grammar.primary([])))


def _name(node: Node) -> Node:
    """Letters beside each other as one of several characters, anything else as it is."""
    if isinstance(node, Product) and all(isinstance(each, Letter) for each in node.factors):
        return Letter("".join(each.base for each in node.factors if isinstance(each, Letter)))
    return node


def dotted(grammar: Grammar) -> Node:
    order = DOTS[grammar.take().text]
    of = grammar.node_of(grammar.argument())
    if isinstance(of, TimeDerivative) and of.dotted:
        return replace(of, order=of.order + order)
    return TimeDerivative(ungrouped(of), order, dotted=True)


def bold(grammar: Grammar) -> Node:
    """A bold letter; what is longer and underlined is a result, and no vector."""
    command = grammar.take().text
    argument = grammar.argument()
    if written(argument) == "∇":
        return sloped(grammar)
    of = _name(grammar.node_of(argument))
    if command == r"\underline" and not isinstance(of, Letter | TimeDerivative | Primed):
        return Bracketed(of)
    return mapped(of, lambda x: replace(x, bold=True) if isinstance(x, Letter) else x)


def marked(grammar: Grammar) -> Node:
    mark = MARKS[grammar.take().text]
    of = _name(grammar.node_of(grammar.argument()))
    if isinstance(of, Letter):
        return replace(of, mark=mark)
    if isinstance(of, (TimeDerivative, Primed)) and isinstance(of.of, Letter):
        return replace(of, of=replace(of.of, mark=mark))
    return Average(of) if mark == "bar" else of


def lettered(grammar: Grammar) -> Node:
    """Letters in another script, as they are where Unicode has none."""
    style = STYLES[grammar.take().text]
    text = written(grammar.argument())
    if text.isdigit():  # 1 is the unit matrix
        return Number(text)
    try:
        base = "".join(styled(each, style) for each in text)
    except KeyError:
        base = text
    if base == "𝒪" and grammar.peek().kind == "open":
        return _order(grammar)
    return Letter(base)


def slanted(grammar: Grammar) -> Node:
    grammar.take()
    return grammar.node_of(grammar.argument())
