"""What a statement lacks: one term of it, or one factor."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache

from sympy import (
    Add,
    Expr,
    Mul,
    Symbol,
    cancel,
    factor_terms,
    fraction,
    linsolve,
    simplify,
    together,
)
from sympy.simplify.fu import TR5
from sympy.solvers.solveset import NonlinearError

from rigidtop.judge import paths
from rigidtop.judge.context import START
from rigidtop.judge.faults import near
from rigidtop.judge.jets import TIME, Jet, jets, operations, symbol
from rigidtop.judge.laws import LAGRANGIANS
from rigidtop.judge.outcome import FALSE, Outcome
from rigidtop.judge.question import Question
from rigidtop.judge.sides import ZERO, letters_of, own_letters
from rigidtop.judge.surroundings import highest
from rigidtop.judge.written import written
from rigidtop.read.phrases import Cue
from rigidtop.tree import nodes as n
from rigidtop.tree.latex import latex
from rigidtop.tree.plain import plain as in_words


def term(question: Question) -> Outcome | None:
    """One term that is missing, of letters that the statement has, or that are near.

    Where it is not said to follow, as few as two terms may be of another problem.
    """
    if len(question.both) != 1 or not question.worlds.count:
        return None
    if Cue.ELSEWHERE in question.at.cues:
        return None
    if question.path is not None:
        return _missing_in_time(question)
    left, right = question.both[0]
    count = sum(len(Add.make_args(x.expand())) for x in (left, right) if x != 0)
    tops = highest(question.equations)
    gap = _solved_for(tops, question.equations, left - right)
    if gap is None or not _is_monomial(gap):
        # sin² θ + cos² θ is 1.
        short = operations(left - right) <= LONGEST
        gap = TR5((left - right).expand()).expand() if short else None
    if gap is None or not _is_monomial(gap):
        gap = _left_out(question.equations, left - right)
    from_lagrangian = any(x in question.context.definitions for x in LAGRANGIANS)
    derived = question.at.derived or _differentiates(question)
    moves = any(left.has(x) or right.has(x) for x in tops) or _differentiates(question)
    moves |= derived and any(x.has(TIME) for x in question.equations)
    if (
        not moves
        or count < (2 if derived or from_lagrangian else 3)
        or gap is None
        or not _is_monomial(gap)
        or not question.rests_on
    ):
        return None
    terms = {x.as_coeff_Mul()[1] for x in Add.make_args((left - right).expand())}
    if count < 3 and gap.as_coeff_Mul()[1] in terms:
        return None  # one of its two terms has another number
    own = own_letters(question.left) | own_letters(question.right)
    if not letters_of(gap) <= (own | near(question) if derived else own):
        return None
    term = written(-gap if question.right == ZERO else gap)
    if question.right == ZERO:
        side = f"{latex(n.Sum((question.left, term)))} = 0"
    else:
        side = f"{latex(question.left)} = {latex(n.Sum((question.right, term)))}"
    words = f"the term {in_words(term)}"
    return Outcome(FALSE, f"{words} is missing", question.rests_on, words, side)


def _missing_in_time(question: Question) -> Outcome | None:
    """One term that is missing in a motion, where only its highest rate stands in what holds."""
    path = question.path
    assert path is not None
    letter = path.letter
    context = question.context
    begins = any(c.instant == START and letter in c.letters for c in context.constraints)
    if not begins or letter in context.definitions:
        return None  # it may be how something else moves
    for law in paths.laws(question):
        orders = [jet.order for jet in jets(law.expression).values() if jet.letter == letter]
        order = max(orders, default=0)
        top = symbol(Jet(letter, order))
        slope = law.expression.diff(top)
        if not order or question.moves(slope) or {*orders} != {order} or slope == 0:
            continue
        rate_of_it = path.value.diff(TIME, order)
        term = simplify((law.expression.subs(top, rate_of_it)) / slope)
        for _ in range(order):
            term = -term.integrate((TIME, 0, TIME)) if term.has(TIME) else -term * TIME
        if not _is_monomial(term) or question.moves(term):
            continue
        if paths.solves(question, path.value + (-1) ** (order + 1) * term):
            words = f"the term {in_words(written(term))}"
            side = f"{latex(question.left)} = {latex(n.Sum((question.right, written(term))))}"
            return Outcome(FALSE, f"{words} is missing", law.rests_on, words, side)
    return None


def _left_out(equations: Sequence[Expr], gap: Expr) -> Expr | None:
    """The one term by which a difference is more than an equation, as it stands or turned round."""
    short = [x for x in equations if operations(x) <= LONGEST]
    still = (x for x in map(_without_time, short) if x is not None)
    rests = ((gap - s * each).expand() for each in (*short, *still) for s in (1, -1))
    return next((x for x in rests if x != 0 and not x.is_Add and _is_monomial(x)), None)


LONGEST = 120
"""From an equation with more operations no term is left out."""


@lru_cache(maxsize=2_000)
def _without_time(equation: Expr) -> Expr | None:
    """An equation for amplitudes: without the factor cos ωt; None if the time stands elsewhere."""
    if not equation.has(TIME):
        return None
    factors = Mul.make_args(factor_terms(equation.expand()))
    rest = Mul(*(x for x in factors if not x.has(TIME)))
    return rest if rest.is_Add else next((x for x in factors if x.is_Add and not x.has(TIME)), None)


def factor(question: Question) -> Outcome | None:
    """One factor that is missing in an equation of motion."""
    if len(question.both) != 1 or not question.worlds.count or question.path is not None:
        return None
    left, right = question.both[0]
    tops = highest(question.equations)
    if not any(left.has(x) for x in tops) or right == 0:
        return None
    solved = _solved_for(tops, question.equations, left)
    if solved is None:
        return None
    factor = factor_terms(cancel(together(solved / right)))
    base, exponent = factor.as_base_exp()
    if base.is_Mul or base.is_Add or exponent not in (-2, -1, 1, 2):
        return None
    if factor.is_number or not letters_of(factor) <= near(question):
        return None
    term = written(factor)
    words = f"the factor {in_words(term)}"
    line = f"{latex(question.left)} = {latex(n.Product((term, n.Bracketed(question.right))))}"
    return Outcome(FALSE, f"{words} is missing", question.rests_on, words, line)


def _differentiates(question: Question) -> bool:
    sides = (question.left, question.right)
    return any(isinstance(x, n.Derivative) for side in sides for x in n.walked(side))


def _is_monomial(expression: Expr) -> bool:
    """Whether it is one term, with a small number in front."""
    over, under = fraction(expression)
    number, _ = over.expand().as_coeff_Mul()
    return (
        expression != 0
        and not over.expand().is_Add
        and not under.expand().is_Add
        and number.is_Rational
        and max(abs(number.p), number.q) <= 8
    )


def _solved_for(tops: Sequence[Symbol], equations: Sequence[Expr], gap: Expr) -> Expr | None:
    """What is left of a difference where the highest rates are put in; None if it is not short."""
    used = [x for x in tops if gap.has(x)]
    if len(tops) > 4 or len(equations) > 6 or gap.count_ops() > 200:
        return None
    try:
        solutions = list(linsolve(list(equations), list(tops))) if used else [()]
    except NonlinearError:
        return None
    if len(solutions) != 1 or (used and any(x.has(*tops) for x in solutions[0])):
        return None
    rest = gap.xreplace(dict(zip(tops, solutions[0], strict=False))) if used else gap
    term: Expr = factor_terms(cancel(together(rest)))
    return term
