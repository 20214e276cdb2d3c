"""The symbols that a document uses, as its list of symbols."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

from sympy import Symbol

from rigidtop.report.blocks import Block, Display, Heading, Symbols
from rigidtop.theory.lettered import Lettered
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.layout import layout
from rigidtop.typeset.sentences import printed_unit


def symbol_list(
    blocks: Sequence[Block], order: Mapping[str, int] | None = None
) -> tuple[Block, ...]:
    """The symbols of all displays under a heading; nothing where there are none.

    They stand in an `order` of their names, or in that of the vocabulary.
    """
    used = symbols_used(blocks)
    names = {symbol.name for symbol in used if not isinstance(symbol, Lettered)}
    # A symbol of another notation stands where that of the notes does, others before.
    own = {x for x in used if isinstance(x, Lettered)}
    alone = sorted((x for x in own if x.stands is None), key=lambda x: (x.place, x.name))
    placed = {x.place: x for x in own if x.stands is not None}
    quantities = [(symbol, symbol.quantity) for symbol in alone]
    for place, (symbol, quantity) in enumerate(VOCABULARY.items()):
        if symbol.name in names:
            quantities.append((symbol, quantity))
        if place in placed:
            quantities.append((placed[place], placed[place].quantity))
    if order is not None:
        quantities.sort(key=lambda pair: order.get(pair[0].name, len(order)))
    rows = tuple(
        (layout(symbol), quantity.meaning, printed_unit(quantity.unit))
        for symbol, quantity in quantities
        if quantity.glyph.base != "const"
    )
    return (Heading(1, "", "Symbols", "symbols"), Symbols(rows)) if rows else ()


def symbols_used(blocks: Iterable[Block]) -> set[Symbol]:
    """The symbols of all displays."""
    return {
        symbol
        for block in blocks
        if isinstance(block, Display)
        for row in block.rows
        for side in row.equation.sides
        for symbol in side.free_symbols
    }
