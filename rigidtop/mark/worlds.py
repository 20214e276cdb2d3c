"""Answers that are read and judged in worlds, where the first reading of them comes to no end.

It reads more (complex numbers, columns in any axes, two signs, mathematics outside of dollars) and
knows more goals: whatever the lecture derives under a name.  What it says is taken where the answer
passes, or where one change makes a wrong line right.
"""

from __future__ import annotations

from functools import cache

from rigidtop.errors import RigidtopError
from rigidtop.judge.answer import marked as judged
from rigidtop.judge.answering import facts, goal, letters
from rigidtop.judge.context import Context
from rigidtop.judge.outcome import DEFINITION, UNREAD
from rigidtop.judge.text import Row, read_text
from rigidtop.mark.facts import context
from rigidtop.mark.marking import Mark, Marked, Marking
from rigidtop.mark.passages import Subject, top
from rigidtop.mark.slips import Slip
from rigidtop.tree.plain import plain
from rigidtop.tree.statement import Statement, Unread


def marking(source: str, start: str, name: str, subject: Subject | None = None) -> Marking:
    """An answer marked by what the models say, from one line of the lecture to another.

    Raises RigidtopError where the lecture does not have them, or no model knows what is asked.
    """
    subject = subject or top()
    start, name = start.strip("()"), name.strip("()")
    for each in (start, name):
        if each not in subject.lecture.names:
            raise RigidtopError(f"no line of the lecture is called {each!r}")
    asked = goal(name, subject.lecture)
    read, _ = read_text(source, plain=True)
    own = frozenset().union(*(letters(x) for _, x in read if isinstance(x, Statement)))
    found = judged(source, facts(asked, _families(subject), own), asked)
    return Marking(tuple(map(_line, found.rows)), found.arrives, name)


@cache
def _families(subject: Subject) -> tuple[tuple[Context, ...], ...]:
    return tuple(tuple(map(context, family)) for family in subject.families)


def _line(row: Row) -> Marked:
    said = row.passage.text.strip() if isinstance(row.statement, Unread) else plain(row.statement)
    outcome = row.outcome
    if outcome.verdict == UNREAD:
        return Marked(row.line, said, Mark.UNREAD, outcome.why)
    if outcome.passed:
        return Marked(row.line, said, Mark.FOLLOWS, outcome.why)
    if outcome.passed is False:
        slips = (Slip("other", outcome.slip),) if outcome.slip else ()
        return Marked(row.line, said, Mark.WRONG, outcome.why, slips)
    if outcome.verdict == DEFINITION:
        return Marked(row.line, said, Mark.DEFINITION, outcome.why)
    if outcome.verdict == "premise":
        return Marked(row.line, said, Mark.ASSUMPTION, outcome.why)
    return Marked(row.line, said, Mark.INCONCLUSIVE, outcome.why)
