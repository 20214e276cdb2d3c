"""Integrals, sums over an index, and limits."""

from __future__ import annotations

from rigidtop.read.derivatives import differential_of
from rigidtop.read.grammar import Grammar
from rigidtop.read.shapes import integrand_of
from rigidtop.read.tex import UnreadError
from rigidtop.tree.nodes import (
    Differential,
    Integral,
    Letter,
    Limit,
    Node,
    Number,
    Sum,
    Total,
    ungrouped,
    walked,
)


def integral(grammar: Grammar) -> Node:
    """An integral, or several in a row; the innermost goes with the first differential."""
    position = grammar.peek().position
    bounds: list[tuple[Node | None, Node | None]] = []
    while grammar.peek().text in ("∫", "∮"):
        grammar.take()
        limits = grammar.limits()
        lower, upper = (grammar.node_of(limits[x]) if x in limits else None for x in "_^")
        bounds.append((lower, upper))
    grammar.integrals += 1
    by = _differentials(grammar)
    of = _integrand(grammar, in_front=bool(by))
    by += _differentials(grammar)
    grammar.integrals -= 1
    for _ in () if by else bounds:
        of, variable = integrand_of(of, position)
        by = [*by, (variable, 1)]
    for variable, dimension in by:
        lower, upper = bounds.pop() if bounds else (None, None)
        of = Integral(ungrouped(of), variable, lower, upper, dimension)
    if bounds:
        raise UnreadError("an integral that does not say over what", position)
    return of


def _integrand(grammar: Grammar, *, in_front: bool) -> Node:
    """What stands between ∫ and dx, or behind both."""
    if in_front:
        return grammar.term() if grammar.starts() else Number("1")
    if grammar.is_differential():
        return Number("1")
    terms = [grammar.signed()]
    while grammar.is_sign("+-") and not _has_differential(terms[-1]):
        terms.append(grammar.signed())
    if grammar.is_sign("·"):
        grammar.take()
    return terms[0] if len(terms) == 1 else Sum(tuple(terms))


def _differentials(grammar: Grammar) -> list[tuple[Node, int]]:
    """The letters behind each d, with how often they count: d³r."""
    variables = []
    while grammar.is_differential():
        grammar.take()
        dimension = grammar.exponent()
        variables.append((differential_of(grammar), dimension))
    return variables


def total(grammar: Grammar) -> Node:
    """Σ or Π with its index and bounds."""
    sign = grammar.take().text
    limits = grammar.limits()
    below, above = limits.get("_", ()), limits.get("^", ())
    equals = next((i for i, each in enumerate(below) if each.text == "="), None)
    lower = grammar.node_of(below[equals + 1 :]) if equals is not None else None
    upper = grammar.node_of(above) if above else None
    names = tuple(Letter(each.text) for each in below[:equals] if each.kind == "letter")
    return Total(grammar.term(), names, lower, upper, sign)


def limit(grammar: Grammar) -> Node:
    grammar.take()
    group = grammar.limits().get("_", ())
    goes = next((i for i, each in enumerate(group) if each.text == "→"), None)
    if goes is None:
        raise UnreadError("a limit that does not say of what", grammar.place())
    letter, place = group[:goes], group[goes + 1 :]
    return Limit(grammar.term(), grammar.node_of(letter), grammar.node_of(place))


def _has_differential(node: Node) -> bool:
    return any(isinstance(each, Differential) for each in walked(node))
