"""Pages in Markdown become lines: a sentence, ending in a colon, and the display that it leads to.

    ## Equation of motion

    Differentiate (3.53) with respect to $\\dot\\theta$:

    $$\\frac{\\partial\\mathcal L}{\\partial\\dot\\theta} = \\lambda_1\\dot\\theta$$

Headings and other paragraphs are the lecture's text.  Only the last sentence of a paragraph in
front of a display says a move (`rigidtop.read.sentence`).  Beneath a heading that begins with
"Laws", and deeper ones beneath that, it names the law, and what stands before it says where it is
from.
``<a id="constant-rate"></a>`` gives the lines below it a name, up to the next name, heading, box
or numbered equation.  What goes beyond the main thread stands in a box, which a code host folds as
our pages do, and has no headings:

    <details><summary>How parallel they are</summary>

    …

    </details>

A picture is a paragraph of its own, ``![The orbit of (1.5).](#orbit)``: its words, and the name of
what draws it.

Behind it "it" and "the discriminant" are those of the main thread, if that has any.  A box that
begins with ``<details class="lecturer">`` is not for students.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from importlib.resources import files
from itertools import takewhile
from pathlib import Path
from typing import Any

from sympy import Symbol

from rigidtop.errors import RigidtopError
from rigidtop.notation import NOTES, Notation
from rigidtop.proof.derivation import Line
from rigidtop.proof.equation import Equation, symbols_of
from rigidtop.proof.lecture import (
    Block,
    Box,
    BoxEnd,
    Fault,
    Heading,
    Illustration,
    Lecture,
    Prose,
    Shown,
    Text,
)
from rigidtop.proof.letters import Letters
from rigidtop.proof.moves import Known, Move, Scope
from rigidtop.read import sentence as language
from rigidtop.read.equations import equations as read
from rigidtop.read.library import Law
from rigidtop.read.library import found as found_law
from rigidtop.read.tables import is_of_letters
from rigidtop.read.tex import unread
from rigidtop.read.walk import places

Library = Callable[[], Sequence[Law]]
"""Where laws are looked for."""

_SENTENCE = re.compile(r"(?<=[.!?])\s+(?=[A-Z])")
_HIDDEN = re.compile(r"\$\$|\\\[|\\begin\{|^```+ *math", re.M)
_TAG = re.compile(r"\\tag\{([^}]+)\}")
_ANCHOR = re.compile(r'\s*<a id="([\w.-]+)"></a>\s*')
_NEARLY_ANCHOR = re.compile(r"\s*<a\b(?![^>]*\bhref)", re.I)
_BOX = re.compile(r'<details( class="lecturer")?><summary>(.+)</summary>\s*')
_NEARLY_BOX = re.compile(r"\s*</?(?:details|summary)\b", re.I)
_BOX_END = "</details>"
_PICTURE = re.compile(r"!\[(.*)\]\(#([\w-]+)\)", re.S)
_NEARLY_PICTURE = re.compile(r"\s*!\[")
_LIST = re.compile(r"\s*(?:[-*+]|\d+[.)])\s")


def read_page(
    source: str,
    file: str,
    name: str,
    notation: Notation,
    above: Sequence[Known],
    library: Library = tuple,
) -> Text:
    """Read a page.  `above` may be cited, besides the page's own lines.

    A law of the `library`, which is asked for when it is needed, needs no source.
    """
    reader = _Reader(file, name, notation, list(above), library)
    for text, at, reader.anchor in _named(source):
        reader.take(text, at)
    reader.end()
    if reader.outside is not None:
        reader.fault(source.count("\n") + 1, f"the last box has no end: {_BOX_END}")
        reader.box(_BOX_END, 0)
    if not any(isinstance(block, (Prose, Shown)) for block in reader.blocks):
        reader.faults.append(Fault(1, "the page is empty: it has neither words nor displays"))
    return Text(file, name, tuple(reader.blocks), tuple(reader.faults))


def _named(source: str) -> Iterator[tuple[str, int, str]]:
    """Blocks with the numbers of their first lines and the names that they have, if any."""
    name, fresh = "", False  # just given, so that a heading may stand between it and its lines
    for text, at in _paragraphs(source):
        anchored = _ANCHOR.match(text)
        if anchored is not None:
            name, fresh = anchored[1], True
            text = text[anchored.end() :]
            if not text:
                continue
        if not fresh and (text.startswith("#") or _NEARLY_BOX.match(text)):
            name = ""
        if text.lstrip().startswith("$$"):
            text = text.strip()
            if _TAG.search(text) and not fresh:
                name = ""  # a numbered equation ends what a name names
            fresh = False
        yield text, at, name


_BLOCK = re.compile(
    r"^[ \t]*\$\$(?:(?s:.+?)\$\$[ \t]*$|(?s:.*)\Z)|^#[^\n]*"
    r"|(?:^(?![ \t]*\$\$)[^\n]*[^\s][^\n]*(?:\n|\Z))+",
    re.M,
)


def _paragraphs(source: str) -> list[tuple[str, int]]:
    """Blocks between empty lines, with the numbers of their first lines; a display is whole."""
    place = places(source)
    return [(m[0].rstrip("\n"), place(m.start())[0]) for m in _BLOCK.finditer(source)]


@dataclass
class _Reader:
    """Goes through the paragraphs of a page."""

    file: str
    name: str
    notation: Notation
    above: list[Known]
    library: Library = tuple
    laws: int = 0
    """The level of the heading above that begins with "Laws", if any: there lines need no move."""
    blocks: list[Block] = field(default_factory=list)
    page: list[Known] = field(default_factory=list)
    near: list[Known] = field(default_factory=list)
    pending: tuple[str, int] | None = None
    faults: list[Fault] = field(default_factory=list)
    anchor: str = ""
    source: str = ""
    outside: tuple[list[Known], list[Known]] | None = None
    """In a box the lines of the `page` and those `near`, without the box's own."""

    def take(self, text: str, at: int) -> None:
        if is_of_letters(text):  # they are the collection's
            return
        if text.startswith("#"):
            self.end()
            level = len(text) - len(text.lstrip("#"))
            self.heading(level, text[level:].strip(), at)
            if not self.laws or level <= self.laws:
                self.laws = level if text[level:].split()[:1] == ["Laws"] else 0
        elif _NEARLY_BOX.match(text):
            self.end()
            self.box(text, at)
        elif _NEARLY_PICTURE.match(text):
            self.end()
            self.picture(text, at)
        elif text.startswith("$$"):
            self.display(text.strip("$").strip(), at)
        elif hidden := _HIDDEN.search(text):
            self.pending = None
            at += text.count("\n", 0, hidden.start())
            problem = "a display stands by itself, between empty lines and in $$"
            self.blocks.append(Shown(text, at, None, problem, self.anchor))
        else:
            if _NEARLY_ANCHOR.match(text):
                self.fault(
                    at, 'an anchor is written <a id="its-name"></a>, of letters, digits, - . _'
                )
            self.end(at_list=bool(_LIST.match(text)))
            *before, last = _SENTENCE.split(text)
            if last.rstrip().endswith(":"):
                if before and not self.laws:
                    self.prose(" ".join(before), at)
                self.source = " ".join(before)
                self.pending = (last.strip(), at + text[: text.rindex(last)].count("\n"))
            else:
                self.prose(text, at)

    def prose(self, words: str, at: int) -> None:
        self.blocks.append(Prose(words, at, pieces(words, self.notation)))

    def picture(self, text: str, at: int) -> None:
        """Adds a picture, or a fault where it is no paragraph of its own."""
        shown = _PICTURE.fullmatch(text.strip())
        if shown is None:
            self.fault(at, "a picture is a paragraph of its own: ![its words](#its-name)")
            return
        words = " ".join(shown[1].split())
        self.blocks.append(Illustration(shown[2], words, at, pieces(words, self.notation)))

    def box(self, text: str, at: int) -> None:
        """Opens a box, or closes the one that is open."""
        begins = _BOX.fullmatch(text)
        if begins is not None and self.outside is None:
            self.outside = [*self.page], self.near
            self.near = []
            words = pieces(begins[2], self.notation)
            self.blocks.append(Box(begins[2], at, words, bool(begins[1])))
        elif text.strip() == _BOX_END and self.outside is not None:
            main, self.near = self.outside
            before = self.above[: len(self.above) - len(self.page)]
            self.above = [*before, *self.page[len(main) :], *main]
            self.page, self.outside = main, None
            self.blocks.append(BoxEnd())
        else:
            self.fault(
                at,
                "a box begins with <details><summary>its title</summary> and ends with "
                "</details>, each between empty lines, and has no box in it",
            )

    def heading(self, level: int, words: str, at: int) -> None:
        if self.outside is not None:
            self.fault(at, f"a box has no heading in it: end it above {words!r}, with {_BOX_END}")
            self.box(_BOX_END, at)
        self.near = []
        self.blocks.append(Heading(level, words, at, pieces(words, self.notation)))

    def fault(self, at: int, problem: str) -> None:
        self.faults.append(Fault(at, problem))

    def end(self, at_list: bool = False) -> None:
        """A sentence that ends in a colon was followed by no display; a list may follow it."""
        if self.pending is not None:
            words, at = self.pending
            if not at_list:
                self.fault(at, "a sentence ends in a colon, and no display stands below it")
            self.prose(words, at)
            self.pending = None

    def display(self, latex: str, at: int) -> None:
        sentence, self.pending = self.pending, None
        try:
            if sentence is None:
                raise RigidtopError(
                    "a display without its sentence: say in front of it, with a colon, what is done"
                )
            line = self.line(latex, *sentence)
        except (RigidtopError, language.SentenceError) as error:
            self.blocks.append(Shown(latex, at, None, str(error), self.anchor))
            return
        self.blocks.append(Shown(latex, at, line, "", self.anchor))
        known = Known(line.id, line.equations, line.scope, called=line.called)
        self.page.append(known)
        self.near.append(known)
        self.above.append(known)

    def line(self, latex: str, sentence: str, at: int) -> Line:
        found = read(latex, self.notation)
        equations = []
        for each in found:
            if each.equation is None:
                raise RigidtopError(f"not read: {each.problem}")
            equations.append(each.equation)
        tag = next((e.tag for e in equations if e.tag), "")
        for again in {e.tag for e in equations if e.tag} & {k.tag for k in self.above}:
            self.fault(at, f"({again}) is the number of a line above: a number names one line")
        number = sum(isinstance(b, Shown) for b in self.blocks) + 1
        # A number that stands above already names that line, not this one.
        id = tag if tag and all(k.id != tag for k in self.above) else f"{self.name}:{number}"
        words = pieces(sentence, self.notation)
        made = Line(id, tuple(equations), sentence, words, file=self.file, at=at)
        said = sentence.rstrip(":").strip()
        if self.laws:
            where = re.match(r"(Along the motion|At the moment),? +", said)
            called = said[where.end() :] if where else said
            scope = Scope.IDENTITY
            if where is not None:
                scope = Scope.MOTION if where[1].startswith("Along") else Scope.SET
            source = self.source
            if not source and (law := found_law(called, latex, self.library())):
                source, scope = law.source, max(scope, law.scope)
            if not source:
                self.fault(at, f"{called!r} has no source: say in front of it whose law it is")
            origin = pieces(source, self.notation)
            return replace(made, scope=scope, called=called, source=source, origin=origin)
        context = language.Antecedents(self.above, self.notation, self.page, self.near)
        defined = language.definition(said, context)
        if defined is not None:
            name, using = defined
            if language.is_taken(name, context):
                raise RigidtopError(f"{name!r} names something above: call this otherwise")
            letters = {x for k in self.above for e in k.equations for x in symbols_of(e)}
            call = Move("call", using=using, by=tuple(letters), words=sentence)
            return replace(made, called=name, move=call)
        return replace(made, move=language.move(sentence, context))


