"""What a notation is, and what it does with expressions."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from sympy import Expr, Symbol

from rigidtop.notation.translate import Image, inverse, translated
from rigidtop.theory import symbols as s
from rigidtop.theory.lettered import Lettered, known
from rigidtop.theory.symbols import Glyph

MATRICES = frozenset({s.inertia, s.Lambda, s.O_matrix, s.A_matrix, s.B_matrix, s.C_matrix, s.unit})
"""Symbols of the lecture that stand for square matrices."""


def is_matrix(symbol: Symbol) -> bool:
    """Whether a symbol stands for a square matrix."""
    _, quantity = known(symbol)
    return symbol in MATRICES or (quantity is not None and quantity.matrix)


SEQUENCES: Mapping[str, Mapping[Symbol, Image]] = {
    "zyz": {},
    # Ry(θ) = Rz(π/2) Rx(θ) Rz(−π/2): the line of nodes is e₁′, a quarter turn before e₂′.
    "zxz": {
        s.phi: Image(s.phi, quarters=-1),
        s.psi: Image(s.psi, quarters=1),
        s.e1p: Image(s.e2p, negative=True),
        s.e2p: Image(s.e1p),
        s.omega1p: Image(s.omega2p, negative=True),
        s.omega2p: Image(s.omega1p),
        s.c_phi: Image(s.s_phi),
        s.s_phi: Image(s.c_phi, negative=True),
        s.c_psi: Image(s.s_psi, negative=True),
        s.s_psi: Image(s.c_psi),
    },
}
"""The sequences of Euler angles, and what the notes' symbols are in each: the letters of the same
role, with minus signs and quarter turns.  The claim ``euler-zxz`` proves it."""

MEANINGS: Mapping[str, Mapping[Symbol, str]] = {
    "zyz": {},
    "zxz": {
        s.phi: "first Euler angle: azimuth of the line of nodes",
        s.psi: r"third Euler angle: turn about $\mathbf e_3$ from the line of nodes",
        s.e1p: r"line of nodes: $\mathbf e_1$ after $\phi$",
        s.e2p: r"$\mathbf e_2$ before the last Euler rotation",
    },
}
"""What the letters mean there, where that is not what they mean in the notes."""


@dataclass(frozen=True)
class Notation:
    """A convention: the glyph of every symbol, and other spellings that are understood too.

    `glyphs` and `spellings` have the notes' symbols as names of roles: where the sequence of the
    Euler angles is z–x′–z″, the glyph of `phi` is that of the first angle about z, which is another
    angle than the notes'.  `letters` are the symbols of this notation for those roles whose letter
    or meaning is not the notes'.
    """

    name: str
    glyphs: Mapping[Symbol, Glyph]
    spellings: Mapping[Glyph, Symbol]
    title: str = ""
    source: str = ""
    note: str = ""
    sequence: str = "zyz"
    letters: Mapping[Symbol, Lettered] = field(default_factory=dict)

    @cached_property
    def names(self) -> Mapping[Glyph, Symbol]:
        """The symbol of every glyph that is printed or understood."""
        return {**self.spellings, **{glyph: symbol for symbol, glyph in self.glyphs.items()}}

    def symbol(self, glyph: Glyph) -> Symbol | None:
        """The symbol of a glyph, a missing bold type forgiven where it is no other symbol's."""
        return self.names.get(glyph) or self.names.get(replace(glyph, bold=True))

    def written(self, tree: Expr) -> Any:
        """An expression, matrix, condition or `Equation` of the notes, in this notation's symbols.

        Where the Euler angles differ, φ and ψ are shifted by a quarter turn.  It stays typed.
        """
        return translated(tree, self.images)

    def named(self, tree: Expr) -> Any:
        """As `written`; a letter alone is the name of an angle, wherever that is counted from."""
        image = self.images.get(tree) if isinstance(tree, Symbol) else None
        return image.symbol if image is not None and image.quarters else self.written(tree)

    def axis(self, tree: Expr) -> Any:
        """The axis as `named`; an axis is no direction, so that −e₂′ is e₂′."""
        image = self.images.get(tree) if isinstance(tree, Symbol) else None
        return image.symbol if image is not None and image.negative else self.named(tree)

    def in_notes(self, tree: Expr) -> Expr:
        """The way back: what is in this notation's symbols, in those of the notes."""
        return translated(tree, self._back)

    def read(self, tree: Expr) -> Any:
        """What was read by this notation's glyphs, in the symbols of the notes.

        The reader names a role, `phi` for what is written φ; here it becomes what it means.
        """
        own = {role: Image(letter) for role, letter in self.letters.items()}
        return self.in_notes(translated(tree, own))

    @cached_property
    def images(self) -> Mapping[Symbol, Image]:
        """What becomes of the notes' symbols, of those that do not stay as they are."""
        turned = SEQUENCES[self.sequence]
        roles = {symbol: turned.get(symbol, Image(symbol)) for symbol in self.glyphs}
        return {
            symbol: replace(image, symbol=self.letters[image.symbol])
            for symbol, image in roles.items()
            if image.symbol in self.letters
        }

    @cached_property
    def _back(self) -> Mapping[Symbol, Image]:
        return inverse(self.images)
