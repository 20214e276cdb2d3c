"""What a notation writes otherwise: as sentences, rows of a table and records."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import asdict

from sympy import Symbol

from rigidtop.notation import Notation
from rigidtop.report.blocks import Block, Paragraph, SectionHead, TableBlock, listed
from rigidtop.report.wording import Wording
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered, stands_for
from rigidtop.theory.symbols import VOCABULARY
from rigidtop.typeset.layout import layout
from rigidtop.typeset.text import text
from rigidtop.typeset.words import unmarked

TURNS = {"zyz": "z–y′–z″", "zxz": "z–x′–z″"}
WORDS = "The numbers of the equations are those of the notes."


def turns(notation: Notation) -> str:
    """The sequence of the Euler angles, in words.

    >>> from rigidtop.notation import GOLDSTEIN
    >>> turns(GOLDSTEIN)
    'Euler angles $z–x′–z″$: $R = Rz(φ) Rx(θ) Rz(ψ)$'
    """
    first, second, third = (text(notation.letters.get(x, x)) for x in (s.phi, s.theta, s.psi))
    axis = notation.sequence[1]
    product = f"Rz({first}) R{axis}({second}) Rz({third})"
    return f"Euler angles ${TURNS[notation.sequence]}$: $R = {product}$"


def different(notation: Notation, among: Iterable[Symbol] | None = None) -> list[Lettered]:
    """The symbols that look or mean otherwise than in the notes, in order of print."""
    used = None if among is None else set(among)
    return [
        letter
        for symbol, letter in notation.letters.items()
        if (used is None or letter in used) and letter.quantity != VOCABULARY[symbol]
    ]


def rows(notation: Notation) -> list[list[str]]:
    """Letter, the same in the notes, name in code, meaning."""
    means = Wording(notation).meaning
    return [
        [text(x), text(notation.in_notes(x)), x.name, unmarked(means(x.quantity.meaning))]
        for x in different(notation)
    ]


def record(notation: Notation) -> dict[str, object]:
    """The notation as plain values, for `rigidtop notation --json`."""
    means = Wording(notation).meaning
    return {
        "name": notation.name,
        "title": notation.title,
        "source": notation.source,
        "note": unmarked(notation.note),
        "euler": notation.sequence,
        "symbols": [
            {
                "symbol": stands_for(x).name,
                "name": x.name,
                "letter": text(x),
                "notes": text(notation.in_notes(x)),
                "glyph": asdict(x.quantity.glyph),
                "meaning": unmarked(means(x.quantity.meaning)),
                "unit": x.quantity.unit,
            }
            for x in different(notation)
        ],
    }


def origin(notation: Notation) -> str:
    """Whose notation it is, where that can be read, and its Euler angles."""
    return f"Notation: {notation.title} ({notation.source}). {turns(notation)}."


def front(notation: Notation, used: Iterable[Symbol]) -> list[Block]:
    """A section about the notation and its symbols, of those that are `used`."""
    blocks: list[Block] = [SectionHead(1, "", "Notation", "notation")]
    blocks.append(Paragraph((origin(notation).removeprefix("Notation: "),)))
    symbols = different(notation, used)
    if notation.images:
        blocks.append(Paragraph((f"{notation.note} {WORDS}".strip(),)))
    if symbols:
        means = Wording(notation).meaning
        cells = tuple(
            (means(x.quantity.meaning), layout(x), layout(notation.in_notes(x))) for x in symbols
        )
        head = ("meaning", "here", "in the notes")
        blocks.append(TableBlock(head, cells, "Written otherwise", "text", (0.62, 0, 0)))
    return blocks


def remark(notation: Notation, used: Iterable[Symbol]) -> list[Block]:
    """The same for a single claim, in one paragraph; nothing in the notation of the notes."""
    if not notation.images:
        return []
    letters = different(notation, used)
    others = listed((layout(x), " is ", layout(notation.in_notes(x))) for x in letters)
    rest = (" Here ", *others, " of the notes.") if letters else ()
    return [Paragraph((f"As in {notation.title}; {turns(notation)}.", *rest), "Notation")]
