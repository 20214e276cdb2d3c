"""A file gone through once: where its formulas stand, in LaTeX or in Markdown and its like."""

from __future__ import annotations

import re
from bisect import bisect_left, bisect_right
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from rigidtop.errors import RigidtopError
from rigidtop.read.tex import closing

LONGEST = 2_000_000
"""A file is no longer than this (characters)."""

MOST = 20_000
"""A file has no more formulas, and no more places where one is not taken."""

LONGEST_TICKS = 20
"""Longer rows of ` or ~ do not begin code: looking for the end of each takes time."""

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
class Problem:
    """A place in the file where mathematics stands that was not taken as a formula, and why.

    `skipped` says that it is none by the file's own words: a comment, or code.
    """

    position: int
    reason: str
    skipped: bool = False


STRUCK = "skipped: struck out"
"""Why a formula that has been taken back is not taken."""

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
_VERBATIM = {
    **dict.fromkeys(("verbatim", "Verbatim", "lstlisting", "minted", "alltt"), "code"),
    **dict.fromkeys(("tikzpicture", "pgfpicture", "picture", "asy"), "a picture"),
    "comment": "a comment",
}
"""Environments that are left out, and what they are."""

_BOTH = (
    r"(?P<escaped>\\\\|\\[$%`])"
    r"|(?P<blank>\n[ \t]*(?=\n))"
    r"|(?P<off>\\iffalse(?![A-Za-z]))"
    r"|(?P<struck>\\(?:sout|xout|st|hcancel)\s*\{)"
    r"|\\(?P<side>begin|end)\s*\{\s*(?P<name>[A-Za-z]+\*?)\s*\}"
    r"|(?P<sign>\$\$?|\\[\[\]()])"
)


@dataclass(frozen=True)
class _Delimiters:
    """What opens and closes a formula beside dollars, as patterns.

    Where the formula is a `block`, blank lines may stand in it.
    """

    opens: str
    closes: str
    display: bool = False
    block: bool = False


_SHORT = r"(?:math|katex|mathjax|latex)\b[^%<>{}\n]{0,80}"
_DELIMITERS = {
    "bracket": _Delimiters(r"\\\\\[", r"\\\\\]", display=True),
    "parenthesis": _Delimiters(r"\\\\\(", r"\\\\\)"),
    "dollar": _Delimiters(r"\$`", r"`\$"),
    "role": _Delimiters(r"(?:\{math\}|:math:)`", r"`"),
    "macro": _Delimiters(r"\b(?:stem|latexmath):\[", r"(?<!\\)\]"),
    "block": _Delimiters(
        r"^\[(?:stem|latexmath)\b[^\]\n]{0,80}\][ \t]*\n\+{4}[ \t]*$", r"^\+{4}[ \t]*$", True, True
    ),
    "script": _Delimiters(r"<script\b[^<>\n]{0,80}math/tex[^<>\n]{0,80}>", "</script>", block=True),
    "shortcode": _Delimiters(
        rf"\{{\{{[<%][ \t]*{_SHORT}[>%]\}}\}}", r"\{\{[<%][ \t]*/[^{}\n]{0,80}\}\}", block=True
    ),
    "tag": _Delimiters(rf"\{{%[ \t]*{_SHORT}%\}}", r"\{%[ \t]*end[^%{}\n]{0,80}%\}", block=True),
}
"""Escaped brackets, GitLab's dollars, roles of MyST and reStructuredText, AsciiDoc, HTML, Hugo,
Jekyll."""
_BESIDE = "|".join(f"(?P<{name}>{each.opens})" for name, each in _DELIMITERS.items())
_INNER = re.compile(rf"\s*(?:\$|\\\[|\\\(|\\begin\s*\{{(?:{'|'.join(map(re.escape, _MATHS))})\}})")
"""What begins a formula within such delimiters once more."""
_MATH_FENCE = r"[ \t>]*(?=(?:`{3}|~{3}|:{3})[`~:]{0,17}[ \t]*\{?math\b)"
_OPTIONS = re.compile(
    r"(?:\n---[ \t]*(?:\n(?!---)[^\n]*){0,20}\n---[ \t]*(?=\n))?(?:\n[ \t>]*:[\w-]+:[^\n]*)*"
)
"""Those of a directive stand in front of its text."""
_TEXTS = frozenset(
    (
        *("admonition", "attention", "caution", "danger", "dropdown", "error", "example", "hint"),
        *("exercise", "exercise-start", "important", "margin", "note", "seealso", "sidebar", "tip"),
        *("solution", "solution-start", "topic", "warning", "card", "details", "epigraph", "aside"),
    )
)
"""Directives whose fence holds text; those of prf as well."""

