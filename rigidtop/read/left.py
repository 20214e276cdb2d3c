"""What a walk through a file leaves: mathematics of which no formula is made, and its numbers."""

from __future__ import annotations

import re
from bisect import bisect_left
from collections.abc import Iterator

from rigidtop.read.walk import Formula, Problem, Walk

OUTSIDE = "mathematics outside of dollars: put it between $ and $"

LONGEST_LOST = 2_000
"""Of what is not taken no more is kept (characters)."""

_PROSE = frozenset(
    (
        *("document", "abstract", "itemize", "enumerate", "description", "figure", "table"),
        *("tabular", "tabularx", "longtable", "center", "quote", "quotation", "tikzpicture"),
        *("minipage", "thebibliography", "titlepage", "flushleft", "flushright", "filecontents"),
    )
)
"""Environments where an = outside all formulas is no mathematics."""
_KEYED = frozenset({"tikzpicture", "filecontents", "thebibliography"})
"""Environments where = stands between a key and its value."""
N = r"(?:[A-Z]{1,4}\.?)?\d{1,3}(?:[.–-]\d{1,3})*[a-z]?'{0,3}|\*{1,3}"
"""(3.57), (7), (A.3), (12a), (*): a number as it stands in brackets; a year is none."""
TAG = r"\\tag\*?\s*\{((?:[^{}\n]|\{[^{}\n]*\}){0,200})\}"
NUMBER = re.compile(rf"[ \t\n|]*(?:</?t[dr]>)*\(\s*({N})\s*\)[.,]?[ \t|]*(?=\n|$)")
_LAST = re.compile(rf"(?<!Eq\. )(?<!Eqs\. )\(\s*({N})\s*\)[.,]?[ \t|]*(?=\n|$)")
_LOST = re.compile(rf"{TAG}|\\l?eqno\s*\(?\s*({N})|{_LAST.pattern}")
SIGNS = "equiv|approx|neq?|lt|gt|leq?|geq?|ll|gg|propto|sim|simeq|cong|to|in"
RELATED = re.compile(
    rf"[=<>≈≡≠≤≥∝≃≅∥⊥→]|\\(?:{SIGNS})(?![A-Za-z])|(?<![_{{])\\(?:parallel|perp)(?![A-Za-z])"
)
_BARE = re.compile(
    r"\\[A-Za-z]+\*?\s*\[[^\]\n]{0,400}\]|<[A-Za-z/!][^<>]{0,400}>|https?://\S+"
    r"|\\(?:url|href|label|hypersetup|setlength|geometry)\s*(?:\[\w*\]\s*)?\{[^{}\n]{0,400}\}"
    r"|\\(?:(?:re)?newcommand|providecommand|def|DeclareMathOperator)(?![A-Za-z])[^\n]{0,400}"
    r"|\]\([^)\n]{0,400}\)|\{:?\s*[#.][^{}\n]{0,400}\}|^[ \t]*=+[ \t]*$"
    r"|(?P<hit>(?<!\\)[=≈≡≠≤≥∝≃≅]|(?<=[^\s>][ ])[<>](?=[ ])|\\tag\*?\s*\{"
    rf"|\\(?:{SIGNS}|[td]?frac|partial|sqrt|d?dot|sin|cos|mathbf|boldsymbol|mathcal|hat|vec"
    r"|theta|phi|psi|omega|Omega|lambda)(?![A-Za-z]))",
    re.M,
)
"""A sign or a command that only mathematics has; what may have one all the same goes before it."""


def states(formula: Formula) -> bool:
    """Whether a formula says anything: a display, or a relation in a line."""
    return formula.display or RELATED.search(formula.text) is not None


def bare(walk: Walk) -> Iterator[Problem]:
    """The lines with mathematics outside of all dollars, in order.

    In an unknown environment, at a \\tag or beside a number it is refused.
    """
    hits, taken = [*_hits(walk)], _taken(walk)
    told: set[int] = set()
    for name, begun, end in walk.unknown:
        inside = hits[bisect_left(hits, begun) : bisect_left(hits, end)]
        if name.rstrip("*") not in _PROSE and inside:
            walk.refuse(begun, f"mathematics in an environment that is not read: {name}", end)
            told.update(inside)
    until = 0
    for hit in hits:
        if hit in told:
            continue
        tagged = walk.source.startswith(r"\tag", hit)
        if tagged:
            walk.refuse(hit, r"a \tag outside a formula")
        if hit < until:
            continue
        start = walk.source.rfind("\n", 0, hit) + 1
        until = walk.source.find("\n", hit)
        until = until if until >= 0 else len(walk.source)
        if tagged:
            continue
        start += len(walk.source[start:until]) - len(walk.source[start:until].lstrip())
        number = _LAST.search(walk.source, hit, until) or NUMBER.match(walk.source, until)
        if number and number.start(1) not in taken:
            walk.refuse(start, OUTSIDE, until)
        else:
            walk.count()
            yield Problem(start, OUTSIDE)


def _hits(walk: Walk) -> Iterator[int]:
    """Where mathematics stands outside of all that was taken, skipped and refused."""
    covered = [(formula.opens, formula.end) for formula in walk.found]
    covered += walk.skipped + [(start, end) for start, end, _ in walk.refused]
    covered += [(begun, end) for name, begun, end in walk.unknown if name in _KEYED]
    covered += [(0, begun) for name, begun, _ in walk.unknown if name == "document"]
    at = 0
    for start, end in [*sorted(covered), (len(walk.source), len(walk.source))]:
        if start > at:
            found = _BARE.finditer(walk.source, at, start)
            yield from (match.start() for match in found if match["hit"])
        at = max(at, end)


def _taken(walk: Walk) -> set[int]:
    """Where the numbers of formulas stand."""
    found = (NUMBER.match(walk.source, formula.end) for formula in walk.found)
    return {beside.start(1) for beside in found if beside}


def lost(walk: Walk) -> Iterator[tuple[str, Formula]]:
    """Numbers that stand beside what was refused, in order, each with that and why."""
    spans = sorted([(formula.opens, formula.end) for formula in walk.found] + walk.skipped)
    starts = [start for start, _ in spans]
    seen = _taken(walk)
    refused = sorted(walk.refused)
    following = [*(start for start, _, _ in refused[1:]), len(walk.source)][: len(refused)]
    for (start, until, reason), after in zip(refused, following, strict=True):
        end = min(until, max(after, start + 1))
        beside = NUMBER.match(walk.source, end)
        for match in [*_LOST.finditer(walk.source, start, end), *([beside] if beside else [])]:
            assert match.lastindex is not None
            place = match.start(match.lastindex)
            i = bisect_left(starts, place) - 1
            if place in seen or (i >= 0 and place < spans[i][1]):
                continue
            seen.add(place)
            stop = max(end, match.end())
            written = walk.source[start : min(stop, start + LONGEST_LOST)]
            walk.count()
            yield bared(match[match.lastindex]), Formula(written, start, stop, True, start, reason)


def bared(number: str) -> str:
    """A number without brackets round it."""
    return re.sub(r"\s+", "", number).strip("()$")
