"""Motions that a text gives as functions of the time: do they obey what holds?"""

from __future__ import annotations

from dataclasses import replace

from sympy import Expr, MatrixBase

from rigidtop.judge.context import PREMISE, Constraint, Context, Definition
from rigidtop.judge.jets import TIME, Jet, jets, rate, symbol
from rigidtop.judge.laws import Residual, residuals
from rigidtop.judge.meaning import Meant
from rigidtop.judge.question import Pair, Path, Premises, Question
from rigidtop.judge.sides import ZERO, letters_of, named, speaks_of
from rigidtop.tree.nodes import Letter

MOST_RATES = 3
"""Rates of so high an order are put in."""


def path_of(question: Question) -> Path | None:
    """The motion that a statement gives; None if it gives none."""
    letter, _ = named(question.left)
    if letter is None or question.at.instant or letter not in question.moving:
        return None
    value, node = question.meaning().value(question.right), question.right
    if isinstance(value, MatrixBase) or not value.has(TIME):
        return None
    context, at = question.context, question.at
    if letter in context.definitions:
        meant = question.meaning().value(letter)
        place = None if isinstance(meant, MatrixBase) else _place_of(question, meant)
        if place is not None:
            letter, value = place, _solved(meant, value, place)
            node = Meant(value)
        elif not meant.has(TIME):
            return None
    if speaks_of(value, letter):
        return None
    definition = Definition(node, at.number, at.scope, motion=True)
    return Path(letter, value, context.forgetting(letter), definition)


def _place_of(question: Question, meant: Expr) -> Letter | None:
    """The one letter that moves of which another one is a linear function, as of x in u = x − a."""
    moving = [x for x in jets(meant) if question.moves(x)]
    if len(moving) != 1 or meant.has(TIME):
        return None
    [x] = moving
    jet = jets(meant)[x]
    linear = meant.diff(x) != 0 and not meant.diff(x).has(x)
    plain = not (jet.order or jet.place or jet.instant)
    return jet.letter if linear and plain else None


def _solved(meant: Expr, value: Expr, letter: Letter) -> Expr:
    """What a letter is where a linear function of it has a value."""
    x = symbol(Jet(letter))
    return (value - meant.subs(x, 0)) / meant.diff(x)


def laws(question: Question) -> list[Residual]:
    """What holds of the letter of a path where nothing says how it moves."""
    path = question.path
    assert path is not None
    return [
        each
        for each in Premises(path.before, question.memory).residuals
        if speaks_of(each.expression, path.letter) and not each.instant
    ]


def solves(question: Question, value: Expr) -> bool:
    """Whether a motion, or another in its place, obeys what holds of its letter."""
    path = question.path
    assert path is not None
    put = _put_in(path.letter, value, question.context)
    own_laws = laws(question)
    gaps = [(each.expression.subs(put, simultaneous=True), 0 * TIME) for each in own_laws]
    solved = {each.constraint for each in own_laws}
    left = tuple(c for c in path.context.constraints if c not in solved)
    if not question.new_letters:  # else they say what the new letters are
        starts = tuple(c for c in left if c.instant and path.letter in c.letters)
        tried = Definition(Meant(value), question.at.number, question.at.scope)
        begun = residuals(
            replace(path.context.defining(path.letter, tried), constraints=starts),
            question.memory,
        )
        gaps += [(each.expression, 0 * TIME) for each in begun if each.constraint in starts]
        left = tuple(c for c in left if c not in starts)
    return question.of(gaps, replace(path.context, constraints=left)).holds()


def tried(question: Question) -> Context:
    """What is known with a motion that is tried: what a Lagrangian says of its letter, too.

    The Lagrangian itself does not move the letter any more.
    """
    path = question.path
    assert path is not None
    put, at = _put_in(path.letter, path.value, question.context), question.at
    known = path.context
    for each in laws(question):
        if each.constraint is None:
            gap = Meant(each.expression.subs(put, simultaneous=True))
            known = known.holding(Constraint(gap, ZERO, at.number, PREMISE, at.scope))
    return known


def is_free(question: Question) -> bool:
    """Whether a motion of letters that are left open may be tried, though it solves nothing yet."""
    path = question.path
    assert path is not None
    letters = [symbol(Jet(x)) for x in sorted(letters_of(path.value), key=str)]
    same: list[Pair] = [(x, x) for x in letters]
    return (
        path.letter not in question.context.definitions
        and bool(letters)
        and not question.at.closed
        and bool(question.of(same, path.context).worlds.count)
    )


def _put_in(letter: Letter, value: Expr, context: Context) -> dict[Expr, Expr]:
    """The numbers of a letter and its rates where it is a function of the time."""
    put: dict[Expr, Expr] = {}
    for order in range(MOST_RATES + 1):
        put[symbol(Jet(letter, order))] = value
        value = rate(value, context.habits.moving)
    return put
