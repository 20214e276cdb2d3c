r"""The tokens of a formula: what TeX has for layout ends here, and each says what it is.

>>> [token.kind for token in tokens(pieces(r"\left(a_1\right) \leq 2{,}5\,\text{for } x"))]
['open', 'letter', 'sign', 'number', 'close', 'relation', 'number', 'words', 'letter']
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from typing import Final

from rigidtop.read.tex import (
    DEEPEST,
    Piece,
    UnreadError,
    commands,
    flat,
    pieces,
    plain,
    said,
)
from rigidtop.read.unit_names import spelled
from rigidtop.read.vocabulary import (
    CASES,
    DERIVATIVES,
    FUNCTIONS,
    LINES,
    MATRICES,
    MEANINGS,
    SEQUENCES,
    SILENT,
    SKIPPED,
    SPACES,
    SWITCHES,
    TEXTS,
    TEXTS_BETWEEN,
    UPRIGHT,
)

MOST = 4_000
"""A formula has no more tokens."""

DIGITS = 40
"""A number has no more digits."""


@dataclass(frozen=True, slots=True)
class Token:
    """A part of a formula that is not taken apart any more, or (`group`) one with tokens in it.

    The kinds: letter, number, sign, relation, arrow, open, close, bar, prime, dots, comma, stop,
    quad, break, align, command, upright, words, tag, group, environment.  `spaced` is true where
    a space is set in front of it.
    """

    kind: str
    text: str
    position: int
    group: tuple[Token, ...] = ()
    spaced: bool = False


_ACCENTED: Final = {"\u20d7": r"\vec", "\u0304": r"\bar", "\u0303": r"\tilde"}
"""Accents that plain text has behind their letters."""
_PLACED: Final = ("t", "b", "c")
"""Options that say where an environment stands."""
_LENGTH = re.compile(r"-?[\d.]+(?:pt|em|ex|mm|cm|in|baselineskip)")


def tokens(items: Sequence[Piece], depth: int = 0) -> tuple[Token, ...]:
    """The tokens of pieces; `UnreadError` for what does not end, never began, or is too deep."""
    if depth > DEEPEST:
        raise UnreadError(f"nested deeper than {DEEPEST}", items[0].position if items else 0)
    return tuple(_Scan(_divided(items), depth).all())


def _divided(items: Sequence[Piece]) -> Sequence[Piece]:
    r"""Pieces with a fraction that TeX writes between its parts, a \over b, as others are."""
    for k, piece in enumerate(items):
        if piece.text == r"\over":
            parts = (Piece("{}", piece.position, tuple(x)) for x in (items[:k], items[k + 1 :]))
            return Piece(r"\frac", piece.position), *parts
    return items


class _Scan:
    """Walks over pieces and keeps the tokens that come of them."""

    def __init__(self, items: Sequence[Piece], depth: int) -> None:
        self.items, self.at, self.depth = items, 0, depth
        self.tokens: list[Token] = []
        self.spaced = False
        self.lefts: list[int] = []

    def all(self) -> list[Token]:
        while self.at < len(self.items):
            if len(self.tokens) > MOST:
                raise UnreadError(f"more than {MOST} symbols and signs", self.place())
            self.next()
        return [token for token in self.tokens if token.kind != "nothing"]

    def inner(self, items: Sequence[Piece]) -> tuple[Token, ...]:
        """The tokens of what stands within."""
        return tokens(items, self.depth + 1)

    def place(self) -> int:
        return self.items[min(self.at, len(self.items) - 1)].position

    def text(self, ahead: int = 0) -> str:
        at = self.at + ahead
        return self.items[at].text if 0 <= at < len(self.items) else ""

    def take(self) -> Piece:
        self.at += 1
        return self.items[self.at - 1]

    def put(self, kind: str, text: str, position: int, group: Iterable[Token] = ()) -> None:
        self.tokens.append(Token(kind, text, position, tuple(group), self.spaced))
        self.spaced = False

    def next(self) -> None:
        piece = self.take()
        text = piece.text
        sequence = self.sequence(piece)
        if sequence:
            self.put(*sequence, piece.position)
        elif text in _HANDLERS:
            _HANDLERS[text](self, piece)
        elif text in SPACES:
            self.space(piece)
        elif text in _ACCENTED and self.tokens:
            accent = Token("command", _ACCENTED[text], piece.position)
            self.tokens[-1:] = [accent, replace(self.tokens[-1], spaced=False)]
        elif text in SILENT:
            pass
        elif text in SKIPPED:
            self.argument()
        elif text in MEANINGS:
            kind, meaning = MEANINGS[text]
            self.put(kind, meaning or text, piece.position)
        elif text.isdecimal():
            self.number(piece)
        elif text == "{}" and not piece.group and not self.is_taken():
            pass  # a {} keeps the spaces of a sign, and says nothing
        elif text == "{}":
            self.put("group", "", piece.position, self.inner(piece.group))
        elif text[0] == "\\":
            name = text[1:]
            kind, text = ("upright", name) if name in FUNCTIONS else ("command", text)
            self.put(kind, text, piece.position)
        else:
            self.put("letter", text, piece.position)

    def space(self, piece: Piece) -> None:
        """A space, which several in a row make a wide one."""
        self.spaced = True
        wide = 0
        while self.text() in SPACES:
            self.at += 1
            wide += 1
        if wide > 1:
            self.put("quad", "quad", piece.position)

    def is_taken(self) -> bool:
        """Whether what comes next belongs to a command or an index."""
        last = self.tokens[-1] if self.tokens else None
        return last is not None and (last.kind == "command" or last.text in ("_", "^"))

    def sequence(self, piece: Piece) -> tuple[str, str] | None:
        """The meaning of several characters that stand right beside each other."""
        for length in (3, 2):
            ahead = self.items[self.at : self.at + length - 1]
            written = piece.text + "".join(each.text for each in ahead)
            close = all(each.position - piece.position < length for each in ahead)
            if written in SEQUENCES and (close or written in (":=", "=:")):
                self.at += length - 1
                return SEQUENCES[written]
        return None

    def argument(self) -> tuple[Piece, ...]:
        """What a command takes: a group's pieces, or one piece."""
        while self.text() == "*" or self.text() in SPACES:
            self.at += 1
        if self.text() == "[" and "]" in [each.text for each in self.items[self.at : self.at + 40]]:
            while self.take().text != "]":
                pass
        if self.at >= len(self.items):
            return ()
        piece = self.take()
        return piece.group if piece.text == "{}" else (piece,)

    def number(self, first: Piece) -> None:
        text, end = first.text, first.position + 1
        while self.at < len(self.items):
            ahead = self.items[self.at]
            behind = self.text(1)
            decimal = "." not in text and behind.isdecimal()
            close = ahead.position <= end
            if close and (ahead.text.isdecimal() or (ahead.text == "." and decimal)):
                text += self.take().text
            elif close and self.is_comma(text):
                text += "."
                self.at += 1
            elif ahead.text == "{}" and decimal and plain(*ahead.group) == ",":
                text += "."
                self.at += 1
                end = self.items[self.at].position
                continue
            else:
                break
            end = ahead.position + 1
        if len(text) > DIGITS:
            raise UnreadError(f"a number of more than {DIGITS} digits", first.position)
        self.put("number", text, first.position)

    def is_comma(self, text: str) -> bool:
        """Whether a comma stands for the point of a number: x = 0,5, but not (0,5) or x = 0,1,2."""
        ahead = [each.text for each in self.items[self.at : self.at + 12]]
        behind = "".join(ahead[1:]).lstrip("0123456789")
        related = bool(self.tokens) and self.tokens[-1].kind == "relation"
        listed = behind.startswith(",") and behind[1:2].isdecimal()
        return (
            text == "0"
            and ahead[0] == ","
            and related
            and behind != "".join(ahead[1:])
            and not listed
        )

    # Handlers

    def delimiter(self, piece: Piece) -> str:
        r"""The bracket behind ``\left`` or ``\right``, by how it opens."""
        written = self.take().text if self.at < len(self.items) else ""
        written = {"<": r"\langle", ">": r"\rangle"}.get(written, written)
        kind, text = MEANINGS.get(written, ("", ""))
        if kind not in ("open", "close", "bar", "stop"):
            raise UnreadError(f"{piece.text} without a bracket", piece.position)
        return text or written

    def left(self, piece: Piece) -> None:
        self.lefts.append(len(self.tokens))
        self.put("open", self.delimiter(piece), piece.position)

    def right(self, piece: Piece) -> None:
        closes = self.delimiter(piece)
        if not self.lefts:
            raise UnreadError(r"a \right without its \left", piece.position)
        at = self.lefts.pop()
        opens = self.tokens[at].text
        dropped = replace(self.tokens[at], kind="nothing")
        if (opens == "." and closes != "|") or (closes == "." and opens not in ("(", "[")):
            self.tokens[at] = dropped
        if closes != "." and not (opens == "." and closes == "{"):
            self.put("close", closes, piece.position)

    def begin(self, piece: Piece) -> None:
        name = plain(*self.argument()).rstrip("*")
        start, depth = self.at, 1
        while depth:
            if self.at >= len(self.items):
                raise UnreadError(rf"a \begin{{{name}}} without its \end", piece.position)
            depth += {r"\begin": 1, r"\end": -1}.get(self.take().text, 0)
        inside = list(self.items[start : self.at - 1])
        self.argument()
        texts = [*(each.text for each in inside), "]"]
        option = "".join(texts[1 : texts.index("]")]) if texts[0] == "[" else ""
        if option in _PLACED or (option and name == "empheq"):  # else it is a row: [a, b, c]^T
            inside = inside[texts.index("]") + 1 :]
        if name in ("array", "alignat", "alignedat", "IEEEeqnarray", "empheq", "numcases"):
            inside = inside[1:] if inside and inside[0].text == "{}" else inside
        group = self.inner(inside)
        related = any(each.kind in ("relation", "environment") for each in group)
        cased = any(each.text == "cases" for each in group)
        braced = bool(self.tokens) and self.tokens[-1].kind == "open"
        rows = name == "array" and related and not cased
        if rows and braced and self.tokens[-1].text == "{" and self.text() == r"\right":
            self.put("environment", "cases", piece.position, group)
        elif name in LINES or rows:
            self.put("break", "", piece.position)
            self.tokens += group
            self.put("break", "", piece.position)
        elif name in CASES or name in MATRICES:
            self.put("environment", "cases" if name in CASES else name, piece.position, group)
        else:
            raise UnreadError(f"the environment {name}", piece.position)

    def end(self, piece: Piece) -> None:
        raise UnreadError(r"an \end without its \begin", piece.position)

    def line(self, piece: Piece) -> None:
        if self.text() == "*":
            self.at += 1
        if self.text() == "[":
            ahead = [each.text for each in self.items[self.at + 1 : self.at + 12]]
            if "]" in ahead and _LENGTH.fullmatch(
                "".join(ahead[: ahead.index("]")]).replace("\\", "")
            ):
                self.at += ahead.index("]") + 2
        self.put("break", "", piece.position)

    def words(self, piece: Piece) -> None:
        """Words, with the mathematics in dollars among them."""
        between = piece.text in TEXTS_BETWEEN
        if between:
            self.put("break", "", piece.position)
        parts: list[list[Piece]] = [[]]
        for each in self.argument():
            if each.text == "$":
                parts.append([])
            else:
                parts[-1].append(each)
        for count, part in enumerate(parts):
            if count % 2:
                self.tokens += self.inner(part)
            elif said(part):
                self.put("words", said(part), part[0].position)
        if between:
            self.put("break", "", piece.position)

    def always(self, piece: Piece) -> None:
        self.put("words", "for all", piece.position)

    def upright(self, piece: Piece) -> None:
        """Letters that stand upright; those of the name of an operator are no product."""
        inside = self.argument()
        named = piece.text.startswith(r"\operatorname")
        self.put("upright", said(inside), piece.position, () if named else self.inner(inside))

    def measure(self, piece: Piece) -> None:
        r"""A unit: ``\si{m/s^2}``."""
        self.put("upright", unit_of(self.argument()), piece.position)

    def quantity(self, piece: Piece) -> None:
        r"""A number with its unit: ``\SI{9.8}{m/s^2}``."""
        digits, _, power = said(self.argument()).replace(" ", "").partition("e")
        number = digits + (rf"\cdot 10^{{{power}}}" if power else "")
        self.tokens += [replace(x, position=piece.position) for x in self.inner(pieces(number))]
        self.measure(piece)

    def sized(self, piece: Piece) -> None:
        r"""``\qty{3}{kg}`` is a quantity; ``\qty(x)`` says only how large brackets are."""
        if self.text() == self.text(1) == "{}":
            self.quantity(piece)

    def switch(self, piece: Piece) -> None:
        """A font for all that follows in the group."""
        font = SWITCHES[piece.text]
        if self.text() == "{}":
            rest: Sequence[Piece] = (self.take(),)
        else:
            rest, self.at = self.items[self.at :], len(self.items)
        self.tokens += self.inner(
            (Piece(font, piece.position), Piece("{}", piece.position, tuple(rest)))
        )

    def tag(self, piece: Piece) -> None:
        if piece.text in (r"\eqno", r"\leqno"):
            inside = self.items[self.at :]
            self.at = len(self.items)
        else:
            inside = self.argument()
        self.put("tag", plain(*inside).strip("()$ "), piece.position)

    def stacked(self, piece: Piece) -> None:
        """What stands above or below a sign is left out."""
        self.argument()
        self.tokens += self.inner(self.argument())

    def negated(self, piece: Piece) -> None:
        self.at += self.text() in ("=", r"\equiv")
        self.put("relation", "≠", piece.position)

    def arrow(self, piece: Piece) -> None:
        self.argument()
        self.put("arrow", "⇒", piece.position)

    def derivative(self, piece: Piece) -> None:
        r"""A derivative of the package physics: ``\dv[2]{x}{t}``, ``\pdv{L}{x}{y}``."""
        order: Sequence[Piece] = ()
        if self.text() == "[":
            self.at += 1
            start = self.at
            while self.at < len(self.items) and self.take().text != "]":
                pass
            order = self.items[start : self.at - 1]
        given: list[Sequence[Piece]] = []
        while self.text() == "{}" and len(given) < 3:
            given.append(self.take().group)
        if not given:
            given.append(self.argument())
        of, by = (given[0], given[1:]) if given[1:] else ((), given)
        sign = Piece(DERIVATIVES[piece.text], piece.position)
        power = [Piece("^", piece.position), Piece("{}", piece.position, tuple(order))]
        raised = power if order else []
        over = (sign, *raised, *of)
        under = [each for part in by for each in (sign, *part, *raised)]
        groups = (Piece("{}", piece.position, tuple(part)) for part in (over, under))
        self.tokens += self.inner((Piece(r"\frac", piece.position), *groups))

    def matrix(self, piece: Piece) -> None:
        """A matrix of the package physics."""
        inside = self.items[self.at].group if self.text() == "{}" else ()
        self.at += bool(inside)
        if len(inside) > 2 and inside[0].text in "([" and inside[-1].text in ")]":
            self.put("open", inside[0].text, piece.position)
            self.put("environment", "matrix", piece.position, self.inner(inside[1:-1]))
            self.put("close", inside[0].text, piece.position)
        else:
            self.put("environment", "matrix", piece.position, self.inner(inside))


