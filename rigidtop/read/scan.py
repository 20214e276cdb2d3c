r"""A formula taken apart: the tokens of our pages, and of anyone's notes, with their places.

What has a meaning only in TeX ends here: spacing, sizes of brackets, fonts, accents, scripts.  A
letter with its font, accent, index and prime is one token: the symbol that the notation has for
it, or, if the notation is open, a symbol of its own.  Where a text could mean two things it is not
read, and the reason says which two.

>>> from rigidtop.notation import OWN
>>> [token.kind for token in tokens(r"V(x) = \int_0^x F\,dx", OWN)][:6]
['SYMBOL', 'OF', 'SYMBOL', 'FO', 'RELATION', 'INTEGRAL']
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import replace
from typing import Any

from rigidtop.notation import Notation
from rigidtop.notation.convention import own
from rigidtop.read import signs
from rigidtop.read.cursor import Token
from rigidtop.read.environments import Environments
from rigidtop.read.look import length, mathematical, operator_at, spelling
from rigidtop.read.tex import (
    DEEPEST,
    NOTHING,
    TEXTS,
    Piece,
    UnreadError,
    commands,
    pieces,
    plain,
    said,
)
from rigidtop.theory.symbols import Glyph

MOST = 4_000
"""A formula has no more tokens."""

DIGITS = 40
"""A number has no more digits."""


def tokens(text: str, notation: Notation) -> list[Token]:
    """The tokens of a formula, of one line or more; `UnreadError` says what and where if not."""
    return limited(Scan(pieces(text), notation))


def limited(scan: Scan) -> list[Token]:
    """All tokens, if they are not too many."""
    found: list[Token] = []
    for token in scan.tokens():
        found.append(token)
        if len(found) > MOST:
            raise UnreadError(f"more than {MOST} symbols and signs", token.position)
    return found


class Scan(Environments):
    """Takes all that stands in formulas."""

    def tokens(self) -> Iterator[Token]:
        """Outside all brackets what can't be read is a token too, and the rest is read on."""
        while self.at < len(self.items):
            begun = self.at
            try:
                for token in self.next():
                    self.last = token.kind
                    yield token
            except UnreadError as error:
                if self.nested:
                    raise
                closes = _CLOSES.get(self.items[begun].text, "")
                end = self.closing(begun, (self.items[begun].text, closes)) if closes else None
                if end is None or self.at > begun + 1:
                    end = begun
                self.at = max(self.at, end + 1)
                while self.peek().text in ("_", "^", "{}"):
                    self.at += 1  # what it takes, or stands in brackets, is no equation of its own
                yield Token("UNREAD", error, error.position)

    def next(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        single = self.single()
        if single is not None:
            yield Token(*single, position)
        elif text in _TAKES:
            yield from _TAKES[text](self)
        elif text in NOTHING or text in signs.LEFT_OUT:
            self.take()
            if text == r"\right" and self.peek().text == ".":
                self.take()
        elif text in signs.SKIPPED:
            self.at += 1 + (self.peek(1).text == "*")
            if text == r"\label" and self.peek().text == "[":  # cleveref's kind of it
                self.at = 1 + (self.closing(self.at, ("[", "]")) or self.at)
            self.argument(piece)
        elif text == r"\underline" and not self.is_letter(self.at):
            self.take()
        elif text in signs.REFUSED:
            raise UnreadError(f"{signs.REFUSED[text]}: that is not read", position)
        elif text in signs.BRACKETS:
            yield from self.sign()
        elif text in signs.DECIMALS or (text == "." and self.peek(1).text in signs.DECIMALS):
            yield self.number()
        elif text == ".":
            self.take()
            if self.depth:
                raise UnreadError("a full stop inside a formula", position)
            yield Token("SEPARATOR", text, position)
        elif text == r"\\":
            self.at += 1 + length(self.items[self.at + 1 : self.at + 13])
            yield Token("LINE", text, position)
        elif text == "&":
            self.take()
            if self.peek(-2).text == "&" and self.at > 1:
                self.commented = self.at
            yield Token("ALIGN", text, position)
        elif text in signs.FUNCTIONS:
            self.take()
            yield from self.function(text[1:].replace("ln", "log"), position)
        elif text in signs.BETWEEN:
            self.take()
            between = self.argument(piece)
            yield Token("LINE", text, position)
            if mathematical(between):
                reason = "mathematics between the lines: write it as a line of its own"
                yield Token("UNREAD", UnreadError(reason, position), position)
                yield Token("LINE", text, position)
        elif text in signs.OVER and self.peek(1).text == "{}" and not self.is_letter(self.at):
            self.take()
            yield Token("RATE", signs.OVER[text], position)
            yield from self.braced(self.argument(piece), position)
        elif self.constant_spelled():
            yield Token("CONSTANT", "const", position)
        elif text in TEXTS and self.are_words():
            yield from self.words()
        else:
            yield from self.symbol()

    def single(self) -> tuple[str, Any] | None:
        """What is one token and takes nothing with it; what our pages do not have is refused."""
        text, behind, position = self.peek().text, self.peek(1).text, self.peek().position
        count, reason = 1, ""
        found: tuple[str, Any] = ("", "")
        if (text, behind) in ((":", "="), ("=", ":")):
            count, found = 2, ("RELATION", "≡")
        elif text in signs.RELATIONS:
            found = ("RELATION", signs.RELATIONS[text])
            reason = "" if text in signs.JUDGED else "a relation that is not read"
        elif text in signs.SPACES:
            found = ("SPACE", text)
        elif text in signs.ARROWS:
            found = ("ARROW", text)
        elif text in (",", ";") or (text == ":" and not self.depth):
            found = ("COMMA" if self.depth else "SEPARATOR", text)
        elif text in signs.SIGNS:
            found = ("SIGNS", signs.SIGNS[text])
            reason = "two signs at once: write an equation for each"
            if self.is_measured():
                raise UnreadError("± of a measured number: how far it may be off", position)
        elif text in signs.OMITTED or (text == behind == self.peek(2).text == "."):
            count, found = 1 if text in signs.OMITTED else 3, ("SYMBOL", own(Glyph("…")))
            reason = "dots for what is left out"
            if self.last == "NUMBER" and self.items[self.at - 1].text in signs.DECIMALS:
                raise UnreadError("a number of which digits are left out", position)
        if not found[0]:
            return None
        if reason and not (self.open or self.habits.signs):
            raise UnreadError(reason, position)
        self.at += count
        return found

    def is_measured(self) -> bool:
        """Whether ± stands between numbers with decimals."""
        around = [piece.text for piece in self.items[max(0, self.at - 6) : self.at + 7]]
        ahead = self.peek(self.behind(self.at + 1) - self.at).text
        return self.last == "NUMBER" and ahead in signs.DECIMALS and "." in around

    def number(self) -> Token:
        first = self.peek()
        digits = ""
        while self.peek().text in signs.DECIMALS or (
            self.peek().text == "." and self.peek(1).text in signs.DECIMALS and "." not in digits
        ):
            if digits and self.peek().position > self.items[self.at - 1].position + 1:
                raise UnreadError("two numbers side by side", self.peek().position)
            digits += self.take().text
            if len(digits) > DIGITS:
                raise UnreadError(f"a number of more than {DIGITS} digits", first.position)
        if (
            self.open
            and not self.nested
            and (signs.DECIMAL_UNIT if "." in digits else signs.UNITED).match(self.written())
        ):
            reason = "its unit, or factors? put a unit in \\text{}"
            raise UnreadError(reason, self.peek().position)
        return Token("NUMBER", digits, first.position)

    def written(self) -> str:
        """What stands next, as it is written."""
        made, end = "", self.items[self.at - 1].position + 1
        for piece in self.items[self.at : self.at + 24]:
            made += " " * (piece.position > end)
            made += f"{{{plain(piece)}}}" if piece.text == "{}" else piece.text
            end = piece.position + len(piece.text)
        return made

    def tag(self) -> Iterator[Token]:
        piece = self.take()
        if piece.text in (r"\eqno", r"\leqno"):
            number = ""
            while self.peek().text and self.peek().text != r"\\":
                number += self.take().text
        else:
            number = plain(*self.argument(piece))
        yield Token("TAG", number.strip("()$ "), piece.position)

    def stacked(self) -> Iterator[Token]:
        """What stands above a relation is a comment, unless it is a relation too."""
        piece = self.take()
        above = self.argument(piece)
        below = list(self.inside(self.argument(piece), nested=False))
        if [token.kind for token in below] not in (["RELATION"], ["ARROW"]):
            raise UnreadError("a sign above what is no relation", piece.position)
        if mathematical(above):
            raise UnreadError("a relation above a relation", piece.position)
        yield from below

    def symbol(self) -> Iterator[Token]:
        position = self.peek().position
        sign, count = operator_at(self.items, self.at)
        word = self.spelled()
        if word in ("Re", "Im") and not (word == "Re" and self.peek(2).text in ("=", "")):
            raise UnreadError("a real or imaginary part: that is not read", position)
        if word in signs.DOUBTFUL | {"ve"}:
            raise UnreadError(f"{word}: a function, or a product of letters?", position)
        if word and signs.SEGMENT.fullmatch(word):
            raise UnreadError(
                f"{word}: a name, of a distance say, or a product of letters?", position
            )
        if sign:
            yield from self.operator(sign, count)
        elif word in signs.SPELLED:
            self.at += len(word)
            yield from self.function(word, position)
        elif word:
            reason = "a word or a product? put words in \\text{}, spaces between letters"
            raise UnreadError(f"{word}: {reason}", position)
        else:
            yield from self.lettered()

    # Brackets

    def sign(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        called = self.at in self.calls
        row = text == "[" and self.is_row(self.at)
        if self.open and text in ("[", r"\{") and not (called or row) and self.commas(self.at):
            reason = "brackets with a comma: an interval, a row, a commutator or a Poisson bracket?"
            raise UnreadError(reason, position)
        entries = row or (text == "(" and self.last != "FUNCTION" and self.commas(self.at))
        end = self.closing(self.at, ("[", "]")) if text == "[" else None
        apart = [p.text for p in self.items[self.at : end or self.at] if p.text in signs.APART]
        if self.open and (row or len(apart) > 1) and not self.commas(self.at):
            raise UnreadError("a row without commas: a vector, or a product?", position)
        applied = text == "(" and self.last == "CLOSE"
        if self.open and applied and self.one_letter(self.bracketed(self.at)[0]):
            reason = "brackets of what stands in the next, or times it?"
            raise UnreadError(reason, position)
        alone = text == "[" and self.one_letter(self.bracketed(self.at, ("[", "]"))[0])
        if self.open and alone and not (called or row):
            raise UnreadError("a letter in square brackets: its unit, or a factor?", position)
        self.take()
        if called or entries:
            kind, closes = ("OF", "FO") if called else ("LIST", "TSIL")
            self.depth += 1
            self.ends.append((self.depth, closes))
            yield Token(kind, "(", position)
            return
        if text in (")", "]") and self.ends and self.ends[-1][0] == self.depth:
            self.depth -= 1
            yield Token(self.ends.pop()[1], ")", position)
            return
        kind = signs.BRACKETS[text]
        self.depth += (kind in ("OPEN", "LIST")) - (kind in ("CLOSE", "TSIL"))
        if self.depth > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", position)
        self.depth = max(self.depth, 0)
        if self.called is not None and self.depth <= self.called:
            self.called = None
        yield Token(kind, text, position)
        if kind == "SUM":
            yield from self.under()
        elif kind in ("CLOSE", "TSIL"):
            yield from self.frame()

    def is_row(self, at: int) -> bool:
        """Whether square brackets hold the components of a vector: three, or two in a column."""
        end = self.closing(at, ("[", "]"))
        if end is None:
            return False
        count = sum(piece.text == "," for piece in self.items[at:end])
        raised = self.items[end + 1 : end + 2] and self.items[end + 1].text == "^"
        above = plain(*self.items[end + 2 : end + 3])
        return bool(raised and above in signs.TRANSPOSED) or (count == 2 and self.commas(at))

    def frame(self) -> Iterator[Token]:
        """An index behind brackets is a place, (…)_{x=0}, or the frame of a rate."""
        if self.peek().text != "_":
            return
        if "=" in plain(self.peek(1)):
            yield from self.taken_at(self.peek().position)
            return
        piece = self.take()
        yield Token("FRAME", plain(*self.argument(piece)), piece.position)

    def left(self) -> Iterator[Token]:
        r"""``\left``, whose ``\right`` may be a full stop, or a bar with a place."""
        start, position = self.at, self.peek().position
        inner, end = self.items[start + 2 :], self.closing(start, (r"\left", r"\right"))
        opens, closes = self.peek(1).text, ""
        if end is not None and end + 1 < len(self.items):
            inner, closes = self.items[start + 2 : end], self.items[end + 1].text
        if opens in ("<", r"\langle"):
            raise UnreadError(f"{signs.REFUSED[chr(92) + 'langle']}: that is not read", position)
        if end is None or (opens != "." and closes != "." and opens not in signs.BARS):
            self.at += 1 + (opens == ".")
            return
        self.at = end + 2
        if opens == "." and closes in signs.BARS:
            yield Token("OPEN", "(", position)
            yield from self.inside(inner)
            yield Token("CLOSE", ")", position)
            yield from self.taken_at(position)
        elif opens in signs.BARS and closes in signs.BARS:
            yield Token("BAR", "|", position)
            yield from self.inside(inner)
            yield Token("RAB", "|", position)
        elif (opens, closes) == (".", ".") or (
            (opens, closes) in ((r"\{", "."), (".", r"\}"))
            and any(piece.text in (r"\begin", r"\\") for piece in inner)
        ):
            if self.last == "RELATION" and plain(*inner[1:2], *inner[-1:]) == "array" * 2:
                cases = replace(inner[1], group=pieces("cases"))  # its columns stand behind it
                inner = [inner[0], cases, *inner[3:-1], cases]
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\right", position)
        else:
            raise UnreadError("a bracket on one side alone", position)

    def bar(self) -> Iterator[Token]:
        ahead = self.peek(1)
        if ahead.text == "|" == self.peek().text and ahead.position == self.peek().position + 1:
            self.take()  # || is the size of a vector too
        elif ahead.text == "_" and not self.bars and self.peek().text in ("|", r"\vert"):
            piece = self.take()
            yield from self.taken_at(piece.position)
            return
        piece = self.take()
        closes = piece.text in signs.CLOSING or (
            bool(self.bars) and piece.text not in signs.OPENING
        )
        if closes and self.bars:
            self.bars.pop()
            self.depth -= 1
        elif not closes:
            self.bars.append(True)
            self.depth += 1
        yield Token("RAB" if closes else "BAR", "|", piece.position)

    def taken_at(self, position: int) -> Iterator[Token]:
        """The place at which something is taken, behind its bar."""
        if self.peek().text != "_":
            raise UnreadError("a bar without the place at which something is taken", position)
        piece = self.take()
        place = said(self.argument(piece))
        if self.peek().text == "^":
            raise UnreadError("a value between two limits", position)
        yield Token("EVALUATED", place, piece.position)

    def brace(self) -> Iterator[Token]:
        piece = self.take()
        body = self.argument(piece)
        first = body[0].text if body else ""
        if self.open and first in ("+", "-") and self.last in ("SYMBOL", "CLOSE", "_END"):
            reason = "a brace that begins with a sign: a term, or a factor?"
            raise UnreadError(reason, piece.position)
        self.skip()
        if self.peek().text != {r"\underbrace": "_", r"\overbrace": "^"}[piece.text]:
            raise UnreadError("a brace without what stands at it", piece.position)
        self.take()
        label = self.argument(piece)
        while label and label[0].text in {*NOTHING, "=", r"\equiv"}:
            label = label[1:]
        yield Token("BRACE", "", piece.position)
        yield from self.braced(body, piece.position)
        yield from self.braced(label, piece.position)

    def group(self) -> Iterator[Token]:
        """Braces that TeX does not need: {θ}, {}, {\\bf L}, {const}."""
        piece = self.peek()
        sign, count = operator_at(self.items, self.at)
        first = piece.group[0].text if piece.group else ""
        behind = self.peek(1).text
        if [inner.text for inner in piece.group] == [","]:
            raise UnreadError("a comma within a number: a full stop, or thousands?", piece.position)
        elif sign:
            yield from self.operator(sign, count)
        elif plain(piece).strip(".") in signs.CONSTANT:
            self.take()
            yield Token("CONSTANT", "const", piece.position)
        elif piece.group and self.one_letter([piece]):
            yield from self.lettered()
        elif first in signs.WORDED and len(plain(piece)) > 1:
            self.take()
            self.items[self.at : self.at] = [
                piece.group[0],
                Piece("{}", piece.group[0].position, piece.group[1:]),
            ]
            yield from self.words()
        elif behind == "_" or behind == "'" or first in signs.SWITCHES:
            yield from self.symbol()
        elif behind == "^" and len(piece.group) > 1:
            self.take()
            inner = list(self.inside(piece.group))
            if len(inner) != 1:
                reason = "a power of braces that are not seen: put brackets"
                raise UnreadError(reason, piece.group[-1].position)
            yield from inner
        else:
            self.take()
            yield from self.inside(piece.group, nested=False)


_CLOSES = {"(": ")", "[": "]", r"\{": r"\}"}

_TAKES: Mapping[str, Callable[[Scan], Iterator[Token]]] = {
    "^": Scan.power,
    "{}": Scan.group,
    r"\sqrt": Scan.root,
    r"\int": Scan.integral,
    r"\left": Scan.left,
    r"\begin": Scan.environment,
    **dict.fromkeys(signs.FRACTIONS, Scan.fraction),
    **dict.fromkeys(signs.BARS, Scan.bar),
    **dict.fromkeys(commands("stackrel overset"), Scan.stacked),
    **dict.fromkeys(commands("underbrace overbrace"), Scan.brace),
    **dict.fromkeys(commands("tag tag* eqno leqno"), Scan.tag),
}
"""What takes a piece with all that belongs to it."""


def shown(token: Token, notation: Notation) -> str:
    """A token in words, for messages."""
    glyph = notation.glyphs.get(token.value) if token.kind == "SYMBOL" else None
    if glyph is None and not isinstance(token.value, str):
        return "what stands here"
    return spelling(glyph) if glyph is not None else token.value or "this"
