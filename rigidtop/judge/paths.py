"""Motions that a text gives as functions of the time: do they obey what holds?"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

import numpy as np
from sympy import Add, Derivative, Expr, Integral, MatrixBase, Piecewise, Rational, Subs, Symbol

from rigidtop.judge import worlds
from rigidtop.judge.context import PREMISE, SETTING, START, Constraint, Context, LetterDefinition
from rigidtop.judge.jets import TIME, Jet, jets, operations, rate, symbol
from rigidtop.judge.laws import residuals
from rigidtop.judge.letters import CLOCK
from rigidtop.judge.program import Program
from rigidtop.judge.question import Pair, Premises, Question, TrialMotion
from rigidtop.judge.residual import Residual
from rigidtop.judge.sides import ZERO, letters_of, named, speaks_of
from rigidtop.judge.values import plain
from rigidtop.judge.vocabulary import Meant
from rigidtop.tree import nodes as n
from rigidtop.tree.nodes import Letter, Node

MOST_RATES = 3
"""Rates of so high an order are put in."""


def path_of(question: Question) -> TrialMotion | None:
    """The motion that a statement gives; None if it gives none."""
    letter, node = named_path(question, question.right)
    if letter is None or question.at.instant or letter not in question.moving:
        return None
    value = question.meaning().value(node)
    if isinstance(value, MatrixBase) or not value.has(TIME):
        return None
    context, at = _without_trials(question.context, letter), question.at
    own = [each for each in context.followed if letter in each.letters]
    if own and _is_steady(question, value) and _needs_its_own(question, letter):
        context = context.forgetting(letter)
        for each in own:
            context = context.holding(each)
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
    definition = LetterDefinition(node, at.number, at.scope, motion=True)
    return TrialMotion(letter, value, context.forgetting(letter), definition)


def _without_trials(context: Context, letter: Letter) -> Context:
    """What is known without other motions of a letter that were only supposed."""
    kept = tuple(
        c
        for c in context.constraints
        if c.kind != SETTING or c.instant or c.left != letter or CLOCK not in n.letters(c.right)
    )
    return replace(context, constraints=kept)


def _is_steady(question: Question, value: Expr) -> bool:
    """Whether a value changes with the time alone, all other letters being constant."""
    rest = rate(value, question.moving) - value.diff(TIME)
    return not question.moves(value) or question.of([(rest, 0 * TIME)]).holds()


def speed_of(question: Question) -> TrialMotion | None:
    """The motion of which a statement gives the velocity in time, but for where it begins.

    None if it gives none, or if what holds depends on where the letter is.
    """
    match question.left:
        case n.TimeDerivative(Letter() as letter, 1) if letter in question.moving:
            pass
        case _:
            return None
    value = question.meaning().value(question.right)
    if question.at.instant or isinstance(value, MatrixBase) or not value.has(TIME):
        return None
    if question.moves(value) or operations(value) > LONGEST_SPEED:
        return None
    sum_of_it = _without_cases(value.integrate(TIME))
    if sum_of_it.has(Integral):
        return None
    begins = [c for c in question.context.constraints if c.instant and c.left == letter]
    kept = tuple(c for c in question.context.constraints if c not in begins)
    before = replace(question.context, constraints=kept).forgetting(letter)
    definition = LetterDefinition(
        Meant(sum_of_it), question.at.number, question.at.scope, motion=True
    )
    path = TrialMotion(letter, sum_of_it, before, definition)
    placed = any(x.expression.has(symbol(Jet(letter))) for x in laws(replace(question, path=path)))
    return None if placed else path


def _without_cases(value: Expr) -> Expr:
    """The first case of each, where letters are not zero."""
    return value.replace(lambda x: isinstance(x, Piecewise), lambda x: x.args[0].expr)


LONGEST_SPEED = 40
"""A velocity with more operations is not integrated."""


def named_path(question: Question, right: Node) -> tuple[Letter | None, Node]:
    """The letter of which the left side is a constant multiple, and what it is by a right one."""
    letter, _ = named(question.left)
    if isinstance(question.left, n.Product):
        factors = question.left.factors
        moving = [x for x in factors if question.moves(question.meaning().value(x))]
        if len(moving) == 1 and isinstance(moving[0], Letter):
            rest = n.Product(tuple(x for x in factors if x is not moving[0]))
            return moving[0], n.Quotient(right, rest)
    return letter, right


def _needs_its_own(question: Question, letter: Letter) -> bool:
    """Whether only what has followed says how it moves: of a component, or of a combination."""
    context = question.context
    if letter in context.definitions:
        return _moves_with_several(question, letter)
    return not any(letter in each.letters for each in context.constraints)


def _moves_with_several(question: Question, letter: Letter) -> bool:
    """Whether it stands for a combination of several letters that move, as ζ = x + i y."""
    value = question.meaning().value(letter)
    found = [] if isinstance(value, MatrixBase) else [x for x in jets(value) if question.moves(x)]
    return len(found) > 1


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
        if not _ties_parameters(each.expression, path.letter, question)
    ]


def _ties_parameters(expression: Expr, letter: Letter, question: Question) -> bool:
    """Whether it says the same wherever the letter is, as β v = 6 π η r v does of β."""
    x = symbol(Jet(letter))
    factor = (expression / x).expand()
    return expression.has(x) and not question.moves(factor) and not factor.has(TIME)


def solves(question: Question, value: Expr, begins: bool = True) -> bool:
    """Whether a motion, or another in its place, obeys what holds of its letter.

    It need not where it is one of several, and not the one that `begins` as it is said.
    """
    path = question.path
    assert path is not None
    put = _put_in(path.letter, value, question.moving)
    own_laws = laws(question)
    gaps = [(_moved(each.expression, put), 0 * TIME) for each in own_laws]
    solved = {each.constraint for each in own_laws}
    left = tuple(c for c in path.context.constraints if c not in solved)
    if not question.new_letters:  # else they say what the new letters are
        said = [c for c in left if c.instant and path.letter in c.letters]
        ends = [c for c in said if isinstance(c.left, n.TimeDerivative) and c.right == ZERO]
        # Whether it is so at a moment of which no time is known, as "in the end", is not seen.
        timed = {START, *path.context.instants}
        starts = tuple(c for c in said if c.instant in timed or c not in ends)
        left = tuple(c for c in left if c in starts or c not in said)
        tried = LetterDefinition(Meant(value), question.at.number, question.at.scope)
        begun = residuals(
            replace(path.context.defining(path.letter, tried), constraints=starts),
            question.memory,
        )
        gaps += [(each.expression, 0 * TIME) for each in begun if each.constraint in starts]
        gaps = gaps if begins else gaps[: len(own_laws)]
        left = tuple(c for c in left if c not in starts)
    return question.of(gaps, replace(path.context, constraints=left)).holds()


def goes_with_others(question: Question, value: Expr) -> bool:
    """Whether others that move can go so that all holds, where the motion is put into it.

    What holds has a solution then, whatever all other letters are; and it has none where the motion
    is a faster one, as it would if the others could follow anything.
    """
    path = question.path
    assert path is not None
    others = {x for each in laws(question) for x in jets(each.expression) if question.moves(x)}
    still = {*_constant(path.before.followed)}
    letters = {jet.letter for x in others for jet in jets(x).values()} - {path.letter} - still
    rates = {symbol(Jet(x, order)): 0 for x in still for order in range(1, MOST_RATES + 1)}
    pool = Premises(path.before, question.memory).residuals
    always = [x.expression.subs(rates) for x in pool if not x.instant]
    own = [x for x in always if letters & letters_of(x)]
    rest = [x for x in always if not question.moves(x)]
    moving = question.moving - still
    if not own:
        return False

    def goes(motion: Expr) -> bool:
        put = _put_in(path.letter, motion, moving)
        gaps = [_moved(x, put) for x in own]
        rates = [rate(x, moving) for x in gaps]
        gaps = plain([*gaps, *rates, *(rate(x, moving) for x in rates)])
        every = worlds.symbols_of(gaps)
        free = [
            x for x in every if any(j.letter in letters and not j.instant for j in jets(x).values())
        ]
        given = worlds.symbols_of([*gaps, *rest])
        places = worlds.found(plain(rest), [x for x in given if x not in free])
        beside_time = [x for x in free if motion.has(x)]  # with zeros there nothing would move
        return places.count > 0 and all(
            _is_solvable(gaps, free, beside_time, dict(zip(places.letters, column, strict=True)))
            for column in places.points.real.T[:_TRIALS].tolist()
        )

    return goes(value) and not goes(value.subs(TIME, _FASTER * TIME))


def _constant(equations: Sequence[Constraint]) -> Iterator[Letter]:
    """The letters of which an equation says that they do not change."""
    for each in equations:
        match each.left:
            case n.TimeDerivative(Letter() as letter, 1) if each.right == ZERO:
                yield letter


def _is_solvable(
    gaps: Sequence[Expr],
    free: Sequence[Symbol],
    not_zero: Sequence[Symbol],
    numbers: Mapping[Symbol, float],
) -> bool:
    """Whether equations have a solution in some letters, the others having numbers."""
    here = [x for x in (_without_rounding(gap.xreplace(numbers)) for gap in gaps) if x != 0]
    at_zero = Program(free, np.zeros((len(free), 1), complex)).values(here).values
    if (np.abs(at_zero) < _NOTHING).all():
        return False  # all others may be zero, which says nothing
    found = worlds.found(here, free, not_zero=not_zero, enough=1)
    return bool(found.count) and bool((np.abs(found.points.imag) < _NOTHING).all())


def _without_rounding(expression: Expr) -> Expr:
    """A sum without the terms that vanish but for the rounding of numbers."""
    terms = Add.make_args(expression.expand())
    return Add(*(x for x in terms if abs(x.as_coeff_Mul()[0]) > _NOTHING))


_TRIALS = 3
_FASTER = Rational(7, 5)
_NOTHING = 1e-9


def tried(question: Question) -> Context:
    """What is known with a motion that is tried: what a Lagrangian says of its letter, too.

    The Lagrangian itself does not move the letter any more.
    """
    path = question.path
    assert path is not None
    put, at = _put_in(path.letter, path.value, question.moving), question.at
    known = path.context
    for each in laws(question):
        if each.constraint is None:
            gap = Meant(_moved(each.expression, put))
            known = known.holding(Constraint(gap, ZERO, at.number, PREMISE, at.scope))
    return known


def is_free(question: Question) -> bool:
    """Whether a motion of letters that are left open may be tried, though it solves nothing yet."""
    path = question.path
    assert path is not None
    letters = [symbol(Jet(x)) for x in sorted(letters_of(path.value), key=str)]
    same: list[Pair] = [(x, x) for x in letters]
    known = path.letter in question.context.definitions
    return (
        not (known and not _moves_with_several(question, path.letter))
        and bool(letters)
        and not question.at.closed
        and bool(question.of(same, path.context).worlds.count)
    )


def _moved(expression: Expr, put: Mapping[Expr, Expr]) -> Expr:
    """An expression where numbers are put into it, which SymPy's `subs` does many times slower."""
    if expression.has(Derivative, Integral, Subs):
        return expression.subs(put, simultaneous=True)
    return expression.xreplace(put)


def _put_in(letter: Letter, value: Expr, moving: frozenset[Letter]) -> dict[Expr, Expr]:
    """The numbers of a letter and its rates where it is a function of the time."""
    put: dict[Expr, Expr] = {}
    for order in range(MOST_RATES + 1):
        put[symbol(Jet(letter, order))] = value
        value = rate(value, moving)
    return put