_IN_TEX = re.compile(rf"{_BOTH}|(?P<percent>%[^\n]*)|(?P<verb>\\verb\*?[^A-Za-z\s*])", re.M)
_IN_MARKDOWN = re.compile(
    rf"{_BESIDE}|{_BOTH}|(?P<percent>^[ \t]*%[^\n]*)|(?P<html><!--)"
    rf"|(?P<fence>^(?:{_MATH_FENCE}|[ \t]{{0,3}}(?=[`~]))"
    r"(?P<ticks>`{3,}+|~{3,}+|:{3,}+)(?P<info>[^\n`]*+)$)"
    r"|(?P<strike>(?<!~)~~(?![~\s])|<(?:del|s|strike)>)"
    r"|(?P<directive>^(?P<margin>[ \t]*)\.\.[ \t]+math::[ \t]*(?P<first>[^\n]*)$)|(?P<code>`+)",
    re.M,
)
_FENCED = re.compile(r"^[ \t]{0,3}(`{3,20}+|~{3,20}+)(?s:.*?)^[ \t]{0,3}\1[^\n]*", re.M)
_QUOTED = re.compile(r"^[ \t]{0,3}>", re.M)
_TEX = re.compile(r"^[ \t]*\\(?:documentclass|begin\s*\{\s*document\s*\})", re.M)
DOCUMENT = re.compile(r"^[ \t]*\\begin\s*\{\s*document\s*\}", re.M)
"""Where the text of a file in LaTeX begins."""
_BLANK_LINE = re.compile(r"\n[ \t]*\n")
_PARAGRAPH = re.compile(r"\n(?=[ \t]*\n)")
_TOLD = re.compile(r"=|\\(?:tag|equiv|approx|neq?)(?![A-Za-z])")
"""What makes a skipped part worth telling, if mathematics stands in it at all."""
_MATHEMATICAL = re.compile(r"\$|\\[\[(]|\\begin\s*\{|\\tag")
_SAID = re.compile(r"\s+[a-z]{2,}\s")
"""How text begins that stands between two dollars by mistake."""


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


