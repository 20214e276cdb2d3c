"""A counterexample: numbers of a world in which a statement does not hold."""

from __future__ import annotations

from contextlib import suppress

import numpy as np
from numpy.typing import NDArray
from sympy import Expr

from rigidtop.judge import worlds as w
from rigidtop.judge.approximations import nearly_equal
from rigidtop.judge.context import PLACE, SETTING
from rigidtop.judge.faults import FEWEST
from rigidtop.judge.jets import jets
from rigidtop.judge.outcome import FALSE, Outcome
from rigidtop.judge.program import UnknownFunctionError
from rigidtop.judge.question import Question
from rigidtop.judge.values import UnclearError
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter
from rigidtop.tree.plain import plain as in_words

MOST_NUMBERS = 8
"""No more numbers are told."""


def refuted(question: Question) -> Outcome:
    """That it fails in a world, with the numbers of its letters and of both sides there."""
    letters = _numbered(question)
    for left, right in question.both:
        try:
            values = question.worlds.program.values([*letters.values(), left, right]).values.real
        except UnknownFunctionError:
            break
        fails = [k for k in range(question.worlds.count) if not _agree(values[-2:, k])]
        if fails:
            *numbers, here, there = values[:, fails[0]]
            told = [f"{x} = {v:.3g}" for x, v in zip(letters, numbers, strict=True)]
            where = f"at {', '.join(told[:MOST_NUMBERS])}: " if told else ""
            both = f"the left side is {here:.4g}, the right side {there:.4g}"
            return Outcome(FALSE, (where + both).replace("-", "−"), question.rests_on)
    return Outcome(FALSE, "it does not hold", question.rests_on)


def acceleration(question: Question) -> Outcome | None:
    """A counterexample to an acceleration that equations of motion give, as they stand above.

    None where the words suppose something, where a letter is new, or where it is nearly true.
    """
    at, worlds = question.at, question.worlds
    context = question.context
    cases = any(c.kind in (SETTING, PLACE) and not c.instant for c in context.constraints)
    if cases or context.open or Cue.ELSEWHERE in at.cues:
        return None  # another case may have begun
    supposed = at.supposed or at.opens or at.case or at.small or at.large or at.instant
    if supposed or at.inline or question.new_letters or worlds.count < FEWEST or worlds.tied:
        return None
    own = [x for gap in question.gaps for x, jet in jets(gap).items() if jet.order == 2]
    left = {x for one, _ in question.both for x in jets(one)}
    if not own or not left & {*own} or w.rank(question.equations, worlds, own) < len({*own}):
        return None
    if worlds.vanish(own):
        return None  # in a case in which nothing moves
    signs = worlds.signs(question.gaps)
    if signs is None or not signs.all() or nearly_equal(question) is not None:
        return None
    return refuted(question)


def _numbered(question: Question) -> dict[str, Expr]:
    """The letters and rates that stand in it and have a number in its worlds."""
    meaning, numbered = question.meaning(), dict[str, Expr]()
    for node in (x for side in (question.left, question.right) for x in n.walked(side)):
        if isinstance(node, Letter) or (isinstance(node, n.TimeDerivative) and node.dotted):
            with suppress(UnclearError):
                value = meaning.scalar(node)
                if value.free_symbols <= {*question.worlds.letters}:
                    numbered[in_words(node)] = value
    return numbered


def _agree(pair: NDArray[np.float64]) -> bool:
    """Whether two numbers differ by no more than rounding."""
    return bool(abs(pair[0] - pair[1]) <= w.CLOSE * (abs(pair[0]) + abs(pair[1]) + w.CLOSE))
