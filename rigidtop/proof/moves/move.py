"""What a move is: what is cited, what is done with it, what comes of it, and why it is refused."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from enum import IntEnum
from itertools import islice
from typing import Any

import sympy
from sympy import Expr, Symbol
from sympy.core.function import PoleError

from rigidtop.proof.algebra import Algebra
from rigidtop.proof.equation import Equation
from rigidtop.proof.values import Value, vanishes
from rigidtop.theory.rates import slopes_at_zero


class RefusedError(Exception):
    """A move that can't be made, and why: `nodes` stand where the message has braces."""

    def __init__(self, message: str, *nodes: Any) -> None:
        super().__init__(message, *nodes)
        self.message, self.nodes = message, nodes

    def __str__(self) -> str:
        return self.words()

    def words(self, said: Callable[[Any], str] = str) -> str:
        """The message, what stands in it printed by `said`."""
        return self.message.format(*(x if isinstance(x, str) else said(x) for x in self.nodes))


class Scope(IntEnum):
    """Where an equation holds; what rests on several holds where all of them do."""

    IDENTITY = 0
    """For all coordinates and velocities: it may be differentiated by either."""
    MOTION = 1
    """Along the motion: it may be differentiated in time."""
    SET = 2
    """Where something is set, at a moment: it may not be differentiated."""


@dataclass(frozen=True)
class Order:
    """What is neglected is of this order in a small letter: ``Order(epsilon, 2)`` is O(ε²).

    Letters that are small together are counted together: each is as small as `small`.
    """

    small: Symbol
    power: int
    together: tuple[Symbol, ...] = ()

    @property
    def letters(self) -> tuple[Symbol, ...]:
        """The letters that are small."""
        return self.together or (self.small,)

    def counted(self, expression: Expr) -> Expr:
        """An expression with `small` before each of the letters that are small together."""
        return expression.xreplace({x: self.small * x for x in self.together})

    def lowest(self, expression: Expr) -> int:
        """The power of what is small with which an expression begins.

        Raises RefusedError where it begins with none that is known.
        """
        counted = self.counted(expression)
        if not counted.has(self.small):
            return 0
        for power in counted.atoms(sympy.Pow):
            if power.has(self.small) and not power.exp.is_number:
                raise RefusedError("of {} no order in {} is known", power, self.small)
        try:
            slopes = slopes_at_zero(counted, self.small)
            for power, at in enumerate(islice(slopes, max(self.power, 0) + 1)):
                if not vanishes(at):
                    return power
            _, power = counted.as_leading_term(self.small).as_coeff_exponent(self.small)
            return int(sympy.floor(power))
        except (PoleError, NotImplementedError, TypeError, ValueError):
            raise RefusedError("of {} no order in {} is known", expression, self.small) from None


@dataclass(frozen=True)
class Condition:
    """What has to hold besides: `expression` ≠, >, ≥ or = 0, ≪ 1, 0 at the "start", or "large".

    So is "small" what has to be small.

    `lost`: a branch ends there.
    """

    expression: Expr
    relation: str = "≠"
    lost: bool = False


SIZES = ("small", "large")
"""Relations that say of what size something is."""


@dataclass(frozen=True)
class Pair:
    """Two values with a relation between them."""

    left: Value
    right: Value
    relation: str = "="

    @property
    def sides(self) -> tuple[Value, Value]:
        return self.left, self.right

    def valued(self, algebra: Algebra) -> Pair:
        """With what an algebra knows put in."""
        return replace(self, left=algebra.value(self.left), right=algebra.value(self.right))


@dataclass(frozen=True)
class Known:
    """Equations that may be cited: a law, a definition, a line that stands.

    `called` is what sentences call it; `defines` is the letter that it introduces.  Of numbers that
    are `tied`, such as by k = mω², one can't change while the others stay.
    """

    id: str
    equations: tuple[Equation, ...]
    scope: Scope = Scope.IDENTITY
    conditions: tuple[Condition, ...] = ()
    order: Order | None = None
    called: str = ""
    defines: Symbol | None = None
    tied: frozenset[Symbol] = frozenset()

    @property
    def tag(self) -> str:
        return next((e.tag for e in self.equations if e.tag), "")

    @property
    def sizes(self) -> dict[Expr, str]:
        """What has to be "small" or "large" where they hold, as letters."""
        small = self.order.letters if self.order is not None else ()
        told = {c.expression: c.relation for c in self.conditions if c.relation in SIZES}
        return {**dict.fromkeys(small, "small"), **told}


@dataclass(frozen=True)
class Move:
    """What a sentence says is done.

    `verb` names the move, `of` what it is done with, `using` what is put in besides.  `by` are
    expressions: a factor, a variable, axes, values.
    """

    verb: str
    of: tuple[Known, ...] = ()
    using: tuple[Known, ...] = ()
    by: tuple[Any, ...] = ()
    power: int = 0
    where: tuple[Condition, ...] = ()
    words: str = ""
    unnamed: bool = False
    """Whether the words mean the line above without naming it, as "differentiate in time" does."""

    @property
    def cited(self) -> tuple[Known, ...]:
        return (*self.of, *(k for k in self.using if k not in self.of))

    @property
    def bounds(self) -> tuple[Condition, ...]:
        """What is positive where the cited equations hold."""
        return tuple(c for known in self.cited for c in known.conditions if c.relation == ">")

    @property
    def settings(self) -> tuple[Condition, ...]:
        """What has been set where the cited equations hold."""
        return tuple(c for known in self.cited for c in known.conditions if c.relation == "=")


@dataclass(frozen=True)
class Performed:
    """What a move arrives at.  `given` is put into the line as well, before they are compared."""

    pairs: tuple[Pair, ...]
    scope: Scope
    conditions: tuple[Condition, ...] = ()
    order: Order | None = None
    given: Mapping[Expr, Value] = field(default_factory=dict)
    every: bool = False
    """Whether the line has to show all pairs (both roots)."""
    tied: frozenset[Symbol] = frozenset()


def name_of(known: Known) -> str:
    """What a message calls an equation: its name, its number in brackets, or its id."""
    return known.called or (f"({known.tag})" if known.tag else known.id)


def the_one(move: Move) -> Known:
    """What a move is done with, where that is one equation.  Raises RefusedError."""
    if len(move.of) != 1:
        raise RefusedError("{} acts on one equation, not on {}", move.verb, str(len(move.of)))
    return move.of[0]


def the_factor(move: Move) -> Expr:
    """What a move is made by, such as a factor, where that is one thing.  Raises RefusedError."""
    if len(move.by) != 1:
        raise RefusedError("{} by one thing at a time, not by {}", move.verb, str(len(move.by)))
    return move.by[0]


def is_equation(pair: Pair) -> bool:
    """Whether two values are equal.  Raises RefusedError for another relation."""
    if pair.relation not in ("=", "≡"):
        raise RefusedError("a relation {} can't be treated so", pair.relation)
    return True
