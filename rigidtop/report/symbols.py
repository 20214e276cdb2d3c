"""The symbols that a document uses, as its list of symbols."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from sympy import Symbol

from rigidtop.report.blocks import Block, Display, Heading, Symbols
from rigidtop.theory.lettered import known
from rigidtop.typeset.layout import layout
from rigidtop.typeset.sentences import printed_unit


def symbol_list(blocks: Sequence[Block], heading: Heading) -> tuple[Block, ...]:
    """The symbols of all displays under a heading; nothing where there are none.

    They stand in the order of first use, each letter with all that is made of it.
    """
    rows = []
    letters: dict[str, int] = {}
    for symbol in dict.fromkeys(_in_order(blocks)):
        place, quantity = known(symbol)
        if quantity is not None and quantity.glyph.base != "const":
            at = letters.setdefault(quantity.glyph.base, len(letters))
            row = (layout(symbol), quantity.meaning, printed_unit(quantity.unit))
            rows.append(((at, len(quantity.glyph.accent), place, symbol.name), row))
    shown = tuple(row for _, row in sorted(rows, key=lambda pair: pair[0]))
    return (heading, Symbols(shown)) if shown else ()


def symbols_used(blocks: Iterable[Block]) -> set[Symbol]:
    """The symbols of all displays."""
    return set(_in_order(blocks))


def _in_order(blocks: Iterable[Block]) -> Iterator[Symbol]:
    for block in blocks:
        if isinstance(block, Display):
            for row in block.rows:
                for side in row.equation.sides:
                    yield from sorted(side.free_symbols, key=lambda x: (known(x)[0], x.name))
