r"""The numbers that a class of LaTeX counts, and the labels that stand for them.

An author writes ``\label{eq:nutation}`` and never sees the number: it is counted here as the class
counts it, anew in each section or chapter where it does that.

>>> text = r"\section{Tops}\begin{align} a &= b \label{ab} \\ c &= d \end{align}"
>>> [(row.number, row.label) for row in counted(r"\numberwithin{equation}{section}" + text)]
[('1.1', 'ab'), ('1.2', '')]
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from functools import lru_cache

from rigidtop.read.document import formulas
from rigidtop.read.walk import Formula


@dataclass(frozen=True)
class Counted:
    """A row of a display with its number: from where to where it stands in the file."""

    number: str
    label: str
    start: int
    end: int


_LEVELS = ("chapter", "section", "subsection")
_EVENTS = re.compile(
    r"(?<!\\)%[^\n]*|\\(?P<level>chapter|section|subsection)\s*(?:\[[^\]\n]*\])?\s*\{"
    r"|\\(?P<appendix>appendix)(?![A-Za-z])"
    r"|\\(?P<side>begin|end)\s*\{subequations\}(?P<whole>\s*\\label\s*\{[^{}\n]{0,200}\})?"
)
_WITHIN = re.compile(
    r"\\(?:numberwithin|counterwithin\*?)\s*\{equation\}\s*\{(chapter|section|subsection)\}"
    r"|\\@addtoreset\s*\{equation\}\s*\{(chapter|section|subsection)\}"
)
_CLASS = re.compile(r"^[^%\n]*\\documentclass\s*(?:\[[^\]]*\])?\s*\{(\w+)\}", re.M)
_BOOKS = frozenset({"book", "report", "scrbook", "scrreprt", "memoir", "amsbook", "extbook"})
_DISPLAY = re.compile(r"\\begin\s*\{\s*(\w+)(\*?)\s*\}")
_ONE = frozenset({"equation", "multline", "dmath"})
_ROWS = frozenset({"align", "gather", "alignat", "flalign", "eqnarray", "IEEEeqnarray", "xalignat"})
_ROW = re.compile(r"\\(?P<side>begin|end)\s*\{|(?P<row>\\\\)|(?<!\\)%[^\n]*")
LABEL = re.compile(r"\\label\s*(?:\[\w*\]\s*)?\{([^{}\n]{1,200})\}")
_TAG = re.compile(r"\\tag\*?\s*\{([^{}\n]{1,200})\}")
_NONE = re.compile(r"\\no(?:number|tag)(?![A-Za-z])")


def _within(source: str) -> str:
    """In what equations are counted anew: "section", "chapter", or "" for the whole file."""
    found = _WITHIN.search(source)
    if found:
        return found[1] or found[2]
    classed = _CLASS.search(source)
    return "chapter" if classed and classed[1] in _BOOKS else ""


@lru_cache(maxsize=4)
def counted(source: str) -> tuple[Counted, ...]:
    """Every row that bears a number, by the class or by its tag, in order."""
    level = _within(source)
    depth = _LEVELS.index(level) + 1 if level else 0
    heads: list[int | str] = [0, 0, 0]
    lettered = False
    count, letter = 0, 0
    made: list[Counted] = []
    events: list[tuple[int, re.Match[str] | Formula]] = [
        (m.start(), m) for m in _EVENTS.finditer(source) if m[0][0] != "%"
    ]
    events += [(f.opens, f) for f in formulas(source) if f.display]
    for _, what in sorted(events, key=lambda pair: pair[0]):
        if isinstance(what, re.Match):
            if what["level"]:
                k = _LEVELS.index(what["level"])
                heads[k:] = [_next(heads[k]), *[0] * (2 - k)]
                count = 0 if k < depth else count
            elif what["appendix"]:
                k = 0 if level == "chapter" else 1
                heads[k:] = ["@", *[0] * (2 - k)]
            else:
                lettered = what["side"] == "begin"
                count, letter = count + lettered, 0
            continue
        for start, end in _numbered_rows(source, what.opens, what.start, what.end):
            text = source[start:end]
            tag, label = _TAG.search(text), LABEL.search(text)
            if tag is None:
                letter, count = (letter + 1, count) if lettered else (0, count + 1)
            first = 0 if heads[0] else 1
            parts = [*heads[first:depth], count]
            number = ".".join(map(str, parts)) + (chr(96 + letter) if 0 < letter < 27 else "")
            bare = tag[1].strip("()$ ") if tag else number
            made.append(Counted(bare, label[1] if label else "", start, end))
    return tuple(made)


def row_of(rows: Sequence[Counted], position: int) -> Counted | None:
    """The row in which something stands."""
    i = bisect_right(rows, position, key=lambda row: row.start) - 1
    return rows[i] if i >= 0 and position < rows[i].end else None


def _next(head: int | str) -> int | str:
    return chr(ord(head) + 1) if isinstance(head, str) else head + 1


def _numbered_rows(source: str, opens: int, start: int, end: int) -> Iterator[tuple[int, int]]:
    """The rows of a display that have a number: all of it where it has but one."""
    begun = _DISPLAY.match(source, opens)
    if begun is None:  # between $$ and $$: a number is written there
        if _TAG.search(source, start, end):
            yield start, end
        return
    name, star = begun[1], begun[2]
    if star or name in _ONE:
        if (not star and not _NONE.search(source, start, end)) or _TAG.search(source, start, end):
            yield start, end
        return
    if name not in _ROWS:
        return
    depth, at = 0, start
    stop = source.rfind("\\end", start, end)
    for match in _ROW.finditer(source, start, stop):
        depth += {"begin": 1, "end": -1}.get(match["side"] or "", 0)
        if match["row"] and not depth:
            if not _NONE.search(source, at, match.start()):
                yield at, match.start()
            at = match.end()
    if source[at:stop].strip() and not _NONE.search(source, at, stop):
        yield at, stop
