"""Formulas in a file: Markdown with dollars, or LaTeX, and the numbers that stand beside them."""

from __future__ import annotations

import re
import time
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, lru_cache

from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES, Notation
from rigidtop.read.formula import Line, read
from rigidtop.read.habits import NO_HABITS, Habits

LONGEST = 2_000_000
"""A file is no longer than this (characters)."""

MOST = 20_000
"""A file has no more formulas, and no more places where one is not taken."""

MOST_NUMBERS = 5_000
"""A file has no more numbered equations."""

OUTSIDE = "mathematics outside of dollars: put it between $ and $"

LONGEST_LOST = 2_000
"""Of what is not taken no more is kept (characters)."""

LONGEST_TICKS = 20
"""Longer rows of ` or ~ do not begin code: looking for the end of each takes time."""

SECONDS = 60.0
"""A file is not read for longer than this (of the processor's time)."""

LATE = "the time for the file was over"

DEEPEST = 40
"""Environments are not followed deeper."""


@dataclass(frozen=True)
class Formula:
    """The text between two dollars, say: where it stands in the file, whether on its own.

    The text goes from `start` on; the formula with its dollars from `opens` to `end`.  `problem`
    is why it could not be taken: only what bears a number comes with one.
    """

    text: str
    start: int
    end: int
    display: bool
    opens: int = 0
    problem: str = ""


@dataclass(frozen=True)
class Numbered:
    """The formulas that bear one number together."""

    number: str
    formulas: tuple[Formula, ...]


@dataclass(frozen=True)
class Problem:
    """A place in the file where mathematics stands that was not taken as a formula, and why.

    `skipped` says that it is none by the file's own words: a comment, or code.
    """

    position: int
    reason: str
    skipped: bool = False


_MATHS = frozenset(
    name + star
    for name in (
        *("equation", "align", "alignat", "xalignat", "xxalignat", "flalign", "gather", "math"),
        *("multline", "eqnarray", "displaymath", "dmath", "IEEEeqnarray"),
    )
    for star in ("", "*")
)
_WITH_ARGUMENTS = {
    "alignat": re.compile(r"\s*\{\s*\d*\s*\}"),
    "IEEEeqnarray": re.compile(r"\s*(?:\[[^\]\n]*\]\s*)?\{[^{}\n]*\}"),
    "dmath": re.compile(r"\s*\[[^\]\n]*\]"),
}
_WITH_ARGUMENTS |= dict.fromkeys(("xalignat", "xxalignat"), _WITH_ARGUMENTS["alignat"])
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
_VERBATIM = frozenset({"verbatim", "Verbatim", "lstlisting", "minted", "comment", "alltt"})

