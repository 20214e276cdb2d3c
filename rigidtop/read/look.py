"""Looking at pieces of TeX ahead, and putting glyphs together."""

from __future__ import annotations

import re
import unicodedata
from collections.abc import Container, Sequence
from dataclasses import replace
from itertools import pairwise

from rigidtop.read import signs
from rigidtop.read.tex import BOLD, NOTHING, TEXTS, UPRIGHT, Piece, UnreadError, flat, plain, split
from rigidtop.theory.symbols import Glyph


def operator_at(items: Sequence[Piece], at: int) -> tuple[str, int]:
    r"""Whether a d or ∂ stands there, and in how many pieces: ``d``, ``\mathrm d``, ``{\rm d}``."""
    text = items[at].text if at < len(items) else ""
    if text == "d":
        return "d", 1
    if text == r"\partial":
        return "∂", 1
    if text in signs.WORDED and at + 1 < len(items) and plain(items[at + 1]) == "d":
        return "d", 2
    if text == "{}" and items[at].group and items[at].group[0].text in signs.WORDED:
        return ("d", 1) if plain(items[at]) == "d" else ("", 0)
    return "", 0


def operator(
    over: Sequence[Piece], below: Sequence[Piece], position: int
) -> tuple[str, Sequence[Piece], list[Sequence[Piece]]] | None:
    """What is differentiated and by what, of a fraction that is a derivative."""
    over, below = ([p for p in part if p.text not in NOTHING] for part in (over, below))
    sign, count = operator_at(over, 0)
    if not sign:
        marked = [p.text for p in flat(over) if p.text not in signs.DRESSES | TEXTS] == ["d"]
        if marked and operator_at(below, 0)[0]:
            raise UnreadError("a derivative whose d has a mark of its own", position)
        return None
    order = 1
    if count < len(over) - 1 and over[count].text == "^":
        if not plain(over[count + 1]).isdigit():
            if operator_at(below, 0)[0] == sign:
                raise UnreadError("a derivative of an order that is no number", position)
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


def infix(items: Sequence[Piece], level: int) -> Sequence[Piece]:
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


def crossed(items: Sequence[Piece]) -> bool:
    """Whether × stands anywhere but before or behind a number."""
    numeric = [plain(piece).isdigit() for piece in items]
    return any(crossed(piece.group) for piece in items) or any(
        piece.text == r"\times" and not any(numeric[max(i - 1, 0) : i + 2])
        for i, piece in enumerate(items)
    )


def lonely_d(items: Sequence[Piece]) -> bool:
    """Whether a d stands alone: a letter, a distance say."""
    ends = {*signs.RELATIONS, "+", "-", ")", "", "_", "/", ",", r"\cdot"}
    for i, piece in enumerate(items):
        if piece.text == "{}":
            over = piece.group[:1] and piece.group[0].text == "d"  # the bar of a derivative
            if over and (len(piece.group) == 1 or piece.group[1].text == "^"):
                continue
            if lonely_d(piece.group):
                return True
        if piece.text != "d" or (i and items[i - 1].text in signs.WORDED | {"_", "^"}):
            continue
        behind = items[i + 1].text if i + 1 < len(items) else ""
        if behind == "(" and (not i or items[i - 1].text in ("+", "-", "=")):
            return True
        if behind in ends and not (i and items[i - 1].text == r"\frac"):
            return True
    return False


def below(items: Sequence[Piece]) -> set[str]:
    """The single letters that stand below others."""
    found = {plain(b) for a, b in pairwise(items) if a.text == "_" and is_latin(plain(b))}
    return found.union(*(below(piece.group) for piece in items if piece.group))


def mathematical(words: Sequence[Piece]) -> bool:
    """Whether a relation stands among words."""
    return any(piece.text in signs.MATHEMATICAL for piece in flat(words))


def is_list(inner: Sequence[Piece]) -> bool:
    """Whether letters are listed with dots and without commas: x₁ … x_n."""
    texts = [piece.text for piece in inner]
    return any(text in signs.OMITTED for text in texts) and not {"+", "-"} & set(texts)


def terms(inner: Sequence[Piece]) -> set[str]:
    """The letters that are terms of a sum, without index or prime: x of x − ct."""
    made = set()
    parts: list[list[Piece]] = [[]]
    for piece in inner:
        if piece.text in ("+", "-"):
            parts.append([])
        else:
            parts[-1].append(piece)
    for part in parts:
        bare = [p for p in part if p.text not in signs.DRESSES]
        if bare and (len(bare) == 1 or bare[1].text in ("_", "'")) and len(bare) <= 3:
            made.add(signs.LETTERS.get(plain(bare[0]), plain(bare[0])))
    return made


def length(items: Sequence[Piece]) -> int:
    """How many pieces say how the next line follows, and how far down: `\\\\*[2pt]`."""
    texts = [piece.text for piece in items[:12]]
    star = texts[:1] == ["*"]
    if texts[star : star + 1] != ["["] or "]" not in texts:
        return int(star)
    end = texts.index("]")
    return end + 1 if signs.LENGTH.fullmatch("".join(texts[1 + star : end])) else int(star)


