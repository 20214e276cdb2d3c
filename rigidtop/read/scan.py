"""TeX taken apart: groups, commands and letters become the tokens of a formula, with their places.

What has a meaning only in TeX ends here: spacing, sizes of brackets, fonts, accents, scripts.  A
letter with its font, accent, index and prime is one token: the symbol that the notation declares.
Unicode, HTML's entities and its tags for indices are understood as the TeX that they stand for.
"""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from typing import Any

import sympy

from rigidtop.errors import RigidtopError
from rigidtop.notation import Notation
from rigidtop.notation.characters import GREEK, MARKS, MATHS, SUBSCRIPTS, SUPERSCRIPTS
from rigidtop.theory import symbols as s
from rigidtop.theory.symbols import VOCABULARY, Glyph

LONGEST = 20_000
"""A formula is no longer than this (characters)."""

DEEPEST = 40
"""Groups, brackets and environments are not nested deeper."""

MOST = 4_000
"""A formula has no more tokens."""

DIGITS = 40
"""A number has no more digits."""


MOST_INDICES = 6
"""ω_{1,2,…} is a list of no more."""


class UnreadError(RigidtopError):
    """What can't be read, and where: `position` counts characters from the start of the text."""

    def __init__(self, reason: str, position: int) -> None:
        super().__init__(reason)
        self.reason, self.position = reason, position


@dataclass(frozen=True)
class Token:
    """A piece of a formula: what it is, what it stands for, where it begins."""

    kind: str
    value: Any
    position: int


# --- TeX -----------------------------------------------------------------------------------------


@dataclass(frozen=True)
class Piece:
    """A command with its backslash, a character, or (``{}``) a group of pieces."""

    text: str
    position: int
    group: tuple[Piece, ...] = ()


_RAISED, _LOWERED = "".join(SUPERSCRIPTS), "".join(SUBSCRIPTS)
_TEX = re.compile(
    r"\\(?:tag|operatorname)\*|\\[A-Za-z]+|\\.|%[^\n]*"
    r"|&(?:#\d{1,6}|#x[0-9A-Fa-f]{1,6}|[A-Za-z]{2,31});"
    r"|</?(?:sup|sub|b|i|em|strong|u|span|br)\b[^<>\n]{0,40}>"
    rf"|[{_RAISED}]+|[{_LOWERED}]+|\s+|[^\\\s]|\\",
    re.S,
)
_CONTROL = re.compile("[\x00-\x08\x0e-\x1b\x7f]")
_TAGS = {"<sup>": "^{", "<sub>": "_{", "<b>": r"\mathbf{", "<strong>": r"\mathbf{", "<br>": r"\\"}
_TAGS |= {"</sup>": "}", "</sub>": "}", "</b>": "}", "</strong>": "}"}
_COMBINING = {mark: tex.split("{")[0] for mark, tex in MARKS.items()}


def pieces(text: str) -> tuple[Piece, ...]:
    """The pieces of TeX, what stands in braces taken together, spaces and comments left out.

    >>> [piece.text for piece in pieces(r"\\frac{a}2 % half")]
    ['\\\\frac', '{}', '2']
    >>> [piece.text for piece in pieces("ω̇₃²")]
    ['\\\\dot', '{}', '_', '{}', '^', '{}']
    """
    if len(text) > LONGEST:
        raise UnreadError(f"longer than {LONGEST} characters", LONGEST)
    control = _CONTROL.search(text)
    if control is not None:
        reason = f"a control character (U+{ord(control[0]):04X}), which no formula has"
        raise UnreadError(reason, control.start())
    stack: list[tuple[int, list[Piece]]] = [(0, [])]
    for found, position in _atoms(text):
        inside = stack[-1][1]
        if found == "{":
            if len(stack) > DEEPEST:
                raise UnreadError(f"nested deeper than {DEEPEST}", position)
            stack.append((position, []))
        elif found == "}":
            if len(stack) == 1:
                raise UnreadError("a } without its {", position)
            start, done = stack.pop()
            stack[-1][1].append(Piece("{}", start, tuple(done)))
        elif found in _COMBINING:
            if not inside:
                raise UnreadError("an accent above nothing", position)
            last = inside.pop()
            inside += [Piece(_COMBINING[found], last.position), Piece("{}", position, (last,))]
        else:
            inside.append(Piece(found, position))
    if len(stack) > 1:
        raise UnreadError("a { without its }", stack[-1][0])
    return tuple(stack[0][1])


def _atoms(text: str) -> Iterator[tuple[str, int]]:
    for match in _TEX.finditer(text):
        found = match[0]
        if found.isspace() or (found[0] == "%" and found != "%"):
            continue
        written = _written(found)
        if written is None:
            yield found, match.start()
        else:
            for inner in _TEX.finditer(written):
                if not inner[0].isspace():
                    yield inner[0], match.start()


