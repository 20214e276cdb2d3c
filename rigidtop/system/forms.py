"""Forms of expressions that are short: without `simplify`, each by what it is good for."""

from __future__ import annotations

from collections.abc import Sequence

import sympy
from sympy import Expr, Integer, Matrix, Symbol

from rigidtop.theory.trig import reduce_ratio, reduce_trig

LARGEST = 4000
"""Operations in an expression up to which a normal form is tried, to see whether it is shorter."""

FACTORED = 200
"""Operations in a coefficient up to which it is factored."""

PRINTED = 150
"""Operations in a result up to which it is brought to lowest terms, to be read."""

CRAMER = 3
"""Rows of a part of the mass matrix up to which determinants are written out."""


def short(value: Expr) -> Expr:
    """The shortest of the normal forms of a trigonometric polynomial."""
    forms = [value]
    for keep in ("cos", "sin"):
        reduced = reduce_trig(value, keep)
        forms += [reduced, sympy.factor_terms(reduced)]
    return min(forms, key=lambda form: form.count_ops())


def expanded(value: Expr) -> Expr:
    """A sum of terms, as few as sin² + cos² = 1 allows."""
    forms = [sympy.expand(value), reduce_trig(value), reduce_trig(value, "sin")]
    return min(forms, key=lambda form: form.count_ops())


def grouped(value: Expr, velocities: Sequence[Symbol]) -> Expr:
    """Collected in the velocities, each coefficient in factors: what is in all masses goes out."""
    terms: dict[Expr, list[Expr]] = {}
    for term in sympy.Add.make_args(reduce_trig(value)):
        rates, rest = term.as_independent(*velocities, as_Add=False)[::-1]
        terms.setdefault(rates, []).append(rest)
    groups = []
    for rates, coefficients in terms.items():
        total = sympy.Add(*coefficients)
        if total.count_ops() < FACTORED and total.is_polynomial(*total.atoms(sympy.sin, sympy.cos)):
            total = sympy.factor(total)
        groups.append(rates * total)
    return sympy.factor_terms(sympy.Add(*groups))


def readable(value: Expr) -> Expr:
    """The value in lowest terms, as far as that is quick; it is the same in any case."""
    if value.count_ops() > PRINTED:
        return value
    return min((value, reduce_ratio(value), short(value)), key=lambda form: form.count_ops())


def parts_of(matrix: Matrix) -> list[list[int]]:
    """The rows that hang together, in order: a matrix of blocks falls apart."""
    left, parts = list(range(matrix.rows)), []
    while left:
        part = [left.pop(0)]
        for k in part:
            part += [j for j in left if matrix[k, j] != 0]
            left = [j for j in left if j not in part]
        parts.append(sorted(part))
    return parts


def over(mass: Matrix, right: Sequence[Expr]) -> tuple[Expr, ...]:
    """M⁻¹ times a column, to be read: by Cramer's rule, part by part.

    Nothing where a part of M that does not fall apart is large.
    """
    mass = mass.applyfunc(short)
    column = dict.fromkeys(range(mass.rows), Integer(0))
    for part in parts_of(mass):
        if len(part) > CRAMER:
            return ()
        own = mass.extract(part, part)
        above = own.adjugate() * Matrix([short(right[k]) for k in part])
        below = short(own.det(method="berkowitz"))
        column |= {k: short(x) / below for k, x in zip(part, above, strict=True)}
    return tuple(column.values())
