"""Single changes of a printed equation: a sign, a factor, an exponent, an index, a function."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol, cos, sin

from rigidtop.proof.equation import (
    Cross,
    Equation,
    IntegralOver,
    Matrices,
    Partial,
    Rate,
    SumOver,
    Transposed,
    Underbrace,
    VolumeIntegral,
    as_printed,
)
from rigidtop.theory.symbols import const

Families = Sequence[tuple[Symbol, ...]]
"""Symbols that a slip of the pen exchanges."""


@dataclass(frozen=True)
class Perturbation:
    """A changed equation and what was changed."""

    equation: Equation
    change: str


def perturbations(equation: Equation, families: Families = ()) -> tuple[Perturbation, ...]:
    """Every single change of sign, factor, exponent, index, function or term, side by side."""
    # All at once: SymPy forgets what it has found out wherever it is told to leave trees alone.
    with as_printed():
        return tuple(
            Perturbation(
                Equation(
                    *equation.sides[:k],
                    changed,
                    *equation.sides[k + 1 :],
                    relation=equation.relation,
                    tag=equation.tag,
                ),
                change,
            )
            for k, side in enumerate(equation.sides)
            for changed, change in _changed_side(side, families)
        )


def _changed_side(side: Expr, families: Families) -> Iterator[tuple[Expr, str]]:
    """A side with one change in it; of a matrix one entry is changed."""
    if not isinstance(side, sympy.MatrixBase):
        yield from _changed(side, families)
        return
    for k, entry in enumerate(side):
        for changed, change in _changed(entry, families):
            new = [*side[:k], changed, *side[k + 1 :]]
            yield sympy.ImmutableMatrix(*side.shape, new), f"entry {k + 1}: {change}"


def _changed(node: Expr, families: Families) -> Iterator[tuple[Expr, str]]:
    """The tree with one change at this node or below it."""
    yield from _changed_here(node, families)
    if isinstance(node, Matrices):
        for k, matrix in enumerate(node.args):
            for changed, change in _changed_side(matrix, families):
                yield Matrices(*node.args[:k], changed, *node.args[k + 1 :]), change
        return
    for k, argument in enumerate(node.args):
        if not _stands(node, k):
            for changed, change in _changed(argument, families):
                yield node.func(*node.args[:k], changed, *node.args[k + 1 :]), change


def _stands(node: Expr, k: int) -> bool:
    """Whether argument k is left alone.

    The label of a brace, the index of a sum and the measure of an integral assert nothing; a rate
    is one thing with a meaning of its own; a power changes its exponent itself.
    """
    return (
        isinstance(node, (Partial, Rate))
        or (isinstance(node, (Underbrace, Pow)) and k == 1 and not node.args[1].args)
        or (isinstance(node, (IntegralOver, SumOver, VolumeIntegral)) and k == 0)
    )


def _changed_here(node: Expr, families: Families) -> Iterator[tuple[Expr, str]]:
    """The changes of a node itself, typed as printed."""
    if node in (0, const):
        return
    if isinstance(node, Add):
        for k, term in enumerate(node.args):
            others = (*node.args[:k], *node.args[k + 1 :])
            yield Add(*node.args[:k], -term, *node.args[k + 1 :]), f"sign of {term}"
            yield (Add(*others) if len(others) > 1 else others[0]), f"{term} dropped"
            yield Add(*node.args[:k], 2 * term, *node.args[k + 1 :]), f"twice {term}"
    elif isinstance(node, Pow):
        base, exponent = node.args
        yield Pow(base, exponent + 1), f"exponent of {base}"
        yield Mul(node, Integer(-1)), f"sign of {node}"
    elif isinstance(node, Symbol):
        for family in families:
            if node in family:
                yield from ((other, f"{other} for {node}") for other in family if other != node)
        yield Mul(Integer(2), node), f"twice {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"
        yield Mul(node, node), f"square of {node}"
    elif isinstance(node, (sin, cos)):
        yield (cos if isinstance(node, sin) else sin)(*node.args), f"the other function in {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"
        yield Pow(node, Integer(2)), f"square of {node}"
    elif isinstance(node, (Partial, Rate)):
        yield Mul(Integer(-1), node), f"sign of {node}"
    elif isinstance(node, Cross):
        yield Cross(node.args[1], node.args[0]), "factors of × exchanged"
    elif isinstance(node, Transposed):
        yield node.args[0], "transposition dropped"
    elif node.is_Number:
        larger = Rational(node.p + node.q, node.q)
        yield larger, f"{larger} for {node}"
        yield Mul(Integer(-1), node), f"sign of {node}"