_HANDLERS: Final[dict[str, Callable[[_Scan, Piece], None]]] = {
    r"\left": _Scan.left,
    r"\forall": _Scan.always,
    r"\right": _Scan.right,
    r"\begin": _Scan.begin,
    r"\end": _Scan.end,
    r"\\": _Scan.line,
    r"\newline": _Scan.line,
    r"\cr": _Scan.line,
    r"\not": _Scan.negated,
    **dict.fromkeys(TEXTS | TEXTS_BETWEEN, _Scan.words),
    **dict.fromkeys(UPRIGHT, _Scan.upright),
    **dict.fromkeys(commands("SI SIrange"), _Scan.quantity),
    **dict.fromkeys(commands("si unit"), _Scan.measure),
    r"\qty": _Scan.sized,
    **dict.fromkeys(SWITCHES, _Scan.switch),
    **dict.fromkeys(commands("tag tag* eqno leqno"), _Scan.tag),
    **dict.fromkeys(commands("stackrel overset underset"), _Scan.stacked),
    **dict.fromkeys(commands("xrightarrow xRightarrow xleftarrow xLeftarrow"), _Scan.arrow),
    **dict.fromkeys(DERIVATIVES, _Scan.derivative),
    **dict.fromkeys(commands("mqty pmqty bmqty"), _Scan.matrix),
}


def unit_of(items: Sequence[Piece]) -> str:
    r"""A unit as text: ``m.s^{-2}`` is "m s^-2", and so is ``\metre\per\second\squared``."""
    names = [piece.text[1:] for piece in flat(items) if piece.text[0] == "\\"]
    return spelled(names) if names else said(items).replace(".", " ")


def written(group: Iterable[Token]) -> str:
    r"""Tokens as text, such as an index: ``{\rm eff}`` is "eff", ``\pm`` is "±"."""
    text = ""
    accent = ""
    for token in group:
        if token.kind == "command":
            accent = _ACCENTS.get(token.text, "")
            continue
        inner = written(token.group) if token.kind == "group" else token.text
        text += inner + accent
        accent = ""
    return unicodedata.normalize("NFC", text)


_ACCENTS: Final = {r"\dot": "\u0307", r"\ddot": "\u0308", r"\hat": "\u0302", r"\bar": "\u0304"}
