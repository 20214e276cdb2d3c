"""Whether a statement speaks of another case than what stands above it."""

from __future__ import annotations

from rigidtop.judge.context import Context
from rigidtop.judge.situation import Situation
from rigidtop.read.phrases import Cue
from rigidtop.tree.statement import Statement


def is_one_of_cases(statement: Statement, at: Situation, context: Context) -> bool:
    """Whether it is the middle one in a list of cases: γ < ω, γ = ω, γ > ω."""
    if at.closed or not context.bounds or statement.relations != ("=",):
        return False
    last = context.bounds[-1]
    return last.number == at.number - 1 and {*statement.sides} == {last.greater, last.less}


def may_be_elsewhere(statement: Statement, at: Situation, context: Context) -> bool:
    """Whether it says anew what stands above, in circumstances that only words tell."""
    told = Cue.CIRCUMSTANCE in at.cues and not at.closed
    return told and context.speaks_of(statement.sides[0])


def is_said_again(statement: Statement, at: Situation, context: Context) -> bool:
    """Whether it repeats what stands above, in circumstances that only words tell."""
    said = {(each.left, each.right) for each in (*context.constraints, *context.followed)}
    told = Cue.CIRCUMSTANCE in at.cues and not at.closed
    return told and len(statement.sides) == 2 and statement.sides in said
