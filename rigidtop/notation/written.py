"""Symbols of another notation: each knows its own letter and the symbol that it stands for.

Goldstein's φ is another angle than the φ of the notes, so the two are never equal.  Everywhere else
a `Written` symbol behaves like the one that it stands for: SymPy puts sums and products into the
same order, so that a typed equation is still seen to be typed, and the page orders factors alike.

>>> from rigidtop.theory.symbols import lambda1, omega1
>>> I1 = Written("I1", Glyph("I", "1"), lambda1)
>>> I1 * omega1, I1.quantity.meaning, I1 == lambda1
(I1*omega1, 'principal moment of inertia about $e₁$', False)
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from sympy import Symbol

from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import VOCABULARY, Glyph

_PLACES = {symbol: place for place, symbol in enumerate(VOCABULARY)}


class Written(Lettered):
    """A symbol of another notation; `stands` is the notes' symbol in whose place it stands."""

    __slots__ = ("stands",)

    stands: Symbol

    def __new__(cls, name: str, glyph: Glyph, stands: Symbol, meaning: str = "") -> Written:
        known = VOCABULARY[stands]
        quantity = replace(known, glyph=glyph, meaning=meaning or known.meaning)
        made = Symbol.__xnew__(cls, name, **stands._assumptions_orig)
        made.quantity, made.place, made.stands = quantity, _PLACES[stands], stands
        return made

    def __getnewargs_ex__(self) -> Any:
        quantity = self.quantity
        return (self.name, quantity.glyph, self.stands, quantity.meaning), {}

    def _hashable_content(self) -> tuple[Any, ...]:
        # What SymPy sorts by: like the symbol it stands for, next to which nothing else comes.
        return f"{self.stands.name} {self.name} {self.quantity}", *self._assumptions0


# SymPy sorts by the names of classes before anything else.
Written.__name__ = "Symbol"


def stands_for(symbol: Symbol) -> Symbol:
    """The notes' symbol in whose place a symbol stands: itself, if it is one of the notes'."""
    return symbol.stands if isinstance(symbol, Written) else symbol