@dataclass(frozen=True, eq=False)
class Displays:
    r"""The equations that the pages of a package print, read when they are asked for.

    >>> printed = Displays("rigidtop.derivations")
    >>> printed("3.52").tag, printed(r"p_\phi = L_z") == printed("p-phi-is-Lz")
    ('3.52', True)
    >>> [line.tag for line in printed.lines("3.36")]
    ['', '', '3.36']
    """

    package: str
    notation: Notation = NOTES

    def __call__(self, what: str) -> Equation:
        """The equation with a number or a name, or written here in LaTeX.

        Raises RigidtopError where it is not read, or where there are several.
        """
        found = [line for line in self.lines(what) if line.tag == what] or self.lines(what)
        if len(found) != 1:
            raise RigidtopError(f"{what} are {len(found)} equations, not one")
        return found[0]

    def of(self, name: str, left: str) -> Equation:
        r"""Of the equations of a name the one with a left side, in LaTeX.

        >>> Displays("rigidtop.derivations").of("p-phi-is-Lz", r"p_\phi").sides[1]
        L_z
        """
        wanted = self(f"{left} = 0").sides[0]
        found = [line for line in self.lines(name) if line.sides[0] == wanted]
        if len(found) != 1:
            raise RigidtopError(f"{len(found)} equations of {name} have the left side {left}")
        return found[0]

    def lines(self, what: str) -> tuple[Equation, ...]:
        """All equations of a number, of a name, or of a formula in LaTeX, in their order."""
        if what not in self._read:
            made = []
            for latex in self._shown.get(what, (what,)):
                for line in read(latex, self.notation):
                    if line.equation is None:
                        raise RigidtopError(f"{latex} is not read: {line.problem}")
                    made.append(line.equation)
            self._read[what] = tuple(made)
        return self._read[what]

    @cached_property
    def _read(self) -> dict[str, tuple[Equation, ...]]:
        """The equations that have been read already, by number or name."""
        return {}

    @cached_property
    def _shown(self) -> dict[str, tuple[str, ...]]:
        """The displays of all pages as they are written, by their numbers and names."""
        made: dict[str, tuple[str, ...]] = {}
        for page in files(self.package).iterdir():
            source = page.read_text("utf-8") if page.name.endswith(".md") else ""
            for text, _, name in _named(source):
                if text.startswith("$$"):
                    shown = text.strip("$").strip()
                    for each in {name, *_TAG.findall(shown)} - {""}:
                        made[each] = (*made.get(each, ()), shown)
        return made


