"""Sides of which one is said to be no smaller than the other."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from rigidtop.judge.context import SETTING, Bound, Constraint
from rigidtop.judge.faults import slip
from rigidtop.judge.numbers import are_numbers
from rigidtop.judge.outcome import FALSE, PREMISE, SAMPLED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Node


def judged(question: Question) -> Judgement:
    """The outcome of left ≥ right; raises UnclearError.

    Beside the text it is a condition.  It follows if it is the same bound as one that is known:
    both are reached together.  Directly behind one it is wrong the other way round.
    """
    context, at = question.context, question.at
    condition = Outcome(PREMISE, "a condition")
    bound = Bound(question.left, question.right, at.number)
    if at.inline:
        return condition, context.opposing(bound)
    bounded = replace(context, bounds=(*context.bounds, bound))
    if len(question.meant) != 1 or all(are_numbers(*pair) for pair in question.meant):
        return condition, context
    if at.supposed:
        return condition, bounded
    for each in reversed(context.bounds):
        left, right = each.greater, each.less
        known = _known(question, left, right)
        if known is None:
            continue
        reached = Constraint(left, right, at.number, SETTING, at.scope)
        edge = question.of(question.both, context.holding(reached))
        same = partial(_is_same, question, edge, known)
        if same(question.both, edge.worlds):
            return Outcome(SAMPLED, "", edge.rests_on), bounded
        directly = at.number - each.number == 1
        if directly and same([pair[::-1] for pair in question.both], edge.worlds):
            turned = f"{latex(question.left)} \\leq {latex(question.right)}"
            words = "the relation turned round"
            why = "it holds the other way round"
            return Outcome(FALSE, why, edge.rests_on, words, turned), context
        wrong = slip(question, same, "\\geq") if edge.worlds.count else None
        if wrong is not None:
            return wrong.outcome, context
    return condition, bounded


def _known(question: Question, left: Node, right: Node) -> Pair | None:
    try:
        both = question.sides(question.meanings(), left, right)
    except UnclearError:
        return None
    return both[0] if len(both) == 1 else None


def _is_same(
    question: Question, edge: Question, known: Pair, both: Sequence[Pair], _: Worlds
) -> bool:
    """Whether sides are equal where a known bound is reached, and differ in the same sense."""
    if not edge.worlds.holds(both):
        return False
    free = question.of([*both, known])
    signs = free.worlds.signs([a - b for a, b in (*both, known)])
    return signs is not None and bool((signs[0] == signs[1]).all())