@cache
def _written(found: str) -> str | None:
    """The TeX for what is not TeX; None for TeX."""
    if found[0] == "&" and len(found) > 1:
        character = html.unescape(found)
        if len(character) > 1:
            return None
        return _written(character) or character
    if found[0] == "<" and len(found) > 1:
        return _TAGS.get(re.sub(r"\s.*|(?<=br)/", "", found[:-1], flags=re.S) + ">", "")
    if found[0].isascii():
        return None
    if found[0] in SUPERSCRIPTS:
        return "^{" + "".join(SUPERSCRIPTS[c] for c in found) + "}"
    if found[0] in SUBSCRIPTS:
        return "_{" + "".join(SUBSCRIPTS[c] for c in found) + "}"
    if found in MATHS:
        return MATHS[found]
    return _taken_apart(found)


def _taken_apart(character: str) -> str | None:
    """A letter with an accent, or of another style: ẑ, 𝐋."""
    parts = unicodedata.normalize("NFD", character)
    if len(parts) == 2 and parts[1] in _COMBINING:
        return _COMBINING[parts[1]] + "{" + parts[0] + "}"
    plain = unicodedata.normalize("NFKC", character)
    if plain == character or len(plain) != 1:
        return " " if character.isspace() else None
    if "BOLD" in unicodedata.name(character, ""):
        return r"\mathbf{" + plain + "}"
    return MATHS.get(plain, plain)


# --- Formulas ------------------------------------------------------------------------------------

