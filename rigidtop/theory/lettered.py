"""Symbols that bring their own letter, for what the vocabulary of the lecture does not have.

Another system has other quantities, or the same letters for others.  A `Lettered` symbol knows how
it is written, what it means and its unit; it is never equal to a symbol of the lecture, whatever
its name.  `in_order` gives symbols their order of print: parameters, momenta, rates, angles.

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

from typing import Any

from sympy import Symbol

from rigidtop.theory.symbols import VOCABULARY, Glyph, Quantity


class Lettered(Symbol):
    """A symbol with its `quantity`; `place` is where it stands in the order of print."""

    __slots__ = ("place", "quantity")

    quantity: Quantity
    place: int

    def __new__(
        cls, name: str, quantity: Quantity, place: int = 0, **assumptions: bool
    ) -> Lettered:
        cls._sanitize(assumptions, cls)
        # SymPy's own cache of symbols knows a name and assumptions only.
        made = Symbol.__xnew__(cls, name, **assumptions)
        made.quantity, made.place = quantity, place
        return made

    def __getnewargs_ex__(self) -> Any:
        return (self.name, self.quantity, self.place), self._assumptions_orig

    def _hashable_content(self) -> tuple[Any, ...]:
        return (*super()._hashable_content(), repr(self.quantity), self.place)


def positive(name: str, glyph: Glyph, meaning: str, unit: str) -> Lettered:
    """A symbol for what is positive, such as a mass."""
    return Lettered(name, Quantity(glyph, meaning, unit), positive=True)


def real(name: str, glyph: Glyph, meaning: str, unit: str) -> Lettered:
    """A symbol for any real number, such as an angle."""
    return Lettered(name, Quantity(glyph, meaning, unit), real=True)


def in_order(*symbols: Lettered) -> tuple[Lettered, ...]:
    """The same symbols, to be printed in this order within a product."""
    return tuple(
        Lettered(symbol.name, symbol.quantity, place, **symbol._assumptions_orig)
        for place, symbol in enumerate(symbols)
    )


BY_NAME: dict[str, tuple[int, Quantity]] = {
    symbol.name: (position, quantity)
    for position, (symbol, quantity) in enumerate(VOCABULARY.items())
}


def known(symbol: Symbol) -> tuple[int, Quantity | None]:
    """The place of a symbol in the order of print, and its quantity if it has one.

    A symbol that brings its own letter is looked up nowhere, whatever its name.
    """
    if isinstance(symbol, Lettered):
        return symbol.place, symbol.quantity
    return BY_NAME.get(symbol.name, (len(BY_NAME), None))
