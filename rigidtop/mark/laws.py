"""The laws of a lecture, held against models: is what nothing derives true of anything?

What follows is as true as what it follows from.  A law is where that ends, so it is asked of models
that were made apart from the pages.
"""

from __future__ import annotations

from collections.abc import Collection, Iterable, Sequence

from rigidtop.derivations import models
from rigidtop.judge.judge import Judge
from rigidtop.judge.outcome import FALSE
from rigidtop.judge.question import Patience
from rigidtop.judge.situation import Situation
from rigidtop.mark.facts import GIVEN, context
from rigidtop.mark.task import ALWAYS, letters, stated
from rigidtop.proof.lecture import Lecture
from rigidtop.proof.model import Model
from rigidtop.tree.statement import Statement


def of_the_top() -> list[Model]:
    """The models by which answers are marked, and a body with a torque."""
    return [*(model for family in models.families() for model in family), models.turning()]


def laws_in(
    lecture: Lecture, models: Sequence[Model], ids: Collection[str] = ()
) -> dict[str, bool | None]:
    """Whether each law of a lecture, or each of some lines that is one, holds in the models.

    It does if for each of its equations one that knows the letters bears it out, and does not if
    all of them refute one; None where none knows the letters, or it is left open.
    """
    contexts = [context(model) for model in models]
    judge = Judge(patience=Patience(0))

    def holds(each: Statement) -> bool | None:
        knowing = [known for known in contexts if letters(each) - ALWAYS <= known.given]
        outcomes = [judge.judged(each, Situation(GIVEN, closed=True), x)[0] for x in knowing]
        if any(outcome.passed for outcome in outcomes):
            return True
        refuted = bool(outcomes) and all(outcome.verdict == FALSE for outcome in outcomes)
        return False if refuted else None

    return {id: _all_of(map(holds, stated(id, lecture))) for id in _laws(lecture, ids)}


def _laws(lecture: Lecture, ids: Collection[str]) -> list[str]:
    """The laws among some lines, or among all; what an exercise is about is none."""
    laws = (id for id in lecture.lines if id in lecture.laws and (not ids or id in ids))
    return [id for id in laws if not lecture.lines[id].file.startswith("exercises/")]


def _all_of(answers: Iterable[bool | None]) -> bool | None:
    """False if one is, else None if one is."""
    every = {*answers}
    return False if False in every else None if None in every or not every else True
