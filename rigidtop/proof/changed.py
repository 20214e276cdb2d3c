"""Single changes of a printed equation: a sign, a factor, an exponent, an index, a function."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import Any

import sympy
from sympy import Add, Expr, Integer, Mul, Pow, Rational, Symbol, cos, sin

from rigidtop.proof.equation import (
    Cross,
    Equation,
    IntegralOver,
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
class Single:
    """A change of one node: its kind, such as "sign", what it is of, and `words` for it."""

    kind: str
    of: Any
    words: str
    entry: int = 0
    """Of a matrix: which entry, counted from 1."""


@dataclass(frozen=True)
class Perturbation:
    """A changed equation and what was changed."""

    equation: Equation
    change: str


def perturbations(equation: Equation, families: Families = ()) -> tuple[Perturbation, ...]:
    """Every single change of sign, factor, exponent, index, function or term, side by side."""
    made = []
    for k, side in enumerate(equation.sides):
        for changed, single in walked(side, lambda node: changes(node, families), (Partial, Rate)):
            sides = (*equation.sides[:k], changed, *equation.sides[k + 1 :])
            new = Equation(*sides, relation=equation.relation, tag=equation.tag)
            place = f"entry {single.entry}: " if single.entry else ""
            made.append(Perturbation(new, place + single.words))
    return tuple(made)


Changed = Iterable[tuple[Expr, Single]]


def walked(
    side: Expr, here: Callable[[Expr], Changed], whole: tuple[type, ...] = ()
) -> list[tuple[Expr, Single]]:
    """A side with one node of it changed, for every node and all that comes of it `here`.

    What is of a type of `whole` is changed as one thing, not within.
    """
    # All at once: SymPy forgets what it has found out wherever it is told to leave trees alone.
    with as_printed():
        return [*_walked(side, here, whole)]


def _walked(
    node: Expr, here: Callable[[Expr], Changed], whole: tuple[type, ...]
) -> Iterator[tuple[Expr, Single]]:
    if isinstance(node, sympy.MatrixBase):
        for k, entry in enumerate(node):
            for new, single in _walked(entry, here, whole):
                entries = [*node[:k], new, *node[k + 1 :]]
                placed = Single(single.kind, single.of, single.words, k + 1)
                yield sympy.ImmutableMatrix(*node.shape, entries), placed
        return
    yield from here(node)
    for k, argument in enumerate(node.args):
        if not isinstance(node, whole) and not _stands(node, k):
            for new, single in _walked(argument, here, whole):
                yield node.func(*node.args[:k], new, *node.args[k + 1 :]), single


def _stands(node: Expr, k: int) -> bool:
    """Whether argument k is left alone.

    The label of a brace, the index of a sum and the measure of an integral assert nothing; a power
    changes its exponent itself.
    """
    return (isinstance(node, (Underbrace, Pow)) and k == 1 and not node.args[1].args) or (
        isinstance(node, (IntegralOver, SumOver, VolumeIntegral)) and k == 0
    )


def changes(node: Expr, families: Families) -> Iterator[tuple[Expr, Single]]:
    """The changes of a node itself, typed as printed."""
    if node in (0, const):
        return
    if isinstance(node, Add):
        for k, term in enumerate(node.args):
            before, behind = node.args[:k], node.args[k + 1 :]
            others = (*before, *behind)
            yield Add(*before, -term, *behind), Single("sign", term, f"sign of {term}")
            rest = Add(*others) if len(others) > 1 else others[0]
            yield rest, Single("too much", term, f"{term} dropped")
            yield Add(*before, 2 * term, *behind), Single("factor", term, f"twice {term}")
        return
    if isinstance(node, Pow):
        base, exponent = node.args
        yield Pow(base, exponent + 1), Single("power", base, f"exponent of {base}")
    elif isinstance(node, Symbol):
        for family in (family for family in families if node in family):
            for other in (other for other in family if other != node):
                yield other, Single("index", other, f"{other} for {node}")
        yield 2 * node, Single("factor", node, f"twice {node}")
        yield Mul(node, node), Single("power", node, f"square of {node}")
    elif isinstance(node, (sin, cos)):
        other = (cos if isinstance(node, sin) else sin)(*node.args)
        yield other, Single("function", other, f"the other function in {node}")
        yield Pow(node, 2), Single("power", node, f"square of {node}")
    elif isinstance(node, Cross):
        yield Cross(*node.args[::-1]), Single("order", node, "factors of × exchanged")
    elif isinstance(node, Transposed):
        yield node.args[0], Single("transpose", node.args[0], "transposition dropped")
    elif node.is_Number:
        larger = Rational(node.p + node.q, node.q)
        yield larger, Single("number", larger, f"{larger} for {node}")
    if isinstance(node, (Pow, Symbol, sin, cos, Partial, Rate)) or node.is_Number:
        yield Mul(Integer(-1), node), Single("sign", node, f"sign of {node}")