_BOTH = (
    r"(?P<escaped>\\\\|\\[$%`])"
    r"|(?P<blank>\n[ \t]*(?=\n))"
    r"|(?P<off>\\iffalse(?![A-Za-z]))"
    r"|\\(?P<side>begin|end)\s*\{\s*(?P<name>[A-Za-z]+\*?)\s*\}"
    r"|(?P<sign>\$\$?|\\[\[\]()])"
)
_IN_TEX = re.compile(rf"{_BOTH}|(?P<percent>%[^\n]*)|(?P<verb>\\verb\*?[^A-Za-z\s*])", re.M)
_IN_MARKDOWN = re.compile(
    rf"{_BOTH}|(?P<percent>^[ \t]*%[^\n]*)|(?P<html><!--)"
    r"|(?P<fence>^[ \t]{0,3}(?P<ticks>`{3,}+|~{3,}+)(?P<info>[^\n`]*+)$)|(?P<code>`+)",
    re.M,
)
_FENCED = re.compile(r"^[ \t]{0,3}(`{3,20}+|~{3,20}+)(?s:.*?)^[ \t]{0,3}\1[^\n]*", re.M)
_QUOTED = re.compile(r"^[ \t]{0,3}>", re.M)
_TEX = re.compile(r"^[ \t]*\\(?:documentclass|begin\s*\{\s*document\s*\})", re.M)
_N = r"(?:[A-Z]{1,4}\.?)?\d{1,3}(?:[.–-]\d{1,3})*[a-z]?'{0,3}|\*{1,3}"
"""(3.57), (7), (A.3), (12a), (*): a number as it stands in brackets; a year is none."""
_TAG = r"\\tag\*?\s*\{((?:[^{}\n]|\{[^{}\n]*\}){0,200})\}"
_NUMBER = re.compile(rf"[ \t\n|]*(?:</?t[dr]>)*\(\s*({_N})\s*\)[.,]?[ \t|]*(?=\n|$)")
_LAST = re.compile(rf"(?<!Eq\. )(?<!Eqs\. )\(\s*({_N})\s*\)[.,]?[ \t|]*(?=\n|$)")
_BLANK_LINE = re.compile(r"\n[ \t]*\n")
_INSIDE = re.compile(
    rf"{_TAG}|\\l?eqno\s*\(?\s*({_N})|\\q?quad\s*\(({_N})\)(?=[\s.,]*$)"
    r"|\((\d+\.\d+[a-z]?)\)(?=[\s.,]*(?:\\end\s*\{\s*[A-Za-z*]+\s*\}\s*)*$)"
)
_LOST = re.compile(rf"{_TAG}|\\l?eqno\s*\(?\s*({_N})|{_LAST.pattern}")
_SIGNS = "equiv|approx|neq?|lt|gt|leq?|geq?|ll|gg|propto|sim|simeq|cong|to|in"
_RELATED = re.compile(
    rf"[=<>≈≡≠≤≥∝≃≅∥⊥→]|\\(?:{_SIGNS})(?![A-Za-z])|(?<![_{{])\\(?:parallel|perp)(?![A-Za-z])"
)
_TOLD = re.compile(r"=|\\(?:tag|equiv|approx|neq?)(?![A-Za-z])")
"""What makes a skipped part worth telling, if mathematics stands in it at all."""
_MATHEMATICAL = re.compile(r"\$|\\[\[(]|\\begin\s*\{|\\tag")
_BARE = re.compile(
    r"\\[A-Za-z]+\*?\s*\[[^\]\n]{0,400}\]|<[A-Za-z/!][^<>]{0,400}>|https?://\S+"
    r"|\\(?:url|href|label|hypersetup|setlength|geometry)\s*(?:\[\w*\]\s*)?\{[^{}\n]{0,400}\}"
    r"|\\(?:(?:re)?newcommand|providecommand|def|DeclareMathOperator)(?![A-Za-z])[^\n]{0,400}"
    r"|\]\([^)\n]{0,400}\)|\{:?\s*[#.][^{}\n]{0,400}\}|^[ \t]*=+[ \t]*$"
    r"|(?P<hit>(?<!\\)[=≈≡≠≤≥∝≃≅]|(?<=[^\s>][ ])[<>](?=[ ])|\\tag\*?\s*\{"
    rf"|\\(?:{_SIGNS}|[td]?frac|partial|sqrt|d?dot|sin|cos|mathbf|boldsymbol|mathcal|hat|vec"
    r"|theta|phi|psi|omega|Omega|lambda)(?![A-Za-z]))",
    re.M,
)
"""A sign or a command that only mathematics has; what may have one all the same goes before it."""
_SAID = re.compile(r"\s+[a-z]{2,}\s")
"""How text begins that stands between two dollars by mistake."""


def formulas(source: str) -> tuple[Formula, ...]:
    """Every formula, in order, those in code and comments left out.

    Raises RigidtopError for a file that is too long.
    """
    return _walked(source).formulas


def problems(source: str) -> tuple[Problem, ...]:
    """Where mathematics stands in a file that `formulas` does not have, in order.

    A stray dollar, an opening without its closing, an unknown environment, a comment.
    """
    return _walked(source).problems


