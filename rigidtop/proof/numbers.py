"""Printed trees in numbers: what refutes at once, and shows nothing.

Each letter, and each atom that is none, has a number of its own at a few places.  A tree is then a
number at each of them, that of a vector one for each of its atoms.  Equations that are no multiples
of each other there are none at all; where they are, only normal forms tell.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import pairwise

import sympy
from sympy import Add, Expr, Mul

from rigidtop.proof import decide
from rigidtop.proof.algebra import ELLIPTIC, Algebra, Value, Vector, flattened
from rigidtop.proof.equation import Equation, Group, NoMeaningError, Printed, Underbrace
from rigidtop.proof.moves import Pair
from rigidtop.theory.symbols import const

Row = list[float]
"""A number for each place; NaN where there is none."""

Rows = dict[Expr, Row]
"""A row for each atom of a vector or each entry of a matrix; of a scalar one, under `SCALAR`."""

SCALAR = "scalar"
PLACES = 5


class UnsureError(Exception):
    """What has no numbers: operators, a sum of what can't be added."""


@dataclass(frozen=True, eq=False)
class Numbers:
    """The numbers of trees, what an algebra knows being put in, beside those of `made`.

    What is asked for again is kept.
    """

    algebra: Algebra
    made: Sequence[Pair]
    kept: dict[Expr, Rows] = field(default_factory=dict)

    def refute(self, equation: Equation) -> bool:
        """Whether numbers tell that an equation is no multiple of any of the pairs.

        One that holds whatever its letters are is none either, but says nothing: that is left open.
        What has no meaning is refuted.
        """
        try:
            return any(
                not gap.vanishes and not any(map(gap.may_be_multiple, self._theirs))
                for gap in self._gaps(equation)
            )
        except UnsureError:
            return False
        except NoMeaningError:
            return True

    @cached_property
    def _theirs(self) -> list[_Gap]:
        return [_Gap(self.of(p.left), self.of(p.right)) for p in self.made]

    def _gaps(self, equation: Equation) -> Iterator[_Gap]:
        if const in equation.sides:
            raise UnsureError
        for left, right in pairwise(equation.sides):
            yield _Gap(self.value(left), self.value(right))

    def value(self, node: Expr) -> Rows:
        """The numbers of a printed tree.  Raises UnsureError, or NoMeaningError."""
        if isinstance(node, (Group, Underbrace)):
            return self.value(node.args[0])
        if isinstance(node, Add):
            return _total([self.value(part) for part in node.args])
        if isinstance(node, Mul):
            return _product([self.value(part) for part in node.args])
        of = decide.FUNCTIONS.get(node.func)
        if of is not None and not isinstance(node, Printed):
            arguments = zip(*map(_scalar, map(self.value, node.args)), strict=True)
            return {SCALAR: [decide.defined(of, *at) for at in arguments]}
        if node not in self.kept:
            self.kept[node] = self.of(self.algebra.value(node))
        return self.kept[node]

    def of(self, value: Value) -> Rows:
        """The numbers of a value of the algebra."""
        if isinstance(value, Vector):
            return {atom: self._row(factor) for atom, factor in value.terms.items()}
        if isinstance(value, sympy.MatrixBase):
            return {k: self._row(entry) for k, entry in enumerate(value)}
        return {SCALAR: self._row(value)}

    def _row(self, expression: Expr) -> Row:
        if not expression.is_commutative:
            raise UnsureError
        flat, names = flattened(expression)
        for node in flat.atoms(*ELLIPTIC):
            stand_in = sympy.Dummy()
            flat, names = flat.xreplace({node: stand_in}), {**names, stand_in: node}
        return [decide.values([flat], attempt, names)[0] for attempt in range(PLACES)]


class _Gap:
    """Left less right, and the size of what is subtracted."""

    def __init__(self, left: Rows, right: Rows) -> None:
        if (SCALAR in left) != (SCALAR in right) and any(
            any(rows[SCALAR]) for rows in (left, right) if SCALAR in rows
        ):
            raise UnsureError  # only 0 fits every kind
        zero = [0.0] * PLACES
        keys = {*left, *right} - ({SCALAR} if len({*left, *right}) > 1 else set())
        pairs = {key: (left.get(key, zero), right.get(key, zero)) for key in keys}
        self.gaps = {k: [a - b for a, b in zip(*p, strict=True)] for k, p in pairs.items()}
        self.size = [
            1 + sum(abs(a[n]) + abs(b[n]) for a, b in pairs.values()) for n in range(PLACES)
        ]
        self.places = [n for n in range(PLACES) if math.isfinite(self.size[n])]

    @property
    def vanishes(self) -> bool:
        """Whether it is nothing, as far as numbers tell."""
        return all(
            decide.holds("=", row[n], self.size[n])
            for row in self.gaps.values()
            for n in self.places
        )

    def may_be_multiple(self, other: _Gap) -> bool:
        """Whether it is the other one times one number, as far as numbers tell."""
        places = [n for n in self.places if n in other.places]
        if len(places) < 2:
            return True
        entries = [
            (self.gaps.get(k, [0.0] * PLACES)[n], other.gaps.get(k, [0.0] * PLACES)[n], n)
            for k in {*self.gaps, *other.gaps}
            for n in places
        ]
        top, below, _ = max(entries, key=lambda found: abs(found[1]))
        if below == 0:
            return False
        factor = top / below
        return all(
            abs(a - factor * b)
            <= 1e3 * decide.TOLERANCE * (self.size[n] + abs(factor) * other.size[n])
            for a, b, n in entries
        )


def _scalar(rows: Rows) -> Row:
    if [*rows] != [SCALAR]:
        raise UnsureError
    return rows[SCALAR]


def _total(parts: Sequence[Rows]) -> Rows:
    made: Rows = {}
    for part in parts:
        for key, row in part.items():
            old = made.get(key)
            made[key] = row if old is None else [a + b for a, b in zip(old, row, strict=True)]
    if SCALAR in made and len(made) > 1 and any(made.pop(SCALAR)):
        raise UnsureError  # only 0 fits every kind
    return made


def _product(parts: Sequence[Rows]) -> Rows:
    made: Rows = {SCALAR: [1.0] * PLACES}
    for part in parts:
        if SCALAR not in made and SCALAR not in part:
            raise UnsureError
        made = {
            b if a == SCALAR else a: [x * y for x, y in zip(p, q, strict=True)]
            for a, p in made.items()
            for b, q in part.items()
        }
    return made
