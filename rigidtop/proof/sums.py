"""Sums over particles and integrals over a body: what in them changes from part to part."""

from __future__ import annotations

from collections.abc import Iterator

from sympy import Expr, Mul, Symbol

from rigidtop.proof.equation import Cross, Dot, Rate, SumOver, VolumeIntegral
from rigidtop.proof.letters import Letters
from rigidtop.proof.values import Applied

SUMS = (SumOver, VolumeIntegral)
"""Σ and ∫ over a body: each binds its first part in its second."""


def indices(node: Expr, letters: Letters) -> frozenset[Symbol]:
    """The indices that stand free in an expression, bound by no sum in it."""
    if isinstance(node, SUMS):
        return indices(node.args[1], letters) - {node.args[0]}
    if isinstance(node, Symbol):
        return letters.indexed.get(node, frozenset())
    return frozenset().union(*(indices(part, letters) for part in node.args))


def varies(part: Expr, node: Expr, letters: Letters) -> bool:
    """Whether an expression changes from part to part of a sum."""
    return node.args[0] in indices(part, letters)


def parted(node: Expr, term: Expr, letters: Letters) -> tuple[Expr, Expr]:
    """The factors that stay the same for all parts of a sum, and those that do not."""
    groups: dict[bool, list[Expr]] = {False: [], True: []}
    for factor in Mul.make_args(term):
        groups[varies(factor, node, letters)].append(factor)
    return Mul(*groups[False]), Mul(*groups[True])


def linear(node: Expr, term: Expr, letters: Letters) -> list[Expr]:
    """Scalar products of what changes from part to part with what does not."""
    return [
        f
        for f in Mul.make_args(term)
        if isinstance(f, Dot)
        and varies(f.args[0], node, letters) != varies(f.args[1], node, letters)
        and not isinstance(f.args[0], Cross)
    ]


def is_vector(node: Expr, letters: Letters) -> bool:
    """Whether an atom is a vector, or a sum of vectors."""
    if isinstance(node, SUMS):
        return any(is_vector(part, letters) for part in Mul.make_args(node.args[1]))
    return node in letters.vectors or isinstance(node, (Cross, Applied, Rate))


def linear_factors(term: Expr) -> Iterator[Expr]:
    """What a term is linear in: its factors, also those of its vector and scalar products."""
    yield term
    if isinstance(term, (Mul, Cross, Dot)):
        for part in term.args:
            yield from linear_factors(part)


def order_of(node: Expr) -> tuple[bool, str]:
    """The order in which sums are written: Σ outside ∫, k outside l."""
    return isinstance(node, VolumeIntegral), str(node.args[0])