def bare(source: str) -> tuple[Problem, ...]:
    """The lines with mathematics outside of all dollars and the like, in order."""
    return _walked(source).bare


def states(formula: Formula) -> bool:
    """Whether a formula says anything: a display, or a relation in a line."""
    return formula.display or _RELATED.search(formula.text) is not None


@dataclass(frozen=True)
class _Walked:
    formulas: tuple[Formula, ...]
    problems: tuple[Problem, ...]
    bare: tuple[Problem, ...]
    lost: tuple[Numbered, ...]


@lru_cache(maxsize=2)
def _walked(source: str) -> _Walked:
    if len(source) > LONGEST:
        raise RigidtopError(f"a file of more than {LONGEST} characters: split it")
    walk = _Walk(source)
    walk.go()
    return _Walked(
        tuple(walk.found),
        tuple(sorted(set(walk.problems), key=lambda problem: problem.position)),
        tuple(walk.bare),
        tuple(walk.lost),
    )


def is_tex(source: str) -> bool:
    """Whether a text is LaTeX by itself, and no Markdown."""
    return _TEX.search(_FENCED.sub("", source)) is not None


def places(source: str) -> Callable[[int], tuple[int, int]]:
    r"""What tells the line and the column, counted from 1, of a position in a text.

    >>> places("a\nbc")(3)
    (2, 2)
    """
    starts = [0, *(match.end() for match in re.finditer("\n", source))]

    def place(position: int) -> tuple[int, int]:
        line = bisect_right(starts, position)
        return line, position - starts[line - 1] + 1

    return place


