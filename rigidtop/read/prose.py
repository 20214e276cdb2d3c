"""The words of a text: what stands between its formulas, and where its sentences end."""

from __future__ import annotations

import re
import unicodedata
from bisect import bisect_left, bisect_right
from collections.abc import Iterator, Sequence
from functools import lru_cache

from rigidtop.read.left import states
from rigidtop.read.scopes import Boundary, scopes
from rigidtop.read.unmarked import unmarked
from rigidtop.read.walk import DOCUMENT, Formula, Walk

DISPLAY, STATEMENT, LETTER = "\x01", "\x02", "\x03"
"""What stands in prose for formulas: on a line of their own, with a relation, without."""

LONGEST = 500
"""Of the words in front of a formula no more are kept, and no more behind it (characters)."""

NEAR = 200
"""Words further off say nothing of a letter (characters)."""

_DROPPED = re.compile(
    r"\\(?:begin|end)[ \t]*\{[^{}\x01-\x03]{0,40}\}"
    r"|\\(?:label|(?:eq|auto|page|c|C)?ref|cite\w*|tag|[vh]space|input|include\w*|use\w+)\*?[ \t]*"
    r"(?:\[[^\]\n\x01-\x03]{0,200}\][ \t]*)?\{[^{}\x01-\x03]{0,200}\}"
    r"|<[A-Za-z/!][^<>\x01-\x03]{0,200}>|\]\([^)\n\x01-\x03]{0,200}\)"
)
_ACCENT = re.compile(r"\\([\"'`^])[ \t]*\{?\\?([A-Za-z])\}?")
_ACCENTS = {'"': "\u0308", "'": "\u0301", "`": "\u0300", "^": "\u0302"}
_MARKUP = re.compile(r"\\[A-Za-z]+\*?|\\.|[{}*`~\\]|(?<!\w)_+|_+(?!\w)|^[ \t]*>", re.M)
_SIGNS = str.maketrans(
    {"§": "Section", "¶": " ", "\f": " ", DISPLAY: " ", STATEMENT: " ", LETTER: " ", "’": "'"}
)
_SHORT = "z|z.B|z. B|d|d.h|d. h|e.g|i.e|p. ex|p|cf|vs|Eq|Eqs|Fig|Figs|Sec|Gl|Abb|bzw|resp|ca|no|Nr"
"""Behind these a full stop is none."""
_STOPS = "".join(rf"(?<!\b{re.escape(short)})" for short in _SHORT.split("|")) + "[.!?]"
_END = re.compile(
    r"(?=[\f.!?,;\s])(?:"
    rf"\f|{_STOPS}[\"')\]]*(?:\s*\n[ \t]*\n\s*|\s+(?=[^\Wa-zà-ÿ_\d]|[\"'(\x01-\x03])|\s*\Z)"
    r"|(?<=[\x01])[,;]?\s+(?=[A-ZÄÖÜÉÀ][^\W\d_]|A )|(?<=\x01)[ \t]*\n[ \t]*\n\s*(?=[\x02\x03])"
    r"|(?<![,:;\x01-\x03\s])[ \t]*\n[ \t]*\n\s*(?=[A-ZÄÖÜÉÀ]))"
)
"""Where a sentence ends; that it may begin with few characters is said first, for speed."""
_FORMULA = re.compile(f"[{DISPLAY}{STATEMENT}{LETTER}]")
_STATED = re.compile(f"[{DISPLAY}{STATEMENT}]")
_STOP = re.compile(
    r"(?<!\\right)(?<!\\left)(?<!\\)([.,;])(?:\s|\}|\\[a-z]*quad|\\\\|\\(?:label|tag)\*?\{[^{}\n]{0,99}\}"
    r"|\\(?:nonumber|notag)|\\end\s*\{[a-z*]+\})*\Z"
)


