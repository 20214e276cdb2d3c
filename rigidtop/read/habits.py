"""What an author's file says of its formulas."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from rigidtop.read.kinds import Sort, Spoken
from rigidtop.read.macros import Macros
from rigidtop.theory.symbols import Glyph


@dataclass(frozen=True)
class Habits:
    """Macros, and what letters are: by the formulas that they stand in, and by the file's words."""

    macros: Macros = field(default_factory=dict)
    functions: frozenset[tuple[Glyph, str]] = frozenset()
    """A letter and one that it is a function of: V and x."""
    timed: frozenset[Glyph] = frozenset()
    """Letters that depend on the time: x(t)."""
    said: Mapping[Glyph, Spoken] = field(default_factory=dict)
    """What the words say that a letter is."""
    letters: frozenset[str] = frozenset()
    """Letters that stand alone in the file: a row of them may be their product.

    π is one where it is what an equation is for, or has a dot.
    """
    components: frozenset[tuple[str, str]] = frozenset()
    """A letter and a number above it that may be an index, since the file has x¹ or x^μ."""
    conditions: bool = False
    """Whether words behind a line, "for θ ≠ 0", are taken in the letters of a table too."""
    signs: bool = False
    """Whether ±, ≤, … and dots are taken in the letters of a table too."""

    def is_a(self, glyph: Glyph, sort: Sort) -> bool:
        """Whether the words say that a letter is of that sort."""
        return glyph in self.said and self.said[glyph].sort is sort

    def kind(self, glyph: Glyph) -> str:
        """The kind of quantity that the words say a letter is, if they do."""
        return self.said[glyph].kind if glyph in self.said else ""


NO_HABITS = Habits()
"""No macros, no functions, no words."""