class _Walk:
    """Goes through a file and takes formulas; what it can't take it tells."""

    def __init__(self, source: str) -> None:
        self.source = source
        self.tex = is_tex(source)
        self.found: list[Formula] = []
        self.problems: list[Problem] = []
        self.lost: list[Numbered] = []
        self.bare: list[Problem] = []
        self.skipped: list[tuple[int, int]] = []
        self.refused: list[tuple[int, int, str]] = []
        """From where to where something was not taken, and why."""
        self.dollars: list[int] = []
        """Those of this paragraph that are alone."""
        self.paragraph = 0, -1
        """From where to where there is no blank line."""
        self.open: list[tuple[str, int]] = []
        self.unknown: list[tuple[str, int, int]] = []
        self.missing: set[str] = set()  # closings that do not come any more: looked for only once

    def go(self) -> None:
        pattern = _IN_TEX if self.tex else _IN_MARKDOWN
        at = 0
        while match := pattern.search(self.source, at):
            at = self.take(match)
        self.end_paragraph()
        self.unknown += [(name, begun, self.paragraph_end(begun)) for name, begun in self.open]
        self.found.sort(key=lambda formula: formula.opens)
        self.tell_bare()
        self.tell_refused()

    def take(self, match: re.Match[str]) -> int:
        """Go behind what was found."""
        kind = match.lastgroup
        if kind == "blank":
            self.end_paragraph()
        elif kind == "percent":
            self.skip(match.start(), match.end(), "a comment")
        elif kind == "html":
            return self.skip_until(match, r"-->", "a comment")
        elif kind == "off":
            return self.skip_until(match, r"\\fi(?![A-Za-z])", "a comment")
        elif kind == "verb":
            return self.skip_until(match, re.escape(match[0][-1]), "code")
        elif kind == "code":
            return self.code(match)
        elif match.groupdict().get("fence"):
            return self.fence(match)
        elif match["name"]:
            return self.environment(match)
        elif kind == "sign":
            return self.sign(match)
        return match.end()

    # What is no mathematics

    def skip(self, start: int, end: int, what: str) -> None:
        self.skipped.append((start, end))
        inside = self.source[start:end]
        if _TOLD.search(inside) and (what == "code" or _MATHEMATICAL.search(inside)):
            self.problems.append(Problem(start, f"skipped: {what}", skipped=True))
            self.count()

    def skip_until(self, match: re.Match[str], closing: str, what: str) -> int:
        end = self.find(closing, match.end())
        if end is None:
            self.refuse(match.start(), f"{match[0].strip()} without its end")
            return match.end()
        self.skip(match.start(), end.end(), what)
        return end.end()

    def code(self, match: re.Match[str]) -> int:
        if len(self.dollars) % 2 or len(match[0]) > LONGEST_TICKS:
            return match.end()
        end = self.find(rf"(?<!`){match[0]}(?!`)", match.end())
        if end is None or _BLANK_LINE.search(self.source, match.end(), end.start()):
            return match.end()
        self.skip(match.start(), end.end(), "code")
        return end.end()

    def fence(self, match: re.Match[str]) -> int:
        if len(match["ticks"]) > LONGEST_TICKS:
            return match.end()
        end = self.find(rf"\n[ \t]{{0,3}}{match['ticks']}[`~]*", match.end())
        self.end_paragraph()
        if end is not None and match["info"].strip() == "math":
            self.add(match.end(), end.start(), end.end(), match.start())
            return end.end()
        return self.skip_until(match, rf"\n[ \t]{{0,3}}{match['ticks']}[`~]*", "code")

    # Formulas

    def find(self, pattern: str, at: int) -> re.Match[str] | None:
        """The next place of it; one that does not come any more is looked for only once."""
        if pattern in self.missing:
            return None
        found = re.compile(pattern).search(self.source, at)
        if found is None:
            self.missing.add(pattern)
        return found

    def closing(self, pattern: str, at: int) -> re.Match[str] | None:
        r"""The next place of it outside comments and \\\\."""
        if pattern in self.missing:
            return None
        passed = r"\\\\|\\[$%]|%[^\n]*" if self.tex else r"\\\\|\\[$%]"
        for found in re.compile(rf"(?P<wanted>{pattern})|{passed}").finditer(self.source, at):
            if found["wanted"]:
                return found
        self.missing.add(pattern)
        return None

    def add(self, start: int, stop: int, end: int, opens: int, display: bool = True) -> None:
        text, line = self.source[start:stop], self.source.rfind("\n", 0, opens) + 1
        if not self.tex and _QUOTED.match(self.source, line, opens):
            text = _QUOTED.sub(lambda found: " " * len(found[0]), text)
        self.found.append(Formula(text, start, end, display, opens))
        self.count()

    def count(self) -> None:
        if len(self.found) + len(self.problems) + len(self.bare) + len(self.lost) > MOST:
            raise RigidtopError(
                f"a file of more than {MOST} formulas, or places where one is not taken: split it"
            )

    def refuse(self, position: int, reason: str, end: int | None = None) -> None:
        """Tell what can't be taken; a number behind it, in its paragraph, is lost with it."""
        self.problems.append(Problem(position, reason))
        self.count()
        stop = self.paragraph_end(position) if end is None else end
        self.refused.append((position, stop, reason))

    def paragraph_end(self, position: int) -> int:
        begun, end = self.paragraph
        if not begun <= position <= end:
            blank = self.find(_BLANK_LINE.pattern, position)
            self.paragraph = position, blank.start() if blank else len(self.source)
        return self.paragraph[1]

    def environment(self, match: re.Match[str]) -> int:
        name, begins = match["name"], match["side"] == "begin"
        if name in _MATHS and not begins:
            self.refuse(match.start(), rf"\end{{{name}}} without its \begin", match.end())
        elif name in _MATHS:
            end = self.closing(rf"\\(?:begin|end)\s*\{{\s*{re.escape(name)}\s*\}}", match.end())
            if end is None or end[0].startswith(r"\begin"):
                self.refuse(match.start(), rf"\begin{{{name}}} without its \end")
                return match.end()
            arguments = _WITH_ARGUMENTS.get(name.rstrip("*"))
            given = arguments.match(self.source, match.end()) if arguments else None
            start = given.end() if given else match.end()
            self.add(start, end.start(), end.end(), match.start(), name != "math")
            return end.end()
        elif name.rstrip("*") in _VERBATIM and begins:
            what = "a comment" if name == "comment" else "code"
            return self.skip_until(match, rf"\\end\s*\{{\s*{re.escape(name)}\s*\}}", what)
        elif begins:
            if not len(self.dollars) % 2 and len(self.open) < DEEPEST:
                self.open.append((name, match.end()))
        elif name == "document" and self.tex:
            self.skip(match.end(), len(self.source), "behind the end of the document")
            return len(self.source)
        elif any(name == opened for opened, _ in self.open):
            while self.open:
                opened, begun = self.open.pop()
                self.unknown.append((opened, begun, match.start()))
                if opened == name:
                    break
        return match.end()

    def sign(self, match: re.Match[str]) -> int:
        sign, begun, at = match[0], match.start(), match.end()
        if sign == "$":
            self.dollars.append(begun)
            return at
        if sign in (r"\]", r"\)"):
            self.refuse(begun, f"{sign} without its opening", at)
            return at
        if sign == "$$":
            first_in_line = not self.source[
                self.source.rfind("\n", max(0, begun - 40), begun) + 1 : begun
            ].strip()
            if len(self.dollars) % 2 and not first_in_line:  # $a$$b$
                self.dollars.append(begun)
                return begun + 1
            end = self.closing(r"\$\$", at)
        else:
            closes = {r"\[": r"\]", r"\(": r"\)"}[sign]
            end = self.closing(f"{re.escape(sign)}|{re.escape(closes)}", at)
            if end is not None and end[0] == sign:
                end = None
        if end is not None and sign != r"\[" and _BLANK_LINE.search(self.source, at, end.start()):
            end = None
        if end is None:
            self.refuse(begun, f"{sign} without its closing in the same paragraph")
            return at
        self.add(at, end.start(), end.end(), begun, sign != r"\(")
        return end.end()

    # Dollars

    def end_paragraph(self) -> None:
        """Take what stands between the dollars of a paragraph, if they come in pairs."""
        dollars, self.dollars = self.dollars, []
        if len(dollars) % 2:
            stray = self.stray(dollars)
            reason = "an odd number of $ in this paragraph: one is missing, or is meant as \\$"
            if stray is None:
                self.refuse(dollars[0], reason)
                return
            line_end = self.source.find("\n", dollars[stray])
            self.refuse(dollars[stray], reason, line_end if line_end >= 0 else len(self.source))
            del dollars[stray]
        pairs = list(zip(dollars[::2], dollars[1::2], strict=True))
        wrong = [pair for pair in pairs if self.is_text(*pair)]
        if wrong:
            self.refuse(wrong[0][0], "words between two $: is one of them meant as \\$?")
            return
        for opens, closes in pairs:
            self.add(opens + 1, closes, closes + 1, opens, display=False)

    def is_text(self, opens: int, closes: int) -> bool:
        if _SAID.match(self.source, opens + 1, closes):
            return True
        last = max(self.found[-1:], key=lambda formula: formula.opens, default=None)
        return last is not None and opens < last.opens < closes

    def stray(self, dollars: Sequence[int]) -> int | None:
        """The dollar without which the others are pairs, if there is just one."""
        around = [(self.source[max(i - 1, 0) : i], self.source[i + 1 : i + 2]) for i in dollars]
        opening = [bool(after.strip()) for _, after in around]
        closing = [bool(before.strip()) and not after.isdigit() for before, after in around]
        before = [True]
        for i in range(0, len(dollars) - 1, 2):
            before.append(before[-1] and opening[i] and closing[i + 1])
        behind = [True]
        for i in range(len(dollars) - 2, 0, -2):
            behind.append(behind[-1] and opening[i] and closing[i + 1])
        behind.reverse()
        fitting = [2 * i for i in range(len(before)) if before[i] and behind[i]]
        return fitting[0] if len(fitting) == 1 else None

    # What is left

    def tell_bare(self) -> None:
        """Mathematics outside all formulas: in an unknown environment, or a \\tag."""
        covered = [(formula.opens, formula.end) for formula in self.found]
        covered += self.skipped + [(start, end) for start, end, _ in self.refused]
        covered += [(begun, end) for name, begun, end in self.unknown if name in _KEYED]
        covered += [(0, begun) for name, begun, _ in self.unknown if name == "document"]
        hits: list[int] = []
        at = 0
        for start, end in [*sorted(covered), (len(self.source), len(self.source))]:
            if start > at:
                hits += [
                    match.start()
                    for match in _BARE.finditer(self.source, at, start)
                    if match["hit"]
                ]
            at = max(at, end)
        told = []
        for name, begun, end in self.unknown:
            first = bisect_left(hits, begun)
            if name.rstrip("*") not in _PROSE and first < len(hits) and hits[first] < end:
                self.refuse(begun, f"mathematics in an environment that is not read: {name}", end)
                told.append((begun, end))
        inside = [False] * len(hits)
        for begun, end in told:
            for i in range(bisect_left(hits, begun), bisect_left(hits, end)):
                inside[i] = True
        left = [hit for hit, known in zip(hits, inside, strict=True) if not known]
        for hit in left:
            if self.source.startswith(r"\tag", hit):
                self.refuse(hit, r"a \tag outside a formula")
        self.tell_lines(left)

    def tell_lines(self, hits: Sequence[int]) -> None:
        """The lines with mathematics of which no formula is made; a number beside it is lost."""
        until = 0
        for hit in hits:
            if hit < until:
                continue
            start = self.source.rfind("\n", 0, hit) + 1
            until = self.source.find("\n", hit)
            until = until if until >= 0 else len(self.source)
            if self.source.startswith(r"\tag", hit):
                continue  # that is told
            start += len(self.source[start:until]) - len(self.source[start:until].lstrip())
            number = _LAST.search(self.source, hit, until) or _NUMBER.match(self.source, until)
            if number and number.start(1) not in self.taken:
                self.refuse(start, OUTSIDE, until)
            else:
                self.bare.append(Problem(start, OUTSIDE))
                self.count()

    @cached_property
    def taken(self) -> set[int]:
        """Where the numbers of formulas stand."""
        found = (_NUMBER.match(self.source, formula.end) for formula in self.found)
        return {beside.start(1) for beside in found if beside}

    def tell_refused(self) -> None:
        """Numbers that stand beside what was not taken."""
        spans = sorted([(formula.opens, formula.end) for formula in self.found] + self.skipped)
        starts = [start for start, _ in spans]
        seen: set[int] = set()
        refused = sorted(self.refused)
        following = [*(start for start, _, _ in refused[1:]), len(self.source)][: len(refused)]
        for (start, until, reason), after in zip(refused, following, strict=True):
            end = min(until, max(after, start + 1))
            beside = _NUMBER.match(self.source, end)
            for match in [*_LOST.finditer(self.source, start, end), *([beside] if beside else [])]:
                assert match.lastindex is not None
                place = match.start(match.lastindex)
                i = bisect_left(starts, place) - 1
                if place in self.taken or place in seen or (i >= 0 and place < spans[i][1]):
                    continue
                seen.add(place)
                stop = max(end, match.end())
                written = self.source[start : min(stop, start + LONGEST_LOST)]
                formula = Formula(written, start, stop, True, start, reason)
                self.lost.append(Numbered(_bared(match[match.lastindex]), (formula,)))
                self.count()


