"""Two sides of a line of somebody's notes, and what becomes of it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

from sympy import Expr, Symbol

from rigidtop.mark.law import Law, put_in
from rigidtop.proof.verdict import Verdict
from rigidtop.read.formula import Line

PREMISE = "premise"
"""Said of what is taken as it stands: a law, a quantity of the file's own, a special motion."""

UNREAD = "unread"
"""Said of what is not understood."""


@dataclass(frozen=True)
class Held:
    """What became of a line; `rests` are the numbers of the lines that it follows from."""

    line: Line
    verdict: str
    note: str = ""
    rests: tuple[int, ...] = ()

    @property
    def passed(self) -> bool | None:
        """None: it was not judged."""
        if self.verdict == PREMISE:
            return None
        return self.verdict in _HOLDS


_HOLDS = frozenset(v.value for v in (Verdict.PROVED, Verdict.SAMPLED, Verdict.ASSUMING))


@dataclass(frozen=True)
class Case:
    """Two sides of a line as they are written, and their values with all that is said put in.

    `rests` are the lines that say so; `inner` is a link of a chain behind the first one.
    """

    number: int
    line: Line
    left: Expr
    right: Expr
    sides: tuple[Expr, Expr]
    rests: frozenset[int]
    inner: bool = False
    along: bool = False
    """Whether every letter is one of the law's, or of what is said."""
    closed: bool = False
    """Whether the file says by itself what the line must be, in any case."""
    solvable: bool = False
    """Whether numbers for its letters make it hold."""

    @property
    def residual(self) -> Expr:
        return self.sides[0] - self.sides[1]

    @property
    def symbols(self) -> set[Symbol]:
        return letters(self.sides[0]) | letters(self.sides[1])

    def said(self, verdict: str, note: str, law: Law | None = None) -> Held:
        """What becomes of the line, which rests on what was put in, and on a law."""
        rests = self.rests | (law.rests if law is not None else set())
        return Held(self.line, str(verdict), note, tuple(sorted(rests - {self.number})))

    def assuming(self, *conditions: str, law: Law | None = None) -> Held:
        said = ", ".join(x.removeprefix("where ") for x in conditions if x)
        return self.said(Verdict.ASSUMING, f"where {said}", law)

    def undecided(self, note: str) -> Held:
        return self.said(Verdict.UNDECIDED, note)

    def where(self, put: Mapping[Symbol, Expr]) -> Case:
        return replace(self, sides=(put_in(self.sides[0], put), put_in(self.sides[1], put)))


def letters(side: Expr | None) -> set[Symbol]:
    return set(getattr(side, "free_symbols", ()))
