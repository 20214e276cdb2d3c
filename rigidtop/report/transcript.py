r"""A formula as it is written, sign by sign, as MathML: nothing of it need be understood.

What is set here is set from TeX alone, with the author's macros put in.  A command or a character
that is not known makes the whole formula one that is not set.

>>> transcript(r"\theta", {})
'<math xmlns="http://www.w3.org/1998/Math/MathML" alttext="\\theta"><mi>θ</mi></math>'
>>> transcript(r"\strange{x}", {})
''
"""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Callable, Mapping, Sequence
from html import escape

from rigidtop.notation.characters import FUNCTIONS, MATHS
from rigidtop.read.macros import Macros, expanded
from rigidtop.read.tex import (
    BOLD,
    DEEPEST,
    GREEKS,
    NOTHING,
    TEXTS,
    UPRIGHT,
    Piece,
    UnreadError,
    commands,
    listed,
    pieces,
    plain,
    said,
    split,
)
from rigidtop.typeset import mathml

_SIGNS = {tex: sign for sign, tex in MATHS.items() if tex[0] == "\\" and tex[1:].isalpha()}
_SIGNS |= {rf"\{sign}": sign for sign in "{}%&$#"}
_SIGNS |= {r"\le": "≤", r"\ge": "≥", r"\ne": "≠", r"\leqslant": "≤", r"\geqslant": "≥"}
_SIGNS |= {
    r"\perp": "⊥",
    r"\rightarrow": "→",
    r"\longrightarrow": "⟶",
    r"\implies": "⟹",
    r"\iff": "⟺",
}
_SIGNS |= {r"\dots": "…", r"\cdots": "⋯", r"\vdots": "⋮", r"\ddots": "⋱", r"\colon": ":"}
_SIGNS |= {r"\lvert": "|", r"\rvert": "|", r"\vert": "|", r"\lVert": "‖", r"\rVert": "‖"}
_SIGNS |= {r"\|": "‖", r"\lbrace": "{", r"\rbrace": "}", r"\sum": "∑", r"\prod": "∏"}
_SIGNS |= {r"\oint": "∮", r"\iint": "∬", r"\iiint": "∭", r"\otimes": "⊗", r"\oplus": "⊕"}
_SIGNS |= {r"\ast": "∗", r"\star": "⋆", r"\bullet": "∙", r"\cap": "∩", r"\cup": "∪", r"\bot": "⊥"}
_SIGNS |= {r"\perp": "⊥"}
_SIGNS |= {r"\subset": "⊂", r"\propto": "∝", r"\doteq": "≐", r"\triangleq": "≜", r"\odot": "⊙"}
_SIGNS |= {sign: sign for sign in "=+/<>|,;:!?.()[]"} | {"-": "−", "*": "∗"}
_LETTERS = {**GREEKS, r"\ell": "ℓ", r"\hbar": "ℏ", r"\infty": "∞", r"\partial": "∂"}
_LETTERS |= {r"\nabla": "∇", r"\Re": "ℜ", r"\Im": "ℑ", r"\imath": "ı", r"\jmath": "ȷ"}
_LETTERS |= {r"\phi": "ϕ", r"\varphi": "φ", r"\vartheta": "ϑ", r"\epsilon": "ϵ"}
_LETTERS |= {r"\emptyset": "∅", r"\dagger": "†", r"\circ": "∘", r"\prime": "′", r"\degree": "°"}
_NAMES = {*FUNCTIONS, *listed("lim max min sup inf arg deg sec csc cot coth sgn ker dim Tr diag")}
_SPREAD = frozenset("∑∏∫∮∬∭")
_OPENS = frozenset("([{|‖⟨")
_BRACKETS = _OPENS | frozenset(")]}⟩")
_PRIMES = {"′′": "″", "′′′": "‴"}
_SPACES = {r"\quad": "1em", r"\qquad": "2em", r"\enspace": "0.5em"}
_DOTTED = '<mo scriptlevel="0">{}</mo>'
_ACCENTS = {
    r"\dot": _DOTTED.format("˙"),
    r"\ddot": _DOTTED.format("¨"),
    r"\dddot": _DOTTED.format("⃛"),
    r"\hat": '<mo stretchy="false">^</mo>',
    r"\widehat": '<mo stretchy="true">^</mo>',
    r"\tilde": '<mo stretchy="false">~</mo>',
    r"\widetilde": '<mo stretchy="true">~</mo>',
    r"\bar": '<mo stretchy="false">¯</mo>',
    r"\overline": '<mo stretchy="true">¯</mo>',
    r"\vec": '<mo stretchy="false">→</mo>',
    r"\overrightarrow": '<mo stretchy="true">→</mo>',
    r"\overbrace": '<mo stretchy="true">⏞</mo>',
}
_BELOW = {r"\underbrace": "⏟", r"\underline": "_"}
_WORDS = commands("text mbox hbox textrm textit textnormal")
_FRACTIONS = commands("frac dfrac tfrac cfrac")
_CHEMICAL = re.compile(
    r"(?P<base>[A-Z][a-z]?|[)\]])_?(?P<below>\d*)(?:\^\{?(?P<above>\d*[+-])\}?)?"
    r"|(?P<beside>[(\[]|\d+)|(?P<sign><=>|->|<-|[+=])|(?P<other>.)"
)
"""A part of a chemical formula with what stands below and above it."""
_STYLES = {r"\mathcal": "SCRIPT", r"\mathscr": "SCRIPT", r"\mathbb": "DOUBLE-STRUCK"}
_STYLES |= {r"\mathfrak": "FRAKTUR"}
_DROPPED = commands("label vspace hspace phantom vphantom hphantom")
_BARE = NOTHING | commands("nonumber notag mathstrut strut relax scriptstyle hfill boldmath")
_FENCES = {"pmatrix": "()", "bmatrix": "[]", "Bmatrix": "{}", "vmatrix": "||", "Vmatrix": "‖‖"}
_FENCES |= {"cases": "{ ", "dcases": "{ ", "rcases": " }"}
_CENTRED = frozenset({*_FENCES, "matrix", "smallmatrix", "array"}) - {"cases", "dcases", "rcases"}
_WITH_ARGUMENT = frozenset({"array", "alignat", "alignat*", "alignedat", "xalignat", "xalignat*"})