@dataclass(frozen=True)
class Raw:
    """Mathematics in a sentence that is no expression and no equation, as it is written.

    `text` is the same without TeX, its Greek letters as letters.
    """

    latex: str
    text: str


def pieces(words: str, notation: Notation) -> tuple[Any, ...]:
    r"""Running text with its mathematics read: strings, trees and equations, `Raw` where not.

    >>> pieces(r"has $2.9\times 10^{-3}\ \text{J s}$, at $15^\circ$", NOTES)[1:]
    (Raw(latex='2.9\\times 10^{-3}', text='2.9×10^-3'), '\u202fJ\u202fs', ', at ', 15, '°')
    """
    made: list[Any] = []
    for k, piece in enumerate(re.split(r"\$([^$]+)\$", words)):
        if k % 2 == 0:
            made.append(piece)
            continue
        counted = _COUNTED.fullmatch(piece)
        formula = counted["number"] if counted else piece
        made.append(_formula(formula, notation))
        if counted:
            unit = " ".join((counted["unit"] or "").split()) + _POWERS[counted["power"]]
            made.append("\u202f" + unit.replace(" ", "\u202f") if counted["unit"] else "°")
    return tuple(piece for piece in made if piece != "")


_COUNTED = re.compile(
    r"(?P<number>.*\d\}?)(?:\s|\\[ ,;:]|~)*"
    r"(?:\\(?:text|mathrm)\s*\{(?P<unit>[^{}]+)\}(?:\^\{?(?P<power>[23])\}?)?|\^\s*\{?\\circ\}?)\s*"
)
"""A formula that ends in a number with a unit, which is a word: of letters or the degree."""

