"""Symbols that bring their own letter, for what the vocabulary of the lecture does not have.

Another system has other quantities, or the same letters for others, and so has another notation:
Goldstein's φ is another angle than the φ of the notes.  A `Lettered` symbol knows how it is
written, what it means and its unit; it is never equal to a symbol of the lecture, whatever its
name.  `in_order` gives symbols their order of print: parameters, momenta, rates, angles.

>>> m, k, x = in_order(
...     positive("m", Glyph("m"), "mass of the cart", "kg"),
...     positive("k", Glyph("k"), "stiffness of the spring", "N/m"),
...     real("x", Glyph("x"), "deflection", "m"),
... )
>>> k * x**2 / m
k*x**2/m
>>> x.quantity.meaning, x.place
('deflection', 2)
"""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import sympy

from rigidtop.theory.symbols import VOCABULARY, Glyph, VocabularyEntry


class Symbol(sympy.Symbol):
    """A symbol with its `quantity`; `place` is where it stands in the order of print.

    One of another notation has the symbol of the notes in whose place it `stands`, and SymPy puts
    sums and products of it into the same order.

    It takes two names of SymPy's that are not documented.  Made in the ordinary way, symbols of
    one name and the same assumptions are one object, whatever else they know: `__xnew__` makes a
    new one.  And SymPy tells symbols apart, and puts them in order, by `_hashable_content` alone.
    A `Dummy` is never another either, but it is ordered by a running number, so that factors would
    change places from run to run of a program, and two made alike would not be equal.
    """

    __slots__ = ("_sorted_by", "place", "quantity", "stands")

    quantity: VocabularyEntry
    place: int
    stands: sympy.Symbol | None

    def __new__(
        cls,
        name: str,
        quantity: VocabularyEntry,
        place: int = 0,
        stands: sympy.Symbol | None = None,
        **assumptions: bool,
    ) -> Symbol:
        # SymPy's own cache of symbols knows a name and assumptions only.
        symbol: Symbol = sympy.Symbol.__xnew__(cls, name, **assumptions)
        symbol.quantity, symbol.place, symbol.stands = quantity, place, stands
        symbol._sorted_by = f"{stands_for(symbol).name} {name} {quantity} {place}"
        return symbol

    def __getnewargs_ex__(self) -> Any:
        return (self.name, self.quantity, self.place, self.stands), self.assumptions0

    def _hashable_content(self) -> tuple[Any, ...]:
        _, *assumptions = super()._hashable_content()
        return self._sorted_by, *assumptions


Lettered = Symbol
"""Its name where SymPy's own `Symbol` is at hand."""


def positive(name: str, glyph: Glyph, meaning: str, unit: str) -> Lettered:
    """A symbol for what is positive, such as a mass."""
    return Lettered(name, VocabularyEntry(glyph, meaning, unit), positive=True)


def real(name: str, glyph: Glyph, meaning: str, unit: str) -> Lettered:
    """A symbol for any real number, such as an angle."""
    return Lettered(name, VocabularyEntry(glyph, meaning, unit), real=True)


def matrix(name: str, glyph: Glyph, meaning: str, unit: str) -> Lettered:
    """A symbol for a square matrix, whose entries are in this unit."""
    return Lettered(name, VocabularyEntry(glyph, meaning, unit, matrix=True))


def in_order(*symbols: Lettered) -> tuple[Lettered, ...]:
    """The same symbols, to be printed in this order within a product."""
    return tuple(
        Lettered(symbol.name, symbol.quantity, place, **symbol.assumptions0)
        for place, symbol in enumerate(symbols)
    )


def instead(stands: sympy.Symbol, name: str, glyph: Glyph, meaning: str = "") -> Lettered:
    """What another notation writes for a symbol of the lecture: letter, name in code, meaning.

    >>> from rigidtop.theory.symbols import lambda1
    >>> I1 = instead(lambda1, "I1", Glyph("I", "1"))
    >>> I1, I1.quantity.meaning, stands_for(I1), I1 == lambda1
    (I1, 'principal moment of inertia about $\\\\mathbf e_1$', lambda1, False)
    """
    place, entry = BY_NAME[stands.name]
    quantity = replace(entry, glyph=glyph, meaning=meaning or entry.meaning)
    return Lettered(name, quantity, place, stands, **stands.assumptions0)


def stands_for(symbol: sympy.Symbol) -> sympy.Symbol:
    """The notes' symbol in whose place a symbol stands: itself, if it is of no other notation."""
    return getattr(symbol, "stands", None) or symbol


BY_NAME: dict[str, tuple[int, VocabularyEntry]] = {
    symbol.name: (position, quantity)
    for position, (symbol, quantity) in enumerate(VOCABULARY.items())
}


def known(symbol: sympy.Symbol) -> tuple[int, VocabularyEntry | None]:
    """The place of a symbol in the order of print, and its quantity if it has one.

    A symbol that brings its own letter is looked up nowhere, whatever its name.
    """
    if isinstance(symbol, Lettered):
        return symbol.place, symbol.quantity
    return BY_NAME.get(symbol.name, (len(BY_NAME), None))