def transcript(text: str, macros: Macros, display: bool = False, alt: str = "") -> str:
    """The ``<math>`` element of a formula; "" where something of it is not known here.

    `alt` says it in words, by default its TeX.
    """
    try:
        items = expanded(pieces(text), macros)
        inside = _Transcript(items).table()
    except UnreadError:
        return ""
    return mathml.element(inside, alt or " ".join(text.split()), display) if items else ""


class _Transcript:
    """Goes through pieces; `bold` says that letters are, `deep` what they stand in."""

    def __init__(self, items: Sequence[Piece], bold: bool = False, deep: int = 0) -> None:
        self.items, self.at, self.bold, self.deep = items, 0, bold, deep
        self.closings = _closings(items)
        self.limit()

    def limit(self) -> None:
        if self.deep > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", 0)

    def within(self, items: Sequence[Piece], bold: bool = False) -> _Transcript:
        return _Transcript(items, bold or self.bold, self.deep + 1)

    # --- What is next -----------------------------------------------------------------------------

    def peek(self) -> str:
        return self.items[self.at].text if self.at < len(self.items) else ""

    def next(self) -> Piece:
        if self.at >= len(self.items):
            raise UnreadError("the formula ends too early", 0)
        self.at += 1
        return self.items[self.at - 1]

    def inner(self, items: Sequence[Piece], bold: bool = False) -> str:
        return _one(self.within(items, bold).parts())

    def argument(self, bold: bool = False) -> str:
        """What a command takes: a group, a command with its own, or a sign."""
        if self.peek() == "{}":
            return self.inner(self.next().group, bold)
        if self.peek().isdigit():
            return f"<mn>{self.next().text}</mn>"  # of x^12 the 1 alone
        was, self.bold, self.deep = self.bold, bold or self.bold, self.deep + 1
        self.limit()
        atom = self.atom()
        self.bold, self.deep = was, self.deep - 1
        return atom

    def group(self) -> tuple[Piece, ...]:
        piece = self.next()
        return piece.group if piece.text == "{}" else (piece,)

    # --- Rows -------------------------------------------------------------------------------------

    def table(self, centred: bool = False) -> str:
        """Lines and their cells, if there are several."""
        lines = [split(line, "&") for line in split(self.items, r"\\")]
        if len(lines) == 1 and len(lines[0]) == 1:
            return _one(self.parts())
        rows = ""
        for cells in lines:
            sides = ["center" if centred else ("left" if k % 2 else "right") for k in range(99)]
            if len(cells) == 1 and not centred:
                sides[0] = "left"
            rows += "<mtr>"
            for side, cell in zip(sides, cells, strict=False):
                # An empty letter in front makes a sign at the beginning one between two sides.
                begins = "<mi></mi>" if side == "left" else ""
                cell_signs = begins + "".join(self.within(cell).parts())
                rows += f'<mtd style="text-align:{side};padding:0.2em">{_row(cell_signs)}</mtd>'
            rows += "</mtr>"
        return f'<mtable displaystyle="{str(not centred).lower()}">{rows}</mtable>'

    def parts(self) -> list[str]:
        """All that is left, atom by atom."""
        pieces: list[str] = []
        while self.at < len(self.items):
            begun = self.items[self.at].text
            first = not pieces or _is_sign(pieces[-1])
            part = self.scripted(first)
            if begun in _WORDS or (_name(begun) and not first):
                pieces.append(mathml.THIN)
            if part:
                pieces.append(part)
            if _name(begun) and self.peek():
                pieces.append(mathml.APPLY)
            if begun in _WORDS or (_name(begun) and self.peek() not in ("", "(", r"\left", "{}")):
                pieces.append(mathml.THIN)
        # A word has space beside what stands there.
        return pieces[pieces[:1] == [mathml.THIN] : len(pieces) - (pieces[-1:] == [mathml.THIN])]

    # --- Atoms ------------------------------------------------------------------------------------

    def scripted(self, first: bool) -> str:
        """An atom with its index, its exponent and its primes."""
        begun = self.peek()
        base = "<mi></mi>" if begun in ("^", "_") else self.atom(first)
        below, above, primes = "", "", ""
        while self.peek() in ("^", "_", "'"):
            mark = self.next().text
            if mark == "'":
                primes += "′"
            elif (above if mark == "^" else below) or not base:
                raise UnreadError("two exponents, or two indices", 0)
            elif mark == "^":
                above = self.argument()
            else:
                below = self.argument()
        if primes and above:
            above = _row(f"<mo>{primes}</mo>{above}")
        elif primes:
            base = f"<msub>{base}{below}</msub>" if below else base
            return mathml.primed(base, _PRIMES.get(primes, primes))
        base = mathml.beside_accent(base) if above else base
        spread = _SIGNS.get(begun) in _SPREAD or begun in (r"\lim", r"\underbrace", r"\overbrace")
        under, over = ("munder", "mover") if spread else ("msub", "msup")
        if below and above:
            both = "munderover" if spread else "msubsup"
            return f"<{both}>{base}{below}{above}</{both}>"
        if below:
            return f"<{under}>{base}{below}</{under}>"
        return f"<{over}>{base}{above}</{over}>" if above else base

    def atom(self, first: bool = False) -> str:
        """One sign, letter, number, bracket or command with what it takes; "" for what says none.

        A minus at the `first` place stands before what follows and not between two terms.
        """
        piece = self.next()
        text = piece.text
        if text == "{}":
            return self.inner(piece.group)
        if self.at - 1 in self.closings:
            return self.bracketed()
        if text.isdigit():
            while self.peek().isdigit() or (self.peek() == "." and self._digit_follows()):
                text += self.next().text
            return f"<mn>{text}</mn>"
        if len(text) == 1 and text.isalpha() and unicodedata.category(text) != "Lm":
            return self.letter(text)
        if text in _LETTERS:
            return self.letter(_LETTERS[text])
        if _name(text):
            return f"<mi>{text[1:]}</mi>"
        for kind, element in self.takes.items():
            if text in kind:
                return element(self, text)
        if text in _SIGNS:
            return _sign(_SIGNS[text], first)
        if text in _BARE:
            return ""
        raise UnreadError(f"{text} is not known", piece.position)

    def _digit_follows(self) -> bool:
        return self.at + 1 < len(self.items) and self.items[self.at + 1].text.isdigit()

    def bracketed(self) -> str:
        """The MathML from a bracket to the one that closes it; an exponent raises it as one."""
        begun = self.at - 1
        self.at = self.closings[begun] + 1
        shape = "".join(_SIGNS[self.items[k].text] for k in (begun, self.at - 1))
        inside = self.within(self.items[begun + 1 : self.at - 1]).parts()
        return mathml.fenced("".join(inside), shape, tall=False)

    def letter(self, character: str) -> str:
        greek = ord(character) > 0x370
        style = ' mathvariant="normal"' * (character.isupper() and greek)
        if self.bold:
            upright = ' mathvariant="normal"' * (character.isupper() or not greek)
            style = f'{upright} style="font-weight:bold"'
        return f"<mi{style}>{escape(character)}</mi>"

    def fence(self, _: str) -> str:
        """The MathML from \\left to its \\right, with brackets as high as what is inside."""
        opens, depth, begun = self.bracket(), 1, self.at
        while depth:
            depth += {r"\left": 1, r"\right": -1}.get(self.next().text, 0)
        inside = self.items[begun : self.at - 1]
        return _row(opens + self.inner(inside) + self.bracket())

    def bracket(self) -> str:
        piece = self.next().text
        sign = _SIGNS.get(piece)
        if piece == ".":
            return ""
        if sign is None:
            raise UnreadError(f"{piece} is no bracket", 0)
        return f'<mo stretchy="true">{escape(sign)}</mo>'

    # --- Commands ---------------------------------------------------------------------------------

    def fraction(self, _: str) -> str:
        return f"<mfrac>{self.argument()}{self.argument()}</mfrac>"

    def chosen(self, _: str) -> str:
        over, under = self.argument(), self.argument()
        return mathml.fenced(f'<mfrac linethickness="0">{over}{under}</mfrac>', "()", tall=True)

    def formula(self, _: str) -> str:
        """A chemical formula: letters upright, a number behind one below it, charges above."""
        row = ""
        for part in _CHEMICAL.finditer(_as_typed(self.group())):
            if part["other"]:
                raise UnreadError(f"{part['other']} is not known in a chemical formula", 0)
            if part["sign"] or part["beside"]:
                sign, tag = part["sign"], "mo" if part["sign"] else "mtext"
                row += f"<{tag}>{_ARROWS.get(sign, sign or part['beside'])}</{tag}>"
                continue
            below, above = part["below"], (part["above"] or "").replace("-", "−")
            marks = f"<mn>{below}</mn>" * bool(below) + f"<mtext>{above}</mtext>" * bool(above)
            tag = f"m{'sub' * bool(below)}{'sup' * bool(above)}"
            base = f"<mtext>{part['base']}</mtext>"
            row += f"<{tag}>{base}{marks}</{tag}>" if marks else base
        return _row(row)

    def root(self, _: str) -> str:
        if self.peek() != "[":
            return f"<msqrt>{self.argument()}</msqrt>"
        ends = next((k for k in range(self.at, len(self.items)) if self.items[k].text == "]"), None)
        if ends is None:
            raise UnreadError("a [ without its ]", 0)
        degree = self.inner(self.items[self.at + 1 : ends])
        self.at = ends + 1
        return f"<mroot>{self.argument()}{degree}</mroot>"

    def accented(self, text: str) -> str:
        return f"<mover>{self.argument()}{_ACCENTS[text]}</mover>"

    def underlined(self, text: str) -> str:
        return f'<munder>{self.argument()}<mo stretchy="true">{_BELOW[text]}</mo></munder>'

    def bolded(self, _: str) -> str:
        return self.argument(bold=True)

    def words(self, text: str) -> str:
        group = self.group()
        if text in UPRIGHT and not plain(*group).isalpha():
            return self.inner(group)
        tag = "mi" if text.startswith(r"\operatorname") else "mtext"
        dashed = said(group).replace("---", "—").replace("--", "–")
        return f"<{tag}>{escape(dashed)}</{tag}>"

    def styled(self, text: str) -> str:
        return "".join(f"<mi>{_character(_STYLES[text], x)}</mi>" for x in plain(*self.group()))

    def spaced(self, text: str) -> str:
        return f'<mspace width="{_SPACES[text]}"/>'

    def numbered(self, _: str) -> str:
        return f'<mspace width="2em"/><mtext>({escape(plain(*self.group()))})</mtext>'

    def dropped(self, _: str) -> str:
        self.group()
        return ""

    def stacked(self, text: str) -> str:
        other, base = self.argument(), self.argument()
        tag = "munder" if text == r"\underset" else "mover"
        return f"<{tag}>{base}{other}</{tag}>"

    def environment(self, _: str) -> str:
        """A matrix, cases, or lines below one another."""
        name = plain(*self.group())
        if name in _WITH_ARGUMENT:
            self.group()
        depth, begun = 1, self.at
        while depth:
            depth += {r"\begin": 1, r"\end": -1}.get(self.next().text, 0)
        inside = self.items[begun : self.at - 1]
        self.group()
        table = self.within(inside).table(centred=name in _CENTRED)
        fences = _FENCES.get(name, "  ")
        opens, closes = (f'<mo stretchy="true">{x}</mo>' * (x != " ") for x in fences)
        return _row(opens + table + closes)

    takes: Mapping[frozenset[str], Callable[[_Transcript, str], str]] = {
        _FRACTIONS: fraction,
        commands("binom dbinom tbinom"): chosen,
        commands("ce"): formula,
        commands("left"): fence,
        commands("sqrt"): root,
        frozenset(_ACCENTS): accented,
        frozenset(_BELOW): underlined,
        BOLD: bolded,
        TEXTS | UPRIGHT: words,
        frozenset(_STYLES): styled,
        frozenset(_SPACES): spaced,
        commands("tag") | {r"\tag*"}: numbered,
        _DROPPED: dropped,
        commands("underset overset stackrel"): stacked,
        commands("begin"): environment,
    }


