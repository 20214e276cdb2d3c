"""Functions that only an equation of their slopes speaks of: y of a wave, W of Hamilton and Jacobi.

What is said of them holds at every place, until a text says what they are.
"""

from __future__ import annotations

import time
from collections.abc import Collection, Iterable, Sequence
from dataclasses import replace

from sympy import MatrixBase

from rigidtop.judge.context import FIELD, Context, LetterDefinition
from rigidtop.judge.faults import NUMBERS, SLIP_SECONDS
from rigidtop.judge.laws import HAMILTONIANS, LAGRANGIANS
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.meaning import Meaning
from rigidtop.judge.outcome import DEFINITION, FALSE, PREMISE, SAMPLED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question
from rigidtop.judge.residual import Residual
from rigidtop.judge.sides import ZERO, speaks_of
from rigidtop.judge.slips import changes
from rigidtop.judge.values import UnclearError, pairs
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Letter, Node
from rigidtop.tree.plain import plain as in_words
from rigidtop.tree.statement import Statement


def fields_of(
    read: Iterable[Statement], moving: Collection[Letter]
) -> dict[Letter, tuple[Node, ...]]:
    """The letters whose slopes a text speaks of first, with the letters that these are taken by.

    Along a motion a slope is a ratio of rates, and no field.
    """
    seen: set[Node] = {*LAGRANGIANS, *HAMILTONIANS}
    fields: dict[Letter, tuple[Node, ...]] = {}
    for each in read:
        nodes = [x for side in each.sides for x in n.walked(side)]
        for slope in nodes:
            if isinstance(slope, n.Derivative) and isinstance(slope.of, Letter):
                known = slope.of in seen and slope.of not in fields
                driven = not slope.partial and {*slope.by} & {*moving, CLOCK}
                if known or driven or not all(isinstance(x, Letter) for x in slope.by):
                    continue
                fields[slope.of] = (*dict.fromkeys((*fields.get(slope.of, ()), *slope.by)),)
        called = {x.function for x in nodes if isinstance(x, n.Call)}  # u(x, t)
        seen |= {x for x in nodes if isinstance(x, Letter)} - called
    return fields


def equation(question: Question) -> Judgement | None:
    """What an equation of slopes says of a field of which nothing is known."""
    unknown = question.context.habits.fields - question.context.definitions.keys()
    slopes = [
        x.of
        for side in (question.left, question.right)
        for x in n.walked(side)
        if isinstance(x, n.Derivative) and x.of in unknown
    ]
    rates = any(
        isinstance(x, n.TimeDerivative)
        for side in (question.left, question.right)
        for x in n.walked(side)
    )
    if not slopes or rates or question.at.instant or question.inner:
        return None
    if any(x.kind == FIELD for x in question.grounds.near) and question.holds():
        return question.follows()
    context = question.context.holding(question.constraint(FIELD))
    names = ", ".join(sorted({in_words(x) for x in slopes}))
    return Outcome(PREMISE, f"it says how {names} changes", question.rests_on_meaning), context


def value(question: Question) -> Judgement | None:
    """What a field is: it solves what has been said of it, or is tried, or has a slip."""
    letter, context = question.left, question.context
    if not isinstance(letter, Letter) or question.at.instant:
        return None
    if letter not in context.habits.fields or letter in context.definitions:
        return None
    laws = [x for x in question.pool if x.kind == FIELD and speaks_of(x.expression, letter, True)]
    meant = question.meaning().value(question.right)
    if question.right == ZERO:
        return Outcome(PREMISE, "a place"), context  # at an edge
    if not laws or isinstance(meant, MatrixBase) or speaks_of(meant, letter):
        return None
    if _is_solved(question, laws, question.right):
        verdict, why = SAMPLED, "it solves what stands above"
    else:
        verdict, why = DEFINITION, f"{in_words(letter)} is tried"
    rests_on = frozenset().union(*(x.rests_on for x in laws)) | question.rests_on_meaning
    known = _defined(question, question.right)
    fits = verdict == SAMPLED or question.of([(meant, meant)], known).worlds.count
    if fits and (verdict == SAMPLED or question.new_letters):
        return Outcome(verdict, why, rests_on), known
    with question.patience.search(SLIP_SECONDS) as until:
        for change in changes(
            question.left, question.right, n.letters(question.right), frozenset()
        ):
            if time.process_time() > until or change.rank > NUMBERS:
                break
            if change.left == question.left and _is_solved(question, laws, change.right):
                right = f"{latex(change.left)} = {latex(change.right)}"
                why = f"it holds with {change.words}"
                wrong = Outcome(FALSE, why, rests_on, change.words, right)
                return wrong, _defined(question, change.right)
    return (Outcome(verdict, why, rests_on), known) if fits else None


def _is_solved(question: Question, laws: Sequence[Residual], node: Node) -> bool:
    """Whether a field with this value obeys what is said of it, whatever the letters are."""
    known = _defined(question, node)
    meaning = Meaning(known, question.memory)
    free = replace(known, constraints=tuple(c for c in known.constraints if c.kind != FIELD))
    gaps: list[Pair] = []
    for constraint in (x.constraint for x in laws if x.constraint is not None):
        try:
            gaps += pairs(meaning.value(constraint.left), meaning.value(constraint.right))
        except UnclearError:
            return False
    return question.of(gaps, free).holds()


def _defined(question: Question, node: Node) -> Context:
    letter, context = question.left, question.context
    assert isinstance(letter, Letter)
    places = context.habits.functions.get(letter, ())
    definition = LetterDefinition(node, question.at.number, question.at.scope, places)
    return context.defining(letter, definition)