def numbered(source: str) -> tuple[Numbered, ...]:
    """The formulas that bear a number, as `\\tag{3.57}` or in brackets at the end of the line.

    A number belongs to all displays above it between which nothing is said.
    """
    found = formulas(source)
    numbers = [_numbers_of(source, formula) for formula in found]
    made = []
    for i, inside in enumerate(numbers):
        first = i
        while inside and first and _goes_on(source, found, numbers, first):
            first -= 1
        for number in inside:
            made.append(Numbered(number, found[first : i + 1]))
            first = i  # what stands above belongs to the first of several numbers
    made += _walked(source).lost
    if len(made) > MOST_NUMBERS:
        raise RigidtopError(f"a file of more than {MOST_NUMBERS} numbered equations: split it")
    return tuple(sorted(made, key=lambda group: group.formulas[-1].opens))


def _bared(number: str) -> str:
    """A number without brackets round it."""
    return re.sub(r"\s+", "", number).strip("()$")


def _numbers_of(source: str, formula: Formula) -> tuple[str, ...]:
    """The numbers of a display, one or more; that of a formula in a line, if it is an equation."""
    tagged = (_bared("".join(groups)) for groups in _INSIDE.findall(formula.text))
    inside = tuple(dict.fromkeys(filter(None, tagged)))
    if inside:
        return inside
    beside = _NUMBER.match(source, formula.end)
    if beside and (formula.display or _RELATED.search(formula.text)):
        return (beside[1],)
    return ()