class TextStructure:
    """The formulas of a text, its scopes and its sentences.

    `formulas` are those of the file, where it is `plain` with those outside of dollars.
    Raises RigidtopError for a text that is too long.
    """

    def __init__(self, source: str, plain: bool = False) -> None:
        walk = Walk(source)
        self.formulas = unmarked(walk) if plain else walk.found
        covered = [*((formula.opens, formula.end) for formula in self.formulas), *walk.skipped]
        marks = scopes(source, sorted(covered), walk.tex)
        self.starts = [mark.start for mark in marks]
        self.paths = [(), *(mark.path for mark in marks)]
        document = DOCUMENT.search(source) if walk.tex else None
        start = document.end() if document else 0
        pieces = _pieces(source, self.formulas, walk.skipped, marks, start)
        self.text = _words("".join(pieces))
        self.places = [match.start() for match in _FORMULA.finditer(self.text)]
        self.stated = [match.start() for match in _STATED.finditer(self.text)]
        self.ends = [match.end() for match in _END.finditer(self.text)]

    def scope(self, number: int) -> tuple[int, ...]:
        """The path of the scope in which a formula stands."""
        return self.paths[bisect_right(self.starts, self.formulas[number].opens)]

    def sentence(self, number: int) -> int:
        """The number of the sentence of a formula."""
        return bisect_right(self.ends, self.places[number])

    def around(self, number: int) -> tuple[str, str]:
        """The words between a formula and the statements before and behind it in its sentence."""
        place = self.places[number]
        start, end = self.bounds(number)
        start, end = max(start, place - LONGEST), min(end, place + LONGEST)
        i = bisect_right(self.stated, place)
        last = i - 2 if i and self.stated[i - 1] == place else i - 1
        if last >= 0:
            start = max(start, self.stated[last] + 1)
        if i < len(self.stated):
            end = min(end, self.stated[i])
        return _shown(self.text[start:place]), _shown(self.text[place + 1 : end])

    def since(self, number: int) -> str:
        """The words of its scope since the statement before, in other sentences too."""
        place = self.places[number]
        stated = bisect_left(self.stated, place)
        start = max(self.stated[stated - 1] + 1 if stated else 0, place - LONGEST)
        return _shown(self.text[start:place].rpartition("\f")[2])

    def near(self, number: int) -> tuple[str, str]:
        """The words around a formula between two displays, with = for what says something."""
        place = self.places[number]
        start, end = self.bounds(number)
        before = self.text[max(start, place - NEAR) : place].rpartition(DISPLAY)[2]
        behind = self.text[place + 1 : min(end, place + NEAR)].partition(DISPLAY)[0]
        return _shown(before.replace(STATEMENT, "=")), _shown(behind.replace(STATEMENT, "="))

    def bounds(self, number: int) -> tuple[int, int]:
        """Where the sentence of a formula begins and ends."""
        sentence = self.sentence(number)
        start = self.ends[sentence - 1] if sentence else 0
        return start, self.ends[sentence] if sentence < len(self.ends) else len(self.text)


@lru_cache(maxsize=1)
def prose_of(source: str, plain: bool) -> TextStructure:
    """The prose of a text, kept until another one is read: its letters and its formulas need it."""
    return TextStructure(source, plain)


def _pieces(
    source: str,
    formulas: Sequence[Formula],
    skipped: Sequence[tuple[int, int]],
    marks: Sequence[Boundary],
    at: int,
) -> Iterator[str]:
    """The source in pieces, with signs for formulas and scopes, without comments and code."""
    spans = [(formula.opens, 2, formula.end, _sign(formula)) for formula in formulas]
    spans += [(start, 2, end, " ") for start, end in skipped]
    spans += [(mark.start, 1, mark.words, "\f") for mark in marks]
    spans += [
        (mark.title, 0, mark.title, "¶\f" if mark.alone else "¶") for mark in marks if mark.title
    ]
    for start, _, end, sign in sorted(spans):
        yield source[at:start].translate(_SIGNS)
        yield sign
        at = max(at, end)
    yield source[at:].translate(_SIGNS)


def _sign(formula: Formula) -> str:
    stop = _STOP.search(formula.text[-200:])
    kind = DISPLAY if formula.display else STATEMENT if states(formula) else LETTER
    return kind + (stop[1] if stop else "")


def _words(text: str) -> str:
    """Words without the marks of TeX and Markdown."""
    text = _DROPPED.sub(" ", text)
    text = _ACCENT.sub(lambda m: unicodedata.normalize("NFC", m[2] + _ACCENTS[m[1]]), text)
    return _MARKUP.sub(" ", text.replace(r"\ss", "ß"))


def _shown(text: str) -> str:
    return " ".join(_FORMULA.sub("§", text).split())
