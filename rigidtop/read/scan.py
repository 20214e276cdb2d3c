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

import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any

import sympy

from rigidtop.notation import Notation
from rigidtop.notation.convention import own
from rigidtop.read.habits import NO_HABITS, Habits
from rigidtop.read.kinds import Sort
from rigidtop.read.tex import (
    BOLD,
    DEEPEST,
    FONTS,
    GREEKS,
    NOTHING,
    TEXTS,
    UPRIGHT,
    Piece,
    UnreadError,
    commands,
    flat,
    listed,
    pieces,
    plain,
    said,
    split,
)
from rigidtop.theory.symbols import VOCABULARY, Glyph

MOST = 4_000
"""A formula has no more tokens."""

DIGITS = 40
"""A number has no more digits."""

MOST_INDICES = 6
"""ω_{1,2,…} is a list of no more."""


@dataclass(frozen=True)
class Token:
    """A piece of a formula: what it is, what it stands for, where it begins."""

    kind: str
    value: Any
    position: int


# --- What is written how -------------------------------------------------------------------------

_SPACES = commands("quad qquad enspace hfill")
_SKIPPED = commands("label hspace vspace phantom hphantom vphantom color textcolor mspace hskip")
_SKIPPED |= commands("colorbox cite")
"""Commands that are left out with their first argument."""
_LEFT_OUT = commands(
    "boxed fbox mathop mathord mathrel ensuremath scriptstyle displaylimits strut mathstrut null "
    "relax qedhere smash mathclap bf@series protect hfil centering nobreak / -"
)
_BETWEEN = commands("intertext shortintertext")
_JUDGED = {
    "=": "=",
    "<": "<",
    ">": ">",
    r"\lt": "<",
    r"\gt": ">",
    r"\equiv": "≡",
    r"\neq": "≠",
    r"\ne": "≠",
    r"\approx": "≈",
}
"""The relations that our pages have."""
_RELATIONS = {
    **_JUDGED,
    **dict.fromkeys(commands("le leq leqslant"), "≤"),
    **dict.fromkeys(commands("ge geq geqslant"), "≥"),
    **dict.fromkeys(commands("simeq cong approxeq"), "≃"),
    **dict.fromkeys(commands("triangleq coloneqq doteq eqqcolon coloneq"), "≡"),
    r"\ll": "≪",
    r"\gg": "≫",
    r"\sim": "∼",
    r"\propto": "∝",
    r"\lesssim": "≲",
    r"\gtrsim": "≳",
    r"\perp": "⊥",
    r"\parallel": "∥",
}
_ARROWS = commands(
    "Rightarrow Longrightarrow implies Leftrightarrow iff Longleftrightarrow therefore "
    "rightarrow to longrightarrow leftrightarrow longleftrightarrow because"
)
_SIGNS = {r"\pm": ("+", "-"), r"\mp": ("-", "+")}
_BOTH = {"±": "+,−", "∓": "−,+"}
"""ε_± is ε₊ with the upper sign and ε₋ with the lower."""
_MATHEMATICAL = frozenset({*_RELATIONS, *_SIGNS, "$", r"\to", r"\in"})
_OMITTED = commands("cdots ldots dots dotsb dotsc vdots") | {"…", "⋯"}
_BRACKETS = {
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
_REFUSED = {
    **dict.fromkeys(commands("langle rangle"), "an average or a product in ⟨ ⟩"),
    **dict.fromkeys(commands("in notin subset subseteq cup cap"), "a set"),
    **dict.fromkeys(commands("forall exists mapsto colon"), "a map or a quantifier"),
    **dict.fromkeys(commands("lim limsup liminf"), "a limit"),
    **dict.fromkeys(commands("max min sup inf arg"), "an extremum"),
    **dict.fromkeys(commands("otimes oplus wedge circ bullet"), "a product of a kind"),
    **dict.fromkeys(commands("prod coprod binom"), "a product over an index, or a binomial"),
    **dict.fromkeys(commands("cancel bcancel xcancel cancelto"), "what is struck out"),
    **dict.fromkeys(commands("iint iiint oint"), "an integral of several dimensions"),
    **dict.fromkeys(commands("includegraphics xymatrix tikz"), "a picture"),
    "*": "a star: a product is written without one",
    "!": "a factorial",
    "?": "a question mark",
}
_DEGREES = "an angle in degrees: the reader knows radians"
_FRACTIONS = commands("dfrac cfrac tfrac frac nicefrac")
_FUNCTIONS = commands(
    "sin cos tan arcsin arccos arctan sinh cosh tanh exp log ln det cot sec csc coth"
)
_SPELLED = ("sin", "cos", "tan", "exp", "log")
_WORDS = frozenset(name[1:] for name in _FUNCTIONS) | {"tr", "Tr"}
"""Functions that are written as words."""
_ELLIPTIC = frozenset({"K", "F"})
"""In the letters of a table these are functions too: ``\\operatorname{K}``."""

_OVER = {r"\dot": 1, r"\ddot": 2}
_MARKS = {
    **dict.fromkeys(commands("bar overline"), "\u0304"),
    **dict.fromkeys(commands("tilde widetilde"), "\u0303"),
    r"\check": "\u030c",
    r"\breve": "\u0306",
    r"\mathring": "\u030a",
}
_STYLES = {
    r"\mathcal": "SCRIPT",
    r"\mathscr": "SCRIPT",
    r"\cal": "SCRIPT",
    r"\mathfrak": "FRAKTUR",
    r"\mathbb": "DOUBLE-STRUCK",
}
_HATS = commands("hat widehat")
"""With a small hat a letter is a unit vector; a wide one is a matrix, or what an author makes."""
_DRESSES = FONTS | _HATS | frozenset(_MARKS) | frozenset(_OVER)
_SWITCHES = commands("bf rm it bfseries boldmath")
_WORDED = UPRIGHT | commands("textrm text textit mathtt mbox textsf")
_UPRIGHT_ALONE = commands("mathrm operatorname operatorname* mathit")
_LETTERS = {
    **GREEKS,
    r"\ell": "ℓ",
    r"\hbar": "ħ",
    r"\imath": "i",
    r"\jmath": "j",
    r"\infty": "∞",
    "∞": "∞",
    r"\varpi": "ϖ",
    r"\digamma": "Ϝ",
}
_ALPHABET = frozenset("αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϕϑϖϵℓℒħℋ")
_SETS = frozenset("RNZCQ")
_ENERGY = re.compile("E[ckmp][a-z]?")
"""A product, or the name of an energy."""
_TIME = own(Glyph("t"))
ANGLES = frozenset("θφψϕϑαβγχϖ")
_TIMELY = frozenset("xyzrqθφψϕsuvω")
_INDEXES = frozenset("ijklμνcefgos") | frozenset("ABCDEFGHIJKLMOPQRSUVWXYZ")
"""Letters that above another may be its index; n, m, p, x are rather a power."""
_ORDERS = frozenset({"O", "o", "𝒪", "Δ", "δ", "Γ"})
"""Letters whose brackets never hold a factor."""
_POTENTIALS = frozenset({"f", "F", "U", "V", "H", "ψ", "Ψ"})
"""Letters whose brackets may hold either: it is not guessed."""

CONDITIONS: frozenset[str] = listed(
    "for if when whenever unless provided assuming as at per se quando für wenn falls bei pour "
    "quand si para cuando om når hvis since because 当 若 如果 因为"
)
_CONNECTIVES = listed(
    "and or where with so then thus hence but is are from by to let we that which e ed ou et oder "
    "und wobei dove con med og y avec où soit i.e. e.g. otherwise therefore now"
)
_CONSTANT = frozenset({"const", "constant", "konst"})
_UNIT = re.compile(
    r"\(?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A|eV|cal)|rad|deg|kg|min|h|hr|km|mi|yr|AU|sec)"
    r"(?:\^?\{?[-−]?\d\}?)?(?:[·/ ]?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A)|rad|kg|min|h|hr)"
    r"(?:\^?\{?[-−]?\d\}?)?)*\)?"
)
_LENGTH = re.compile(r"\s*-?[\d.,]+\s*(?:pt|em|ex|mm|cm|in)\s*")
_NUMBER_OF = re.compile(r"\(\d+(?:\.\d+)*[a-z]?\)")

_CASES = listed("cases dcases rcases numcases cases* dcases*")
_MATRICES = listed("matrix pmatrix bmatrix Bmatrix smallmatrix pmatrix* bmatrix* matrix*")
_LINES = listed(
    "aligned align array split gather gathered eqnarray equation alignat alignedat multline "
    "flalign empheq subequations multlined dmath displaymath math IEEEeqnarray Aligned"
)
_ARGUED = listed("alignedat alignat IEEEeqnarray empheq")
_OPENING, _CLOSING = commands("lvert lVert"), commands("rvert rVert")
_BARS = frozenset({"|", r"\|"}) | commands("vert Vert") | _OPENING | _CLOSING
_TRANSPOSED = frozenset({"T", "⊤"})
DECIMALS = frozenset("0123456789")
_SIGNS_AROUND = frozenset({*_RELATIONS, "+", "-", "_", "^", "/", r"\cdot", r"\times"})
_BEFORE_LAST = frozenset({"RELATION", "SIGN", "SIGNS", "SLASH", "DOT", "CROSS"})
_BEFORE = _BEFORE_LAST | {"", "NUMBER", "ALIGN", "LINE", "SPACE", "SEPARATOR", "ARROW", "WORDS"}
_BEFORE |= {"OPEN", "LIST", "OF", "COMMA"}


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
    """Goes through pieces from left to right.

    In an open notation any letter is one, in any dress.
    """

    def __init__(
        self,
        items: Sequence[Piece],
        notation: Notation,
        habits: Habits = NO_HABITS,
        depth: int = 0,
        outer: Scan | None = None,
    ) -> None:
        self.level: int = outer.level + 1 if outer is not None else 0
        self.items, self.notation, self.at = list(_infix(items, self.level)), notation, 0
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
        texts = set() if outer else {piece.text for piece in flat(items)}
        plainly = self.open and not texts & BOLD and bool(habits.said)
        self.crossed: bool = outer.crossed if outer else plainly and _crossed(items)
        """Whether × stands and nothing in bold type: words then make vectors of letters."""
        self.two_signs: bool = outer.two_signs if outer else bool(texts & set(_SIGNS))
        self.integrals: bool = outer.integrals if outer else r"\int" in texts
        self.lonely_d: bool = outer.lonely_d if outer else _lonely_d(items)

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
        takes = 2 if piece.text in _FRACTIONS else piece.text in _DRESSES | TEXTS | set(_STYLES)
        return (piece, *(self.take() for _ in range(takes) if self.peek().text))

    def within(self, group: Sequence[Piece], depth: int = 0) -> Scan:
        """What goes through the pieces of a group."""
        if self.level > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", self.peek().position)
        return Scan(group, self.notation, self.habits, depth, self)

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

    def is_letter(self, at: int) -> bool:
        """Whether what stands there is one letter, whatever it has above or at it."""
        return self.one_letter(self.items[at : at + 2])

    def one_letter(self, inner: Sequence[Piece]) -> bool:
        found = self.within(inner)
        try:
            found.letter()
        except UnreadError:
            return False
        return bool(inner) and found.at >= len(found.items)

    def starts_letter(self, at: int) -> bool:
        """Whether a letter begins there."""
        text = self.items[at].text if at < len(self.items) else ""
        if text == "{}":
            group = self.items[at].group
            return bool(group) and self.within(group).starts_letter(0)
        return text in _DRESSES or text in _LETTERS or text in _STYLES or self.is_alphabetic(text)

    def is_alphabetic(self, text: str) -> bool:
        """Whether it is a letter that formulas have: in a table any may stand."""
        return len(text) == 1 and text.isalpha() and (not self.open or _is_latin(text))

    # What stands there

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
                self.at = max(self.at, begun + 1)
                yield Token("UNREAD", error, error.position)

    def next(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        single = self.single()
        if single is not None:
            yield Token(*single, position)
        elif text == r"\left":
            yield from self.left()
        elif text in NOTHING or text in _LEFT_OUT:
            self.take()
            if text == r"\right" and self.peek().text == ".":
                self.take()
        elif text in _SKIPPED:
            self.at += 1 + (self.peek(1).text == "*")
            self.argument(piece)
        elif text == r"\underline" and not self.is_letter(self.at):
            self.take()
        elif text in _REFUSED:
            raise UnreadError(f"{_REFUSED[text]}: that is not read", position)
        elif text in _BRACKETS:
            yield from self.sign()
        elif text in DECIMALS or (text == "." and self.peek(1).text in DECIMALS):
            yield self.number()
        elif text == ".":
            self.take()
            if self.depth:
                raise UnreadError("a full stop inside a formula", position)
            yield Token("SEPARATOR", text, position)
        elif text == r"\\":
            self.at += 1 + _length(self.items[self.at + 1 : self.at + 13])
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
        elif text in _FRACTIONS:
            yield from self.fraction()
        elif text == r"\sqrt":
            yield from self.root()
        elif text in _FUNCTIONS:
            self.take()
            yield from self.function(text[1:].replace("ln", "log"), position)
        elif text == r"\int":
            yield from self.integral()
        elif text in (r"\stackrel", r"\overset"):
            yield from self.stacked()
        elif text in _BETWEEN:
            self.take()
            between = self.argument(piece)
            yield Token("LINE", text, position)
            if _mathematical(between):
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
        elif text in _OVER and self.peek(1).text == "{}" and not self.is_letter(self.at):
            self.take()
            yield Token("RATE", _OVER[text], position)
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
        elif text in _RELATIONS:
            found = ("RELATION", _RELATIONS[text])
            reason = "" if text in _JUDGED else "a relation that is not read"
        elif text in _SPACES:
            found = ("SPACE", text)
        elif text in _ARROWS:
            found = ("ARROW", text)
        elif text in (",", ";") or (text == ":" and not self.depth):
            found = ("COMMA" if self.depth else "SEPARATOR", text)
        elif text in _SIGNS:
            found, reason = ("SIGNS", _SIGNS[text]), "two signs at once: write an equation for each"
        elif text in _OMITTED or (text == behind == self.peek(2).text == "."):
            count, found = 1 if text in _OMITTED else 3, ("SYMBOL", own(Glyph("…")))
            reason = "dots for what is left out"
        if not found[0]:
            return None
        if reason and not self.open:
            raise UnreadError(reason, position)
        self.at += count
        return found

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

    def tag(self) -> Token:
        piece = self.take()
        if piece.text in (r"\eqno", r"\leqno"):
            number = ""
            while self.peek().text and self.peek().text != r"\\":
                number += self.take().text
        else:
            number = plain(*self.argument(piece))
        return Token("TAG", number.strip("()$ "), piece.position)

    def stacked(self) -> Iterator[Token]:
        """What stands above a relation is a comment, unless it is a relation too."""
        piece = self.take()
        above = self.argument(piece)
        below = list(self.inside(self.argument(piece), nested=False))
        if [token.kind for token in below] not in (["RELATION"], ["ARROW"]):
            raise UnreadError("a sign above what is no relation", piece.position)
        if _mathematical(above):
            raise UnreadError("a relation above a relation", piece.position)
        yield from below

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
        kind = _BRACKETS[text]
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

    def is_row(self, at: int) -> bool:
        """Whether square brackets hold the components of a vector: three, or two in a column."""
        end = self.closing(at, ("[", "]"))
        if end is None:
            return False
        count = sum(piece.text == "," for piece in self.items[at:end])
        raised = self.items[end + 1 : end + 2] and self.items[end + 1].text == "^"
        above = plain(*self.items[end + 2 : end + 3])
        return bool(raised and above in _TRANSPOSED) or (count == 2 and self.commas(at))

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
            raise UnreadError(f"{_REFUSED[chr(92) + 'langle']}: that is not read", position)
        if end is None or (opens != "." and closes != "." and opens not in _BARS):
            self.at += 1 + (opens == ".")
            return
        self.at = end + 2
        if opens == "." and closes in _BARS:
            yield Token("OPEN", "(", position)
            yield from self.inside(inner)
            yield Token("CLOSE", ")", position)
            yield from self.taken_at(position)
        elif opens in _BARS and closes in _BARS:
            yield Token("BAR", "|", position)
            yield from self.inside(inner)
            yield Token("RAB", "|", position)
        elif (opens, closes) in ((".", "."), (r"\{", "."), (".", r"\}")):
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\right", position)
        else:
            raise UnreadError("a bracket on one side alone", position)

    def bar(self) -> Token:
        ahead = self.peek(1)
        if ahead.text == "|" == self.peek().text and ahead.position == self.peek().position + 1:
            self.take()  # || is the size of a vector too
        elif ahead.text == "_" and not self.bars and self.peek().text in ("|", r"\vert"):
            piece = self.take()
            [token] = self.taken_at(piece.position)
            return token
        piece = self.take()
        closes = piece.text in _CLOSING or (bool(self.bars) and piece.text not in _OPENING)
        if closes and self.bars:
            self.bars.pop()
            self.depth -= 1
        elif not closes:
            self.bars.append(True)
            self.depth += 1
        return Token("RAB" if closes else "BAR", "|", piece.position)

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
        if sign:
            yield from self.operator(sign, count)
        elif plain(piece).strip(".") in _CONSTANT:
            self.take()
            yield Token("CONSTANT", "const", piece.position)
        elif piece.group and self.one_letter([piece]):
            yield from self.lettered()
        elif first in _WORDED and len(plain(piece)) > 1:
            self.take()
            self.items[self.at : self.at] = [
                piece.group[0],
                Piece("{}", piece.group[0].position, piece.group[1:]),
            ]
            yield from self.words()
        elif behind == "_" or behind == "'" or first in _SWITCHES:
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

    # Derivatives, powers, functions

    def fraction(self) -> Iterator[Token]:
        piece = self.take()
        over, below = self.argument(piece), self.argument(piece)
        found = _operator(over, below, piece.position)
        if found is None:
            yield Token("FRACTION", piece.text, piece.position)
            yield from self.braced(over, piece.position)
            yield from self.braced(below, piece.position)
            return
        sign, rest, by = found
        self.taken_of(piece.position)
        body = [list(self.inside(rest))] if rest else []
        variables = [self.variable(part, piece.position) for part in by]
        yield from self.derivative(sign, body, variables, piece.position)

    def variable(self, part: Sequence[Piece], position: int) -> list[Token]:
        """What is differentiated by; the time is, whether a table has it or not."""
        if [piece.text for piece in flat(part)] == ["t"]:
            return [Token("SYMBOL", _TIME, position)]
        return list(self.inside(part))

    def taken_of(self, position: int) -> None:
        """Refuse brackets behind a derivative that may say where it is taken."""
        at = self.behind(self.at)
        if not self.open or at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if [piece.text for piece in inner] == ["t"]:
            self.at = end + 1
        elif plain(*inner) == "0" or self.one_letter(inner) or "t" in _terms(inner):
            reason = "a derivative at a place, or times what stands in brackets?"
            raise UnreadError(reason, position)

    def derivative(
        self, sign: str, body: list[list[Token]], by: list[list[Token]], position: int
    ) -> Iterator[Token]:
        """The tokens of d^n…/dx^n, of a body that stands above the bar, or of none."""
        times = all(len(part) == 1 and part[0].value == _TIME for part in by)
        if times and len(by) <= 2 and (sign == "d" or not self.open):
            yield Token("RATE", len(by), position)
            by = []
        else:
            yield Token("SLOPE" if body else "OPERATOR", sign, position)
        for part in (*body, *by):
            yield Token("_BEGIN", "{", position)
            yield from part
            yield Token("_END", "}", position)

    def operator(self, sign: str, count: int) -> Iterator[Token]:
        r"""A d or ∂ outside of a fraction: dx/dt, ``\partial_x``, or a differential."""
        start, position = self.at, self.peek().position
        self.at += count
        if sign == "∂" and not self.open:
            raise UnreadError(
                r"∂ outside of a fraction: write \frac{\partial…}{\partial…}", position
            )
        if sign == "∂" and self.peek().text == "_":
            piece = self.take()
            index = self.argument(piece)
            if plain(index[0] if len(index) == 1 else piece) in frozenset("ijklμν_"):
                raise UnreadError("∂ with an index: by what is it differentiated?", position)
            yield from self.derivative("∂", [], [self.variable(index, position)], position)
            return
        order = 1
        if self.peek().text == "^" and plain(self.peek(1)).isdigit():
            order = int(plain(self.peek(1))[:2])
            self.at += 2
        self.skip()
        apart = self.peek().position - self.items[start + count - 1].position
        if not self.starts_letter(self.at):
            upright = count > 1 or self.items[start].text == "{}"
            if sign == "d" and (upright or self.peek().text in ("(", "[")):
                reason = "d before more than a letter: a differential, or a factor?"
                raise UnreadError(reason, position)
            self.at = start
            if sign == "∂":
                raise UnreadError("∂ without what it is to act on", position)
            yield from self.lettered()
            return
        glyph = self.letter()
        behind = self.at
        self.skip()
        if self.peek().text == "/":
            below, n = operator_at(self.items, self.at + 1)
            if below == sign:
                self.at += 1 + n
                by = self.at
                if not self.starts_letter(self.at):
                    raise UnreadError("a derivative by what is no letter", position)
                self.letter()
                if order > 1:
                    raise UnreadError("a derivative of higher order on one line", position)
                body = list(self.resolved(glyph, position))
                variable = self.variable(self.items[by : self.at], position)
                yield from self.derivative(sign, [body], [variable], position)
                return
        self.at = behind
        if sign == "∂":
            raise UnreadError("∂ without what it is differentiated by", position)
        single = count == 1 and self.items[start].text == "d" and order == 1
        if not self.open and not self.integrals:
            raise UnreadError(r"a differential: a derivative is a dot or \frac{d…}{dt}", position)
        if single and (self.lonely_d or (apart > 1 and not self.integrals)):
            raise UnreadError(r"d: a differential or a letter? write \mathrm{d}", position)
        if order > 3:
            raise UnreadError("a differential of higher order", position)
        raised = ("", "²", "³")[order - 1]
        [of] = self.resolved(glyph, position)
        dressed = replace(glyph, base=f"d{raised}{glyph.base}", bold=glyph.bold and order == 1)
        yield Token("DIFFERENTIAL", (own(dressed), order, of.value), position)

    def power(self) -> Iterator[Token]:
        piece = self.take()
        letter, function = self.last == "SYMBOL", self.last == "FUNCTION"
        raised = self.argument(piece)
        if plain(*raised) in (r"\circ", "°"):
            raise UnreadError(_DEGREES, piece.position)
        if letter and plain(*raised) in ("0", "1"):
            raise UnreadError("0 or 1 above a letter: an index, or a power?", piece.position)
        if plain(*raised) in _TRANSPOSED:
            yield Token("TRANSPOSED", "T", piece.position)
        else:
            yield Token("POWER", "^", piece.position)
            yield from self.braced(raised, piece.position)
        at = self.behind(self.at)
        if function or at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if [piece.text for piece in inner] == ["t"]:
            self.at = end + 1  # ω²(t): that it depends on the time is left out
        elif self.open and letter and (self.commas(at) or self.one_letter(inner)):
            raise UnreadError("a power, and then what it is a function of?", piece.position)

    def root(self) -> Iterator[Token]:
        piece = self.take()
        index = "2"
        if self.peek().text == "[":
            inner, end = self.bracketed(self.at, ("[", "]"))
            index = plain(*inner)
            if end < 0 or not re.fullmatch("[2-9]", index):
                raise UnreadError("a root whose index is no small number", piece.position)
            if not self.open and index != "2":
                raise UnreadError("roots other than the square root are not read", piece.position)
            self.at = end + 1
        yield Token("ROOT", int(index), piece.position)
        yield from self.braced(self.argument(piece), piece.position)

    def function(self, name: str, position: int) -> Iterator[Token]:
        """A function; what stands in braces behind it must not be a sum."""
        at = self.behind(self.at + 2 * (self.peek().text == "^"))
        inner, end = self.bracketed(at, ("[", "]"))
        if end >= 0 and plain(*inner).isdigit() and end + 1 < len(self.items):
            power = Piece("^", self.items[at].position)  # \cos[2](x) of the package physics
            self.items[at : end + 1] = [power, Piece("{}", power.position, tuple(inner))]
        elif end >= 0:
            for i, text in ((at, "("), (end, ")")):
                self.items[i] = replace(self.items[i], text=text)
        yield Token("FUNCTION", name, position)
        self.skip()
        if self.peek().text == "^":
            self.last = "FUNCTION"
            yield from self.power()
            self.skip()
        if self.peek().text == "(" and self.called is None:
            self.called = self.depth
        group = self.peek().group
        if self.peek().text != "{}" or (group and group[0].text in ("(", r"\left")):
            return
        if {piece.text for piece in group} & {"+", "-", "/"} or self.several(group):
            reason = "what the function acts on: put it in brackets"
            raise UnreadError(reason, self.peek().position)

    def several(self, group: Sequence[Piece]) -> bool:
        """Whether what stands in braces is more than an angle with a number, or a rate times t."""
        found = list(self.inside(group))
        if len(found) > 1 and found[-1].value == self.notation.symbol(Glyph("t")):
            found.pop()
        kinds = [token.kind for token in found]
        if kinds[:1] in (["NUMBER"], ["FRACTION"], ["FUNCTION"]):
            symbols = kinds.count("SYMBOL") if kinds[0] == "NUMBER" else 0
            return symbols > 1
        return kinds.count("SYMBOL") > 1

    # Sums and integrals

    def limits(self) -> list[tuple[Piece, ...] | None]:
        """What stands below and above, in any order."""
        found: dict[str, tuple[Piece, ...]] = {}
        self.skip()
        while self.peek().text in ("_", "^"):
            piece = self.take()
            found[piece.text] = self.argument(piece)
            self.skip()
        return [found.get("_"), found.get("^")]

    def under(self) -> Iterator[Token]:
        """The index of a sum, and its limits."""
        position = self.peek().position
        below, above = self.limits()
        index, lower = below or (), None
        for i, piece in enumerate(index):
            if piece.text == "=" and above is not None:
                index, lower = index[:i], index[i + 1 :]
                break
        if above is not None and lower is None:
            raise UnreadError("a sum with an end and no start", position)
        over = said(index)
        if below is not None and not over.strip("_ "):
            raise UnreadError("a sum whose index is no letter", position)
        if not self.open and (above is not None or not re.fullmatch(r"[a-z]", over)):
            reason = f"a sum over {over!r}: only over an index, such as k"
            raise UnreadError(reason if below else "a sum without its index", position)
        yield Token("INDEX", over, position)
        for part in (lower, above):
            if part is not None:
                yield from self.braced(part, position)

    def integral(self) -> Iterator[Token]:
        piece = self.take()
        below, above = self.limits()
        if below is None and above is not None:
            raise UnreadError("an integral with an end and no start", piece.position)
        yield Token("INTEGRAL", "", piece.position)
        for part in (below, above):
            if part is not None:
                yield from self.braced(part, piece.position)

    # Environments

    def environment(self) -> Iterator[Token]:
        piece = self.peek()
        name, end = self.named_environment()
        kind = name.rstrip("*")
        inner = self.items[self.at + 2 : end]
        if kind in ("array", *_ARGUED):
            while inner and inner[0].text in ("[", "{}"):
                inner = inner[_behind(inner) :]
        self.at = end + 2
        whole = self.last != "OPEN" and not self.depth
        if (name in _CASES and self.open) or (kind in ("array", "matrix") and whole):
            yield from self.system(name, inner, piece.position)
        elif name in _MATRICES or kind == "array":
            yield from self.rows(name, inner, piece.position)
        elif kind in _LINES:
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", piece.position)
        elif kind.endswith("vmatrix") or kind == "Vmatrix":
            raise UnreadError("a determinant that is written out", piece.position)
        else:
            raise UnreadError(f"the environment {name}", piece.position)

    def named_environment(self) -> tuple[str, int]:
        r"""The name of the environment that begins here, and where its ``\end`` stands."""
        position = self.peek().position
        name = plain(self.peek(1))
        depth = 0
        for i in range(self.at, len(self.items)):
            depth += {r"\begin": 1, r"\end": -1}.get(self.items[i].text, 0)
            if depth > DEEPEST:
                raise UnreadError(f"nested deeper than {DEEPEST}", position)
            if depth == 0:
                ends = plain(*self.items[i + 1 : i + 2])
                if ends != name:
                    raise UnreadError(rf"\begin{{{name}}} that ends as {ends}", position)
                return name, i
        raise UnreadError(rf"\begin{{{name}}} without its \end", position)

    def system(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        """Equations below one another, or the values that one side has in several cases."""
        cells = [split(row, "&") for row in _rows(inner) if row]
        related = any(p.text in _RELATIONS for row in cells if row for p in flat(row[0]))
        aligned = any(p.text in _RELATIONS for row in cells if len(row) > 1 for p in row[1][:1])
        if name not in _CASES or (self.last != "RELATION" and (related or aligned)):
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", position)
            return
        branches = []
        for row in cells:
            value = [t for t in self.inside(row[0]) if t.kind not in ("ALIGN", "SPACE")]
            while value and value[-1].kind in ("COMMA", "SEPARATOR"):
                value.pop()
            condition = " ".join(filter(None, map(said, row[1:])))
            branches.append((tuple(value), condition))
        if not branches:
            raise UnreadError("cases without any", position)
        yield Token("BRANCHES", tuple(branches), position)

    def rows(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("MATRIX", name, position)
        for i, row in enumerate(_rows(inner)):
            if i:
                yield Token("LINE", r"\\", position)
            for j, cell in enumerate(split(row, "&")):
                if j:
                    yield Token("COMMA", "&", position)
                yield from self.inside(cell)
        yield Token("XIRTAM", name, position)

    # Words

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
        named = written in _WORDS or written.strip(". ") in _CONSTANT or len(written) > 3
        return named or self.peek().text not in UPRIGHT

    def words(self) -> Iterator[Token]:
        piece = self.take()
        inner = self.argument(piece)
        written = said(inner)
        bare = written.strip(" .,;:")
        if not bare:
            yield Token("SEPARATOR" if written and not self.depth else "SPACE", "", piece.position)
        elif bare.lower() in _CONSTANT:
            yield Token("CONSTANT", "const", piece.position)
        elif bare in _WORDS or (bare in _ELLIPTIC and not self.open):
            yield from self.function({"ln": "log", "Tr": "tr"}.get(bare, bare), piece.position)
        elif _NUMBER_OF.fullmatch(bare):
            yield Token("TAG", bare.strip("()"), piece.position)
        elif _mathematical(inner):
            if self.open and bare.split()[0].lower() in CONDITIONS and not self.depth:
                yield Token("WORDS", bare, piece.position)
                return
            raise UnreadError("mathematics in words inside a formula", piece.position)
        elif self.commented >= 0 and self.at - self.commented <= 3:
            return
        elif not self.open and bare.lower() == "and" and not self.depth:
            yield Token("SEPARATOR", bare, piece.position)
        elif not self.open and (self.depth or bare.split()[0].lower() not in CONDITIONS):
            raise UnreadError(f"words inside a formula: {bare!r}", piece.position)
        elif not self.open:
            yield Token("WORDS", bare, piece.position)
        elif _UNIT.fullmatch(bare) and self.last in ("NUMBER", "_END", "CLOSE"):
            base = bare if len(bare) > 1 else f" {bare}"  # metres are no masses
            yield Token("SYMBOL", self.notation.symbol(Glyph(base)), piece.position)
        elif self.is_quantity(bare):
            yield Token("SYMBOL", self.notation.symbol(self.scripts(Glyph(bare))), piece.position)
        elif piece.text in _UPRIGHT_ALONE and bare.isalnum():
            raise UnreadError(f"the function {bare} is not known", piece.position)
        elif self.depth:
            raise UnreadError(f"words inside a formula: {bare[:40]!r}", piece.position)
        else:
            yield Token("WORDS", bare, piece.position)

    def is_quantity(self, written: str) -> bool:
        """Whether words stand where a quantity would: with nothing but signs around them."""
        if len(written) > 40 or written.split()[0].lower() in CONDITIONS | _CONNECTIVES:
            return False
        self.skip()
        behind = self.peek().text
        ends = {"", ")", "]", r"\right"} if self.depth or self.last in _BEFORE_LAST else set()
        follows = behind in _SIGNS_AROUND | ends
        aligned = behind == "&" and self.peek(1).text in _SIGNS_AROUND
        return self.last in _BEFORE and (follows or aligned)

    # Letters

    def symbol(self) -> Iterator[Token]:
        position = self.peek().position
        sign, count = operator_at(self.items, self.at)
        word = "" if sign else self.spelled()
        if sign:
            yield from self.operator(sign, count)
        elif word in _SPELLED:
            self.at += len(word)
            yield from self.function(word, position)
        elif word in ("Re", "Im"):
            raise UnreadError("a real or imaginary part: that is not read", position)
        elif word:
            reason = "a word or a product? put words in \\text{}, spaces between letters"
            raise UnreadError(f"{word}: {reason}", position)
        else:
            yield from self.lettered()

    def spelled(self) -> str:
        """A function spelled with single letters, or a row of letters that looks like a word."""
        run = ""
        for i in range(40):
            piece = self.peek(i)
            if not (_is_latin(piece.text) and piece.text.isascii()):
                break
            if i and piece.position != self.peek(i - 1).position + 1:
                break
            run += piece.text
        for name in _SPELLED:
            if run.startswith(name):
                return name
        if not self.open:
            return ""
        bracketed = self.peek(len(run)).text in ("(", "[", r"\left", r"\{")
        if run in ("Re", "Im") and bracketed:
            return run
        before = self.items[self.at - 1] if self.at else Piece("", -9)
        joined = _is_latin(before.text) and before.position + 1 == self.peek().position
        cut = min((run.find(name) for name in _SPELLED if name in run), default=len(run))
        if not joined and _ENERGY.fullmatch(run) and self.peek(len(run)).text == "=":
            return run
        twice = cut == 3 and any(a == b for a, b in pairwise(run[:cut]))
        return run if (twice or cut >= 4) and not joined and not _is_product(run[:cut]) else ""

    def lettered(self) -> Iterator[Token]:
        """A letter, with the brackets behind it if it is a function of what they hold."""
        position, before = self.peek().position, self.last
        pair = self.peek().text + self.peek(1).text
        if self.open and pair in ("KE", "PE") and self.peek(1).position == position + 1:
            self.at += 2
            glyph = self.scripts(Glyph(pair))
        else:
            glyph = self.letter()
        if glyph == Glyph("e") and self.peek().text == "^":
            piece = self.take()
            yield Token("EXPONENTIAL", "e", position)
            yield from self.braced(self.argument(piece), piece.position)
            return
        change = glyph == Glyph("Δ") or (glyph == Glyph("δ") and before != "NUMBER")
        if (
            self.open
            and change
            and self.starts_letter(self.at)
            and not operator_at(self.items, self.at)[0]
        ):
            of = self.letter()
            glyph = replace(of, base=glyph.base + of.base)
        if glyph == Glyph("π"):
            if [self.peek(i).text for i in range(3)] == ["(", "t", ")"]:
                raise UnreadError("π of the time: another letter than the number", position)
            yield Token("SYMBOL", sympy.pi, position)
            return
        if self.open and glyph == Glyph("D") and self.starts_letter(self.at):
            raise UnreadError("D before a letter: a derivative, or a factor?", position)
        found = list(self.resolved(glyph, position))
        if self.open:
            self.arguments(glyph)
            self.functional()
        else:
            self.of_time()
        yield from found

    def resolved(self, glyph: Glyph, position: int) -> Iterator[Token]:
        """The symbol of a letter; of one with dots or several indices, what it is made of."""
        several = _BOTH.get(glyph.sub, glyph.sub).split(",") if self.two_signs else []
        several = several or glyph.sub.split(",")
        known = self.known(glyph)
        if known is None and self.peek().text == "^" and plain(self.peek(1)) == "2":
            known = self.notation.symbol(replace(glyph, base=glyph.base + "²"))
            self.at += 2 if known is not None else 0
        several_of = known is None or (
            self.two_signs and all(x.isdigit() or x in "+−" for x in several)
        )
        if several_of and 1 < len(several) <= (2 if self.open else MOST_INDICES):
            made = tuple(self.known(replace(glyph, sub=sub)) for sub in several)
            if None not in made:
                yield Token("CHOICE", made, position)
                return
        if known is not None:
            yield Token("SYMBOL", known, position)
            return
        for order, accent in {"dot": ((1, ""),), "ddot": ((1, "dot"), (2, ""))}.get(
            glyph.accent, ()
        ):
            letter = self.known(replace(glyph, accent=accent))
            if letter is not None:
                yield Token("RATE", order, position)
                yield Token("_BEGIN", "{", position)
                yield Token("SYMBOL", letter, position)
                yield Token("_END", "}", position)
                return
        hint = ""
        if glyph.sub in frozenset("ijkl"):
            hint = ": write an equation for each value of the index"
        elif glyph == Glyph("d"):
            hint = r": a derivative is a dot or \frac{d…}{dt}"
        raise UnreadError(f"no symbol {spelling(glyph)} in this notation{hint}", position)

    def known(self, glyph: Glyph) -> sympy.Symbol | None:
        """The symbol of a glyph, also of a unit vector with a hat that it does not need."""
        found = self.notation.symbol(glyph)
        if found is None and "(ext)" in glyph.sub:
            sub = glyph.sub.replace("(ext)", "(e)" if "," in glyph.sub else "ext")
            found = self.notation.symbol(replace(glyph, sub=sub))
        if found is not None or glyph.accent != "hat":
            return found
        bare = self.notation.symbol(replace(glyph, accent="", bold=True))
        return bare if bare in VOCABULARY and VOCABULARY[bare].unit == "" else None

    def of_time(self) -> None:
        """Leave out that a symbol of a table depends on time or place: ω(t), ρ(r)."""
        at = self.behind(self.at)
        if at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        inside, place = plain(*inner), self.items[at].position
        if inside == "t" and self.called is not None:
            reason = "of the time, or times t? leave (t) out, or t without brackets"
            raise UnreadError(reason, place)
        if inside in ("t", "r"):
            self.at = end + 1
        elif inside == "0" or inside.startswith("t="):
            raise UnreadError("a value at one time", place)

    def arguments(self, glyph: Glyph) -> None:
        """Decide whether brackets behind a letter hold what it is a function of.

        That it depends on time, x(t), is left out.
        """
        at = self.behind(self.at, NOTHING - {" ", r"\,"})
        if at < len(self.items) and self.items[at].text == "{}":
            inner = [p for p in self.items[at].group if p.text not in NOTHING]
            if len(inner) > 2 and (inner[0].text, inner[-1].text) == ("(", ")"):
                self.items[at : at + 1] = inner  # R{(θ)}
        if at >= len(self.items) or self.items[at].text != "(":
            return
        inner, end = self.bracketed(at)
        if end < 0:
            return
        inside, place = plain(*inner), self.items[at].position
        texts = {piece.text for piece in inner}
        function = any(known == glyph for known, _ in self.habits.functions)
        if inside == "t":
            if self.called is not None and glyph.base not in _TIMELY:
                reason = "of the time, or times t? leave (t) out, or t without brackets"
                raise UnreadError(reason, place)
            if function:
                self.calls.add(at)
            else:
                self.at = end + 1
        elif inside.startswith("t="):
            del self.items[at + 1 : at + 3]
            self.calls.add(at)
        elif (
            inside == "0"
            or self.one_letter(inner)
            or self.commas(at)
            or _listed(inner)
            or glyph.base in _ORDERS
            or any((glyph, term) in self.habits.functions for term in _shifted(inner))
            or self.habits.is_a(glyph, Sort.FUNCTION)
        ):
            self.calls.add(at)
        elif glyph in self.habits.timed and "t" in texts and not function:
            raise UnreadError(f"{spelling(glyph)} at the time in brackets, or times it?", place)
        elif self.habits.is_a(glyph, Sort.NUMBER) and not function and "t" not in texts:
            return  # a mass, a length: times what stands in brackets
        elif function or glyph.base in _POTENTIALS or inside.replace(".", "").isdigit():
            raise UnreadError(f"{spelling(glyph)} of what stands in brackets, or times it?", place)

    def functional(self) -> None:
        """Decide whether square brackets behind a letter hold what it is a functional of, S[q]."""
        at = self.behind(self.at, NOTHING - {" ", r"\,"})
        inner, end = self.bracketed(at, ("[", "]"))
        if end < 0:
            return
        texts = [piece.text for piece in inner]
        bracket = texts.index("(") if "(" in texts else len(inner)
        alone = self.one_letter(inner[:bracket]) and texts[-1:] in ([")"], texts[bracket - 1 :])
        if self.commas(at) or alone:
            self.calls.add(at)

    def letter(self) -> Glyph:
        """A letter with its fonts, accents, index and prime, in any order."""
        dresses: list[Piece] = []
        while self.peek().text in _DRESSES:
            dresses.append(self.take())
            self.skip()
        piece = self.take()
        text = piece.text
        if text in _STYLES:
            glyph = Glyph(_styled(plain(*self.argument(piece)), text, piece.position))
        elif text == "{}":
            glyph = self.dressed(piece, {dress.text for dress in dresses})
        elif text == r"\nabla":
            glyph = Glyph("∇", bold=True)
        elif text in _LETTERS:
            glyph = Glyph(_LETTERS[text])
        elif self.is_alphabetic(text):
            glyph = Glyph(text)
        elif text in ("0", "1") and any(dress.text in BOLD for dress in dresses):
            glyph = Glyph(text, bold=True)
        elif text in TEXTS and self.peek().text == "{}":
            glyph = Glyph(said(self.argument(piece)))
        elif text.startswith("\\") and len(text) > 1:
            known = "of TeX" if text[1:].isalpha() else "here"
            raise UnreadError(f"the command {text} is not known {known}", piece.position)
        elif len(text) == 1 and text.isalpha():
            raise UnreadError(f"words inside a formula: {text!r}", piece.position)
        else:
            reason = f"{text or 'the end'} where a symbol should be"
            raise UnreadError(reason, piece.position)
        for dress in reversed(dresses):
            glyph = _dressed(glyph, dress)
        glyph = self.scripts(glyph)
        still = replace(glyph, accent="" if "dot" in glyph.accent else glyph.accent)
        spatial = self.crossed and self.habits.is_a(still, Sort.SPATIAL)
        return replace(glyph, bold=True) if spatial else glyph

    def dressed(self, piece: Piece, worn: set[str]) -> Glyph:
        """The letter in braces; several beneath one arrow, or upright, are one letter."""
        whole = worn & ({r"\vec", r"\overrightarrow", r"\overline"} | UPRIGHT)
        written = plain(piece)
        if self.open and whole and len(written) > 1 and written.isascii() and written.isalnum():
            return Glyph(written)
        if written in ("0", "1") and worn & BOLD:
            return Glyph(written, bold=True)
        if not piece.group:
            raise UnreadError("an empty group", piece.position)
        inner = self.within(piece.group, self.depth)
        glyph = inner.letter()
        inner.skip()
        if inner.at < len(inner.items):
            raise UnreadError("no single symbol in braces", piece.position)
        return glyph

    def scripts(self, glyph: Glyph) -> Glyph:
        while True:
            piece = self.peek()
            if piece.text == "'":
                self.take()
                glyph = _primed(glyph)
            elif piece.text == "_":
                self.take()
                sub = said(self.argument(piece)).replace("-", "−")
                sub = sub if self.open else sub.replace(" ", "")
                if not sub:
                    raise UnreadError("an empty index", piece.position)
                if glyph.sub and not glyph.sub.startswith("("):
                    raise UnreadError("two indices", piece.position)
                glyph = replace(glyph, sub=",".join(filter(None, (sub, glyph.sub))))
            elif piece.text == "^" and self.peek(2).text == "_":
                at = self.at  # x^2_1 is x_1^2
                self.items[at : at + 4] = [*self.items[at + 2 : at + 4], *self.items[at : at + 2]]
            elif piece.text == "^":
                found = self.raised(glyph, self.peek(1))
                if found is None:
                    return glyph
                self.at += 2
                glyph = found
            else:
                return glyph

    def raised(self, glyph: Glyph, above: Piece) -> Glyph | None:
        """The letter with what stands above it, if that is no power."""
        if glyph.base == "e" and not glyph.bold:
            return None
        written = plain(above)
        if written and set(written) == {"′"}:
            for _ in written:
                glyph = _primed(glyph)
            return glyph
        if written in ("*", r"\ast", r"\star", r"\dagger", "+", "-"):
            sign = {"-": "⁻", "+": "⁺", r"\dagger": "†"}.get(written, "*")
            return replace(glyph, base=glyph.base + sign)
        first = above.group[0].text if above.group else above.text
        bracketed = re.fullmatch(r"\(\w{1,4}\)", written)
        worded = first in TEXTS | UPRIGHT and len(written) > 1 and len(above.group) == 2
        if bracketed or worded or (written == "ext" and not self.open):
            sub = f"({written.strip('()')})"
            return replace(glyph, sub=",".join(filter(None, (glyph.sub, sub))))
        if self.open and written in _INDEXES and not glyph.bold:
            raise UnreadError(f"{written} above a letter: an index, or a power?", above.position)
        return None


# --- Looking at pieces ---------------------------------------------------------------------------


def operator_at(items: Sequence[Piece], at: int) -> tuple[str, int]:
    r"""Whether a d or ∂ stands there, and in how many pieces: ``d``, ``\mathrm d``, ``{\rm d}``."""
    text = items[at].text if at < len(items) else ""
    if text == "d":
        return "d", 1
    if text == r"\partial":
        return "∂", 1
    if text in _WORDED and at + 1 < len(items) and plain(items[at + 1]) == "d":
        return "d", 2
    if text == "{}" and items[at].group and items[at].group[0].text in _WORDED:
        return ("d", 1) if plain(items[at]) == "d" else ("", 0)
    return "", 0


def _operator(
    over: Sequence[Piece], below: Sequence[Piece], position: int
) -> tuple[str, Sequence[Piece], list[Sequence[Piece]]] | None:
    """What is differentiated and by what, of a fraction that is a derivative."""
    over, below = ([p for p in part if p.text not in NOTHING] for part in (over, below))
    sign, count = operator_at(over, 0)
    if not sign:
        marked = [p.text for p in flat(over) if p.text not in _DRESSES | TEXTS] == ["d"]
        if marked and operator_at(below, 0)[0]:
            raise UnreadError("a derivative whose d has a mark of its own", position)
        return None
    order = 1
    if count < len(over) - 1 and over[count].text == "^":
        if not plain(over[count + 1]).isdigit():
            return None
        order, count = int(plain(over[count + 1])[:2]), count + 2
    by: list[Sequence[Piece]] = []
    i = 0
    while i < len(below):
        also, n = operator_at(below, i)
        if also != sign:
            return None
        start = i = i + n
        while i < len(below) and not operator_at(below, i)[0]:
            i += 1
        variable = below[start:i]
        times = 1
        if len(variable) > 2 and variable[-2].text == "^" and plain(variable[-1]).isdigit():
            times, variable = int(plain(variable[-1])[:1]), variable[:-2]
        if not variable or variable[0].text in ("_", "^", "'", "+", "-"):
            return None
        by += [variable] * times
    if not by:
        return None
    if len(by) != order or order > 4:
        raise UnreadError("a derivative whose orders above and below differ", position)
    return sign, over[count:], by


def _infix(items: Sequence[Piece], level: int) -> Sequence[Piece]:
    r"""Pieces without TeX's own ``\over`` and ``\cr``."""
    texts = [piece.text for piece in items]
    if r"\cr" in texts:
        items = [replace(p, text=r"\\") if p.text == r"\cr" else p for p in items]
    if not level or texts.count(r"\over") != 1:
        return items
    at = texts.index(r"\over")
    place = items[at].position
    halves = (tuple(items[:at]), tuple(items[at + 1 :]))
    return [Piece(r"\frac", place), *(Piece("{}", place, half) for half in halves)]


def _crossed(items: Sequence[Piece]) -> bool:
    """Whether × stands anywhere but before or behind a number."""
    return any(_crossed(piece.group) for piece in items) or any(
        piece.text == r"\times"
        and not (items[max(i - 1, 0)].text in DECIMALS or plain(*items[i + 1 : i + 2]).isdigit())
        for i, piece in enumerate(items)
    )


def _lonely_d(items: Sequence[Piece]) -> bool:
    """Whether a d stands alone: a letter, a distance say."""
    ends = {*_RELATIONS, "+", "-", ")", "", "_", "/", ",", r"\cdot"}
    for i, piece in enumerate(items):
        if piece.text == "{}":
            over = piece.group[:1] and piece.group[0].text == "d"  # the bar of a derivative
            if over and (len(piece.group) == 1 or piece.group[1].text == "^"):
                continue
            if _lonely_d(piece.group):
                return True
        if piece.text != "d" or (i and items[i - 1].text in _WORDED | {"_", "^"}):
            continue
        behind = items[i + 1].text if i + 1 < len(items) else ""
        if behind in ends and not (i and items[i - 1].text == r"\frac"):
            return True
    return False


def _mathematical(words: Sequence[Piece]) -> bool:
    """Whether a relation stands among words."""
    return any(piece.text in _MATHEMATICAL for piece in flat(words))


def _listed(inner: Sequence[Piece]) -> bool:
    """Whether letters are listed with dots and without commas: x₁ … x_n."""
    texts = [piece.text for piece in inner]
    return any(text in _OMITTED for text in texts) and not {"+", "-"} & set(texts)


def _terms(inner: Sequence[Piece]) -> set[str]:
    """The letters that are terms of a sum, without index or prime: x of x − ct."""
    made = set()
    parts: list[list[Piece]] = [[]]
    for piece in inner:
        if piece.text in ("+", "-"):
            parts.append([])
        else:
            parts[-1].append(piece)
    for part in parts:
        bare = [p for p in part if p.text not in _DRESSES]
        if bare and (len(bare) == 1 or bare[1].text in ("_", "'")) and len(bare) <= 3:
            made.add(_LETTERS.get(plain(bare[0]), plain(bare[0])))
    return made


def _length(items: Sequence[Piece]) -> int:
    """How many pieces are the distance to the next line: `\\\\[2pt]`."""
    texts = [piece.text for piece in items[:12]]
    if texts[:1] != ["["] or "]" not in texts:
        return 0
    end = texts.index("]")
    return end + 1 if _LENGTH.fullmatch("".join(texts[1:end])) else 0


def _rows(inner: Sequence[Piece]) -> list[Sequence[Piece]]:
    """The rows of an environment, without the distances between them."""
    return [row[_length(row) :] for row in split(inner, r"\\")]


def _shifted(inner: Sequence[Piece]) -> set[str]:
    """The letters of a sum without powers, which may be an argument: x − ct, not y − x² + 1."""
    return set() if any(piece.text == "^" for piece in inner) else _terms(inner)


def _behind(inner: Sequence[Piece]) -> int:
    """Behind an argument in braces or square brackets."""
    if inner[0].text == "{}":
        return 1
    return next((i + 1 for i, piece in enumerate(inner) if piece.text == "]"), 1)


def _is_latin(text: str) -> bool:
    """Whether it is a letter that formulas have."""
    return len(text) == 1 and text.isalpha() and (text.isascii() or text in _ALPHABET)


def _is_product(run: str) -> bool:
    """Whether a row of letters is rather a product, such as mgRh: no vowels in it."""
    return not set(run.lower()) & set("aeiouy")


# --- Glyphs --------------------------------------------------------------------------------------


def _styled(written: str, style: str, position: int) -> str:
    if len(written) != 1:
        raise UnreadError("no single symbol in braces", position)
    if style == r"\mathbb" and written in _SETS:
        raise UnreadError("a set: that is not read", position)
    case = "CAPITAL" if written.isupper() else "SMALL"
    for prefix in ("MATHEMATICAL ", ""):
        try:
            return unicodedata.lookup(f"{prefix}{_STYLES[style]} {case} {written.upper()}")
        except KeyError:
            continue
    return written


def _primed(glyph: Glyph) -> Glyph:
    return replace(glyph, base=glyph.base + "′") if glyph.prime else replace(glyph, prime=True)


def _dressed(glyph: Glyph, dress: Piece) -> Glyph:
    if dress.text in BOLD:
        return replace(glyph, bold=True)
    if dress.text in _MARKS:
        return replace(glyph, base=glyph.base + _MARKS[dress.text])
    if dress.text in UPRIGHT:
        return glyph
    accent = "hat" if dress.text in _HATS else {1: "dot", 2: "ddot"}[_OVER[dress.text]]
    if glyph.accent == "hat" and accent != "hat":
        glyph = replace(glyph, base=glyph.base[0] + "\u0302" + glyph.base[1:], accent="")
    if glyph.accent:
        raise UnreadError("an accent above an accent", dress.position)
    return replace(glyph, accent=accent, bold=glyph.bold or dress.text == r"\hat")


def spelling(glyph: Glyph) -> str:
    """A glyph in words, for messages.

    >>> spelling(Glyph("ω", "7", "dot", prime=True))
    'ω_7 with a dot and a prime'
    """
    extras = [{"dot": "a dot", "ddot": "two dots", "hat": "a hat"}.get(glyph.accent, "")]
    extras += ["a prime" if glyph.prime else "", "bold type" if glyph.bold else ""]
    joint = " and ".join(filter(None, extras))
    name = f"{glyph.base}_{glyph.sub}" if glyph.sub else glyph.base
    return f"{name} with {joint}" if joint else name


def shown(token: Token, notation: Notation) -> str:
    """A token in words, for messages."""
    glyph = notation.glyphs.get(token.value) if token.kind == "SYMBOL" else None
    if glyph is None and not isinstance(token.value, str):
        return "what stands here"
    return spelling(glyph) if glyph is not None else token.value or "this"
