"""TeX taken apart: groups, commands and letters become the tokens of a formula, with their places.

What has a meaning only in TeX ends here: spacing, sizes of brackets, fonts, accents, scripts.  A
letter with its font, accent, index and prime is one token: the symbol that the notation declares.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from typing import Any

import sympy

from rigidtop.errors import RigidtopError
from rigidtop.notation import Notation
from rigidtop.present.layout import GREEK
from rigidtop.theory.symbols import Glyph

LONGEST = 20_000
"""A formula is no longer than this (characters)."""

DEEPEST = 60
"""Groups and brackets are not nested deeper."""


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


_TEX = re.compile(r"\\[A-Za-z]+\*?|\\.|%[^\n]*|\s+|[^\\\s]", re.S)


def pieces(text: str) -> tuple[Piece, ...]:
    """The pieces of TeX, what stands in braces taken together, spaces and comments left out.

    >>> [piece.text for piece in pieces(r"\\frac{a}2 % half")]
    ['\\\\frac', '{}', '2']
    """
    if len(text) > LONGEST:
        raise UnreadError(f"longer than {LONGEST} characters", LONGEST)
    stack: list[tuple[int, list[Piece]]] = [(0, [])]
    for match in _TEX.finditer(text):
        found, position = match[0], match.start()
        if found.isspace() or found.startswith("%"):
            continue
        if found == "{":
            if len(stack) > DEEPEST:
                raise UnreadError(f"nested deeper than {DEEPEST}", position)
            stack.append((position, []))
        elif found == "}":
            if len(stack) == 1:
                raise UnreadError("a } without its {", position)
            start, inside = stack.pop()
            stack[-1][1].append(Piece("{}", start, tuple(inside)))
        else:
            stack[-1][1].append(Piece(found, position))
    if len(stack) > 1:
        raise UnreadError("a { without its }", stack[-1][0])
    return tuple(stack[0][1])


# --- Formulas ------------------------------------------------------------------------------------

_NOTHING = frozenset(
    "\\" + name
    for name in (
        *(",", ";", ":", "!", " ", "quad", "qquad", "displaystyle", "textstyle", "limits"),
        *("nolimits", "nonumber", "notag", "left", "right", "middle"),
        *(size + side for size in ("big", "Big", "bigg", "Bigg") for side in ("", "l", "r")),
    )
) | {"~"}
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
    "[": "LIST",
    "]": "TSIL",
    "+": "SIGN",
    "-": "SIGN",
    "−": "SIGN",
    "/": "SLASH",
    r"\cdot": "DOT",
    r"\times": "CROSS",
    r"\sum": "SUM",
    r"\Rightarrow": "ARROW",
    r"\implies": "ARROW",
    r"\Leftrightarrow": "ARROW",
    r"\iff": "ARROW",
}
_FUNCTIONS = frozenset(
    "\\" + name
    for name in (
        *("sin", "cos", "tan", "arcsin", "arccos", "arctan", "sinh", "cosh", "tanh"),
        *("exp", "log", "ln", "det"),
    )
)
_FONTS = {r"\mathbf": True, r"\boldsymbol": True, r"\bm": True, r"\vec": True, r"\mathrm": False}
_ACCENTS = {r"\dot": "dot", r"\ddot": "ddot", r"\hat": "hat", r"\widehat": "hat"}
_VARIANTS = {"varphi": "φ", "vartheta": "θ", "varepsilon": "ε"}
_GREEK = {"\\" + name: letter for name, letter in {**GREEK, **_VARIANTS}.items()}
_TEXTS = frozenset({r"\text", r"\textrm", r"\mathrm", r"\textit", r"\mathit", r"\operatorname"})
_MATRICES = frozenset({"matrix", "pmatrix", "bmatrix", "Bmatrix", "vmatrix"})
_LINES = frozenset(
    name + star
    for name in ("aligned", "align", "array", "split", "gather", "gathered", "eqnarray", "equation")
    for star in ("", "*")
)


def tokens(text: str, notation: Notation) -> list[Token]:
    """The tokens of a formula, of one line or more; `UnreadError` says what and where if not."""
    return list(_Scan(pieces(text), notation).tokens())


class _Scan:
    """Goes through pieces from left to right."""

    def __init__(self, items: Sequence[Piece], notation: Notation, depth: int = 0) -> None:
        self.items, self.notation, self.at = items, notation, 0
        self.depth = depth
        """Of brackets: commas outside all separate equations, inside entries."""
        self.bars: list[bool] = []

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

    def inside(self, group: Sequence[Piece]) -> Iterator[Token]:
        yield from _Scan(group, self.notation, self.depth + 1).tokens()

    def braced(self, group: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("_BEGIN", "{", position)
        yield from self.inside(group)
        yield Token("_END", "}", position)

    # Reading

    def tokens(self) -> Iterator[Token]:
        while self.at < len(self.items):
            yield from self.next()

    def next(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        if text in _NOTHING:
            self.take()
            if (text == r"\left" and self.peek().text == ".") or (
                text == r"\right" and self.peek().text == "."
            ):
                self.take()
        elif text in _RELATIONS:
            self.take()
            yield Token("RELATION", _RELATIONS[text], position)
        elif text in _PLAIN:
            self.take()
            self.depth += (text in "([") - (text in ")]") if len(text) == 1 else 0
            yield Token(_PLAIN[text], "-" if text == "−" else text, position)
            if text == r"\sum":
                yield from self.under()
            elif text == ")":
                yield from self.frame()
        elif text.isdigit() or (text == "." and self.peek(1).text.isdigit()):
            yield self.number()
        elif text in (",", ";"):
            self.take()
            yield Token("COMMA" if self.depth else "SEPARATOR", text, position)
        elif text == ".":
            self.take()
            if self.depth:
                raise UnreadError("a full stop inside a formula", position)
            yield Token("SEPARATOR", text, position)
        elif text in (r"\\", "&"):
            self.take()
            if text == r"\\":
                yield Token("LINE", text, position)
        elif text == "^":
            yield from self.power()
        elif text == "{}":
            self.take()
            yield from self.inside(piece.group)
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
            yield Token("FUNCTION", text[1:].replace("ln", "log"), position)
        elif text == r"\int":
            yield from self.integral()
        elif text in (r"\stackrel", r"\overset"):
            self.take()
            self.argument(piece)  # what stands above the sign is a comment
            yield from self.inside(self.argument(piece))
        elif text == r"\underbrace":
            yield from self.underbrace()
        elif text == r"\begin":
            yield from self.environment()
        elif text == r"\end":
            raise UnreadError(r"an \end without its \begin", position)
        elif text == r"\tag":
            self.take()
            yield Token("TAG", _words(self.argument(piece)), position)
        elif text == r"\label":
            self.take()
            self.argument(piece)
        elif text in ("|", r"\vert", r"\lvert", r"\rvert"):
            yield self.bar()
        elif self.spelled("const"):
            self.at += len("const")
            yield self.constant(position)
        elif text in _TEXTS and len(self.peek(1).group) != 1:
            yield from self.words()
        else:
            yield from self.symbol()

    def number(self) -> Token:
        position, digits = self.peek().position, ""
        while self.peek().text.isdigit() or (
            self.peek().text == "." and self.peek(1).text.isdigit() and "." not in digits
        ):
            digits += self.take().text
        return Token("NUMBER", digits, position)

    def spelled(self, word: str) -> bool:
        return all(self.peek(i).text == letter for i, letter in enumerate(word))

    def constant(self, position: int) -> Token:
        return Token("CONSTANT", "const", position)

    def words(self) -> Iterator[Token]:
        piece = self.take()
        said = _words(self.argument(piece))
        if said.strip(".").lower() in ("const", "constant", "konst"):
            yield self.constant(piece.position)
        elif piece.text == r"\operatorname":
            yield Token("FUNCTION", said, piece.position)
        elif said in ("and", "or", ","):
            yield Token("SEPARATOR", said, piece.position)
        else:
            raise UnreadError(f"words inside a formula: {said!r}", piece.position)

    def bar(self) -> Token:
        piece = self.take()
        closes = bool(self.bars)
        self.bars.pop() if closes else self.bars.append(True)
        return Token("RAB" if closes else "BAR", "|", piece.position)

    def power(self) -> Iterator[Token]:
        piece = self.take()
        raised = self.argument(piece)
        if _words(raised) in ("T", r"\top", r"\mathsf{T}", "t"):
            yield Token("TRANSPOSED", "T", piece.position)
            return
        yield Token("POWER", "^", piece.position)
        yield from self.braced(raised, piece.position)

    def under(self) -> Iterator[Token]:
        """The index of a sum."""
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
        first = over[0].text if over else ""
        by_time = [p.text for p in below] in (["d", "t"], [r"\partial", "t"])
        if by_time and first in ("d", r"\partial"):
            yield Token("RATE", first, piece.position)
            if len(over) > 1:
                yield from self.braced(over[1:], piece.position)
            return
        yield Token("FRACTION", piece.text, piece.position)
        yield from self.braced(over, piece.position)
        yield from self.braced(below, piece.position)

    def integral(self) -> Iterator[Token]:
        piece = self.take()
        self.skip()
        measure = ""
        while self.peek().text and len(measure) < 4:
            self.skip()
            measure += _words((self.take(),)).replace("^", "")
            if measure == "d3r":
                break
        if measure != "d3r":
            raise UnreadError("an integral that is not over d³r", piece.position)
        yield Token("INTEGRAL", "d3r", piece.position)

    def underbrace(self) -> Iterator[Token]:
        piece = self.take()
        body = self.argument(piece)
        if self.peek().text != "_":
            raise UnreadError("a brace without what stands beneath it", piece.position)
        self.take()
        label = self.argument(piece)
        if label and label[0].text in _RELATIONS:
            label = label[1:]
        yield Token("BRACE", "", piece.position)
        yield from self.braced(body, piece.position)
        yield from self.braced(label, piece.position)

    def environment(self) -> Iterator[Token]:
        piece = self.take()
        name = _words(self.argument(piece))
        inner, depth = [], 1
        while depth:
            if not self.peek().text:
                raise UnreadError(rf"\begin{{{name}}} without its \end", piece.position)
            depth += {r"\begin": 1, r"\end": -1}.get(self.peek().text, 0)
            inner.append(self.take())
        self.argument(piece)
        inner.pop()
        if name in _LINES:
            if name == "array" and inner and inner[0].text == "{}":
                inner = inner[1:]
            yield from _Scan(inner, self.notation, self.depth).tokens()
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
        known = sympy.pi if glyph == Glyph("π") else self.notation.symbol(glyph)
        if known is None and self.peek().text == "^" and _words((self.peek(1),)) == "2":
            known = self.notation.symbol(replace(glyph, base=glyph.base + "²"))
            self.at += 2 if known is not None else 0
        if known is None:
            raise UnreadError(f"no symbol {spelling(glyph)} in this notation", position)
        self.of_time(position)
        yield Token("SYMBOL", known, position)

    def letter(self) -> Glyph:
        """A letter with its font, accent, index and prime."""
        piece = self.take()
        text = piece.text
        if text == r"\mathcal":
            base = _words(self.argument(piece))
            glyph = Glyph({"L": "ℒ"}.get(base, base))
        elif text in _FONTS or text in _ACCENTS or text == "{}":
            group = piece.group if text == "{}" else self.argument(piece)
            inner = _Scan(group, self.notation, self.depth)
            glyph = inner.letter()
            if inner.at < len(group):
                raise UnreadError(f"more than one symbol under {text}", piece.position)
            if text in _FONTS:
                glyph = replace(glyph, bold=glyph.bold or _FONTS[text])
            elif text in _ACCENTS:
                if glyph.accent:
                    raise UnreadError("an accent above an accent", piece.position)
                glyph = replace(glyph, accent=_ACCENTS[text])
        elif text in _GREEK:
            glyph = Glyph(_GREEK[text])
        elif len(text) == 1 and text.isalpha():
            glyph = Glyph(text)
        else:
            raise UnreadError(f"{text or 'the end'} where a symbol should be", piece.position)
        return self.scripts(glyph)

    def scripts(self, glyph: Glyph) -> Glyph:
        while True:
            piece = self.peek()
            if piece.text == "'":
                self.take()
                if glyph.prime:
                    raise UnreadError("two primes", piece.position)
                glyph = replace(glyph, prime=True)
            elif piece.text == "_":
                self.take()
                if glyph.sub:
                    raise UnreadError("two indices", piece.position)
                glyph = replace(glyph, sub=_index(self.argument(piece)))
            elif piece.text == "^" and _words((self.peek(1),)) in (r"\prime", "(e)"):
                self.take()
                said = _words(self.argument(piece))
                if said == r"\prime":
                    glyph = replace(glyph, prime=True)
                else:
                    glyph = replace(glyph, sub=",".join(filter(None, (glyph.sub, said))))
            else:
                return glyph

    def of_time(self, position: int) -> None:
        """Leave out that a symbol depends on time or place: ω(t), ρ(r)."""
        silent = _NOTHING | _FONTS.keys()
        ahead = [i for i in range(12) if self.peek(i).text not in silent][:3]
        shown = [_words((self.peek(i),)) for i in ahead]
        if shown in (["(", "t", ")"], ["(", "r", ")"]):
            self.at += ahead[-1] + 1
        elif shown == ["(", "0", ")"]:
            raise UnreadError("a value at one time", position)


def _split(items: Sequence[Piece], at: str) -> list[list[Piece]]:
    """The parts between the pieces `at`, outside inner environments."""
    parts: list[list[Piece]] = [[]]
    depth = 0
    for piece in items:
        depth += {r"\begin": 1, r"\end": -1}.get(piece.text, 0)
        if piece.text == at and not depth:
            parts.append([])
        else:
            parts[-1].append(piece)
    return parts if parts[-1] or len(parts) == 1 else parts[:-1]


def _words(group: Sequence[Piece]) -> str:
    """Pieces as text, without braces and fonts.

    >>> _words(pieces(r"\\text{CM}")), _words(pieces(r"d^{3}\\mathbf{r}"))
    ('CM', 'd^3r')
    """
    made = ""
    for piece in group:
        if piece.text == "{}":
            made += _words(piece.group)
        elif piece.text not in _TEXTS and piece.text not in _FONTS and piece.text not in _NOTHING:
            made += piece.text
    return made


def _index(group: Sequence[Piece]) -> str:
    """An index as glyphs have it: 1, CM, 1′, φ, −."""
    said = _words(group)
    for command, letter in {**_GREEK, r"\perp": "⊥", r"\parallel": "∥"}.items():
        said = re.sub(re.escape(command) + r"(?![A-Za-z])", letter, said)
    return said.replace("'", "′").replace("-", "−")


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
