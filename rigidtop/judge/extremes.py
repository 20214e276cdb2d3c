"""Greatest and least values, as letters such as x_max name them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import suppress
from dataclasses import replace

import numpy as np
from sympy import Expr, MatrixBase, Symbol

from rigidtop.judge.context import SETTING, Constraint
from rigidtop.judge.jets import TIME, jets
from rigidtop.judge.letters import ANGLES
from rigidtop.judge.program import Program
from rigidtop.judge.quantity import Quantity
from rigidtop.judge.question import Question
from rigidtop.judge.sides import ZERO, own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant
from rigidtop.judge.worlds import symbols_of
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain as in_words

_MOST_TIMES, _LONGEST = 6001, 30.0
_NEAR = 1e-4
"""A greatest value is known to this share of it."""


def quantities(question: Question, letter: Letter) -> Iterator[Quantity]:
    """The greatest or the least value of what has the same base, or one where a slope vanishes."""
    base, context = replace(letter, sub=""), question.context
    if base not in context.definitions:
        return
    words = f"an extreme value of {in_words(base)}"
    with suppress(UnclearError):
        value = question.meaning().value(base)
        right = question.meaning().scalar(question.right)
        if isinstance(value, MatrixBase):
            return
        for x in _runs(value, question):
            which = letter.sub if letter.sub in ("max", "min") else ""
            if not right.has(x) and _is_extreme(value, right, x, which):
                yield Quantity(words, Meant(right))
                return
        for x in sorted(own_letters(context.definitions[base].node), key=str):
            if x not in own_letters(question.right) and _is_flat(question, base, x, letter.sub):
                yield Quantity(words, Meant(right))
                return


def _is_flat(question: Question, base: Letter, x: Letter, which: str) -> bool:
    """Whether the right side is what a letter is where its slope vanishes, as it bends there."""
    at, context = question.at, question.context
    slope = n.Derivative(base, (x,))
    there = context.holding(Constraint(slope, ZERO, at.number, SETTING, at.scope))
    asked = replace(question.within(there), left=base, asked=None)
    if not asked.worlds.count or not asked.holds():
        return False
    signs = asked.worlds.signs([asked.meaning().scalar(n.Derivative(base, (x, x)))])
    wanted = _BENDS.get(which, (-1, 1))
    return signs is not None and any(bool((signs == sign).all()) for sign in wanted)


_BENDS = {"max": (-1,), "top": (-1,), "min": (1,)}
"""How something bends at its greatest value, and at its least one."""


def _runs(value: Expr, question: Question) -> list[Symbol]:
    """What a value changes with: the time, or an angle."""
    angles = (x for x, jet in jets(value).items() if jet.letter.base in ANGLES and not jet.order)
    return [TIME] if value.has(TIME) else sorted(angles, key=str)


def _is_extreme(value: Expr, right: Expr, x: Symbol, which: str) -> bool:
    """Whether a number is the greatest or the least value, or the one of them that is asked."""
    others = symbols_of([value - x, right])
    span = np.linspace(0, _LONGEST if x == TIME else 2 * np.pi, _MOST_TIMES)
    for seed in range(_TRIALS):
        rng = np.random.default_rng(seed)
        points = np.tile(rng.uniform(0.2, 0.9, (len(others), 1)), (1, len(span)))
        rows = [span if each == x else row for each, row in zip(others, points, strict=True)]
        at = Program(others, np.array(rows, complex)).values([value, right]).values.real
        extremes = [at[0].max()] * (which != "min") + [at[0].min()] * (which != "max")
        if not np.isfinite(at).all() or not np.isclose(at[1, 0], extremes, _NEAR, 0).any():
            return False
    return True


_TRIALS = 3
