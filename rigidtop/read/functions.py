"""Functions by their names, and how far what they act on goes: cos ωt, but sin θ cos θ."""

from __future__ import annotations

from typing import Final

from rigidtop.read.grammar import Grammar
from rigidtop.read.shapes import product_of
from rigidtop.read.tokens import written
from rigidtop.tree.nodes import (
    Apply,
    Constant,
    Letter,
    Node,
    Number,
    Power,
    Quotient,
    Root,
    letters,
    ungrouped,
)

_INVERSE: Final = {name: f"arc{name}" for name in ("sin", "cos", "tan")}
_WAVES, _PHASES = frozenset("kωΩνκqnm"), frozenset({"t", "x", "φ", "ϕ", "θ"})
"""Letters in front of brackets with one of these places belong to what a function acts on."""
_ANGLES: Final = frozenset("θφψϕϑt")
"""What ends the argument of a function: sin θ, cos ωt."""


def named(grammar: Grammar, name: str) -> Node:
    """What letters spell: a function, a root or a constant."""
    if name == "sqrt":
        return Root(grammar.node_of(grammar.argument()))
    return Constant() if name == "const" else function(grammar, name)


def function(grammar: Grammar, name: str) -> Node:
    """A function with its power and what it acts on."""
    power: Node | None = None
    while grammar.is_sign("_^"):
        sign, group = grammar.take().text, grammar.argument()
        if sign == "_":
            name += "_" + written(group)
        elif written(group) in ("-1", "−1") and name in _INVERSE:
            name = _INVERSE[name]
        else:
            power = grammar.node_of(group)
    applied = Apply(name, acted_on(grammar))
    return applied if power is None else Power(applied, power)


def acted_on(grammar: Grammar) -> Node:
    """What a function acts on: brackets, or a product as far as it stands close."""
    token = grammar.peek()
    bracket = token.kind == "open" and token.text in "([{"
    if bracket or (token.kind == "group" and len(token.group) > 1):
        return ungrouped(grammar.primary([]))
    if not grammar.starts():
        raise grammar.missing("what a function acts on")
    factors = [grammar.factor([])]
    while goes_on(grammar, factors[-1]):
        factors.append(grammar.factor(factors))
    return product_of(factors)


def goes_on(grammar: Grammar, last: Node) -> bool:
    """Whether the argument of a function takes the next factor too: cos ωt, but sin θ cos θ."""
    token = grammar.peek()
    if token.text == "(" and not token.spaced and not letters(last):
        return isinstance(last, (Number, Quotient))  # sin 2(α + β)
    if token.text == "(" and not token.spaced and isinstance(last, Letter):
        behind = grammar.items[grammar.at : grammar.partners.get(grammar.at, grammar.at)]
        return last.base in _WAVES and any(x.text in _PHASES for x in behind)  # sin ω(t − t₀)
    if token.spaced or token.kind not in ("letter", "number", "group") or not grammar.starts():
        return False
    if token.text == "d" and grammar.is_differential():
        return False
    share = isinstance(last, Quotient) and not letters(last)  # cos ½θ
    if not (share or isinstance(last, (Letter, Number, Power))) or grammar.spelled():
        return False
    return not (letters(last) and {each.base for each in letters(last)} <= _ANGLES)


def root(grammar: Grammar) -> Node:
    grammar.take()
    degree: Node = Number("2")
    if grammar.peek().kind == "open" and grammar.peek().text == "[":
        end = grammar.partners.get(grammar.at, grammar.at)
        degree = grammar.node_of(grammar.items[grammar.at + 1 : end])
        grammar.at = end + 1
    of = ungrouped(grammar.node_of(grammar.argument()))
    if isinstance(degree, Number) and degree.text.isdecimal():
        return Root(of, int(degree.text))
    return Power(of, Quotient(Number("1"), degree))
