"""What an answer has to reach, and the facts by which it is judged, for a line of a lecture."""

from __future__ import annotations

from collections.abc import Sequence

from rigidtop.errors import RigidtopError
from rigidtop.judge.answer import GIVEN, Goal
from rigidtop.judge.context import Context
from rigidtop.judge.judge import Judge, Situation
from rigidtop.proof.lecture import Lecture
from rigidtop.read.statements import statements
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.statement import Statement

_ALWAYS = frozenset({Letter("π"), Letter("t"), Letter("i"), Letter("e")})


def goal(name: str, lecture: Lecture) -> Goal:
    """What the lecture derives under a number or a name; definitions there only lead to it."""
    written = {x.line.id: x.latex for text in lecture.texts for x in text.shown if x.line}

    def read(id: str) -> tuple[Statement, ...]:
        return tuple(x for x in statements(written[id]) if isinstance(x, Statement))

    lines = [lecture.lines[id] for id in lecture.names[name]]
    numbered = [line for line in lines if any(e.tag == name for e in line.equations)]
    calls = [line for line in lines if line.move is not None and line.move.verb == "call"]
    derived = [line for line in lines if line not in calls]
    chosen = numbered or derived or lines
    # The first of many lines is where a claim begins.
    chosen = chosen[1:] if len(chosen) > 3 and not numbered else chosen
    named = [x for line in calls if line not in chosen for x in read(line.id)]
    return Goal(name, tuple(x for x in (read(line.id) for line in chosen) if x), tuple(named))


def facts(
    goal: Goal, families: Sequence[Sequence[Context]], answer: frozenset[Letter]
) -> Sequence[Context]:
    """The contexts, from the general to the special, in which most of a goal follows.

    Of several the one that knows most letters of the answer.  Raises RigidtopError where none is.
    """
    found = []
    for family in families:
        for k, context in enumerate(family):
            count = _following(goal, context)
            if count:
                found.append((-count, len(answer - context.letters), k, family[: k + 1]))
    if not found:
        raise RigidtopError(f"no model of the collection knows what {goal.name} is about")
    return min(found, key=lambda x: x[:3])[3]


def _following(goal: Goal, context: Context) -> int:
    """How many statements of a goal follow in a context that knows their letters."""
    judge, at = Judge(left_for_slips=0), Situation(GIVEN, closed=True)
    for each in goal.names:
        _, context = judge.judged(each, at, context)
    count = 0
    for together in goal.statements:
        if any(letters(each) - context.letters - _ALWAYS for each in together):
            continue
        outcomes = []
        for each in together:
            outcome, context = judge.judged(each, at, context)
            outcomes.append(outcome)
        count += all(outcome.passed for outcome in outcomes)
    return count


def letters(statement: Statement) -> frozenset[Letter]:
    """The letters of a statement."""
    return frozenset().union(*map(n.letters, statement.sides))
