"""The symbols that a document uses, as its list of symbols."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType

from sympy import Basic, Symbol, elliptic_f, elliptic_k

from rigidtop.report.blocks import (
    Block,
    Display,
    ExerciseHead,
    Paragraph,
    SectionHead,
    TableBlock,
    in_unit,
)
from rigidtop.theory.lettered import known
from rigidtop.theory.symbols import Glyph, VocabularyEntry
from rigidtop.typeset.latex import latex
from rigidtop.typeset.layout import layout
from rigidtop.typeset.words import parts


def symbol_list(
    blocks: Sequence[Block], heading: SectionHead, letters: Iterable[Symbol] = ()
) -> tuple[Block, ...]:
    """The symbols of all displays under a heading; nothing where there are none.

    They stand in the order of first use, each letter with all that is made of it.  Of `letters`
    those are listed too that the words of a question name.
    """
    spelled: dict[tuple[str, ...], set[Symbol]] = {}
    for letter in (x for x in letters if known(x)[1] is not None):
        spelled.setdefault(_tokens(latex(letter)), set()).add(letter)
    spelled.pop(("1",), None)  # the unit matrix, which no one means by a number
    named = {tokens: next(iter(alike)) for tokens, alike in spelled.items() if len(alike) == 1}
    rows = []
    bases: dict[str, int] = {}
    for symbol in dict.fromkeys(_in_order(blocks, named)):
        place, quantity = _quantity(symbol)
        if quantity is not None and quantity.glyph.base != "const":
            at = bases.setdefault(quantity.glyph.base, len(bases))
            row = (layout(symbol), quantity.meaning, in_unit(quantity.unit))
            rows.append(((at, len(quantity.glyph.accent), place, str(symbol)), row))
    ordered = tuple(row for _, row in sorted(rows, key=lambda pair: pair[0]))
    head = ("symbol", "meaning", "unit")
    return (heading, TableBlock(head, ordered, "", "symbols", (0, 1, 0))) if ordered else ()


def symbols_used(blocks: Iterable[Block]) -> set[Symbol]:
    """The set of symbols that occur in the displays of a document."""
    return {symbol for symbol in _in_order(blocks) if isinstance(symbol, Symbol)}


INTEGRALS = {
    elliptic_f: VocabularyEntry(Glyph("F"), "Legendre's integral of the first kind", "1"),
    elliptic_k: VocabularyEntry(Glyph("K"), "Legendre's complete integral of the first kind", "1"),
}
"""Functions that have no letter in the vocabulary."""


def _quantity(symbol: Basic) -> tuple[int, VocabularyEntry | None]:
    return known(symbol) if isinstance(symbol, Symbol) else (0, INTEGRALS[symbol.func])


def _in_order(
    blocks: Iterable[Block], named: Mapping[tuple[str, ...], Symbol] = MappingProxyType({})
) -> Iterator[Basic]:
    """The letters of displays, the integrals that have one, and what is `named` in questions."""
    asked = False
    for block in blocks:
        asked = isinstance(block, ExerciseHead) or (asked and isinstance(block, Paragraph))
        if asked and isinstance(block, Paragraph):
            for words in (piece for piece in block.content if isinstance(piece, str)):
                for is_maths, formula in parts(words):
                    yield from _spelled(_tokens(formula), named) if is_maths else ()
        if isinstance(block, Display):
            for row in block.rows:
                for side in row.equation.sides:
                    used = side.free_symbols | side.atoms(*INTEGRALS)
                    yield from sorted(used, key=lambda x: (_quantity(x)[0], str(x)))


def _tokens(formula: str) -> tuple[str, ...]:
    r"""The commands and characters of a formula in LaTeX, without braces, spaces and words.

    >>> _tokens(r"\dot{\theta}_0 = 3\ \text{rad/s}")
    ('\\dot', '\\theta', '_', '0', '=', '3')
    """
    written = re.sub(r"\\(?:text|mathrm)\s*\{[^}]*\}", "", formula)
    return tuple(re.findall(r"\\[A-Za-z]+|[^\s{}\\]", written))


def _spelled(tokens: Sequence[str], named: Mapping[tuple[str, ...], Symbol]) -> Iterator[Symbol]:
    """The letters that stand in a formula, at each place the one that is spelled longest.

    What has an index or a prime behind it is another letter.
    """
    longest = max(map(len, named), default=0)
    at = 0
    while at < len(tokens):
        sizes = (n for n in range(longest, 0, -1) if tuple(tokens[at : at + n]) in named)
        size = next(sizes, 0)
        if size and not {*tokens[at + size : at + size + 1]} & {"_", "'"}:
            yield named[tuple(tokens[at : at + size])]
        at += size or 1
