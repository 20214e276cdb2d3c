"""What is a number by all that holds: is it the one that is written?"""

from __future__ import annotations

from rigidtop.judge.faults import ratio
from rigidtop.judge.numbers import are_numbers, compared
from rigidtop.judge.question import Judgement, Question
from rigidtop.judge.sides import own_letters


def number(question: Question, nearly: bool = False) -> Judgement | None:
    """The outcome where one side is a number and all that holds gives the other a number, too."""
    if own_letters(question.right) or not all(are_numbers(x, x) for _, x in question.both):
        return None
    factor = ratio(question)
    if factor is None or question.at.instant:
        return None
    meant = [(factor * right, right) for _, right in question.both]
    sides = question.left, question.right
    return compared(*sides, meant, question.rests_on, nearly), question.context
