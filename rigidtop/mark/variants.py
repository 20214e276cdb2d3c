"""How a line may be meant otherwise than it is written: in the body, of vectors, along an axis."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace

from sympy import ImmutableMatrix

from rigidtop.judge.context import Context, LetterDefinition
from rigidtop.judge.meaning import AT_REST, IN_BODY
from rigidtop.judge.sides import ZERO
from rigidtop.judge.vocabulary import Meant
from rigidtop.mark.facts import GIVEN
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.statement import Statement

BODY = re.compile(
    r"\b(?:body|rotating|co-?rotating|körper|mitrotieren|mitbewegt|mitgeführt|hauptachsensystem)",
    re.I,
)
"""Words for the frame in which a dot on a vector differentiates its components."""


def in_body(each: Statement) -> Statement | None:
    """The statement with dots on vectors for the rates of their components in the body."""

    def seen(node: Node) -> Node:
        match node:
            case n.TimeDerivative(Letter(bold=True), frame=""):
                return replace(node, frame="body")
        return node

    sides = tuple(n.mapped(side, seen) for side in each.sides)
    return replace(each, sides=sides) if sides != each.sides else None


def is_turned(each: Statement) -> bool:
    """Whether **ω** × **A** stands beside a rate of **A**, as it does where that is of the body."""
    nodes = [node for side in each.sides for node in n.walked(side)]
    rates = {x.of for x in nodes if isinstance(x, n.TimeDerivative)}
    crossed = [(x.left, x.right) for x in nodes if isinstance(x, n.CrossProduct)]
    return any(_OMEGA in pair and {*pair} & rates for pair in crossed)


_OMEGA = Letter("ω", bold=True)


def in_its_frame(each: Statement) -> Statement | None:
    """The statement where a frame with a name of the answer's own turns with what stands beside it.

    Of (dA/dt)_frame + w × A that is w.
    """
    nodes = [node for side in each.sides for node in n.walked(side)]
    crossed = [(x.left, x.right) for x in nodes if isinstance(x, n.CrossProduct)]

    def seen(node: Node) -> Node:
        match node:
            case n.TimeDerivative(of, 1, _, frame) if frame and not frame.startswith(
                (*AT_REST, *IN_BODY)
            ):
                beside = {b if a == of else a for a, b in crossed if of in (a, b)}
                if len(beside) == 1:
                    moved = n.Negative(n.CrossProduct(beside.pop(), of))
                    return n.Bracketed(n.Sum((n.TimeDerivative(of, dotted=True), moved)))
        return node

    sides = tuple(n.mapped(side, seen) for side in each.sides)
    return replace(each, sides=sides) if sides != each.sides else None


_VERTICAL = Letter("z", mark="hat", bold=True)


def aligned(
    each: Statement, contexts: tuple[Context, ...]
) -> tuple[Statement, tuple[Context, ...]]:
    """What L_z = L, **L** = L **ẑ** or (0, 0, L) suppose: **L** lies along **ẑ**, and L is L_z.

    Of a length that is equal to a component no world knows in which direction it may change.
    """
    match each.sides:
        case (Letter(base, "z", "", False), Letter() as length):
            vector = Letter(base, bold=True)
        case (Letter(bold=True) as vector, n.Product((Letter() as length, axis)), *_) if (
            axis == _VERTICAL
        ):
            pass
        case (Letter(bold=True) as vector, n.Tuple((x, y, Letter() as length))) if (
            x == y == n.Number("0")
        ):
            pass
        case _:
            return each, contexts
    if replace(vector, bold=False) != length:
        return each, contexts
    if not all(vector in x.definitions for x in contexts):
        return each, contexts
    named = all(_VERTICAL in x.definitions for x in contexts)
    up: Node = _VERTICAL if named else Meant(ImmutableMatrix([0, 0, 1]))
    component = LetterDefinition(n.DotProduct(vector, up), GIVEN)
    known = tuple(
        replace(x.defining(length, component), not_zero=(*x.not_zero, length)) for x in contexts
    )
    along = replace(each, sides=(n.CrossProduct(vector, up), n.Number("0")), relations=("=",))
    return along, known


def unchanging(each: Statement) -> Statement:
    """That the left side of a statement does not change."""
    return replace(each, sides=(n.TimeDerivative(each.sides[0]), ZERO), relations=("=",))


def of_vectors(each: Statement, contexts: Sequence[Context]) -> Statement | None:
    """The statement with vectors for letters with a point or a cross between, as plain ω·L."""
    given = frozenset().union(*(context.given for context in contexts))

    def vector(node: Node) -> Node:
        bold = replace(node, bold=True) if isinstance(node, Letter) else node
        return bold if bold in given else node

    def seen(node: Node) -> Node:
        match node:
            case n.DotProduct(n.Product((*factors, Letter() as left)), Letter() as right):
                return n.Product((*factors, n.DotProduct(vector(left), vector(right))))
            case n.DotProduct(Letter() as left, Letter() as right):
                return n.DotProduct(vector(left), vector(right))
            case n.CrossProduct(Letter() as left, Letter() as right):
                return n.CrossProduct(vector(left), vector(right))
        return node

    sides = tuple(n.mapped(side, seen) for side in each.sides)
    return replace(each, sides=sides) if sides != each.sides else None


def of_whole_vector(each: Statement, contexts: Sequence[Context]) -> Statement | None:
    """ω̇ = 0 or ω = const of the vector **ω**, which says more than of its length."""
    given = frozenset().union(*(context.given for context in contexts))
    match each.sides:
        case (
            n.TimeDerivative(Letter(bold=False) as letter) | (Letter(bold=False) as letter),
            right,
        ):
            bold = replace(letter, bold=True)
            if bold in given and (right == ZERO or isinstance(right, n.Constant)):
                left = n.mapped(each.sides[0], lambda x: bold if x == letter else x)
                return replace(each, sides=(left, right))
    return None


def with_vector(each: Statement, contexts: Sequence[Context]) -> Statement | None:
    """The statement with a vector on its left side, where the facts know one of that name."""
    left = each.sides[0]
    if not isinstance(left, Letter) or left.bold:
        return None
    bold = replace(left, bold=True)
    is_known = any(bold in context.given for context in contexts)
    return replace(each, sides=(bold, *each.sides[1:])) if is_known else None
