"""The symbols that a document uses, as its list of symbols."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from sympy import Basic, Symbol, elliptic_f, elliptic_k

from rigidtop.report.blocks import Block, Display, Heading, Table, in_unit
from rigidtop.theory.lettered import known
from rigidtop.theory.symbols import Glyph, Quantity
from rigidtop.typeset.layout import layout


def symbol_list(blocks: Sequence[Block], heading: Heading) -> tuple[Block, ...]:
    """The symbols of all displays under a heading; nothing where there are none.

    They stand in the order of first use, each letter with all that is made of it.
    """
    rows = []
    letters: dict[str, int] = {}
    for symbol in dict.fromkeys(_in_order(blocks)):
        place, quantity = _quantity(symbol)
        if quantity is not None and quantity.glyph.base != "const":
            at = letters.setdefault(quantity.glyph.base, len(letters))
            row = (layout(symbol), quantity.meaning, in_unit(quantity.unit))
            rows.append(((at, len(quantity.glyph.accent), place, str(symbol)), row))
    shown = tuple(row for _, row in sorted(rows, key=lambda pair: pair[0]))
    head = ("symbol", "meaning", "unit")
    return (heading, Table(head, shown, "", "symbols", (0, 1, 0))) if shown else ()


def symbols_used(blocks: Iterable[Block]) -> set[Symbol]:
    """The symbols of all displays."""
    return {symbol for symbol in _in_order(blocks) if isinstance(symbol, Symbol)}


INTEGRALS = {
    elliptic_f: Quantity(Glyph("F"), "Legendre's integral of the first kind", "1"),
    elliptic_k: Quantity(Glyph("K"), "Legendre's complete integral of the first kind", "1"),
}
"""Functions that have no letter in the vocabulary."""


def _quantity(symbol: Basic) -> tuple[int, Quantity | None]:
    return known(symbol) if isinstance(symbol, Symbol) else (0, INTEGRALS[symbol.func])


def _in_order(blocks: Iterable[Block]) -> Iterator[Basic]:
    """The letters of displays, and the integrals that have one."""
    for block in blocks:
        if isinstance(block, Display):
            for row in block.rows:
                for side in row.equation.sides:
                    used = side.free_symbols | side.atoms(*INTEGRALS)
                    yield from sorted(used, key=lambda x: (_quantity(x)[0], str(x)))