_ARROWS = {"->": "→", "<-": "←", "<=>": "⇌"}


def _as_typed(items: Sequence[Piece]) -> str:
    """Pieces as they were typed, without spaces."""
    return "".join(f"{{{_as_typed(x.group)}}}" if x.text == "{}" else x.text for x in items)


def _closings(items: Sequence[Piece]) -> dict[int, int]:
    """Where each bracket is closed that is, by its place; those of \\left and \\right apart."""
    closings: dict[int, int] = {}
    opened: list[tuple[str, int]] = []
    for k, piece in enumerate(items):
        sign = _SIGNS.get(piece.text, " ")
        if k and items[k - 1].text in (r"\left", r"\right"):
            continue
        if opened and opened[-1][0] + sign in ("()", "[]", "||", "‖‖"):
            closings[opened.pop()[1]] = k
        elif sign in "([|‖":
            opened.append((sign, k))
    return closings


def _name(text: str) -> bool:
    """Whether a command is a function's name."""
    return text[:1] == "\\" and text[1:] in _NAMES


def _one(parts: Sequence[str]) -> str:
    return parts[0] if len(parts) == 1 else _row("".join(parts))


def _row(inside: str) -> str:
    return f"<mrow>{inside}</mrow>"


def _is_sign(part: str) -> bool:
    """Whether a minus behind it stands before what follows."""
    return part.startswith(("<mo>", "<mo ")) and not part.endswith(
        (")</mo>", "]</mo>", "}</mo>", "|</mo>")
    )


def _sign(sign: str, first: bool) -> str:
    if sign in _BRACKETS:
        return f'<mo stretchy="false">{sign}</mo>'
    if sign == "/":
        return '<mo lspace="0" rspace="0">/</mo>'
    form = ' form="prefix"' if first and sign in "+−±∓" else ""
    return f"<mo{form}>{escape(sign)}</mo>"


def _character(style: str, letter: str) -> str:
    """A letter of another alphabet, such as ℒ."""
    kind = "CAPITAL" if letter.isupper() else "SMALL"
    for before in ("", "MATHEMATICAL "):
        try:
            return unicodedata.lookup(f"{before}{style} {kind} {letter.upper()}")
        except KeyError:
            continue
    raise UnreadError(f"no {letter} of this style", 0)
