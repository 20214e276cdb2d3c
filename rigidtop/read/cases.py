r"""Where a text comes to another case: headings, items, rows of tables, parts of exercises.

A place lies in a path of cases, from its heading inwards.  What is said holds in its own case and
in those within it, not beside it.

>>> where = cases("# Springs\n\nA mass.\n\n1. Without friction.\n2. With it.\n\nBoth move.\n")
>>> [where(place) for place in (12, 25, 45, 60)]
[(1,), (1, 3), (1, 4), (1,)]
"""

from __future__ import annotations

import re
from bisect import bisect_right
from collections.abc import Callable
from operator import attrgetter, itemgetter

from rigidtop.read.document import formulas
from rigidtop.read.walk import is_tex

_LISTS = "enumerate|itemize|description|parts|subparts|subsubparts|questions|tasks"
_NAMED = r"(?:Example|Problem|Exercise|Question|Case|Part|Beispiel|Aufgabe|Fall)"
_BOLD = r"(?:\*\*|__|\\textbf\s*\{|\\noindent\s*|\{\\bf\s*){0,2}"
_CUTS = re.compile(
    r"(?P<heading>^[ \t]{0,3}#{1,6}[ \t]|\\(?:chapter|(?:sub)*section)\*?[ \t]*[\[{]"
    r"|\\begin[ \t]*\{(?:example|problem|exercise|question|solution|theorem|proof)s?\})"
    r"|(?P<part>\\(?:sub)?paragraph\*?[ \t]*\{"
    rf"|^[ \t]{{0,3}}{_BOLD}(?:{_NAMED}[ ~]*(?:\d|[A-Z]\b|\()|\([a-hivx]{{1,3}}\)[ \t*}}]))"
    rf"|(?P<open>\\begin[ \t]*\{{(?:{_LISTS})\}})|(?P<close>\\end[ \t]*\{{(?:{_LISTS})\}})"
    r"|(?P<item>\\(?:item|part|subpart|question|task)(?![A-Za-z]))"
    r"|(?P<entry>^[ \t]*(?:[-*+]|\d{1,3}[.)])[ \t]+(?=\S)|<tr\b|^\|(?=.*\|[ \t]*$))"
    r"|(?P<text>\n[ \t]*\n(?=[^\W\d_]))",
    re.M,
)


def cases(source: str) -> Callable[[int], tuple[int, ...]]:
    """What tells in which case a place of a text lies."""
    found: list[tuple[int, tuple[int, ...]]] = [(0, (0,))]
    heading = 0
    part: tuple[int, ...] = ()
    items: list[int] = []  # of the lists of LaTeX that are open, 0 before their first item
    entries: list[tuple[int, int]] = []  # how deep an entry of Markdown stands, and which it is
    tex, taken = is_tex(source), formulas(source)
    for count, match in enumerate(_CUTS.finditer(source), 1):
        before = bisect_right(taken, match.start(), key=attrgetter("opens")) - 1
        if before >= 0 and match.end() <= taken[before].end:
            continue  # within a formula a + begins no entry
        kind, width = match.lastgroup, len(match[0].expandtabs(4).lstrip("\n"))
        if kind == "heading":
            heading, part, items, entries = heading + 1, (), [], []
        elif kind == "part":
            part, items, entries = (count,), [], []
        elif kind == "open":
            items.append(0)
        elif kind == "close":
            items[-1:] = []
        elif kind == "item":
            items[-1:] = [count] if items else []
        elif kind == "entry" and not tex:
            indent = width - len(match[0].lstrip())
            entries = [x for x in entries if x[0] < indent] + [(indent, count)]
        elif kind == "text":
            entries = []
        inner = (*(x for x in items if x), *(x for _, x in entries))
        found.append((match.start(), (heading, *part, *inner)))
    return lambda place: found[bisect_right(found, place, key=itemgetter(0)) - 1][1]
