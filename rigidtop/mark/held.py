"""Formulas of a text about a lecture, held against the models of that lecture.

Notes use letters that they do not introduce, and state results in passing.  What the text itself
leaves open is asked of the models that know all its letters: it follows if one bears it out; it is
wrong if none does and one change makes it right.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache

from rigidtop.judge.context import Context
from rigidtop.judge.judge import Judge
from rigidtop.judge.outcome import FALSE, SAMPLED, Outcome
from rigidtop.judge.question import Patience
from rigidtop.judge.sides import EQUALS, NEARLY
from rigidtop.judge.situation import Situation
from rigidtop.judge.text import Row, in_time
from rigidtop.mark.facts import context
from rigidtop.mark.task import ALWAYS, Subject, bare, knowing, letters, names
from rigidtop.proof.counterexample import entries
from rigidtop.proof.equation import NoMeaningError
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.model import Model
from rigidtop.tree.several import each_index
from rigidtop.tree.statement import Statement

A_FORMULA = 5.0
"""How long a formula is held against one model (s, of the processor's time)."""


def held(rows: Sequence[Row], subject: Subject, until: float) -> tuple[Row, ...]:
    """The rows of a text, those that it leaves open with what the models say of them."""
    judge = Judge()
    return tuple(_held(row, subject, judge, until) for row in rows)


def _held(row: Row, subject: Subject, judge: Judge, until: float) -> Row:
    each, at = row.statement, row.situation
    if not isinstance(each, Statement) or row.outcome.passed is not None or at is None:
        return row
    if not {*each.relations} <= {*EQUALS, *NEARLY} or not each.relations:
        return row
    found = [_by_models(x, at, subject, judge, until) for x in each_index(each)]
    if all(outcome is not None and outcome.passed for outcome in found):
        return replace(row, outcome=Outcome(SAMPLED, "in the models of the lecture"))
    special = at.supposed or at.case or at.instant or at.asked or at.defined
    wrong = next((x for x in found if x is not None and x.slip and not special), None)
    return row if wrong is None else replace(row, outcome=wrong)


def _by_models(
    each: Statement, at: Situation, subject: Subject, judge: Judge, until: float
) -> Outcome | None:
    """That a formula holds in a model that knows its letters, or what is wrong in all of them."""
    at = replace(at, closed=True)
    quick = Judge(judge.memory, patience=Patience(0))
    refuting = []
    models, alone = contexts(subject)
    # Where only names are known, the axes of no frame are.
    for known in models if any(x.bold for x in letters(each)) else (*models, *alone):
        if letters(each) - ALWAYS <= known.given:
            outcome, _ = in_time(quick, each, at, known, until, A_FORMULA)
            if outcome.passed:
                return outcome
            if outcome.verdict == FALSE:
                refuting.append(known)
    for known in refuting:
        outcome, _ = in_time(judge, each, at, known, until, A_FORMULA)
        if outcome.slip:
            return replace(outcome, rests_on=frozenset())
    return None


@cache
def contexts(subject: Subject) -> tuple[tuple[Context, ...], tuple[Context, ...]]:
    """What each model says with what the lecture calls its letters, and the latter alone."""
    models, alone = [], []
    for model in (model for family in subject.families for model in family):
        called = [
            x
            for id in subject.lecture.lines
            for x in names(id, subject.lecture)
            if _holds_what_is_set(id, model, subject.lecture)
        ]
        known = context(model)
        models.append(knowing(known, called))
        alone.append(knowing(bare(known), [x for x in called if x.sides[0] not in known.given]))
    return tuple(models), tuple(alone)


def _holds_what_is_set(id: str, model: Model, lecture: Lecture) -> bool:
    """Whether all that has been set for a line holds in a model."""
    for condition in lecture.judged(id).known.conditions:
        if condition.relation != "=":
            continue
        try:
            if any(x != 0 for x in entries(model.value(condition.expression), 0)):
                return False
        except (ArithmeticError, TypeError, ValueError, AttributeError, NoMeaningError):
            return False
    return True
