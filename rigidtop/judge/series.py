"""Sums in which the index is a number: Σ n xⁿ from one end to the other, which may be infinity."""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Eq, Expr, Integer, Piecewise, Product, Sum, Symbol

from rigidtop.judge.values import UnclearError
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter

MOST_TERMS = 24
"""A sum of no more terms is taken term by term."""


def is_of_numbers(node: n.Total) -> bool:
    """Whether the index stands in the terms as a number, and no letter has it in its name."""
    if len(node.index) != 1:
        return False
    [index] = node.index
    names = n.letters(node.of)
    return index in names and not any(_counts(x, index) for x in names)


def _counts(letter: Letter, index: Letter) -> bool:
    return index.base in letter.sub.split(",") or letter.sub == index.base


def series(term: Expr, index: Symbol, lower: Expr, upper: Expr, sign: str) -> Expr:
    """The sum, or the product, of a term for all numbers from one end to the other.

    Of a series its value is taken where it converges.  Raises UnclearError where none is found.
    """
    if lower.is_Integer and upper.is_Integer and upper - lower < MOST_TERMS:
        terms = [term.xreplace({index: Integer(k)}) for k in range(int(lower), int(upper) + 1)]
        return _joined(terms, sign)
    k = sympy.Dummy("k", integer=True, nonnegative=True)
    which = sympy.summation if sign == "Σ" else sympy.product
    value = which(term.xreplace({index: k}), (k, lower, upper))
    if isinstance(value, Piecewise):  # beside it stand single values, as x = 1, and divergence
        usual = (branch for branch, where in value.args if not isinstance(where, Eq))
        value = next(usual, value)
    if value.has(Sum, Product, Piecewise, sympy.oo, sympy.nan, sympy.zoo):
        raise UnclearError("a series whose value is not found")
    return value


def _joined(terms: Sequence[Expr], sign: str) -> Expr:
    return sympy.Add(*terms) if sign == "Σ" else sympy.Mul(*terms)