_NOTHING = frozenset(
    "\\" + name
    for name in (
        *(",", ";", ":", "!", " ", "\n", "thinspace", "displaystyle", "textstyle", "limits"),
        *("nolimits", "nonumber", "notag", "left", "right", "middle", "allowbreak", "noindent"),
        *(size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r", "m")),
    )
) | {"~"}
_SPACES = frozenset({r"\quad", r"\qquad", r"\enspace", r"\hfill"})
_SKIPPED = frozenset({r"\label", r"\hspace", r"\vspace", r"\phantom", r"\hphantom", r"\vphantom"})
_BETWEEN = frozenset({r"\intertext", r"\shortintertext"})
_RELATIONS = {
    "=": "=",
    r"\equiv": "≡",
    r"\neq": "≠",
    r"\ne": "≠",
    "<": "<",
    ">": ">",
    r"\lt": "<",
    r"\gt": ">",
    r"\approx": "≈",
}
_PLAIN = {
    "(": "OPEN",
    ")": "CLOSE",
    r"\{": "OPEN",
    r"\}": "CLOSE",
    "[": "LIST",
    "]": "TSIL",
    "+": "SIGN",
    "-": "SIGN",
    "/": "SLASH",
    r"\cdot": "DOT",
    r"\times": "CROSS",
    r"\sum": "SUM",
}
_PLAIN |= dict.fromkeys(
    (
        *(r"\Rightarrow", r"\Longrightarrow", r"\implies", r"\Leftrightarrow", r"\iff"),
        *(r"\Longleftrightarrow", r"\therefore"),
    ),
    "ARROW",
)
_FUNCTIONS = frozenset(
    "\\" + name
    for name in (
        *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh"),
        *("exp", "log", "ln", "det"),
    )
)
_WORDS = frozenset(name[1:] for name in _FUNCTIONS) | {"tr", "Tr", "K", "F"}
"""Functions that are written as words: `\\operatorname{K}`."""
_BOLD = frozenset({r"\mathbf", r"\boldsymbol", r"\bm", r"\vec", r"\bf", r"\pmb", r"\bold"})
_UPRIGHT = frozenset({r"\mathrm", r"\mathit", r"\mathnormal", r"\mathsf", r"\rm", r"\it"})
_FONTS = _BOLD | _UPRIGHT
_ACCENTS = {r"\dot": "dot", r"\ddot": "ddot", r"\hat": "hat", r"\widehat": "hat"}
_SCRIPT = frozenset({r"\mathcal", r"\mathscr", r"\cal"})
_VARIANTS = {"varphi": "φ", "vartheta": "θ", "varepsilon": "ε", "varrho": "ρ", "varOmega": "Ω"}
_GREEK = {"\\" + name: letter for name, letter in {**GREEK, **_VARIANTS}.items()}
_LETTERS = _GREEK | {r"\perp": "⊥", r"\parallel": "∥", r"\partial": "∂", r"\top": "T"}
_LETTERS |= {r"\intercal": "T", r"\prime": "′", "'": "′"}
_TEXTS = frozenset({r"\text", r"\textrm", r"\textit", r"\mbox", r"\hbox", r"\operatorname"})
_TEXTS |= {r"\operatorname*", r"\mathrm", r"\textnormal", r"\mathit"}
_MATRICES = frozenset({"matrix", "pmatrix", "bmatrix", "Bmatrix"})
_LINES = frozenset(
    name + star
    for name in (
        *("aligned", "align", "array", "split", "gather", "gathered", "eqnarray", "equation"),
        *("alignat", "alignedat", "multline", "flalign"),
    )
    for star in ("", "*")
)
_OPENING, _CLOSING = frozenset({r"\lvert", r"\lVert"}), frozenset({r"\rvert", r"\rVert"})
_BARS = frozenset({"|", r"\|", r"\vert", r"\Vert"}) | _OPENING | _CLOSING
_TRANSPOSED = frozenset({"T", "⊤"})
_CONSTANT = frozenset({"const", "constant", "konst"})
_LENGTH = re.compile(r"\s*-?[\d.,]+\s*(?:pt|em|ex|mm|cm|in)\s*")


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


class Scan:
    """Goes through pieces from left to right."""

    def __init__(
        self, items: Sequence[Piece], notation: Notation, depth: int = 0, level: int = 0
    ) -> None:
        self.items, self.notation, self.at = list(items), notation, 0
        self.depth, self.level = depth, level
        """Of brackets: commas outside all separate equations, inside entries.  Of groups."""
        self.nested = depth > 0
        self.bars: list[bool] = []
        self.called: int | None = None
        """How deep the function stands whose brackets are open."""
        self.commented = -1
        """Where && stood: words there are a comment."""

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
        while self.peek().text in _NOTHING:
            self.at += 1

    def argument(self, of: Piece) -> tuple[Piece, ...]:
        """What a command takes: a group, or one piece."""
        self.skip()
        piece = self.take()
        if not piece.text:
            raise UnreadError(f"{of.text} without what it is to act on", of.position)
        return piece.group if piece.text == "{}" else (piece,)

    def inside(self, group: Sequence[Piece], nested: bool = True) -> Iterator[Token]:
        if self.level > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", self.peek().position)
        depth = self.depth + nested
        inner = self.within(group, depth)
        inner.called = -1 if self.called is not None else None
        yield from inner.tokens()

    def within(self, group: Sequence[Piece], depth: int) -> Scan:
        """What goes through the pieces of a group."""
        return type(self)(group, self.notation, depth, self.level + 1)

    def braced(self, group: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("_BEGIN", "{", position)
        yield from self.inside(group)
        yield Token("_END", "}", group[-1].position + 1 if group else position)

    # Reading

    def tokens(self) -> Iterator[Token]:
        """Outside all brackets what can't be read is a token too, and the rest is read on."""
        while self.at < len(self.items):
            begun = self.at
            try:
                yield from self.next()
            except UnreadError as error:
                if self.nested:
                    raise
                self.at = max(self.at, begun + 1)
                yield Token("UNREAD", error, error.position)

    def next(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        if text in _NOTHING:
            self.take()
            if text in (r"\left", r"\right") and self.peek().text == ".":
                self.take()
        elif text in _SPACES:
            self.take()
            yield Token("SPACE", text, position)
        elif text in _SKIPPED:
            self.take()
            self.argument(piece)
        elif text in _RELATIONS:
            self.take()
            yield Token("RELATION", _RELATIONS[text], position)
        elif text in _PLAIN:
            yield from self.sign()
        elif text in DECIMALS or (text == "." and self.peek(1).text in DECIMALS):
            yield self.number()
        elif text in (",", ";"):
            self.take()
            yield Token("COMMA" if self.depth else "SEPARATOR", text, position)
        elif text == ".":
            self.take()
            if self.depth:
                raise UnreadError("a full stop inside a formula", position)
            yield Token("SEPARATOR", text, position)
        elif text == r"\\":
            self.take()
            self.length()
            yield Token("LINE", text, position)
        elif text == "&":
            self.take()
            if self.peek(-2).text == "&" and self.at > 1:
                self.commented = self.at
            yield Token("ALIGN", text, position)
        elif text == "^":
            yield from self.power()
        elif text == "{}":
            yield from self.group()
        elif text in (r"\frac", r"\tfrac", r"\dfrac"):
            yield from self.fraction()
        elif text == r"\sqrt":
            self.take()
            if self.peek().text == "[":
                raise UnreadError("roots other than the square root are not read", position)
            yield Token("ROOT", text, position)
            yield from self.braced(self.argument(piece), position)
        elif text in _FUNCTIONS:
            self.take()
            yield from self.function(text[1:].replace("ln", "log"), position)
        elif text == r"\int":
            yield from self.integral()
        elif text in (r"\stackrel", r"\overset"):
            yield from self.stacked()
        elif text in _BETWEEN:
            self.take()
            words = self.argument(piece)
            yield Token("LINE", text, position)
            if _mathematical(words):
                reason = "mathematics between the lines: write it as a line of its own"
                yield Token("UNREAD", UnreadError(reason, position), position)
                yield Token("LINE", text, position)
        elif text in (r"\underbrace", r"\overbrace"):
            yield from self.brace()
        elif text == r"\begin":
            yield from self.environment()
        elif text == r"\end":
            raise UnreadError(r"an \end without its \begin", position)
        elif text in (r"\tag", r"\tag*", r"\eqno", r"\leqno"):
            yield self.tag()
        elif text in _BARS:
            yield self.bar()
        elif self.constant_spelled():
            yield Token("CONSTANT", "const", position)
        elif text in _TEXTS and self.are_words():
            yield from self.words()
        else:
            yield from self.symbol()

    def sign(self) -> Iterator[Token]:
        piece = self.take()
        kind = _PLAIN[piece.text]
        self.depth += (kind in ("OPEN", "LIST")) - (kind in ("CLOSE", "TSIL"))
        if self.depth > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", piece.position)
        self.depth = max(self.depth, 0)
        if self.called is not None and self.depth <= self.called:
            self.called = None
        yield Token(kind, piece.text, piece.position)
        if piece.text == r"\sum":
            yield from self.under()
        elif kind == "CLOSE":
            yield from self.frame()

    def number(self) -> Token:
        first = self.peek()
        digits = ""
        while self.peek().text in DECIMALS or (
            self.peek().text == "." and self.peek(1).text in DECIMALS and "." not in digits
        ):
            if digits and self.peek().position > self.items[self.at - 1].position + 1:
                raise UnreadError("two numbers side by side", self.peek().position)
            digits += self.take().text
            if len(digits) > DIGITS:
                raise UnreadError(f"a number of more than {DIGITS} digits", first.position)
        return Token("NUMBER", digits, first.position)

    def length(self) -> None:
        """Leave out the distance to the next line: `\\\\[2pt]`."""
        if self.peek().text != "[":
            return
        ahead = [self.peek(i).text for i in range(1, 12)]
        if "]" in ahead and _LENGTH.fullmatch("".join(ahead[: ahead.index("]")])):
            self.at += ahead.index("]") + 2

    def group(self) -> Iterator[Token]:
        """Braces that TeX does not need: {θ}, {}, {\\bf L}, {const}."""
        piece = self.peek()
        first = piece.group[0].text if piece.group else ""
        behind = self.peek(1).text
        scripted = behind == "_" or behind == "'" or first in _FONTS
        if _words(piece.group).strip(".") in _CONSTANT:
            self.take()
            yield Token("CONSTANT", "const", piece.position)
        elif scripted:
            yield from self.symbol()
        elif behind == "^" and len(piece.group) > 1:
            self.take()
            inner = list(self.inside(piece.group))
            if len(inner) != 1:
                raise UnreadError(
                    "a power of braces that are not seen: put brackets", behind_of(piece)
                )
            yield from inner
        else:
            self.take()
            yield from self.inside(piece.group, nested=False)

    def function(self, name: str, position: int) -> Iterator[Token]:
        """A function; what stands in braces behind it must not be a sum."""
        yield Token("FUNCTION", name, position)
        self.skip()
        if self.peek().text == "^":
            yield from self.power()
            self.skip()
        if self.peek().text in ("(", "[") and self.called is None:
            self.called = self.depth
        if self.peek().text == "{}":
            seen = {piece.text for piece in self.peek().group}
            if self.peek().group and self.peek().group[0].text in ("(", r"\left"):
                return
            if seen & {"+", "-", "/"} or self.several(self.peek().group):
                raise UnreadError(
                    "what the function acts on: put it in brackets", self.peek().position
                )

    def several(self, group: Sequence[Piece]) -> bool:
        """Whether what stands in braces is more than an angle with a number, or a rate times t."""
        found = list(self.inside(group))
        if len(found) > 1 and found[-1].value == s.t:
            found.pop()
        kinds = [token.kind for token in found]
        if kinds[:1] in (["NUMBER"], ["FRACTION"], ["FUNCTION"]):
            symbols = kinds.count("SYMBOL") if kinds[0] == "NUMBER" else 0
            return symbols > 1
        return kinds.count("SYMBOL") > 1

    def constant_spelled(self) -> bool:
        for word in ("constant", "const"):
            if all(self.peek(i).text == letter for i, letter in enumerate(word)):
                self.at += len(word)
                if self.peek().text == "." and word == "const" and self.depth:
                    self.take()
                return True
        return False

    def are_words(self) -> bool:
        following = self.peek(1)
        if self.peek().text.startswith((r"\operatorname", r"\text", r"\mbox", r"\hbox")):
            return True
        said = _words(following.group)
        return said in _WORDS - {"K", "F"} or said.strip(". ") in _CONSTANT or len(said) > 3

    def words(self) -> Iterator[Token]:
        piece = self.take()
        words = self.argument(piece)
        said = _words(words).strip()
        plain = said.strip(".,").lower()
        if plain in _CONSTANT:
            yield Token("CONSTANT", "const", piece.position)
        elif said in _WORDS:
            name = {"ln": "log", "Tr": "tr"}.get(said, said)
            yield from self.function(name, piece.position)
        elif _mathematical(words):
            raise UnreadError("mathematics in words inside a formula", piece.position)
        elif self.commented >= 0 and self.at - self.commented <= 3:
            return
        elif re.fullmatch(r"\(\d+\.\d+[a-z]?\)", plain):
            yield Token("TAG", plain.strip("()"), piece.position)
        elif plain in ("and", ""):
            yield Token("SEPARATOR", said, piece.position)
        else:
            raise UnreadError(f"words inside a formula: {said!r}", piece.position)

    def tag(self) -> Token:
        piece = self.take()
        if piece.text in (r"\eqno", r"\leqno"):
            said = ""
            while self.peek().text and self.peek().text != r"\\":
                said += self.take().text
        else:
            said = _words(self.argument(piece))
        return Token("TAG", said.strip("()$ "), piece.position)

    def bar(self) -> Token:
        piece = self.take()
        closes = piece.text in _CLOSING or (bool(self.bars) and piece.text not in _OPENING)
        if closes and self.bars:
            self.bars.pop()
            self.depth -= 1
        elif not closes:
            self.bars.append(True)
            self.depth += 1
        return Token("RAB" if closes else "BAR", "|", piece.position)

    def power(self) -> Iterator[Token]:
        piece = self.take()
        raised = self.argument(piece)
        if _words(raised) in _TRANSPOSED:
            yield Token("TRANSPOSED", "T", piece.position)
            return
        yield Token("POWER", "^", piece.position)
        yield from self.braced(raised, piece.position)

    def stacked(self) -> Iterator[Token]:
        """What stands above a relation is a comment, unless it is a relation too."""
        piece = self.take()
        above = self.argument(piece)
        below = list(self.inside(self.argument(piece), nested=False))
        if [token.kind for token in below] not in (["RELATION"], ["ARROW"]):
            raise UnreadError("a sign above what is no relation", piece.position)
        if any(each.text in _RELATIONS or each.text in _NOT_READ for each in _flat(above)):
            raise UnreadError("a relation above a relation", piece.position)
        yield from below

    def under(self) -> Iterator[Token]:
        """The index of a sum."""
        self.skip()
        if self.peek().text != "_":
            raise UnreadError("a sum without its index", self.peek().position)
        piece = self.take()
        said = _words(self.argument(piece))
        if not re.fullmatch(r"[a-z]", said):
            raise UnreadError(f"a sum over {said!r}: only over an index, such as k", piece.position)
        yield Token("INDEX", said, piece.position)

    def frame(self) -> Iterator[Token]:
        """The frame in which a rate is seen, behind its brackets."""
        if self.peek().text == "_":
            piece = self.take()
            yield Token("FRAME", _words(self.argument(piece)), piece.position)

    def fraction(self) -> Iterator[Token]:
        piece = self.take()
        over, below = self.argument(piece), self.argument(piece)
        order = {"dt": 1, "∂t": 1, "dt^2": 2}.get(_words(below), 0)
        rest = _differentiated(over, order) if order else None
        if rest is not None:
            yield Token("RATE", order, piece.position)
            if rest:
                yield from self.braced(rest, piece.position)
            return
        slope = _slope(over, below)
        if slope is not None:
            yield Token("PARTIAL", "", piece.position)
            for part in slope:
                yield from self.braced(part, piece.position)
            return
        yield Token("FRACTION", piece.text, piece.position)
        yield from self.braced(over, piece.position)
        yield from self.braced(below, piece.position)

    def integral(self) -> Iterator[Token]:
        piece = self.take()
        self.skip()
        if self.peek().text in ("_", "^"):
            yield from self.bounded(piece)
            return
        measure = ""
        while self.peek().text and len(measure) < 3:
            self.skip()
            measure += _words((self.take(),)).replace("^", "")
        if measure != "d3r":
            raise UnreadError("an integral that is not over d³r", piece.position)
        yield Token("INTEGRAL", "d3r", piece.position)

    def bounded(self, piece: Piece) -> Iterator[Token]:
        """``\\int_a^b dx``, what is integrated behind it."""
        bounds = {}
        while (sign := self.peek().text) in ("_", "^") and sign not in bounds:
            self.take()
            bounds[sign] = self.argument(piece)
            self.skip()
        if len(bounds) < 2 or _words((self.take(),)) != "d":
            wanted = r"an integral is written \int_a^b dx, with what is integrated behind it"
            raise UnreadError(wanted, piece.position)
        self.skip()
        begin = self.at
        letters = [*self.symbol()]
        if [token.kind for token in letters] != ["SYMBOL"]:
            raise UnreadError("an integral over what is no letter", piece.position)
        variable = self.items[begin : self.at]
        yield Token("BOUNDS", "", piece.position)
        for part in (variable, bounds["_"], bounds["^"]):
            yield from self.braced(part, piece.position)

    def brace(self) -> Iterator[Token]:
        piece = self.take()
        body = self.argument(piece)
        behind = {r"\underbrace": "_", r"\overbrace": "^"}[piece.text]
        self.skip()
        if self.peek().text != behind:
            raise UnreadError("a brace without what stands at it", piece.position)
        self.take()
        label = self.argument(piece)
        while label and label[0].text in {*_NOTHING, "=", r"\equiv"}:
            label = label[1:]
        yield Token("BRACE", "", piece.position)
        yield from self.braced(body, piece.position)
        yield from self.braced(label, piece.position)

    def environment(self) -> Iterator[Token]:
        piece = self.take()
        name = _words(self.argument(piece))
        begin, depth = self.at, 1
        while depth:
            if not self.peek().text:
                raise UnreadError(rf"\begin{{{name}}} without its \end", piece.position)
            depth += {r"\begin": 1, r"\end": -1}.get(self.take().text, 0)
            if depth > DEEPEST:
                raise UnreadError(f"nested deeper than {DEEPEST}", self.peek().position)
        inner = self.items[begin : self.at - 1]
        ends = _words(self.argument(piece))
        if ends != name:
            raise UnreadError(rf"\begin{{{name}}} that ends as {ends}", piece.position)
        if name in _LINES:
            if name.startswith(("array", "alignat", "alignedat")) and inner[:1]:
                inner = inner[1:] if inner[0].text == "{}" else inner
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", piece.position)
            return
        if name not in _MATRICES:
            raise UnreadError(f"the environment {name}", piece.position)
        yield Token("MATRIX", name, piece.position)
        for i, row in enumerate(_split(inner, r"\\")):
            if i:
                yield Token("LINE", r"\\", piece.position)
            for j, cell in enumerate(_split(row, "&")):
                if j:
                    yield Token("COMMA", "&", piece.position)
                yield from self.inside(cell)
        yield Token("XIRTAM", name, piece.position)

    # Letters

    def symbol(self) -> Iterator[Token]:
        position = self.peek().position
        glyph = self.letter()
        if glyph == Glyph("e") and self.peek().text == "^":
            piece = self.take()
            yield Token("EXPONENTIAL", "e", position)
            yield from self.braced(self.argument(piece), piece.position)
            return
        known = sympy.pi if glyph == Glyph("π") else self.known(glyph)
        if known is None and self.peek().text == "^" and _words((self.peek(1),)) == "2":
            known = self.notation.symbol(replace(glyph, base=glyph.base + "²"))
            self.at += 2 if known is not None else 0
        if known is None and 0 < glyph.sub.count(",") < MOST_INDICES:
            several = [self.known(replace(glyph, sub=sub)) for sub in glyph.sub.split(",")]
            if all(symbol is not None for symbol in several):
                self.of_time()
                yield Token("CHOICE", tuple(several), position)
                return
        if known is None and glyph.accent in ("dot", "ddot"):
            rates = self.rate_of(glyph)
            if rates is not None:
                order, letter = rates
                yield Token("RATE", order, position)
                yield Token("_BEGIN", "{", position)
                yield Token("SYMBOL", letter, position)
                yield Token("_END", "}", position)
                return
        if known is None:
            hint = ""
            if glyph.sub in _INDICES:
                hint = ": write an equation for each value of the index"
            elif glyph == Glyph("d"):
                hint = r": a derivative is a dot or \frac{d…}{dt}"
            raise UnreadError(f"no symbol {spelling(glyph)} in this notation{hint}", position)
        self.of_time()
        yield Token("SYMBOL", known, position)

    def rate_of(self, glyph: Glyph) -> tuple[int, sympy.Symbol] | None:
        """Of a letter with dots that has no symbol: how many dots are to be taken off to one."""
        below = {"dot": ((1, ""),), "ddot": ((1, "dot"), (2, ""))}[glyph.accent]
        for order, accent in below:
            letter = self.known(replace(glyph, accent=accent))
            if letter is not None:
                return order, letter
        return None

    def known(self, glyph: Glyph) -> sympy.Symbol | None:
        """The symbol of a glyph, also of a unit vector with a hat that it does not need."""
        found = self.notation.symbol(glyph)
        if found is not None or glyph.accent != "hat":
            return found
        plain = self.notation.symbol(replace(glyph, accent="", bold=True))
        return plain if plain in VOCABULARY and VOCABULARY[plain].unit == "" else None

    def letter(self) -> Glyph:
        """A letter with its fonts, accents, index and prime, in any order."""
        commands: list[Piece] = []
        while self.peek().text in _FONTS or self.peek().text in _ACCENTS:
            commands.append(self.take())
            self.skip()
        piece = self.take()
        text = piece.text
        if text in _SCRIPT:
            base = _words(self.argument(piece))
            glyph = Glyph({"L": "ℒ"}.get(base, base))
        elif text == "{}":
            glyph = self.letter_of(piece)
        elif text in _GREEK:
            glyph = Glyph(_GREEK[text])
        elif len(text) == 1 and text.isalpha():
            glyph = Glyph(text)
        else:
            raise UnreadError(_instead_of_a_symbol(text), piece.position)
        for command in reversed(commands):
            if command.text in _BOLD:
                glyph = replace(glyph, bold=True)
            elif command.text in _ACCENTS:
                if glyph.accent:
                    raise UnreadError("an accent above an accent", command.position)
                glyph = replace(glyph, accent=_ACCENTS[command.text])
        return self.scripts(glyph)

    def letter_of(self, piece: Piece) -> Glyph:
        if self.level > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", piece.position)
        inner = self.within(piece.group, self.depth)
        glyph = inner.letter() if piece.group else None
        inner.skip()
        if glyph is None or inner.at < len(piece.group):
            words = glyph is None or "no single symbol"
            raise UnreadError(
                "an empty group" if words is True else f"{words} in braces", piece.position
            )
        return glyph

    def scripts(self, glyph: Glyph) -> Glyph:
        while True:
            piece = self.peek()
            if piece.text == "^" and self.peek(2).text == "_":  # x^2_1 is x_1^2
                at = self.at
                self.items[at : at + 4] = [*self.items[at + 2 : at + 4], *self.items[at : at + 2]]
                piece = self.peek()
            raised = _words((self.peek(1),)) if piece.text == "^" else ""
            if piece.text == "'" or raised == "′":
                self.take()
                if raised:
                    self.argument(piece)
                if glyph.prime:
                    raise UnreadError("two primes", piece.position)
                glyph = replace(glyph, prime=True)
            elif piece.text == "_":
                self.take()
                sub = _index(self.argument(piece))
                if glyph.sub and glyph.sub != "(e)":
                    raise UnreadError("two indices", piece.position)
                glyph = replace(glyph, sub=",".join(filter(None, (sub, glyph.sub))))
            elif raised in ("(e)", "ext", "(ext)"):
                self.take()
                self.argument(piece)
                said = raised if raised == "(e)" or not glyph.sub else "(e)"
                said = "ext" if "ext" in raised and not glyph.sub else said
                glyph = replace(glyph, sub=",".join(filter(None, (glyph.sub, said))))
            else:
                return glyph

    def of_time(self) -> None:
        """Leave out that a symbol depends on time or place: ω(t), ρ(r)."""
        if self.peek().text not in _AROUND:
            return
        ahead = [i for i in range(12) if self.peek(i).text not in _NOTHING | _FONTS][:4]
        said = [_words((self.peek(i),)) for i in ahead]
        if said[:3] == ["(", "t", ")"] and self.called is not None:
            raise UnreadError(
                "of the time, or times t? leave (t) out, or t without brackets",
                self.peek(ahead[0]).position,
            )
        if said[:3] in (["(", "t", ")"], ["(", "r", ")"]):
            self.at += ahead[2] + 1
        elif said[:3] == ["(", "0", ")"] or said[:3] == ["(", "t", "="]:
            raise UnreadError("a value at one time", self.peek(ahead[0]).position)


DECIMALS = frozenset("0123456789")
_INDICES = frozenset("ijkl")
_AROUND = _NOTHING | {"("}


def behind_of(piece: Piece) -> int:
    """Where the last piece of a group stands."""
    return piece.group[-1].position if piece.group else piece.position


def _flat(group: Sequence[Piece]) -> Iterator[Piece]:
    """Pieces and what stands in their braces."""
    for piece in group:
        yield piece
        yield from _flat(piece.group)


def _mathematical(words: Sequence[Piece]) -> bool:
    """Whether a relation stands among words."""
    return any(
        piece.text in _RELATIONS or piece.text in _NOT_READ or piece.text == "$"
        for piece in _flat(words)
    )


def _split(items: Sequence[Piece], at: str) -> list[Sequence[Piece]]:
    """The parts between the pieces `at`, outside inner environments."""
    parts: list[list[Piece]] = [[]]
    depth = 0
    for piece in items:
        depth += {r"\begin": 1, r"\end": -1}.get(piece.text, 0)
        if piece.text == at and not depth:
            parts.append([])
        else:
            parts[-1].append(piece)
    return [*(parts if parts[-1] or len(parts) == 1 else parts[:-1])]


def _differentiated(over: Sequence[Piece], order: int) -> tuple[Piece, ...] | None:
    """What stands behind the d above the bar of d…/dt; None if there is no d."""
    flat: list[Piece] = []
    for piece in over:
        inner = piece.group if piece.text == "{}" and _words(piece.group) in "d" else (piece,)
        flat.extend(inner)
    while flat and flat[0].text in _NOTHING | _UPRIGHT:
        flat.pop(0)
    if not flat or flat[0].text not in ("d", r"\partial"):
        return None
    rest = flat[1:]
    if order == 2:
        if len(rest) < 2 or rest[0].text != "^" or _words((rest[1],)) != "2":
            return None
        rest = rest[2:]
    return tuple(rest)


def _slope(over: Sequence[Piece], below: Sequence[Piece]) -> list[Sequence[Piece]] | None:
    """f and x of ∂f/∂x; None if it is another fraction."""
    parts = [[p for p in part if p.text not in _NOTHING] for part in (over, below)]
    if not all(len(part) > 1 and part[0].text == r"\partial" for part in parts):
        return None
    return [part[1:] for part in parts]


def _words(group: Sequence[Piece]) -> str:
    """Pieces as text, without braces and fonts, Greek letters as letters.

    >>> _words(pieces(r"\\text{CM}")), _words(pieces(r"d^{3}\\mathbf{r}"))
    ('CM', 'd^3r')
    """
    made = []
    for piece in group:
        if piece.text == "{}":
            made.append(_words(piece.group))
        elif piece.text not in _TEXTS | _FONTS | _NOTHING:
            made.append(_LETTERS.get(piece.text, piece.text))
    return "".join(made)


def unread(text: str) -> str:
    """Mathematics that is not read, without TeX: ``\\lambda_r + i\\lambda_i`` as λ_r + iλ_i."""
    try:
        shown = "".join(f" {p.text} " if p.text in "+-=" else _words((p,)) for p in pieces(text))
    except UnreadError:
        return text
    return " ".join(shown.split())


def _index(group: Sequence[Piece]) -> str:
    """An index as glyphs have it: 1, CM, 1′, φ, −."""
    return _words(group).replace("-", "−")


_NOT_READ = dict.fromkeys(
    (
        *(r"\ge", r"\geq", r"\le", r"\leq", r"\geqslant", r"\leqslant", r"\ll", r"\gg", r"\sim"),
        *(r"\simeq", r"\cong", r"\propto", r"\to", r"\parallel", r"\in", r"\gtrsim", r"\lesssim"),
    ),
    "a relation that is not read",
) | dict.fromkeys((r"\pm", r"\mp"), "two signs at once: write an equation for each")


def _instead_of_a_symbol(text: str) -> str:
    return _NOT_READ.get(text, f"{text or 'the end'} where a symbol should be")


def spelling(glyph: Glyph) -> str:
    """A glyph in words, for messages.

    >>> spelling(Glyph("ω", "7", "dot", prime=True))
    'ω_7 with a dot and a prime'
    """
    extras = [{"dot": "a dot", "ddot": "two dots", "hat": "a hat"}.get(glyph.accent, "")]
    extras += ["a prime" if glyph.prime else "", "bold type" if glyph.bold else ""]
    said = " and ".join(filter(None, extras))
    name = f"{glyph.base}_{glyph.sub}" if glyph.sub else glyph.base
    return f"{name} with {said}" if said else name


def shown(token: Token, notation: Notation) -> str:
    """A token in words, for messages."""
    glyph = notation.glyphs.get(token.value) if token.kind == "SYMBOL" else None
    if glyph is None and not isinstance(token.value, str):
        return "what stands here"
    return spelling(glyph) if glyph is not None else token.value or "this"
