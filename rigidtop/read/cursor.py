"""Going through pieces of TeX from left to right: tokens, and what all that takes them needs."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Any, Self

from rigidtop.notation import Notation
from rigidtop.read import signs
from rigidtop.read.habits import NO_HABITS, Habits
from rigidtop.read.look import below, crossed, infix, lonely_d
from rigidtop.read.tex import BOLD, DEEPEST, NOTHING, Piece, UnreadError, flat
from rigidtop.theory.symbols import Glyph


@dataclass(frozen=True)
class Token:
    """A piece of a formula: what it is, what it stands for, where it begins."""

    kind: str
    value: Any
    position: int


class Cursor:
    """Goes through pieces from left to right.

    In an open notation any letter is one, in any dress.
    """

    def __init__(
        self,
        items: Sequence[Piece],
        notation: Notation,
        habits: Habits = NO_HABITS,
        depth: int = 0,
        outer: Cursor | None = None,
    ) -> None:
        self.level: int = outer.level + 1 if outer is not None else 0
        self.items, self.notation, self.at = list(infix(items, self.level)), notation, 0
        self.open = notation.open
        self.habits = habits
        self.depth = depth
        """Of brackets: commas outside all separate equations, inside entries."""
        self.nested = depth > 0
        self.bars: list[bool] = []
        self.called: int | None = None
        """How deep the function stands whose brackets are open."""
        self.commented = -1
        """Where && stood: words there are a comment."""
        self.pairs: dict[tuple[str, str], tuple[int, dict[int, int]]] = {}
        self.listing: tuple[int, set[int]] = -1, set()  # where brackets open that hold commas
        self.calls: set[int] = set()  # where brackets open that hold arguments
        self.ends: list[tuple[int, str]] = []  # how deep what closes otherwise than it looks
        self.last = ""
        self.worn: dict[Glyph, bool] = outer.worn if outer else {}
        """Whether a bold letter has an arrow, or stands in bold type."""
        texts = set() if outer else {piece.text for piece in flat(items)}
        plainly = self.open and not texts & BOLD and bool(habits.said)
        self.crossed: bool = outer.crossed if outer else plainly and crossed(items)
        """Whether × stands and nothing in bold type: words then make vectors of letters."""
        self.two_signs: bool = outer.two_signs if outer else bool(texts & set(signs.SIGNS))
        self.integrals: bool = outer.integrals if outer else r"\int" in texts
        self.lonely_d: bool = outer.lonely_d if outer else lonely_d(items)
        summed = r"\sum" in texts
        self.below: set[str] = outer.below if outer else set() if summed else below(items)
        """Letters that stand as indices, where nothing is summed."""

    # Moving

    def peek(self, ahead: int = 0) -> Piece:
        """The piece there; an empty one behind the end."""
        i = self.at + ahead
        end = self.items[-1].position + 1 if self.items else 0
        return self.items[i] if i < len(self.items) else Piece("", end)

    def take(self) -> Piece:
        piece = self.peek()
        self.at += 1
        return piece

    def skip(self) -> None:
        self.at = self.behind(self.at)

    def behind(self, at: int, nothing: frozenset[str] = NOTHING) -> int:
        """Where something stands, from a place on."""
        while at < len(self.items) and self.items[at].text in nothing:
            at += 1
        return at

    def argument(self, of: Piece) -> tuple[Piece, ...]:
        r"""What a command takes, with what that takes in turn: ``x_\mathrm{cm}``."""
        self.skip()
        piece = self.take()
        if not piece.text:
            raise UnreadError(f"{of.text} without what it is to act on", of.position)
        if piece.text == "{}":
            return piece.group
        takes = 2 if piece.text in signs.FRACTIONS else piece.text in signs.TAKING
        return (piece, *(self.take() for _ in range(takes) if self.peek().text))

    def within(self, group: Sequence[Piece], depth: int = 0) -> Self:
        """What goes through the pieces of a group."""
        if self.level > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", self.peek().position)
        return type(self)(group, self.notation, self.habits, depth, self)

    def inside(self, group: Sequence[Piece], nested: bool = True) -> Iterator[Token]:
        inner = self.within(group, self.depth + nested)
        inner.called = -1 if self.called is not None else None
        yield from inner.tokens()

    def braced(self, group: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("_BEGIN", "{", position)
        yield from self.inside(group)
        yield Token("_END", "}", group[-1].position + 1 if group else position)

    def closing(self, at: int, pair: tuple[str, str] = ("(", ")")) -> int | None:
        """Where the bracket that opens there closes."""
        known = self.pairs.get(pair)
        if known is None or known[0] != len(self.items):
            opened: list[int] = []
            closes: dict[int, int] = {}
            for i, piece in enumerate(self.items):
                if piece.text == pair[0]:
                    opened.append(i)
                elif piece.text == pair[1] and opened:
                    closes[opened.pop()] = i
            known = self.pairs[pair] = len(self.items), closes
        return known[1].get(at)

    def bracketed(self, at: int, pair: tuple[str, str] = ("(", ")")) -> tuple[list[Piece], int]:
        """What stands in the bracket that opens there, and where it closes; -1 if it does not."""
        end = self.closing(at, pair) if at < len(self.items) else None
        if end is None:
            return [], -1
        return [piece for piece in self.items[at + 1 : end] if piece.text not in NOTHING], end

    def commas(self, at: int) -> bool:
        """Whether commas stand in the bracket that opens there, outside of inner ones."""
        if self.listing[0] != len(self.items):
            opened: list[int] = []
            found: set[int] = set()
            for i, piece in enumerate(self.items):
                text = piece.text.lstrip("\\")
                if text in ("(", "[", "{"):
                    opened.append(i)
                elif text in (")", "]", "}") and opened:
                    opened.pop()
                elif piece.text == "," and opened:
                    found.add(opened[-1])
            self.listing = len(self.items), found
        pair = {"(": ("(", ")"), "[": ("[", "]")}.get(self.items[at].text, (r"\{", r"\}"))
        return at in self.listing[1] and self.closing(at, pair) is not None

    def tokens(self) -> Iterator[Token]:
        """The tokens of all pieces."""
        raise NotImplementedError
