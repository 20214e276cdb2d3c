"""TeX taken apart: commands, characters and groups, with their places; and put into words.

Unicode, HTML's entities and its tags for indices are understood as the TeX that they stand for.
"""

from __future__ import annotations

import html
import re
import unicodedata
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import cache

from rigidtop.errors import RigidtopError
from rigidtop.notation.characters import GREEK, MARKS, MATHS, SUBSCRIPTS, SUPERSCRIPTS

LONGEST = 20_000
"""A formula is no longer than this (characters)."""

DEEPEST = 40
"""Groups, brackets and environments are not nested deeper."""


class UnreadError(RigidtopError):
    """What can't be read, and where: `position` counts characters from the start of the text."""

    def __init__(self, reason: str, position: int) -> None:
        super().__init__(reason)
        self.reason, self.position = reason, position


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
    accents = 0
    for found, position in _atoms(text):
        inside = stack[-1][1]
        accents = accents + 1 if found in _COMBINING else 0
        if accents > DEEPEST:
            raise UnreadError(f"nested deeper than {DEEPEST}", position)
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
        ends = text[match.end() : match.end() + 1]
        if found.isspace() or (found[0] == "%" and (found != "%" or ends == "\n")):
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
    if found == r"\_":
        return "_"  # Markdown has it so, lest it be taken for a slanted word
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


# --- Pieces in words -----------------------------------------------------------------------------


_BRACE = re.compile(r"\\.|[{}]", re.S)


def closing(text: str, at: int, stop: int) -> int | None:
    """Where the brace is closed that opens at a place; None if it is not in front of `stop`."""
    depth = 0
    for match in _BRACE.finditer(text, at, stop):
        depth += {"{": 1, "}": -1}.get(match[0], 0)
        if depth == 0:
            return match.start()
    return None


def listed(names: str) -> frozenset[str]:
    """Words of a text, each once."""
    return frozenset(names.split())


def commands(names: str) -> frozenset[str]:
    r"""Several commands: ``commands("le leq")`` has ``\le`` and ``\leq``."""
    return frozenset("\\" + name for name in names.split())


NOTHING = (
    commands("thinspace displaystyle textstyle limits nolimits nonumber notag left right middle")
    | commands("allowbreak noindent , ; : !")
    | {"\\ ", "\\\n", "~"}
    | {f"\\{size}{side}" for size in ("big", "Big", "bigg", "Bigg") for side in ("", *"lrm")}
)
"""What says nothing in a formula: spacing, and sizes of brackets."""
BOLD = commands("mathbf boldsymbol bm vec bf pmb bold overrightarrow underline overrightharpoon")
BOLD |= commands("overleftrightarrow mathbfit boldmath mathbold bfseries")
UPRIGHT = commands("mathrm mathit mathnormal mathsf rm it")
FONTS = BOLD | UPRIGHT
SIZES = commands("tiny scriptsize footnotesize small normalsize large displaystyle textstyle")
TEXTS = commands("text textrm textit mbox hbox operatorname operatorname* mathrm textnormal mathit")
GREEKS = {"\\" + name: letter for name, letter in GREEK.items()}
GREEKS |= {r"\varphi": "φ", r"\vartheta": "θ", r"\varepsilon": "ε", r"\varrho": "ρ"}
GREEKS |= {r"\var" + name: letter for name, letter in GREEK.items() if name[0].isupper()}
SAID = {**GREEKS, r"\perp": "⊥", r"\parallel": "∥", r"\partial": "∂", r"\top": "T"}
SAID |= {r"\intercal": "T", r"\prime": "′", "'": "′", r"\to": "→", r"\rightarrow": "→"}
SAID |= {r"\ll": "≪", r"\gg": "≫", r"\le": "≤", r"\leq": "≤", r"\ge": "≥", r"\geq": "≥"}
SAID |= {r"\neq": "≠", r"\ne": "≠", r"\approx": "≈", r"\dots": "…", r"\ldots": "…", r"\cdots": "…"}
SAID |= {r"\leqslant": "≤", r"\geqslant": "≥", r"\pm": "±", r"\mp": "∓", r"\times": "×"}
SAID |= {r"\odot": "⊙", r"\oplus": "⊕", r"\cap": "∩", r"\cup": "∪", r"\in": "∈", r"\circ": "∘"}
SAID |= {r"\bot": "⊥", r"\cdot": "·", r"\ell": "ℓ", r"\infty": "∞"}


def flat(items: Sequence[Piece]) -> Iterator[Piece]:
    """Pieces and what stands in their braces."""
    left = [*reversed(items)]
    while left:
        piece = left.pop()
        if piece.text != "{}":
            yield piece
        left.extend(reversed(piece.group))


def plain(*items: Piece) -> str:
    r"""Pieces as text, without braces, fonts and spaces, Greek letters as letters.

    >>> plain(*pieces(r"\text{CM}")), plain(*pieces(r"d^{3}\mathbf{r}"))
    ('CM', 'd^3r')
    """
    left_out = TEXTS | FONTS | NOTHING
    return "".join(SAID.get(p.text, p.text) for p in flat(items) if p.text not in left_out)


def said(items: Sequence[Piece]) -> str:
    """Words with the spaces between them, as far as places tell."""
    made, end = "", -1
    for piece in flat(items):
        if piece.text in NOTHING | TEXTS | FONTS | SIZES | {"$"}:
            continue
        made += " " * (end >= 0 and piece.position > end)
        named = piece.text[:1] == "\\" and piece.text[1:].isalpha()
        made += SAID.get(piece.text, piece.text[1:] if named else piece.text)
        end = piece.position + len(piece.text)
    return " ".join(made.split()).replace(" ,", ",")


def words(text: str) -> str:
    """Words and mathematics as they are written, without TeX: "for θ = 0"."""
    if not set(text) & set("\\${}^_~&<"):
        return " ".join(text.split()).strip(" .,;")
    try:
        return said(pieces(text)).strip(" .,;")
    except UnreadError:
        return " ".join(text.split())


def unread(text: str) -> str:
    """Mathematics that is not read, without TeX: ``\\lambda_r + i\\lambda_i`` as λ_r + iλ_i."""
    try:
        shown = "".join(f" {p.text} " if p.text in "+-=" else plain(p) for p in pieces(text))
    except UnreadError:
        return text
    return " ".join(shown.replace("\\", " ").split())


def split(items: Sequence[Piece], at: str) -> list[Sequence[Piece]]:
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
