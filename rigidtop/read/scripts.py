"""The scripts of a factor: indices, powers, primes, and the place at which it is taken."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from rigidtop.read.grammar import Grammar
from rigidtop.read.shapes import framed, is_place, primed, with_index
from rigidtop.read.tex import UnreadError
from rigidtop.read.tokens import Token, written
from rigidtop.read.units import raised
from rigidtop.tree.nodes import (
    At,
    Call,
    Component,
    Letter,
    Node,
    Number,
    Power,
    Primed,
    Product,
    TimeDerivative,
    TransposedMatrix,
    Tuple,
    Unit,
    letters,
    ungrouped,
)


def scripted(grammar: Grammar, node: Node) -> Node:
    """A factor with its index, power and primes, and with where it is taken."""
    count = 0
    while True:
        count = grammar.counted(count)
        if grammar.is_sign("_"):
            grammar.take()
            node = subscripted(grammar, node, grammar.argument())
        elif grammar.is_sign("^"):
            grammar.take()
            node = _superscripted(grammar, node, grammar.argument())
        elif grammar.peek().kind == "prime":
            grammar.take()
            node = primed(node)
        elif grammar.is_sign("!"):
            raise UnreadError("a factorial", grammar.place())
        elif grammar.peek().kind == "bar" and grammar.is_sign("_", 1):
            grammar.take()
            node = taken(grammar, node)
        elif grammar.peek().kind == "open" and _is_called(grammar, node):
            node = _called(grammar, node)
        else:
            return node


def subscripted(grammar: Grammar, node: Node, group: Sequence[Token]) -> Node:
    """A node with its index: of a letter, a frame of a rate, the place of a value, a component."""
    text = written(group)
    indexed = with_index(node, text)
    if indexed is not None:
        return indexed
    if any(each.kind == "relation" for each in group):
        return _at_place(grammar, node, group)
    return framed(ungrouped(node), text) or Component(node, text)


def _superscripted(grammar: Grammar, node: Node, group: Sequence[Token]) -> Node:
    text = written(group)
    if text in ("T", "⊤"):
        return TransposedMatrix(node)
    if text in ("∘", "°"):
        return Product((node, Unit("°")))
    if group and group[0].kind == "prime":
        return _superscripted(grammar, primed(node), group[1:]) if group[1:] else primed(node)
    if text in ("*", "⋆", "†") and isinstance(node, Letter):
        return replace(node, mark="star" if text != "†" else "dagger")
    named = len(group) == 1 and group[0].kind in ("words", "upright") and len(text) > 1
    # Nobody writes a power for 1: in R⁰₁ zero is a frame, in x⁰ an order, as in x⁽⁰⁾.
    zero = text == "0" and isinstance(node, Letter) and node != Letter("e")
    number = zero or (len(group) == 3 and group[0].text == "(")
    if named or number or text in ("+", "-", "±", "∓", "⊥", "∥"):
        indexed = with_index(node, text if not number else f"({text.strip('()')})")
        if indexed is not None:
            return indexed
    exponent = grammar.node_of(group)
    return raised(node, exponent) if isinstance(node, Unit) else Power(node, exponent)


def taken(grammar: Grammar, node: Node) -> Node:
    """A bar with what stands below it, or below and above."""
    limits = grammar.limits()
    below = limits.get("_", ())
    if "^" in limits:
        return At(node, sub=f"{written(below)}^{written(limits['^'])}")
    return framed(ungrouped(node), written(below)) or _at_place(grammar, node, below)


def _at_place(grammar: Grammar, node: Node, group: Sequence[Token]) -> Node:
    relations = [i for i, each in enumerate(group) if each.text == "="]
    if len(relations) != 1:
        return At(node, sub=written(group))
    left, right = group[: relations[0]], group[relations[0] + 1 :]
    return At(node, grammar.node_of(left), grammar.node_of(right))


def _is_called(grammar: Grammar, node: Node) -> bool:
    """Whether the bracket that follows holds the places of a function."""
    token = grammar.peek()
    end = grammar.partners.get(grammar.at)
    core = node.of if isinstance(node, (TimeDerivative, Primed)) else node
    if token.text != "(" or token.spaced or end is None or not isinstance(core, Letter):
        return False
    inside = grammar.items[grammar.at + 1 : end]
    time = len(inside) > 2 and inside[0].text == "t" and inside[1].text == "="
    if time and not any(each.kind == "relation" for each in inside[2:]):
        return True
    if grammar.related.get(grammar.at) or (isinstance(node, TimeDerivative) and not node.dotted):
        return False
    if core in grammar.reading.functions:
        return True
    if core == Letter("Γ") and inside and not any(x.kind == "letter" for x in inside):
        return _is_number(grammar, inside)
    if any(each.kind == "open" for each in inside) or len(inside) > 24:
        return False
    return _holds_places(grammar, node, inside)


def _is_number(grammar: Grammar, inside: Sequence[Token]) -> bool:
    """Whether no letter stands there: Γ(¼) is the gamma function, and no product."""
    try:
        return not letters(grammar.node_of(inside))
    except UnreadError:
        return False


def _holds_places(grammar: Grammar, node: Node, inside: Sequence[Token]) -> bool:
    try:
        place = grammar.node_of(inside)
    except UnreadError:
        return False
    if isinstance(place, Tuple):
        return all(map(is_place, place.entries)) and bool(letters(place))
    if place == Number("0") or (isinstance(place, Letter) and place.base == "t"):
        return True
    if isinstance(node, TimeDerivative) and isinstance(place, Letter):
        return True  # nobody writes φ̇(θ) for a product
    guessed = grammar.reading.calls and not grammar.reading.functions
    return guessed and is_place(place) and not isinstance(place, Number)


def _called(grammar: Grammar, node: Node) -> Node:
    start, end = grammar.at, grammar.partners[grammar.at]
    inside = grammar.items[start + 1 : end]
    grammar.at = end + 1
    if any(each.kind == "relation" for each in inside):
        inside = inside[2:]
    return Call(node, grammar.inner(inside).entries())
