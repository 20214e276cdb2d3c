"""What holds for one sign of a letter: of a root, of |x|, or of two roots."""

from __future__ import annotations

from dataclasses import replace

from sympy import Abs, Expr, Rational

from rigidtop.judge.context import PREMISE as SUPPOSED
from rigidtop.judge.outcome import ASSUMING, FALSE, Outcome
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.question import Judgement, Question
from rigidtop.judge.sides import ZERO, named, other_root
from rigidtop.judge.values import UnclearError
from rigidtop.judge.worlds import Worlds
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.nodes import Node
from rigidtop.tree.plain import plain as in_words


def but_for_a_sign(question: Question) -> Judgement | None:
    """That it holds where a letter has the sign of a root, or of |x|: cos α = √(1 − sin² α)."""
    sides = (question.left, question.right)
    if len(question.both) != 1:
        return None
    [(left, right)] = question.both
    both = zip(sides, (left, right), strict=True)
    bare = [x for x, value in both if not _has_root(x, value, question.worlds)]
    if len(bare) != 1 or bare[0] == ZERO:
        return None
    signs = question.worlds.signs([left * right])
    if signs is None or not (signs > 0).any() or not question.worlds.holds([(left**2, right**2)]):
        return None
    sign = question.worlds.signs([left if bare[0] is question.left else right])
    assert sign is not None
    agree = {*sign[signs > 0]}
    if agree not in ({1}, {-1}):
        return None
    outcome, context = question.follows()
    relation, opposite = ("\\geq", "negative") if agree == {1} else ("\\leq", "positive")
    where = f"{latex(bare[0])} {relation} 0"
    words = f"where {in_words(bare[0])} is not {opposite}"
    return replace(outcome, verdict=ASSUMING, why=words, conditions=(where,)), context


def _has_root(side: Node, value: Expr, worlds: Worlds) -> bool:
    """Whether a root, or |x|, is in how a side is written or in what it stands for.

    What is positive anyway, as |g|, has no sign to lose; the length N of a vector has lost it.
    """
    length = isinstance(side, n.Letter) and value.is_Pow and value.exp == Rational(1, 2)
    inside = [x.args[0] for x in value.atoms(Abs)]
    signs = worlds.signs(inside) if inside else None
    lost = bool(inside) and (signs is None or bool((signs < 0).any()))
    return lost or length or any(isinstance(x, n.Root | n.Absolute) for x in n.walked(side))


def one_root(question: Question) -> Judgement | None:
    """One of the two roots of what stands above, with a sign that nothing else says."""
    letter, _ = named(question.left)
    context = question.context
    free = letter is not None and letter not in context.definitions
    # A letter that stands for something has a sign, but which way it goes is free.
    if (
        not (free or isinstance(question.left, (n.TimeDerivative, n.Primed)))
        or question.at.closed
        or question.inner
    ):
        return None
    other = n.mapped(question.right, other_root)
    elsewhere = Cue.ELSEWHERE in question.at.cues
    if other == question.right and _is_square_above(question) and not elsewhere:
        other = n.Negative(question.right)
    if other == question.right or len(question.both) != 1:
        return None
    try:
        both = [*question.both, *question.sides(question.meanings(), question.left, other)]
    except UnclearError:
        return None
    if not question.worlds.holds_one(both):
        return None
    if question.at.sign and _is_of_sign(question, -question.at.sign):
        why = f"it is the {'positive' if question.at.sign < 0 else 'negative'} one of two roots"
        line = f"{latex(question.left)} = {latex(other)}"
        return Outcome(FALSE, why, question.rests_on, "another sign", line), context
    conditions = (f"{latex(question.left)} = {latex(question.right)}",)
    why = "it is one of two roots"
    outcome = Outcome(ASSUMING, why, question.rests_on, conditions=conditions)
    return outcome, context.holding(question.constraint(SUPPOSED))


def _is_square_above(question: Question) -> bool:
    """Whether the line above says what the square of the left side is."""
    said = question.context.said[:1]
    return said == (n.Power(question.left, n.Number("2")),)


def _is_of_sign(question: Question, sign: int) -> bool:
    """Whether the right side has a sign in every world."""
    right = [right for _, right in question.both]
    try:
        values = question.worlds.program.values(right).values
    except UnknownFunctionError:
        return False
    return bool((sign * values.real > 0).all())
