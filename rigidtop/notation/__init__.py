"""Notations: which letters stand for which symbols, in print and when read."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from sympy import Symbol

from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph

MATRICES = frozenset({s.inertia, s.Lambda, s.O_matrix, s.A_matrix, s.B_matrix, s.C_matrix, s.unit})
"""Symbols that stand for square matrices."""


@dataclass(frozen=True)
class Notation:
    """A convention: the glyph of every symbol, and other spellings that are understood too."""

    name: str
    glyphs: Mapping[Symbol, Glyph]
    spellings: Mapping[Glyph, Symbol]

    @property
    def names(self) -> Mapping[Glyph, Symbol]:
        """The symbol of every glyph that is printed or understood."""
        return _names(self)

    def symbol(self, glyph: Glyph) -> Symbol | None:
        """The symbol of a glyph, a missing bold type forgiven where it is no other symbol's."""
        return self.names.get(glyph) or self.names.get(replace(glyph, bold=True))


def _names(notation: Notation) -> Mapping[Glyph, Symbol]:
    return {**notation.spellings, **{glyph: symbol for symbol, glyph in notation.glyphs.items()}}


NOTES = Notation(
    "notes",
    {symbol: quantity.glyph for symbol, quantity in VOCABULARY.items()},
    {
        Glyph("N", "(e)", bold=True): s.N_ext,
        Glyph("F", "k,(e)", bold=True): s.F_k,
        Glyph("F", "grav,M", bold=True): s.F_grav,
        Glyph("ω", "1", prime=True): s.omega1p,
        Glyph("ω", "2", prime=True): s.omega2p,
        Glyph("e", "1′", bold=True): s.e1p,
        Glyph("e", "2′", bold=True): s.e2p,
    },
)
"""The lecture notes."""
