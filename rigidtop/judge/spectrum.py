"""Roots with an index: frequencies of what oscillates in several ways, and eigenvalues."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property, partial

import numpy as np
import sympy
from sympy import Dummy, Expr, I, ImmutableMatrix, PolynomialError, Symbol, fraction, together

from rigidtop.judge import worlds as w
from rigidtop.judge.faults import slip
from rigidtop.judge.jets import Jet, jets, symbol
from rigidtop.judge.letters import FREQUENCIES
from rigidtop.judge.oscillations import equations_of_motion
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.question import Judgement, Pair, Question, alone
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter

MOST_WAYS = 4
"""Of what can move in more ways no frequencies are worked out."""


@dataclass(frozen=True, eq=False)
class Secular:
    """What vanishes where `unknown` is one of several roots, and the statements that say so."""

    unknown: Symbol
    gap: Expr
    rests_on: frozenset[int]

    def at(self, root: Expr) -> Expr:
        return self.gap.subs(self.unknown, root)

    @cached_property
    def _powers(self) -> list[int]:
        """The powers of the unknown in it; none where it is no polynomial."""
        over, _ = fraction(together(self.gap))
        try:
            return [int(power) for (power,) in sympy.Poly(over, self.unknown).monoms()]
        except PolynomialError:
            return []

    @property
    def is_even(self) -> bool:
        """Whether with each root its negative is one."""
        return all(power % 2 == 0 for power in self._powers)

    @property
    def roots(self) -> int:
        """How many roots of either sign it has; 0 where it is no polynomial."""
        highest = max(self._powers, default=0)
        return highest // 2 if self.is_even else highest


def with_meaning(question: Question, judgement: Judgement) -> Judgement:
    """What becomes of a new letter with an index that may be one root of what stands above.

    It follows where it is one; where words say that it comes out it may have a slip.
    """
    outcome, context = judgement
    name = _named(question)
    if outcome.verdict not in (DEFINITION, PREMISE) or name is None:
        return judgement
    if question.at.cues & {Cue.ELSEWHERE, Cue.OTHER}:
        return judgement
    with suppress(UnclearError, UnknownFunctionError):
        for each in _equations(question, name):
            if name.sub.isdigit() and int(name.sub) > each.roots:
                continue  # it has no such root
            wide = question.of([*question.both, (each.gap, each.gap)])
            if _is_root(question, each, question.both, wide.worlds):
                rests_on = wide.rests_on | each.rests_on
                return replace(outcome, verdict=SAMPLED, why="", rests_on=rests_on), context
            if each.roots < 2 or Cue.SEVERAL not in question.at.cues:
                continue
            wrong = slip(wide, partial(_is_root, question, each))
            if wrong is not None:
                told = replace(wrong.outcome, rests_on=wide.rests_on | each.rests_on)
                return told, wrong.context
    return judgement


_INDICES = frozenset({*"1234+-", "I", "II"})
"""Indices that number roots."""


def _named(question: Question) -> Letter | None:
    """The letter with an index that the left side, or its root, is, if it is a new one."""
    left, at = question.left, question.at
    name = left.base if isinstance(left, n.Power) and left.exponent == n.Number("2") else left
    if not isinstance(name, Letter) or name.bold or name.sub not in _INDICES:
        return None
    named = at.instant or question.inner or at.supposed or at.defined
    return None if named or name in question.context.definitions else name


def _equations(question: Question, name: Letter) -> Iterator[Secular]:
    yield from _written(question, replace(name, sub=""))
    if name.base in FREQUENCIES and (name.base == "ω" or Cue.OSCILLATION in question.at.cues):
        moving = _of_motion(question)
        if moving is not None:
            yield moving


def _written(question: Question, bare: Letter) -> Iterator[Secular]:
    """What is said above of the letter without its index, if it is left open: the latest first."""
    context, x = question.context, alone(bare)
    if bare in context.definitions or bare not in context.letters or bare in question.moving:
        return
    meaning = question.meaning()
    for each in reversed([*context.constraints, *context.followed]):
        if each.instant or bare not in each.letters:
            continue
        with suppress(UnclearError):
            gap = meaning.scalar(each.left) - meaning.scalar(each.right)
            if gap.has(x) and not question.moves(gap) and gap.diff(x, x) != 0:
                yield Secular(x, gap, frozenset({each.number}))


def _of_motion(question: Question) -> Secular | None:
    """The determinant of linear equations of motion, for a frequency; None where they are none."""
    equations = equations_of_motion(question)
    gaps = [gap for gap, _ in equations]
    places = sorted(
        {
            jet.letter
            for gap in gaps
            for jet in jets(gap).values()
            if jet.order == 2 and jet.letter in question.moving
        },
        key=str,
    )
    if not 1 < len(places) <= MOST_WAYS or len(gaps) != len(places):
        return None
    rows = [[symbol(Jet(x, order)) for x in places] for order in range(3)]
    rest = {x: 0 for row in rows for x in row}
    linear = all(gap.diff(x, y) == 0 for gap in gaps for x in rest for y in rest)
    here = [(gap.subs(rest), sympy.S.Zero) for gap in gaps]
    if not linear and not (question.at.small and question.of(here).holds()):
        return None
    stiffness, damping, inertia = (
        ImmutableMatrix([[gap.diff(x).subs(rest) for x in row] for gap in gaps]) for row in rows
    )
    x = Dummy("x")
    determinant = (stiffness + I * x * damping - x**2 * inertia).det(method="berkowitz")
    rests_on = frozenset().union(*(rests_on for _, rests_on in equations))
    return Secular(x, determinant, rests_on)


def _is_root(question: Question, each: Secular, both: Sequence[Pair], worlds: Worlds) -> bool:
    """Whether the right side is a root, and not each number is one."""
    left, right = both[0]
    if left != question.both[0][0] or len(both) > len(question.both) + 1:
        return False
    root = sympy.sqrt(right) if isinstance(question.left, n.Power) else right
    other = each.at(root * sympy.Rational(7, 5))
    if not worlds.holds([(each.at(root), 0 * root)]) or worlds.vanish([other]):
        return False
    cues = question.at.cues & {Cue.LEAST, Cue.GREATEST}
    return not cues or _is_last(each, root, worlds, Cue.GREATEST in cues)


def _is_last(each: Secular, root: Expr, worlds: Worlds, greatest: bool) -> bool:
    """Whether a root is the greatest one, or the least one, in every world."""
    over, _ = fraction(together(each.gap))
    coefficients = sympy.Poly(over, each.unknown).all_coeffs()
    values = worlds.program.values([root, *coefficients]).values
    for own, *column in values.T:
        roots = np.abs(np.roots(column)) if each.is_even else np.roots(column).real
        last = roots.max() if greatest else roots.min()
        if abs(own.real - last) > w.CLOSE * abs(last):
            return False
    return True
