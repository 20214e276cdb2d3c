"""Statements with ±: both signs of it, or both roots of what holds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from rigidtop.judge import equality, faults
from rigidtop.judge.counterexample import refuted
from rigidtop.judge.definitions import definition
from rigidtop.judge.jets import TIME
from rigidtop.judge.novelties import brings
from rigidtop.judge.outcome import PREMISE, UNDECIDED, Outcome, joint
from rigidtop.judge.question import Judgement, Pair, Question, alone
from rigidtop.judge.sides import ZERO, named, own_letters, speaks_of
from rigidtop.judge.worlds import Worlds
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.several import signed

BOTH_ROOTS = ("1,2", "1/2", "12")
"""Indices under which both roots stand in one formula."""

UPPER, LOWER = 1, -1


def judged(question: Question) -> Judgement:
    """The outcome of both signs: each is a statement, or both are the roots of what holds."""
    letter, _ = named(question.left)
    if letter is None:
        if not any("±" in x.sub for x in own_letters(question.left)):
            roots = _roots(question)
            if roots is not None:
                return roots[0], question.context
        return each_sign(question, equality.judged)
    names = {question.meaning(sign=x).named(letter) for x in (UPPER, LOWER)}
    settled = len(names) > 1 and names <= question.context.definitions.keys()
    if question.inner or settled:
        return each_sign(question, equality.judged)
    sub = letter.sub.replace(" ", "").strip("±∓")
    root = replace(letter, sub="" if sub in BOTH_ROOTS else sub)
    roots = _roots(replace(question, left=root))
    if roots is not None:
        outcome, right = roots
        context = question.context
        if outcome.passed is not None and root != letter:
            _, context = each_sign(replace(question, right=right), equality.judged)
        return outcome, context
    if sub in BOTH_ROOTS:
        return each_sign(question, equality.judged, [replace(letter, sub=x) for x in "12"])
    if len(names) == 1 and definition(question, question.left, question.right) is not None:
        return _either(question, letter)
    return each_sign(question, equality.judged)


def _either(question: Question, letter: Letter) -> Judgement:
    """A letter that nothing has fixed yet is one of two values."""
    values = (n.Bracketed(signed(question.right, sign)) for sign in (UPPER, LOWER))
    gaps = tuple(n.Bracketed(n.Sum((question.left, n.Negative(value)))) for value in values)
    both = replace(question, left=n.Product(gaps), right=ZERO)
    known = question.context.holding(both.constraint(PREMISE))
    return brings(both, [letter]), known


def each_sign(
    question: Question, judge: Callable[[Question], Judgement], names: Sequence[Node] = ()
) -> Judgement:
    """The outcome of the upper signs and of the lower ones, each with its name if given."""
    outcomes, context = [], question.context
    names = names or (question.left, question.left)
    for sign, name in zip((UPPER, LOWER), names, strict=True):
        outcome, context = judge(replace(question.within(context), left=name, signs=(sign,)))
        outcomes.append(outcome)
    return joint(outcomes), context


def _roots(question: Question) -> tuple[Outcome, Node] | None:
    """Whether what an equation speaks of is one of both values, and both as they have to be.

    None where nothing speaks of it.
    """
    question = replace(question, signs=(UPPER, LOWER))
    if question.at.instant:
        always = _roots(question.always())
        if always is not None and always[0].passed:
            return always
    letter, context = question.left, question.context
    if (
        isinstance(letter, Letter)
        and letter not in context.definitions
        and not any(speaks_of(each.expression, letter) for each in question.pool)
    ):
        return None
    if question.worlds.holds_one(question.both) or _solve(question):
        return question.follows()[0], question.right
    wrong = faults.slip(question, _are_roots)
    if wrong is not None:
        return wrong.outcome, wrong.change.right
    if question.at.closed:
        return refuted(question), question.right
    return Outcome(UNDECIDED, equality.DOES_NOT_FOLLOW), question.right


def _are_roots(both: Sequence[Pair], worlds: Worlds) -> bool:
    return worlds.holds_one(both) and not worlds.vanish([x for pair in both for x in pair])


def _solve(question: Question) -> bool:
    """Whether all that speaks of a letter holds with each of both values in its place."""
    if not isinstance(question.left, Letter):
        return False
    x = alone(question.left)
    laws = [each for each in question.pool if each.expression.has(x)]
    if not laws or any(right.has(x) for _, right in question.both):
        return False
    spoken = {each.constraint for each in laws}
    others = tuple(c for c in question.context.constraints if c not in spoken)
    gaps = [
        (each.expression.subs(x, right), 0 * TIME) for each in laws for _, right in question.both
    ]
    return question.of(gaps, replace(question.context, constraints=others)).holds()
