"""Letters and their rates as independent numbers: each is a symbol of SymPy.

A `Jet` says which number: the letter, how often it is differentiated, which component of a vector
or which particle it is, and at which instant.  The symbol has all of that in its name, so that
either can be had from the other.

>>> from rigidtop.tree.nodes import Letter
>>> rate = Jet(Letter("θ"), 1)
>>> jet_of(symbol(rate)) == rate
True
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import lru_cache

import sympy
from sympy import Expr, Integer, Symbol

from rigidtop.tree.nodes import Letter

_BETWEEN = "\x1f"


@dataclass(frozen=True)
class Jet:
    """One number of a world; `instant` is "" now, and `place` counts components or particles."""

    letter: Letter
    order: int = 0
    place: tuple[int, ...] = ()
    instant: str = ""


TIME = Symbol("t" + _BETWEEN, real=True)
"""The time."""


@lru_cache(maxsize=20_000)
def symbol(jet: Jet) -> Symbol:
    """The symbol of a number."""
    letter = jet.letter
    bold = "b" if letter.bold else ""
    place = ",".join(map(str, jet.place))
    parts = (letter.base, letter.sub, letter.mark, bold, str(jet.order), place, jet.instant)
    return Symbol(_BETWEEN.join(parts), real=True)


@lru_cache(maxsize=20_000)
def jet_of(x: Symbol) -> Jet | None:
    """What number a symbol is; None for the time and for what is no letter's."""
    parts = x.name.split(_BETWEEN)
    if len(parts) != 7:
        return None
    base, sub, mark, bold, order, place, instant = parts
    letter = Letter(base, sub, mark, bool(bold))
    where = tuple(map(int, place.split(","))) if place else ()
    return Jet(letter, int(order), where, instant)


def jets(expression: Expr) -> dict[Symbol, Jet]:
    """The numbers that an expression speaks of."""
    found = ((x, jet_of(x)) for x in expression.free_symbols)
    return {x: jet for x, jet in found if jet is not None}


def rate(expression: Expr, moving: frozenset[Letter]) -> Expr:
    """The derivative in time, every letter that does not move being constant."""
    made = expression.diff(TIME) if expression.has(TIME) else Integer(0)
    for x, jet in jets(expression).items():
        if jet.order or jet.letter in moving:
            made += expression.diff(x) * symbol(replace(jet, order=jet.order + 1))
    return made


def at_instant(expression: Expr, instant: str, moving: frozenset[Letter], time: Expr) -> Expr:
    """What an expression is at another moment: what moves has another value there."""
    put: dict[Expr, Expr] = {
        x: symbol(replace(jet, instant=instant))
        for x, jet in jets(expression).items()
        if not jet.instant and (jet.order or jet.letter in moving)
    }
    return sympy.sympify(expression).xreplace(put | {TIME: time})