_POWERS = {None: "", "2": "²", "3": "³"}


def _formula(latex: str, notation: Notation) -> Any:
    """A tree or an equation, or what is not read; decimals stay as they are written."""
    if re.search(r"\d\.\d", latex):
        return Raw(latex, unread(latex))
    for side in (latex + " = 0", latex):  # most are no equation, and a side of one
        found = read(side, notation)
        tree = found[0].equation if len(found) == 1 else None
        if tree is not None and (side == latex or len(tree.sides) == 2):
            return tree if side == latex else tree.sides[0]
    # An index is no symbol of the notation.
    return Symbol(latex) if re.fullmatch("[a-z]", latex) else Raw(latex, unread(latex))


def read_lecture(
    sources: Sequence[tuple[str, str]],
    letters: Letters,
    notation: Notation,
    library: Library = tuple,
) -> Lecture:
    """Read the pages of a lecture, (name, text) in reading order."""
    above: list[Known] = []
    texts = []
    for name, source in sources:
        text = read_page(source, f"{name}.md", name, notation, above, library)
        above += _known(text)
        texts.append(text)
    return Lecture(letters, tuple(texts))


def read_exercises(
    sources: Sequence[tuple[str, str]], lecture: Lecture, notation: Notation
) -> Lecture:
    """A lecture with pages of exercises behind it: they may cite it, and not one another."""
    above = [known for text in lecture.texts for known in _known(text)]
    texts = [read_page(source, f"{name}.md", name, notation, above) for name, source in sources]
    return replace(lecture, texts=(*lecture.texts, *texts), main=len(lecture.texts))


def read_beside(file: str, source: str, lecture: Lecture, notation: Notation) -> Lecture:
    """A lecture with one more page behind it, which may cite it.

    A page with the name of one of the lecture's stands in the place of that and of all behind it.
    """
    name = Path(file).stem
    before = tuple(takewhile(lambda text: text.name != name, lecture.texts))
    above = [known for text in before for known in _known(text)]
    named = {known.called: known for known in above}
    former = [replace(named[now], called=old) for old, now in lecture.formerly if now in named]
    above = [*former, *above]
    page = read_page(source, file, name, notation, above)
    return replace(lecture, texts=(*before, page), main=len(before))


def _known(text: Text) -> list[Known]:
    """The lines of a page, the main thread last: of two that say a letter it has the last word."""
    lines = sorted(text.lines, key=lambda line: line.id not in text.boxed)
    return [Known(x.id, x.equations, x.scope, called=x.called) for x in lines]
