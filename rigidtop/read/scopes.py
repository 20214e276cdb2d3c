r"""The scopes of a text: headings, exercises, titles of paragraphs, items, theorems and their like.

A place has a path of numbers, from its heading inwards, those of items below zero; what is set in
a scope ends with it.

>>> [mark.path for mark in scopes("# Springs\n\nA mass.\n\n1. Free.\n2. With friction.\n\nBoth.")]
[(1,), (1, -2), (1, -3), (1,)]
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace

HEADINGS = {"part": 0, "chapter": 1, "section": 2, "subsection": 3, "subsubsection": 4}
UNDERLINES = "=-~^"
"""What underlines a heading, from the outermost on."""

RULE, ENVIRONMENT, EXERCISE, CASE, TITLE, LETTER, ENTRY = 8, 10, 20, 24, 30, 34, 40
"""How far within another a scope lies: one ends those that do not lie further out."""

DEEPEST = 40
"""Environments are not followed deeper."""

LONGEST_TITLE = 300
"""A title is no longer (characters)."""

_EXERCISES = "Example|Problem|Exercise|Question|Task|Beispiel|Aufgabe|Exemple|Exercice|Problème"
_CASES = "Case|Part|Fall|Teil|Cas|Partie"
_LISTS = "enumerate|itemize|description|parts|subparts|subsubparts|questions|tasks"
_THEOREMS = (
    "examples?|problems?|exercises?|questions?|solutions?|theorem|lemma|proposition|corollary"
    "|proof|definition|remark|note|case|beispiel|aufgabe|satz|beweis|exemple|exercice"
    "|eg|ex|exmp|exer|defi|defn|thm|lem|prop|cor|rem|rmk|soln?|law|bsp|aufg"
)
_WHERE = (
    "On|At|In|For|With|Without|After|Before|If|When|During|Near|Above|Below|Auf|Bei|Im|Am|Mit|Ohne"
    "|Nach|Vor|Für|Wenn|Sur|Au|En|Sans|Avec|Pour|Après|Avant|Si"
)
"""How words in italics begin that say in which case something is."""
_BOLD = (
    r"\*\*|__|\\textbf[ \t]*\{|\{\\bf(?:series)?[ \t]|<b>|<strong>"
    rf"|\*(?=(?:[^*\s][^*\n]{{0,80}}[.:]|(?:{_WHERE})\b[^*\n]{{1,60}})\*(?!\*))"
    rf"|\\(?:emph|textit)[ \t]*\{{(?=(?:[^{{}}\n]{{1,80}}[.:]|(?:{_WHERE})\b[^{{}}\n]{{1,60}})\}})"
)
_ITALIC = r"(?:\*|_|\\(?:emph|textit)[ \t]*\{)"
_MARK = re.compile(
    r"^[ \t]{0,3}(?P<hash>#{1,6}|={2,6}|\*{2,6})[ \t]+(?=\S)"
    r"|^(?P<underlined>[^\s|>#$\\-][^\n]{0,200})\n(?P<under>={3,}|-{3,}|~{3,}|\^{3,})[ \t]*$"
    r"|\\(?P<section>part|chapter|(?:sub){0,2}section)\*?[ \t]*(?:\[[^\]\n]{0,200}\])?[ \t]*\{"
    r"|<h(?P<html>[1-6])\b[^>\n]{0,200}>"
    r"|^[ \t]{0,3}(?P<rule>(?P<dash>[-*_])(?:[ \t]*(?P=dash)){2,}[ \t]*$|<hr|\\hrule(?![A-Za-z]))"
    rf"|\\(?P<side>begin|end)[ \t]*\{{(?P<name>{_LISTS}|{_THEOREMS})\*?\}}"
    r"|\\(?P<item>item|(?:sub){0,2}part|question|task)(?![A-Za-z])"
    r"|\\(?P<paragraph>(?:sub)?paragraph\*?[ \t]*\{)"
    rf"|^[ \t]*(?:\\noindent\s*)?(?:(?P<bold>{_BOLD})|{_ITALIC}(?=\(?[a-hivx]{{1,4}}\)"
    rf"|(?:{_CASES})[ ~]*\d))?"
    rf"(?:(?P<exercise>(?:{_EXERCISES})[ ~]*(?:\d|[A-Z]\b|\())"
    rf"|(?P<case>(?:{_CASES})[ ~]*(?:\d|[A-Z]\b|\())"
    r"|(?P<letter>\([a-hivx]{1,4}\)|[a-h]\)(?=[ \t]))|(?(bold)(?P<title>(?=\S))|(?!)))"
    r"|^(?P<indent>[ \t]*)(?P<entry>[-*+][ \t]+(?=\S)"
    r"|(?P<count>\d{1,3})[.)](?:[ \t]+(?=\S)|[ \t]*$)"
    r"|<tr\b[^>\n]{0,200}>|<li\b[^>\n]{0,200}>|\|(?=[^\n]*\|[ \t]*$))"
    r"|(?P<text>\n[ \t]*\n(?P<left>[ \t]*)(?![a-h]\)[ \t])(?=[^\W\d_]))",
    re.M,
)
_BLOCK_ENDS = re.compile(
    r"^[ \t]*(?:#|\Z)|(?:\\(?:begin|end)[ \t]*\{[^{}\n]*\}(?:[ \t]*\\label\{[^{}\n]*\})?"
    r"|\\maketitle|\\\]|\$\$|```)[.,;]?[ \t]*\Z"
)
"""A line behind which a paragraph begins."""
_CLOSING = {"**": r"\*\*", "*": r"\*", "__": "__", "<b>": "</b>", "<strong>": "</strong>"}


@dataclass(frozen=True)
class Boundary:
    """Where a scope begins or ends, and the path of what follows.

    Its words begin at `words`; a title goes from there to `title`, and is a sentence of its own
    where it is `alone`, as that of a section.
    """

    start: int
    path: tuple[int, ...]
    words: int
    title: int = 0
    alone: bool = False


@dataclass(frozen=True)
class _Scope:
    level: int
    number: int
    environment: str = ""
    """The name of what `\\end` closes; an item of its list has the name, too."""
    brief: bool = False
    """Whether it ends with its paragraph: "*On the level* it is so." without a display."""


def scopes(
    source: str, covered: Sequence[tuple[int, int]] = (), tex: bool = False
) -> list[Boundary]:
    """The boundaries of a text in order, those in what is `covered` (formulas, code) left out."""
    return [*_Outline(source, tex).marks(covered)]


class _Outline:
    """Goes through the marks of a text, with the scopes that are open."""

    def __init__(self, source: str, tex: bool) -> None:
        self.source = source
        self.tex = tex
        self.open: list[_Scope] = []
        self.count = 0

    def marks(self, covered: Sequence[tuple[int, int]]) -> Iterator[Boundary]:
        spans, span = [*covered, (len(self.source) + 1, len(self.source) + 2)], 0
        for match in _MARK.finditer(self.source):
            while spans[span][1] <= match.start():
                span += 1
            if spans[span][0] <= match.start() or match.end() <= match.start():
                continue
            mark = self.mark(match)
            if mark is not None:
                yield mark

    def mark(self, match: re.Match[str]) -> Boundary | None:
        start, end = match.span()
        if match["hash"] or match["underlined"]:
            return self.line(match)
        if match["section"] or match["html"]:
            self.enter(HEADINGS[match["section"]] if match["section"] else int(match["html"]))
            close = self.brace(end) if match["section"] else self.until("</h|\n", end)
            return Boundary(start, self.path, end, close, alone=True)
        if match["rule"]:
            if self.source[:start].strip():
                self.enter(RULE)
            return Boundary(start, self.path, end)
        if match["side"]:
            return self.environment(match)
        if match["item"]:
            return self.item(match)
        if match["paragraph"]:
            self.enter(TITLE)
            return Boundary(start, self.path, end, self.brace(end))
        if match["entry"] or match["text"]:
            return None if self.tex else self.entry(match)
        return self.title(match)

    def line(self, match: re.Match[str]) -> Boundary | None:
        """A heading of Markdown and its like."""
        if self.tex:
            return None
        start, words = match.start(), match.start()
        if match["hash"]:
            self.enter(len(match["hash"]))
            words, end = match.end(), self.until("\n", match.end())
        else:
            self.enter(1 + UNDERLINES.index(match["under"][0]))
            end = match.end("underlined")
        return Boundary(start, self.path, words, end, alone=True)

    def title(self, match: re.Match[str]) -> Boundary | None:
        """A paragraph that begins in bold type, or with the name of an exercise."""
        bold, (start, end) = match["bold"], match.span()
        level = next(
            level
            for level, kind in (
                (EXERCISE, "exercise"),
                (CASE, "case"),
                (LETTER, "letter"),
                (TITLE, ""),
            )
            if not kind or match[kind]
        )
        if (level == TITLE or (level < TITLE and not bold)) and not self.begins(start):
            return None
        self.enter(level)
        if not bold:
            return Boundary(start, self.path, start)
        if bold == "*" and self.is_whole(start):
            self.open[-1] = replace(self.open[-1], brief=True)
        closing = _CLOSING.get(bold)
        words = match.end("bold")
        close = self.until(closing, end) if closing else self.brace(words)
        return Boundary(start, self.path, words, close)

    def environment(self, match: re.Match[str]) -> Boundary | None:
        name, (start, end) = match["name"], match.span()
        if match["side"] == "begin" and len(self.open) < DEEPEST:
            self.push(ENVIRONMENT, name)
        elif any(scope.environment == name for scope in self.open):
            while self.open.pop().environment != name:
                pass
            if self.open and self.open[-1].environment == name:
                self.open.pop()  # it was the item of the list
        else:
            return None
        return Boundary(start, self.path, end)

    def item(self, match: re.Match[str]) -> Boundary | None:
        lists = [i for i, scope in enumerate(self.open) if scope.level == ENVIRONMENT]
        if not lists:
            return None
        del self.open[lists[-1] + 1 :]
        self.push(ENTRY, self.open[-1].environment)
        return Boundary(match.start(), self.path, match.end())

    def entry(self, match: re.Match[str]) -> Boundary | None:
        """An entry of a list, a row of a table, or the paragraph that ends them."""
        start, end = match.span()
        indent = len((match["left"] if match["text"] else match["indent"]).expandtabs(4))
        within = any(scope.level >= ENTRY and not scope.environment for scope in self.open)
        if match["text"]:
            before = len(self.open)
            if self.open and self.open[-1].brief:
                self.open.pop()
            while self.open and self.open[-1].level >= ENTRY + indent:
                if self.open[-1].environment:
                    break
                self.open.pop()
            return Boundary(start, self.path, end) if len(self.open) < before else None
        if match["count"] not in (None, "1") and not within and not self.begins(start):
            return None
        self.enter(ENTRY + indent)
        return Boundary(start, self.path, end)

    # The scopes that are open

    @property
    def path(self) -> tuple[int, ...]:
        return tuple(-scope.number if scope.level >= ENTRY else scope.number for scope in self.open)

    def enter(self, level: int) -> None:
        """Begin a scope; it ends those that are no further out, up to an environment."""
        while self.open and self.open[-1].level >= level:
            if self.open[-1].environment and level >= RULE:
                break
            self.open.pop()
        self.push(level)

    def push(self, level: int, environment: str = "") -> None:
        self.count += 1
        self.open.append(_Scope(level, self.count, environment))

    def begins(self, at: int) -> bool:
        """Whether a paragraph begins in the line of a place."""
        line = self.source.rfind("\n", 0, at)
        above = self.source[
            max(0, line - LONGEST_TITLE, self.source.rfind("\n", 0, line) + 1) : line
        ]
        return line < 0 or _BLOCK_ENDS.search(above) is not None

    def is_whole(self, at: int) -> bool:
        """Whether a paragraph is no more than a sentence, which goes on in no display."""
        paragraph = self.source[at : at + LONGEST_TITLE].partition("\n\n")[0]
        return paragraph.rstrip().endswith((".", "!")) and "$$" not in paragraph

    # Where a title ends

    def until(self, pattern: str, at: int) -> int:
        close = re.compile(pattern).search(self.source, at, at + LONGEST_TITLE)
        return close.start() if close else at

    def brace(self, at: int) -> int:
        """Where the brace closes that opened before."""
        depth = 1
        for match in re.compile(r"\\.|[{}]").finditer(self.source, at, at + LONGEST_TITLE):
            depth += {"{": 1, "}": -1}.get(match[0], 0)
            if not depth:
                return match.start()
        return at
