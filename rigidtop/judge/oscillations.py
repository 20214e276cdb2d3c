"""Frequencies and periods: are they those of the oscillation that stands above?"""

from __future__ import annotations

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import replace
from functools import partial

from sympy import Expr, pi, sqrt

from rigidtop.judge.context import LAW, LetterDefinition
from rigidtop.judge.faults import multiple, slip
from rigidtop.judge.jets import jets, symbol
from rigidtop.judge.letters import FREQUENCIES, PERIODS
from rigidtop.judge.outcome import DEFINITION, PREMISE, SAMPLED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant
from rigidtop.judge.worlds import Worlds
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node


def with_meaning(question: Question, judgement: Judgement) -> Judgement:
    """What becomes of a new frequency or period, where an oscillation stands above.

    It follows from that; where words speak of it, it may have a slip.
    """
    outcome, context = judgement
    if outcome.verdict not in (DEFINITION, PREMISE) or question.at.instant:
        return judgement
    name = _named(question.left)
    if name is None or name in question.context.definitions:
        return judgement
    at = question.at
    if not at.oscillates and (name.base != "ω" or at.defined or at.supposed):
        return judgement  # with ω₀² = k/m
    squares = _squares(question, name)
    # Of several oscillations one without an index is the latest.
    for grounds, square in squares if name.sub else squares[-1:]:
        wide = question.of([*question.both, (square, square)])
        if _agrees(question, square, question.both, wide.worlds):
            rests_on = wide.rests_on | grounds
            return replace(outcome, verdict=SAMPLED, why="", rests_on=rests_on), context
    if squares and at.oscillates and not _is_of_another(question, name, squares[-1][1]):
        grounds, square = squares[-1]
        others = [(square, other) for _, other in squares]
        wide = question.of([*question.both, *others])
        if not (wide.worlds.holds(others) or _stands_above(question)):
            return judgement  # it may be that of another one
        wrong = slip(wide, partial(_agrees, question, square))
        told = wrong.outcome if wrong is not None else _multiple(question, square)
        if told is not None:
            value = Meant(sqrt(_wanted(question, square)[0]))
            righted = LetterDefinition(value, at.number, at.scope)
            known = question.context.defining(name, righted)
            return replace(told, rests_on=wide.rests_on | grounds), known
    return judgement


def _is_of_another(question: Question, name: Letter, square: Expr) -> bool:
    """Whether it is of something else, as that of what has been said to oscillate has a name.

    So is τ₁ with J + J₁ beside τ with J, and the Ω of an energy beside ω.
    """
    kinds = (PERIODS, _TURNS_A_SECOND, FREQUENCIES - _TURNS_A_SECOND)
    kind = next(x for x in kinds if name.base in x)
    wanted = {PERIODS: 4 * pi**2 / square, _TURNS_A_SECOND: square / (4 * pi**2)}.get(kind, square)
    context = question.context
    for x in {*context.definitions, *context.letters} - {name}:
        if x.base in kind:
            with suppress(UnclearError):
                value = question.meaning().scalar(x)
                if question.of([(value**2, wanted)]).holds():
                    return True
    return False


_TURNS_A_SECOND = frozenset("fνn")
"""Letters of how often something oscillates in a second."""


def _stands_above(question: Question) -> bool:
    """Whether the statement before is the latest equation of motion."""
    context = question.context
    latest = context.accelerations[-1] if context.accelerations else None
    return latest is not None and context.said[:2] == (latest.left, latest.right)


def _multiple(question: Question, square: Expr) -> Outcome | None:
    """What is wrong with a right side that is a simple multiple of what it should be."""
    wanted = _wanted(question, square)[0]
    value = wanted if isinstance(question.left, n.Power) else sqrt(wanted)
    return multiple(question.of([(value, right) for _, right in question.both]))


def _squares(question: Question, name: Letter) -> list[tuple[frozenset[int], Expr]]:
    """The squares of the frequencies with which what stands above oscillates, with what says so.

    Those of the letter of which the name has the index, if it has one: ω_x.
    """
    own = [x for x in question.moving if x.base == name.sub]
    squares = []
    for gap, rests_on in equations_of_motion(question, own):
        square = _square(gap, question)
        if square is not None:
            squares.append((rests_on, square))
    return squares


def equations_of_motion(
    question: Question, own: Sequence[Letter] = ()
) -> list[tuple[Expr, frozenset[int]]]:
    """What vanishes by the equations of motion above, or by laws, with what says so.

    If letters are its `own`, only the equations of their accelerations.
    """
    equations = []
    for each in question.context.accelerations:
        with suppress(UnclearError):
            nodes = [x for side in (each.left, each.right) for x in n.walked(side)]
            moved = [x.of for x in nodes if isinstance(x, n.TimeDerivative) and x.order == 2]
            if own and not any(x in own for x in moved):
                continue
            meaning = question.meaning(held=frozenset(x for x in moved if isinstance(x, Letter)))
            gap = meaning.scalar(each.left) - meaning.scalar(each.right)
            equations.append((gap, frozenset({each.number})))
    laws = [(x.expression, x.rests_on) for x in question.pool if x.kind == LAW]
    return equations or laws


def _square(gap: Expr, question: Question) -> Expr | None:
    """The square of the frequency of an equation of one letter; None where it is none."""
    moving = [x for x in jets(gap).values() if x.order or x.letter in question.moving]
    places = {replace(x, order=0) for x in moving}
    if len(places) != 1 or max(x.order for x in moving) != 2:
        return None
    [place] = places
    q, rate, acceleration = (symbol(replace(place, order=k)) for k in range(3))
    linear = all(gap.diff(x, y) == 0 for x in (q, rate, acceleration) for y in (q, rate))
    rest = dict.fromkeys((q, rate, acceleration), 0)
    here = gap.subs(rest)
    small = linear or (question.at.small and question.of([(here, 0 * here)]).holds())
    if gap.diff(rate).subs(rest) != 0 or not small:
        return None
    inertia, stiffness = (gap.diff(x).subs(rest) for x in (acceleration, q))
    return stiffness / inertia if inertia != 0 != stiffness else None


def _agrees(question: Question, square: Expr, both: Sequence[Pair], worlds: Worlds) -> bool:
    """Whether the right side is the frequency, or the period, or its square."""
    left, right = both[0]
    if left != question.both[0][0]:
        return False
    value = right if isinstance(question.left, n.Power) else right**2
    return any(worlds.holds([(value, x)]) for x in _wanted(question, square))


def _wanted(question: Question, square: Expr) -> list[Expr]:
    """What the square of a frequency, or of a period, may be."""
    name = _named(question.left)
    assert name is not None
    wanted = [4 * pi**2 / square] if name.base in PERIODS else [square]
    return wanted + ([square / (4 * pi**2)] if name.base in _TURNS_A_SECOND else [])


def _named(side: Node) -> Letter | None:
    """The letter of a frequency or a period that a side, or its root, is."""
    name = side.base if isinstance(side, n.Power) and side.exponent == n.Number("2") else side
    letters = FREQUENCIES | PERIODS
    return name if isinstance(name, Letter) and name.base in letters else None