class Walk:
    """Goes through a file and takes formulas; what it can't take it tells."""

    def __init__(self, source: str) -> None:
        if len(source) > LONGEST:
            raise RigidtopError(f"a file of more than {LONGEST} characters: split it")
        self.source = source
        self.tex = is_tex(source)
        self.found: list[Formula] = []
        self.problems: list[Problem] = []
        self.counted = 0
        self.skipped: list[tuple[int, int]] = []
        self.refused: list[tuple[int, int, str]] = []
        """From where to where something was not taken, and why."""
        self.dollars: list[int] = []
        """Those of this paragraph that are alone."""
        self.open: list[tuple[str, int]] = []
        self.unknown: list[tuple[str, int, int]] = []
        self.texts: list[str] = []  # the fences of directives with text that are open
        self.missing: set[str] = set()  # closings that do not come any more: looked for only once
        pattern = _IN_TEX if self.tex else _IN_MARKDOWN
        document = DOCUMENT.search(source) if self.tex else None
        at = self.begin(document.end()) if document else 0
        while match := pattern.search(self.source, at):
            at = self.take(match)
        self.end_paragraph()
        self.unknown += [(name, begun, self.paragraph_end(begun)) for name, begun in self.open]
        self.found.sort(key=lambda formula: formula.opens)

    def begin(self, start: int) -> int:
        """Go to where the document begins: what stands before it sets nothing."""
        self.skipped.append((0, start))
        return start

    def take(self, match: re.Match[str]) -> int:
        """Handles a match, and gives the place at which the walk goes on."""
        kind = match.lastgroup
        if kind == "blank":
            self.end_paragraph()
        elif kind == "percent":
            self.skip(match.start(), match.end(), "a comment")
        elif kind == "html":
            return self.skip_until(match, r"-->", "a comment")
        elif kind == "off":
            return self.skip_until(match, r"\\fi(?![A-Za-z])", "a comment")
        elif kind in ("struck", "strike"):
            return self.struck(match)
        elif kind == "verb":
            return self.skip_until(match, re.escape(match[0][-1]), "code")
        elif kind == "code":
            return self.code(match)
        elif not self.tex and match["fence"] is not None:
            return self.fence(match)
        elif not self.tex and match["directive"] is not None:
            return self.directive(match)
        elif kind in _DELIMITERS:
            return self.beside(match, kind)
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

    def struck(self, match: re.Match[str]) -> int:
        """What is struck out within a paragraph has been taken back."""
        stop, opens = self.paragraph_end(match.end()), match[0]
        if opens.endswith("{"):
            end, length = closing(self.source, match.end() - 1, stop), 1
        else:
            closes = opens.replace("<", "</")
            end, length = self.source.find(closes, match.end(), stop), len(closes)
        if len(self.dollars) % 2 or end is None or end < 0:
            return match.end()
        end += length
        self.skip(match.start(), end, "struck out")
        return end

    def code(self, match: re.Match[str]) -> int:
        if len(self.dollars) % 2 or len(match[0]) > LONGEST_TICKS:
            return match.end()
        end = self.find(rf"(?<!`){match[0]}(?!`)", match.end())
        if end is None or _BLANK_LINE.search(self.source, match.end(), end.start()):
            return match.end()
        self.skip(match.start(), end.end(), "code")
        return end.end()

    def fence(self, match: re.Match[str]) -> int:
        ticks, info = match["ticks"], match["info"].strip()
        if len(ticks) > LONGEST_TICKS:
            return match.end()
        self.end_paragraph()
        name = info.removeprefix("{").partition("}")[0] if info.startswith("{") else ""
        if not info and self.texts and ticks.startswith(self.texts[-1]):
            self.texts.pop()
            return match.end()
        if name in _TEXTS or name.startswith("prf:"):
            self.texts.append(ticks)
            return match.end()
        mathematics = name == "math" or info.split()[:1] == ["math"]
        margin = "[ \\t>]*" if mathematics else r"[ \t]{0,3}"
        closing = rf"\n{margin}{ticks}[`~:]*"
        end = self.find(closing, match.end()) if mathematics else None
        if end is None:
            return self.skip_until(match, closing, "code")
        options = _OPTIONS.match(self.source, match.end(), end.start())
        start = options.end() if options else match.end()
        self.add(start, end.start(), end.end(), match.start("ticks"))
        return end.end()

    def directive(self, match: re.Match[str]) -> int:
        """The formulas of a directive of reStructuredText: what is indented, by blank lines."""
        self.end_paragraph()
        options = _OPTIONS.match(self.source, match.end())
        end = options.end() if options else match.end()
        if match["first"].strip():
            self.add(match.start("first"), match.end("first"), end, match.start())
        inside = re.compile(rf"(?:\n{match['margin']}[ \t]+\S[^\n]*)+")
        blank = re.compile(r"(?:\n[ \t]*(?=\n))*")
        opens = match.start()
        while True:
            gap = blank.match(self.source, end)
            block = inside.match(self.source, gap.end() if gap else end)
            if block is None:
                return end
            self.add(block.start() + 1, block.end(), block.end(), max(opens, block.start()))
            end = block.end()

    def beside(self, match: re.Match[str], kind: str) -> int:
        """A formula between other delimiters than those of TeX."""
        delimiters, start = _DELIMITERS[kind], match.end()
        closing = re.compile(rf"(?P<end>{delimiters.closes})|{delimiters.opens}", re.M)
        end = None if len(self.dollars) % 2 else closing.search(self.source, start)
        if end is not None and not end["end"]:
            end = None
        if end is not None and not delimiters.block:
            inside = self.source[start : end.start()]
            end = None if _BLANK_LINE.search(inside) or not inside.strip() else end
        if kind == "dollar" and end is None:
            self.dollars.append(match.start())
            return match.start() + 1
        if end is None:
            return match.start() + 2 if kind in ("bracket", "parenthesis") else start
        if _INNER.match(self.source, start, end.start()):
            return start
        alone = self.source[self.source.rfind("\n", 0, match.start()) + 1 : match.start()].strip()
        display = delimiters.display or "display" in match[0] or (delimiters.block and not alone)
        self.add(start, end.start(), end.end(), match.start(), display)
        return end.end()

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
        """Raises RigidtopError for too many formulas, and places where one is not taken."""
        self.counted += 1
        if self.counted > MOST:
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
        i = bisect_left(self.ends, position)
        return self.ends[i] if i < len(self.ends) else len(self.source)

    @cached_property
    def ends(self) -> list[int]:
        """The places at which paragraphs end, in order."""
        return [match.start() for match in _PARAGRAPH.finditer(self.source)]

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
            what = _VERBATIM[name.rstrip("*")]
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
