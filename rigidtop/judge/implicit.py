"""What a letter nearly is that only an equation fixes: Ω ≈ M g R/(λ₃ ω₃) for a fast top."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray
from sympy import Add, Expr, Integer, Symbol

from rigidtop.judge.context import Constraint, Context
from rigidtop.judge.jets import operations
from rigidtop.judge.orders import LONGEST, Scaling, nearly, share
from rigidtop.judge.question import Pair, Question, alone
from rigidtop.judge.sides import own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.tree.nodes import Letter

MATTERS = 3.0
"""Without a term that is written the equation holds at least so much worse."""

Scalings = Callable[[Question, Worlds], list[Scaling]]
"""What may be small or large where a question is asked."""


@dataclass(frozen=True, eq=False)
class Implicit:
    """An equation that fixes a letter, and the question where the other letters are free."""

    question: Question
    gap: Expr
    letter: Symbol
    rests_on: int

    def nearly_solved(self, right: Expr, scaled: Scalings) -> Scaling | None:
        """For what a value solves it nearly, each of its terms being needed for that."""
        terms = self._terms(right)
        free = self.question.of([(x, Integer(0)) for x in terms])
        worlds = free.worlds
        if not worlds.count:
            return None
        for scaling in scaled(free, worlds):
            if self._is_solved(terms, worlds, scaling) and self._needs_all(right, worlds, scaling):
                return scaling
        return None

    def _terms(self, right: Expr) -> list[Expr]:
        return [x.subs(self.letter, right) for x in Add.make_args(self.gap.expand())]

    def _is_solved(self, terms: Sequence[Expr], worlds: Worlds, scaling: Scaling) -> bool:
        """Whether the sum becomes small beside one of its terms, and that stands in it."""
        return any(
            nearly(-term, Add(*terms) - term, (), worlds, [scaling]) is not None for term in terms
        )

    def _needs_all(self, right: Expr, worlds: Worlds, scaling: Scaling) -> bool:
        """Whether it holds worse without any one of the terms."""
        parts = Add.make_args(right.expand()) if operations(right) < LONGEST else (right,)
        if len(parts) < 2:
            return True
        whole = self._share(right, worlds, scaling)
        others = [self._share(right - part, worlds, scaling) for part in parts]
        return all(bool((other > MATTERS * whole).all()) for other in others)

    def _share(self, right: Expr, worlds: Worlds, scaling: Scaling) -> NDArray[np.float64]:
        """How large the sum is at the last step beside each of its terms, at best."""
        terms = self._terms(right)
        shares = [share(-x, Add(*terms) - x, worlds, scaling) for x in terms]
        return np.asarray(np.min(shares, axis=0), float)


def implicit(question: Question) -> Iterator[Implicit]:
    """The equations that fix the letter on the left, the latest first."""
    letter, context = question.left, question.context
    if not isinstance(letter, Letter) or question.at.instant:
        return
    letter = replace(letter, sub=letter.sub.strip("+-−±∓"))  # one of its roots
    if letter in context.definitions:
        return
    stated = (*context.constraints, *context.followed)
    for each in sorted(stated, key=lambda c: -c.number):
        if letter in own_letters(each.left) | own_letters(each.right) and not each.instant:
            for free in _freed(context):
                with suppress(UnclearError):
                    found = _solvable(replace(question.within(free), left=letter), letter, each)
                    if found is not None:
                        yield found


def _freed(context: Context) -> tuple[Context, Context]:
    """The context without what holds, and without what letters stand for, too."""
    bare = context.without_equations()
    return bare, replace(bare, definitions={})


def _solvable(question: Question, letter: Letter, equation: Constraint) -> Implicit | None:
    """The equation, where it has the letter in more than one way and not its rate."""
    meaning, x = question.meaning(), alone(letter)
    gap = meaning.scalar(equation.left) - meaning.scalar(equation.right)
    if not gap.has(x) or gap.diff(x, 2) == 0 or question.moves(gap):
        return None
    return Implicit(question, gap, x, equation.number)


def solves_nearly(each: Implicit, scaled: Scalings, both: Sequence[Pair], _: Worlds) -> bool:
    """Whether the right sides solve an equation nearly: what slips are compared by."""
    return all(
        left == each.letter and each.nearly_solved(right, scaled) is not None
        for left, right in both
    )
