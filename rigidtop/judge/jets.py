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

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import sympy
from sympy import Add, Expr, Integer, Mul, Symbol

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
    """The SymPy symbol that stands for a jet, the same for equal jets."""
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


@lru_cache(maxsize=20_000)
def symbols(expression: Expr) -> frozenset[Symbol]:
    """All that an expression has in place of numbers."""
    return frozenset(expression.free_symbols)


@lru_cache(maxsize=20_000)
def operations(expression: Expr) -> int:
    """How many operations make an expression: about what `count_ops` says, but cheap."""
    args = expression.args
    return sum(map(operations, args)) + max(len(args) - 1, 1) if args else 0


@lru_cache(maxsize=20_000)
def jets(expression: Expr) -> Mapping[Symbol, Jet]:
    """The numbers that an expression speaks of."""
    found = ((x, jet_of(x)) for x in symbols(expression))
    return {x: jet for x, jet in found if jet is not None}


def rate(expression: Expr, moving: frozenset[Letter]) -> Expr:
    """The derivative in time, every letter that does not move being constant."""
    return _rate(sympy.sympify(expression), moving)


@lru_cache(maxsize=50_000)
def _rate(node: Expr, moving: frozenset[Letter]) -> Expr:
    """The same; each part of an expression is differentiated once."""
    if node.is_Symbol:
        jet = jet_of(node)
        if jet is None:
            return Integer(int(node == TIME))
        moves = not jet.instant and (jet.order or jet.letter in moving)
        return symbol(replace(jet, order=jet.order + 1)) if moves else Integer(0)
    if node.is_Add:
        return Add(*(_rate(x, moving) for x in node.args))
    if node.is_Mul:
        slopes = [(k, _rate(x, moving)) for k, x in enumerate(node.args)]
        return Add(*(_with_factor(node.args, k, x) for k, x in slopes if x != 0))
    if node.is_Pow and _rate(node.exp, moving) == 0:
        slope = _rate(node.base, moving)
        return node.exp * node.base ** (node.exp - 1) * slope if slope != 0 else slope
    terms = [(x, _rate(x, moving)) for x in symbols(node)]
    return Add(*(node.diff(x) * slope for x, slope in terms if slope != 0))


def _with_factor(factors: Sequence[Expr], place: int, factor: Expr) -> Expr:
    """A product with another factor in one place."""
    return Mul(*factors[:place], factor, *factors[place + 1 :])


def at_instant(expression: Expr, instant: str, moving: frozenset[Letter], time: Expr) -> Expr:
    """What an expression is at another moment: what moves has another value there."""
    put: dict[Expr, Expr] = {
        x: symbol(replace(jet, instant=instant))
        for x, jet in jets(expression).items()
        if not jet.instant and (jet.order or jet.letter in moving)
    }
    return sympy.sympify(expression).xreplace(put | {TIME: time})


def time_at(instant: str) -> Symbol:
    """The time at an instant of which nothing says when it is."""
    return Symbol(f"t\x1f{instant}", real=True)
