"""A motion that begins where nothing changes: there it stays."""

from __future__ import annotations

from dataclasses import replace

from sympy import Expr, Integer

from rigidtop.judge.context import SETTING, Context
from rigidtop.judge.jets import TIME, rate
from rigidtop.judge.question import Question
from rigidtop.judge.values import UnclearError, pairs


def staying(question: Question) -> Context | None:
    """What is known if all that is said of an instant holds always; None if it may change.

    It stays if its rates vanish wherever it holds, as long as no law names the time.
    """
    context = question.context
    if question.at.instant or question.asked is not None:
        return None
    if any(each.expression.has(TIME) for each in question.pool):
        return None
    for instant in dict.fromkeys(c.instant for c in context.constraints if c.instant):
        facts = [c for c in context.constraints if c.instant == instant]
        gaps: list[Expr] = []
        try:
            for each in facts:
                meaning = question.meaning()
                both = pairs(meaning.value(each.left), meaning.value(each.right))
                gaps += [left - right for left, right in both]
            rates = [question.then(rate(gap, question.moving), instant) for gap in gaps]
        except UnclearError:
            continue
        there = replace(question, deep=True).of([(each, Integer(0)) for each in rates])
        if there.worlds.count and there.worlds.holds(there.both):
            kept = tuple(c for c in context.constraints if c.instant != instant)
            always = (replace(each, instant="", kind=SETTING) for each in facts)
            return replace(context, constraints=(*kept, *always))
    return None
