"""A model: what the letters of a subject mean for the motions that its facts allow.

A line is right if it holds for every such motion, whatever its form.  Each symbol has a value in
terms of a few that are free, each of these a rate, and something may hold besides.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import cache
from typing import Any

import sympy
from sympy import Expr, Matrix, MatrixBase, Symbol, sin

from rigidtop.proof import floats
from rigidtop.proof.equation import BODY, Meaning, NoMeaningError, Rate, value
from rigidtop.theory.rates import total_derivative
from rigidtop.theory.symbols import const


@dataclass(frozen=True, eq=False)
class Model:
    """Values of symbols: `meaning` in terms of the state, `rates` of what changes in time.

    `limits` are put in afterwards, one mapping after the other: what holds for the special motion.
    `words` name it.  Where the facts allow other motions besides, `branch` has those.
    """

    words: str
    meaning: Meaning
    rates: Mapping[Symbol, Expr]
    limits: tuple[Mapping[Symbol, Expr], ...] = ()
    branch: tuple[Model, ...] = ()
    lost: Expr | None = None
    """What vanishes on the branch."""
    frame: Matrix | None = None
    """Rotational velocity of the axes along which vectors are given; None where it is not said."""
    omega: Matrix | None = None
    """Rotational velocity of the body, likewise."""
    timeless: bool = False
    """Nothing is said of time: no derivative has a meaning."""
    frozen: frozenset[Symbol] = frozenset()
    """Symbols whose rate is left out: for a derivative that forgets them."""
    along: bool = False
    """Whether its accelerations are those of the motion: an identity holds for any."""
    exists: Callable[[Mapping[Symbol, Expr]], bool] = floats.anything
    """Whether there is something with these numbers: a body with these moments."""

    def before_limits(self, node: Expr) -> Any:
        """The value of a typed tree for the general motion; NoMeaningError if it has none."""
        return value(node, {**self.meaning, **self._of_rates(node)})

    def value(self, node: Expr) -> Any:
        """The value of a typed tree: a scalar, a column or a matrix in the state's symbols."""
        return self.limited(self.before_limits(node))

    def rate(self, node: Expr) -> Any:
        """The value of d/dt of a typed tree."""
        return self.limited(self._derivative(self.before_limits(node)))

    def limited(self, found: Any) -> Any:
        """A value with what holds for the special motion put in."""
        found = sympy.sympify(found)
        for limit in self.limits:
            found = found.xreplace(dict(limit))
        return found

    def _of_rates(self, node: Expr) -> dict[Expr, Expr]:
        """The meaning of every rate in a tree, inner ones first."""
        found: dict[Expr, Expr] = {}
        sides = list(node) if isinstance(node, MatrixBase) else [node]
        rates = set().union(*(side.atoms(Rate) for side in sides))
        for rate in sorted(rates, key=lambda r: sympy.count_ops(r, visual=False)):
            if rate in self.meaning:
                continue
            inside = value(rate.args[0], {**self.meaning, **found})
            found[rate] = self._derivative(inside)
            if BODY in rate.args and isinstance(inside, MatrixBase):
                if self.omega is None:
                    raise NoMeaningError("a rate as seen from the body, but not how it rotates")
                found[rate] -= self.omega.cross(inside)
        return found

    def _derivative(self, expression: Expr) -> Any:
        """d/dt, of vectors as seen from space."""
        if self.timeless:
            raise NoMeaningError("a rate where nothing is said of time")
        kept = {x: rate for x, rate in self.rates.items() if x not in self.frozen}
        rate = total_derivative(sympy.sympify(expression), kept)
        if not isinstance(expression, MatrixBase):
            return rate
        if self.frame is None or expression.shape != (3, 1):
            raise NoMeaningError("a rate of a vector, but not as seen from where")
        return rate + self.frame.cross(expression)

    def symbols(self) -> set[Symbol]:
        """The symbols that have a value here, those of the state among them."""
        named = {x for x in self.meaning if isinstance(x, Symbol)}
        values = [sympy.sympify(v) for v in self.meaning.values()]
        return named | set().union(*(v.free_symbols for v in values)) | {*self.rates, const}


@dataclass(frozen=True)
class Sample:
    """A motion in numbers: the free symbols' short values, and in these every symbol."""

    point: Mapping[Symbol, Expr]
    facts: Meaning

    @property
    def meaning(self) -> Meaning:
        """The number that every symbol stands for at this point."""
        numbers = {x: number(v) for x, v in self.point.items()}
        return {k: number(sympy.sympify(v).xreplace(numbers)) for k, v in self.facts.items()}


DIGITS = 30


@cache
def samples(model: Model, count: int = 30) -> tuple[Sample, ...]:
    """Motions in numbers that the facts allow, short numbers first."""
    meaning = {
        key: model.limited(found) for key, found in model.meaning.items() if not callable(found)
    }
    for symbol in sorted(model.symbols() - set(meaning) - {const}, key=str):
        meaning[symbol] = model.limited(symbol)
    entries = (e for v in meaning.values() for e in (v if isinstance(v, MatrixBase) else [v]))
    flat = [sympy.sympify(e) for e in entries]
    free = sorted(set().union(*(e.free_symbols for e in flat)), key=str)
    angles = floats.angle_symbols(flat)
    # In digits, a sine that is zero would be divided by all the same.
    points = [
        point
        for point in floats.points(free, angles, 30 * count, model.exists)
        if all(sin(2 * point[x]) != 0 for x in angles & set(point))
    ]
    found: list[Sample] = []
    # The choice of numbers widens slowly: some of the first, some of the later ones.
    for point in points[:: max(1, len(points) // (3 * count))]:
        # Where something is divided by zero, the symbols do not describe the motion.
        if not any(map(math.isinf, map(floats.at(point), flat))):
            found.append(Sample(dict(point), meaning))
        if len(found) == count:
            break
    return tuple(found)


def number(found: Any) -> Any:
    """A value in digits; an angle stays exact, so that its sine may be exactly zero."""
    if isinstance(found, MatrixBase):
        return found.applyfunc(number)
    found = sympy.sympify(found)
    return found if (found / sympy.pi).is_Rational else sympy.N(found, DIGITS)