def rows(inner: Sequence[Piece]) -> list[Sequence[Piece]]:
    """The rows of an environment, without the distances between them."""
    return [row[length(row) :] for row in split(inner, r"\\")]


def shifted(inner: Sequence[Piece]) -> set[str]:
    """The letters of a sum without powers, which may be an argument: x − ct, not y − x² + 1."""
    return set() if any(piece.text == "^" for piece in inner) else terms(inner)


def behind(inner: Sequence[Piece]) -> int:
    """Behind an argument in braces or square brackets."""
    if inner[0].text == "{}":
        return 1
    return next((i + 1 for i, piece in enumerate(inner) if piece.text == "]"), 1)


def is_latin(text: str) -> bool:
    """Whether it is a letter that formulas have."""
    return len(text) == 1 and text.isalpha() and (text.isascii() or text in signs.ALPHABET)


def is_product(run: str, letters: Container[str] = ()) -> bool:
    """Whether a row of letters is rather a product: no vowels, as mgRh, or one, all the file's own.

    >>> is_product("mghu"), is_product("mghu", "ghmu"), is_product("spin", "inps")
    (False, True, False)
    """
    vowels = [letter for letter in run if letter in "aeiouyAEIOUY"]
    own = len(vowels) == 1 and run.lower() not in signs.WORDLIKE
    return not vowels or (own and all(letter in letters for letter in run))


def components(text: str) -> set[tuple[str, str]]:
    r"""Letters with a number above that may be an index: the text has them as x^1, or as x^\mu.

    >>> sorted(components(r"u = u^1, y = x^\mu + e^{-1} + z^{10}"))
    [('u', '2'), ('u', '3'), ('x', '3'), ('x', '5')]
    """
    found = [(m[1], m[2] or m[3]) for m in _ABOVE.finditer(text)]
    return {
        (signs.LETTERS.get(letter, letter), power)
        for letter, above in found
        for power in ("23" if above == "1" else "35")
    }


_ABOVE = re.compile(
    r"(\\[A-Za-z]+|(?<![A-Za-z\\])[A-Za-z])\s*\^\s*"
    r"(?:\{\s*([01ijk]|\\(?:mu|nu|rho))\s*\}|([01](?!\d)|[ijk]|\\(?:mu|nu|rho)\b))"
)


def has_own_pi(text: str) -> bool:
    r"""Whether π is no number there: it has a dot, or an equation that says what it is.

    >>> [has_own_pi(x) for x in (r"\pi &= Rx", r"\dot{\pi} = 0", r"\pi_x = p", r"x = 2\pi")]
    [True, True, True, False]
    """
    return _OWN_PI.search(text) is not None


_OWN_PI = re.compile(
    r"(?<!\d)\\pi\s*(?:\\,)?\s*\\dot|\\pi\s*_\s*(?:\{[^{}]*\}|\\[a-z]+|\w)\s*&?=|"
    r"\\d?dot\s*\{?\s*\\pi\b(?!\s*\}?\s*_)|\\pi\s*(?:\^\s*\{?\s*(?:[ijk]|\\[mn]u)|\(\s*[xtr]\s*[,)])|(?:^|&|\\\\)\s*\\pi\s*&?\s*(?:=|:=|\\equiv\b)\s*&?"
    r"(?!\s*(?:\d|\\(?:frac\{?\d|arc|int|lim|sum)))"
)


def products(text: str, letters: Container[str]) -> list[str]:
    """The rows of letters with a vowel that are products, since all are letters of the file."""
    runs = re.findall(r"(?<![A-Za-z\\{])[A-Za-z]{4,}(?![A-Za-z}])", text)
    return [run for run in runs if is_product(run, letters) and not is_product(run)]


def styled(written: str, style: str, position: int) -> str:
    if len(written) != 1:
        raise UnreadError("no single symbol in braces", position)
    if style == r"\mathbb" and written in signs.SETS:
        raise UnreadError("a set: that is not read", position)
    case = "CAPITAL" if written.isupper() else "SMALL"
    for prefix in ("MATHEMATICAL ", ""):
        try:
            return unicodedata.lookup(f"{prefix}{signs.STYLES[style]} {case} {written.upper()}")
        except KeyError:
            continue
    return written


def primed(glyph: Glyph) -> Glyph:
    return replace(glyph, base=glyph.base + "′") if glyph.prime else replace(glyph, prime=True)


def dressed(glyph: Glyph, dress: Piece) -> Glyph:
    if dress.text in BOLD:
        return replace(glyph, bold=True)
    if dress.text in signs.MARKS:
        return replace(glyph, base=glyph.base + signs.MARKS[dress.text])
    if dress.text in UPRIGHT:
        return glyph
    accent = "hat" if dress.text in signs.HATS else {1: "dot", 2: "ddot"}[signs.OVER[dress.text]]
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
