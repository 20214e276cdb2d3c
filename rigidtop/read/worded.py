"""Words in a formula: conditions, units, names of functions and of quantities."""

from __future__ import annotations

from collections.abc import Iterator

from rigidtop.read import signs
from rigidtop.read.calculus import Calculus
from rigidtop.read.cursor import Token
from rigidtop.read.look import mathematical
from rigidtop.read.tex import UPRIGHT, UnreadError, plain, said
from rigidtop.theory.symbols import Glyph


class Words(Calculus):
    """Takes words."""

    def constant_spelled(self) -> bool:
        for word in ("constant", "const"):
            if all(self.peek(i).text == letter for i, letter in enumerate(word)):
                self.at += len(word)
                if self.peek().text == "." and word == "const" and self.depth:
                    self.take()
                return True
        return False

    def are_words(self) -> bool:
        """Whether text is more than a letter; in a table's letters an index may be upright."""
        written = plain(self.peek(1))
        if self.open:
            return written != "d" and not (self.peek().text in UPRIGHT and len(written) < 2)
        named = written in signs.WORDS or written.strip(". ") in signs.CONSTANT or len(written) > 3
        return named or self.peek().text not in UPRIGHT

    def words(self) -> Iterator[Token]:
        piece = self.take()
        inner = self.argument(piece)
        written = said(inner)
        bare = written.strip(" .,;:")
        if not bare:
            yield Token("SEPARATOR" if written and not self.depth else "SPACE", "", piece.position)
        elif bare.lower().removeprefix("a ") in signs.CONSTANT:
            yield Token("CONSTANT", "const", piece.position)
        elif bare in signs.WORDS or (bare in signs.ELLIPTIC and not self.open):
            yield from self.function({"ln": "log", "Tr": "tr"}.get(bare, bare), piece.position)
        elif bare in ("Re", "Im"):
            raise UnreadError("a real or imaginary part: that is not read", piece.position)
        elif signs.NUMBER_OF.fullmatch(bare):
            yield Token("TAG", bare.strip("()"), piece.position)
        elif mathematical(inner):
            if self.open and bare.split()[0].lower() in signs.CONDITIONS and not self.depth:
                yield Token("WORDS", bare, piece.position)
                return
            raise UnreadError("mathematics in words inside a formula", piece.position)
        elif self.commented >= 0 and self.at - self.commented <= 3:
            return
        elif not self.open and bare.lower() == "and" and not self.depth:
            yield Token("SEPARATOR", bare, piece.position)
        elif not self.open and (self.depth or bare.split()[0].lower() not in signs.CONDITIONS):
            raise UnreadError(f"words inside a formula: {bare!r}", piece.position)
        elif not self.open:
            yield Token("WORDS", bare, piece.position)
        elif self.is_unit(bare):
            base = (bare if len(bare) > 1 else f" {bare}").replace(" ", "\u2009")  # no mass m
            if self.peek().text == "^" and not bare.isalpha():  # of the last one, as in m/s^2
                base += self.take().text + plain(*self.argument(piece))
            yield Token("SYMBOL", self.notation.symbol(Glyph(base)), piece.position)
        elif self.is_quantity(bare):
            yield Token("SYMBOL", self.notation.symbol(self.scripts(Glyph(bare))), piece.position)
        elif piece.text in signs.UPRIGHT_ALONE and bare.isalnum():
            raise UnreadError(f"the function {bare} is not known", piece.position)
        elif self.depth:
            raise UnreadError(f"words inside a formula: {bare[:40]!r}", piece.position)
        else:
            yield Token("WORDS", bare, piece.position)

    def is_unit(self, written: str) -> bool:
        """Whether words are a unit: behind a number any short one is, or what has a stroke."""
        if self.last == "NUMBER" and self.peek().text == "^":
            return True
        if self.last == "NUMBER" and written.lower() not in signs.CONDITIONS | signs.CONNECTIVES:
            return signs.SHORT.fullmatch(written) is not None
        ended = self.last in ("_END", "CLOSE") or (self.last == "SYMBOL" and "/" in written)
        return ended and signs.UNIT.fullmatch(written) is not None

    def is_quantity(self, written: str) -> bool:
        """Whether words stand where a quantity would: with nothing but signs around them."""
        if (
            len(written) > 40
            or not any(map(str.isalpha, written))
            or written[0] == "("
            or written.split()[0].lower() in signs.CONDITIONS | signs.CONNECTIVES
        ):
            return False
        self.skip()
        behind = self.peek().text
        ends = {"", ")", "]", r"\right"} if self.depth or self.last in signs.BEFORE_LAST else set()
        follows = behind in signs.SIGNS_AROUND | ends
        aligned = behind == "&" and self.peek(1).text in signs.SIGNS_AROUND
        return self.last in signs.BEFORE and (follows or aligned)
