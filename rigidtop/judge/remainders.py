"""What is equal but for terms of an order: sin x = x + O(x³)."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from sympy import Expr

from rigidtop.judge import approximations, definitions
from rigidtop.judge.faults import NEARLY_ALIKE, slip
from rigidtop.judge.orders import Scaling, grows, small_together
from rigidtop.judge.outcome import ASSUMING, FALSE, UNDECIDED, Outcome
from rigidtop.judge.question import Judgement, Pair, Question
from rigidtop.judge.sides import ZERO, own_letters
from rigidtop.judge.worlds import Worlds
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Node
from rigidtop.tree.plain import plain as in_words


def has_order(side: Node) -> bool:
    """Whether terms of a side are left out and their order is written."""
    return _parted(side)[1] is not None


def judged(question: Question) -> Judgement:
    """The outcome of A = B + O(X): the sides differ by no more than X where that is small.

    Of what stands behind O(X) in a chain it is asked whether X may be that.
    """
    left, (right, order) = _first(question.left), _parted(question.right)
    question = replace(question, left=left, right=right)
    if order is None:
        return approximations.judged(question)
    named = definitions.definition(question, left, right) if right != ZERO else None
    if named is not None:
        return named
    if question.holds():
        return question.follows()
    size = question.meaning().scalar(order)
    scaling = small_together(own_letters(order), question.worlds)
    context, within = question.context, f"O({in_words(order)})"
    unseen = Outcome(UNDECIDED, f"it is not seen that the sides differ by no more than {within}")
    if scaling is None or not question.worlds.count:
        return unseen, context
    apart = [_grows(question, pair, size, scaling, question.worlds) for pair in question.both]
    if all(x is False for x in apart):
        outcome = Outcome(ASSUMING, f"for {scaling.words}", question.rests_on)
        return replace(outcome, conditions=(scaling.words,)), context
    wrong = slip(
        question, partial(_is_within, question, size, scaling), "\\approx", most=NEARLY_ALIKE
    )
    if wrong is not None:
        return wrong.outcome, context
    if True in apart and question.at.closed:
        why = f"the sides differ by more than {within} for {scaling.words}"
        return Outcome(FALSE, why, question.rests_on), context
    return unseen, context


def _first(side: Node) -> Node:
    """A side without its order, or what stands in that where there is nothing else."""
    bare, order = _parted(side)
    return order if order is not None and bare == ZERO else bare


def _parted(side: Node) -> tuple[Node, Node | None]:
    """A side without the terms that are left out, and what their order is made of."""
    terms = side.terms if isinstance(side, n.Sum) else (side,)
    orders = [x for x in map(_order, terms) if x is not None]
    kept = tuple(x for x in terms if _order(x) is None)
    bare = n.Sum(kept) if len(kept) > 1 else kept[0] if kept else ZERO
    return bare, orders[0] if orders else None


def _order(term: Node) -> Node | None:
    match term:
        case n.Negative(n.Remainder(of)) | n.Remainder(of):
            return of
    return None


def _is_within(
    question: Question, size: Expr, scaling: Scaling, both: Sequence[Pair], worlds: Worlds
) -> bool:
    return all(_grows(question, pair, size, scaling, worlds) is False for pair in both)


def _grows(
    question: Question, pair: Pair, size: Expr, scaling: Scaling, worlds: Worlds
) -> bool | None:
    return grows(pair, size, question.equations, worlds, scaling)
