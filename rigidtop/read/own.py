r"""Anyone's notes taken apart: letters that no table has, and the many ways of writing.

`Own` goes through TeX as `Scan` does, and understands besides: any letter in any dress; d and ∂
before and over anything; functions of letters, f(q, t); sums and integrals with limits; ± and ∓;
cases, systems, rows; what is taken at a place; words and conditions behind a line.  Where a text
could mean two things it is not read, and the reason says which two.

>>> from rigidtop.notation import OWN
>>> from rigidtop.read.scan import pieces
>>> [t.kind for t in Own(pieces(r"V(x) = \int_0^x F\,dx"), OWN).tokens()][:6]
['SYMBOL', 'OF', 'SYMBOL', 'FO', 'RELATION', 'INTEGRAL_OVER']
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import pairwise

import sympy

from rigidtop.notation import Notation
from rigidtop.notation.characters import GREEK
from rigidtop.notation.convention import own
from rigidtop.read import scan
from rigidtop.read.scan import Piece, Scan, Token, UnreadError, spelling
from rigidtop.theory.symbols import Glyph

_RELATIONS = {
    **dict.fromkeys((r"\le", r"\leq", r"\leqslant"), "≤"),
    **dict.fromkeys((r"\ge", r"\geq", r"\geqslant"), "≥"),
    **dict.fromkeys((r"\simeq", r"\cong", r"\approxeq"), "≃"),
    **dict.fromkeys((r"\triangleq", r"\coloneqq", r"\doteq", r"\eqqcolon", r"\coloneq"), "≡"),
    r"\ll": "≪",
    r"\gg": "≫",
    r"\sim": "∼",
    r"\propto": "∝",
    r"\lesssim": "≲",
    r"\gtrsim": "≳",
    r"\perp": "⊥",
    r"\parallel": "∥",
}
_ARROWS = frozenset(
    "\\" + name
    for name in [
        "rightarrow",
        "to",
        "longrightarrow",
        "leftrightarrow",
        "longleftrightarrow",
        "because",
    ]
)
_SIGNS = {r"\pm": ("+", "-"), r"\mp": ("-", "+")}
_OMITTED = frozenset({r"\cdots", r"\ldots", r"\dots", r"\dotsb", r"\dotsc", r"\vdots", "…", "⋯"})
_LEFT_OUT = frozenset(
    {r"\boxed", r"\fbox", r"\mathop", r"\mathord", r"\mathrel", r"\ensuremath", r"\scriptstyle"}
    | {r"\displaylimits", r"\strut", r"\mathstrut", r"\null", r"\relax", r"\qedhere", r"\smash"}
    | {r"\mathclap", r"\bf@series", r"\protect", r"\hfil", r"\centering", r"\nobreak", r"\/", r"\-"}
)
_WITH_ONE = frozenset({r"\color", r"\textcolor", r"\mspace", r"\hskip", r"\colorbox", r"\cite"})
"""Commands that are left out with their first argument."""
_UPRIGHT_ALONE = frozenset({r"\mathrm", r"\operatorname", r"\operatorname*", r"\mathit"})
_SIGNS_AROUND = frozenset({*scan._RELATIONS, *_RELATIONS, "+", "-", "_", "^", "/"})
_SIGNS_AROUND |= {r"\cdot", r"\times"}
_BEFORE_LAST = frozenset({"RELATION", "SIGN", "SIGNS", "SLASH", "DOT", "CROSS"})
_BEFORE = _BEFORE_LAST | {"", "NUMBER", "ALIGN", "LINE", "SPACE", "SEPARATOR", "ARROW", "WORDS"}
_BEFORE |= {"OPEN", "LIST", "OF", "COMMA"}
_ORDERS = frozenset({"O", "o", "𝒪", "Δ", "δ", "Γ"})
"""Letters whose brackets never hold a factor."""
_POTENTIALS = frozenset({"f", "F", "U", "V", "H", "ψ", "Ψ"})
"""Letters whose brackets may hold either: it is not guessed."""
_REFUSED = {
    **dict.fromkeys((r"\langle", r"\rangle"), "an average or a product in ⟨ ⟩"),
    **dict.fromkeys((r"\in", r"\notin", r"\subset", r"\subseteq", r"\cup", r"\cap"), "a set"),
    **dict.fromkeys((r"\forall", r"\exists", r"\mapsto", r"\colon"), "a map or a quantifier"),
    **dict.fromkeys((r"\lim", r"\limsup", r"\liminf"), "a limit"),
    **dict.fromkeys((r"\max", r"\min", r"\sup", r"\inf", r"\arg"), "an extremum"),
    **dict.fromkeys(
        (r"\otimes", r"\oplus", r"\wedge", r"\circ", r"\bullet"), "a product of a kind"
    ),
    **dict.fromkeys((r"\prod", r"\coprod", r"\binom"), "a product over an index, or a binomial"),
    **dict.fromkeys((r"\cancel", r"\bcancel", r"\xcancel", r"\cancelto"), "what is struck out"),
    **dict.fromkeys((r"\iint", r"\iiint", r"\oint"), "an integral of several dimensions"),
    **dict.fromkeys((r"\includegraphics", r"\xymatrix", r"\tikz"), "a picture"),
    "*": "a star: a product is written without one",
    "!": "a factorial",
    "?": "a question mark",
}
_DEGREES = "an angle in degrees: the reader knows radians"
_OVER = {r"\dot": 1, r"\ddot": 2}
_MARKS = {
    **dict.fromkeys((r"\bar", r"\overline"), "\u0304"),
    **dict.fromkeys((r"\tilde", r"\widetilde"), "\u0303"),
    r"\check": "\u030c",
    r"\breve": "\u0306",
    r"\mathring": "\u030a",
}
_BOLD = scan._BOLD | {r"\overrightarrow", r"\underline", r"\overrightharpoon", r"\mathbfit"}
_BOLD |= {r"\boldmath", r"\mathbold", r"\bfseries"}
_UPRIGHT = scan._UPRIGHT | {r"\textrm", r"\text", r"\textit", r"\mathtt", r"\mbox", r"\textsf"}
_STYLES = {r"\mathcal": "SCRIPT", r"\mathscr": "SCRIPT", r"\cal": "SCRIPT"}
_STYLES |= {r"\mathfrak": "FRAKTUR", r"\mathbb": "DOUBLE-STRUCK"}
_HATS = frozenset({r"\hat", r"\widehat"})
"""With a small hat a letter is a unit vector; a wide one is a matrix, or what an author makes."""
_DRESSES = _BOLD | scan._UPRIGHT | _HATS | frozenset(_MARKS) | frozenset(_OVER)
_LETTERS = {
    **scan._GREEK,
    r"\ell": "ℓ",
    r"\hbar": "ħ",
    r"\imath": "i",
    r"\jmath": "j",
    r"\infty": "∞",
    r"\varpi": "ϖ",
    **{r"\var" + name: letter for name, letter in GREEK.items() if name[0].isupper()},
    r"\varphi": "φ",
    r"\digamma": "Ϝ",
    "∞": "∞",
}
_SETS = frozenset("RNZCQ")
_FUNCTIONS = frozenset({r"\cot", r"\sec", r"\csc", r"\coth"})
_SPELLED = ("sin", "cos", "tan", "exp", "log")
ANGLES = frozenset("θφψϕϑαβγχϖ")
_INDEXES = frozenset("ijklμνcefgos") | frozenset("ABCDEFGHIJKLMOPQRSUVWXYZ")
"""Letters that above another may be its index; n, m, p, x are rather a power."""
CONDITIONS: frozenset[str] = frozenset(
    [
        "for",
        "if",
        "when",
        "whenever",
        "unless",
        "provided",
        "assuming",
        "as",
        "at",
        "per",
        "se",
        "quando",
        "für",
        "wenn",
        "falls",
        "bei",
        "pour",
        "quand",
        "si",
        "para",
        "cuando",
        "om",
        "når",
        "hvis",
        "since",
        "because",
    ]
) | {"当", "若", "如果", "因为"}
_UNIT = re.compile(
    r"\(?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A|eV|cal)|rad|deg|kg|min|h|hr|km|mi|yr|AU|sec)"
    r"(?:\^?\{?[-−]?\d\}?)?(?:[·/ ]?(?:[kmcMGμn]?(?:m|g|s|N|J|W|Hz|Pa|K|C|V|A)|rad|kg|min|h|hr)"
    r"(?:\^?\{?[-−]?\d\}?)?)*\)?"
)
_CASES = frozenset({"cases", "dcases", "rcases", "numcases", "cases*", "dcases*"})
_LINES = scan._LINES | {"empheq", "subequations", "multlined", "dmath", "gathered", "eqnarray*"}
_LINES |= {"equation", "equation*", "displaymath", "math", "IEEEeqnarray", "flalign*", "Aligned"}
_MATRICES = scan._MATRICES | {"smallmatrix", "pmatrix*", "bmatrix*", "matrix*"}
_BAR_SIGNS = frozenset({"|", r"\|", r"\vert", r"\Vert", r"\lvert", r"\rvert", r"\lVert", r"\rVert"})


def operator_at(items: Sequence[Piece], at: int) -> tuple[str, int]:
    r"""Whether a d or ∂ stands there, and in how many pieces: ``d``, ``\mathrm d``, ``{\rm d}``."""
    text = items[at].text if at < len(items) else ""
    if text == "d":
        return "d", 1
    if text == r"\partial":
        return "∂", 1
    if text in _UPRIGHT and at + 1 < len(items) and _plain(items[at + 1]) == "d":
        return "d", 2
    if text == "{}" and items[at].group and items[at].group[0].text in _UPRIGHT:
        return ("d", 1) if _plain(items[at]) == "d" else ("", 0)
    return "", 0


def _plain(piece: Piece) -> str:
    return scan._words((piece,))


def _said(items: Sequence[Piece]) -> str:
    """Words with the spaces between them, as far as places tell."""
    made, end = "", -1
    for piece in _flat(items):
        if piece.text in scan._NOTHING or piece.text in scan._TEXTS | scan._FONTS | {"$", "~"}:
            continue
        made += " " * (end >= 0 and piece.position > end)
        made += scan._LETTERS.get(piece.text, piece.text)
        end = piece.position + len(piece.text)
    return " ".join(made.split())


def words(text: str) -> str:
    """Words and mathematics as they are written, without TeX: "for θ = 0"."""
    try:
        return _said(scan.pieces(text)).strip(" .,;")
    except UnreadError:
        return " ".join(text.split())


def _flat(items: Sequence[Piece]) -> Iterator[Piece]:
    for piece in items:
        if piece.text != "{}":
            yield piece
        yield from _flat(piece.group)


class Own(Scan):
    """Goes through the pieces of a formula in anyone's letters.

    `functions` are the letters that are functions elsewhere in the file, each with a letter that
    it is a function of: V with x where V(x) stands; `timed` are those that depend on the time: x
    where x(t) stands.
    """

    def __init__(
        self,
        items: Sequence[Piece],
        notation: Notation,
        depth: int = 0,
        level: int = 0,
        functions: frozenset[tuple[Glyph, str]] = frozenset(),
        timed: frozenset[Glyph] = frozenset(),
        outer: Own | None = None,
    ) -> None:
        super().__init__(_infix(items, level), notation, depth, level)
        self.functions, self.timed = functions, timed
        self.pairs: dict[tuple[str, str], tuple[int, dict[int, int]]] = {}
        self.calls: set[int] = set()  # where brackets open that hold arguments
        self.ends: list[tuple[int, str]] = []  # how deep what closes otherwise than it looks
        self.last = ""
        top = outer if outer is not None else self
        if outer is None:
            flat = list(_flat(items))
            self.two_signs = any(piece.text in _SIGNS for piece in flat)
            self.integrals = any(piece.text == r"\int" for piece in flat)
            self.lonely_d = _lonely_d(items)
        else:
            self.two_signs, self.lonely_d = top.two_signs, top.lonely_d
            self.integrals = top.integrals

    def within(self, group: Sequence[Piece], depth: int) -> Own:
        return Own(group, self.notation, depth, self.level + 1, self.functions, self.timed, self)

    def tokens(self) -> Iterator[Token]:
        for token in super().tokens():
            self.last = token.kind
            yield token

    # What stands there

    def next(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        if text in _LEFT_OUT:
            self.take()
        elif text in _WITH_ONE:
            self.take()
            self.argument(piece)
        elif text == r"\left":
            yield from self.left()
        elif text in _RELATIONS:
            self.take()
            yield Token("RELATION", _RELATIONS[text], position)
        elif (text == ":" and self.peek(1).text == "=") or (
            text == "=" and self.peek(1).text == ":"
        ):
            self.at += 2
            yield Token("RELATION", "≡", position)
        elif text == ":" and not self.depth:
            self.take()
            yield Token("SEPARATOR", ":", position)
        elif text == r"\underline" and not self.is_letter(self.at):
            self.take()
        elif text in _ARROWS:
            self.take()
            yield Token("ARROW", text, position)
        elif text in _SIGNS:
            self.take()
            yield Token("SIGNS", _SIGNS[text], position)
        elif text in _OMITTED or [self.peek(i).text for i in range(3)] == [".", ".", "."]:
            self.at += 1 if text in _OMITTED else 3
            yield Token("SYMBOL", own(Glyph("…")), position)
        elif text in _REFUSED:
            raise UnreadError(f"{_REFUSED[text]}: that is not read", position)
        elif text == "^" and _plain(self.peek(1)) in (r"\circ", "°"):
            raise UnreadError(_DEGREES, position)
        elif text in _FUNCTIONS:
            self.take()
            yield from self.function(text[1:], position)
        elif text == r"\sqrt" and self.peek(1).text == "[":
            yield from self.root()
        elif text in (r"\dfrac", r"\cfrac", r"\tfrac", r"\frac", r"\nicefrac"):
            yield from self.fraction()
        elif text in _OVER and self.peek(1).text == "{}" and not self.is_letter(self.at):
            self.take()
            yield Token("RATE", _OVER[text], position)
            yield from self.braced(self.argument(piece), position)
        elif text in scan._TEXTS and self.peek(1).text == "{}" and self.are_words():
            yield from self.words()
        else:
            yield from super().next()

    def argument(self, of: Piece) -> tuple[Piece, ...]:
        r"""What a command takes, with what that takes in turn: ``x_\mathrm{cm}``."""
        self.skip()
        piece = self.peek()
        found = super().argument(of)
        takes = 2 if piece.text in (r"\frac", r"\tfrac", r"\dfrac") else 1
        if piece.text in _DRESSES | scan._TEXTS | frozenset(_STYLES) or takes == 2:
            found += tuple(self.take() for _ in range(takes) if self.peek().text)
        return found

    def is_letter(self, at: int) -> bool:
        """Whether what stands there is one letter, whatever it has above or at it."""
        inner = self.within(self.items[at : at + 2], 0)
        try:
            inner.letter()
        except UnreadError:
            return False
        return inner.at >= len(inner.items)

    def starts_letter(self, at: int) -> bool:
        """Whether a letter begins there."""
        text = self.items[at].text if at < len(self.items) else ""
        if text == "{}":
            return bool(self.items[at].group) and self.within(
                self.items[at].group, 0
            ).starts_letter(0)
        return text in _DRESSES or text in _LETTERS or text in _STYLES or _is_latin(text)

    # Brackets

    def left(self) -> Iterator[Token]:
        r"""``\left``, whose ``\right`` may be a full stop, or a bar with a place."""
        start = self.at
        found = self.closing(start, (r"\left", r"\right"))
        end = -1 if found is None else found
        opens = self.peek(1).text
        closes = self.items[end + 1].text if 0 < end + 1 < len(self.items) else ""
        if opens in ("<", r"\langle"):
            raise UnreadError(
                f"{_REFUSED[chr(92) + 'langle']}: that is not read", self.peek().position
            )
        inner = self.items[start + 2 : end]
        position = self.peek().position
        if end < 0 or (opens != "." and closes != "." and opens not in _BAR_SIGNS):
            self.take()
        elif opens == "." and closes in _BAR_SIGNS:
            self.at = end + 2
            yield Token("OPEN", "(", position)
            yield from self.inside(inner)
            yield Token("CLOSE", ")", position)
            yield from self.taken_at(position)
        elif opens in _BAR_SIGNS and closes in _BAR_SIGNS:
            self.at = end + 2
            yield Token("BAR", "|", position)
            yield from self.inside(inner)
            yield Token("RAB", "|", position)
        elif (opens in (".", r"\{") and closes == ".") or (opens == "." and closes == r"\}"):
            self.at = end + 2
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\right", position)
        else:
            raise UnreadError("a bracket on one side alone", position)

    def taken_at(self, position: int) -> Iterator[Token]:
        """The place at which something is taken, behind its bar."""
        if self.peek().text != "_":
            raise UnreadError("a bar without the place at which something is taken", position)
        piece = self.take()
        place = _said(self.argument(piece))
        if self.peek().text == "^":
            raise UnreadError("a value between two limits", position)
        yield Token("EVALUATED", place, piece.position)

    def bar(self) -> Token:
        ahead = self.peek(1)
        if ahead.text == "|" == self.peek().text and ahead.position == self.peek().position + 1:
            self.take()  # || is the size of a vector too
        elif ahead.text == "_" and not self.bars and self.peek().text in ("|", r"\vert"):
            piece = self.take()
            [token] = self.taken_at(piece.position)
            return token
        return super().bar()

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

    def commas(self, at: int) -> bool:
        """Whether commas stand in the bracket that opens there, outside of inner ones."""
        pair = {"(": ("(", ")"), "[": ("[", "]")}.get(self.items[at].text, (r"\{", r"\}"))
        end = self.closing(at, pair)
        depth = 0
        for piece in self.items[at:end] if end is not None else ():
            text = piece.text.lstrip("\\")
            depth += (text in ("(", "[", "{")) - (text in (")", "]", "}"))
            if depth == 1 and piece.text == ",":
                return True
        return False

    def is_row(self, at: int) -> bool:
        """Whether square brackets hold the components of a vector: three, or two in a column."""
        end = self.closing(at, ("[", "]"))
        if end is None:
            return False
        commas = sum(piece.text == "," for piece in self.items[at:end])
        behind = [piece.text for piece in self.items[end + 1 : end + 2]]
        above = "".join(map(_plain, self.items[end + 2 : end + 3]))
        raised = behind == ["^"] and above in scan._TRANSPOSED
        return raised or (commas == 2 and self.commas(at))

    def sign(self) -> Iterator[Token]:
        piece = self.peek()
        text, position = piece.text, piece.position
        row = text == "[" and self.is_row(self.at)
        if text in ("[", r"\{") and self.at not in self.calls and not row and self.commas(self.at):
            raise UnreadError(
                "brackets with a comma: an interval, a row, a commutator or a Poisson bracket?",
                position,
            )
        if self.at in self.calls or row or (text == "(" and self.commas(self.at)):
            kind = ("OF", "FO") if self.at in self.calls else ("LIST", "TSIL")
            self.take()
            self.depth += 1
            self.ends.append((self.depth, kind[1]))
            yield Token(kind[0], "(", position)
            return
        if text in (")", "]") and self.ends and self.ends[-1][0] == self.depth:
            self.take()
            self.depth -= 1
            yield Token(self.ends.pop()[1], ")", position)
            return
        yield from super().sign()
        if text == "]":
            yield from self.frame()

    def frame(self) -> Iterator[Token]:
        """An index behind brackets is a place, (…)_{x=0}, or the frame of a rate."""
        if self.peek().text == "_" and "=" in _plain(self.peek(1)):
            yield from self.taken_at(self.peek().position)
        elif self.peek().text == "_":
            yield from super().frame()

    def brace(self) -> Iterator[Token]:
        body = self.peek(1).group
        if body and body[0].text in ("+", "-") and self.last in ("SYMBOL", "CLOSE", "_END"):
            raise UnreadError(
                "a brace that begins with a sign: a term, or a factor?", self.peek().position
            )
        yield from super().brace()

    # Derivatives

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
        variables = [list(self.inside(part)) for part in by]
        yield from self.derivative(sign, body, variables, piece.position)

    def taken_of(self, position: int) -> None:
        """Refuse brackets behind a derivative that may say where it is taken."""
        at = self.at
        while at < len(self.items) and self.items[at].text in scan._NOTHING:
            at += 1
        if at >= len(self.items) or self.items[at].text != "(":
            return
        end = self.closing(at)
        inner = [] if end is None else self.items[at + 1 : end]
        inner = [piece for piece in inner if piece.text not in scan._NOTHING]
        place = _plain(Piece("{}", 0, tuple(inner))) == "0" or self.one_letter(inner)
        if [piece.text for piece in inner] == ["t"] and end is not None:
            self.at = end + 1
        elif place or "t" in _terms(inner):
            raise UnreadError(
                "a derivative at a place, or times what stands in brackets?", position
            )

    def derivative(
        self, sign: str, body: list[list[Token]], by: list[list[Token]], position: int
    ) -> Iterator[Token]:
        """The tokens of d^n…/dx^n, of a body that stands above the bar, or of none."""
        times = [len(part) == 1 and part[0].value == own(Glyph("t")) for part in by]
        if sign == "d" and all(times) and len(by) <= 2:
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
        if sign == "∂" and self.peek().text == "_":
            piece = self.take()
            by = self.argument(piece)
            if _plain(by[0] if len(by) == 1 else piece) in frozenset("ijklμν_"):
                raise UnreadError("∂ with an index: by what is it differentiated?", position)
            yield from self.derivative("∂", [], [list(self.inside(by))], position)
            return
        order = 1
        if self.peek().text == "^" and _plain(self.peek(1)).isdigit():
            order = int(_plain(self.peek(1))[:2])
            self.at += 2
        self.skip()
        apart = self.peek().position - self.items[start + count - 1].position
        if not self.starts_letter(self.at):
            upright = count > 1 or self.items[start].text == "{}"
            if sign == "d" and (upright or self.peek().text in ("(", "[")):
                raise UnreadError(
                    "d before more than a letter: a differential, or a factor?", position
                )
            self.at = start
            if sign == "∂":
                raise UnreadError("∂ without what it is to act on", position)
            yield from self.lettered()
            return
        glyph = self.letter()
        slash = self.at
        self.skip()
        if self.peek().text == "/":
            below, n = operator_at(self.items, self.at + 1)
            if below == sign:
                self.at += 1 + n
                if not self.starts_letter(self.at):
                    raise UnreadError("a derivative by what is no letter", position)
                by_glyph = self.letter()
                if order > 1:
                    raise UnreadError("a derivative of higher order on one line", position)
                body = [Token("SYMBOL", self.notation.symbol(glyph), position)]
                variable = [Token("SYMBOL", self.notation.symbol(by_glyph), position)]
                yield from self.derivative(sign, [body], [variable], position)
                return
        self.at = slash
        if sign == "∂":
            raise UnreadError("∂ without what it is differentiated by", position)
        plain = count == 1 and self.items[start].text == "d" and order == 1
        if plain and (self.lonely_d or (apart > 1 and not self.integrals)):
            raise UnreadError(r"d: a differential or a letter? write \mathrm{d}", position)
        raised = {1: "", 2: "²", 3: "³"}.get(order)
        if raised is None:
            raise UnreadError("a differential of higher order", position)
        glyph = replace(glyph, base=f"d{raised}{glyph.base}")
        yield Token("SYMBOL", self.notation.symbol(glyph), position)

    # Sums and integrals

    def limits(self) -> tuple[tuple[Piece, ...] | None, tuple[Piece, ...] | None]:
        """What stands below and above, in any order."""
        below = above = None
        self.skip()
        while self.peek().text in ("_", "^"):
            piece = self.take()
            found = self.argument(piece)
            if piece.text == "_":
                below = found
            else:
                above = found
            self.skip()
        return below, above

    def under(self) -> Iterator[Token]:
        position = self.peek().position
        below, above = self.limits()
        if above is not None and below is None:
            raise UnreadError("a sum with an end and no start", position)
        index, lower = below or (), None
        for i, piece in enumerate(index):
            if piece.text == "=" and above is not None:
                index, lower = index[:i], index[i + 1 :]
                break
        if above is not None and lower is None:
            raise UnreadError("a sum with an end and no start", position)
        said = _said(index)
        if below is not None and not said.strip("_ "):
            raise UnreadError("a sum whose index is no letter", position)
        yield Token("INDEX", said, position)
        for part in (lower, above):
            if part is not None:
                yield from self.braced(part, position)

    def integral(self) -> Iterator[Token]:
        piece = self.take()
        below, above = self.limits()
        if below is None and above is not None:
            raise UnreadError("an integral with an end and no start", piece.position)
        yield Token("INTEGRAL_OVER", "", piece.position)
        for part in (below, above):
            if part is not None:
                yield from self.braced(part, piece.position)

    def root(self) -> Iterator[Token]:
        piece = self.take()
        index = ""
        self.take()
        while self.peek().text not in ("]", ""):
            index += self.take().text
        self.take()
        if not re.fullmatch(r"[2-9]", index):
            raise UnreadError("a root whose index is no small number", piece.position)
        yield Token("ROOT", int(index), piece.position)
        yield from self.braced(self.argument(piece), piece.position)

    # Environments

    def environment(self) -> Iterator[Token]:
        name, end = self.named_environment()
        piece = self.peek()
        if name in _CASES or (
            name in ("array", "matrix") and self.last != "OPEN" and not self.depth
        ):
            self.at += 2
            inner = self.items[self.at : end]
            self.at = end + 2
            if name == "array" and inner and inner[0].text == "{}":
                inner = inner[1:]
            yield from self.system(name, inner, piece.position)
        elif name in _MATRICES or name == "array":
            self.at += 2
            inner = self.items[self.at : end]
            self.at = end + 2
            if name == "array" and inner and inner[0].text == "{}":
                inner = inner[1:]
            yield from self.rows(name, inner, piece.position)
        elif name in _LINES:
            self.at += 2
            inner = self.items[self.at : end]
            self.at = end + 2
            while inner and (
                inner[0].text == "[" or (inner[0].text == "{}" and name[:5] in _ARGUED)
            ):
                inner = inner[_behind(inner) :]
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", piece.position)
        elif name.endswith("vmatrix") or name == "Vmatrix":
            raise UnreadError("a determinant that is written out", piece.position)
        else:
            raise UnreadError(f"the environment {name}", piece.position)

    def named_environment(self) -> tuple[str, int]:
        r"""The name of the environment that begins here, and where its ``\end`` stands."""
        position = self.peek().position
        name = _plain(self.peek(1))
        depth = 0
        for i in range(self.at, len(self.items)):
            depth += {r"\begin": 1, r"\end": -1}.get(self.items[i].text, 0)
            if depth > scan.DEEPEST:
                raise UnreadError(f"nested deeper than {scan.DEEPEST}", position)
            if depth == 0:
                ends = _plain(self.items[i + 1]) if i + 1 < len(self.items) else ""
                if ends != name:
                    raise UnreadError(rf"\begin{{{name}}} that ends as {ends}", position)
                return name, i
        raise UnreadError(rf"\begin{{{name}}} without its \end", position)

    def system(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        """Equations below one another, or the values that one side has in several cases."""
        rows = [row for row in scan._split(inner, r"\\") if row]
        cells = [scan._split(row, "&") for row in rows]
        related = [any(p.text in _EQUAL for p in _flat(row[0])) for row in cells if row]
        aligned = [len(row) > 1 and any(p.text in _EQUAL for p in row[1][:1]) for row in cells]
        if name not in _CASES or (self.last != "RELATION" and any(related + aligned)):
            yield from self.inside(inner, nested=False)
            yield Token("SPACE", r"\end", position)
            return
        branches = []
        for row in cells:
            value = [t for t in self.inside(row[0]) if t.kind not in ("ALIGN", "SPACE")]
            while value and value[-1].kind in ("COMMA", "SEPARATOR"):
                value.pop()
            condition = " ".join(filter(None, map(_said, row[1:])))
            branches.append((tuple(value), condition))
        if not branches:
            raise UnreadError("cases without any", position)
        yield Token("BRANCHES", tuple(branches), position)

    def rows(self, name: str, inner: Sequence[Piece], position: int) -> Iterator[Token]:
        yield Token("MATRIX", name, position)
        for i, row in enumerate(scan._split(inner, r"\\")):
            if i:
                yield Token("LINE", r"\\", position)
            for j, cell in enumerate(scan._split(row, "&")):
                if j:
                    yield Token("COMMA", "&", position)
                yield from self.inside(cell)
        yield Token("XIRTAM", name, position)

    # Words

    def are_words(self) -> bool:
        return _plain(self.peek(1)) != "d" and not (
            self.peek().text in scan._UPRIGHT and len(_plain(self.peek(1))) < 2
        )

    def words(self) -> Iterator[Token]:
        piece = self.take()
        inner = self.argument(piece)
        said = _said(inner)
        plain = said.strip(" .,;:")
        if not plain:
            yield Token("SEPARATOR" if said and not self.depth else "SPACE", said, piece.position)
        elif plain.lower() in scan._CONSTANT:
            yield Token("CONSTANT", "const", piece.position)
        elif plain in scan._WORDS - {"K", "F"}:
            yield from self.function({"ln": "log", "Tr": "tr"}.get(plain, plain), piece.position)
        elif re.fullmatch(r"\(\d+(?:\.\d+)*[a-z]?\)", plain):
            yield Token("TAG", plain.strip("()"), piece.position)
        elif any(p.text == "$" for p in _flat(inner)) or scan._mathematical(inner):
            if plain.split()[0].lower() in CONDITIONS and not self.depth:
                yield Token("WORDS", plain, piece.position)
                return
            raise UnreadError("mathematics in words inside a formula", piece.position)
        elif _UNIT.fullmatch(plain) and self.last in ("NUMBER", "_END", "CLOSE"):
            base = plain if len(plain) > 1 else f" {plain}"  # metres are no masses
            yield Token("SYMBOL", self.notation.symbol(Glyph(base)), piece.position)
        elif self.is_quantity(plain):
            yield Token("SYMBOL", self.notation.symbol(self.scripts(Glyph(plain))), piece.position)
        elif piece.text in _UPRIGHT_ALONE and plain.isalnum():
            raise UnreadError(f"the function {plain} is not known", piece.position)
        elif self.depth:
            raise UnreadError(f"words inside a formula: {plain[:40]!r}", piece.position)
        else:
            yield Token("WORDS", plain, piece.position)

    def is_quantity(self, said: str) -> bool:
        """Whether words stand where a quantity would: with nothing but signs around them."""
        if len(said) > 40 or said.split()[0].lower() in CONDITIONS | _CONNECTIVES:
            return False
        self.skip()
        behind = self.peek().text
        ends = {"", ")", "]", r"\right"} if self.depth or self.last in _BEFORE_LAST else set()
        follows = behind in _SIGNS_AROUND | ends
        aligned = behind == "&" and self.peek(1).text in _SIGNS_AROUND
        return self.last in _BEFORE and (follows or aligned)

    def function(self, name: str, position: int) -> Iterator[Token]:
        at = self.at
        if at < len(self.items) and self.items[at].text == "^":
            at += 2
        while at < len(self.items) and self.items[at].text in scan._NOTHING:
            at += 1
        if [p.text for p in self.items[at : at + 4 : 2]] == ["[", "]"] and (
            _plain(self.items[at + 1]).isdigit() and at + 3 < len(self.items)
        ):
            power = Piece("^", self.items[at].position)  # \cos[2](x) of the package physics
            self.items[at : at + 3] = [power, self.items[at + 1]]
        elif at < len(self.items) and self.items[at].text == "[":
            end = self.closing(at, ("[", "]"))
            if end is not None:
                for i, text in ((at, "("), (end, ")")):
                    self.items[i] = replace(self.items[i], text=text)
        yield from super().function(name, position)

    def power(self) -> Iterator[Token]:
        position, letter = self.peek().position, self.last == "SYMBOL"
        if letter and _plain(self.peek(1)) in ("0", "1"):
            raise UnreadError("0 or 1 above a letter: an index, or a power?", position)
        function = self.last == "FUNCTION"
        yield from super().power()
        at = self.at
        while at < len(self.items) and self.items[at].text in scan._NOTHING:
            at += 1
        if function or at >= len(self.items) or self.items[at].text != "(":
            return
        end = self.closing(at)
        inner = [] if end is None else self.items[at + 1 : end]
        inner = [piece for piece in inner if piece.text not in scan._NOTHING]
        if [piece.text for piece in inner] == ["t"] and end is not None:
            self.at = end + 1  # ω²(t): that it depends on the time is left out
        elif letter and (self.commas(at) or self.one_letter(inner)):
            raise UnreadError("a power, and then what it is a function of?", position)

    # Letters

    def group(self) -> Iterator[Token]:
        sign, count = operator_at(self.items, self.at)
        if sign:
            yield from self.operator(sign, count)
            return
        if self.peek().group and self.within([self.peek()], 0).one_letter([self.peek()]):
            yield from self.lettered()
            return
        first = self.peek().group[0].text if self.peek().group else ""
        if first in _UPRIGHT and len(_plain(self.peek())) > 1:
            inner = self.take().group
            self.items[self.at : self.at] = [inner[0], Piece("{}", inner[0].position, inner[1:])]
            yield from self.words()
            return
        yield from super().group()

    def symbol(self) -> Iterator[Token]:
        position = self.peek().position
        sign, count = operator_at(self.items, self.at)
        if sign:
            yield from self.operator(sign, count)
            return
        word = self.spelled()
        if word in _SPELLED:
            self.at += len(word)
            yield from self.function(word, position)
            return
        if word in ("Re", "Im"):
            raise UnreadError("a real or imaginary part: that is not read", position)
        if word:
            raise UnreadError(
                f"{word}: a word or a product? put words in \\text{{}}, spaces between letters",
                position,
            )
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
        bracketed = self.peek(len(run)).text in ("(", "[", r"\left", r"\{")
        if run in ("Re", "Im") and bracketed:
            return run
        before = self.items[self.at - 1] if self.at else Piece("", -9)
        joined = _is_latin(before.text) and before.position + 1 == self.peek().position
        cut = min((run.find(name) for name in _SPELLED if name in run), default=len(run))
        twice = cut == 3 and any(a == b for a, b in pairwise(run[:cut]))
        return run if (twice or cut >= 4) and not joined and not _is_product(run[:cut]) else ""

    def lettered(self) -> Iterator[Token]:
        """A letter, with the brackets behind it if it is a function of what they hold."""
        position = self.peek().position
        before = self.last
        pair = self.peek().text + self.peek(1).text
        if pair in ("KE", "PE") and self.peek(1).position == position + 1:
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
        if change and self.starts_letter(self.at) and not operator_at(self.items, self.at)[0]:
            of = self.letter()
            glyph = replace(of, base=glyph.base + of.base)
        if glyph == Glyph("π"):
            if [self.peek(i).text for i in range(3)] == ["(", "t", ")"]:
                raise UnreadError("π of the time: another letter than the number", position)
            yield Token("SYMBOL", sympy.pi, position)
            return
        several = glyph.sub.split(",")
        if self.two_signs and 1 < len(several) == 2 and all(part.isdigit() for part in several):
            made = tuple(self.notation.symbol(replace(glyph, sub=sub)) for sub in several)
            yield Token("CHOICE", made, position)
            return
        if glyph == Glyph("D") and self.starts_letter(self.at):
            raise UnreadError("D before a letter: a derivative, or a factor?", position)
        self.arguments(glyph)
        self.functional()
        yield Token("SYMBOL", self.notation.symbol(glyph), position)

    def arguments(self, glyph: Glyph) -> None:
        """Decide whether brackets behind a letter hold what it is a function of.

        That it depends on time, x(t), is left out.
        """
        at = self.at
        while at < len(self.items) and self.items[at].text in scan._NOTHING - {" ", r"\,"}:
            at += 1
        if at < len(self.items) and self.items[at].text == "{}":
            inside = [p for p in self.items[at].group if p.text not in scan._NOTHING]
            if len(inside) > 2 and (inside[0].text, inside[-1].text) == ("(", ")"):
                self.items[at : at + 1] = inside  # R{(θ)}
        if at >= len(self.items) or self.items[at].text != "(":
            return
        end = self.closing(at)
        if end is None:
            return
        inner = [piece for piece in self.items[at + 1 : end] if piece.text not in scan._NOTHING]
        said = _plain(Piece("{}", 0, tuple(inner)))
        place = self.items[at].position
        if said == "t":
            if self.called is not None and glyph.base not in _TIMELY:
                raise UnreadError(
                    "of the time, or times t? leave (t) out, or t without brackets", place
                )
            if any(known == glyph for known, _ in self.functions):
                self.calls.add(at)
            else:
                self.at = end + 1
        elif said.startswith("t="):
            del self.items[at + 1 : at + 3]
            self.calls.add(at)
        elif (
            said == "0"
            or self.one_letter(inner)
            or self.commas(at)
            or _listed(inner)
            or glyph.base in _ORDERS
            or any((glyph, term) in self.functions for term in _terms(inner))
        ):
            self.calls.add(at)
        elif any(known == glyph for known, _ in self.functions):
            raise UnreadError(f"{spelling(glyph)} of what stands in brackets, or times it?", place)
        elif glyph in self.timed and any(piece.text == "t" for piece in inner):
            raise UnreadError(f"{spelling(glyph)} at the time in brackets, or times it?", place)
        elif glyph.base in _POTENTIALS or said.replace(".", "").isdigit():
            raise UnreadError(f"{spelling(glyph)} of what stands in brackets, or times it?", place)

    def functional(self) -> None:
        """Decide whether square brackets behind a letter hold what it is a functional of, S[q]."""
        at = self.at
        while at < len(self.items) and self.items[at].text in scan._NOTHING - {" ", r"\,"}:
            at += 1
        if at >= len(self.items) or self.items[at].text != "[":
            return
        end = self.closing(at, ("[", "]"))
        if end is None:
            return
        inner = [piece for piece in self.items[at + 1 : end] if piece.text not in scan._NOTHING]
        texts = [piece.text for piece in inner]
        bracket = texts.index("(") if "(" in texts else len(inner)
        alone = self.one_letter(inner[:bracket]) and texts[-1:] in ([")"], texts[bracket - 1 :])
        if self.commas(at) or alone:
            self.calls.add(at)

    def one_letter(self, inner: Sequence[Piece]) -> bool:
        found = self.within(inner, 0)
        try:
            found.letter()
        except UnreadError:
            return False
        return bool(inner) and found.at >= len(inner)

    def letter(self) -> Glyph:
        dresses: list[Piece] = []
        while self.peek().text in _DRESSES:
            dresses.append(self.take())
            self.skip()
        piece = self.take()
        text = piece.text
        if text in _STYLES:
            glyph = Glyph(
                _styled(_plain(Piece("{}", 0, self.argument(piece))), text, piece.position)
            )
        elif text == "{}":
            glyph = self.dressed(piece, dresses)
        elif text == r"\nabla":
            glyph = Glyph("∇", bold=True)
        elif text in _LETTERS:
            glyph = Glyph(_LETTERS[text])
        elif _is_latin(text):
            glyph = Glyph(text)
        elif text in ("0", "1") and any(dress.text in _BOLD for dress in dresses):
            glyph = Glyph(text, bold=True)
        elif text in scan._TEXTS and self.peek().text == "{}":
            glyph = Glyph(_said(self.argument(piece)))
        elif text.startswith("\\") and text not in scan._NOT_READ and len(text) > 1:
            known = "of TeX" if text[1:].isalpha() else "here"
            raise UnreadError(f"the command {text} is not known {known}", piece.position)
        elif len(text) == 1 and text.isalpha():
            raise UnreadError(f"words inside a formula: {text!r}", piece.position)
        else:
            raise UnreadError(scan._instead_of_a_symbol(text), piece.position)
        for dress in reversed(dresses):
            glyph = _dressed(glyph, dress)
        return self.scripts(glyph)

    def dressed(self, piece: Piece, dresses: Sequence[Piece]) -> Glyph:
        """The letter in braces; several beneath one arrow, or upright, are one letter."""
        worn = {dress.text for dress in dresses}
        said = _plain(piece)
        whole = worn & ({r"\vec", r"\overrightarrow", r"\overline"} | scan._UPRIGHT)
        if whole and len(said) > 1 and said.isascii() and said.isalnum():
            return Glyph(said)
        if said in ("0", "1") and worn & _BOLD:
            return Glyph(said, bold=True)
        if not piece.group:
            raise UnreadError("an empty group", piece.position)
        inner = self.within(piece.group, self.depth)
        glyph = inner.letter()
        inner.skip()
        if inner.at < len(piece.group):
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
                sub = _said(self.argument(piece)).replace("-", "−")
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
        said = _plain(above)
        if said and set(said) == {"′"}:
            for _ in said:
                glyph = _primed(glyph)
            return glyph
        if said in ("*", r"\ast", r"\star", r"\dagger", "+", "-"):
            return replace(
                glyph, base=glyph.base + {"-": "⁻", "+": "⁺", r"\dagger": "†"}.get(said, "*")
            )
        first = above.group[0].text if above.group else above.text
        bracketed = re.fullmatch(r"\(\w{1,4}\)", said)
        worded = first in scan._TEXTS | scan._UPRIGHT and len(said) > 1 and len(above.group) == 2
        if bracketed or worded:
            return replace(glyph, sub=",".join(filter(None, (glyph.sub, f"({said.strip('()')})"))))
        if said in _INDEXES and not glyph.bold:
            raise UnreadError(f"{said} above a letter: an index, or a power?", above.position)
        return None


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
            made.add(_LETTERS.get(_plain(bare[0]), _plain(bare[0])))
    return made


_ARGUED = frozenset({"aligne", "align", "alignat"[:5], "IEEEe", "empheq"[:5], "eqnar"[:0]}) - {""}
_EQUAL = frozenset(scan._RELATIONS) | frozenset(_RELATIONS)
_TIMELY = frozenset("xyzrqθφψϕsuvω")
_CONNECTIVES = frozenset(
    [
        "and",
        "or",
        "where",
        "with",
        "so",
        "then",
        "thus",
        "hence",
        "but",
        "is",
        "are",
        "from",
        "by",
        "to",
        "let",
        "we",
        "that",
        "which",
        "e",
        "ed",
        "ou",
        "et",
        "oder",
        "und",
        "wobei",
        "dove",
        "con",
        "med",
        "og",
        "y",
        "con",
        "avec",
        "où",
        "soit",
        "i.e.",
        "e.g.",
        "otherwise",
        "therefore",
        "now",
    ]
)


def _is_latin(text: str) -> bool:
    """Whether it is a letter that formulas have."""
    return len(text) == 1 and text.isalpha() and (text.isascii() or text in _ALPHABET)


_ALPHABET = frozenset("αβγδεζηθικλμνξοπρσςτυφχψωΑΒΓΔΕΖΗΘΙΚΛΜΝΞΟΠΡΣΤΥΦΧΨΩϕϑϖϵℓℒħℋ")


def _is_product(run: str) -> bool:
    """Whether a row of letters is rather a product, such as mgRh: no vowels in it."""
    return not set(run.lower()) & set("aeiouy")


def _lonely_d(items: Sequence[Piece]) -> bool:
    """Whether a d stands alone: a letter, a distance say."""
    for i, piece in enumerate(items):
        if piece.text == "{}":
            if [p.text for p in piece.group][:1] == ["d"] and (
                len(piece.group) == 1 or piece.group[1].text == "^"
            ):
                continue  # over the bar of a derivative
            if _lonely_d(piece.group):
                return True
        if piece.text != "d" or (i and items[i - 1].text in _UPRIGHT | {"_", "^"}):
            continue
        behind = items[i + 1].text if i + 1 < len(items) else ""
        if behind in {*_EQUAL, "+", "-", ")", "", "_", "/", ",", r"\cdot"} and not (
            i and items[i - 1].text == r"\frac"
        ):
            return True
    return False


def _behind(inner: Sequence[Piece]) -> int:
    """Behind an argument in braces or square brackets."""
    if inner[0].text == "{}":
        return 1
    return next((i + 1 for i, piece in enumerate(inner) if piece.text == "]"), 1)


def _operator(
    over: Sequence[Piece], below: Sequence[Piece], position: int
) -> tuple[str, Sequence[Piece], list[Sequence[Piece]]] | None:
    """What is differentiated and by what, of a fraction that is a derivative."""
    over, below = ([p for p in part if p.text not in scan._NOTHING] for part in (over, below))
    sign, count = operator_at(over, 0)
    if not sign:
        return None
    order = 1
    if count < len(over) - 1 and over[count].text == "^":
        if not _plain(over[count + 1]).isdigit():
            return None
        order, count = int(_plain(over[count + 1])[:2]), count + 2
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
        if len(variable) > 2 and variable[-2].text == "^" and _plain(variable[-1]).isdigit():
            times, variable = int(_plain(variable[-1])[:1]), variable[:-2]
        if not variable or variable[0].text in ("_", "^", "'", "+", "-"):
            return None
        by += [variable] * times
    if not by:
        return None
    if len(by) != order or order > 4:
        raise UnreadError("a derivative whose orders above and below differ", position)
    return sign, over[count:], by


def _styled(said: str, style: str, position: int) -> str:
    if len(said) != 1:
        raise UnreadError("no single symbol in braces", position)
    if style == r"\mathbb" and said in _SETS:
        raise UnreadError("a set: that is not read", position)
    case = "CAPITAL" if said.isupper() else "SMALL"
    kind = _STYLES[style]
    for name in (f"MATHEMATICAL {kind} {case} {said.upper()}", f"{kind} {case} {said.upper()}"):
        try:
            return unicodedata.lookup(name)
        except KeyError:
            continue
    return said


def _primed(glyph: Glyph) -> Glyph:
    return replace(glyph, base=glyph.base + "′") if glyph.prime else replace(glyph, prime=True)


def _dressed(glyph: Glyph, dress: Piece) -> Glyph:
    if dress.text in _BOLD:
        return replace(glyph, bold=True)
    if dress.text in _MARKS:
        return replace(glyph, base=glyph.base + _MARKS[dress.text])
    if dress.text in scan._UPRIGHT:
        return glyph
    accent = "hat" if dress.text in _HATS else {1: "dot", 2: "ddot"}[_OVER[dress.text]]
    if glyph.accent == "hat" and accent != "hat":
        glyph = replace(glyph, base=glyph.base[0] + "\u0302" + glyph.base[1:], accent="")
    if glyph.accent:
        raise UnreadError("an accent above an accent", dress.position)
    return replace(glyph, accent=accent, bold=glyph.bold or dress.text == r"\hat")