def _goes_on(
    source: str, found: Sequence[Formula], numbers: Sequence[tuple[str, ...]], first: int
) -> bool:
    """Whether the formula before belongs to the same number."""
    before, this = found[first - 1], found[first]
    if not (before.display and this.display) or numbers[first - 1]:
        return False
    return not source[before.end : this.opens].strip()


def lines(
    group: Numbered, notation: Notation = NOTES, habits: Habits = NO_HABITS
) -> tuple[Line, ...]:
    """The equations of a number, with their places in the file."""
    for formula in group.formulas:
        if formula.problem:
            return (Line(formula.start, None, formula.problem, tag=group.number),)
    joint = "\\\\\n"
    text = joint.join(formula.text for formula in group.formulas)
    starts, at = [], 0
    for formula in group.formulas:
        starts.append((at, formula.start))
        at += len(formula.text) + len(joint)

    def place(position: int) -> int:
        begun, start = max(pair for pair in starts if pair[0] <= position)
        return start + position - begun

    made = [replace(line, position=place(line.position)) for line in read(text, notation, habits)]
    return tuple(_of_number(made, group.number))


def _of_number(made: Sequence[Line], number: str) -> Sequence[Line]:
    """Those up to the tag of that number, from the tag before it on; to the last all behind it."""
    tagged = [i for i, line in enumerate(made) if line.tag]
    if len({made[i].tag for i in tagged}) < 2:
        return made
    here = [i for i in tagged if made[i].tag == number]
    if not here:
        return made
    before = [i + 1 for i in tagged if i < here[0]]
    behind = here[-1] + 1 if here[-1] < tagged[-1] else len(made)
    return made[max(before, default=0) : behind]


def alone(source: str) -> tuple[Numbered, ...]:
    """Every formula of a file by itself, without its number."""
    return tuple(Numbered("", (formula,)) for formula in formulas(source))


def grouped(source: str) -> tuple[Numbered, ...]:
    """Every number of a file with its formulas, and every formula that has none, in order."""
    made = numbered(source)
    inside = {formula.start for group in made for formula in group.formulas}
    others = [each for each in alone(source) if each.formulas[0].start not in inside]
    return tuple(sorted((*made, *others), key=lambda group: group.formulas[0].start))


def each(
    groups: Iterable[Numbered],
    notation: Notation = NOTES,
    seconds: float = SECONDS,
    habits: Habits = NO_HABITS,
) -> Iterator[tuple[Numbered, tuple[Line, ...]]]:
    """Formulas with their equations; once the time is up the rest is unread, and says so."""
    end = time.process_time() + seconds
    for group in groups:
        if time.process_time() > end:
            yield group, (Line(group.formulas[0].start, None, LATE),)
        else:
            yield group, lines(group, notation, habits)
