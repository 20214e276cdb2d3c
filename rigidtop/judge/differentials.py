"""Differentials that stand alone, as rates: dφ = N dt/L says that φ̇ = N/L; and variations."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace
from itertools import pairwise

from rigidtop.judge.letters import CLOCK
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement, Unread

_ONE = n.Number("1")


def in_rates(read: Iterable[Statement | Unread]) -> list[Statement | Unread]:
    """Statements whose differentials are those of things that move, with rates in their place.

    Others stay: dm may be a part of a mass that does not change.
    """
    stated = [*read]
    moving = {
        node.of
        for each in stated
        if isinstance(each, Statement)
        for side in each.sides
        for node in n.walked(side)
        if isinstance(node, n.TimeDerivative) and isinstance(node.of, Letter)
    }
    return [_in_rates(each, moving) if isinstance(each, Statement) else each for each in stated]


def in_variations(read: Iterable[Statement | Unread]) -> list[Statement | Unread]:
    """Statements in which δ before a letter makes another one of it: δθ is small, and has a rate.

    Others stay where δ is a letter itself.
    """
    stated = [*read]
    nodes = [
        node
        for each in stated
        if isinstance(each, Statement)
        for side in each.sides
        for node in n.walked(side)
    ]
    if DELTA not in nodes or is_factor(nodes):
        return stated
    return [
        replace(each, sides=tuple(n.mapped(side, _in_variations) for side in each.sides))
        if isinstance(each, Statement)
        else each
        for each in stated
    ]


DELTA = Letter("δ")


def is_factor(nodes: Sequence[Node]) -> bool:
    """Whether δ stands anywhere but in front of what it may vary, as in δ x."""
    products = (x.factors for x in nodes if isinstance(x, n.Product))
    pairs = [pair for factors in products for pair in pairwise(factors) if pair[0] == DELTA]
    varied = [x for _, x in pairs if not isinstance(x, (n.Power, n.Bracketed))]
    return nodes.count(DELTA) > len(varied)


def _in_variations(node: Node) -> Node:
    """A product in which each δ is one with the letter, or the rate of a letter, behind it."""
    if not isinstance(node, n.Product):
        return node
    factors: list[Node] = []
    for factor in node.factors:
        varied = _varied(factor) if factors and factors[-1] == DELTA else None
        factors[-1:] = [varied] if varied is not None else [*factors[-1:], factor]
    return factors[0] if len(factors) == 1 else n.Product(tuple(factors))


def _varied(node: Node) -> Node | None:
    match node:
        case Letter(base):
            return replace(node, base=f"δ{base}")
        case n.TimeDerivative(Letter(base) as of):
            return replace(node, of=replace(of, base=f"δ{base}"))
    return None


def _in_rates(each: Statement, moving: Collection[Node]) -> Statement:
    names = [x.of for side in each.sides for x in _differentials(side)]
    known = CLOCK in names or {*names} <= {*moving}
    if not names or not known or not all(isinstance(x, Letter) for x in names):
        return each
    degrees = {_degree(side) for side in each.sides if side != n.Number("0")}
    if len(degrees) != 1 or degrees & {None, 0}:
        return each
    return replace(each, sides=tuple(n.mapped(side, _rate) for side in each.sides))


def _differentials(node: Node) -> list[n.Differential]:
    """Those that belong to no integral."""
    if isinstance(node, n.Integral):
        return []
    if isinstance(node, n.Differential):
        return [node]
    return [x for part in n.parts(node) for x in _differentials(part)]


def _rate(node: Node) -> Node:
    match node:
        case n.Differential(of):
            return _ONE if of == CLOCK else n.TimeDerivative(of)
        case n.Product(factors) if _ONE in factors:
            left = tuple(x for x in factors if x != _ONE)
            return left[0] if len(left) == 1 else n.Product(left)
    return node


def _degree(node: Node) -> int | None:
    """How many differentials are multiplied in each term of a side; None if it is not the same."""
    match node:
        case n.Differential(order=1, partial=False):
            return 1
        case n.Negative(of) | n.Bracketed(of) | n.Absolute(of):
            return _degree(of)
        case n.Sum(terms):
            degrees = {_degree(x) for x in terms}
            return degrees.pop() if len(degrees) == 1 else None
        case n.Product(factors):
            return _sum([_degree(x) for x in factors])
        case n.DotProduct(left, right) | n.CrossProduct(left, right):
            return _sum([_degree(left), _degree(right)])
        case n.Quotient(over, under):
            below = _degree(under)
            return _sum([_degree(over), None if below is None else -below])
        case n.Power(base, n.Number(text)) if text.isdigit():
            degree = _degree(base)
            return None if degree is None else degree * int(text)
    return None if _differentials(node) else 0


def _sum(degrees: Iterable[int | None]) -> int | None:
    total = 0
    for each in degrees:
        if each is None:
            return None
        total += each
    return total
