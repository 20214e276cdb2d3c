"""What is a number by all that holds: is it the one that is written?"""

from __future__ import annotations

from contextlib import suppress

import sympy
from sympy import Expr, Float, Symbol

from rigidtop.judge.context import LetterDefinition
from rigidtop.judge.faults import ratio
from rigidtop.judge.numbers import are_numbers, compared
from rigidtop.judge.question import Judgement, Question, alone
from rigidtop.judge.sides import own_letters
from rigidtop.judge.values import UnclearError
from rigidtop.judge.vocabulary import Meant
from rigidtop.tree.nodes import Letter

_STEPS, _NEAR, _ROUNDED = 40, 100, 1e-12
"""So many steps of Newton's method are made; a root lies no farther off by a factor."""


def number(question: Question, nearly: bool = False) -> Judgement | None:
    """The outcome where one side is a number and all that holds gives the other a number, too."""
    if question.at.instant and not question.moves(*question.gaps):
        question = question.always()
    if own_letters(question.right) or not all(are_numbers(x, x) for _, x in question.both):
        return None
    factor = ratio(question)
    if factor is None or question.at.instant:
        return _root(question, nearly)
    meant = [(factor * right, right) for _, right in question.both]
    sides = question.left, question.right
    return compared(*sides, meant, question.rests_on, nearly), question.context


def _root(question: Question, nearly: bool) -> Judgement | None:
    """The same of a letter that an equation above fixes, in which all else is a number."""
    letter, context, at = question.left, question.context, question.at
    if not isinstance(letter, Letter) or letter in context.definitions or at.instant:
        return None
    if len(question.both) != 1:  # of any one of several
        return None
    x, [(_, right)] = alone(letter), question.both
    for each in reversed((*context.constraints, *context.followed)):
        if letter in each.letters and not each.instant:
            with suppress(UnclearError):
                meaning = question.meaning()
                gap = meaning.scalar(each.left) - meaning.scalar(each.right)
                value = _solved(gap, x, right)
                if value is None:
                    continue
                rests_on = frozenset({each.number}) | meaning.used
                outcome = compared(letter, question.right, [(value, right)], rests_on, nearly)
                definition = LetterDefinition(Meant(value), at.number, at.scope, supposed=True)
                return outcome, context.defining(letter, definition)
    return None


def _solved(gap: Expr, x: Symbol, near: Expr) -> Expr | None:
    """The root of an equation that lies near a number; None where other letters stand in it."""
    units = [u for u in near.free_symbols | gap.free_symbols if u.name.startswith("unit ")]
    unit = near / near.subs(dict.fromkeys(units, 1))
    plain = gap.subs(x, x * unit).subs(dict.fromkeys(units, 1))
    if plain.free_symbols != {x}:
        return None
    start = float(sympy.N(near.subs(dict.fromkeys(units, 1))))
    value, slope = start, plain.diff(x)
    for _ in range(_STEPS):
        rise = complex(slope.subs(x, value))
        step = complex(plain.subs(x, value)) / rise if rise else complex("nan")
        if step.imag or step != step:
            return None
        value -= step.real
        if abs(step) <= _ROUNDED * abs(value):
            near_enough = 1 / _NEAR < value / start < _NEAR
            return Float(value) * unit if near_enough else None
    return None
